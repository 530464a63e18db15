// SPDX-License-Identifier: Apache-2.0
#include "myoface/drag/drag.h"

#include <algorithm>
#include <cmath>

#include "myoface/physics/forces.h"

#include "in_plane.h"

namespace myoface {
namespace {

constexpr double kLongestJump = 3.0;       // of the kernel in one update [mm]
constexpr double kMostHold = 100'000.0;    // in mouse priority [mN]: no skin is pulled into bone
constexpr double kSecondStageLimit = 1.3;  // strain allowed in stage 2, of the region's limit
constexpr int kMostSearches = 8;
constexpr int kSettleSweeps = 6000;
constexpr int kMostSettleSweeps = 10 * kSettleSweeps;
constexpr double kRefusedAtOnce = 0.25;
constexpr int kMostCorrections = 20;
constexpr double kRoughly = 10.0;  // times what counts as rest at last
constexpr int kBetweenJumps = 3;   // sweeps while a quick hand is followed
constexpr int kMostJumps = 8;
constexpr double kOnRay = 0.002;   // [mm]
constexpr double kNearRay = 0.02;  // [mm]

/// Force on the grabbed point along the view.
double view_force(const Grip& grip, const Points& forces, const Vec3& view) {
    return grip_position(grip, forces).dot(view);
}

}  // namespace

Vec3 depth_correction(const MassSpringModel& model, const Points& positions, int node,
                      const Vec3& view, double gain) {
    Vec3 a = Vec3::Zero();
    double stiffness = 0.0;
    for (int e = model.spring_start[node]; e < model.spring_start[node + 1]; ++e) {
        const SpringEnd& spring = model.spring_ends[e];
        const Vec3 r = positions.col(node) - positions.col(spring.other);
        const double distance = r.norm();
        if (distance > 0.0) {
            a += spring.stiffness * (1.0 - spring.length / distance) * r;  // (4)
        }
        stiffness += spring.stiffness;
    }
    if (!(stiffness > 0.0)) {
        return Vec3::Zero();
    }
    a *= gain / stiffness;
    const Vec3 along_view = a.dot(view) / view.dot(view) * view;  // (5)
    return -along_view;                                           // (6)
}

SkinDrag::SkinDrag(const FaceModel& face, const FaceMassSpring& system, const DragRequest& request,
                   const ViewRay& ray, const Points& start, const Eigen::VectorXd& yielding)
    : face_(face), system_(system), request_(request), start_(start), yielding_(yielding) {
    hands_.push_back(make_hand(request.where, ray));
    if (request.mirrored) {
        add_mirrored_hand();
    }
}

void SkinDrag::move_to(const ViewRay& ray) {
    const auto turn = [](Hand& hand, const ViewRay& next) {
        // A perspective ray turns its plane a little: carry the target over.
        const Vec3 at = view_plane(hand.ray.direction) * hand.target +
                        hand.start.dot(hand.ray.direction) * hand.ray.direction;
        hand.ray = next;
        hand.target = in_plane(next, at);
    };
    const ViewRay wanted = guided(hands_[0], ray);
    turn(hands_[0], wanted);
    if (hands_.size() > 1) {
        turn(hands_[1], mirrored(wanted));
    }
}

Eigen::Vector2d SkinDrag::way_to_goal(const Hand& hand, const Vec3& at) {
    return in_plane(hand.ray, hand.ray.origin) - in_plane(hand.ray, at) - hand.behind;
}

double SkinDrag::furthest_from_goal(const Points& positions) const {
    double worst = 0.0;
    for (const Hand& hand : hands_) {
        worst = std::max(worst, way_to_goal(hand, grip_position(hand.grip, positions)).norm());
    }
    return worst;
}

/// Lets go of as much of the way as the force is too large by. @return whether a goal has moved
bool SkinDrag::yield_to_force(bool may_follow) {
    constexpr double kQuickest = 0.6;
    constexpr double kSlack = 1.02;
    bool moved = false;
    for (Hand& hand : hands_) {
        const double force = hand.force.norm();
        const Eigen::Vector2d whole = way_to_goal(hand, hand.start);
        if (force > kSlack * kMostHold) {
            hand.behind += std::min(kQuickest, 1.0 - kMostHold / force) * whole;
            moved = true;
        } else if (may_follow && force < 0.9 * kMostHold &&
                   hand.behind != Eigen::Vector2d::Zero()) {
            hand.behind *= hand.behind.norm() > 0.01 ? 0.9 : 0.0;
            moved = true;
        }
    }
    return moved;
}

/// As if the hand had just gripped and had the whole way before it.
void SkinDrag::back_to_grip(EquilibriumSolver& solver, MassSpringState& state) {
    state.positions = start_;
    for (Hand& hand : hands_) {
        hand.target = in_plane(hand.ray, kernel_centre(hand));
        hand.behind.setZero();
        hand.force.setZero();
        hand.search = {};
    }
    second_stage_ = false;
    layer_share_ = 0.0;
    state.layer.resize(3, 0);
    solver.restart();
}

double SkinDrag::step_towards_ray(MassSpringState& state) {
    double left = 0.0;
    for (Hand& hand : hands_) {
        const auto plane = view_plane(hand.ray.direction);
        const Vec3 at = grip_position(hand.grip, state.positions);
        Eigen::Vector2d way = way_to_goal(hand, at);
        const double distance = way.norm();
        if (distance > kLongestJump) {
            way *= kLongestJump / distance;
            left = std::max(left, distance - kLongestJump);
        }
        const Vec3 move = plane * way;
        double carried = 0.0;
        for (std::size_t k = 0; k < hand.kernel.nodes.size(); ++k) {
            state.positions.col(hand.kernel.nodes[k]) += hand.kernel.profile[k] * move;
            carried += hand.kernel.weights[k] * hand.kernel.profile[k];
        }
        hand.target += carried * way;
        // (4)-(6) for the grabbed point, its neighbours where the kernel put them; relaxation
        // follows in turn.
        for (const int node : hand.grip.nodes) {
            if (system_.model.fixed[node] == 0) {
                state.positions.col(node) +=
                    depth_correction(system_.model, state.positions, node, hand.ray.direction, 0.5);
            }
        }
    }
    return left;
}

/// The last hairs between the point and its ray. @return how far they were [mm]
double SkinDrag::put_on_ray(MassSpringState& state) {
    double furthest = 0.0;
    for (Hand& hand : hands_) {
        const Eigen::Vector2d way = way_to_goal(hand, grip_position(hand.grip, state.positions));
        furthest = std::max(furthest, way.norm());
        if (way.norm() > kLongestJump) {
            continue;  // more than hairs: another frame's work
        }
        const Vec3 move = view_plane(hand.ray.direction) * way / hand.peak;
        double carried = 0.0;
        for (std::size_t k = 0; k < hand.kernel.nodes.size(); ++k) {
            state.positions.col(hand.kernel.nodes[k]) += hand.kernel.profile[k] * move;
            carried += hand.kernel.weights[k] * hand.kernel.profile[k];
        }
        hand.target += carried / hand.peak * way;
    }
    return furthest;
}

void SkinDrag::take_forces(const EquilibriumSolver& solver) {
    for (std::size_t h = 0; h < hands_.size() && h < solver.hand_forces().size(); ++h) {
        hands_[h].force = solver.hand_forces()[h];
    }
}

/// The handle holds a mean of the kernel's nodes; the point itself must lie on the ray. How far the
/// target must go for the point to go a millimetre is learnt from one correction to the next.
/// @cite broyden_1965
void SkinDrag::correct_targets(const Points& positions) {
    constexpr double kFirst = 0.7;
    constexpr double kMost = 5.0;
    for (Hand& hand : hands_) {
        TargetSearch& search = hand.search;
        const Eigen::Vector2d error = way_to_goal(hand, grip_position(hand.grip, positions));
        if (search.begun) {
            const Eigen::Vector2d went = search.error - error;  // of the point
            const Eigen::Vector2d said = search.gain * went;
            const double along = search.move.dot(said);
            if (std::abs(along) > 0.1 * search.move.squaredNorm()) {
                search.gain +=
                    (search.move - said) * (search.move.transpose() * search.gain) / along;
            }
        }
        if (!search.begun || !(search.gain.norm() < kMost)) {
            search.gain = kFirst * Eigen::Matrix2d::Identity();
        }
        search.begun = true;
        search.error = error;
        search.move = search.gain * error;
        hand.target += search.move;
    }
}

double SkinDrag::strain_share(const Points& positions) const {
    double share = 0.0;
    for (const Hand& hand : hands_) {
        // What is gripped sets the limit; looser tissue nearby keeps its own.
        double limit = 1e9;
        for (const int node : hand.grip.nodes) {
            limit = std::min(limit, system_.strain_limit[node]);
        }
        share = std::max(share, skin_strain(system_.model, positions, hand.near_springs,
                                            system_.strain_limit, std::min(limit, 1e3))
                                    .share_of_limit);
    }
    return share;
}

/// Stage 1's load stays on the skin while stage 2 works on the muscle layer.
Drive SkinDrag::with_first_stage(const Drive& drive) const {
    Drive loaded = drive;
    if (loaded.load.cols() == 0) {
        loaded.load = Points::Zero(3, system_.model.node_count());
    }
    for (const Hand& hand : hands_) {
        for (std::size_t k = 0; k < hand.kernel.nodes.size(); ++k) {
            loaded.load.col(hand.kernel.nodes[k]) +=
                skin_share_ * spread(hand, k) * hand.skin_force;
        }
    }
    return loaded;
}

RelaxReport SkinDrag::pull(EquilibriumSolver& solver, MassSpringState& state, const Drive& drive,
                           int iterations, double still_mm) {
    RelaxOptions options;
    options.iterations = iterations;
    options.still_mm = still_mm;
    const std::vector<HandPull> hands = pulls();
    if (second_stage_) {
        solver.drive_changed();  // it carries the first stage's load
    }
    const RelaxReport report =
        second_stage_ ? solver.relax(state, with_first_stage(drive), options, {}, hands)
                      : solver.relax(state, drive, options, {}, hands);
    take_forces(solver);
    return report;
}

void SkinDrag::enter_second_stage(EquilibriumSolver& solver, MassSpringState& state) {
    for (Hand& hand : hands_) {
        hand.skin_force = hand.force;
    }
    second_stage_ = true;
    state.layer = Points::Zero(3, system_.model.skin_nodes);
    solver.restart();
}

RelaxReport SkinDrag::update(EquilibriumSolver& solver, MassSpringState& state, const Drive& drive,
                             int iterations) {
    if (request_.mode == DragMode::MousePriority) {
        RelaxOptions options;
        options.iterations = kBetweenJumps;
        double left = step_towards_ray(state);
        for (int jump = 1; jump < kMostJumps && left > 0.0; ++jump) {
            solver.relax(state, drive, options, handles());
            take_forces(solver);
            yield_to_force(true);
            left = step_towards_ray(state);
        }
        options.iterations = iterations;
        RelaxReport report = solver.relax(state, drive, options, handles());
        take_forces(solver);
        const bool yields = yield_to_force(true);
        // What is shown has the point under the cursor.
        const double off = report.finite ? put_on_ray(state) : 0.0;
        report.converged = report.converged && off < kOnRay && !yields;
        return report;
    }
    RelaxReport report = pull(solver, state, drive, iterations, RelaxOptions{}.still_mm);
    // Between frames the shares follow the strain instead of being searched for.
    double& share = second_stage_ ? layer_share_ : skin_share_;
    const double most = second_stage_ ? 1.0 - skin_share_ : 1.0;
    const double limit = second_stage_ ? kSecondStageLimit : 1.0;
    const double strain = strain_share(state.positions) / limit;
    const double before = share;
    if (strain > 1.0) {
        share *= std::max(0.6, 1.0 / strain);
    } else if (share < most) {
        share = std::min(most, share * std::min(1.15, 1.0 / std::max(strain, 1e-3)) + 0.002);
    }
    if (std::abs(share - before) > 0.003) {
        report.converged = false;
    } else if (!second_stage_ && skin_share_ < 0.98 && strain > 0.95) {
        enter_second_stage(solver, state);
        report.converged = false;
    } else if (second_stage_ && strain < 0.7 / kSecondStageLimit) {
        second_stage_ = false;  // the hand went back
        layer_share_ = 0.0;
        state.layer.resize(3, 0);
        solver.restart();
        report.converged = false;
    }
    return report;
}

/// The largest share of a force at which the skin keeps its limit, or a hundredth less: strain
/// grows almost evenly with the share, so the search goes to where a line through its ends meets
/// the limit, and halves an end that stays (the Illinois rule). @cite dowell_jarratt_1971
RelaxReport SkinDrag::search_share(EquilibriumSolver& solver, MassSpringState& state,
                                   const Drive& drive, double& share, double most, double limit) {
    constexpr double kBelow = 0.01;       // of the limit
    constexpr double kNarrowest = 0.004;  // of the whole force
    constexpr double kRough = kRoughly * RelaxOptions{}.still_mm;
    int sweeps = 0;
    const auto excess = [&](double at) {
        share = at;
        sweeps += pull(solver, state, drive, kSettleSweeps, kRough).iterations;
        return strain_share(state.positions) / limit - 1.0;
    };
    double low = 0.0;
    double below = strain_share(state.positions) / limit - 1.0;
    double high = most;
    double above = excess(most);
    if (below >= 0.0) {
        share = 0.0;  // at its limit without a hand
    } else if (above > 0.0) {
        int stayed = 0;          // which end did in the last round: -1 the lower, 1 the higher
        double reached = below;  // at the lower end, as it is
        for (int k = 0; k < kMostSearches && reached < -kBelow && high - low > kNarrowest; ++k) {
            const double aim = (below + 0.5 * kBelow) / (below - above);
            const double width = high - low;
            const double at = low + std::clamp(aim, 0.05, 0.95) * width;
            const double found = excess(at);
            if (found > 0.0) {
                high = at;
                above = found;
                below *= stayed < 0 ? 0.5 : 1.0;
                stayed = -1;
            } else {
                low = at;
                below = reached = found;
                above *= stayed > 0 ? 0.5 : 1.0;
                stayed = 1;
            }
        }
        share = low;
    }
    RelaxReport report = pull(solver, state, drive, kSettleSweeps, RelaxOptions{}.still_mm);
    report.iterations += sweeps;
    return report;
}

RelaxReport SkinDrag::settle(EquilibriumSolver& solver, MassSpringState& state, const Drive& drive,
                             double still_mm, bool anew) {
    const bool judging = request_.mode == DragMode::ConstraintPriority;
    if (anew || judging) {
        back_to_grip(solver, state);
    }
    if (judging) {
        RelaxReport report = search_share(solver, state, drive, skin_share_, 1.0, 1.0);
        if (skin_share_ < 0.999) {
            const int sweeps = report.iterations;
            enter_second_stage(solver, state);
            report = search_share(solver, state, drive, layer_share_, 1.0 - skin_share_,
                                  kSecondStageLimit);
            report.iterations += sweeps;
        }
        return report;
    }
    RelaxReport report;
    int sweeps = 0;
    double refused = 0.0;  // of the way
    while (sweeps < kMostSettleSweeps) {
        const double left = step_towards_ray(state);
        RelaxOptions options;
        options.iterations = left > 0.0 ? 20 : kSettleSweeps;
        options.still_mm = kRoughly * still_mm;
        report = solver.relax(state, drive, options, handles());
        sweeps += report.iterations;
        take_forces(solver);
        if (!report.finite) {  // a hand that no tissue can follow: less of its way
            back_to_grip(solver, state);
            refused = std::min(1.0, refused + kRefusedAtOnce);
            for (Hand& hand : hands_) {
                hand.behind = refused * way_to_goal(hand, hand.start);
            }
            ++sweeps;
            continue;
        }
        if (yield_to_force(false)) {
            continue;
        }
        if (left > 0.0) {
            continue;
        }
        // Only the target is put right from here on: the face is close to its place. Rest to the
        // last digit counts once the point is nearly on its ray.
        bool yields = false;
        for (int fine = 0;
             fine < kMostCorrections && !yields && report.finite && sweeps < kMostSettleSweeps;
             ++fine) {
            const double worst = furthest_from_goal(state.positions);
            const bool exact = options.still_mm == still_mm;
            if (worst < kOnRay && report.converged && exact) {
                break;
            }
            if (worst >= kOnRay) {
                correct_targets(state.positions);
            }
            options.still_mm = worst < kNearRay ? still_mm : kRoughly * still_mm;
            report = solver.relax(state, drive, options, handles());
            sweeps += report.iterations;
            take_forces(solver);
            yields = yield_to_force(false);
        }
        if (!yields) {
            put_on_ray(state);
            break;
        }
    }
    report.iterations = sweeps;
    return report;
}

DragReport SkinDrag::report(const MassSpringState& state, const Drive& drive,
                            bool with_forces) const {
    const Hand& hand = hands_.front();
    const Vec3 view = hand.ray.direction;
    DragReport report;
    report.mode = request_.mode;
    const auto nearest = std::max_element(hand.grip.weights.begin(), hand.grip.weights.end());
    report.node = hand.grip.nodes[static_cast<std::size_t>(nearest - hand.grip.weights.begin())];
    report.reached = grip_position(hand.grip, state.positions);
    const Vec3 from_origin = report.reached - hand.ray.origin;
    report.target = hand.ray.origin + from_origin.dot(view) * view;
    report.off_ray_mm = distance_to_ray(hand.ray, report.reached);
    report.force_mN = hand.force.norm();
    report.strain_share = strain_share(state.positions);
    if (request_.mode == DragMode::ConstraintPriority) {
        report.stage_skin_mN =
            skin_share_ * (second_stage_ ? hand.skin_force.norm() : hand.force.norm());
        report.stage_muscle_mN = second_stage_ ? layer_share_ * hand.force.norm() : 0.0;
        report.refused_mN =
            std::max(0.0, report.force_mN - report.stage_skin_mN - report.stage_muscle_mN);
    }
    if (!with_forces) {
        return report;
    }
    // Before: the grabbed point alone on the ray, everything else where the drag began.
    MassSpringState before;
    before.positions = start_;
    before.velocities = Points::Zero(3, start_.cols());
    const Vec3 sideways =
        view_plane(view) * (view_plane(view).transpose() * (hand.ray.origin - hand.start));
    for (const int node : hand.grip.nodes) {
        before.positions.col(node) += sideways;
    }
    const Points f0 = total_forces(system_.model, before, drive, false);
    const Points f1 = total_forces(system_.model, state, drive, false);
    const double at_start = std::max(std::abs(view_force(hand.grip, f0, view)),
                                     0.02 * grip_position(hand.grip, f0).norm());
    report.view_force_residual =
        at_start > 0.0 ? std::abs(view_force(hand.grip, f1, view)) / at_start : 0.0;
    return report;
}

}  // namespace myoface
