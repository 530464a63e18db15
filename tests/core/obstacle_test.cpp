// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/obstacle.h"

#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "myoface/physics/build_mass_spring.h"
#include "myoface/physics/forces.h"
#include "myoface/physics/packed_model.h"
#include "myoface/sim/simulator.h"

#include "test_meshes.h"

namespace myoface {
namespace {

TEST(DistanceField, OfASphereIsTheDistanceFromIt) {
    constexpr double kRadius = 12.0;
    const DistanceField field(test::sphere(kRadius, 60, 90));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-17.0, 17.0);
    for (int k = 0; k < 500; ++k) {
        const Vec3 p(unit(random), unit(random), unit(random));
        const double expected = p.norm() - kRadius;
        EXPECT_NEAR(field.exact(p), expected, 0.02);
        if (p.norm() > 8.0) {  // the middle of a sphere is a kink
            EXPECT_NEAR(field.at(p).distance, expected, 0.09);
            EXPECT_LT((field.at(p).slope - p.normalized()).norm(), 0.2);
        }
    }
    EXPECT_GT(field.at({100.0, 0.0, 0.0}).distance, 50.0);  // beyond the lattice a bound
    EXPECT_LE(field.at({100.0, 0.0, 0.0}).distance, 88.1);
}

TEST(DistanceField, HasTheSlopeOfWhatItSays) {
    const DistanceField field(test::sphere(10.0));
    constexpr double kStep = 1e-6;
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-14.0, 14.0);
    for (int k = 0; k < 200; ++k) {
        const Vec3 p(unit(random), unit(random), unit(random));
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 off = kStep * Vec3::Unit(axis);
            const double slope =
                (field.at(p + off).distance - field.at(p - off).distance) / (2.0 * kStep);
            EXPECT_NEAR(field.at(p).slope[axis], slope, 1e-4);
        }
    }
}

TEST(DistanceField, HasNoKinks) {
    // Along a line through many cells, past sharp edges: the slope turns, it does not jump.
    const DistanceField field(test::sphere(8.0, 4, 4));
    constexpr double kStep = 1e-4;
    const Vec3 way = Vec3(0.62, 0.57, 0.54).normalized();
    Vec3 last = field.at(Vec3(-9.0, -6.0, -4.0)).slope;
    for (int k = 1; k < 150000; ++k) {
        const Vec3 slope = field.at(Vec3(-9.0, -6.0, -4.0) + k * kStep * way).slope;
        ASSERT_LT((slope - last).norm(), 5.0 * kStep) << k;
        last = slope;
    }
}

TEST(DistanceField, ReachesToItsVeryEdges) {
    const TriangleMesh surface = test::sphere(10.0, 40, 60);
    const Vec3 edge = surface.vertices.rowwise().maxCoeff().array() + 6.0;  // of its lattice
    for (const double cell : {0.7, 1.5, 4.0}) {
        const DistanceField field(surface, cell);
        for (const double x : {-1.0, 0.0, 1.0}) {
            for (const double y : {-1.0, 0.0, 1.0}) {
                for (const double z : {-1.0, 1.0}) {
                    const Vec3 p = 0.999 * edge.cwiseProduct(Vec3(x, y, z));
                    EXPECT_NEAR(field.at(p).distance, field.exact(p), 0.06 * cell * cell)
                        << cell << " " << p.transpose();
                }
            }
        }
    }
}

