// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numeric>
#include <vector>

#include "myoface/base/parallel.h"
#include "myoface/physics/packed_model.h"

#include "flush_tiny.h"
#include "lane_tasks.h"
#include "large_array.h"

namespace myoface {

constexpr int kSliceGrain = 48;  // slices a thread takes at a time

/// A number of one node in an array by slices.
inline float& of_row(LargeArray<VectorLanes>& a, int row, int axis) {
    return a[static_cast<std::size_t>(row / kLanes)].v[axis][row % kLanes];
}
inline float of_row(const LargeArray<VectorLanes>& a, int row, int axis) {
    return a[static_cast<std::size_t>(row / kLanes)].v[axis][row % kLanes];
}
inline Vec3 of_row(const LargeArray<VectorLanes>& a, int row) {
    return {of_row(a, row, 0), of_row(a, row, 1), of_row(a, row, 2)};
}
inline void set_row(LargeArray<VectorLanes>& a, int row, const Vec3& value) {
    for (int axis = 0; axis < 3; ++axis) {
        of_row(a, row, axis) = static_cast<float>(value[axis]);
    }
}
inline float& of_row(LargeArray<ScalarLanes>& a, int row) {
    return a[static_cast<std::size_t>(row / kLanes)].s[row % kLanes];
}
inline float of_row(const LargeArray<ScalarLanes>& a, int row) {
    return a[static_cast<std::size_t>(row / kLanes)].s[row % kLanes];
}

/// The kernels that run here: the fastest that the processor has.
const LaneKernels& lane_kernels();
/// For tests and measurements: these instead; null: the fastest again.
void use_kernels(const LaneKernels* kernels);

/// Nodes in rows, eight rows a slice; the last slice is filled up with rows that nothing touches.
struct PackedModel::Data {
    explicit Data(const MassSpringModel& model);

    void set_drive(const Drive& drive);
    /// Gravity, loads and inertia only.
    void set_loads(const Drive& drive);
    /// The tether's targets go along with the muscle layer. @param layer 3×skin nodes
    void set_shift(const Drive& drive, const Points& layer);
    /// Rows' places at rest, nothing moved.
    LargeArray<NodeRecord> resting_records() const;
    /// Ways from rest into records; fixed nodes too.
    void put(const Points& positions, LargeArray<NodeRecord>& records) const;
    void put_motion(const MassSpringState& state, LargeArray<NodeRecord>& records) const;
    /// Rest plus way, of nodes that are free.
    void take(const LargeArray<NodeRecord>& records, Points& positions) const;
    /// Forces without dampers. @return energy [µJ]
    double forces(const LargeArray<NodeRecord>& records, LargeArray<VectorLanes>& out,
                  bool with_energy = true) const {
        return forces_then(records, out, with_energy, [](int, int) {});
    }
    /// The same; `after(begin, end)` works on slices whose forces are still in the cache.
    /// @return energy where it is wanted
    template <typename After>
    double forces_then(const LargeArray<NodeRecord>& records, LargeArray<VectorLanes>& out,
                       bool with_energy, const After& after) const;
    void damped_forces(const LargeArray<NodeRecord>& records, LargeArray<VectorLanes>& out) const;
    /// Gershgorin row sums [mN/mm]. @see stiffness_row_sums()
    void row_sums(const LargeArray<NodeRecord>& records, LargeArray<ScalarLanes>& out) const;

    void prepare_damping();
    ForceTask task(const LargeArray<NodeRecord>& records) const;

    const MassSpringModel& model;
    int nodes = 0, slices = 0;
    std::vector<int> row_of;   ///< per node
    std::vector<int> node_of;  ///< per row, −1 where filled up
    std::vector<int> spring_start, link_start;
    LargeArray<SpringColumn> springs;
    LargeArray<ScalarLanes> linear;  ///< per column of springs
    LargeArray<LinkColumn> links;
    LargeArray<TieLanes> ties;
    LargeArray<TargetLanes> targets;
    LargeArray<LoadLanes> loads;
    bool tissue = false, sliding = false, targeted = false, loaded = false;
    // For motion in time only.
    LargeArray<ScalarLanes> damping, tie_damping;
    LargeArray<VectorLanes> linear_rest, rest;
    // Of the last call through PackedModel.
    LargeArray<NodeRecord> last_records;
    LargeArray<VectorLanes> last_forces;

private:
    /// One end of a contact: what acts on `row`.
    struct ContactEnd {
        int row = 0, other = 0;
        float sign = 1.0F;
        float stiffness = 0.0F;
        float normal[3] = {};
        float apart = 0.0F;  ///< at rest, less the gap
        float gap = 0.0F;
    };

    void order_rows();
    void fill_columns();
    void fill_ties();
    double contact_forces(const LargeArray<NodeRecord>& records, bool in_motion, int begin_row,
                          int end_row, LargeArray<VectorLanes>& out) const;
    double barrier_forces(const LargeArray<NodeRecord>& records, bool in_motion, int begin_row,
                          int end_row, LargeArray<VectorLanes>& out) const;
    /// Calls `met(row, stiffness, sample)` for rows that may have met an obstacle.
    template <typename Met>
    void each_barrier(const LargeArray<NodeRecord>& records, bool in_motion, int begin_row,
                      int end_row, const Met& met) const;

    std::vector<std::pair<int, int>> spring_places_;  ///< column × 8 + lane, both ends
    std::vector<ContactEnd> contacts_;                ///< by row
    LargeArray<ScalarLanes> linear_ground_;           ///< Σ_j K_ij, where it is not 0
    std::vector<float> clear_;                        ///< per row: Barriers::clear squared
    std::vector<Eigen::Isometry3d> pose_, unposed_;   ///< of obstacles, and the way back
    bool factored_ = false;                           ///< springs are not as in the model
};

template <typename After>
double PackedModel::Data::forces_then(const LargeArray<NodeRecord>& records,
                                      LargeArray<VectorLanes>& out, bool with_energy,
                                      const After& after) const {
    const ForceTask work = task(records);
    const LaneKernels& kernels = lane_kernels();
    std::vector<double> energies(static_cast<std::size_t>(slices / kSliceGrain + 1), 0.0);
    parallel_for(slices, kSliceGrain, [&](int begin, int end) {
        const FlushTiny flush;
        double energy = 0.0;
        if (with_energy) {
            energy = kernels.forces_and_energy(work, begin, end, out.data());
        } else {
            kernels.forces(work, begin, end, out.data());
        }
        energies[begin / kSliceGrain] =
            energy + contact_forces(records, false, begin * kLanes, end * kLanes, out) +
            barrier_forces(records, false, begin * kLanes, end * kLanes, out);
        after(begin, end);
    });
    return std::accumulate(energies.begin(), energies.end(), 0.0);
}

}  // namespace myoface
