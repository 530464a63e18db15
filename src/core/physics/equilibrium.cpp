// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "myoface/base/parallel.h"
#include "myoface/physics/euler.h"
#include "myoface/physics/forces.h"

#include "node_force.h"

namespace myoface {
namespace {

constexpr int kGrain = 384;
constexpr int kMassesEvery = 40;  // iterations
constexpr int kColdIterations = 20;
constexpr int kLookEvery = 5;         // iterations between looks at convergence
constexpr double kMassSafety = 1.15;  // over Gershgorin's bound for a unit step
constexpr double kRunaway = 200.0;    // no tissue moves that far [mm]
// With levels:
constexpr int kSmoothingSteps = 6;
constexpr int kMostSteps = 30;             // of a round; when that does not do, steps alone go on
constexpr int kCoarseSteps = 40;           // on the coarsest
constexpr int kCycles = 1;                 // on those between
constexpr double kSmoothingDamping = 1.0;  // critical for a tenth of the stiffest
constexpr double kFarthest = 3.0;   // [mm] at once: further on the finer level is another one
constexpr double kFarStill = 25.0;  // of a step at rest: a correction that says as much

/// What a chunk of nodes adds to the sums of one iteration, in fixed order.
struct ChunkSums {
    double residual = 0.0;
    double curvature = 0.0;  // −v·ΔF
    double kinetic = 0.0;    // v·M v
};

struct NodeUpdate {
    Vec3 velocity, position;
};

/// Velocity and position after one unit step under force f.
NodeUpdate stepped(const Vec3& x, const Vec3& v, const Vec3& f, double mass, double damping) {
    const Vec3 velocity = ((2.0 - damping) * v + (2.0 / mass) * f) / (2.0 + damping);
    return {velocity, x + velocity};
}

}  // namespace

EquilibriumSolver::EquilibriumSolver(const MassSpringModel& model, const CoarseLevel* coarser)
    : model_(model), coarser_(coarser) {
    begin_rounds();
    if (coarser_ != nullptr) {
        coarse_solver_ =
            std::make_unique<EquilibriumSolver>(coarser_->model(), coarser_->coarser());
    }
}

void EquilibriumSolver::drive_changed() {
    since_masses_ = kMassesEvery;
    begin_rounds();
    coarse_drive_.reset();
    if (coarse_solver_) {
        coarse_solver_->drive_changed();
    }
}

void EquilibriumSolver::restart() {
    warm_ = false;
    begin_rounds();
}

void EquilibriumSolver::begin_rounds() {
    steps_ = kSmoothingSteps;
    steps_done_ = 0;
    last_far_ = 0.0;
}

void EquilibriumSolver::scale_masses(const MassSpringState& state, const Drive& drive,
                                     std::span<const HandPull> pulls) {
    // A unit step is stable while ω² = Σ|K|/M stays below 4.
    mass_ = kMassSafety / 4.0 * stiffness_row_sums(model_, state.positions, drive);
    for (const HandPull& pull : pulls) {
        for (std::size_t k = 0; k < pull.nodes.size(); ++k) {
            mass_[pull.nodes[k]] += kMassSafety / 4.0 * pull.stiffness * pull.weights[k];
        }
    }
    mass_ = mass_.cwiseMax(1e-9);
    if (state.layer.cols() > 0) {
        layer_mass_.resize(model_.skin_nodes);
        const LinearStiffness& links = model_.layer.links;
        for (int i = 0; i < model_.skin_nodes; ++i) {
            const double boost = drive.tether_boost.size() > 0 ? drive.tether_boost[i] : 1.0;
            double sum = model_.ties[i].tether * (1.0 + 2.0 * boost);
            for (int e = links.start[i]; e < links.start[i + 1]; ++e) {
                sum += std::abs(links.value[e]);
            }
            layer_mass_[i] = std::max(kMassSafety / 4.0 * sum, 1e-9);
            mass_[i] += kMassSafety / 4.0 * model_.ties[i].tether * boost;
        }
    }
}

Eigen::Vector2d EquilibriumSolver::pull_force(const Points& x, const HandPull& pull) const {
    if (pull.force) {
        return *pull.force;
    }
    Vec3 grip = Vec3::Zero();
    for (std::size_t k = 0; k < pull.grip_nodes.size(); ++k) {
        grip += pull.grip_weights[k] * x.col(pull.grip_nodes[k]);
    }
    const Eigen::Vector2d gap = pull.target - pull.plane.transpose() * grip;
    const double distance = gap.norm();
    if (!(distance > 0.0)) {
        return Eigen::Vector2d::Zero();
    }
    const double size = pull.largest * std::tanh(pull.stiffness * distance / pull.largest);
    return size / distance * gap;
}

void EquilibriumSolver::advance(const MassSpringState& state, const Drive& drive,
                                std::span<const HandPull> pulls, bool layer) {
    const int n = model_.node_count();
    const int chunks = (n + kGrain - 1) / kGrain;
    const Points& x = state.positions;
    std::vector<ChunkSums> sums(static_cast<std::size_t>(2 * chunks));
    parallel_for(n, kGrain, [&](int begin, int end) {
        ChunkSums sum;
        for (int i = begin; i < end; ++i) {
            if (model_.fixed[i] != 0) {
                next_.col(i) = x.col(i);
                continue;
            }
            const Vec3 f = node_force(model_, x, state.layer, drive, i);
            const Vec3 v = velocity_.col(i);
            sum.residual += f.squaredNorm();
            sum.curvature += v.dot(last_force_.col(i) - f);
            sum.kinetic += mass_[i] * v.squaredNorm();
            const NodeUpdate update = stepped(x.col(i), v, f, mass_[i], damping_);
            force_.col(i) = f;
            velocity_.col(i) = update.velocity;
            next_.col(i) = update.position;
        }
        sums[begin / kGrain] = sum;
    });
    if (layer) {
        parallel_for(model_.skin_nodes, kGrain, [&](int begin, int end) {
            ChunkSums sum;
            for (int i = begin; i < end; ++i) {
                if (model_.fixed[i] != 0) {
                    continue;
                }
                const Vec3 f = layer_node_force(model_, x, state.layer, drive, i);
                const Vec3 v = layer_velocity_.col(i);
                sum.residual += f.squaredNorm();
                sum.curvature += v.dot(layer_last_force_.col(i) - f);
                sum.kinetic += layer_mass_[i] * v.squaredNorm();
                const NodeUpdate update =
                    stepped(state.layer.col(i), v, f, layer_mass_[i], damping_);
                layer_force_.col(i) = f;
                layer_velocity_.col(i) = update.velocity;
                layer_next_.col(i) = update.position;
            }
            sums[chunks + begin / kGrain] = sum;
        });
    }
    ChunkSums total;
    for (const ChunkSums& sum : sums) {
        total.residual += sum.residual;
        total.curvature += sum.curvature;
        total.kinetic += sum.kinetic;
    }
    residual_ = total.residual;
    for (const HandPull& pull : pulls) {
        apply_pull(x, pull, layer);
    }
    // The damping that is critical for the slowest motion seen in the last step.
    if (smoothing_) {
        damping_ = kSmoothingDamping;
    } else if (total.kinetic > 0.0) {
        const double slowest = std::clamp(total.curvature / total.kinetic, 0.0, 0.9);
        damping_ = std::clamp(2.0 * std::sqrt(slowest), 0.004, 1.9);
    }
    last_force_.swap(force_);
    layer_last_force_.swap(layer_force_);
}

void EquilibriumSolver::apply_pull(const Points& x, const HandPull& pull, bool layer) {
    const Vec3 f = pull.plane * pull_force(x, pull);
    hand_forces_.push_back(f);
    const auto push = [&](const std::vector<int>& nodes, const std::vector<double>& weights,
                          double share, const Points& inner, Points& velocity, Points& next,
                          const Eigen::VectorXd& mass) {
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const int i = nodes[k];
            if (model_.fixed[i] != 0) {
                continue;
            }
            const Vec3 part = share * weights[k] * f;
            residual_ += (inner.col(i) + part).squaredNorm() - inner.col(i).squaredNorm();
            const Vec3 kick = 2.0 / (mass[i] * (2.0 + damping_)) * part;
            velocity.col(i) += kick;
            next.col(i) += kick;
        }
    };
    push(pull.nodes, pull.weights, pull.skin_share, force_, velocity_, next_, mass_);
    if (layer && pull.layer_share > 0.0) {
        push(pull.layer_nodes, pull.layer_weights, pull.layer_share, layer_force_, layer_velocity_,
             layer_next_, layer_mass_);
    }
}

