// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "myoface/physics/mass_spring_model.h"

namespace myoface {

/// A model packed for speed, with its forces in single precision: nodes along a Morton curve,
/// within windows sorted by their number of neighbours, eight side by side (sliced ELLPACK),
/// gathered per node in a fixed order. The same bits on every processor and for any number of
/// threads. Displacements, not positions, are what is rounded, so nothing moves at rest.
/// @cite morton_1966 @cite kreutzer_2014
class PackedModel {
public:
    explicit PackedModel(const MassSpringModel& model);
    ~PackedModel();
    PackedModel(const PackedModel&) = delete;
    PackedModel& operator=(const PackedModel&) = delete;

    /// Springs as they are under a drive, its targets and loads.
    void set_drive(const Drive& drive);

    /// As total_forces() without dampers. @param positions 3×N [mm]
    Points forces(const Points& positions);
    /// As potential_energy() without the muscle layer [µJ].
    double energy(const Points& positions);
    /// As total_forces() with dampers.
    Points damped_forces(const MassSpringState& state);

    /// One pass over records that stand as the last call left them: what a benchmark measures.
    void repeat_pass(bool damped);
    /// What a pass moves through memory at least [bytes].
    double bytes_of_pass(bool damped) const;

    struct Data;  ///< what the solver works on: packed_data.h

private:
    std::unique_ptr<Data> data_;
};

/// Name of the instructions that the kernels use on this processor.
const char* kernel_name();

}  // namespace myoface
