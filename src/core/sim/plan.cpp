// SPDX-License-Identifier: Apache-2.0
#include "myoface/sim/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"
#include "myoface/mesh/bvh.h"
#include "myoface/muscle/expression.h"

#include "edit_text.h"

namespace myoface {
namespace {

using nlohmann::json;

constexpr double kProtectRadius = 10.0;  // [mm]

Vec3 grabbed_place(const FaceModel& face, const std::string& at) {
    if (at.rfind("vertex", 0) == 0) {
        double value = -1.0;
        const int count = face.scan->mesh.vertex_count();
        if (!read_number(at.substr(6), value) || value < 0 || value >= count ||
            value != std::floor(value)) {
            throw InvalidInput("Drag: '" + at + "' is not a vertex of the scan (0 to " +
                               std::to_string(count - 1) + ").");
        }
        return face.scan->mesh.vertices.col(static_cast<Eigen::Index>(value));
    }
    const std::vector<double> xyz = numbers(at);
    if (xyz.size() == 3) {
        return face.scan->frame.to_model({xyz[0], xyz[1], xyz[2]});
    }
    const auto found = face.landmarks.find(at);
    if (found == face.landmarks.end()) {
        throw InvalidInput("'" + at +
                           "' is neither a landmark of this face, 'vertex N' nor 'x,y,z'.");
    }
    return found->second.position;
}

struct View {
    Vec3 right, up, forward;
};

View view_of(const std::string& name) {
    const std::vector<double> xyz = numbers(name);
    if (xyz.size() == 3) {
        const Vec3 direction(xyz[0], xyz[1], xyz[2]);
        if (!(direction.norm() > 1e-9)) {
            throw InvalidInput("Drag: the view direction has no length.");
        }
        const auto plane = view_plane(direction);
        return {plane.col(0), plane.col(1), direction.normalized()};
    }
    const Eigen::Quaterniond q = standard_view(name);
    return {q * Vec3::UnitX(), q * Vec3::UnitY(), q * -Vec3::UnitZ()};
}

/// The place of the skin that is meant, and where it is now. Places are meant on the scan as it
/// was.
SurfacePoint place_on_skin(const FaceModel& face, const std::string& at) {
    const ClosestPoint hit =
        Bvh(face.skin.mesh).closest_point(face.skin.mesh, grabbed_place(face, at));
    if (hit.distance > 25.0) {
        throw InvalidInput("'" + at + "' lies " + std::to_string(static_cast<int>(hit.distance)) +
                           " mm away from the skin.");
    }
    return hit.where;
}

DragReport run_drag(Simulator& simulator, const DragEdit& drag, bool last, PlanReport& report) {
    const FaceModel& face = simulator.face();
    const TriangleMesh now{simulator.state().positions.leftCols(face.node_count()),
                           face.skin.mesh.triangles};
    const SurfacePoint where = place_on_skin(face, drag.at);
    DragRequest request;
    request.where = where;
    request.mode = drag.mode;
    request.radius = drag.radius;
    request.mirrored = drag.mirrored;
    request.path = drag.path;
    const View view = view_of(drag.view);
    ViewRay ray{position(now, where), view.forward};
    simulator.begin_drag(request, ray);
    ray.origin += drag.move.x() * view.right + drag.move.y() * view.up;
    simulator.move_drag(ray);
    report.last = simulator.settle();
    DragReport result = *report.last.drag;
    if (drag.mode == DragMode::MousePriority || !last) {
        simulator.end_drag(drag.mode == DragMode::MousePriority);
    }
    return result;
}

constexpr std::array<std::string_view, 3> kPaths{"free", "normal", "midplane"};

/// Radius and mirror, which several edits have. @return whether the key was one of them
template <typename Wrong>
bool take_place(const std::string& key, const std::string& value, double& radius, bool& mirrored,
                const Wrong& wrong) {
    if (key == "radius") {
        if (!read_number(value, radius) || radius < 0.0 || radius > 100.0) {
            wrong("radius is a number of millimetres from 0 to 100.");
        }
        return true;
    }
    if (key == "mirror") {
        if (value != "0" && value != "1") {
            wrong("mirror is 0 or 1.");
        }
        mirrored = value == "1";
        return true;
    }
    return false;
}

void append_place(std::string& text, double radius, bool mirrored) {
    if (radius > 0.0) {
        text += "; radius=";
        append_number(text, radius);
    }
    text += mirrored ? "; mirror=1" : "";
}

/// Adds to what is protected already.
void run_protect(Simulator& simulator, const ProtectEdit& protect) {
    const FaceModel& face = simulator.face();
    const double radius = protect.radius > 0.0 ? protect.radius : kProtectRadius;
    Eigen::VectorXd share = simulator.protection().size() > 0
                                ? simulator.protection()
                                : Eigen::VectorXd::Zero(face.node_count());
    const SurfacePoint where = place_on_skin(face, protect.at);
    share = share.cwiseMax(brushed(face, where, radius));
    if (protect.mirrored) {
        share = share.cwiseMax(brushed(face, mirrored_place(face, where), radius));
    }
    simulator.set_protection(share);
}

}  // namespace

DragEdit parse_drag(const std::string& text) {
    DragEdit drag;
    each_part(text, [&](const std::string& key, const std::string& value) {
        const auto wrong = [&](const std::string& what) {
            throw InvalidInput("Drag '" + text + "': " + what);
        };
        if (key == "at") {
            drag.at = value;
        } else if (key == "view") {
            drag.view = value;
            view_of(value);
        } else if (key == "move") {
            const std::vector<double> xy = numbers(value);
            if (xy.size() != 2 || std::abs(xy[0]) > 200.0 || std::abs(xy[1]) > 200.0) {
                wrong("move needs two numbers of millimetres, RIGHT,UP, of at most 200.");
            }
            drag.move = {xy[0], xy[1]};
        } else if (key == "mode") {
            if (value != "mouse" && value != "constraint") {
                wrong("mode is mouse or constraint.");
            }
            drag.mode = value == "mouse" ? DragMode::MousePriority : DragMode::ConstraintPriority;
        } else if (key == "path") {
            const auto path = std::find(kPaths.begin(), kPaths.end(), value);
            if (path == kPaths.end()) {
                wrong("path is free, normal or midplane.");
            }
            drag.path = static_cast<DragPath>(path - kPaths.begin());
        } else if (!take_place(key, value, drag.radius, drag.mirrored, wrong)) {
            wrong("'" + key + "' is not one of at, view, move, mode, radius, mirror, path.");
        }
    });
    return drag;
}

VolumeEdit parse_volume(const std::string& text) {
    VolumeEdit volume;
    each_part(text, [&](const std::string& key, const std::string& value) {
        const auto wrong = [&](const std::string& what) {
            throw InvalidInput("Volume '" + text + "': " + what);
        };
        if (key == "at") {
            volume.at = value;
        } else if (key == "ml") {
            if (!read_number(value, volume.ml)) {
                wrong("ml is a number of millilitres.");
            }
        } else if (!take_place(key, value, volume.radius, volume.mirrored, wrong)) {
            wrong("'" + key + "' is not one of at, ml, radius, mirror.");
        }
    });
    return volume;
}

std::string volume_to_text(const VolumeEdit& volume) {
    std::string text = "at=" + volume.at + "; ml=";
    append_number(text, volume.ml);
    append_place(text, volume.radius, volume.mirrored);
    return text;
}

TargetEdit parse_target(const std::string& text) {
    TargetEdit target;
    const std::size_t by = text.rfind(" by ");
    const std::size_t equals = text.rfind('=');
    const bool relative = equals == std::string::npos && by != std::string::npos;
    const std::size_t at = relative ? by : equals;
    if (at == std::string::npos ||
        !read_number(text.substr(at + (relative ? 4 : 1)), target.value)) {
        throw InvalidInput("Target '" + text +
                           "' is neither \"MEASURE=NUMBER\" nor \"MEASURE by CHANGE\".");
    }
    target.measure = trimmed(text.substr(0, at));
    target.relative = relative;
    target_measure(target.measure);
    return target;
}

std::string target_to_text(const TargetEdit& target) {
    std::string text = target.measure + (target.relative ? " by " : "=");
    append_number(text, target.value);
    return text;
}

ProtectEdit parse_protect(const std::string& text) {
    ProtectEdit protect;
    each_part(text, [&](const std::string& key, const std::string& value) {
        const auto wrong = [&](const std::string& what) {
            throw InvalidInput("Protect '" + text + "': " + what);
        };
        if (key == "at") {
            protect.at = value;
        } else if (!take_place(key, value, protect.radius, protect.mirrored, wrong)) {
            wrong("'" + key + "' is not one of at, radius, mirror.");
        }
    });
    return protect;
}

std::string protect_to_text(const ProtectEdit& protect) {
    std::string text = "at=" + protect.at;
    append_place(text, protect.radius, protect.mirrored);
    return text;
}

std::string drag_to_text(const DragEdit& drag) {
    std::string text = "at=" + drag.at + "; view=" + drag.view + "; move=";
    append_number(text, drag.move.x());
    text += ',';
    append_number(text, drag.move.y());
    text += drag.mode == DragMode::MousePriority ? "; mode=mouse" : "; mode=constraint";
    append_place(text, drag.radius, drag.mirrored);
    if (drag.path != DragPath::Free) {
        text += "; path=";
        text += kPaths[static_cast<std::size_t>(drag.path)];
    }
    return text;
}

Plan plan_from_json(const std::string& text, const std::string& name) {
    const json document = json::parse(text, nullptr, false);
    if (!document.is_object() || !document.contains("plan") || !document["plan"].is_array()) {
        throw IoError(name + ": is not a plan: a JSON object with a list \"plan\" is needed.");
    }
    Plan plan;
    for (const json& edit : document["plan"]) {
        const std::string place = name + " edit " + std::to_string(plan.size() + 1) + ": ";
        const bool muscle =
            edit.is_object() && edit.contains("muscle") && edit["muscle"].is_string();
        const auto is_text = [&](const char* key) {
            return edit.is_object() && edit.contains(key) && edit[key].is_string();
        };
        if (is_text("drag")) {
            plan.emplace_back(parse_drag(edit["drag"].get<std::string>()));
        } else if (is_text("volume")) {
            plan.emplace_back(parse_volume(edit["volume"].get<std::string>()));
        } else if (is_text("target")) {
            plan.emplace_back(parse_target(edit["target"].get<std::string>()));
        } else if (is_text("protect")) {
            plan.emplace_back(parse_protect(edit["protect"].get<std::string>()));
        } else if (muscle && edit.contains("rate") && edit["rate"].is_number()) {
            plan.emplace_back(
                ContractionEdit{edit["muscle"].get<std::string>(), edit["rate"].get<double>()});
        } else if (edit.is_object() && edit.contains("expression") &&
                   edit["expression"].is_string() && edit.contains("intensity") &&
                   edit["intensity"].is_number()) {
            plan.emplace_back(ExpressionEdit{edit["expression"].get<std::string>(),
                                             edit["intensity"].get<double>()});
        } else if (muscle && edit.contains("strength") && edit["strength"].is_number()) {
            plan.emplace_back(
                StrengthEdit{edit["muscle"].get<std::string>(), edit["strength"].get<double>()});
        } else {
            throw IoError(
                place +
                "is none of drag, volume, target and protect, nor a muscle with a rate or "
                "strength, nor an expression with an intensity.");
        }
    }
    return plan;
}

std::string plan_to_json(const Plan& plan) {
    json list = json::array();
    for (const Edit& edit : plan) {
        if (const auto* rate = std::get_if<ContractionEdit>(&edit)) {
            list.push_back({{"muscle", rate->muscle}, {"rate", rate->rate}});
        } else if (const auto* strength = std::get_if<StrengthEdit>(&edit)) {
            list.push_back({{"muscle", strength->muscle}, {"strength", strength->strength}});
        } else if (const auto* expression = std::get_if<ExpressionEdit>(&edit)) {
            list.push_back(
                {{"expression", expression->expression}, {"intensity", expression->intensity}});
        } else if (const auto* volume = std::get_if<VolumeEdit>(&edit)) {
            list.push_back({{"volume", volume_to_text(*volume)}});
        } else if (const auto* target = std::get_if<TargetEdit>(&edit)) {
            list.push_back({{"target", target_to_text(*target)}});
        } else if (const auto* protect = std::get_if<ProtectEdit>(&edit)) {
            list.push_back({{"protect", protect_to_text(*protect)}});
        } else {
            list.push_back({{"drag", drag_to_text(std::get<DragEdit>(edit))}});
        }
    }
    return json{{"plan", list}}.dump(1) + "\n";
}

std::pair<std::string, double> parse_setting(const std::string& text) {
    const std::size_t equals = text.rfind('=');
    double value = 0.0;
    if (equals == std::string::npos || equals == 0 ||
        !read_number(text.substr(equals + 1), value)) {
        throw InvalidInput("'" + text + "' is not of the form NAME=NUMBER.");
    }
    return {trimmed(text.substr(0, equals)), value};
}

PlanReport run_plan(Simulator& simulator, const Plan& plan, std::optional<double> seconds) {
    PlanReport report;
    bool settled = false;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        if (const auto* expression = std::get_if<ExpressionEdit>(&plan[i])) {
            if (!(expression->intensity >= 0.0 && expression->intensity <= 1.0)) {
                throw InvalidInput("The intensity of " + expression->expression +
                                   " must lie between 0 and 1.");
            }
            std::vector<double> rates = simulator.contractions().rate;
            add_expression(rates, expression_named(expression->expression), expression->intensity);
            for (std::size_t m = 0; m < rates.size(); ++m) {
                if (rates[m] != simulator.contractions().rate[m]) {
                    simulator.set_contraction(static_cast<int>(m), rates[m]);
                }
            }
            settled = false;
            continue;
        }
        if (const auto* rate = std::get_if<ContractionEdit>(&plan[i])) {
            for (const int m : muscles_named(rate->muscle)) {
                simulator.set_contraction(m, rate->rate);
            }
            settled = false;
        } else if (const auto* strength = std::get_if<StrengthEdit>(&plan[i])) {
            for (const int m : muscles_named(strength->muscle)) {
                simulator.set_strength(m, strength->strength);
            }
            settled = false;
        } else if (const auto* protect = std::get_if<ProtectEdit>(&plan[i])) {
            run_protect(simulator, *protect);
        } else {
            if (!settled) {
                report.last = simulator.settle();
            }
            settled = true;
            if (const auto* volume = std::get_if<VolumeEdit>(&plan[i])) {
                report.volumes.push_back(
                    add_volume(simulator, {place_on_skin(simulator.face(), volume->at), volume->ml,
                                           volume->radius, volume->mirrored}));
                settled = false;
                continue;
            }
            if (const auto* target = std::get_if<TargetEdit>(&plan[i])) {
                report.targets.push_back(meet_target(
                    simulator, {target_measure(target->measure), target->value, target->relative}));
                settled = false;
                continue;
            }
            const bool last = i + 1 == plan.size();
            report.drags.push_back(run_drag(simulator, std::get<DragEdit>(plan[i]), last, report));
        }
    }
    if (seconds) {
        if (simulator.dragging()) {
            simulator.end_drag(false);
        }
        report.last = simulator.live_on(*seconds);
    } else if (!settled) {
        report.last = simulator.settle();
    }
    return report;
}

}  // namespace myoface
