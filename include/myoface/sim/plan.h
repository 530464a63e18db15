// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "myoface/sim/shaping.h"

namespace myoface {

/// A drag as a script gives it:
/// "at=prn|vertex 3440|x,y,z; view=left|dx,dy,dz; move=RIGHT,UP; mode=mouse|constraint; radius=MM;
///  mirror=0|1; path=free|normal|midplane". Points are in the scan file's own unit and axes, moves
///  in mm in the view's plane.
struct DragEdit {
    std::string at = "prn";
    std::string view = "front";
    Eigen::Vector2d move = Eigen::Vector2d::Zero();
    DragMode mode = DragMode::MousePriority;
    double radius = 0.0;
    bool mirrored = false;
    DragPath path = DragPath::Free;
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
};
/// @throws InvalidInput saying which part is wrong
VolumeEdit parse_volume(const std::string& text);
std::string volume_to_text(const VolumeEdit& volume);

/// "MEASURE=NUMBER" or "MEASURE by CHANGE". @see meet_target()
struct TargetEdit {
    std::string measure;
    double value = 0.0;
    bool relative = false;
};
/// @throws InvalidInput
TargetEdit parse_target(const std::string& text);
std::string target_to_text(const TargetEdit& target);

/// "at=…; radius=MM; mirror=0|1": skin that the edits after it leave alone.
struct ProtectEdit {
    std::string at;
    double radius = 0.0;
    bool mirrored = false;
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

/// Edits in the order they are made.
using Edit = std::variant<ContractionEdit, StrengthEdit, DragEdit, ExpressionEdit, VolumeEdit,
                          TargetEdit, ProtectEdit>;
using Plan = std::vector<Edit>;

/// {"plan": [{"muscle": name, "rate": c}, {"muscle": name, "strength": s}, {"drag": text},
///           {"expression": name, "intensity": w}, {"volume": text}, {"target": text},
///           {"protect": text}]}
/// @throws IoError, InvalidInput
Plan plan_from_json(const std::string& text, const std::string& name);
std::string plan_to_json(const Plan& plan);

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

}  // namespace myoface
