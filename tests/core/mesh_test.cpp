// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include <gtest/gtest.h>

#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/cross_section.h"
#include "myoface/mesh/cut.h"
#include "myoface/mesh/diffusion.h"
#include "myoface/mesh/geodesic.h"
#include "myoface/mesh/isosurface.h"
#include "myoface/mesh/normals.h"
#include "myoface/mesh/remesh.h"
#include "myoface/mesh/weld.h"

#include "test_meshes.h"

namespace myoface {
namespace {

using test::grid;
using test::sphere;

TEST(Adjacency, CountsTheEdgesOfAClosedSurfaceByEuler) {
    const TriangleMesh mesh = sphere(10.0);
    const Adjacency adjacency(mesh);
    EXPECT_EQ(
        mesh.vertex_count() - static_cast<int>(adjacency.edges().size()) + mesh.triangle_count(),
        2);
    for (const MeshEdge& edge : adjacency.edges()) {
        EXPECT_EQ(edge.triangle_count, 2);
    }
}

TEST(Adjacency, KnowsNeighboursAndTrianglesOfAVertex) {
    const TriangleMesh mesh = grid(3);
    const Adjacency adjacency(mesh);
    EXPECT_EQ(adjacency.neighbours(4).size(), 6U);  // the middle one, two diagonals
    EXPECT_EQ(adjacency.triangles(4).size(), 6U);
    EXPECT_EQ(adjacency.neighbours(0).size(), 3U);
}

TEST(BoundaryLoops, AreFoundLongestFirst) {
    TriangleMesh mesh = test::together(grid(3), grid(5));
    const auto loops = boundary_loops(mesh, Adjacency(mesh));
    ASSERT_EQ(loops.size(), 2U);
    EXPECT_EQ(loops[0].size(), 16U);
    EXPECT_EQ(loops[1].size(), 8U);
}

TEST(BoundaryLoops, AreAbsentOnAClosedSurface) {
    const TriangleMesh mesh = sphere(1.0);
    EXPECT_TRUE(boundary_loops(mesh, Adjacency(mesh)).empty());
}

TEST(Components, AreCountedAndNumberedBySmallestVertex) {
    const Components parts = connected_components(test::together(grid(3), sphere(2.0)));
    EXPECT_EQ(parts.count, 2);
    EXPECT_EQ(parts.of_vertex.front(), 0);
    EXPECT_EQ(parts.of_vertex.back(), 1);
}

TEST(VertexNormals, PointOutwardOnASphere) {
    const TriangleMesh mesh = sphere(10.0, 40, 60);
    const Points normals = vertex_normals(mesh, Adjacency(mesh));
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_GT(normals.col(v).dot(mesh.vertices.col(v).normalized()), 0.999);
    }
}

TEST(SignedVolume, OfASphereIsThatOfASphere) {
    const double exact = 4.0 / 3.0 * std::numbers::pi * 1000.0;
    EXPECT_NEAR(signed_volume(sphere(10.0, 80, 120)) / exact, 1.0, 2e-3);
}

TEST(VertexAreas, SumToTheSurface) {
    EXPECT_NEAR(vertex_areas(grid(11, 0.5)).sum(), 25.0, 1e-12);
}

TEST(CrossSection, OfASphereIsACircle) {
    const TriangleMesh ball = sphere(10.0, 60, 90);
    const auto cut = cross_section(ball, Vec3(0.0, 6.0, 0.0), Vec3(0.0, 2.0, 0.0));
    double around = 0.0;
    for (const auto& [a, b] : cut) {
        EXPECT_NEAR(a.y(), 6.0, 1e-9);
        EXPECT_NEAR(a.norm(), 10.0, 0.02);
        around += (b - a).norm();
    }
    EXPECT_NEAR(around, 2.0 * std::numbers::pi * 8.0, 0.1);
    EXPECT_TRUE(cross_section(ball, Vec3(0.0, 11.0, 0.0), Vec3::UnitY()).empty());
}

TEST(GeodesicDistances, ComeThroughTheEdgeTheirSourceLiesOn) {
    // Rounding puts the source to either side of the edge: what it reaches must not jump.
    TriangleMesh mesh;
    mesh.triangles.resize(3, 2);
    mesh.triangles << 0, 1, 1, 0, 2, 3;
    for (int k = 1; k < 200; ++k) {
        const Vec3 axis = Vec3(1.0, 0.3 * k, 2.0 - 0.1 * k).normalized();
        mesh.vertices.resize(3, 4);
        mesh.vertices << 0.0, 3.0, 1.2, 1.9, 0.0, 0.0, 2.1, -1.7, 0.0, 0.0, 0.0, 0.0;
        mesh.vertices = Eigen::AngleAxisd(0.1 * k, axis).toRotationMatrix() * mesh.vertices;
        const double share = 0.2 + 0.003 * k;
        const Vec3 at = (1.0 - share) * mesh.vertices.col(0) + share * mesh.vertices.col(1);
        const GeodesicSource sources[] = {{0, (mesh.vertices.col(0) - at).norm()},
                                          {1, (mesh.vertices.col(1) - at).norm()}};
        const auto distance = geodesic_distances(mesh, Adjacency(mesh), sources, 10.0);
        EXPECT_NEAR(distance[2], (mesh.vertices.col(2) - at).norm(), 1e-6);
        EXPECT_NEAR(distance[3], (mesh.vertices.col(3) - at).norm(), 1e-6);
    }
}

TEST(GeodesicDistances, AreExactAlongAStraightLineOfEdges) {
    const TriangleMesh mesh = grid(11, 2.0);
    const std::vector<GeodesicSource> from{{0, 0.0}};
    const auto distance = geodesic_distances(mesh, Adjacency(mesh), from);
    EXPECT_NEAR(distance[10], 20.0, 1e-12);
    EXPECT_NEAR(distance[120], 20.0 * std::numbers::sqrt2, 1e-9);  // along the diagonals
}

TEST(GeodesicDistances, HardlyDependOnTheTriangulation) {
    // The diagonals of a grid all run the same way: along edges one diagonal would be 41 % longer.
    const TriangleMesh flat = grid(41, 1.0);
    const std::vector<GeodesicSource> middle{{20 * 41 + 20, 0.0}};
    const auto distance = geodesic_distances(flat, Adjacency(flat), middle);
    for (int v = 0; v < flat.vertex_count(); ++v) {
        const double exact = (flat.vertices.col(v) - flat.vertices.col(20 * 41 + 20)).norm();
        EXPECT_NEAR(distance[static_cast<std::size_t>(v)], exact, 1e-9 + 0.01 * exact);
    }
    const TriangleMesh ball = sphere(10.0, 40, 60);
    Eigen::Index pole = 0;
    ball.vertices.row(2).maxCoeff(&pole);
    const std::vector<GeodesicSource> top{{static_cast<int>(pole), 0.0}};
    const auto around = geodesic_distances(ball, Adjacency(ball), top);
    for (int v = 0; v < ball.vertex_count(); ++v) {
        const double exact =
            10.0 * std::acos(std::clamp(
                       ball.vertices.col(v).normalized().dot(ball.vertices.col(pole).normalized()),
                       -1.0, 1.0));
        EXPECT_NEAR(around[static_cast<std::size_t>(v)], exact, 0.01 * exact + 0.05);
    }
}

TEST(GeodesicDistances, DoNotCrossAGap) {
    const TriangleMesh two = test::together(grid(3), grid(3));
    const std::vector<GeodesicSource> from{{0, 0.0}};
    const auto distance = geodesic_distances(two, Adjacency(two), from);
    EXPECT_TRUE(std::isinf(distance[9]));
}

TEST(GeodesicDistances, CountWeightedWaysLonger) {
    const TriangleMesh mesh = grid(3, 1.0);
    const std::vector<GeodesicSource> from{{0, 0.0}};
    const auto distance =
        geodesic_distances(mesh, Adjacency(mesh), from, 100.0, [](int) { return 2.5; });
    EXPECT_NEAR(distance[2], 5.0, 1e-12);
}

TEST(Weld, JoinsSeamsAndDropsWhatHasNoArea) {
    TriangleMesh mesh = test::together(grid(2), grid(2));  // the same square twice, 8 vertices
    mesh.triangles.conservativeResize(3, 5);
    mesh.triangles.col(4) << 0, 0, 1;
    const WeldedMesh welded = weld(mesh);
    EXPECT_EQ(welded.mesh.vertex_count(), 4);
    EXPECT_EQ(welded.mesh.triangle_count(), 2);
    EXPECT_EQ(welded.degenerate, 1);
    EXPECT_EQ(welded.duplicates, 2);
    EXPECT_EQ(welded.of_vertex[0], welded.of_vertex[4]);
}

TEST(Isosurface, OfABallIsClosedAndRound) {
    const TriangleMesh mesh =
        isosurface([](const Vec3& p) { return p.norm() - 10.0; },
                   Eigen::AlignedBox3d(Vec3::Constant(-13.0), Vec3::Constant(13.0)), 1.0);
    const Adjacency adjacency(mesh);
    EXPECT_TRUE(boundary_loops(mesh, adjacency).empty());
    EXPECT_EQ(
        mesh.vertex_count() - static_cast<int>(adjacency.edges().size()) + mesh.triangle_count(),
        2);
    EXPECT_GT(signed_volume(mesh), 0.0);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_NEAR(mesh.vertices.col(v).norm(), 10.0, 0.06);
    }
}

