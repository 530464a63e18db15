// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/equilibrium.h"

#include <gtest/gtest.h>

#include "myoface/base/parallel.h"
#include "myoface/physics/euler.h"
#include "myoface/physics/forces.h"
#include "myoface/sim/simulator.h"

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
}

}  // namespace
}  // namespace myoface
