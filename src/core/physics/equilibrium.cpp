// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/equilibrium.h"

#include <algorithm>
#include <cmath>

#include "anderson.h"
#include "level_transfer.h"
#include "relaxation.h"

namespace myoface {
namespace {

constexpr int kSmoothingSteps = 6;
constexpr int kMostSteps = 30;    // of a round; when that does not do, steps alone go on
constexpr int kCoarseSteps = 40;  // on the coarsest
constexpr double kLongestCorrection =
    3.0;                            // [mm] at once: further on the finer level is another one
constexpr double kFarStill = 25.0;  // of a step at rest: a correction that says as much
constexpr double kMixNear = 0.5;    // [mm] a correction from which on rounds are accelerated
constexpr double kRise = 1e-5;      // of the energy: rounding

RowHandle on_rows(const Handle& handle, const PackedModel::Data& packed) {
    RowHandle rows;
    rows.weights = handle.weights;
    rows.plane = handle.plane;
    Vec3 rest = Vec3::Zero();
    for (std::size_t k = 0; k < handle.nodes.size(); ++k) {
        rows.rows.push_back(packed.row_of[handle.nodes[k]]);
        rest += handle.weights[k] * packed.model.rest.col(handle.nodes[k]);
    }
    rows.target = handle.target - handle.plane.transpose() * rest;
    return rows;
}

RowPull on_rows(const HandPull& pull, const PackedModel::Data& packed) {
    RowPull rows;
    rows.hand = &pull;
    Vec3 rest = Vec3::Zero();
    for (std::size_t k = 0; k < pull.grip_nodes.size(); ++k) {
        rows.grip_rows.push_back(packed.row_of[pull.grip_nodes[k]]);
        rest += pull.grip_weights[k] * packed.model.rest.col(pull.grip_nodes[k]);
    }
    for (const int node : pull.nodes) {
        rows.rows.push_back(packed.row_of[node]);
    }
    rows.target = pull.target - pull.plane.transpose() * rest;
    return rows;
}

double dot(const LargeArray<VectorLanes>& a, const LargeArray<VectorLanes>& b) {
    double sum = 0.0;
    for (std::size_t s = 0; s < a.size(); ++s) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int k = 0; k < kLanes; ++k) {
                sum += static_cast<double>(a[s].v[axis][k] * b[s].v[axis][k]);
            }
        }
    }
    return sum;
}

double longest(const LargeArray<VectorLanes>& a, int rows) {
    double square = 0.0;
    for (int r = 0; r < rows; ++r) {
        square = std::max(square, of_row(a, r).squaredNorm());
    }
    return std::sqrt(square);
}

/// to = from + share · way
void move(const LargeArray<NodeRecord>& from, const LargeArray<VectorLanes>& way, double share,
          LargeArray<NodeRecord>& to) {
    const auto part = static_cast<float>(share);
    for (std::size_t r = 0; r < from.size(); ++r) {
        for (int axis = 0; axis < 3; ++axis) {
            to[r].moved[axis] = from[r].moved[axis] + part * of_row(way, static_cast<int>(r), axis);
        }
    }
}

}  // namespace

/// One level with those below it.
struct EquilibriumSolver::Level {
    Level(const MassSpringModel& model, const CoarseLevel* coarser) : relaxation(model) {
        const auto slices = static_cast<std::size_t>(relaxation.packed().slices);
        if (coarser != nullptr) {
            coarse_level = coarser;
            below = std::make_unique<Level>(coarser->model(), coarser->coarser());
            transfer = std::make_unique<LevelTransfer>(*coarser, relaxation.packed(),
                                                       below->relaxation.packed());
            for (auto* lanes : {&forces, &way}) {
                lanes->reset(slices);
            }
            there = relaxation.packed().resting_records();
            good = relaxation.packed().resting_records();
            unmixed = relaxation.packed().resting_records();
            anderson = std::make_unique<Anderson>(slices);
            const auto fewer = static_cast<std::size_t>(below->relaxation.packed().slices);
            gathered.reset(fewer);
            coarse_forces.reset(fewer);
            begun = below->relaxation.packed().resting_records();
            own_loads.reset(fewer);
        }
    }

    void set_drive(const Drive& drive) {
        relaxation.set_drive(drive);
        begin_rounds();
        if (below) {
            below->set_drive(coarse_level->restricted(drive));
            const PackedModel::Data& packed = below->relaxation.packed();
            std::copy_n(packed.loads.data(), packed.loads.size(), own_loads.data());
        }
    }

    /// What was learnt of the way to the last equilibrium counts no more; a round goes on.
    void hands_moved() {
        steps_done = steps == kSmoothingSteps ? steps_done : 0;
        steps = kSmoothingSteps;
        last_far = 0.0;
        relaxation.renew_masses();
        if (anderson) {
            anderson->restart();
        }
        has_good = mixed = false;
        rounds = 0;
    }
    void begin_rounds() {
        hands_moved();
        steps_done = 0;
    }

