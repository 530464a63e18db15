// SPDX-License-Identifier: Apache-2.0
#include "myoface/sim/target.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "myoface/base/error.h"
#include "myoface/mesh/bvh.h"

#include "undo_shaping.h"

namespace myoface {
namespace {

constexpr double kOffMillimetres = 0.02;
constexpr double kOffDegrees = 0.1;
constexpr double kFarthestWish = 25.0;  // way of a landmark [mm]
constexpr double kMostStretch = 2.5;    // of the strain at which a region's capacity is used up
constexpr double kTargetGap = 0.2;      // [mm] between hand and skin: bone holds back
constexpr double kStill = 5e-5;         // [mm] a step at rest: the measure is known to 0.01 mm
constexpr int kMostSettlesEach = 12;    // of one landmark
constexpr double kLeastRise = 0.02;     // of the rise at the start: less is none
constexpr double kWayThatTells = 0.05;  // [mm]
constexpr double kStride = 3.0;         // [mm] of the hand in one round
constexpr double kArrived = 0.02;       // [mm]
constexpr int kSweepsOfRound = 12;
constexpr int kMostRounds = 40;
constexpr int kMostTrials = 4;       // on the way back from a limit
constexpr double kNearLimit = 0.95;  // of it: near enough

std::string with_unit(double value, bool degrees) {
    char text[40];
    std::snprintf(text, sizeof text, degrees ? "%.1f°" : "%.2f mm", value);
    return text;
}

/// What of a measure's landmarks a surgeon would move, first those that move most easily.
std::vector<std::string> movable(const Measure& measure) {
    std::vector<std::string> result;
    for (const char* name :
         {"prn", "c",   "al", "ac", "sbal", "pg", "gn", "ls", "cph", "ch", "li",
          "sl",  "sto", "sn", "se", "go",   "zy", "g",  "ft", "ex",  "en", "n"}) {
        if (std::find(measure.points.begin(), measure.points.end(), name) != measure.points.end()) {
            result.emplace_back(name);
        }
    }
    if (result.empty()) {
        throw InvalidInput("Target: nothing of " + measure.title + " can be moved.");
    }
    return result;
}

/// How a measure changes with its movable landmark; both sides move alike, mirrored.
Vec3 slope(const Landmarks& here, const Mat3& axes, const Measure& measure,
           const std::string& landmark, bool paired) {
    constexpr double kProbeStep = 0.05;  // [mm]
    Vec3 result = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        if (!paired && axis == 0) {
            continue;  // a landmark of the midline stays there
        }
        double value[2];
        for (const int side : {0, 1}) {
            Landmarks moved = here;
            const double way = side == 0 ? -kProbeStep : kProbeStep;
            moved.at(landmark + (paired ? "_l" : "")).position += way * axes.col(axis);
            if (paired) {
                moved.at(landmark + "_r").position += (axis == 0 ? -way : way) * axes.col(axis);
            }
            value[side] = measured(measure, moved).value_or(0.0);
        }
        result += (value[1] - value[0]) / (2.0 * kProbeStep) * axes.col(axis);
    }
    return result;
}

/// Why a landmark goes no further (a name that scripts/translations.py looks for).
std::string refuse(std::string why) {
    return why;
}

/// One landmark on its way: the hand that moves it and the measure it moves.
class Approach {
public:
    Approach(Simulator& simulator, const LandmarksOnSkin& places, const TargetRequest& request,
             const std::string& landmark)
        : simulator_(simulator), places_(places), request_(request), landmark_(landmark) {
        const FaceModel& face = simulator.face();
        const Landmarks here = places.at(simulator.state().positions);
        const bool paired = here.count(landmark) == 0;
        const Vec3 steep = request.measure.kind == MeasureKind::Projection
                               ? Vec3(face.axes.col(2))
                               : slope(here, face.axes, request.measure, landmark, paired);
        steepness_ = steep.norm();
        if (!changes()) {
            return;
        }
        way_ = steep / steepness_;
        // Seen from where the whole way lies in the picture.
        const Vec3 beside = paired ? Vec3(-face.axes.col(2)) : Vec3(-face.axes.col(0));
        const Vec3 view = beside - beside.dot(way_) * way_;
        view_ = view.norm() > 0.1 ? view.normalized() : Vec3(-face.axes.col(0));
        const TriangleMesh now{simulator.state().positions.leftCols(face.node_count()),
                               face.skin.mesh.triangles};
        drag_.where =
            Bvh(now).closest_point(now, here.at(landmark + (paired ? "_l" : "")).position).where;
        drag_.radius = request.radius;
        drag_.mirrored = paired;
        start_ = position(now, drag_.where);
    }