TEST(DistanceField, SaysTheSameWhoeverAsksFirst) {
    const TriangleMesh surface = test::sphere(10.0);
    const DistanceField alone(surface);
    const DistanceField shared(surface);
    std::vector<std::thread> threads;
    std::vector<std::vector<double>> said(4);
    for (auto& numbers : said) {
        threads.emplace_back([&] {
            for (int k = 0; k < 400; ++k) {
                numbers.push_back(shared.at({0.07 * k - 14.0, 0.02 * k, 3.0}).distance);
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (int k = 0; k < 400; ++k) {
        const double expected = alone.at({0.07 * k - 14.0, 0.02 * k, 3.0}).distance;
        for (const auto& numbers : said) {
            EXPECT_EQ(numbers[static_cast<std::size_t>(k)], expected);
        }
    }
}

/// The small face pressed against its bones, with the jaw half open.
struct PressedFace {
    PressedFace() {
        drive.gravity = system.model.rest_gravity;
        drive.obstacle_pose = obstacle_poses(*face, 0.5);
        state = rest_state(system.model);
        for (int i = 0; i < face->node_count(); ++i) {
            if (system.model.fixed[i] == 0) {
                const double depth = face->tissue[i].depth;
                state.positions.col(i) -= (depth + 1.0) * face->sliding[i].normal;
            }
        }
    }
    std::shared_ptr<const FaceModel> face = test::small_model();
    FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    Drive drive;
    MassSpringState state;
};

TEST(Barriers, PushWithTheSlopeOfTheirEnergy) {
    PressedFace pressed;
    // Only barriers: everything else is taken away.
    MassSpringModel model = pressed.system.model;
    model.springs.clear();
    model.linear = {};
    model.contacts.clear();
    model.ties.assign(model.ties.size(), Tie{});
    index_rows(model);
    const Points forces = total_forces(model, pressed.state, pressed.drive, false);
    int pushed = 0;
    for (int i = 0; i < model.skin_nodes; i += 17) {
        for (int axis = 0; axis < 3; ++axis) {
            constexpr double kStep = 1e-5;
            double energy[2];
            for (const int side : {0, 1}) {
                MassSpringState moved = pressed.state;
                moved.positions(axis, i) += side == 0 ? -kStep : kStep;
                energy[side] = potential_energy(model, moved, pressed.drive);
            }
            const double slope = (energy[1] - energy[0]) / (2.0 * kStep);
            EXPECT_NEAR(forces(axis, i), -slope, 1e-3 * std::abs(slope) + 0.5);
        }
        pushed += forces.col(i).norm() > 0.0;
    }
    EXPECT_GT(pushed, 30);
}

TEST(Barriers, PushAlikeInThePackedModel) {
    const PressedFace pressed;
    PackedModel packed(pressed.system.model);
    packed.set_drive(pressed.drive);
    const Points expected = total_forces(pressed.system.model, pressed.state, pressed.drive, false);
    EXPECT_LT((packed.forces(pressed.state.positions) - expected).norm(), 1e-5 * expected.norm());
    const Points damped = total_forces(pressed.system.model, pressed.state, pressed.drive, true);
    EXPECT_LT((packed.damped_forces(pressed.state) - damped).norm(), 1e-5 * damped.norm());
    const double energy = potential_energy(pressed.system.model, pressed.state, pressed.drive);
    EXPECT_NEAR(packed.energy(pressed.state.positions), energy, 1e-5 * energy);
}

TEST(Barriers, DoNotActAtRest) {
    const PressedFace pressed;
    const MassSpringModel& model = pressed.system.model;
    Drive upright;
    upright.gravity = model.rest_gravity;
    EXPECT_LT(total_forces(model, rest_state(model), upright, false).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Barriers, KeepSkinThatSlidesOutsideTheBone) {
    const auto face = test::small_model();
    for (const char* at : {"g", "zy_l", "go_r", "gn"}) {
        Simulator simulator(face);
        const Vec3 start = face->landmarks.at(at).position;
        DragRequest request;
        const TriangleMesh& mesh = face->skin.mesh;
        request.where = Bvh(mesh).closest_point(mesh, start).where;
        const Vec3 view = -face->axes.col(2);
        const Vec3 grip = position(mesh, request.where);
        simulator.begin_drag(request, {grip - 300.0 * view, view});
        simulator.move_drag(
            {grip + 20.0 * face->axes.col(0) - 10.0 * face->axes.col(1) - 300.0 * view, view});
        simulator.settle();
        for (int i = 0; i < face->node_count(); ++i) {
            if (face->tissue[i].tissue != Tissue::Skin || face->tissue[i].fixed) {
                continue;
            }
            for (int bone = 0; bone < 2; ++bone) {
                EXPECT_GT(face->obstacles[static_cast<std::size_t>(bone)].bone->exact(
                              simulator.state().positions.col(i)),
                          -0.2)
                    << at << " node " << i;
            }
        }
    }
}

TEST(Obstacles, StandOpenWithTheJaw) {
    const auto face = test::small_model();
    const auto poses = obstacle_poses(*face, 0.7);
    ASSERT_EQ(poses.size(), face->obstacles.size());
    const Vec3 chin = face->landmarks.at("gn").position;
    EXPECT_LT((poses[1] * chin - opened(face->jaw, 0.7, chin)).norm(), 1e-9);
    EXPECT_TRUE(poses[0].isApprox(Eigen::Isometry3d::Identity()));
    EXPECT_NEAR(poses[1].linear().determinant(), 1.0, 1e-9);
}

}  // namespace
}  // namespace myoface