void EquilibriumSolver::hold(const Handle& handle) {
    double compliance = 0.0;  // Σ w²/M
    Vec3 centre = Vec3::Zero();
    for (std::size_t k = 0; k < handle.nodes.size(); ++k) {
        const int i = handle.nodes[k];
        centre += handle.weights[k] * next_.col(i);
        if (model_.fixed[i] == 0) {
            compliance += handle.weights[k] * handle.weights[k] / mass_[i];
        }
    }
    if (!(compliance > 0.0)) {
        return;
    }
    const Vec3 error = handle.plane * (handle.target - handle.plane.transpose() * centre);
    for (std::size_t k = 0; k < handle.nodes.size(); ++k) {
        const int i = handle.nodes[k];
        if (model_.fixed[i] == 0) {
            const Vec3 move = handle.weights[k] / (mass_[i] * compliance) * error;
            next_.col(i) += move;
            velocity_.col(i) += move;
        }
    }
    const Vec3 reaction = 0.5 * (2.0 + damping_) / compliance * error;
    hand_forces_.push_back(reaction);
    // The held nodes are not out of balance by what the hand holds.
    for (std::size_t k = 0; k < handle.nodes.size(); ++k) {
        const int i = handle.nodes[k];
        if (model_.fixed[i] == 0) {
            const Vec3 f = last_force_.col(i);
            residual_ += (f + handle.weights[k] * reaction).squaredNorm() - f.squaredNorm();
        }
    }
}

