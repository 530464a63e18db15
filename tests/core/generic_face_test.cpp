// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/generic_face.h"

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/weld.h"

#include "test_meshes.h"

namespace myoface {
namespace {

TEST(GenericFace, HasAboutTheWantedNumberOfVertices) {
    for (const int wanted : {3000, 12000, 60000}) {
        GenericFaceOptions options;
        options.vertices = wanted;
        const int got = make_generic_face(options).scan.mesh.vertex_count();
        EXPECT_NEAR(static_cast<double>(got) / wanted, 1.0, 0.15) << wanted;
    }
}

TEST(GenericFace, IsClosedButForEyesAndMouth) {
    for (const int wanted : {3000, 12000}) {
        GenericFaceOptions options;
        options.vertices = wanted;
        const WeldedMesh welded = weld(make_generic_face(options).scan.mesh);
        const Adjacency adjacency(welded.mesh);
        EXPECT_EQ(boundary_loops(welded.mesh, adjacency).size(), 3U);
        EXPECT_EQ(connected_components(welded.mesh).count, 3);  // head and two eyeballs
        int wrong = 0;
        for (const MeshEdge& edge : adjacency.edges()) {
            wrong += edge.triangle_count > 2;
        }
        EXPECT_EQ(wrong, 0);
        // Euler: the head has three openings, each eyeball none.
        EXPECT_EQ(welded.mesh.vertex_count() - static_cast<int>(adjacency.edges().size()) +
                      welded.mesh.triangle_count(),
                  2 - 3 + 2 + 2);
    }
}

TEST(GenericFace, IsSymmetric) {
    const Scan& scan = test::small_face().scan;
    const Bvh bvh(scan.mesh);
    for (int v = 0; v < scan.mesh.vertex_count(); v += 7) {
        Vec3 other = scan.mesh.vertices.col(v);
        other.x() = -other.x();
        EXPECT_LT(bvh.closest_point(scan.mesh, other).distance, 1e-9);
    }
}

TEST(GenericFace, GivesTheSameBitsTwice) {
    const GenericFace again = [] {
        GenericFaceOptions options;
        options.vertices = 4000;
        return make_generic_face(options);
    }();
    EXPECT_EQ(again.scan.mesh.vertices, test::small_face().scan.mesh.vertices);
}

TEST(GenericFace, HasItsLandmarksOnTheSkin) {
    GenericFaceOptions options;
    options.vertices = 20000;
    const GenericFace face = make_generic_face(options);
    const Bvh bvh(face.scan.mesh);
    EXPECT_EQ(face.landmarks.size(), landmark_names().size());
    for (const auto& [name, landmark] : face.landmarks) {
        EXPECT_LT(bvh.closest_point(face.scan.mesh, landmark.position).distance, 1.0) << name;
    }
}

TEST(GenericFace, FollowsSexAndSeed) {
    GenericFaceOptions options;
    options.vertices = 3000;
    options.sex = Sex::Female;
    const GenericFace female = make_generic_face(options);
    options.sex = Sex::Male;
    const GenericFace male = make_generic_face(options);
    const auto height = [](const GenericFace& f) {
        return (f.landmarks.at("n").position - f.landmarks.at("gn").position).norm();
    };
    EXPECT_GT(height(male), height(female) + 3.0);
    options.seed = 7;
    const GenericFace seven = make_generic_face(options);
    options.seed = 8;
    EXPECT_NE(make_generic_face(options).scan.mesh.vertices, seven.scan.mesh.vertices);
    options.seed = 7;
    EXPECT_EQ(make_generic_face(options).scan.mesh.vertices, seven.scan.mesh.vertices);
}

TEST(GenericFace, RefusesImpossibleWishes) {
    GenericFaceOptions options;
    options.vertices = 10;
    EXPECT_THROW(make_generic_face(options), InvalidInput);
    options.vertices = 5000;
    options.age = -1.0;
    EXPECT_THROW(make_generic_face(options), InvalidInput);
}

TEST(GenericFace, CanBeCancelled) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(make_generic_face({}, &progress), Cancelled);
}

}  // namespace
}  // namespace myoface
