// SPDX-License-Identifier: Apache-2.0
#include "head_warps.h"

#include <algorithm>
#include <vector>

#include "face_template.h"
#include "landmark_pose.h"
#include "registration.h"

namespace myoface {
namespace {

/// How much an error of 1 mm may unbend the warp [mm]; about the spacing of landmarks.
constexpr double kWarpSoftness = 1.5;

/// How far the crown may leave the average one for what the front says [mm]: beyond the scan a bend
/// of the forehead would go on for ever.
constexpr double kCrownShare = 25.0;

/// Places around the average head's cranium that no landmark holds.
Points crown_places() {
    Points places(3, 6);
    places << 0.0, 0.0, 70.9, -70.9, 49.0, -49.0,  //
        131.0, 19.4, 60.1, 60.1, 100.0, 100.0,     //
        -8.0, -93.8, -30.5, -30.5, -10.0, -10.0;
    return places;
}

/// Whether a warp turns nothing inside out around the front of the head.
bool keeps_sense(const SmoothWarp& warp) {
    constexpr double kStep = 1.5;    // [mm]
    constexpr double kLeast = 0.15;  // of the volume
    const Points& points = face_template().points;
    Points ahead(3, 4 * points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        ahead.col(4 * i) = points.col(i);
        for (int axis = 0; axis < 3; ++axis) {
            ahead.col(4 * i + 1 + axis) = points.col(i) + kStep * Vec3::Unit(axis);
        }
    }
    const Points moved = warp(ahead);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Mat3 jacobian = (moved.middleCols<3>(4 * i + 1).colwise() - moved.col(4 * i)) / kStep;
        if (jacobian.determinant() < kLeast) {
            return false;
        }
    }
    return true;
}

}  // namespace

HeadWarps fit_head(const TriangleMesh& skin, const Similarity& to_generic,
                   const Landmarks& landmarks) {
    constexpr int kSamples = 30000;
    constexpr double kOnScan = 2.0;  // [mm] a point further off carries nothing
    constexpr Eigen::Index kCentres = 700;
    const LandmarkPairs pairs = common_landmarks(landmarks);
    Points in_pose(3, pairs.scan.cols());
    for (Eigen::Index i = 0; i < in_pose.cols(); ++i) {
        in_pose.col(i) = to_generic(Vec3(pairs.scan.col(i)));
    }
    HeadWarps warps;
    warps.from_average = SmoothWarp(pairs.generic, in_pose, pairs.errors, kWarpSoftness);
    warps.to_average = SmoothWarp(in_pose, pairs.generic, pairs.errors, kWarpSoftness);
    const SurfaceSamples samples = sample_surface(around_face(skin, to_generic), kSamples);
    if (samples.points.cols() < 500) {
        return warps;
    }
    Pins pins;
    pins.from = warps.from_average(pairs.generic);
    pins.to = in_pose;
    pins.softness = (kWarpSoftness * pairs.errors.cwiseAbs2()).cwiseMax(0.05);
    const DenseFit dense = bend_onto(samples, warps.from_average, pins);
    std::vector<Eigen::Index> kept;
    for (Eigen::Index i = 0;
         i < dense.points.cols() && static_cast<Eigen::Index>(kept.size()) < kCentres; ++i) {
        if (dense.distance[i] < kOnScan) {
            kept.push_back(i);
        }
    }
    const auto n = static_cast<Eigen::Index>(kept.size());
    const Eigen::Index held = in_pose.cols();
    const Points crown = crown_places();
    const Eigen::Index far = crown.cols();
    Points generic(3, n + held + far);
    Points scan(3, n + held + far);
    for (Eigen::Index k = 0; k < n; ++k) {
        generic.col(k) = face_template().points.col(kept[static_cast<std::size_t>(k)]);
        scan.col(k) = dense.points.col(kept[static_cast<std::size_t>(k)]);
    }
    generic.middleCols(n, held) = pairs.generic;
    scan.middleCols(n, held) = in_pose;
    generic.rightCols(far) = crown;
    scan.rightCols(far) = crown;
    for (const double stiffness : {0.3, 3.0, 30.0}) {
        Eigen::VectorXd softness(n + held + far);
        softness << Eigen::VectorXd::Constant(n, stiffness), pins.softness,
            Eigen::VectorXd::Constant(far, kCrownShare);
        HeadWarps bent{WarpCentres(scan, softness).towards(generic),
                       WarpCentres(generic, softness).towards(scan)};
        if (keeps_sense(bent.from_average)) {
            return bent;
        }
    }
    return warps;
}

}  // namespace myoface
