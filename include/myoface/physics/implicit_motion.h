// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/physics/mass_spring_model.h"

namespace myoface {

/// Motion in time by the second-order backward difference formula, stable for steps of any length:
///   v' = (3x' − 4x + x⁻)/2h,   M (3v' − 4v + v⁻)/2h + C v' = F(x').
/// The first step is one of implicit Euler. What a step asks for is an equilibrium with inertia as
/// one more load, so that an EquilibriumSolver with all its levels finds it:
///   begin() puts the load into a drive, the solver relaxes the state, end() takes the velocities.
/// C are the ties' dampers; those of the springs are left out. @cite hairer_wanner_1996
class ImplicitMotion {
public:
    /// @param damping share of the ties' dampers that acts
    /// @param model outlives this
    explicit ImplicitMotion(const MassSpringModel& model, double damping = 0.2);

    /// Forgets the past: the next step starts from the state's positions and velocities.
    void restart() { warm_ = false; }
    /// The past goes along where a state was put elsewhere. @param way 3×N [mm]
    void shift(const Points& way);

    /// @param step [s]
    void begin(const MassSpringState& state, double step, Drive& drive);
    void end(MassSpringState& state);

private:
    const MassSpringModel& model_;
    double damping_;
    bool warm_ = false;
    double step_ = 0.0, h_ = 0.0;
    Points now_, before_;  ///< positions at the begin of this step and the last
    Points velocity_, velocity_before_;
    Points from_;
};

}  // namespace myoface