RelaxReport EquilibriumSolver::relax(MassSpringState& state, const Drive& drive,
                                     const RelaxOptions& options, std::span<const Handle> handles,
                                     std::span<const HandPull> pulls) {
    const bool levels = coarser_ != nullptr && state.layer.cols() == 0;
    return levels ? relax_levels(state, drive, options, handles, pulls)
                  : relax_here(state, drive, options, handles, pulls);
}

RelaxReport EquilibriumSolver::relax_levels(MassSpringState& state, const Drive& drive,
                                            const RelaxOptions& options,
                                            std::span<const Handle> handles,
                                            std::span<const HandPull> pulls) {
    const Points good = state.positions;
    std::vector<Eigen::Vector2d> targets;
    for (const Handle& handle : handles) {
        targets.push_back(handle.target);
    }
    if (targets != targets_) {  // the hand went on: far-reaching motion again
        begin_rounds();
        targets_ = std::move(targets);
    }
    RelaxReport report;
    while (report.iterations < options.iterations) {
        // A round of steps may go on over several calls; the last one has no end.
        if (steps_ > kMostSteps) {
            RelaxOptions rest = options;
            rest.iterations = options.iterations - report.iterations;
            const int before = report.iterations;
            report = relax_here(state, drive, rest, handles, pulls);
            report.iterations += before;
            break;
        }
        if (steps_done_ == 0) {
            warm_ = false;
        }
        smoothing_ = steps_ == kSmoothingSteps;
        RelaxOptions few;
        few.iterations = std::min(steps_ - steps_done_, options.iterations - report.iterations);
        few.still_mm = smoothing_ ? 0.0 : options.still_mm;
        const RelaxReport round = relax_here(state, drive, few, handles, pulls);
        smoothing_ = false;
        report.iterations += round.iterations;
        report.last_step = round.last_step;
        report.residual = round.residual;
        if (!round.finite) {
            report.finite = false;
            state.positions = good;
            break;
        }
        steps_done_ += round.iterations;
        if (steps_done_ < steps_ && !round.converged) {
            continue;  // the budget ends here
        }
        steps_done_ = 0;
        const double far = correct_far(state, drive, handles, pulls);
        if (far < kFarStill * options.still_mm &&
            (round.converged || round.last_step < options.still_mm)) {
            report.converged = true;
            break;
        }
        // What neither the coarser level nor a few steps find is left to more of them.
        if (last_far_ > 0.0 && far > 0.5 * last_far_) {
            steps_ *= 2;
        } else if (far < 0.25 * last_far_) {
            steps_ = std::max(steps_ / 2, kSmoothingSteps);
        }
        last_far_ = far;
    }
    if (report.converged && steps_ <= kMostSteps) {
        // The sums of the last step stand before the correction.
        std::vector<Vec3> held;
        const Points left = free_forces(state, drive, handles, pulls, &held);
        if (!held.empty()) {
            hand_forces_ = std::move(held);
        }
        report.residual = std::sqrt(left.squaredNorm() / std::max(model_.node_count(), 1));
    }
    return report;
}

