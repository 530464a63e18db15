// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "myoface/base/points.h"

namespace myoface {

enum class MuscleKind {
    Linear,     ///< one bundle from bone to skin
    Sheet,      ///< fibres side by side
    Sphincter,  ///< a ring
    Volume      ///< a thick belly between bones
};

/// What contraction does to the skin.
enum class MuscleAction {
    Pull,       ///< towards the bone end, by the linear response
    Purse,      ///< towards the ring's centre, by the sphincter's response
    CloseLids,  ///< lids slide along the eyeball until they meet
    RaiseLid,   ///< the upper lid slides up along the eyeball
    Bulge,      ///< the belly lifts the skin over it
    OpenJaw,    ///< the mandible turns about its hinge and takes the skin with it
    ShiftJaw    ///< its side of the mandible goes forward: both sides thrust the chin out
};

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
    std::string latin;
    std::string group;  ///< brow, eye, nose, mouth, chin, neck, jaw: panel section
    std::string action_unit;
    std::string nerve;              ///< branch of the facial nerve, else the cranial nerve
    std::string origin, insertion;  ///< in words
    std::string does, does_ja;
    std::string note, note_ja;  ///< clinical
    MuscleKind kind = MuscleKind::Linear;
    MuscleAction action = MuscleAction::Pull;
    Side side = Side::Middle;
    MuscleZone zone = MuscleZone::All;
    double half_angle = 0.6;     ///< Ω of the sector [rad]
    double falloff_start = 0.9;  ///< R_s as a share of the muscle's length
    double falloff_end = 1.4;    ///< R_f likewise
    double breadth = 8.0;        ///< of the belly [mm]
    double pull = 6.0;           ///< skin end's way at full contraction [mm]
    double gain = 1.0;           ///< target shift per wanted way, calibrated after relaxation
    double strength = 1.0;       ///< tension at full contraction [N]
    bool shares_mouth = false;   ///< sphincter: its ring is half of the mouth's
    /// Sphincter: how far its response reaches along and across, of the ring's own size.
    double reach_wide = 1.3, reach_high = 1.3;
    double rise = 0.0;  ///< sphincter: centre of its response above the ring's, of its height
    /// Sphincter: shares of the pull across the ring's longer axis above and below it.
    double across_above = 1.0, across_below = 1.0;
    double forward = 0.0;  ///< sphincter: share of the pull along the ring's normal
};

/// A muscle in the coordinates of the average head.
struct AtlasMuscle {
    MuscleTraits traits;
    Points path;  ///< bone end first; closed ring (sphincter); the middle fibre of a sheet [mm]
    std::vector<Points> edges;     ///< outermost fibres of sheets and volumes
    bool deep = false;             ///< runs inside the orbit, not under the skin
    double origin_depth = 1.0;     ///< of the bone end, as a share of the tissue's depth
    double insertion_depth = 0.3;  ///< of the other end
};

using MuscleAtlas = std::vector<AtlasMuscle>;

/// An atlas as assets/muscles.json writes it down, both sides of paired muscles.
/// @throws IoError when it is damaged
MuscleAtlas muscle_atlas_from_json(std::string_view text);

/// The atlas that comes with the program: assets/muscles.json, both sides of paired muscles.
/// @throws IoError when it is damaged
const MuscleAtlas& muscle_atlas();

/// Indices of the muscles a name means: "zygomaticus_major" both sides, with .L or .R one.
/// @throws InvalidInput for an unknown name, with the nearest known one
std::vector<int> muscles_named(const std::string& name);

}  // namespace myoface
