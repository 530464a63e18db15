// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "myoface/sim/shaping.h"
#include "myoface/sim/target.h"

namespace myoface {

/// A place of the skin as a recorded edit holds it: exact on the face it was made on, and by the
/// average head and the nearest landmark on any other. @see carried()
struct PlanPlace {
    SurfacePoint where;        ///< on FaceModel::skin
    Vec3 xyz = Vec3::Zero();   ///< on the scan as it was, our frame [mm]
    Vec3 head = Vec3::Zero();  ///< on the average head [mm]
    std::string near;          ///< landmark
    Vec3 off = Vec3::Zero();   ///< from that landmark, to the face's left, up and front [mm]
};

/// A drag as a script gives it:
/// "at=prn|vertex 3440|x,y,z; view=left|dx,dy,dz; move=RIGHT,UP; mode=mouse|constraint; radius=MM;
///  mirror=0|1; path=free|normal|midplane; keep=0|1; force=N". Points are in the scan file's own
///  unit and
/// axes, moves in mm in the view's plane. A mouse drag always keeps its shape. With a force a
/// constraint drag pulls that hard in the direction of the move, however long that is.
struct DragEdit {
    std::string at = "prn";
    std::string view = "front";
    Eigen::Vector2d move = Eigen::Vector2d::Zero();
    DragMode mode = DragMode::MousePriority;
    double radius = 0.0;
    bool mirrored = false;
    DragPath path = DragPath::Free;
    bool keep = false;               ///< of a constraint drag: the shape stays
    double force_N = 0.0;            ///< of a constraint drag; 0: as hard as the hand is far
    std::optional<PlanPlace> place;  ///< wins over `at`
};
/// @throws InvalidInput saying which part is wrong
DragEdit parse_drag(const std::string& text);
std::string drag_to_text(const DragEdit& drag);

/// "at=…; ml=0.5; radius=MM; mirror=0|1". @see add_volume()
struct VolumeEdit {
    std::string at = "zy_l";
    double ml = 0.5;
    double radius = 0.0;
    bool mirrored = false;
    std::optional<PlanPlace> place;
};
/// @throws InvalidInput saying which part is wrong
VolumeEdit parse_volume(const std::string& text);
std::string volume_to_text(const VolumeEdit& volume);

/// "MEASURE=NUMBER" or "MEASURE by CHANGE", and "; radius=MM". @see meet_target()
struct TargetEdit {
    std::string measure;
    double value = 0.0;
    bool relative = false;
    double radius = 0.0;
};
/// @throws InvalidInput
TargetEdit parse_target(const std::string& text);
std::string target_to_text(const TargetEdit& target);

/// "at=…; radius=MM; mirror=0|1; erase=0|1": skin that the edits after it leave alone, or no longer
/// do. "none": all of it is free again.
struct ProtectEdit {
    std::string at;
    double radius = 0.0;
    bool mirrored = false;
    bool erases = false;
    bool none = false;
    std::optional<PlanPlace> place;
};
/// @throws InvalidInput
ProtectEdit parse_protect(const std::string& text);
std::string protect_to_text(const ProtectEdit& protect);

struct ContractionEdit {
    std::string muscle;
    double rate = 0.0;
};
struct StrengthEdit {
    std::string muscle;
    double strength = 1.0;
};

/// Adds to the contractions that are there.
struct ExpressionEdit {
    std::string expression;
    double intensity = 1.0;
};

/// A shape that no gesture made: of a variant that was taken, or the scan's own.
struct ShapeEdit {
    int vertices = 0;        ///< of the scan; 0: as the scan came
    std::vector<int> moved;  ///< which of them
    Points by;               ///< 3×moved [mm]
};
/// @param shape see shape_of_scan()
ShapeEdit shape_edit(const Points& shape);

/// Edits in the order they are made.
using Edit = std::variant<ContractionEdit, StrengthEdit, DragEdit, ExpressionEdit, VolumeEdit,
                          TargetEdit, ProtectEdit, ShapeEdit>;
using Plan = std::vector<Edit>;

/// What kind of edit it is, in a word or two: "drag", "muscle zygomaticus_major.L".
std::string edit_title(const Edit& edit);

/// "NAME=value" of a --muscle or --strength option. @throws InvalidInput
std::pair<std::string, double> parse_setting(const std::string& text);

/// What a plan did.
struct PlanReport {
    StepReport last;
    std::vector<DragReport> drags;
    std::vector<VolumeReport> volumes;
    std::vector<TargetReport> targets;
};

/// Carries a plan out to rest. Of several drags each acts on what the one before left; the last one
/// is still held when it is a constraint drag.
/// @param seconds where given, a last constraint drag is let go, and then, or where muscles came
///        last, so much time goes by instead of rest being waited for
/// @throws InvalidInput naming the edit
PlanReport run_plan(Simulator& simulator, const Plan& plan,
                    std::optional<double> seconds = std::nullopt);

/// An edit that could not be made, and why.
struct RefusedEdit {
    int edit = 0;  ///< from 1
    std::string what, why;
};
/// As run_plan(), but an edit that cannot be made is left out and told.
PlanReport run_what_goes(Simulator& simulator, const Plan& plan, std::vector<RefusedEdit>& refused,
                         std::optional<double> seconds = std::nullopt);

}  // namespace myoface
