// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/generic_face.h"

#include <cmath>
#include <map>
#include <optional>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/io/skin_texture.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/weld.h"

#include "mesh_quality.h"
#include "test_meshes.h"
#include "thorough.h"

namespace myoface {
namespace {

/// The head's skin as it is seen: without linings, eyeballs and teeth, by their colours.
TriangleMesh outer_skin(const Scan& scan) {
    const auto lining = [&](int v) {
        const Eigen::Vector3f c = scan.colours.col(v);
        for (const Eigen::Vector3f& colour :
             {Eigen::Vector3f(0.77F, 0.53F, 0.48F), Eigen::Vector3f(0.45F, 0.19F, 0.18F)}) {
            if ((c - colour).norm() < 1e-4F) {
                return true;
            }
        }
        return false;
    };
    TriangleMesh skin{scan.mesh.vertices, Triangles(3, scan.mesh.triangle_count())};
    Eigen::Index count = 0;
    for (int t = 0; t < scan.mesh.triangle_count(); ++t) {
        const Eigen::Vector3i v = scan.mesh.triangles.col(t);
        if (scan.triangle_part[static_cast<std::size_t>(t)] == 0 && !lining(v[0]) &&
            !lining(v[1]) && !lining(v[2])) {
            skin.triangles.col(count++) = v;
        }
    }
    skin.triangles.conservativeResize(3, count);
    return skin;
}

TEST(GenericFace, HasAboutTheWantedNumberOfVertices) {
    for (const int wanted : {3000, 12000, 60000}) {
        GenericFaceOptions options;
        options.vertices = wanted;
        const int got = make_generic_face(options).scan.mesh.vertex_count();
        EXPECT_NEAR(static_cast<double>(got) / wanted, 1.0, 0.15) << wanted;
    }
}

TEST(GenericFace, IsClosedButForTheEyes) {
    for (const int wanted : {3000, 12000, 90000}) {
        GenericFaceOptions options;
        options.vertices = wanted;
        const WeldedMesh welded = weld(make_generic_face(options).scan.mesh);
        const Adjacency adjacency(welded.mesh);
        EXPECT_EQ(boundary_loops(welded.mesh, adjacency).size(), 2U);
        // Head, eyeballs, caruncles, teeth and gums; behind the lips lies a closed bag.
        constexpr int kParts = 1 + 2 + 2 + 28 + 2;
        EXPECT_EQ(connected_components(welded.mesh).count, kParts);
        int wrong = 0;
        for (const MeshEdge& edge : adjacency.edges()) {
            wrong += edge.triangle_count > 2;
        }
        EXPECT_EQ(wrong, 0);
        // Euler: the head has two openings and no handle, everything else is a ball.
        EXPECT_EQ(welded.mesh.vertex_count() - static_cast<int>(adjacency.edges().size()) +
                      welded.mesh.triangle_count(),
                  2 - 2 + 2 * (kParts - 1));
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

TEST(GenericFace, HasGoodTriangles) {
    for (const int wanted : {5000, 30000}) {
        for (const std::optional<Sex> sex : {std::optional<Sex>(), std::optional(Sex::Female)}) {
            GenericFaceOptions options;
            options.vertices = wanted;
            options.sex = sex;
            const Scan scan = make_generic_face(options).scan;
            EXPECT_EQ(scan.findings.turned_triangles, 0);
            EXPECT_FALSE(scan.findings.inward);
            EXPECT_EQ(scan.findings.degenerate_triangles, 0);
            const TriangleMesh skin = outer_skin(scan);
            for (int t = 0; t < skin.triangle_count(); ++t) {
                ASSERT_GT(test::smallest_angle(skin, t), 8.0) << wanted << ' ' << t;
            }
            EXPECT_TRUE(test::crossing_triangles(skin).empty()) << wanted;
        }
    }
}

TEST(GenericFace, MeasuresAsTheNormsSay) {
    for (const Sex sex : {Sex::Female, Sex::Male}) {
        GenericFaceOptions options;
        options.vertices = 3000;
        options.sex = sex;
        options.age = 22.0;
        const Landmarks landmarks = make_generic_face(options).landmarks;
        int within = 0;
        for (const Norm& norm : norms(sex, 22.0)) {
            const double z = (*measured(norm.measure, landmarks) - norm.mean) / norm.sd;
            EXPECT_LT(std::abs(z), norm.measure.in_degrees() ? 1.5 : 2.0) << norm.measure.id;
            within += norm.measure.kind == MeasureKind::Distance && std::abs(z) <= 1.0;
        }
        EXPECT_GE(within, 20);
    }
}

TEST(GenericFace, IndividualsSpreadAsTheNormsSay) {
    const int kPeople = test::thorough() ? 100 : 40;
    std::map<std::string, std::pair<double, double>> sums;
    for (int seed = 0; seed < kPeople; ++seed) {
        GenericFaceOptions options;
        options.vertices = 3000;
        options.sex = Sex::Male;
        options.age = 25.0;
        options.seed = static_cast<std::uint32_t>(seed);
        const Landmarks landmarks = make_generic_face(options).landmarks;
        for (const Norm& norm : norms(Sex::Male, 25.0)) {
            const double z = (*measured(norm.measure, landmarks) - norm.mean) / norm.sd;
            sums[norm.measure.id].first += z;
            sums[norm.measure.id].second += z * z;
        }
    }
    for (const auto& [id, sum] : sums) {
        const double mean = sum.first / kPeople;
        const double spread = std::sqrt(sum.second / kPeople - mean * mean);
        // Three standard errors of a mean and of a spread, and a little.
        const double error = 3.0 / std::sqrt(kPeople);
        EXPECT_LT(std::abs(mean), error + 0.03) << id;
        EXPECT_NEAR(spread, 1.0, 0.7 * error + 0.04) << id;
    }
}

TEST(GenericFace, SharesItsTrianglesBetweenPeople) {
    GenericFaceOptions options;
    options.vertices = 4000;
    const Triangles average = make_generic_face(options).scan.mesh.triangles;
    options.sex = Sex::Male;
    options.age = 80.0;
    options.seed = 3;
    options.asymmetry = 0.8;
    const GenericFace person = make_generic_face(options);
    EXPECT_EQ(person.scan.mesh.triangles, average);
    // Not a mirror image of itself any more.
    const Bvh bvh(person.scan.mesh);
    double off = 0.0;
    for (const auto& [name, landmark] : person.landmarks) {
        const Vec3 p = landmark.position;
        const Vec3 q = person.landmarks.at(mirrored_name(name)).position;
        off = std::max(off, (p - Vec3(-q.x(), q.y(), q.z())).norm());
        EXPECT_LT(bvh.closest_point(person.scan.mesh, p).distance, 2.5) << name;
    }
    EXPECT_GT(off, 0.3);
}

TEST(GenericFace, HasAPictureWithoutASeamAcrossTheFace) {
    GenericFaceOptions options;
    options.vertices = 5000;
    options.picture = 256;
    const Scan scan = make_generic_face(options).scan;
    ASSERT_EQ(scan.textures.size(), 1U);
    const auto texture = load_texture(scan);
    ASSERT_TRUE(texture);
    EXPECT_EQ(texture->image.width, 256);
    ASSERT_EQ(scan.faces.uv.size(), scan.faces.vertex.size());
    EXPECT_GE(scan.uv.minCoeff(), 0.0F);
    EXPECT_LE(scan.uv.maxCoeff(), 1.0F);
    // On the outside of the face every vertex has one place in the picture.
    std::map<int, int> place;
    for (std::size_t c = 0; c < scan.faces.vertex.size(); ++c) {
        const Vec3 p = scan.mesh.vertices.col(scan.faces.vertex[c]);
        if (p.z() > 60.0 && p.y() > -14.0 && (p - Vec3(31, 17, 78)).norm() > 20.0 &&
            (p - Vec3(-31, 17, 78)).norm() > 20.0) {
            const auto [found, fresh] = place.try_emplace(scan.faces.vertex[c], scan.faces.uv[c]);
            EXPECT_EQ(found->second, scan.faces.uv[c]);
        }
    }
    EXPECT_GT(place.size(), 200U);
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