/// What is not in balance, hands included, without what handles take.
Points EquilibriumSolver::free_forces(const MassSpringState& state, const Drive& drive,
                                      std::span<const Handle> handles,
                                      std::span<const HandPull> pulls,
                                      std::vector<Vec3>* held) const {
    Points forces = total_forces(model_, state, drive, false);
    for (const HandPull& pull : pulls) {
        const Vec3 f = pull.plane * pull_force(state.positions, pull);
        for (std::size_t k = 0; k < pull.nodes.size(); ++k) {
            forces.col(pull.nodes[k]) += pull.skin_share * pull.weights[k] * f;
        }
    }
    for (const Handle& handle : handles) {
        Vec3 sum = Vec3::Zero();
        double square = 0.0;
        for (std::size_t k = 0; k < handle.nodes.size(); ++k) {
            if (model_.fixed[handle.nodes[k]] == 0) {
                sum += handle.weights[k] * forces.col(handle.nodes[k]);
                square += handle.weights[k] * handle.weights[k];
            }
        }
        if (square > 0.0) {
            const Vec3 taken = handle.plane * (handle.plane.transpose() * sum) / square;
            for (std::size_t k = 0; k < handle.nodes.size(); ++k) {
                forces.col(handle.nodes[k]) -= handle.weights[k] * taken;
            }
            if (held != nullptr) {
                held->push_back(-taken);
            }
        }
    }
    for (int i = 0; i < model_.node_count(); ++i) {
        if (model_.fixed[i] != 0) {
            forces.col(i).setZero();
        }
    }
    return forces;
}

