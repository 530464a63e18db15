// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/LU>

#include "myoface/base/points.h"

namespace myoface {

/// x ↦ scale · rotation · x + shift.
struct Similarity {
    double scale = 1.0;
    Mat3 rotation = Mat3::Identity();
    Vec3 shift = Vec3::Zero();

    Vec3 operator()(const Vec3& x) const { return scale * (rotation * x) + shift; }
    Similarity inverse() const;
};

/// The similarity (never a mirror image) that carries `from` onto `to` with the least weighted sum
/// of squares. @pre at least three points that do not lie on a line. @cite umeyama_1991
Similarity fit_similarity(const Points& from, const Points& to, const Eigen::VectorXd& weights);

/// A smooth map of space through point pairs: an affine part plus r-kernels (the biharmonic spline
/// of three dimensions). Pairs with an error are approached, not met.
/// @cite wahba_1990, sections 2.4 and 4.1
class SmoothWarp {
public:
    SmoothWarp() = default;
    /// @param errors one sigma per pair [mm]; 0 is met exactly.
    /// @param stiffness how strongly an error of 1 mm bends less [mm]; 0 meets all pairs.
    SmoothWarp(const Points& from, const Points& to, const Eigen::VectorXd& errors,
               double stiffness);

    Vec3 operator()(const Vec3& x) const;
    Points operator()(const Points& points) const;

private:
    friend class WarpCentres;
    Points centres_;
    Eigen::MatrixX3d coefficients_;  ///< kernels, then the affine part (4 rows)
};

/// The same centres of a warp for many targets: factorized once.
class WarpCentres {
public:
    /// @param softness per centre, how much it may be missed [mm]; 0 is met exactly
    /// @pre at least one softness is not 0 or no two centres coincide
    WarpCentres(const Points& centres, const Eigen::VectorXd& softness);

    SmoothWarp towards(const Points& to) const;

private:
    Points centres_;
    Eigen::PartialPivLU<Eigen::MatrixXd> solver_;
};

}  // namespace myoface
