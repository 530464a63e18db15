// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "myoface/physics/equilibrium.h"

#include "packed_data.h"

namespace myoface {

/// A handle on packed rows; its target is what is wanted of the *ways* of its rows.
struct RowHandle {
    std::vector<int> rows;
    std::vector<double> weights;
    Eigen::Matrix<double, 3, 2> plane;
    Eigen::Vector2d target = Eigen::Vector2d::Zero();
};

/// A pull on packed rows. @see HandPull
struct RowPull {
    const HandPull* hand = nullptr;
    std::vector<int> grip_rows, rows;
    Eigen::Vector2d target = Eigen::Vector2d::Zero();  ///< of the grip's way
};

/// Dynamic relaxation of one level: Euler steps with masses scaled to each node's stiffness and
/// damping that is critical for the slowest motion alive. @cite underwood_1983
class Relaxation {
public:
    explicit Relaxation(const MassSpringModel& model);

    PackedModel::Data& packed() { return packed_; }
    const PackedModel::Data& packed() const { return packed_; }
    LargeArray<NodeRecord>& records() { return records_; }

    void set_drive(const Drive& drive);
    void restart() { warm_ = false; }
    /// Skin may be stretched otherwise from here on: masses are fitted to its stiffness anew.
    void renew_masses() { since_masses_ = kMassesEvery; }
    /// What hands held counts no more.
    void forget_hands() { hand_rows_.clear(); }

    struct Hands {
        std::span<const RowHandle> handles;
        std::span<const RowPull> pulls;
    };
    /// @param smoothing damp what is rough, for a correction by a coarser level follows
    /// @param layer displacement of the muscle layer, 3×skin nodes, or null
    RelaxReport run(const RelaxOptions& options, const Hands& hands, bool smoothing,
                    const Drive& drive, Points* layer);

    /// What is out of balance at the records' state, without what handles take.
    void free_forces(const LargeArray<NodeRecord>& records, const Hands& hands,
                     LargeArray<VectorLanes>& out, std::vector<Vec3>* held) const;

    const LargeArray<ScalarLanes>& masses() const { return mass_; }
    const std::vector<Vec3>& hand_forces() const { return hand_forces_; }
    std::vector<Vec3>& hand_forces() { return hand_forces_; }
    /// Energy at the start of the last run [µJ].
    double first_energy() const { return first_energy_; }

private:
    static constexpr int kMassesEvery = 40;  // iterations

    void cold_start(bool smoothing, bool layer);
    void scale_masses(const Hands& hands, const Drive& drive, bool layer);
    double advance(bool smoothing, bool with_energy);
    void advance_layer(const Drive& drive, const Points& layer);
    void list_hand_rows(const Hands& hands);
    void hands_act(const Hands& hands);
    void pull_layer(const HandPull& hand, const Vec3& force);
    void hold(const RowHandle& handle, Vec3& reaction);
    Eigen::Vector2d pull_force(const LargeArray<NodeRecord>& records, const RowPull& pull) const;
    double largest_step() const;
    bool is_free(int row) const { return of_row(mass_, row) > 0.0F; }

    PackedModel::Data packed_;
    LargeArray<NodeRecord> records_, next_;
    LargeArray<VectorLanes> force_, last_force_, velocity_;
    LargeArray<ScalarLanes> mass_;  ///< 0 where fixed
    Points positions_, layer_velocity_, layer_next_, layer_force_, layer_last_force_;
    Eigen::VectorXd layer_mass_;
    std::vector<StepSums> sums_;
    StepSums layer_sums_{};
    double damping_ = 0.1;
    double step_damping_ = 0.1;  ///< of the step just taken
    double residual_ = 0.0;
    double wanted_step_ = 0.0;  ///< longest one, had it been taken [mm]
    double first_energy_ = 0.0;
    bool warm_ = false;
    int since_cold_ = 0, since_masses_ = 0;  ///< iterations
    /// A row a hand acts on, and how strongly in this step: before it, so that what a hand holds is
    /// in balance when the step is taken.
    struct HandRow {
        int row = 0;
        int hand = 0;  ///< pulls come first
        std::size_t part = 0;
        Vec3 force = Vec3::Zero();
    };
    std::vector<HandRow> hand_rows_;  ///< by row
    std::vector<Vec3> reactions_;     ///< of the handles, last seen
    std::vector<Vec3> hand_forces_;
};

}  // namespace myoface
