// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/equilibrium.h"

#include <gtest/gtest.h>

#include "myoface/base/parallel.h"
#include "myoface/physics/euler.h"
#include "myoface/physics/forces.h"
#include "myoface/physics/packed_model.h"
#include "myoface/sim/frame_governor.h"

#include "physics/anderson.h"
#include "test_meshes.h"

namespace myoface {
namespace {

TEST(EquilibriumSolver, HangsAWeightWhereHookeSays) {
    MassSpringModel model = test::spring_row(2, 50.0, 10.0, 0.01);
    model.fixed[0] = 1;
    model.ties[1].anchor = 1e-3;  // sideways
    EquilibriumSolver solver(model);
    MassSpringState state = rest_state(model);
    Drive drive;
    drive.gravity = {9810.0, 0.0, 0.0};
    RelaxOptions options;
    options.iterations = 20000;
    const RelaxReport report = solver.relax(state, drive, options);
    EXPECT_TRUE(report.converged);
    EXPECT_NEAR(state.positions(0, 1), 10.0 + 0.01 * 9810.0 / 50.0, 1e-3);
}

TEST(EquilibriumSolver, EndsWhereDampedEulerEnds) {
    MassSpringModel model = test::spring_row(12, 60.0, 2.0, 1e-4, 1e-4);
    model.fixed[0] = model.fixed[11] = 1;
    for (Tie& tie : model.ties) {
        tie.damping = 0.02;
        tie.anchor = 4.0;
    }
    Drive drive;
    drive.load = Points::Zero(3, 12);
    drive.load.col(5) << 3.0, 20.0, -5.0;
    MassSpringState relaxed = rest_state(model);
    EquilibriumSolver solver(model);
    RelaxOptions options;
    options.still_mm = 1e-6;
    options.iterations = 20000;
    ASSERT_TRUE(solver.relax(relaxed, drive, options).converged);
    MassSpringState stepped = rest_state(model);
    const double step = stable_time_step(model, Integrator::ExplicitEuler);
    for (int k = 0; k < 60000; ++k) {
        explicit_euler_step(model, stepped, drive, step);
    }
    EXPECT_LT((relaxed.positions - stepped.positions).cwiseAbs().maxCoeff(), 2e-5);
}

TEST(EquilibriumSolver, FindsNothingToDoAtRest) {
    Simulator simulator(test::small_model());
    const StepReport report = simulator.settle();
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.max_displacement_mm, 0.0);
    EXPECT_EQ(simulator.scan_vertices(), test::small_model()->scan->mesh.vertices);
}

TEST(EquilibriumSolver, HoldsAHandleExactlyAndFeelsItsForce) {
    MassSpringModel model = test::spring_row(3, 50.0, 10.0, 0.01);
    model.fixed[0] = model.fixed[2] = 1;
    Handle handle;
    handle.nodes = {1};
    handle.weights = {1.0};
    handle.plane << 1, 0, 0, 1, 0, 0;
    handle.target = {12.0, 0.0};
    EquilibriumSolver solver(model);
    MassSpringState state = rest_state(model);
    solver.relax(state, {}, {}, {&handle, 1});
    EXPECT_NEAR(state.positions(0, 1), 12.0, 1e-6);
    EXPECT_NEAR(solver.hand_forces().at(0).x(), 200.0, 1e-3);  // both springs by 2 mm
}

TEST(EquilibriumSolver, PullsNoHarderThanItsBound) {
    MassSpringModel model = test::spring_row(2, 0.5, 10.0, 0.01);
    model.fixed[0] = 1;
    model.ties[1].anchor = 1e-3;
    HandPull pull;
    pull.grip_nodes = pull.nodes = {1};
    pull.grip_weights = pull.weights = {1.0};
    pull.plane << 1, 0, 0, 1, 0, 0;
    pull.target = {1000.0, 0.0};
    pull.largest = 20.0;
    EquilibriumSolver solver(model);
    MassSpringState state = rest_state(model);
    RelaxOptions options;
    options.iterations = 20000;
    solver.relax(state, {}, options, {}, {&pull, 1});
    EXPECT_NEAR(solver.hand_forces().at(0).x(), 20.0, 1e-6);
    EXPECT_NEAR(state.positions(0, 1), 10.0 + 20.0 / (0.5 + 1e-3), 0.1);
}

TEST(EquilibriumSolver, GivesTheSameBitsTwiceAndForAnyNumberOfThreads) {
    const auto run = [](int threads) {
        set_thread_count(threads);
        Simulator simulator(test::small_model());
        simulator.set_contraction(test::muscle(simulator.face(), "zygomaticus_major.L"), 0.7);
        simulator.step(300);
        return simulator.state_hash();
    };
    const int before = thread_count();
    const auto one = run(1);
    EXPECT_EQ(one, run(1));
    EXPECT_EQ(one, run(2));
    EXPECT_EQ(one, run(3));
    set_thread_count(before);
}

TEST(EquilibriumSolver, NeverEndsAFrameWithMoreEnergyThanItBegan) {
    for (const bool levels : {false, true}) {
        SimulatorOptions options;
        options.levels = levels;
        Simulator sim(test::small_model(), options);
        for (const char* muscle :
             {"zygomaticus_major.L", "frontalis_medial.R", "depressor_anguli_oris.L"}) {
            sim.set_contraction(test::muscle(sim.face(), muscle), 0.9);
        }
        PackedModel packed(sim.system().model);
        const auto responses =
            muscle_responses(sim.face(), sim.system().model, ResponseForm::Smooth);
        Drive drive = contraction_drive(sim.system(), responses, sim.contractions());
        drive.gravity = kUprightGravity;
        packed.set_drive(drive);
        sim.step(12);
        double before = packed.energy(sim.state().positions);
        int risen = 0;
        for (int frame = 0; frame < 60; ++frame) {
            sim.step(12);
            const double now = packed.energy(sim.state().positions);
            risen += now > before + 1e-4 * std::abs(before);
            before = now;
        }
        // A step with momentum may carry a little of it over the end of a frame.
        EXPECT_LE(risen, levels ? 1 : 3);
    }
}

TEST(Anderson, FindsTheFixedPointOfALinearIterationInAFewSteps) {
    // x → g(x) = x + (1 − λ)(b − x) in 3 N components with rates from 0.2 to 0.98.
    constexpr int kSlices = 3;
    constexpr int kRows = kSlices * kLanes;
    LargeArray<ScalarLanes> mass(kSlices);
    for (int r = 0; r < kRows; ++r) {
        of_row(mass, r) = 1.0F;
    }
    LargeArray<NodeRecord> from(kRows);
    LargeArray<NodeRecord> to(kRows);
    const auto iterate = [&](bool accelerated) {
        Anderson anderson(kSlices);
        for (int r = 0; r < kRows; ++r) {
            std::fill_n(from[r].moved, 3, 0.0F);
        }
        for (int k = 0; k < 12; ++k) {
            for (int r = 0; r < kRows; ++r) {
                // Four rates: four pairs are enough for them.
                const float rate = 0.2F + 0.26F * static_cast<float>(r % 4);
                for (int axis = 0; axis < 3; ++axis) {
                    to[r].moved[axis] =
                        from[r].moved[axis] +
                        (1.0F - rate) * (static_cast<float>(r + axis) - from[r].moved[axis]);
                }
            }
            if (accelerated) {
                anderson.accelerate(from, to, mass);
            }
            std::copy_n(to.data(), kRows, from.data());
        }
        double left = 0.0;
        for (int r = 0; r < kRows; ++r) {
            for (int axis = 0; axis < 3; ++axis) {
                left =
                    std::max(left, std::abs(static_cast<double>(from[r].moved[axis]) - r - axis));
            }
        }
        return left;
    };
    EXPECT_GT(iterate(false), 10.0);
    EXPECT_LT(iterate(true), 0.01);
}

TEST(FrameGovernor, FitsTheSweepsToTheTimeThatTheyTook) {
    FrameGovernor governor;
    StepReport report;
    report.iterations = 100;
    report.milliseconds = 20.0;
    for (int k = 0; k < 30; ++k) {
        governor.learn(report);
    }
    EXPECT_NEAR(governor.sweeps(10.0), 50, 3);
    report.milliseconds = 200.0;  // something else took the machine: at once fewer
    governor.learn(report);
    EXPECT_LT(governor.sweeps(10.0), 12);
    EXPECT_GE(governor.sweeps(0.001), 1);
}

TEST(EquilibriumSolver, PutsBackAStateThatRunsAway) {
    MassSpringModel model = test::spring_row(2, 1.0, 10.0, 1e-3);
    model.fixed[0] = 1;
    EquilibriumSolver solver(model);
    MassSpringState state = rest_state(model);
    Drive drive;
    drive.load = Points::Zero(3, 2);
    drive.load(1, 1) = 1e12;
    const RelaxReport report = solver.relax(state, drive, {});
    EXPECT_FALSE(report.finite);
    EXPECT_EQ(state.positions, model.rest);
}

TEST(Solvers, AgreeOnAContractedFace) {
    // The equilibrium engine against the symplectic Euler integration of the same model.
    SimulatorOptions stepping;
    stepping.solver = SolverKind::SymplecticEuler;
    Simulator quick(test::small_model());
    Simulator slow(test::small_model(), stepping);
    const int m = test::muscle(quick.face(), "corrugator_supercilii.L");
    quick.set_contraction(m, 0.6);
    slow.set_contraction(m, 0.6);
    ASSERT_TRUE(quick.settle().converged);
    const StepReport report = slow.settle();
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.solver, "symplectic");
    const Points difference = quick.state().positions - slow.state().positions;
    EXPECT_LT(std::sqrt(difference.colwise().squaredNorm().maxCoeff()), 0.02);
    // And what is stored in the tissue is the same to half a percent of what was gained.
    const MassSpringModel& model = quick.system().model;
    Drive drive = contraction_drive(quick.system(),
                                    muscle_responses(quick.face(), model, ResponseForm::Smooth),
                                    quick.contractions());
    drive.gravity = kUprightGravity;
    const double at_first = potential_energy(model, rest_state(model), drive);
    const double energy = potential_energy(model, quick.state(), drive);
    EXPECT_LT(energy, at_first);
    EXPECT_NEAR(potential_energy(model, slow.state(), drive), energy, 0.005 * (at_first - energy));
}

}  // namespace
}  // namespace myoface