    RelaxReport relax_levels(const RelaxOptions& options, const Relaxation::Hands& hands,
                             const Drive& drive);
    double correct_far(const Relaxation::Hands& hands, const Drive& drive);

    Relaxation relaxation;
    const CoarseLevel* coarse_level = nullptr;
    std::unique_ptr<Level> below;
    std::unique_ptr<LevelTransfer> transfer;
    int steps = kSmoothingSteps;  ///< of a round before the next correction
    int steps_done = 0;
    double last_far = 0.0;  ///< the last correction [mm]
    LargeArray<VectorLanes> forces, way, gathered, coarse_forces;
    LargeArray<NodeRecord> there, begun;
    LargeArray<LoadLanes> own_loads;  ///< of the level below, without what is sent there
    LargeArray<NodeRecord> good;      ///< where the last round began
    double good_energy = 0.0;
    bool has_good = false;
    int rounds = 0;            ///< since begin_rounds()
    bool accelerates = false;  ///< the finest level only
    std::unique_ptr<Anderson> anderson;
    LargeArray<NodeRecord> unmixed;  ///< where the last round ended
    bool mixed = false;              ///< and acceleration went on from there
};

RelaxReport EquilibriumSolver::Level::relax_levels(const RelaxOptions& options,
                                                   const Relaxation::Hands& hands,
                                                   const Drive& drive) {
    RelaxReport report;
    while (report.iterations < options.iterations) {
        // A round of steps may go on over several calls; the last one has no end.
        if (steps > kMostSteps) {
            RelaxOptions rest = options;
            rest.iterations = options.iterations - report.iterations;
            const int before = report.iterations;
            report = relaxation.run(rest, hands, false, drive, nullptr);
            report.iterations += before;
            break;
        }
        const bool begins = steps_done == 0;
        if (begins) {
            relaxation.restart();
            std::copy_n(relaxation.records().data(), there.size(), there.data());
        }
        const bool smoothing = steps == kSmoothingSteps;
        RelaxOptions few;
        few.iterations = std::min(steps - steps_done, options.iterations - report.iterations);
        few.still_mm = smoothing ? 0.0 : options.still_mm;
        const RelaxReport round = relaxation.run(few, hands, smoothing, drive, nullptr);
        report.iterations += round.iterations;
        report.last_step = round.last_step;
        report.residual = round.residual;
        if (!round.finite) {
            report.finite = false;
            break;
        }
        if (begins && hands.pulls.empty()) {
            const double energy = relaxation.first_energy();
            const bool rises = has_good && energy > good_energy + kRise * std::abs(good_energy);
            if (rises && mixed) {
                std::copy_n(unmixed.data(), unmixed.size(), relaxation.records().data());
                relaxation.restart();
                anderson->restart();
                mixed = false;
                continue;
            }
            if (rises) {
                std::copy_n(good.data(), good.size(), relaxation.records().data());
                relaxation.restart();
                steps = kMostSteps + 1;
                continue;
            }
            // Before the first round hands may not yet have what they want: its energy is no
            // measure.
            good.swap(there);
            good_energy = energy;
            has_good = rounds++ > 0;
        }
        steps_done += round.iterations;
        if (steps_done < steps && !round.converged) {
            continue;  // the budget ends here
        }
        steps_done = 0;
        const double far = correct_far(hands, drive);
        mixed = false;
        if (accelerates && hands.pulls.empty() && far < kMixNear) {
            std::copy_n(relaxation.records().data(), unmixed.size(), unmixed.data());
            mixed = anderson->accelerate(good, relaxation.records(), relaxation.masses());
        }
        if (far < kFarStill * options.still_mm &&
            (round.converged || round.last_step < options.still_mm)) {
            report.converged = true;
            break;
        }
        // What neither the coarser level nor a few steps find is left to more of them.
        if (last_far > 0.0 && far > 0.5 * last_far) {
            steps *= 2;
        } else if (far < 0.25 * last_far) {
            steps = std::max(steps / 2, kSmoothingSteps);
        }
        last_far = far;
    }
    if (report.converged && steps <= kMostSteps) {
        // The sums of the last step stand before the correction.
        std::vector<Vec3> held;
        relaxation.free_forces(relaxation.records(), hands, forces, &held);
        if (!held.empty()) {
            relaxation.hand_forces() = std::move(held);
        }
        report.residual = std::sqrt(dot(forces, forces) / std::max(relaxation.packed().nodes, 1));
    }
    return report;
}

