// SPDX-License-Identifier: Apache-2.0
// Plans from one face to another.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"
#include "myoface/mesh/bvh.h"
#include "myoface/sim/plan_file.h"

#include "edit_text.h"

namespace myoface {
namespace {

constexpr double kBesideSkin = 6.0;   // of a place carried over, from the skin [mm]
constexpr double kNearLandmark = 25;  // farther away, a landmark says nothing [mm]

/// FNV-1a over words instead of bytes.
class Sum {
public:
    template <typename Matrix>
    void add(const Matrix& matrix) {
        using Word =
            std::conditional_t<sizeof(typename Matrix::Scalar) == 8, std::uint64_t, std::uint32_t>;
        for (Eigen::Index k = 0; k < matrix.size(); ++k) {
            Word word = 0;
            std::memcpy(&word, matrix.data() + k, sizeof word);
            value_ = (value_ ^ word) * 1099511628211ULL;
        }
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037ULL;
};

Vec3 blend(const Points& of_nodes, const TriangleMesh& mesh, const SurfacePoint& where) {
    Vec3 result = Vec3::Zero();
    for (int c = 0; c < 3; ++c) {
        result += where.weights[c] * of_nodes.col(mesh.triangles(c, where.triangle));
    }
    return result;
}

/// Finds places of a plan on a face.
class Carrier {
public:
    Carrier(const FaceModel& face, const PlanOrigin& origin, CarriedPlan::Face relation)
        : face_(face), turn_(face.axes * origin.axes.transpose()), relation_(relation) {
        if (relation == CarriedPlan::Face::Other) {
            on_head_ = {face.generic, face.skin.mesh.triangles};
            bvh_ = Bvh(on_head_);
        } else if (relation == CarriedPlan::Face::SameScan) {
            bvh_ = Bvh(face.skin.mesh);
        }
    }

    /// @param doubt set to the distance between fit and landmark, where both speak [mm]
    void carry(PlanPlace& place, double& doubt) const {
        if (relation_ == CarriedPlan::Face::Same) {
            return;
        }
        const bool same_scan = relation_ == CarriedPlan::Face::SameScan;
        const TriangleMesh& mesh = same_scan ? face_.skin.mesh : on_head_;
        const ClosestPoint hit = bvh_.closest_point(mesh, same_scan ? place.xyz : place.head);
        if (!(hit.distance <= kBesideSkin)) {
            throw InvalidInput("Its place lies " +
                               std::to_string(std::lround(std::min(hit.distance, 1e6))) +
                               " mm beside the skin of this face.");
        }
        const Vec3 here = position(face_.skin.mesh, hit.where);
        const auto near = face_.landmarks.find(place.near);
        if (!same_scan && near != face_.landmarks.end() && place.off.norm() < kNearLandmark) {
            doubt = (near->second.position + face_.axes * place.off - here).norm();
        }
        place.where = hit.where;
        place.xyz = here;
    }

