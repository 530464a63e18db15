// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/smooth_warp.h"

#include <gtest/gtest.h>

namespace myoface {
namespace {

TEST(FitSimilarity, RecoversScaleTurnAndShift) {
    std::srand(1);
    const Points from = 50.0 * Points::Random(3, 12);
    Similarity wanted;
    wanted.scale = 0.1;
    wanted.rotation = Eigen::AngleAxisd(2.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    wanted.shift = Vec3(5, -7, 100);
    Points to(3, 12);
    for (int i = 0; i < 12; ++i) {
        to.col(i) = wanted(from.col(i));
    }
    const Similarity found = fit_similarity(from, to, Eigen::VectorXd::Ones(12));
    EXPECT_NEAR(found.scale, 0.1, 1e-12);
    EXPECT_TRUE(found.rotation.isApprox(wanted.rotation, 1e-12));
    EXPECT_TRUE(found.shift.isApprox(wanted.shift, 1e-10));
    const Vec3 p(1, 2, 3);
    EXPECT_LT((found.inverse()(found(p)) - p).norm(), 1e-10);
}

TEST(FitSimilarity, NeverMirrors) {
    std::srand(2);
    const Points from = Points::Random(3, 10);
    Points to = from;
    to.row(0) *= -1.0;
    EXPECT_GT(fit_similarity(from, to, Eigen::VectorXd::Ones(10)).rotation.determinant(), 0.0);
}

TEST(SmoothWarp, MeetsItsPairsAndReproducesAffineMaps) {
    std::srand(3);
    const Points from = 40.0 * Points::Random(3, 15);
    Mat3 affine;
    affine << 1.1, 0.1, 0, -0.05, 0.9, 0.02, 0, 0.1, 1.0;
    const Points to = (affine * from).colwise() + Vec3(1, 2, 3);
    const SmoothWarp warp(from, to, Eigen::VectorXd::Zero(15), 0.0);
    EXPECT_LT((warp(from) - to).cwiseAbs().maxCoeff(), 1e-8);
    const Vec3 p(10, -20, 5);
    EXPECT_LT((warp(p) - (affine * p + Vec3(1, 2, 3))).norm(), 1e-7);
}

TEST(SmoothWarp, ApproachesUncertainPairsOnly) {
    std::srand(4);
    const Points from = 40.0 * Points::Random(3, 15);
    Points to = from;
    to.col(4) += Vec3(0, 10, 0);
    Eigen::VectorXd errors = Eigen::VectorXd::Zero(15);
    errors[4] = 8.0;
    const SmoothWarp warp(from, to, errors, 1.5);
    const double followed = warp(Vec3(from.col(4))).y() - from(1, 4);
    EXPECT_LT(followed, 6.0);
    EXPECT_GT(followed, 0.0);
    EXPECT_LT((warp(Vec3(from.col(0))) - Vec3(from.col(0))).norm(), 1e-7);
}

}  // namespace
}  // namespace myoface