/// One correction by the coarser level. @return the largest motion [mm]
double EquilibriumSolver::correct_far(MassSpringState& state, const Drive& drive,
                                      std::span<const Handle> handles,
                                      std::span<const HandPull> pulls) {
    if (!coarse_drive_) {
        coarse_drive_ = coarser_->restricted(drive);
    }
    MassSpringState coarse;
    coarse.positions = coarser_->restricted_positions(state.positions);
    const Points forces = free_forces(state, drive, handles, pulls);
    Drive with_load = *coarse_drive_;
    with_load.load = coarser_->restricted_forces(forces) -
                     total_forces(coarser_->model(), coarse, *coarse_drive_, false);
    std::vector<Handle> coarse_handles;
    for (const Handle& handle : handles) {
        Handle& held = coarse_handles.emplace_back();
        held.plane = handle.plane;
        Vec3 centre = Vec3::Zero();
        for (const auto& [node, weight] :
             coarser_->restricted_weights(handle.nodes, handle.weights)) {
            held.nodes.push_back(node);
            held.weights.push_back(weight);
            centre += weight * coarse.positions.col(node);
        }
        held.target = handle.plane.transpose() * centre;  // it is held in its place already
    }
    const Points before = coarse.positions;
    RelaxOptions options;
    options.iterations = coarser_->coarser() != nullptr ? kCycles * kSmoothingSteps : kCoarseSteps;
    options.still_mm = 1e-6;
    coarse_solver_->restart();
    if (!coarse_solver_->relax(coarse, with_load, options, coarse_handles).finite) {
        return 0.0;
    }
    const Points way = coarser_->prolonged(coarse.positions - before);
    // As far along it as the energy falls: to where the force along it vanishes.
    const double ahead = forces.cwiseProduct(way).sum();
    if (!(ahead > 0.0)) {
        return 0.0;
    }
    MassSpringState there;
    there.positions = state.positions + way;
    const double left = free_forces(there, drive, handles, pulls).cwiseProduct(way).sum();
    const double share = left < ahead ? std::clamp(ahead / (ahead - left), 0.0, 2.0) : 1.0;
    const double most = std::sqrt(way.colwise().squaredNorm().maxCoeff());
    const double taken = std::min(share, kFarthest / std::max(most, 1e-12));
    state.positions += taken * way;
    return taken * most;
}

RelaxReport EquilibriumSolver::relax_here(MassSpringState& state, const Drive& drive,
                                          const RelaxOptions& options,
                                          std::span<const Handle> handles,
                                          std::span<const HandPull> pulls) {
    const int n = model_.node_count();
    const bool layer = state.layer.cols() > 0;
    if (!warm_ || mass_.size() != n || velocity_.cols() != n ||
        (layer && layer_velocity_.cols() == 0)) {
        velocity_ = Points::Zero(3, n);
        last_force_ = force_ = Points::Zero(3, n);
        next_ = state.positions;
        layer_velocity_ = layer_force_ = layer_last_force_ =
            Points::Zero(3, layer ? model_.skin_nodes : 0);
        layer_next_ = state.layer;
        damping_ = smoothing_ ? kSmoothingDamping : 0.1;
        since_cold_ = smoothing_ ? kColdIterations : 0;
        warm_ = true;
    }
    const Points good = state.positions;
    const Points good_layer = state.layer;
    RelaxReport report;
    int still = 0;
    for (int k = 0; k < options.iterations; ++k) {
        // A cold start may be far from rest: stretched springs are stiff and change quickly.
        if (since_cold_ < kColdIterations || since_masses_ >= kMassesEvery ||
            (k == 0 && (!pulls.empty() || layer))) {
            scale_masses(state, drive, pulls);
            since_masses_ = 0;
        }
        ++since_cold_;
        ++since_masses_;
        hand_forces_.clear();
        advance(state, drive, pulls, layer);
        for (const Handle& handle : handles) {
            hold(handle);
        }
        const bool look = k % kLookEvery == kLookEvery - 1 || k + 1 == options.iterations;
        if (look) {
            report.last_step =
                std::sqrt((next_ - state.positions).colwise().squaredNorm().maxCoeff());
            if (layer) {
                report.last_step = std::max(
                    report.last_step,
                    std::sqrt((layer_next_ - state.layer).colwise().squaredNorm().maxCoeff()));
            }
        }
        state.positions.swap(next_);
        if (layer) {
            state.layer.swap(layer_next_);
        }
        ++report.iterations;
        if (!look) {
            continue;
        }
        if (!(report.last_step < kRunaway)) {
            state.positions = good;
            state.layer = good_layer;
            report.finite = false;
            restart();
            break;
        }
        still = report.last_step < options.still_mm ? still + 1 : 0;
        if (still >= 2) {
            report.converged = true;
            break;
        }
    }
    report.residual = std::sqrt(std::max(residual_, 0.0) / std::max(n, 1));
    return report;
}

}  // namespace myoface
