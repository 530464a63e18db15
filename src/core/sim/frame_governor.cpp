// SPDX-License-Identifier: Apache-2.0
#include "myoface/sim/frame_governor.h"

#include <algorithm>

namespace myoface {

namespace {
constexpr int kFewestSweeps = 3;  // half a round: the next frame goes on with it
constexpr int kMostSweeps = 400;
constexpr double kTrust = 0.25;  // in the newest measurement, when it is faster than expected
}  // namespace

int FrameGovernor::sweeps(double budget) const {
    return std::clamp(static_cast<int>(budget / each_), kFewestSweeps, kMostSweeps);
}

void FrameGovernor::learn(const StepReport& report) {
    if (report.iterations == 0) {
        return;
    }
    const double each = std::max(report.milliseconds / report.iterations, 1e-3);
    // A frame that came late must not come late again; one that came early may have been lucky.
    each_ = each > each_ ? 0.5 * (each + each_) : each_ + kTrust * (each - each_);
}

}  // namespace myoface
