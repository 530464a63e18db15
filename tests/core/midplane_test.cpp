// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/midplane.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "myoface/face/face_model.h"

#include "test_meshes.h"

namespace myoface {
namespace {

TEST(Midplane, OfTheSymmetricHeadIsItsOwn) {
    const Midplane& plane = test::small_model()->midplane;
    EXPECT_NEAR(plane.normal.x(), 1.0, 1e-4);
    EXPECT_NEAR(plane.point.x(), 0.0, 0.05);
}

TEST(Midplane, TurnsWithTheHeadAndIsNotTurnedByASwelling) {
    const GenericFace& head = test::small_face();
    const Mat3 turn = Eigen::AngleAxisd(0.35, Vec3(0.3, 1.0, 0.2).normalized()).toRotationMatrix();
    const Vec3 shift(12.0, -40.0, 7.0);
    auto scan = std::make_shared<Scan>(head.scan);
    for (Eigen::Index v = 0; v < scan->mesh.vertices.cols(); ++v) {
        Vec3 p = scan->mesh.vertices.col(v);
        // A swollen cheek, 6 mm.
        const double d = (p - Vec3(45.0, -15.0, 65.0)).norm() / 18.0;
        p += 6.0 * std::exp(-d * d) * Vec3(0.6, 0.0, 0.8);
        scan->mesh.vertices.col(v) = turn * p + shift;
    }
    Landmarks landmarks = head.landmarks;
    for (auto& [name, landmark] : landmarks) {
        landmark.position = turn * landmark.position + shift;
    }
    landmarks["al_l"].position += turn * Vec3(2.0, 1.0, 0.0);  // one that is a little off
    const Midplane plane = fit_face(scan, landmarks)->midplane;
    EXPECT_GT(plane.normal.dot(turn * Vec3::UnitX()), std::cos(0.6 / 57.3));
    EXPECT_NEAR(plane.normal.dot(turn * Vec3(0.0, 0.0, 90.0) + shift - plane.point), 0.0, 0.6);
    // Mirrored twice is where it was.
    const Vec3 p(10.0, 20.0, 30.0);
    EXPECT_LT((mirrored(plane, mirrored(plane, p)) - p).norm(), 1e-9);
    EXPECT_NEAR(side_of(plane, p), -side_of(plane, mirrored(plane, p)), 1e-9);
}

}  // namespace
}  // namespace myoface
