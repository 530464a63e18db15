// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/face/face_model.h"
#include "myoface/mesh/normals.h"
#include "myoface/sim/simulator.h"
#include "myoface/sim/snapshot.h"

#include "test_meshes.h"

namespace myoface {
namespace {

/// The small face with a skin of fewer nodes than it has vertices.
std::shared_ptr<const FaceModel> coarser_model() {
    static const auto kModel =
        fit_face(std::make_shared<const Scan>(test::small_face().scan),
                 test::small_face().landmarks, nullptr, FitOptions{.finest = 1000});
    return kModel;
}

/// The nodes, moved by a map of space.
template <typename Map>
Points moved_nodes(const FaceModel& face, const Map& map) {
    Points nodes = face.skin.mesh.vertices;
    for (Eigen::Index i = 0; i < nodes.cols(); ++i) {
        nodes.col(i) = map(Vec3(nodes.col(i)));
    }
    return nodes;
}

TEST(SimulatedSkin, IsCoarserThanAFineScan) {
    const auto face = coarser_model();
    EXPECT_TRUE(face->skin.coarse());
    EXPECT_LT(face->node_count(), test::small_model()->node_count());
    EXPECT_FALSE(test::small_model()->skin.coarse());
    EXPECT_EQ(face->scan->mesh.vertices, test::small_face().scan.mesh.vertices);
    EXPECT_GT(face->lip_contacts.size(), 5U);
}

TEST(FollowingScan, IsWhereTheScanFollowsToFrameAfterFrame) {
    for (const auto& face : {coarser_model(), test::small_model()}) {
        const Points& scan = face->scan->mesh.vertices;
        const Adjacency adjacency(face->scan->mesh);
        const Points normals = vertex_normals(face->scan->mesh, adjacency);
        FollowingScan following(face->skin, *face->adjacency, scan, normals.cast<float>());
        for (const double size : {0.0, 0.4, 0.9, 0.2, 0.0}) {
            // A bulge at one cheek; the rest of the face stays.
            const Points nodes = moved_nodes(*face, [&](const Vec3& p) {
                const double away = (p - Vec3(45, -40, 70)).squaredNorm() / 300.0;
                return Vec3(p + 8.0 * size * std::exp(-away) * Vec3(0.6, 0.2, 0.7));
            });
            const Points expected = follow(face->skin, *face->adjacency, scan, nodes);
            const Points& followed = following.follow(nodes);
            EXPECT_LT((followed - expected).cwiseAbs().maxCoeff(), 0.04);
            int untouched = 0;
            for (const char touched : following.touched()) {
                untouched += touched == 0;
            }
            EXPECT_GT(untouched, scan.cols() / 2);
            if (!face->skin.coarse()) {
                EXPECT_EQ(following.normals().cols(), 0);
                continue;
            }
            const Points turned = vertex_normals({expected, face->scan->mesh.triangles}, adjacency);
            double worst = 0.0;
            for (Eigen::Index v = 0; v < scan.cols(); ++v) {
                const Vec3 now = following.normals().col(v).cast<double>();
                const Vec3 before = normals.col(v);
                if ((followed.col(v) - scan.col(v)).norm() > 0.5) {
                    // As far off as the turn of the surface within the reach of a node.
                    worst = std::max(worst, (now - turned.col(v)).norm());
                } else if (followed.col(v) == scan.col(v)) {
                    EXPECT_LT((now - before).norm(), 0.05);
                }
            }
            EXPECT_LT(worst, 0.5);
        }
    }
}

TEST(SimulatedSkin, LeavesTheScanExactlyWhereItIsAtRest) {
    const auto face = coarser_model();
    EXPECT_EQ(scan_positions(*face, face->skin.mesh.vertices, 0.0), face->scan->mesh.vertices);
}

TEST(SimulatedSkin, CarriesTheScanRigidlyWhenAllNodesTurn) {
    const auto face = coarser_model();
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    const auto map = [&](const Vec3& p) { return Vec3(turn * p + Vec3(3, -2, 5)); };
    const Points there = scan_positions(*face, moved_nodes(*face, map), 0.0);
    double worst = 0.0;
    for (int v = 0; v < face->scan->mesh.vertex_count(); ++v) {
        if (face->skin.between(0, v) >= 0) {
            worst = std::max(worst,
                             (there.col(v) - map(Vec3(face->scan->mesh.vertices.col(v)))).norm());
        }
    }
    EXPECT_LT(worst, 0.02);  // edges that lie on one line are held a little
}

TEST(SimulatedSkin, BendsWithASmoothMotion) {
    const auto face = coarser_model();
    const auto map = [](const Vec3& p) {
        return Vec3(p + 4.0 * std::exp(-(p - Vec3(30, -30, 80)).squaredNorm() / 400.0) *
                            Vec3(0.5, 0.7, 0.3));
    };
    const Points there = scan_positions(*face, moved_nodes(*face, map), 0.0);
    double worst = 0.0;
    for (int v = 0; v < face->scan->mesh.vertex_count(); ++v) {
        if (face->skin.between(0, v) >= 0) {
            worst = std::max(worst,
                             (there.col(v) - map(Vec3(face->scan->mesh.vertices.col(v)))).norm());
        }
    }
    EXPECT_LT(worst, 0.6);
}

TEST(SimulatedSkin, KeepsAShapeWhenOtherVerticesBecomeNodes) {
    const auto face = coarser_model();
    const auto whole = test::small_model();
    const auto map = [](const Vec3& p) {
        return Vec3(p +
                    3.0 * std::exp(-(p - Vec3(0, -20, 110)).squaredNorm() / 300.0) * Vec3(0, 0, 1));
    };
    const Points shape = shape_of_scan(*face, moved_nodes(*face, map));
    EXPECT_EQ(shape.cols(), face->own_vertices);
    const Points carried = shaped_skin(*whole, shape);
    EXPECT_LT((carried - moved_nodes(*whole, map)).cwiseAbs().maxCoeff(), 0.4);
    EXPECT_TRUE(shaped_skin(*face, shape).isApprox(moved_nodes(*face, map), 1e-12));
}

TEST(SimulatedSkin, AnswersAMuscleAsTheWholeSkinDoes) {
    Simulator coarse(coarser_model());
    Simulator whole(test::small_model());
    for (Simulator* sim : {&coarse, &whole}) {
        sim->set_contraction(0, 1.0);
        sim->settle();
    }
    const Points& rest = whole.face().scan->mesh.vertices;
    const Points a = coarse.scan_vertices() - rest;
    const Points b = whole.scan_vertices() - rest;
    EXPECT_GT(b.colwise().norm().maxCoeff(), 2.0);
    EXPECT_LT((a - b).norm(), 0.15 * b.norm());
}

TEST(TissueThickness, MovesTheBoneAndNotTheSkin) {
    const auto& small = test::small_face();
    const auto scan = std::make_shared<const Scan>(small.scan);
    const auto mean = test::small_model();
    const auto heavy =
        fit_face(scan, small.landmarks, nullptr, FitOptions{.tissue = TissueThickness::Heavy});
    const auto thin =
        fit_face(scan, small.landmarks, nullptr, FitOptions{.tissue = TissueThickness::Thin});
    EXPECT_EQ(heavy->skin.mesh.vertices, mean->skin.mesh.vertices);
    double sum[3] = {0, 0, 0};
    int k = 0;
    for (const auto& face : {thin, mean, heavy}) {
        for (const TissueProperties& tissue : face->tissue) {
            sum[k] += tissue.region == Region::Cheek ? tissue.depth : 0.0;
        }
        ++k;
    }
    EXPECT_LT(sum[0], 0.85 * sum[1]);
    EXPECT_GT(sum[2], 1.15 * sum[1]);
    // The chin's bone in the midline lies deeper under more tissue.
    const auto front = [](const FaceModel& face) {
        double z = 0.0;
        for (Eigen::Index v = 0; v < face.bone.vertices.cols(); ++v) {
            const Vec3 p = face.bone.vertices.col(v);
            if (std::abs(p.x()) < 3.0 && p.y() < -75.0 && p.y() > -88.0) {
                z = std::max(z, p.z());
            }
        }
        return z;
    };
    EXPECT_LT(front(*heavy), front(*mean) - 1.0);
    EXPECT_GT(front(*thin), front(*mean) + 1.0);
    EXPECT_THROW(tissue_thickness("fat"), InvalidInput);
}

}  // namespace
}  // namespace myoface
