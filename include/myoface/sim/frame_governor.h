// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/sim/simulator.h"

namespace myoface {

/// Fits the work of a frame to its time: so many sweeps as the last ones say will do.
class FrameGovernor {
public:
    /// @param budget [ms]
    int sweeps(double budget) const;
    void learn(const StepReport& report);

private:
    double each_ = 1.0;  ///< of a sweep, corrections by coarser levels included [ms]
};

}  // namespace myoface
