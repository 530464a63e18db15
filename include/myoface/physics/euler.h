// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/physics/mass_spring_model.h"

namespace myoface {

/// One step of forward Euler, eqs. (2)-(3) to the letter; (3) uses the *old* velocity:
///   V(T+ΔT) = V(T) + F(T)/m ΔT,   R(T+ΔT) = R(T) + V(T) ΔT
/// The reference of every other method. Fixed nodes stay.
/// @param step ΔT [s]; stable up to stable_time_step(model, Integrator::ExplicitEuler)
/// @cite matsuda_muscle_spring, Eqs. (2)-(3)
void explicit_euler_step(const MassSpringModel& model, MassSpringState& state, const Drive& drive,
                         double step);

/// The same with the *new* velocity in (3): stable far longer and, undamped, without growth.
void symplectic_euler_step(const MassSpringModel& model, MassSpringState& state, const Drive& drive,
                           double step);

enum class Integrator { ExplicitEuler, SymplecticEuler };

/// A time step [s] that is surely stable near rest, from Gershgorin's bound on the stiffness: with
/// ω² ≤ max 2Σk/m and the damping rate δ,
///   symplectic: (√(δ² + 4ω²) − δ)/ω²,   explicit: δ/ω² with the node's own damping only.
/// 0 for an undamped explicit Euler, which is never stable.
double stable_time_step(const MassSpringModel& model, Integrator integrator);

/// Gershgorin row sums Σ_j |K_ij| per node [mN/mm], springs at the given positions.
Eigen::VectorXd stiffness_row_sums(const MassSpringModel& model, const Points& positions,
                                   const Drive& drive);

}  // namespace myoface
