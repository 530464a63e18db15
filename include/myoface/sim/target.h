// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "myoface/measure/measurement.h"
#include "myoface/sim/simulator.h"

namespace myoface {

/// A measure that is to become a number.
struct TargetRequest {
    Measure measure;
    double value = 0.0;     ///< [mm] or [deg]
    bool relative = false;  ///< value is a change
    double radius = 0.0;    ///< of the grip [mm]; 0: by region
};
struct TargetReport {
    std::vector<std::string> landmarks;  ///< that were moved, one after another, without side
    double before = 0.0, wanted = 0.0, reached = 0.0;
    double moved_mm = 0.0;  ///< the longest way of a landmark
    double force_mN = 0.0;
    int settles = 0;
};
/// One of all_measures() by id or title, in any case of letters. @throws InvalidInput that lists
/// them
Measure target_measure(const std::string& name);

/// Moves a landmark of the measure, on both sides where it has two, the way that changes the
/// measure most, until the measure is met; tissue follows as for a gesture, and the shape stays.
/// Where bone, stretch of the skin or folds stop it, the measure's next landmark goes on from
/// there. The face is left as it was when that does not do either.
/// @throws InvalidInput that names the limits
TargetReport meet_target(Simulator& simulator, const TargetRequest& request);

}  // namespace myoface
