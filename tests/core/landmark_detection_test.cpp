// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/landmark_detection.h"

#include <algorithm>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/cases/case_file.h"
#include "myoface/face/generic_face.h"
#include "myoface/io/mesh_file.h"
#include "myoface/muscle/expression.h"
#include "myoface/sim/simulator.h"

#include "no_faces.h"
#include "spoiled_scan.h"
#include "test_meshes.h"
#include "thorough.h"

namespace myoface {
namespace {

/// Distances of what was found from the truth, of the points that the front of a face has.
std::vector<double> errors(const Landmarks& found, const Landmarks& truth) {
    std::vector<double> result;
    for (const char* name :
         {"prn", "sn", "en_l", "en_r", "ex_l", "ex_r", "ch_l", "ch_r", "ls", "li", "sto", "pg"}) {
        const auto at = found.find(name);
        result.push_back(
            at == found.end() ? 99.0 : (at->second.position - truth.at(name).position).norm());
    }
    std::sort(result.begin(), result.end());
    return result;
}

TEST(LandmarkDetection, FindsThoseOfTheAverageHead) {
    const auto found = detect_landmarks(test::small_face().scan.mesh);
    const auto error = errors(found.landmarks, test::small_face().landmarks);
    EXPECT_LT(error[error.size() / 2], 1.5);
    EXPECT_LT(error.back(), 5.0);
    EXPECT_GT(found.confidence, 0.8);
}

TEST(LandmarkDetection, FindsThoseOfOthersInAnyTurn) {
    std::mt19937 random(17);
    std::normal_distribution<double> normal;
    std::vector<double> all;
    for (const std::uint32_t seed : {21U, 22U, 23U, 24U, 25U, 26U}) {
        GenericFaceOptions options;
        options.vertices = 5000;
        options.seed = seed;
        options.sex = seed % 2 == 0 ? Sex::Female : Sex::Male;
        const GenericFace face = make_generic_face(options);
        const Mat3 turn =
            Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                .normalized()
                .toRotationMatrix();
        TriangleMesh mesh = face.scan.mesh;
        Landmarks truth = face.landmarks;
        mesh.vertices = (turn * mesh.vertices).eval();
        for (auto& [name, landmark] : truth) {
            landmark.position = turn * landmark.position;
        }
        const auto error = errors(detect_landmarks(mesh).landmarks, truth);
        all.insert(all.end(), error.begin(), error.end());
    }
    std::sort(all.begin(), all.end());
    EXPECT_LT(all[all.size() / 2], 2.5);
    EXPECT_LT(all[all.size() * 9 / 10], 6.0);
}

TEST(LandmarkDetection, FindsThemOnSpoiledScansAndKnowsHowWell) {
    std::vector<double> all;
    int within = 0;
    for (std::uint32_t seed = 1; seed <= (test::thorough() ? 30U : 6U); ++seed) {
        const test::SpoiledScan scan = test::spoiled_scan(seed);
        const DetectedLandmarks found = detect_landmarks(scan.mesh);
        EXPECT_GT(found.confidence, 0.5) << scan.story;
        for (const char* name : {"prn", "sn", "en_l", "en_r", "ex_l", "ex_r", "ch_l", "ch_r", "ls",
                                 "li", "sto", "pg"}) {
            const auto at = found.landmarks.find(name);
            ASSERT_NE(at, found.landmarks.end()) << name << ' ' << scan.story;
            const double error =
                scan.unit * (at->second.position - scan.truth.at(name).position).norm();
            all.push_back(error);
            within += error < 2.0 * scan.unit * at->second.error_mm ? 1 : 0;
        }
    }
    std::sort(all.begin(), all.end());
    EXPECT_LT(all[all.size() / 2], 1.5);
    EXPECT_LT(all[all.size() * 95 / 100], 6.5);
    EXPECT_GE(within, static_cast<int>(all.size() * 95 / 100));
}

TEST(LandmarkDetection, RefusesWhatIsNoFace) {
    const std::vector<test::NoFace> things = test::no_faces();
    for (std::size_t k = 0; k < things.size(); k += test::thorough() ? 1 : 3) {
        const test::NoFace& thing = things[k];
        EXPECT_THROW(detect_landmarks(thing.mesh), InvalidInput) << thing.name;
    }
}

TEST(LandmarkDetection, SaysThatAnOpenMouthLeavesItUnsure) {
    const auto face = test::small_model();
    Simulator simulator(face);
    std::vector<double> rates(face->muscles.size(), 0.0);
    add_expression(rates, expression_named("jaw_open"), 1.0);
    for (std::size_t m = 0; m < rates.size(); ++m) {
        simulator.set_contraction(static_cast<int>(m), rates[m]);
    }
    simulator.step(300);
    TriangleMesh mesh = face->scan->mesh;
    mesh.vertices = simulator.scan_vertices();
    const Landmarks open = detect_landmarks(mesh).landmarks;
    const Landmarks closed = detect_landmarks(face->scan->mesh).landmarks;
    // Where the lips no longer meet there may be no such point at all.
    EXPECT_TRUE(open.count("sto") == 0 ||
                open.at("sto").error_mm > 2.0 * closed.at("sto").error_mm);
    EXPECT_GT(open.at("pg").error_mm, 1.5 * closed.at("pg").error_mm);
    EXPECT_LT(open.at("en_l").error_mm, 0.8 * open.at("pg").error_mm);
}

TEST(LandmarkDetection, MakesAScanWithoutLandmarksAFace) {
    const test::TemporaryFolder folder;
    const Scan& scan = test::small_face().scan;
    write_mesh(folder / "a.obj", scan, scan.mesh.vertices);
    OpenedFace face = open_face((folder / "a.obj").string());
    ASSERT_FALSE(face.landmarks.has_value());
    EXPECT_TRUE(find_missing_landmarks(face));
    EXPECT_TRUE(face.landmarks_detected);
    EXPECT_EQ(make_simulator(face)->face().muscles.size(), muscle_atlas().size());

    write_mesh(folder / "ball.obj", test::scan_of(test::sphere(100.0)),
               test::sphere(100.0).vertices);
    OpenedFace ball = open_face((folder / "ball.obj").string());
    EXPECT_FALSE(find_missing_landmarks(ball));
    EXPECT_THROW(make_simulator(ball), InvalidInput);
}

}  // namespace
}  // namespace myoface
