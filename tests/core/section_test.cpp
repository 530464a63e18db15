// SPDX-License-Identifier: Apache-2.0
// Sections, sides, volumes and soft shadows on shapes whose answers are known.
#include "myoface/measure/section.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "myoface/base/parallel.h"
#include "myoface/face/midplane.h"
#include "myoface/measure/region_distance.h"
#include "myoface/measure/symmetry.h"
#include "myoface/measure/volume.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/geodesic.h"
#include "myoface/mesh/normals.h"
#include "myoface/scene/visibility.h"

#include "test_meshes.h"

namespace myoface {
namespace {

constexpr double kPi = std::numbers::pi;

/// All lines of a section together.
std::vector<Eigen::Vector2d> points_of(const std::vector<SectionLine>& lines) {
    std::vector<Eigen::Vector2d> all;
    for (const SectionLine& line : lines) {
        all.insert(all.end(), line.begin(), line.end());
    }
    return all;
}

TEST(Section, OfABallIsACircle) {
    const auto face = test::small_model();
    // The skin blown up to a ball around a place in the head.
    const Vec3 centre = profile_plane(*face).through - 75.0 * face->axes.col(2);
    Points ball = face->skin.mesh.vertices;
    for (Eigen::Index i = 0; i < ball.cols(); ++i) {
        ball.col(i) = centre + 80.0 * (ball.col(i) - centre).normalized();
    }
    const Triangles skin = seen_skin(*face);
    for (const double height : {0.0, 30.0, -40.0}) {
        const SectionPlane plane = horizontal_plane(*face, centre + height * face->axes.col(1));
        const auto points = points_of(section(*face, skin, ball, plane));
        ASSERT_GT(points.size(), 60U);
        const double radius = std::sqrt(80.0 * 80.0 - height * height);
        double mean = 0.0;
        for (const Eigen::Vector2d& p : points) {
            mean += p.norm() / static_cast<double>(points.size());
        }
        EXPECT_NEAR(mean, radius, 0.005 * radius) << height;
    }
}

TEST(Section, LiesOnTheSkinAndInThePlane) {
    const auto face = test::small_model();
    const Triangles skin = seen_skin(*face);
    const Bvh bvh(face->skin.mesh);
    const Vec3 through = face->landmarks.at("sn").position;
    for (const SectionPlane& plane :
         {profile_plane(*face), horizontal_plane(*face, through), sagittal_plane(*face, through),
          free_plane(*face, through, {1.0, 0.4, -0.2})}) {
        EXPECT_NEAR(plane.normal.dot(plane.right), 0.0, 1e-9);
        EXPECT_NEAR(plane.normal.dot(plane.up), 0.0, 1e-9);
        EXPECT_NEAR(plane.right.dot(plane.up), 0.0, 1e-9);
        const auto points = points_of(section(*face, skin, face->skin.mesh.vertices, plane));
        ASSERT_GT(points.size(), 20U);
        for (const Eigen::Vector2d& p : points) {
            const Vec3 place = plane.through + p.x() * plane.right + p.y() * plane.up;
            EXPECT_LT(bvh.closest_point(face->skin.mesh, place).distance, 1e-6);
        }
    }
}

TEST(Section, SaysHowFarBeforeAndNowAreApart) {
    const auto face = test::small_model();
    const Triangles skin = seen_skin(*face);
    const SectionPlane plane = profile_plane(*face);
    const Points& before = face->skin.mesh.vertices;
    Points now = before;
    now.colwise() += Vec3(2.0 * face->axes.col(2));  // all of it 2 mm forward
    const auto was = section(*face, skin, before, plane);
    const auto is = section(*face, skin, now, plane);
    EXPECT_NEAR(largest_gap(was, is), 2.0, 0.05);
    EXPECT_EQ(largest_gap(was, was), 0.0);
    const std::string csv = section_csv(was, is);
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
              1 + points_of(was).size() + points_of(is).size());
}

TEST(SideDifferences, AreSmallOnTheSymmetricHeadAndShowASwelling) {
    const auto face = test::small_model();
    const Points& skin = face->skin.mesh.vertices;
    const Eigen::VectorXd even = side_differences(*face, skin);
    const auto rows = distances_by_region(*face, even);
    ASSERT_FALSE(rows.empty());
    EXPECT_LT(rows.front().mean_mm, 0.4);
    // The left cheek comes out by 3 mm.
    const Vec3 cheek = face->landmarks.at("ch_l").position + Vec3(18.0, 12.0, -14.0);
    const Points normals = vertex_normals(face->skin.mesh, *face->adjacency);
    Points swollen = skin;
    for (Eigen::Index i = 0; i < skin.cols(); ++i) {
        const double away = (skin.col(i) - cheek).norm();
        swollen.col(i) += 3.0 * std::exp(-away * away / (2.0 * 12.0 * 12.0)) * normals.col(i);
    }
    const Eigen::VectorXd uneven = side_differences(*face, swollen);
    EXPECT_NEAR((uneven - even).maxCoeff(), 3.0, 0.6);
    EXPECT_NEAR((uneven - even).minCoeff(), -3.0, 0.6);
    const int usual = thread_count();
    set_thread_count(1);
    EXPECT_EQ(side_differences(*face, swollen), uneven);
    set_thread_count(usual);
}

TEST(Volume, OfAGrowingBallAndOfABumpIsExact) {
    const TriangleMesh ball = test::sphere(50.0, 64, 96);
    const Points grown = 51.0 / 50.0 * ball.vertices;
    const double wanted = 4.0 / 3.0 * kPi * (51.0 * 51.0 * 51.0 - 50.0 * 50.0 * 50.0);
    EXPECT_NEAR(std::abs(swept_volume(ball.triangles, ball.vertices, grown)), wanted,
                0.005 * wanted);
    const TriangleMesh flat = test::grid(81, 1.0);
    Points bump = flat.vertices;
    const Vec3 middle = 0.5 * (bump.rowwise().minCoeff() + bump.rowwise().maxCoeff());
    const Vec3 up = double_area_vector(flat, 0).normalized();
    for (Eigen::Index i = 0; i < bump.cols(); ++i) {
        const double r = (flat.vertices.col(i) - middle).norm();
        bump.col(i) += 4.0 * std::exp(-r * r / (2.0 * 8.0 * 8.0)) * up;
    }
    const double under = 2.0 * kPi * 8.0 * 8.0 * 4.0;  // the volume under a bell
    EXPECT_NEAR(swept_volume(flat.triangles, flat.vertices, bump), under, 0.005 * under);
}

TEST(Measures, OfKnownShapesAreExact) {
    const TriangleMesh ball = test::sphere(50.0, 96, 144);
    EXPECT_NEAR(vertex_areas(ball).sum(), 4.0 * kPi * 2500.0, 0.005 * 4.0 * kPi * 2500.0);
    EXPECT_NEAR(std::abs(signed_volume(ball)), 4.0 / 3.0 * kPi * 125000.0,
                0.005 * 4.0 / 3.0 * kPi * 125000.0);
    // Along the skin from pole to pole: half a great circle.
    const Adjacency adjacency(ball);
    const std::vector<GeodesicSource> pole{{0, 0.0}};
    const std::vector<double> away = geodesic_distances(ball, adjacency, pole);
    Eigen::Index other = 0;
    (ball.vertices.colwise() - ball.vertices.col(0)).colwise().norm().maxCoeff(&other);
    EXPECT_NEAR(away[static_cast<std::size_t>(other)], kPi * 50.0, 0.01 * kPi * 50.0);
    // An angle and a distance between landmarks.
    Landmarks marks;
    marks["prn"].position = {10.0, 0.0, 0.0};
    marks["sn"].position = {0.0, 0.0, 0.0};
    marks["ls"].position = {0.0, 7.0, 0.0};
    const Measure angle{"x", "angle", MeasureKind::Angle, {"prn", "sn", "ls"}};
    EXPECT_NEAR(*measured(angle, marks), 90.0, 1e-9);
    const Measure distance{"y", "distance", MeasureKind::Distance, {"prn", "ls"}};
    EXPECT_NEAR(*measured(distance, marks), std::sqrt(149.0), 1e-9);
}

TEST(LightVisibility, LightsASmallSunkPartAsWhatIsBesideIt) {
    TriangleMesh crumb = test::sphere(1.5);
    crumb.vertices.colwise() += Vec3(0.0, 0.0, 19.2);  // most of it within the ball
    const TriangleMesh ball = test::sphere(20.0, 40, 60);
    const Eigen::Matrix4Xf open = light_visibility(test::together(ball, crumb));
    const float around = light_visibility(ball).row(3).mean();
    for (int v = ball.vertex_count(); v < static_cast<int>(open.cols()); ++v) {
        EXPECT_GT(open(3, v), 0.6F * around);
    }
}

TEST(LightVisibility, IsFullOnABallAndMissingUnderneath) {
    const Eigen::Matrix4Xf open = light_visibility(test::sphere(40.0, 24, 36));
    EXPECT_LT((open.colwise() - Eigen::Vector4f(0, 0, 0, 1)).cwiseAbs().maxCoeff(), 0.05F);
    // A floor under a ball.
    TriangleMesh ball = test::sphere(15.0, 16, 24);
    TriangleMesh floor = test::grid(41, 5.0);
    const Vec3 middle =
        0.5 * (floor.vertices.rowwise().minCoeff() + floor.vertices.rowwise().maxCoeff());
    const Vec3 up = double_area_vector(floor, 0).normalized();
    ball.vertices.colwise() += Vec3(middle + 20.0 * up);
    const TriangleMesh both = test::together(floor, ball);
    const Eigen::Matrix4Xf seen = light_visibility(both);
    const auto from_above = [&](const Vec3& place) {
        Eigen::Index nearest = 0;
        (floor.vertices.colwise() - place).colwise().squaredNorm().minCoeff(&nearest);
        return seen(3, nearest) + seen.col(nearest).head<3>().dot(up.cast<float>());
    };
    EXPECT_LT(from_above(middle), 0.45F);
    EXPECT_GT(from_above(floor.vertices.col(0)), 0.9F);
    const int usual = thread_count();
    set_thread_count(1);
    EXPECT_EQ(light_visibility(both), seen);
    set_thread_count(usual);
}

}  // namespace
}  // namespace myoface