TEST(Remesh, GivesEvenTrianglesOfTheWantedSize) {
    const TriangleMesh rough =
        isosurface([](const Vec3& p) { return p.norm() - 10.0; },
                   Eigen::AlignedBox3d(Vec3::Constant(-13.0), Vec3::Constant(13.0)), 1.5);
    RemeshOptions options;
    options.edge_length = [](const Vec3&) { return 2.0; };
    options.project = [](const Vec3& p, int) { return Vec3(10.0 * p.normalized()); };
    const TriangleMesh even = remesh(rough, options).mesh;
    const Adjacency adjacency(even);
    EXPECT_TRUE(boundary_loops(even, adjacency).empty());
    double sum = 0.0;
    for (const MeshEdge& edge : adjacency.edges()) {
        EXPECT_EQ(edge.triangle_count, 2);
        const double length =
            (even.vertices.col(edge.vertices[0]) - even.vertices.col(edge.vertices[1])).norm();
        EXPECT_GT(length, 0.7);
        EXPECT_LT(length, 3.5);
        sum += length;
    }
    EXPECT_NEAR(sum / static_cast<double>(adjacency.edges().size()), 2.0, 0.3);
}

TEST(SplitAlongZero, PutsVerticesOnTheLineAndKeepsTheArea) {
    const TriangleMesh mesh = grid(6);
    std::vector<double> values;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        values.push_back(mesh.vertices(0, v) - 2.3);
    }
    const SplitMesh split = split_along_zero(
        mesh, values, std::vector<bool>(static_cast<std::size_t>(mesh.vertex_count()), true));
    EXPECT_NEAR(vertex_areas(split.mesh).sum(), 25.0, 1e-12);
    for (std::size_t v = 36; v < split.values.size(); ++v) {
        EXPECT_NEAR(split.mesh.vertices(0, static_cast<Eigen::Index>(v)), 2.3, 1e-12);
    }
}

TEST(Diffusion, SmoothsTheSameOnCoarseAndFineMeshes) {
    // A bump of 4 mm on a plane: its height after smoothing must not depend on the mesh.
    std::vector<double> heights;
    for (const int n : {41, 81}) {
        TriangleMesh mesh = grid(n, 80.0 / (n - 1));
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            const double r2 = (mesh.vertices.col(v) - Vec3(40.0, 40.0, 0.0)).squaredNorm();
            mesh.vertices(2, v) = 4.0 * std::exp(-r2 / 50.0);
        }
        const Diffusion diffusion(mesh, Adjacency(mesh), 11.4);
        heights.push_back(diffusion.apply(mesh.vertices, 2).row(2).maxCoeff());
    }
    EXPECT_LT(heights[0], 3.2);
    EXPECT_NEAR(heights[0] / heights[1], 1.0, 0.03);
}

}  // namespace
}  // namespace myoface
