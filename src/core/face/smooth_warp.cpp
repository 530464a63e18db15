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

SmoothWarp::SmoothWarp(const Points& from, const Points& to, const Eigen::VectorXd& errors,
                       double stiffness)
    : centres_(from) {
    const Eigen::Index n = from.cols();
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 4, n + 4);
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n + 4, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            system(i, j) = -(from.col(i) - from.col(j)).norm();  // conditionally positive definite
        }
        system(i, i) += stiffness * errors[i] * errors[i];
        system(i, n) = system(n, i) = 1.0;
        system.block<1, 3>(i, n + 1) = from.col(i).transpose();
        system.block<3, 1>(n + 1, i) = from.col(i);
        right.row(i) = to.col(i).transpose();
    }
    coefficients_ = system.fullPivLu().solve(right);
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