    bool changes() const { return steepness_ > 1e-3; }

    /// Goes until the measure is met or a limit is. The shape stays; no skin is folded by it.
    void go(double wanted, double tolerance, TargetReport& report) {
        simulator_.begin_drag(drag_, ray_at(0.0));
        limit_.clear();
        double holds = 0.0;  // a way that keeps within the limits, what it reaches and uses up
        double reached = report.reached;
        double share = 0.0;
        double rise = steepness_;
        double next = follow(wanted, reached, report);
        for (int k = 0; k < kMostSettlesEach; ++k) {
            if (!(std::abs(next) < kFarthestWish)) {
                limit_ = refuse(landmark_ + " would have to go more than 25 mm.");
                reached = value_at(holds, report);  // back from where the hand looked for it
                break;
            }
            const double there = value_at(next, report);
            limit_ = limit_met();
            if (!limit_.empty()) {
                reached = back_to_what_holds(holds, share, next, reached, report);
                break;
            }
            const double way = next - holds;
            const double steeper = (there - reached) / way;
            holds = next;
            reached = there;
            share = limit_share();
            if (std::abs(reached - wanted) <= tolerance) {
                break;
            }
            // Between places close together the rise is rounding.
            if (std::abs(way) > kWayThatTells) {
                if (!(std::abs(steeper) > kLeastRise * steepness_)) {
                    limit_ = refuse("moving " + landmark_ + " further changes nothing.");
                    break;
                }
                rise = steeper;
            }
            next = holds + (wanted - reached) / rise;
        }
        if (limit_.empty() && std::abs(reached - wanted) > tolerance) {
            limit_ = refuse("it is not met after 12 tries.");
        }
        report.moved_mm = std::max(report.moved_mm, std::abs(at_));
        if (simulator_.end_drag(true).kept_share < 1.0) {
            limit_ = refuse("the skin would fold over itself.");
        }
        report.reached =
            places_.measure(request_.measure, simulator_.state().positions).value_or(reached);
    }

    /// Why it went no further; nothing where the measure was met.
    const std::string& limit() const { return limit_; }

private:
    ViewRay ray_at(double distance) const {
        return {start_ + distance * way_ - 300.0 * view_, view_};
    }

    double measured_now(const TargetReport& report) const {
        return places_.measure(request_.measure, simulator_.state().positions)
            .value_or(report.before);
    }

    /// The hand goes on while tissue still settles: a quick way to near the goal. How far the
    /// measure has come on the way so far tells where the hand is to be. @return that way [mm]
    double follow(double wanted, double start, const TargetReport& report) {
        double at = 0.0;
        double next = std::clamp((wanted - start) / steepness_, -kStride, kStride);
        for (int k = 0; k < kMostRounds && std::abs(next) < kFarthestWish; ++k) {
            const double went = next - at;
            at = next;
            simulator_.move_drag(ray_at(at));
            step_ = simulator_.step(kSweepsOfRound);
            if (!limit_met().empty()) {
                return at;
            }
            const double rise = (measured_now(report) - start) / at;
            if (!(rise / steepness_ > kLeastRise)) {
                continue;  // the measure has not noticed yet
            }
            next = at + std::clamp((wanted - start) / rise - at, -kStride, kStride);
            if (std::abs(went) < kArrived && std::abs(next - at) < kArrived) {
                break;
            }
        }
        return next;
    }

