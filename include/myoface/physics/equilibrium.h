// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "myoface/physics/coarse_level.h"
#include "myoface/physics/mass_spring_model.h"

namespace myoface {

/// A weighted group of nodes held by a hand: Σ weight_j x_j moves only freely along `free`.
struct Handle {
    std::vector<int> nodes;
    std::vector<double> weights;                       ///< sum to 1
    Eigen::Matrix<double, 3, 2> plane;                 ///< the two held directions, orthonormal
    Eigen::Vector2d target = Eigen::Vector2d::Zero();  ///< wanted planeᵀ Σ weight_j x_j [mm]
};

/// A hand that pulls with a bounded force, through `pull` nodes, at a point given by `grip` nodes.
struct HandPull {
    std::vector<int> grip_nodes;
    std::vector<double> grip_weights;  ///< sum to 1: the grabbed point
    std::vector<int> nodes;
    std::vector<double> weights;  ///< sum to 1: the stress kernel
    std::vector<Mat3> spread;     ///< force of each node per force of the hand; empty: its weight
    Eigen::Matrix<double, 3, 2> plane;
    Eigen::Vector2d target = Eigen::Vector2d::Zero();  ///< the mouse in the plane [mm]
    double stiffness = 1000.0;                         ///< of the hand [mN/mm]
    double largest = 6000.0;                           ///< bound of the force [mN]
    double skin_share = 1.0;                           ///< λ: part that pulls at the skin
    double layer_share = 0.0;                          ///< μ: part that pulls at the muscle layer
    std::vector<int> layer_nodes;
    std::vector<double> layer_weights;
    std::optional<Eigen::Vector2d> force;  ///< given instead of following the mouse [mN]
};

/// The part of a hand's force that its k-th kernel node takes, on the skin.
inline Vec3 part_of(const HandPull& hand, std::size_t k, const Vec3& force) {
    return hand.spread.empty() ? Vec3(hand.weights[k] * force) : Vec3(hand.spread[k] * force);
}

struct RelaxOptions {
    int iterations = 3000;
    double still_mm = 4e-6;  ///< a step below this is at rest [mm]
};

struct RelaxReport {
    int iterations = 0;
    double residual = 0.0;   ///< rms out-of-balance force per node [mN]
    double last_step = 0.0;  ///< largest motion in the last iteration [mm]
    bool converged = false;
    bool finite = true;  ///< false: the state was not finite and was put back
};

/// Equilibrium by dynamic relaxation: Euler steps with masses scaled to each node's stiffness and
/// with damping fitted to the slowest motion still alive. Keeps its momentum between calls, so that
/// a drag can spread its work over frames. With a coarser level, a few such steps even out what is
/// rough in the residual and the coarser level finds the far-reaching rest of the way, by the full
/// approximation scheme; a correction is taken as far as it lowers the energy, and a round of both
/// that does not lower it is undone. Single precision inside. Deterministic, independent of the
/// number of threads. @cite underwood_1983 @cite brandt_1977
class EquilibriumSolver {
public:
    /// @param coarser next level, or null; outlives the solver, as the model does
    explicit EquilibriumSolver(const MassSpringModel& model, const CoarseLevel* coarser = nullptr);
    ~EquilibriumSolver();
    EquilibriumSolver(const EquilibriumSolver&) = delete;
    EquilibriumSolver& operator=(const EquilibriumSolver&) = delete;

    /// Relaxes `state` (its velocities are not used) under the drive, and under handles or pulls.
    RelaxReport relax(MassSpringState& state, const Drive& drive, const RelaxOptions& options,
                      std::span<const Handle> handles = {}, std::span<const HandPull> pulls = {});

    /// To be called whenever the drive is not that of the call before.
    void drive_changed();

    /// To be called where only its loads or where inertia leads to are others.
    void loads_changed();

    /// Forgets momentum: after a jump of the state or another model of the same size.
    void restart();

    /// Force of each handle, or else of each pull, in the last iteration [mN].
    const std::vector<Vec3>& hand_forces() const;

private:
    struct Level;
    std::unique_ptr<Level> level_;
    bool drive_changed_ = true, loads_changed_ = false;
    bool had_layer_ = false;
    std::vector<Eigen::Vector2d> targets_;  ///< of the handles in the last call
};

}  // namespace myoface
