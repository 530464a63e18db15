// SPDX-License-Identifier: Apache-2.0
#include "myoface/scene/mouth_light.h"

#include <algorithm>
#include <cmath>

#include "myoface/base/smooth_step.h"

namespace myoface {
namespace {

const Vec3 kLips(0.0, -52.0, 97.0);  // where they meet, on the average head [mm]
constexpr double kFades = 20.0;      // over this depth the light falls to 1/e [mm]

/// Left, up and behind of the meeting lips, in millimetres of the average head.
class MouthSpace {
public:
    explicit MouthSpace(const FaceModel& face)
        : turn_(face.to_generic.scale * face.axes.transpose()), lips_(from_generic(face, kLips)) {}

    Vec3 at(const Vec3& p) const {
        const Vec3 q = turn_ * (p - lips_);
        return {q.x(), q.y(), -q.z()};
    }

private:
    Mat3 turn_;
    Vec3 lips_;
};

double light_at_depth(double behind) {
    return std::exp(-std::max(behind, 0.0) / kFades);
}

}  // namespace

Eigen::VectorXd light_behind_lips(const FaceModel& face, const Points& places) {
    const MouthSpace mouth(face);
    Eigen::VectorXd light(places.cols());
    for (Eigen::Index k = 0; k < places.cols(); ++k) {
        light[k] = light_at_depth(mouth.at(places.col(k)).z());
    }
    return light;
}

double light_between_lips(const FaceModel& face, const Points& nodes) {
    constexpr double kOpen = 5.0;  // [mm]
    double gap = 0.0;
    for (const auto& [upper, lower] : face.lip_contacts) {
        gap = std::max(gap, (nodes.col(upper) - nodes.col(lower)).norm());
    }
    return 0.1 + 0.9 * smooth_step(0.0, kOpen, gap);
}

void light_the_mouth(const FaceModel& face, Eigen::Matrix4Xf& of_vertices) {
    constexpr float kShut = 0.35F;  // no outer skin near the mouth sees less of the light
    const MouthSpace mouth(face);
    const Points& vertices = face.scan->mesh.vertices;
    const Eigen::Vector3f front = face.axes.col(2).cast<float>();
    for (Eigen::Index v = 0; v < std::min(vertices.cols(), of_vertices.cols()); ++v) {
        if (of_vertices(3, v) > kShut) {
            continue;
        }
        const Vec3 at = mouth.at(vertices.col(v));
        const bool inside = std::abs(at.x()) < 34.0 && at.y() > -28.0 && at.y() < 18.0 &&
                            at.z() > 2.0 && at.z() < 80.0;
        const auto light = static_cast<float>(light_at_depth(at.z()));
        if (inside && 0.5F * light > of_vertices(3, v)) {
            // It comes from the front: half from straight ahead, half from around.
            of_vertices.col(v) << 0.5F * light * front, 0.5F * light;
        }
    }
}

}  // namespace myoface