    /// A view turns with the head.
    void turn(DragEdit& drag) const {
        if (relation_ != CarriedPlan::Face::Other) {
            return;
        }
        const ViewAxes old = view_axes(drag.view);
        const Vec3 way = turn_ * (drag.move.x() * old.right + drag.move.y() * old.up);
        const Vec3 forward = turn_ * old.forward;
        drag.view.clear();
        for (int k = 0; k < 3; ++k) {
            drag.view += k > 0 ? "," : "";
            append_number(drag.view, forward[k]);
        }
        const ViewAxes now = view_axes(drag.view);
        drag.move = {way.dot(now.right), way.dot(now.up)};
    }

private:
    const FaceModel& face_;
    Mat3 turn_;
    CarriedPlan::Face relation_;
    TriangleMesh on_head_;
    Bvh bvh_;
};

std::optional<PlanPlace>* place_of(Edit& edit) {
    if (auto* drag = std::get_if<DragEdit>(&edit)) {
        return &drag->place;
    }
    if (auto* volume = std::get_if<VolumeEdit>(&edit)) {
        return &volume->place;
    }
    auto* protect = std::get_if<ProtectEdit>(&edit);
    return protect != nullptr ? &protect->place : nullptr;
}

const char* face_name(CarriedPlan::Face face) {
    switch (face) {
        case CarriedPlan::Face::Same:
            return "same";
        case CarriedPlan::Face::SameScan:
            return "same scan, fitted otherwise";
        case CarriedPlan::Face::Other:
            return "other";
        case CarriedPlan::Face::Unknown:
            break;
    }
    return "unknown";
}

}  // namespace

PlanOrigin plan_origin(const FaceModel& face) {
    PlanOrigin origin;
    Sum scan;
    scan.add(Points(face.scan->mesh.vertices.leftCols(face.own_vertices)));
    origin.scan = scan.value();
    Sum skin;
    skin.add(face.skin.mesh.vertices);
    skin.add(face.skin.mesh.triangles);
    skin.add(face.generic);
    origin.skin = skin.value();
    origin.axes = face.axes;
    for (const auto& [name, landmark] : face.landmarks) {
        origin.landmarks[name] = landmark.position;
    }
    return origin;
}

PlanPlace plan_place(const FaceModel& face, const SurfacePoint& where) {
    PlanPlace place;
    place.where = where;
    place.xyz = position(face.skin.mesh, where);
    place.head = blend(face.generic, face.skin.mesh, where);
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [name, landmark] : face.landmarks) {
        const Vec3 off = place.xyz - landmark.position;
        if (off.norm() < nearest) {
            nearest = off.norm();
            place.near = name;
            place.off = face.axes.transpose() * off;
        }
    }
    return place;
}

CarriedPlan carried(const RecordedPlan& plan, const FaceModel& face) {
    CarriedPlan result;
    PlanOrigin origin;
    if (plan.origin) {
        origin = *plan.origin;
        const PlanOrigin here = plan_origin(face);
        result.face = here.scan != origin.scan   ? CarriedPlan::Face::Other
                      : here.skin == origin.skin ? CarriedPlan::Face::Same
                                                 : CarriedPlan::Face::SameScan;
    }
    const Carrier carrier(face, origin, result.face);
    for (std::size_t i = 0; i < plan.edits.size(); ++i) {
        Edit edit = plan.edits[i];
        const int number = static_cast<int>(i) + 1;
        const std::string title = edit_title(edit);
        try {
            double doubt = 0.0;
            std::optional<PlanPlace>* place = place_of(edit);
            if (place != nullptr && place->has_value()) {
                if (!plan.origin) {
                    throw InvalidInput(
                        "It has a place, but the plan does not say on which face it was made "
                        "(\"made_on\").");
                }
                carrier.carry(**place, doubt);
            }
            // One without a place was written by hand, as seen on this face.
            if (auto* drag = std::get_if<DragEdit>(&edit); drag != nullptr && drag->place) {
                carrier.turn(*drag);
            }
            const auto* shape = std::get_if<ShapeEdit>(&edit);
            if (shape != nullptr && shape->vertices != 0 &&
                result.face == CarriedPlan::Face::Other) {
                throw InvalidInput(
                    "It is a shape without gestures, taken from a variant, which only goes onto "
                    "the scan it was made on.");
            }
            if (doubt > result.largest_doubt_mm) {
                result.largest_doubt_mm = doubt;
                result.most_doubtful = number;
            }
            result.edits.push_back(std::move(edit));
            result.number.push_back(number);
        } catch (const InvalidInput& problem) {
            result.refused.push_back({number, title, problem.what()});
        }
    }
    return result;
}

Plan plan_on(const FaceModel& face, const RecordedPlan& plan) {
    CarriedPlan here = carried(plan, face);
    if (!here.refused.empty()) {
        const RefusedEdit& first = here.refused.front();
        throw InvalidInput("Plan, edit " + std::to_string(first.edit) + " (" + first.what +
                           "): " + first.why);
    }
    return std::move(here.edits);
}

Replay replay(Simulator& simulator, const RecordedPlan& plan, std::optional<double> seconds) {
    const CarriedPlan here = carried(plan, simulator.face());
    Replay result;
    result.face = here.face;
    result.edits = static_cast<int>(plan.edits.size());
    result.refused = here.refused;
    result.largest_doubt_mm = here.largest_doubt_mm;
    result.most_doubtful = here.most_doubtful;
    std::vector<RefusedEdit> refused;
    result.report = run_what_goes(simulator, here.edits, refused, seconds);
    result.made = here.edits;
    for (auto edit = refused.rbegin(); edit != refused.rend(); ++edit) {
        result.made.erase(result.made.begin() + edit->edit - 1);
    }
    for (RefusedEdit& edit : refused) {
        edit.edit = here.number[static_cast<std::size_t>(edit.edit - 1)];
        result.refused.push_back(std::move(edit));
    }
    std::stable_sort(result.refused.begin(), result.refused.end(),
                     [](const RefusedEdit& a, const RefusedEdit& b) { return a.edit < b.edit; });
    result.done = result.edits - static_cast<int>(result.refused.size());
    return result;
}

std::string replay_to_json(const Replay& replay) {
    nlohmann::ordered_json json;
    json["face"] = face_name(replay.face);
    json["edits"] = replay.edits;
    json["done"] = replay.done;
    json["refused"] = nlohmann::ordered_json::array();
    for (const RefusedEdit& edit : replay.refused) {
        json["refused"].push_back({{"edit", edit.edit}, {"what", edit.what}, {"why", edit.why}});
    }
    json["largest_doubt_mm"] = replay.largest_doubt_mm;
    if (replay.most_doubtful > 0) {
        json["most_doubtful_edit"] = replay.most_doubtful;
    }
    return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string replay_in_words(const Replay& replay) {
    std::string text = std::to_string(replay.done) + " of " + std::to_string(replay.edits) +
                       " edits of the plan were made";
    text += replay.face == CarriedPlan::Face::Other
                ? ", carried over from another scan through the fit."
                : ".";
    for (const RefusedEdit& edit : replay.refused) {
        text += "\nEdit " + std::to_string(edit.edit) + " (" + edit.what +
                ") was left out: " + edit.why;
    }
    if (replay.largest_doubt_mm > kDoubtfulPlace) {
        text += "\nLook at edit " + std::to_string(replay.most_doubtful) +
                ": fit and landmarks put its place " +
                std::to_string(std::lround(replay.largest_doubt_mm)) + " mm apart.";
    }
    return text;
}

}  // namespace myoface
