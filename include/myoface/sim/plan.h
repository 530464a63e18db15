// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "myoface/sim/simulator.h"

namespace myoface {

/// A drag as a script gives it:
/// "at=prn|vertex 3440|x,y,z; view=left|dx,dy,dz; move=RIGHT,UP; mode=mouse|constraint; radius=MM;
///  mirror=0|1". Points are in the scan file's own unit and axes, moves in mm in the view's plane.
struct DragEdit {
    std::string at = "prn";
    std::string view = "front";
    Eigen::Vector2d move = Eigen::Vector2d::Zero();
    DragMode mode = DragMode::MousePriority;
    double radius = 0.0;
    bool mirrored = false;
};
/// @throws InvalidInput saying which part is wrong
DragEdit parse_drag(const std::string& text);
std::string drag_to_text(const DragEdit& drag);

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
using Edit = std::variant<ContractionEdit, StrengthEdit, DragEdit, ExpressionEdit>;
using Plan = std::vector<Edit>;

/// {"plan": [{"muscle": name, "rate": c}, {"muscle": name, "strength": s}, {"drag": text},
///           {"expression": name, "intensity": w}]}
/// @throws IoError, InvalidInput
Plan plan_from_json(const std::string& text, const std::string& name);
std::string plan_to_json(const Plan& plan);

/// "NAME=value" of a --muscle or --strength option. @throws InvalidInput
std::pair<std::string, double> parse_setting(const std::string& text);

/// What a plan did.
struct PlanReport {
    StepReport last;
    std::vector<DragReport> drags;
};

/// Carries a plan out to rest. Of several drags each acts on what the one before left; the last one
/// is still held when it is a constraint drag.
/// @param seconds where given, a last constraint drag is let go, and then, or where muscles came
///        last, so much time goes by instead of rest being waited for
/// @throws InvalidInput naming the edit
PlanReport run_plan(Simulator& simulator, const Plan& plan,
                    std::optional<double> seconds = std::nullopt);

}  // namespace myoface
