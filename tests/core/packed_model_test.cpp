// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/packed_model.h"

#include <random>

#include <gtest/gtest.h>

#include "myoface/base/parallel.h"
#include "myoface/muscle/contraction.h"
#include "myoface/physics/build_mass_spring.h"
#include "myoface/physics/forces.h"

#include "physics/packed_data.h"
#include "test_meshes.h"

namespace myoface {
namespace {

/// The small face, its muscles half contracted, every node somewhere else.
struct DisturbedFace {
    explicit DisturbedFace(double way = 1.0) {
        system.model.rest_gravity = Vec3(0.0, -9810.0, 0.0);
        const auto responses = muscle_responses(*face, system.model, ResponseForm::Smooth);
        Contractions contractions = resting(*face);
        for (double& rate : contractions.rate) {
            rate = 0.5;
        }
        drive = contraction_drive(system, responses, contractions);
        drive.gravity = Vec3(500.0, -9810.0, 0.0);
        state = rest_state(system.model);
        std::srand(5);
        state.positions += way * Points::Random(3, system.model.node_count());
        state.velocities = 30.0 * Points::Random(3, system.model.node_count());
    }

    std::shared_ptr<const FaceModel> face = test::small_model();
    FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    Drive drive;
    MassSpringState state;
};

TEST(PackedModel, HasTheForcesOfThePlainLoop) {
    const DisturbedFace d;
    PackedModel packed(d.system.model);
    packed.set_drive(d.drive);
    const Points expected = total_forces(d.system.model, d.state, d.drive, false);
    const Points forces = packed.forces(d.state.positions);
    EXPECT_LT((forces - expected).cwiseAbs().maxCoeff(), 2e-5 * expected.cwiseAbs().maxCoeff());
    // And where forces are small they are as good, not only where they are large.
    EXPECT_LT((forces - expected).norm(), 1e-5 * expected.norm());
}

TEST(PackedModel, HasTheForcesOfThePlainLoopInMotion) {
    const DisturbedFace d;
    PackedModel packed(d.system.model);
    packed.set_drive(d.drive);
    const Points expected = total_forces(d.system.model, d.state, d.drive, true);
    const Points forces = packed.damped_forces(d.state);
    EXPECT_LT((forces - expected).norm(), 1e-5 * expected.norm());
}

TEST(PackedModel, HasTheEnergyOfThePlainLoop) {
    const DisturbedFace d(0.3);
    PackedModel packed(d.system.model);
    packed.set_drive(d.drive);
    const double expected = potential_energy(d.system.model, d.state, d.drive);
    EXPECT_NEAR(packed.energy(d.state.positions), expected, 1e-5 * std::abs(expected));
}

TEST(PackedModel, GivesTheSameBitsOnEveryProcessorAndForAnyNumberOfThreads) {
    const DisturbedFace d;
    PackedModel packed(d.system.model);
    packed.set_drive(d.drive);
    const int before = thread_count();
    const Points forces = packed.forces(d.state.positions);
    const Points damped = packed.damped_forces(d.state);
    const double energy = packed.energy(d.state.positions);
    for (const int threads : {1, 2, 4}) {
        for (const bool portable : {false, true}) {
            set_thread_count(threads);
            use_kernels(portable ? &portable_kernels() : nullptr);
            EXPECT_EQ(packed.forces(d.state.positions), forces);
            EXPECT_EQ(packed.damped_forces(d.state), damped);
            EXPECT_EQ(packed.energy(d.state.positions), energy);
        }
    }
    use_kernels(nullptr);
    set_thread_count(before);
}

TEST(PackedModel, HasNoForceAtRest) {
    const DisturbedFace d;
    PackedModel packed(d.system.model);
    Drive upright;
    upright.gravity = d.system.model.rest_gravity;
    packed.set_drive(upright);
    EXPECT_EQ(packed.forces(d.system.model.rest).cwiseAbs().maxCoeff(), 0.0);
}

TEST(PackedModel, IsFiniteWhereNodesCoincide) {
    MassSpringModel model = test::spring_row(3, 50.0, 10.0, 0.01);
    PackedModel packed(model);
    EXPECT_TRUE(packed.forces(Points::Zero(3, 3)).allFinite());
    EXPECT_TRUE(std::isfinite(packed.energy(Points::Zero(3, 3))));
}

TEST(PackedModel, TakesSpringsWithoutLength) {
    MassSpringModel model = test::spring_row(3, 50.0, 10.0, 0.01);
    model.springs[1].length = 0.0;
    model.rest.col(2) = model.rest.col(1);
    index_rows(model);
    MassSpringState state = rest_state(model);
    state.positions += Points::Random(3, 3);
    EXPECT_LT(
        (PackedModel(model).forces(state.positions) - total_forces(model, state, {}, false)).norm(),
        1e-3);
}

TEST(PackedModel, TakesAnyOrderOfSprings) {
    const MassSpringModel model = test::spring_row(40, 50.0, 10.0, 0.01);
    MassSpringModel shuffled = model;
    std::mt19937 random(3);
    std::shuffle(shuffled.springs.begin(), shuffled.springs.end(), random);
    index_rows(shuffled);
    Points positions = model.rest + Points::Random(3, 40);
    EXPECT_EQ(PackedModel(model).forces(positions), PackedModel(shuffled).forces(positions));
}

}  // namespace
}  // namespace myoface
