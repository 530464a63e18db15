// SPDX-License-Identifier: Apache-2.0
#include "face_template.h"

#include <cmath>
#include <vector>

#include "myoface/face/generic_face.h"

#include "head/head_mesh.h"

namespace myoface {
namespace {

constexpr int kNodes = 1200;
constexpr double kSpacing = 3.0;  // [mm] of the points to choose from
constexpr double kHalfWidth = 66.0;
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

FaceTemplate build() {
    const HeadField& head = average_head();
    const Landmarks& landmarks = generic_landmarks();
    const Vec3 tip = landmarks.at("prn").position;
    const double top = landmarks.at("en_l").position.y() + kForehead;
    const double bottom = landmarks.at("gn").position.y();
    const double back = landmarks.at("ex_l").position.z() - kDepth;
    std::vector<Vec3> all;
    for (double y = bottom; y <= top; y += kSpacing) {
        for (double x = 0.5 * kSpacing; x <= kHalfWidth; x += kSpacing) {
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
    for (int i = 0; i < kNodes; ++i) {
        const Vec3 p = face.points.col(i);
        face.normals.col(i) = gradient(head, p);
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
