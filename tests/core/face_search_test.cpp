// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/face_search.h"

#include <array>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "myoface/base/parallel.h"
#include "myoface/face/generic_face.h"
#include "myoface/io/mesh_file.h"

#include "test_meshes.h"

namespace myoface {
namespace {

Mat3 any_turn(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
        .normalized()
        .toRotationMatrix();
}

double degrees(const Mat3& turn) {
    return Eigen::AngleAxisd(turn).angle() * 57.29578;
}

TEST(FaceSearch, FindsTheFaceInAnyTurnAndScale) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> exponent(-4.0, 4.0);
    for (int k = 0; k < 6; ++k) {
        TriangleMesh mesh = test::small_face().scan.mesh;
        const Mat3 turn = any_turn(random);
        const double scale = std::exp(exponent(random));
        mesh.vertices =
            (scale * turn * mesh.vertices).colwise() + Vec3(300.0 * scale, -900.0 * scale, 40.0);
        const auto pose = find_face(mesh);
        ASSERT_TRUE(pose.has_value());
        EXPECT_LT(degrees(pose->to_generic.rotation * turn), 6.0);
        EXPECT_NEAR(pose->to_generic.scale * scale, 1.0, 0.06);
        EXPECT_GT(confidence_of(*pose), 0.6);
    }
}

TEST(FaceSearch, FindsOtherPeoplesFaces) {
    std::mt19937 random(5);
    for (const std::uint32_t seed : {1U, 2U, 3U, 4U}) {
        GenericFaceOptions options;
        options.vertices = 4000;
        options.seed = seed;
        options.sex = seed % 2 == 0 ? Sex::Female : Sex::Male;
        TriangleMesh mesh = make_generic_face(options).scan.mesh;
        const Mat3 turn = any_turn(random);
        mesh.vertices = (turn * mesh.vertices).eval();
        const auto pose = find_face(mesh);
        ASSERT_TRUE(pose.has_value());
        EXPECT_LT(degrees(pose->to_generic.rotation * turn), 15.0) << seed;
        EXPECT_GT(confidence_of(*pose), 0.4) << seed;
    }
}

TEST(FaceSearch, GivesTheSameBitsForAnyNumberOfThreads) {
    const int before = thread_count();
    set_thread_count(1);
    const auto one = find_face(test::small_face().scan.mesh);
    set_thread_count(3);
    const auto three = find_face(test::small_face().scan.mesh);
    set_thread_count(before);
    ASSERT_TRUE(one && three);
    EXPECT_EQ(one->to_generic.rotation, three->to_generic.rotation);
    EXPECT_EQ(one->quality, three->quality);
}

/// A box with rounded-off nothing: no nose, no eyes.
TriangleMesh box(const Vec3& size) {
    TriangleMesh mesh = test::sphere(1.0, 40, 60);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3 p = mesh.vertices.col(v);
        mesh.vertices.col(v) = (p / p.cwiseAbs().maxCoeff()).cwiseProduct(size);
    }
    return mesh;
}

TEST(FaceSearch, IsNotSureOfThingsThatAreNoFaces) {
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0.0, 12.0);
    TriangleMesh lumps = test::sphere(100.0, 60, 90);
    for (Eigen::Index i = 0; i < lumps.vertices.size(); ++i) {
        lumps.vertices.data()[i] += noise(random);
    }
    TriangleMesh potato = test::sphere(100.0, 60, 90);
    for (int v = 0; v < potato.vertex_count(); ++v) {
        const Vec3 p = potato.vertices.col(v);
        potato.vertices.col(v) *= 1.0 +
                                  0.08 * std::sin(0.05 * p.x() + 1.0) * std::cos(0.06 * p.y()) +
                                  0.05 * std::sin(0.09 * p.z());
    }
    for (const TriangleMesh& mesh : {test::sphere(100.0, 40, 60), test::grid(60, 5.0),
                                     box({100, 100, 100}), box({30, 90, 160}), lumps, potato}) {
        const auto pose = find_face(mesh);
        EXPECT_LT(pose ? confidence_of(*pose) : 0.0, 0.3) << (pose ? pose->quality : 0.0);
    }
}

TEST(FrameGuess, NamesUnitAndAxes) {
    const GenericFace& face = test::small_face();
    const std::array<const char*, 5> turns{"+x+y+z", "+x-z+y", "-y+x+z", "-z-y-x", "+y+z+x"};
    const std::array<double, 5> units{1.0, 10.0, 100.0, 1000.0, 25.4};
    for (std::size_t k = 0; k < turns.size(); ++k) {
        const char* const axes = turns[k];
        const double mm = units[k];
        Scan scan = test::scan_of(face.scan.mesh);
        const Mat3 turn = axes_from_text(axes);
        scan.mesh.vertices = (turn.transpose() / mm * scan.mesh.vertices).eval();
        scan.file_vertices = scan.mesh.vertices;
        const auto pose = find_face(scan.mesh);
        ASSERT_TRUE(pose.has_value());
        const FrameGuess guess = guess_frame(scan, *pose);
        EXPECT_EQ(axes_to_text(guess.frame.axes), axes);
        EXPECT_EQ(guess.frame.mm_per_unit, mm);
        EXPECT_TRUE(guess.usual_unit);
    }
}

TEST(FrameGuess, SaysWhenNoUnitFits) {
    Scan scan = test::scan_of(test::small_face().scan.mesh);
    scan.mesh.vertices /= 53.2;
    scan.file_vertices = scan.mesh.vertices;
    const auto pose = find_face(scan.mesh);
    ASSERT_TRUE(pose.has_value());
    const FrameGuess guess = guess_frame(scan, *pose);
    EXPECT_FALSE(guess.usual_unit);
    EXPECT_NEAR(guess.frame.mm_per_unit, 53.2, 4.0);
}

}  // namespace
}  // namespace myoface
