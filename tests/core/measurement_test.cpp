// SPDX-License-Identifier: Apache-2.0
#include "myoface/measure/measurement.h"

#include <cmath>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/measure/result_comparison.h"
#include "myoface/muscle/weakening.h"

#include "test_meshes.h"

namespace myoface {
namespace {

TEST(Measurement, OfAFaceAtTwoMomentsAgreesWithItsLandmarks) {
    const auto face = test::small_model();
    const LandmarksOnSkin places(face);
    const Points& before = face->skin.mesh.vertices;
    Points now = before;
    now.row(2).array() *= 1.1;  // everything deeper by a tenth
    const std::vector<Measurement> rows = measure_all(places, before, now, Population());
    EXPECT_EQ(rows.size(), all_measures().size());
    std::set<std::string> ids;
    for (const Measurement& row : rows) {
        ids.insert(row.measure.id);
        ASSERT_TRUE(row.other);
        EXPECT_TRUE(std::isfinite(row.value) && std::isfinite(*row.other));
        if (row.measure.kind != MeasureKind::Projection) {
            ASSERT_TRUE(row.norm);
            EXPECT_DOUBLE_EQ(row.value, *measured(row.measure, places.at(before)));
            EXPECT_DOUBLE_EQ(*row.other, *measured(row.measure, places.at(now)));
        }
    }
    EXPECT_EQ(ids.size(), rows.size());
}

TEST(Measurement, IsWrittenWithEveryNumber) {
    const auto face = test::small_model();
    const LandmarksOnSkin places(face);
    const Points& v = face->skin.mesh.vertices;
    const std::vector<Measurement> rows = measure_all(places, v, v, {Sex::Female, 22.0});
    const auto document = nlohmann::json::parse(
        measurements_json(rows, asymmetries(places.at(v), face->midplane), {Sex::Female, 22.0}));
    EXPECT_EQ(document["sex"], "f");
    ASSERT_EQ(document["measures"].size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_DOUBLE_EQ(document["measures"][i]["value"].get<double>(), rows[i].value);
        EXPECT_EQ(document["measures"][i].contains("z"), rows[i].norm.has_value());
    }
    const std::string csv = measurements_csv(rows);
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), rows.size() + 1);
}

TEST(Measurement, OfSidesIsNothingOnAMirrorImage) {
    Landmarks marks;
    marks["ch_l"].position = {25.0, -40.0, 80.0};
    marks["ch_r"].position = {-25.0, -40.0, 80.0};
    marks["en_l"].position = {16.0, 10.0, 70.0};
    marks["en_r"].position = {-16.0, 13.0, 74.0};
    const auto sides = asymmetries(marks, Midplane());
    ASSERT_EQ(sides.size(), 2U);
    EXPECT_NEAR(sides[0].second, 0.0, 1e-12);
    EXPECT_NEAR(sides[1].second, 5.0, 1e-12);
}

TEST(ResultComparison, FindsTheSameFaceWhereverItLies) {
    const auto face = test::small_model();
    const Points& plan = face->skin.mesh.vertices;
    // The result: the face with the nose and lips 3 mm further forward, turned and moved.
    TriangleMesh result{plan, face->skin.mesh.triangles};
    const Vec3 nose = face->landmarks.at("prn").position;
    int moved = 0;
    for (Eigen::Index v = 0; v < plan.cols(); ++v) {
        const double off = (plan.col(v) - nose).norm();
        if (off < 25.0) {
            const double share = std::pow(std::cos(off / 25.0 * 1.5707963), 2.0);
            result.vertices.col(v) += 3.0 * share * face->axes.col(2);
            ++moved;
        }
    }
    ASSERT_GT(moved, 30);
    Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
    placed.rotate(Eigen::AngleAxisd(0.4, Vec3(0.2, 1.0, -0.3).normalized()));
    placed.pretranslate(Vec3(30.0, -12.0, 55.0));
    result.vertices = (placed.linear() * result.vertices).colwise() + placed.translation();
    Landmarks marks = face->landmarks;
    for (auto& [name, landmark] : marks) {
        landmark.position = placed * landmark.position + Vec3(0.7, -0.5, 0.4);  // set by hand
    }
    const ResultComparison comparison = compare_with_result(*face, plan, result, marks);
    EXPECT_LT(comparison.registration_mm, 0.05);
    EXPECT_LT(((comparison.to_face * placed).matrix() - Eigen::Matrix4d::Identity()).norm(), 0.02);
    double most = 0.0;
    for (Eigen::Index i = 0; i < comparison.distance.size(); ++i) {
        if (std::isfinite(comparison.distance[i])) {
            most = std::max(most, comparison.distance[i]);
        }
    }
    EXPECT_GT(most, 1.8);  // the sides of the nose are nearer than its tip
    EXPECT_LT(most, 3.05);
    ASSERT_FALSE(comparison.regions.empty());
    EXPECT_EQ(comparison.regions[0].region, "whole face");
    EXPECT_GT(comparison.regions[0].share_below_2mm, 0.9);
    for (const RegionDistance& row : comparison.regions) {
        if (row.region == region_name(Region::Forehead)) {
            EXPECT_LT(row.mean_mm, 0.05);
        }
    }
    // Something else does not fit.
    const TriangleMesh ball = test::sphere(40.0);
    EXPECT_THROW(compare_with_result(*face, plan, ball, face->landmarks), InvalidInput);
}

TEST(Weakening, TakesTheSideThatIsAskedFor) {
    ASSERT_GT(weakening_presets().size(), 8U);
    for (const Weakening& preset : weakening_presets()) {
        EXPECT_FALSE(preset.strengths.empty()) << preset.name;
        for (const auto& [muscle, strength] : preset.strengths) {
            EXPECT_GE(strength, 0.0);
            EXPECT_LE(strength, 1.0);
        }
    }
    const auto strength_of = [](const Weakening& set, const char* name) {
        const int muscle = muscles_named(name)[0];
        for (const auto& [m, strength] : set.strengths) {
            if (m == muscle) {
                return strength;
            }
        }
        return 1.0;
    };
    const Weakening left = weakening_named("palsy_6.L");
    EXPECT_EQ(strength_of(left, "zygomaticus_major.L"), 0.0);
    EXPECT_EQ(strength_of(left, "zygomaticus_major.R"), 1.0);
    EXPECT_EQ(strength_of(left, "orbicularis_oris_upper"), 0.5);  // half of it is the right's
    EXPECT_EQ(strength_of(left, "masseter.L"), 1.0);              // another nerve
    EXPECT_THROW(weakening_named("palsy_9"), InvalidInput);
}

}  // namespace
}  // namespace myoface
