// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "myoface/measure/measurement.h"
#include "myoface/sim/simulator.h"

namespace myoface {

/// Tissue added or taken away under a place of the skin: a filler, fat, an implant, a reduction.
struct VolumeRequest {
    SurfacePoint where;
    double ml = 0.5;      ///< below zero: taken away; of a mirrored one, on each side
    double radius = 0.0;  ///< [mm]; 0: by region
    bool mirrored = false;
};
struct VolumeReport {
    double ml = 0.0;            ///< what was added in all
    double pressure_kPa = 0.0;  ///< in the middle
    double kept_share = 1.0;
    std::map<Region, double> by_region;  ///< [mL]
};
/// A pressure under the skin, spread as by StressKernel, rises until the tissue has given way by
/// the wanted volume; the shape stays. @throws InvalidInput when the skin cannot take so much, or
/// the volume is not between -20 and 20 mL
VolumeReport add_volume(Simulator& simulator, const VolumeRequest& request);

/// A measure that is to become a number.
struct TargetRequest {
    Measure measure;
    double value = 0.0;     ///< [mm] or [deg]
    bool relative = false;  ///< value is a change
    double radius = 0.0;    ///< of the grip [mm]; 0: by region
};
struct TargetReport {
    std::string landmark;  ///< that was moved, without side
    double before = 0.0, wanted = 0.0, reached = 0.0;
    double moved_mm = 0.0;  ///< way of the landmark
    double force_mN = 0.0;
    int settles = 0;
};
/// One of all_measures() by id or title, in any case of letters. @throws InvalidInput that lists
/// them
Measure target_measure(const std::string& name);

/// Moves a landmark of the measure, on both sides where it has two, the way that changes the
/// measure most, until the measure is met; tissue follows as for a gesture, and the shape stays.
/// The face is left as it was when that cannot be done.
/// @throws InvalidInput that names the limit: bone, stretch of the skin, or folds
TargetReport meet_target(Simulator& simulator, const TargetRequest& request);

}  // namespace myoface
