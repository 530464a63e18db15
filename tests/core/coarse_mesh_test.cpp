// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/coarse_mesh.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "myoface/mesh/adjacency.h"

#include "test_meshes.h"

namespace myoface {
namespace {

Eigen::VectorXf everywhere(const TriangleMesh& mesh, float spacing) {
    return Eigen::VectorXf::Constant(mesh.vertex_count(), spacing);
}

Vec3 carried(const CoarseMesh& coarse, int fine) {
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3 && coarse.between(k, fine) >= 0; ++k) {
        sum += static_cast<double>(coarse.shares(k, fine)) *
               coarse.mesh.vertices.col(coarse.between(k, fine));
    }
    return sum;
}

TEST(CoarseMesh, KeepsTheSurfaceAndItsTopology) {
    const TriangleMesh fine = test::sphere(40.0, 60, 90);
    const CoarseMesh coarse = coarsen(fine, everywhere(fine, 4.0F));
    EXPECT_LT(coarse.mesh.vertex_count(), fine.vertex_count() / 2);
    const Adjacency after(coarse.mesh);
    EXPECT_EQ(connected_components(coarse.mesh).count, connected_components(fine).count);
    for (const MeshEdge& edge : after.edges()) {
        EXPECT_EQ(edge.triangle_count, 2);
    }
    EXPECT_EQ(coarse.mesh.vertex_count() - static_cast<int>(after.edges().size()) +
                  coarse.mesh.triangle_count(),
              2);
    for (std::size_t k = 0; k < coarse.fine.size(); ++k) {
        EXPECT_EQ(Vec3(coarse.mesh.vertices.col(static_cast<Eigen::Index>(k))),
                  Vec3(fine.vertices.col(coarse.fine[k])));
    }
    double farthest = 0.0;
    for (int v = 0; v < fine.vertex_count(); ++v) {
        EXPECT_NEAR(coarse.shares.col(v).sum(), 1.0F, 1e-5F);
        farthest = std::max(farthest, (carried(coarse, v) - fine.vertices.col(v)).norm());
    }
    EXPECT_LT(farthest, 4.0);
}

TEST(CoarseMesh, CarriesWhatIsLinearOnAPlaneExactly) {
    const TriangleMesh fine = test::grid(41, 1.0);
    const CoarseMesh coarse = coarsen(fine, everywhere(fine, 3.0F));
    int inside = 0;
    for (int v = 0; v < fine.vertex_count(); ++v) {
        const Vec3 p = fine.vertices.col(v);
        const bool border = (p.head<2>().array() < 4.0).any() || (p.head<2>().array() > 36.0).any();
        if (!border) {
            EXPECT_LT((carried(coarse, v) - p).norm(), 1e-4) << v;
            ++inside;
        }
    }
    EXPECT_GT(inside, 800);
}

TEST(CoarseMesh, FollowsTheBorder) {
    const TriangleMesh fine = test::grid(41, 1.0);
    const CoarseMesh coarse = coarsen(fine, everywhere(fine, 3.0F));
    const auto loops = boundary_loops(coarse.mesh, Adjacency(coarse.mesh));
    ASSERT_EQ(loops.size(), 1U);
    for (const int v : loops[0]) {
        const Vec3 p = coarse.mesh.vertices.col(v);
        const double off = std::min({p.x(), p.y(), 40.0 - p.x(), 40.0 - p.y()});
        EXPECT_LT(off, 1e-9);
    }
}

TEST(CoarseMesh, HasTheVerticesThatAreKept) {
    const TriangleMesh fine = test::grid(21, 1.0);
    const std::vector<int> kept{210, 211, 5};
    const CoarseMesh coarse = coarsen(fine, everywhere(fine, 4.0F), kept);
    for (const int v : kept) {
        EXPECT_NE(std::find(coarse.fine.begin(), coarse.fine.end(), v), coarse.fine.end());
        EXPECT_EQ(coarse.between(1, v), -1);
    }
    EXPECT_TRUE(std::is_sorted(coarse.fine.begin(), coarse.fine.end()));
}

TEST(CoarseMesh, KeepsSheetsApartThatLieNear) {
    const TriangleMesh one = test::grid(21, 1.0);
    const int n = one.vertex_count();
    TriangleMesh above = one;
    above.vertices.row(2).array() += 0.05;
    const TriangleMesh both = test::together(one, above);
    const CoarseMesh coarse = coarsen(both, everywhere(both, 3.0F));
    for (int v = 0; v < 2 * n; ++v) {
        for (int k = 0; k < 3 && coarse.between(k, v) >= 0; ++k) {
            const int seed = coarse.fine[static_cast<std::size_t>(coarse.between(k, v))];
            EXPECT_EQ(seed < n, v < n);
        }
    }
}

TEST(CoarseMesh, DoesNotDependOnTheOrderOfTriangles) {
    const TriangleMesh fine = test::grid(31, 1.0);
    TriangleMesh turned = fine;
    turned.triangles = fine.triangles.rowwise().reverse();
    const CoarseMesh a = coarsen(fine, everywhere(fine, 2.5F));
    const CoarseMesh b = coarsen(turned, everywhere(fine, 2.5F));
    EXPECT_EQ(a.fine, b.fine);
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
}

}  // namespace
}  // namespace myoface
