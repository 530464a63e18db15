// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/forces.h"

#include <random>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/physics/build_mass_spring.h"

#include "test_meshes.h"

namespace myoface {
namespace {

/// Every term of the energy in one small model: springs with stiffening, sliding ties with curved
/// quadrics, tethers with targets, anchors, bending-like links, a contact that is closed.
MassSpringModel everything() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    MassSpringModel model = test::spring_row(8, 120.0, 3.0, 1e-4);
    model.skin_nodes = 8;
    model.stretch.assign(8, {10.0, 0.35});
    model.ties.resize(8);
    for (Tie& tie : model.ties) {
        tie.normal = Vec3(unit(random), unit(random), 2.0).normalized();
        const Vec3 a = tie.normal.unitOrthogonal();
        tie.curvature = 0.05 * a * a.transpose();
        tie.thickness = 40.0;
        tie.tether = 3.0;
        tie.anchor = 1.0;
        tie.stop = 0.3;
    }
    model.contacts.push_back({2, 5, Vec3::UnitY(), 300.0, -0.1});
    model.linear.start.clear();
    model.linear.start.push_back(0);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Random(8, 8);
    dense = dense * dense.transpose();
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            model.linear.column.push_back(j);
            model.linear.value.push_back(dense(i, j));
        }
        model.linear.start.push_back(static_cast<int>(model.linear.column.size()));
    }
    model.layer.links = model.linear;
    index_rows(model);
    return model;
}

struct Disturbed {
    MassSpringModel model = everything();
    MassSpringState state = rest_state(model);
    Drive drive;

    Disturbed() {
        std::srand(3);
        state.positions += 1.5 * Points::Random(3, 8);
        state.layer = 0.4 * Points::Random(3, 8);
        drive.shift = Points::Random(3, 8);
        drive.height = Eigen::VectorXd::Random(8);
        drive.tether_boost = Eigen::VectorXd::Constant(8, 2.0);
        drive.length_factor.assign(model.springs.size(), 0.8);
        drive.stiffness_factor.assign(model.springs.size(), 1.7);
        drive.load = Points::Random(3, 8);
        drive.layer_load = Points::Random(3, 8);
        drive.gravity = Vec3(0.0, -9810.0, 0.0);
    }
};

TEST(Forces, AreTheNegativeGradientOfTheEnergy) {
    Disturbed d;
    const Points forces = total_forces(d.model, d.state, d.drive, false);
    const double scale = forces.cwiseAbs().maxCoeff();
    constexpr double kStep = 1e-5;
    for (int i = 0; i < 8; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            MassSpringState ahead = d.state;
            MassSpringState behind = d.state;
            ahead.positions(axis, i) += kStep;
            behind.positions(axis, i) -= kStep;
            const double slope = (potential_energy(d.model, ahead, d.drive) -
                                  potential_energy(d.model, behind, d.drive)) /
                                 (2.0 * kStep);
            EXPECT_NEAR(forces(axis, i), -slope, 1e-6 * scale) << i << " " << axis;
        }
    }
}

TEST(Forces, OnTheMuscleLayerAreTheNegativeGradientToo) {
    Disturbed d;
    const Points forces = layer_forces(d.model, d.state, d.drive);
    const double scale = forces.cwiseAbs().maxCoeff();
    constexpr double kStep = 1e-5;
    for (int i = 0; i < 8; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            MassSpringState ahead = d.state;
            MassSpringState behind = d.state;
            ahead.layer(axis, i) += kStep;
            behind.layer(axis, i) -= kStep;
            const double slope = (potential_energy(d.model, ahead, d.drive) -
                                  potential_energy(d.model, behind, d.drive)) /
                                 (2.0 * kStep);
            EXPECT_NEAR(forces(axis, i), -slope, 1e-6 * scale);
        }
    }
}

TEST(Forces, OfAWholeFaceAreTheNegativeGradientOfItsEnergy) {
    const auto face = test::small_model();
    const FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    MassSpringState state = rest_state(system.model);
    std::srand(5);
    state.positions += 0.3 * Points::Random(3, system.model.node_count());
    const Points forces = total_forces(system.model, state, {}, false);
    // Along a few random directions of the whole state.
    for (int k = 0; k < 4; ++k) {
        const Points direction = Points::Random(3, system.model.node_count());
        constexpr double kStep = 1e-6;
        MassSpringState ahead = state;
        MassSpringState behind = state;
        ahead.positions += kStep * direction;
        behind.positions -= kStep * direction;
        const double slope = (potential_energy(system.model, ahead, {}) -
                              potential_energy(system.model, behind, {})) /
                             (2.0 * kStep);
        const double work = forces.cwiseProduct(direction).sum();
        EXPECT_NEAR(work, -slope, 1e-6 * forces.norm() * direction.norm() / 50.0);
    }
}

