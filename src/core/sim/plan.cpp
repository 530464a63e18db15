// SPDX-License-Identifier: Apache-2.0
// Carries plans out.
#include "myoface/sim/plan.h"

#include <cmath>

#include "myoface/base/error.h"
#include "myoface/mesh/bvh.h"
#include "myoface/muscle/expression.h"

#include "edit_text.h"

namespace myoface {
namespace {

constexpr double kProtectRadius = 10.0;  // [mm]
constexpr double kFarFromSkin = 25.0;    // [mm]

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

/// The place of the skin that is meant. Places are meant on the scan as it was.
SurfacePoint place_on_skin(const FaceModel& face, const std::string& at,
                           const std::optional<PlanPlace>& place) {
    if (place) {
        if (place->where.triangle < 0 || place->where.triangle >= face.skin.mesh.triangle_count()) {
            throw InvalidInput("Its place is on a triangle that this face does not have.");
        }
        return place->where;
    }
    const ClosestPoint hit =
        Bvh(face.skin.mesh).closest_point(face.skin.mesh, grabbed_place(face, at));
    if (!(hit.distance <= kFarFromSkin)) {
        throw InvalidInput("'" + at + "' lies " +
                           std::to_string(static_cast<int>(std::min(hit.distance, 1e6))) +
                           " mm away from the skin.");
    }
    return hit.where;
}

/// Makes one edit after the other.
class PlanRunner {
public:
    PlanRunner(Simulator& simulator, PlanReport& report) : simulator_(simulator), report_(report) {}

    void run(const Edit& edit, bool last) {
        last_ = last;
        std::visit(*this, edit);
    }
    void finish(std::optional<double> seconds) {
        if (seconds) {
            if (simulator_.dragging()) {
                simulator_.end_drag(false);
            }
            report_.last = simulator_.live_on(*seconds);
        } else if (!settled_) {
            report_.last = simulator_.settle();
        }
    }

    void operator()(const ContractionEdit& edit) {
        for (const int m : muscles_named(edit.muscle)) {
            simulator_.set_contraction(m, edit.rate);
        }
        settled_ = false;
    }
    void operator()(const StrengthEdit& edit) {
        for (const int m : muscles_named(edit.muscle)) {
            simulator_.set_strength(m, edit.strength);
        }
        settled_ = false;
    }
    void operator()(const ExpressionEdit& edit) {
        if (!(edit.intensity >= 0.0 && edit.intensity <= 1.0)) {
            throw InvalidInput("The intensity of " + edit.expression +
                               " must lie between 0 and 1.");
        }
        std::vector<double> rates = simulator_.contractions().rate;
        add_expression(rates, expression_named(edit.expression), edit.intensity);
        simulator_.set_contractions(rates);
        settled_ = false;
    }
    void operator()(const DragEdit& drag) {
        settle();
        const FaceModel& face = simulator_.face();
        const TriangleMesh now{simulator_.state().positions.leftCols(face.node_count()),
                               face.skin.mesh.triangles};
        DragRequest request;
        request.where = place_on_skin(face, drag.at, drag.place);
        request.mode = drag.mode;
        request.radius = drag.radius;
        request.mirrored = drag.mirrored;
        request.path = drag.path;
        request.force_mN = 1000.0 * drag.force_N;
        const ViewAxes view = view_axes(drag.view);
        ViewRay ray{position(now, request.where), view.forward};
        simulator_.begin_drag(request, ray);
        ray.origin += drag.move.x() * view.right + drag.move.y() * view.up;
        simulator_.move_drag(ray);
        report_.last = simulator_.settle();
        DragReport result = *report_.last.drag;
        const bool keep = drag.mode == DragMode::MousePriority || drag.keep;
        if (keep || !last_) {
            const DragReport ended = simulator_.end_drag(keep);
            result.kept_share = ended.kept_share;
        }
        report_.drags.push_back(result);
    }
    void operator()(const VolumeEdit& edit) {
        settle();
        settled_ = false;
        const SurfacePoint where = place_on_skin(simulator_.face(), edit.at, edit.place);
        report_.volumes.push_back(
            add_volume(simulator_, {where, edit.ml, edit.radius, edit.mirrored}));
    }
    void operator()(const TargetEdit& edit) {
        settle();
        settled_ = false;
        report_.targets.push_back(meet_target(
            simulator_, {target_measure(edit.measure), edit.value, edit.relative, edit.radius}));
    }
    /// Adds to what is protected already, or takes from it.
    void operator()(const ProtectEdit& edit) {
        if (edit.none) {
            simulator_.set_protection({});
            return;
        }
        const FaceModel& face = simulator_.face();
        const double radius = edit.radius > 0.0 ? edit.radius : kProtectRadius;
        Eigen::VectorXd share = simulator_.protection().size() > 0
                                    ? simulator_.protection()
                                    : Eigen::VectorXd::Zero(face.node_count());
        const auto stroke = [&](const SurfacePoint& where) {
            const Eigen::VectorXd touched = brushed(face, where, radius);
            share = edit.erases ? share.cwiseMin((1.0 - touched.array()).matrix()).eval()
                                : share.cwiseMax(touched).eval();
        };
        const SurfacePoint where = place_on_skin(face, edit.at, edit.place);
        stroke(where);
        if (edit.mirrored) {
            stroke(mirrored_place(face, where));
        }
        simulator_.set_protection(share);
    }
    void operator()(const ShapeEdit& edit) {
        settle();
        const FaceModel& face = simulator_.face();
        Points shape(3, 0);
        if (edit.vertices != 0) {
            if (edit.vertices != face.own_vertices) {
                throw InvalidInput("It is the shape of another scan, with " +
                                   std::to_string(edit.vertices) + " vertices.");
            }
            shape = Points::Zero(3, edit.vertices);
            shape(Eigen::all, edit.moved) = edit.by;
        }
        simulator_.set_skin_rest(shape.cols() > 0 ? shaped_skin(face, shape)
                                                  : face.skin.mesh.vertices);
        settled_ = false;
    }

private:
    void settle() {
        if (!settled_) {
            report_.last = simulator_.settle();
        }
        settled_ = true;
    }

