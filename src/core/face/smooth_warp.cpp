// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/smooth_warp.h"

#include <Eigen/Dense>

#include "myoface/base/parallel.h"

namespace myoface {

Similarity Similarity::inverse() const {
    Similarity back;
    back.scale = 1.0 / scale;
    back.rotation = rotation.transpose();
    back.shift = -back.scale * (back.rotation * shift);
    return back;
}

Similarity fit_similarity(const Points& from, const Points& to, const Eigen::VectorXd& weights) {
    const double total = weights.sum();
    const Vec3 mean_from = from * weights / total;
    const Vec3 mean_to = to * weights / total;
    const Points a = from.colwise() - mean_from;
    const Points b = to.colwise() - mean_to;
    const Mat3 covariance = b * weights.asDiagonal() * a.transpose();
    const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vec3 sign = Vec3::Ones();
    if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) {
        sign.z() = -1.0;
    }
    Similarity result;
    result.rotation = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
    const double spread = (a.colwise().squaredNorm() * weights)(0);
    result.scale = svd.singularValues().dot(sign) / spread;
    result.shift = mean_to - result.scale * (result.rotation * mean_from);
    return result;
}

namespace {

Eigen::MatrixXd warp_system(const Points& centres, const Eigen::VectorXd& softness) {
    const Eigen::Index n = centres.cols();
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 4, n + 4);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {  // conditionally positive definite
            system(i, j) = system(j, i) = -(centres.col(i) - centres.col(j)).norm();
        }
        system(i, i) += softness[i];
        system(i, n) = system(n, i) = 1.0;
        system.block<1, 3>(i, n + 1) = centres.col(i).transpose();
        system.block<3, 1>(n + 1, i) = centres.col(i);
    }
    return system;
}

Eigen::MatrixX3d warp_targets(const Points& to) {
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(to.cols() + 4, 3);
    right.topRows(to.cols()) = to.transpose();
    return right;
}

}  // namespace

SmoothWarp::SmoothWarp(const Points& from, const Points& to, const Eigen::VectorXd& errors,
                       double stiffness)
    : centres_(from) {
    // Landmarks may coincide: every pivot is looked for.
    const Eigen::MatrixXd system = warp_system(from, stiffness * errors.cwiseAbs2());
    coefficients_ = system.fullPivLu().solve(warp_targets(to));
}

WarpCentres::WarpCentres(const Points& centres, const Eigen::VectorXd& softness)
    : centres_(centres), solver_(warp_system(centres, softness)) {}

SmoothWarp WarpCentres::towards(const Points& to) const {
    SmoothWarp warp;
    warp.centres_ = centres_;
    warp.coefficients_ = solver_.solve(warp_targets(to));
    return warp;
}

Vec3 SmoothWarp::operator()(const Vec3& x) const {
    const Eigen::Index n = centres_.cols();
    Eigen::RowVector3d sum = coefficients_.row(n) + x.transpose() * coefficients_.bottomRows<3>();
    for (Eigen::Index i = 0; i < n; ++i) {
        sum -= (x - centres_.col(i)).norm() * coefficients_.row(i);
    }
    return sum.transpose();
}

Points SmoothWarp::operator()(const Points& points) const {
    Points result(3, points.cols());
    parallel_for(static_cast<int>(points.cols()), 512, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            result.col(i) = (*this)(Vec3(points.col(i)));
        }
    });
    return result;
}

}  // namespace myoface
