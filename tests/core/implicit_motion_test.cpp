// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/implicit_motion.h"

#include <gtest/gtest.h>

#include "myoface/physics/equilibrium.h"
#include "myoface/physics/euler.h"
#include "myoface/physics/forces.h"
#include "myoface/sim/simulator.h"

#include "test_meshes.h"

namespace myoface {
namespace {

/// A mass on a tie: its motion is known.
struct Pendulum {
    double stiffness = 40.0, mass = 0.02, damper = 0.2;
    MassSpringModel model = test::spring_row(2, 0.0, 10.0, mass);
    Pendulum() {
        model.fixed[0] = 1;
        model.ties[1].anchor = stiffness;
        model.ties[1].damping = damper;
    }
    double exact(double t) const {
        const double delta = 0.5 * damper / mass;
        const double omega = std::sqrt(stiffness / mass - delta * delta);
        return std::exp(-delta * t) * (std::cos(omega * t) + delta / omega * std::sin(omega * t));
    }
    double run(double end, int steps) const {
        MassSpringState state = rest_state(model);
        state.positions(0, 1) += 1.0;
        ImplicitMotion motion(model, 1.0);
        EquilibriumSolver solver(model);
        RelaxOptions options;
        options.iterations = 400;
        options.still_mm = 1e-7;
        Drive drive;
        for (int k = 0; k < steps; ++k) {
            motion.begin(state, end / steps, drive);
            k == 0 ? solver.drive_changed() : solver.loads_changed();
            solver.relax(state, drive, options);
            motion.end(state);
        }
        return state.positions(0, 1) - 10.0;
    }
};

TEST(ImplicitMotion, AgreesWithADampedOscillatorToSecondOrder) {
    const Pendulum pendulum;
    constexpr double kEnd = 0.3;
    const double coarse = std::abs(pendulum.run(kEnd, 60) - pendulum.exact(kEnd));
    const double fine = std::abs(pendulum.run(kEnd, 120) - pendulum.exact(kEnd));
    EXPECT_LT(fine, 0.02);
    EXPECT_NEAR(coarse / fine, 4.0, 1.2);  // half the step, a quarter of the error
}

TEST(ImplicitMotion, StaysBoundedAtAnyStep) {
    const Pendulum pendulum;
    for (const double step : {1e-4, 0.1, 10.0}) {
        EXPECT_LT(std::abs(pendulum.run(20.0 * step, 20)), 1.05) << step;
    }
}

TEST(ImplicitMotion, IsAForceLikeAnyOther) {
    const auto face = test::small_model();
    const FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    MassSpringState state = rest_state(system.model);
    std::srand(3);
    state.positions += Points::Random(3, system.model.node_count());
    state.velocities = 20.0 * Points::Random(3, system.model.node_count());
    Drive drive;
    drive.gravity = system.model.rest_gravity;
    Drive still = drive;
    ImplicitMotion motion(system.model, 1.0);
    motion.begin(state, 0.01, drive);
    // Inertia alone, and the slope of its energy.
    const Points forces = total_forces(system.model, state, drive, false) -
                          total_forces(system.model, state, still, false);
    for (int i = 0; i < system.model.node_count(); i += 211) {
        for (int axis = 0; axis < 3; ++axis) {
            constexpr double kStep = 1e-4;
            double energy[2];
            for (const int side : {0, 1}) {
                MassSpringState moved = state;
                moved.positions(axis, i) += side == 0 ? -kStep : kStep;
                energy[side] = potential_energy(system.model, moved, drive) -
                               potential_energy(system.model, moved, still);
            }
            EXPECT_NEAR(forces(axis, i), (energy[0] - energy[1]) / (2.0 * kStep),
                        1e-4 * forces.cwiseAbs().maxCoeff());
        }
    }
}

TEST(LiveMotion, SwingsPastRestAndSettlesThere) {
    const auto face = test::small_model();
    Simulator simulator(face);
    const int muscle = test::muscle(*face, "zygomaticus_major.L");
    Simulator still(face);
    still.set_contraction(muscle, 1.0);
    still.settle();
    const double goal = (still.state().positions - still.system().model.rest).norm();
    ASSERT_GT(goal, 1.0);
    simulator.set_live(0.1);  // slow motion
    simulator.set_contraction(muscle, 1.0);
    double most = 0.0;
    std::vector<double> ways;
    for (int frame = 0; frame < 300; ++frame) {
        const StepReport report = simulator.step(30);
        EXPECT_TRUE(report.finite);
        ways.push_back((simulator.state().positions - simulator.system().model.rest).norm());
        most = std::max(most, ways.back());
    }
    EXPECT_LT(ways[0], 0.7 * goal);  // inertia
    EXPECT_GT(most, 1.02 * goal);    // it overshoots
    EXPECT_LT(most, 1.6 * goal);
    EXPECT_LT((simulator.state().positions - still.state().positions).cwiseAbs().maxCoeff(), 0.02);
    simulator.set_contraction(muscle, 0.0);
    for (int frame = 0; frame < 300 && !simulator.step(60).converged; ++frame) {
    }
    EXPECT_EQ(simulator.state().positions, simulator.system().model.rest);
}

TEST(LiveMotion, FollowsTheSymplecticReference) {
    const auto face = test::small_model();
    Simulator live(face);
    const int muscle = test::muscle(*face, "frontalis_lateral.L");
    live.set_contraction(muscle, 0.5);
    constexpr double kSeconds = 2.0 / 60.0;
    live.live_on(kSeconds);
    // The same motion in small explicit steps, the ties' dampers as the live motion has them.
    FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    system.model.rest_gravity = kUprightGravity;
    for (Tie& tie : system.model.ties) {
        tie.damping *= 0.2;
    }
    for (Spring& spring : system.model.springs) {
        spring.damping = 0.0;
    }
    Contractions contractions = resting(*face);
    contractions.rate[muscle] = 0.5;
    Drive drive = contraction_drive(
        system, muscle_responses(*face, system.model, ResponseForm::Smooth), contractions);
    drive.gravity = kUprightGravity;
    MassSpringState state = rest_state(system.model);
    const double stable = stable_time_step(system.model, Integrator::SymplecticEuler);
    const int steps = static_cast<int>(std::ceil(kSeconds / stable));
    for (int k = 0; k < steps; ++k) {
        symplectic_euler_step(system.model, state, drive, kSeconds / steps);
    }
    const double way = (state.positions - system.model.rest).norm();
    EXPECT_GT(way, 0.2);
    EXPECT_LT((live.state().positions - state.positions).norm(), 0.15 * way);
}

}  // namespace
}  // namespace myoface
