// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "myoface/sim/simulator.h"

namespace myoface::test {

/// How far and where a mouth corner has gone [mm], in the face's own axes.
struct CornerTravel {
    double way = 0.0, up = 0.0, back = 0.0, outwards = 0.0;
};
CornerTravel corner_travel(const Simulator& simulator, Side side);

/// The widest open place between the lids of an eye [mm], looked at from the front; nothing where
/// the scan's skin is closed there or has no eye.
std::optional<double> lid_gap(const FaceModel& face, const Points& nodes, Side side);

/// How deep lids that lie outside an eyeball at rest stand inside it [mm].
double deepest_in_eye(const FaceModel& face, const Points& nodes);
/// The same of skin and bone, the mandible where the jaw has it.
double deepest_in_bone(const FaceModel& face, const Points& nodes, const JawPose& jaw);

/// How far touching lips have passed through each other [mm], and how far they are apart in the
/// middle third of the mouth.
struct LipState {
    double crossed = 0.0, apart = 0.0;
};
LipState lips(const FaceModel& face, const Points& nodes);

/// Share of all motion that happens on the other side of the midline, a margin of 6 mm left out.
double share_on_other_side(const FaceModel& face, const Points& nodes, Side side);

/// Sets these contractions, all others to rest, and settles.
StepReport pose(Simulator& simulator, const std::vector<double>& rates);

}  // namespace myoface::test