    Simulator& simulator_;
    PlanReport& report_;
    bool settled_ = false, last_ = false;
};

}  // namespace

ShapeEdit shape_edit(const Points& shape) {
    ShapeEdit edit;
    edit.vertices = static_cast<int>(shape.cols());
    for (Eigen::Index v = 0; v < shape.cols(); ++v) {
        if (!shape.col(v).isZero(0.0)) {
            edit.moved.push_back(static_cast<int>(v));
        }
    }
    edit.by = shape(Eigen::all, edit.moved);
    return edit;
}

std::string edit_title(const Edit& edit) {
    struct Titles {
        std::string operator()(const ContractionEdit& e) const { return "muscle " + e.muscle; }
        std::string operator()(const StrengthEdit& e) const { return "strength of " + e.muscle; }
        std::string operator()(const ExpressionEdit& e) const {
            return "expression " + e.expression;
        }
        std::string operator()(const DragEdit&) const { return "drag"; }
        std::string operator()(const VolumeEdit&) const { return "volume"; }
        std::string operator()(const TargetEdit& e) const { return "target " + e.measure; }
        std::string operator()(const ProtectEdit&) const { return "protected skin"; }
        std::string operator()(const ShapeEdit&) const { return "shape"; }
    };
    return std::visit(Titles{}, edit);
}

PlanReport run_plan(Simulator& simulator, const Plan& plan, std::optional<double> seconds) {
    PlanReport report;
    PlanRunner runner(simulator, report);
    for (std::size_t i = 0; i < plan.size(); ++i) {
        runner.run(plan[i], i + 1 == plan.size());
    }
    runner.finish(seconds);
    return report;
}

PlanReport run_what_goes(Simulator& simulator, const Plan& plan, std::vector<RefusedEdit>& refused,
                         std::optional<double> seconds) {
    PlanReport report;
    PlanRunner runner(simulator, report);
    for (std::size_t i = 0; i < plan.size(); ++i) {
        try {
            runner.run(plan[i], i + 1 == plan.size());
        } catch (const InvalidInput& problem) {
            if (simulator.dragging()) {
                simulator.end_drag(false);
            }
            refused.push_back({static_cast<int>(i) + 1, edit_title(plan[i]), problem.what()});
        }
    }
    runner.finish(seconds);
    return report;
}

}  // namespace myoface
