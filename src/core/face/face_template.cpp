// SPDX-License-Identifier: Apache-2.0
#include "face_template.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "myoface/face/generic_face.h"

#include "head/head_mesh.h"

namespace myoface {
namespace {

constexpr int kNodes = 1200;
constexpr double kSpacing = 3.0;  // [mm] of the points to choose from
constexpr double kTemplateHalfWidth = 66.0;
constexpr double kForehead = 50.0;  // above the inner canthi
constexpr double kDepth = 45.0;     // behind the outer canthi

Vec3 gradient(const HeadField& head, const Vec3& p) {
    Vec3 result;
    constexpr double kStep = 0.4;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 step = kStep * Vec3::Unit(axis);
        result[axis] = head(p + step) - head(p - step);
    }
    return result.normalized();
}

/// relief() of a field: rings instead of discs, so smaller by the root of two.
double ring_relief(const HeadField& head, const Vec3& p, const Vec3& normal, double reach) {
    const double radius = reach / std::numbers::sqrt2;
    const Vec3 along = normal.unitOrthogonal();
    const Vec3 across = normal.cross(along);
    constexpr int kDirections = 12;
    std::array<Vec3, kDirections> ring;
    for (int k = 0; k < kDirections; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kDirections;
        Vec3 q = p + radius * (std::cos(angle) * along + std::sin(angle) * across);
        for (int step = 0; step < 2; ++step) {
            q -= head(q) * normal;
        }
        ring[static_cast<std::size_t>(k)] = q;
    }
    // The ring's own plane stands for the mean of the normals in it.
    Vec3 plane = Vec3::Zero();
    Vec3 middle = Vec3::Zero();
    for (std::size_t k = 0; k < ring.size(); ++k) {
        plane += (ring[k] - p).cross(ring[(k + 1) % ring.size()] - p);
        middle += ring[k] / kDirections;
    }
    return plane.normalized().dot(p - middle);
}

FaceTemplate build() {
    const HeadField& head = average_head();
    const Landmarks& landmarks = generic_landmarks();
    const Vec3 tip = landmarks.at("prn").position;
    const double top = landmarks.at("en_l").position.y() + kForehead;
    const double bottom = landmarks.at("gn").position.y();
    const double back = landmarks.at("ex_l").position.z() - kDepth;
    std::vector<Vec3> all;
    for (double y = bottom; y <= top; y += kSpacing) {
        for (double x = 0.5 * kSpacing; x <= kTemplateHalfWidth; x += kSpacing) {
            const Vec3 p = head.front_point(x, y);
            if (p.z() > back && std::abs(head(p)) < 0.5) {
                all.push_back(p);
                all.emplace_back(-p.x(), p.y(), p.z());
            }
        }
    }
    // Farthest point first; the tip leads.
    std::vector<double> distance(all.size(), 1e30);
    FaceTemplate face;
    face.points.resize(3, kNodes);
    face.points.col(0) = tip;
    for (int chosen = 0; chosen < kNodes; ++chosen) {
        std::size_t farthest = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            distance[i] = std::min(distance[i], (all[i] - face.points.col(chosen)).squaredNorm());
            farthest = distance[i] > distance[farthest] ? i : farthest;
        }
        if (chosen + 1 < kNodes) {
            face.points.col(chosen + 1) = all[farthest];
        }
    }
    face.normals.resize(3, kNodes);
    face.weights.resize(kNodes);
    face.fine_relief.resize(kNodes);
    face.coarse_relief.resize(kNodes);
    for (int i = 0; i < kNodes; ++i) {
        const Vec3 p = face.points.col(i);
        face.normals.col(i) = gradient(head, p);
        face.fine_relief[i] = ring_relief(head, p, face.normals.col(i), kFineReach);
        face.coarse_relief[i] = ring_relief(head, p, face.normals.col(i), kCoarseReach);
        const bool eye = (Vec3(std::abs(p.x()), p.y(), p.z()) - head.eye_centre()).norm() < 19.0;
        face.weights[i] = eye ? 0.3 : (p - tip).norm() < 75.0 ? 1.0 : 0.5;
    }
    face.tip = tip;
    face.centre = face.points.rowwise().mean();
    Vec3 normal = Vec3::Zero();
    for (int i = 0; i < kNodes; ++i) {
        if ((face.points.col(i) - tip).norm() < kNormalReach) {
            normal += face.normals.col(i);
        }
    }
    face.tip_normal = normal.normalized();
    double height = 0.0;
    int count = 0;
    for (int i = 0; i < kNodes; ++i) {
        const Vec3 away = tip - face.points.col(i);
        if (away.norm() < kNoseReach) {
            height += face.tip_normal.dot(away) / kNoseReach;
            ++count;
        }
    }
    face.tip_height = height / count;
    return face;
}

}  // namespace

const FaceTemplate& face_template() {
    static const FaceTemplate kTemplate = build();
    return kTemplate;
}

}  // namespace myoface