    double value_at(double distance, TargetReport& report) {
        simulator_.move_drag(ray_at(distance));
        step_ = simulator_.settle(kStill, false);
        ++report.settles;
        report.force_mN = step_.drag->force_mN;
        at_ = distance;
        return measured_now(report);
    }

    /// How far what a limit is set to is used up: 1 at the limit.
    double gap_share() const { return step_.drag->off_ray_mm / kTargetGap; }
    double stretch_share() const { return step_.drag->strain_share / kMostStretch; }
    double limit_share() const { return std::max(gap_share(), stretch_share()); }

    std::string limit_met() const {
        if (gap_share() > 1.0) {
            return refuse("the bone holds back.");
        }
        return stretch_share() > 1.0 ? refuse("the skin there is stretched to its limit.")
                                     : std::string();
    }

    /// Between a place that holds and one beyond a limit: the furthest that holds, nearly. What
    /// the limit is set to grows almost evenly.
    /// @param share what is used up where it holds @return what is reached there
    double back_to_what_holds(double holds, double share, double beyond, double reached,
                              TargetReport& report) {
        double above = limit_share();
        for (int k = 0; k < kMostTrials && share < kNearLimit; ++k) {
            const double aim = (0.5 * (1.0 + kNearLimit) - share) / (above - share);
            const double trial = holds + std::clamp(aim, 0.1, 0.9) * (beyond - holds);
            const double there = value_at(trial, report);
            if (limit_share() <= 1.0) {
                holds = trial;
                share = limit_share();
                reached = there;
            } else {
                beyond = trial;
                above = limit_share();
            }
        }
        return at_ == holds ? reached : value_at(holds, report);
    }

    Simulator& simulator_;
    const LandmarksOnSkin& places_;
    const TargetRequest& request_;
    std::string landmark_, limit_;
    DragRequest drag_;
    Vec3 start_ = Vec3::Zero(), way_ = Vec3::UnitX(), view_ = -Vec3::UnitZ();
    double steepness_ = 0.0, at_ = 0.0;
    StepReport step_;
};

}  // namespace

Measure target_measure(const std::string& name) {
    const auto plain = [](std::string text) {
        std::transform(text.begin(), text.end(), text.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return text;
    };
    std::string known;
    for (const Measure& measure : all_measures()) {
        if (plain(measure.id) == plain(name) || plain(measure.title) == plain(name)) {
            return measure;
        }
        known += (known.empty() ? "" : ", ") + plain(measure.title);
    }
    throw InvalidInput("'" + name + "' is not a measure; known are " + known + ".");
}

TargetReport meet_target(Simulator& simulator, const TargetRequest& request) {
    const Measure& measure = request.measure;
    const bool degrees = measure.in_degrees();
    UndoShaping undo(simulator);
    simulator.settle();
    const LandmarksOnSkin places(simulator.shared_face());
    const std::optional<double> before = places.measure(measure, simulator.state().positions);
    if (!before) {
        throw InvalidInput("Target: landmarks of " + measure.title + " are missing on this face.");
    }
    TargetReport report;
    report.before = report.reached = *before;
    report.wanted = request.relative ? *before + request.value : request.value;
    const double tolerance = degrees ? kOffDegrees : kOffMillimetres;
    const auto met = [&] { return std::abs(report.reached - report.wanted) <= tolerance; };
    std::string why;
    // What the first landmark cannot do within its limits is left to the next one.
    for (const std::string& landmark : movable(measure)) {
        if (met()) {
            break;
        }
        Approach approach(simulator, places, request, landmark);
        if (!approach.changes()) {
            continue;
        }
        approach.go(report.wanted, tolerance, report);
        report.landmarks.push_back(landmark);
        why += approach.limit().empty() ? "" : (why.empty() ? "" : " ") + approach.limit();
    }
    if (!met()) {
        throw InvalidInput("Target: " + measure.title + " stays at " +
                           with_unit(report.reached, degrees) + " of " +
                           with_unit(report.wanted, degrees) + ": " +
                           (why.empty() ? refuse("none of its landmarks changes it.") : why));
    }
    undo.release();
    return report;
}

}  // namespace myoface
