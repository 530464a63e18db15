// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "myoface/base/points.h"

namespace myoface {

enum class MuscleKind { Linear, Sphincter };
enum class Side { Middle, Left, Right };

/// Which nodes a muscle's kernel may move.
enum class MuscleZone {
    All,
    UpperLip,  ///< not the lower lip
    LowerLip,  ///< not the upper lip
    Brow,      ///< above the lids
    Nose       ///< nose and what touches it
};

/// What the atlas says of a muscle; the same for every face.
struct MuscleTraits {
    std::string name;       ///< zygomaticus_major.L
    std::string base_name;  ///< zygomaticus_major
    std::string title;      ///< zygomaticus major
    std::string title_ja;
    std::string group;  ///< brow, eye, nose, mouth, chin: panel section
    std::string action_unit;
    MuscleKind kind = MuscleKind::Linear;
    Side side = Side::Middle;
    MuscleZone zone = MuscleZone::All;
    double half_angle = 0.6;     ///< Ω of the sector [rad]
    double falloff_start = 0.9;  ///< R_s as a share of the muscle's length
    double falloff_end = 1.4;    ///< R_f likewise
    double breadth = 8.0;        ///< of the belly [mm]
    double pull = 6.0;           ///< skin end's way at full contraction [mm]
    double gain = 1.0;           ///< target shift per wanted way, calibrated after relaxation
    double strength = 1.0;       ///< tension at full contraction [N]
    double forward = 0.0;        ///< sphincter: share of the pull along the ring's normal
};

/// A muscle in the coordinates of the average head.
struct AtlasMuscle {
    MuscleTraits traits;
    Points path;  ///< bone end first (linear), closed ring (sphincter) [mm]
};

using MuscleAtlas = std::vector<AtlasMuscle>;

/// The atlas that comes with the program: assets/muscles.json, both sides of paired muscles.
/// @throws IoError when it is damaged
const MuscleAtlas& muscle_atlas();

/// Indices of the muscles a name means: "zygomaticus_major" both sides, with .L or .R one.
/// @throws InvalidInput for an unknown name, with the nearest known one
std::vector<int> muscles_named(const std::string& name);

}  // namespace myoface