TEST(SpringForces, FollowHookeWhenStretched) {
    MassSpringModel model = test::spring_row(2, 50.0, 10.0, 1.0);
    MassSpringState state = rest_state(model);
    state.positions(0, 1) = 12.0;
    const Points forces = spring_forces(model, state, Vec3::Zero());
    EXPECT_NEAR(forces(0, 0), 100.0, 1e-9);  // mN
    EXPECT_NEAR(forces(0, 1), -100.0, 1e-9);
}

TEST(SpringForces, HoldDampingAndGravityAsEquationOneSays) {
    MassSpringModel model = test::spring_row(2, 0.0, 10.0, 2.0, 3.0);
    MassSpringState state = rest_state(model);
    state.velocities.col(1) << 4.0, 0.0, 0.0;
    const Points forces = spring_forces(model, state, {0.0, -10.0, 0.0});
    EXPECT_NEAR(forces(0, 0), 12.0, 1e-12);
    EXPECT_NEAR(forces(0, 1), -12.0, 1e-12);
    EXPECT_NEAR(forces(1, 0), -20.0, 1e-12);
}

TEST(SpringForces, AreFiniteForCoincidentEnds) {
    MassSpringModel model = test::spring_row(2, 50.0, 10.0, 1.0, 1.0);
    MassSpringState state = rest_state(model);
    state.positions.setZero();
    EXPECT_TRUE(spring_forces(model, state, Vec3::Zero()).allFinite());
    EXPECT_TRUE(total_forces(model, state, {}, true).allFinite());
}

TEST(SpringForces, ConserveMomentumWithoutAnchors) {
    MassSpringModel model = test::spring_row(20, 80.0, 2.0, 1e-3, 0.01);
    MassSpringState state = rest_state(model);
    std::srand(1);
    state.positions += Points::Random(3, 20);
    state.velocities = 100.0 * Points::Random(3, 20);
    const Vec3 net = spring_forces(model, state, Vec3::Zero()).rowwise().sum();
    EXPECT_LT(net.norm(), 1e-9);
    const Vec3 damped = total_forces(model, state, {}, true).rowwise().sum();
    EXPECT_LT(damped.norm(), 1e-9);
}

TEST(SpringForces, AgreeWithTheWholeModelsSprings) {
    MassSpringModel model = test::spring_row(12, 80.0, 2.0, 1e-3, 0.02);
    MassSpringState state = rest_state(model);
    std::srand(2);
    state.positions += Points::Random(3, 12);
    state.velocities = Points::Random(3, 12);
    EXPECT_TRUE(spring_forces(model, state, Vec3::Zero())
                    .isApprox(total_forces(model, state, {}, true), 1e-12));
}

TEST(TotalForces, VanishOnTheRestingFaceUnderGravity) {
    const auto face = test::small_model();
    FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    system.model.rest_gravity = Vec3(0.0, -9810.0, 0.0);
    Drive drive;
    drive.gravity = system.model.rest_gravity;
    const Points forces = total_forces(system.model, rest_state(system.model), drive, true);
    EXPECT_EQ(forces.cwiseAbs().maxCoeff(), 0.0);
}

TEST(TotalForces, HaveTheSameBitsForAnyNumberOfThreads) {
    const auto face = test::small_model();
    const FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    MassSpringState state = rest_state(system.model);
    std::srand(9);
    state.positions += 0.5 * Points::Random(3, system.model.node_count());
    const int before = thread_count();
    set_thread_count(1);
    const Points one = total_forces(system.model, state, {}, false);
    set_thread_count(4);
    const Points four = total_forces(system.model, state, {}, false);
    set_thread_count(before);
    EXPECT_EQ(one, four);
}

TEST(Bending, DoesNotResistMovingOrTurningAFlatPatchAsAWhole) {
    // The hinge matrix has the linear functions in its kernel.
    const auto face = test::small_model();
    const FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    const MassSpringModel& model = system.model;
    double worst = 0.0;
    for (int i = 0; i < model.node_count(); ++i) {
        double row = 0.0;
        double size = 0.0;
        for (int e = model.linear.start[i]; e < model.linear.start[i + 1]; ++e) {
            row += model.linear.value[e];
            size += std::abs(model.linear.value[e]);
        }
        worst = std::max(worst, std::abs(row) / std::max(size, 1e-12));
    }
    EXPECT_LT(worst, 1e-10);
}

TEST(Validate, NamesTheFault) {
    MassSpringModel model = test::spring_row(3, 50.0, 10.0, 1.0);
    EXPECT_NO_THROW(validate(model));
    model.mass[1] = 0.0;
    EXPECT_THROW(validate(model), InvalidInput);
    model = test::spring_row(3, -1.0, 10.0, 1.0);
    EXPECT_THROW(validate(model), InvalidInput);
}

}  // namespace
}  // namespace myoface
