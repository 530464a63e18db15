// SPDX-License-Identifier: Apache-2.0
#include "myoface/sim/plan.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"
#include "myoface/mesh/bvh.h"
#include "myoface/muscle/expression.h"

namespace myoface {
namespace {

using nlohmann::json;

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    const std::size_t end = text.find_last_not_of(" \t");
    return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

bool read_number(const std::string& text, double& value) {
    const std::string word = trimmed(text);
    const char* begin = word.data() + (!word.empty() && word[0] == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    return !word.empty() && error == std::errc() && end == word.data() + word.size() &&
           std::isfinite(value);
}

/// Numbers between commas; empty when one of them is not a number.
std::vector<double> numbers(const std::string& text) {
    std::vector<double> result;
    std::size_t at = 0;
    while (at <= text.size()) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        double value = 0.0;
        if (!read_number(text.substr(at, comma - at), value)) {
            return {};
        }
        result.push_back(value);
        at = comma + 1;
    }
    return result;
}

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
        throw InvalidInput("Drag: '" + at +
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

DragReport run_drag(Simulator& simulator, const DragEdit& drag, bool last, PlanReport& report) {
    const FaceModel& face = simulator.face();
    const TriangleMesh now{simulator.state().positions.leftCols(face.node_count()),
                           face.skin.mesh.triangles};
    const Vec3 place = grabbed_place(face, drag.at);
    // Places are meant on the scan as it was; the hand grips the same skin where it is now.
    const ClosestPoint hit = Bvh(face.skin.mesh).closest_point(face.skin.mesh, place);
    if (hit.distance > 25.0) {
        throw InvalidInput("Drag: '" + drag.at + "' lies " +
                           std::to_string(static_cast<int>(hit.distance)) +
                           " mm away from the skin.");
    }
    DragRequest request;
    request.where = hit.where;
    request.mode = drag.mode;
    request.radius = drag.radius;
    request.mirrored = drag.mirrored;
    const View view = view_of(drag.view);
    ViewRay ray{position(now, hit.where), view.forward};
    simulator.begin_drag(request, ray);
    ray.origin += drag.move.x() * view.right + drag.move.y() * view.up;
    simulator.move_drag(ray);
    report.last = simulator.settle();
    DragReport result = *report.last.drag;
    if (drag.mode == DragMode::MousePriority || !last) {
        simulator.end_drag(true);
    }
    return result;
}

}  // namespace

DragEdit parse_drag(const std::string& text) {
    DragEdit drag;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(';', at), text.size());
        const std::string part = trimmed(text.substr(at, end - at));
        at = end + 1;
        if (part.empty()) {
            continue;
        }
        const std::size_t equals = part.find('=');
        const std::string key = trimmed(part.substr(0, equals));
        const std::string value =
            equals == std::string::npos ? "" : trimmed(part.substr(equals + 1));
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
        } else if (key == "radius") {
            if (!read_number(value, drag.radius) || drag.radius < 0.0 || drag.radius > 100.0) {
                wrong("radius is a number of millimetres from 0 to 100.");
            }
        } else if (key == "mirror") {
            if (value != "0" && value != "1") {
                wrong("mirror is 0 or 1.");
            }
            drag.mirrored = value == "1";
        } else {
            wrong("'" + key + "' is not one of at, view, move, mode, radius, mirror.");
        }
    }
    return drag;
}

std::string drag_to_text(const DragEdit& drag) {
    std::string text = "at=" + drag.at + "; view=" + drag.view + "; move=";
    append_number(text, drag.move.x());
    text += ',';
    append_number(text, drag.move.y());
    text += drag.mode == DragMode::MousePriority ? "; mode=mouse" : "; mode=constraint";
    if (drag.radius > 0.0) {
        text += "; radius=";
        append_number(text, drag.radius);
    }
    return text + (drag.mirrored ? "; mirror=1" : "");
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
        if (edit.is_object() && edit.contains("drag") && edit["drag"].is_string()) {
            plan.emplace_back(parse_drag(edit["drag"].get<std::string>()));
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
            throw IoError(place +
                          "is neither a drag, nor a muscle with a rate or strength, nor an "
                          "expression with an intensity.");
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
        } else {
            if (!settled) {
                simulator.settle();
            }
            const bool last = i + 1 == plan.size();
            report.drags.push_back(run_drag(simulator, std::get<DragEdit>(plan[i]), last, report));
            settled = true;
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