/// One correction by the coarser level. @return the largest motion [mm]
double EquilibriumSolver::Level::correct_far(const Relaxation::Hands& hands, const Drive& drive) {
    LargeArray<NodeRecord>& records = relaxation.records();
    Relaxation& coarse = below->relaxation;
    LargeArray<NodeRecord>& coarse_records = coarse.records();
    PackedModel::Data& coarse_packed = coarse.packed();
    relaxation.free_forces(records, hands, forces, nullptr);
    transfer->restrict_ways(records, coarse_records);
    transfer->restrict_forces(forces, gathered);
    // What is loaded there is balanced by what acts there already.
    std::copy_n(own_loads.data(), own_loads.size(), coarse_packed.loads.data());
    coarse_packed.forces(coarse_records, coarse_forces, false);
    coarse_packed.loaded = true;
    for (std::size_t s = 0; s < gathered.size(); ++s) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int k = 0; k < kLanes; ++k) {
                coarse_packed.loads[s].force[axis][k] +=
                    gathered[s].v[axis][k] - coarse_forces[s].v[axis][k];
            }
        }
    }
    std::vector<RowHandle> handles(hands.handles.size());
    for (std::size_t h = 0; h < handles.size(); ++h) {
        const RowHandle& finer = hands.handles[h];
        RowHandle& held = handles[h];
        held.plane = finer.plane;
        transfer->restrict_weights(finer.rows, finer.weights, held.rows, held.weights);
        Vec3 centre = Vec3::Zero();
        for (std::size_t k = 0; k < held.rows.size(); ++k) {
            const float* moved = coarse_records[static_cast<std::size_t>(held.rows[k])].moved;
            centre += held.weights[k] * Vec3(moved[0], moved[1], moved[2]);
        }
        held.target = held.plane.transpose() * centre;  // it is held in its place already
    }
    std::copy_n(coarse_records.data(), coarse_records.size(), begun.data());
    RelaxOptions options;
    options.iterations = below->below ? kSmoothingSteps : kCoarseSteps;
    options.still_mm = 1e-6;
    coarse.restart();
    coarse.forget_hands();
    below->begin_rounds();
    const Relaxation::Hands coarse_hands{handles, {}};
    const RelaxReport report = below->below
                                   ? below->relax_levels(options, coarse_hands, drive)
                                   : coarse.run(options, coarse_hands, false, drive, nullptr);
    if (!report.finite) {
        return 0.0;
    }
    transfer->prolong(begun, coarse_records, way);
    // As far along it as the energy falls: to where the force along it vanishes.
    const double ahead = dot(forces, way);
    if (!(ahead > 0.0)) {
        return 0.0;
    }
    move(records, way, 1.0, there);
    relaxation.free_forces(there, hands, forces, nullptr);
    const double left = dot(forces, way);
    const double share = left < ahead ? std::clamp(ahead / (ahead - left), 0.0, 2.0) : 1.0;
    const double most = longest(way, relaxation.packed().nodes);
    const double taken = std::min(share, kLongestCorrection / std::max(most, 1e-12));
    move(records, way, taken, records);
    return taken * most;
}

EquilibriumSolver::EquilibriumSolver(const MassSpringModel& model, const CoarseLevel* coarser)
    : level_(std::make_unique<Level>(model, coarser)) {
    level_->accelerates = true;
}

EquilibriumSolver::~EquilibriumSolver() = default;

void EquilibriumSolver::drive_changed() {
    drive_changed_ = true;
}

void EquilibriumSolver::loads_changed() {
    loads_changed_ = true;
}

void EquilibriumSolver::restart() {
    level_->relaxation.restart();
    level_->relaxation.forget_hands();
    level_->begin_rounds();
}

const std::vector<Vec3>& EquilibriumSolver::hand_forces() const {
    return level_->relaxation.hand_forces();
}

RelaxReport EquilibriumSolver::relax(MassSpringState& state, const Drive& drive,
                                     const RelaxOptions& options, std::span<const Handle> handles,
                                     std::span<const HandPull> pulls) {
    const bool layer = state.layer.cols() > 0;
    if (drive_changed_ || had_layer_ != layer) {
        level_->set_drive(drive);
        drive_changed_ = false;
        had_layer_ = layer;
    } else if (loads_changed_) {
        level_->relaxation.packed().set_loads(drive);
        level_->hands_moved();
    }
    loads_changed_ = false;
    std::vector<Eigen::Vector2d> targets;
    for (const Handle& handle : handles) {
        targets.push_back(handle.target);
    }
    if (targets != targets_) {  // the hand went on: far-reaching motion again
        level_->hands_moved();
        targets_ = std::move(targets);
    }
    Relaxation& relaxation = level_->relaxation;
    const PackedModel::Data& packed = relaxation.packed();
    packed.put(state.positions, relaxation.records());
    std::vector<RowHandle> row_handles;
    for (const Handle& handle : handles) {
        row_handles.push_back(on_rows(handle, packed));
    }
    std::vector<RowPull> row_pulls;
    for (const HandPull& pull : pulls) {
        row_pulls.push_back(on_rows(pull, packed));
    }
    const Relaxation::Hands hands{row_handles, row_pulls};
    const Points good_layer = state.layer;
    const RelaxReport report =
        level_->below && !layer
            ? level_->relax_levels(options, hands, drive)
            : relaxation.run(options, hands, false, drive, layer ? &state.layer : nullptr);
    if (report.finite) {
        packed.take(relaxation.records(), state.positions);
    } else {
        state.layer = good_layer;
        restart();
    }
    return report;
}

}  // namespace myoface
