// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/euler.h"

#include <cmath>

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace myoface {
namespace {

/// A mass on a damped spring from a fixed point, pulled out by 1 mm.
struct Oscillator {
    double mass = 0.01, stiffness = 40.0, damping = 0.2;  // ω = 63 /s, ζ = 0.16
    MassSpringModel model;
    MassSpringState state;

    Oscillator() {
        model = test::spring_row(2, stiffness, 10.0, mass, damping);
        model.fixed[0] = 1;
        state = rest_state(model);
        state.positions(0, 1) += 1.0;
    }
    double exact(double t) const {
        const double delta = 0.5 * damping / mass;
        const double omega = std::sqrt(stiffness / mass - delta * delta);
        return std::exp(-delta * t) * (std::cos(omega * t) + delta / omega * std::sin(omega * t));
    }
    double run(double end, int steps, bool symplectic) {
        MassSpringState s = state;
        for (int k = 0; k < steps; ++k) {
            symplectic ? symplectic_euler_step(model, s, {}, end / steps)
                       : explicit_euler_step(model, s, {}, end / steps);
        }
        return s.positions(0, 1) - 10.0;
    }
};

TEST(ExplicitEuler, AgreesWithADampedOscillatorToFirstOrder) {
    Oscillator o;
    constexpr double kEnd = 0.1;
    const double coarse = std::abs(o.run(kEnd, 2000, false) - o.exact(kEnd));
    const double fine = std::abs(o.run(kEnd, 4000, false) - o.exact(kEnd));
    EXPECT_LT(fine, 5e-3);
    EXPECT_NEAR(coarse / fine, 2.0, 0.1);  // half the step, half the error
}

TEST(SymplecticEuler, AgreesWithADampedOscillatorToFirstOrder) {
    Oscillator o;
    constexpr double kEnd = 0.1;
    const double coarse = std::abs(o.run(kEnd, 2000, true) - o.exact(kEnd));
    const double fine = std::abs(o.run(kEnd, 4000, true) - o.exact(kEnd));
    EXPECT_LT(fine, 5e-3);
    EXPECT_NEAR(coarse / fine, 2.0, 0.15);
}

TEST(ExplicitEuler, UsesTheOldVelocityForThePosition) {
    Oscillator o;
    MassSpringState s = o.state;
    explicit_euler_step(o.model, s, {}, 1e-3);
    EXPECT_EQ(s.positions, o.state.positions);  // at rest in the beginning
    EXPECT_NEAR(s.velocities(0, 1), -40.0 / 0.01 * 1e-3, 1e-9);
    symplectic_euler_step(o.model, o.state, {}, 1e-3);
    EXPECT_LT(o.state.positions(0, 1), 11.0);
}

TEST(ExplicitEuler, GrowsWithoutDampingWhereSymplecticDoesNot) {
    Oscillator o;
    for (Spring& s : o.model.springs) {
        s.damping = 0.0;
    }
    index_rows(o.model);
    EXPECT_GT(std::abs(o.state.positions(0, 1) - 10.0), 0.99);
    MassSpringState grown = o.state;
    MassSpringState kept = o.state;
    double largest_explicit = 0.0;
    double largest_symplectic = 0.0;
    for (int k = 0; k < 2000; ++k) {
        explicit_euler_step(o.model, grown, {}, 2e-3);
        symplectic_euler_step(o.model, kept, {}, 2e-3);
        largest_explicit = std::max(largest_explicit, std::abs(grown.positions(0, 1) - 10.0));
        largest_symplectic = std::max(largest_symplectic, std::abs(kept.positions(0, 1) - 10.0));
    }
    EXPECT_GT(largest_explicit, 10.0);
    EXPECT_LT(largest_symplectic, 1.2);
}

TEST(StableTimeStep, KeepsBothIntegratorsBounded) {
    MassSpringModel model = test::spring_row(30, 100.0, 1.0, 1e-4, 0.002);
    for (Tie& tie : model.ties) {
        tie.damping = 0.01;
        tie.anchor = 5.0;
    }
    for (const Integrator integrator : {Integrator::ExplicitEuler, Integrator::SymplecticEuler}) {
        MassSpringState state = rest_state(model);
        std::srand(4);
        state.positions += 0.1 * Points::Random(3, 30);
        const double step = stable_time_step(model, integrator);
        ASSERT_GT(step, 0.0);
        for (int k = 0; k < 20000; ++k) {
            integrator == Integrator::ExplicitEuler ? explicit_euler_step(model, state, {}, step)
                                                    : symplectic_euler_step(model, state, {}, step);
        }
        EXPECT_LT((state.positions - model.rest).cwiseAbs().maxCoeff(), 0.2);
    }
}

TEST(StableTimeStep, IsZeroForAnUndampedExplicitEuler) {
    EXPECT_EQ(stable_time_step(test::spring_row(5, 100.0, 1.0, 1e-4), Integrator::ExplicitEuler),
              0.0);
}

TEST(Euler, LeavesFixedNodesWhereTheyAre) {
    Oscillator o;
    Drive drive;
    drive.gravity = {0.0, -9810.0, 0.0};
    symplectic_euler_step(o.model, o.state, drive, 1e-3);
    EXPECT_EQ(o.state.positions.col(0), o.model.rest.col(0));
    EXPECT_LT(o.state.positions(1, 1), 0.0);
}

}  // namespace
}  // namespace myoface
