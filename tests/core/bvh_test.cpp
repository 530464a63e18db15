// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/bvh.h"

#include <random>

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace myoface {
namespace {

Vec3 random_point(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> coordinate(-size, size);
    return {coordinate(random), coordinate(random), coordinate(random)};
}

TEST(Bvh, FindsTheClosestPointThatBruteForceFinds) {
    const TriangleMesh mesh = test::sphere(10.0);
    const Bvh bvh(mesh);
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const Vec3 query = random_point(random, 20.0);
        double least = 1e9;
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            const Vec3 w =
                closest_barycentric(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), query);
            least = std::min(least, (position(mesh, {t, w}) - query).norm());
        }
        const ClosestPoint found = bvh.closest_point(mesh, query);
        EXPECT_NEAR(found.distance, least, 1e-12);
        EXPECT_NEAR((found.point - query).norm(), found.distance, 1e-12);
    }
}

TEST(Bvh, HitsTheNearSideOfASphere) {
    const TriangleMesh mesh = test::sphere(10.0, 60, 90);
    const Bvh bvh(mesh);
    const auto hit = bvh.first_hit(mesh, {Vec3(0.3, 0.2, 50.0), -Vec3::UnitZ()});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 40.0, 0.05);
    EXPECT_FALSE(bvh.first_hit(mesh, {Vec3(0.0, 11.0, 50.0), -Vec3::UnitZ()}));
}

TEST(Bvh, FollowsAMovedMeshAfterRefit) {
    TriangleMesh mesh = test::sphere(10.0);
    Bvh bvh(mesh);
    mesh.vertices.colwise() += Vec3(100.0, 0.0, 0.0);
    bvh.refit(mesh);
    EXPECT_NEAR(bvh.closest_point(mesh, {100.0, 0.0, 30.0}).distance, 20.0, 1e-9);
}

TEST(ClosestBarycentric, IsFiniteForATriangleWithoutArea) {
    const Vec3 a(1.0, 1.0, 1.0);
    const Vec3 w = closest_barycentric(a, a, a, Vec3::Zero());
    EXPECT_TRUE(w.allFinite());
    EXPECT_NEAR(w.sum(), 1.0, 1e-12);
}

}  // namespace
}  // namespace myoface
