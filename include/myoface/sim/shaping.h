// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

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

}  // namespace myoface
