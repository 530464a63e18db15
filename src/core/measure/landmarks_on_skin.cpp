// SPDX-License-Identifier: Apache-2.0
#include "myoface/measure/landmarks_on_skin.h"

#include "myoface/face/generic_face.h"
#include "myoface/mesh/bvh.h"

namespace myoface {

LandmarksOnSkin::LandmarksOnSkin(std::shared_ptr<const FaceModel> face) : face_(std::move(face)) {
    const TriangleMesh& skin = face_->skin.mesh;
    const Bvh bvh(skin);
    landmarks_ = face_->landmarks;
    for (const auto& [name, landmark] : generic_landmarks()) {
        if (landmarks_.count(name) == 0) {
            const Vec3 fitted = from_generic(*face_, landmark.position);
            landmarks_[name].position = bvh.closest_point(skin, fitted).point;
        }
    }
    for (const auto& [name, landmark] : landmarks_) {
        on_skin_[name] = bvh.closest_point(skin, landmark.position).where;
    }
}

Landmarks LandmarksOnSkin::at(const Points& nodes) const {
    const TriangleMesh& skin = face_->skin.mesh;
    Landmarks now = landmarks_;
    for (auto& [name, landmark] : now) {
        const SurfacePoint& where = on_skin_.at(name);
        for (int c = 0; c < 3; ++c) {
            const int node = skin.triangles(c, where.triangle);
            landmark.position += where.weights[c] * (nodes.col(node) - skin.vertices.col(node));
        }
    }
    return now;
}

std::optional<double> LandmarksOnSkin::measure(const Measure& measure, const Points& nodes) const {
    const Landmarks now = at(nodes);
    if (measure.kind != MeasureKind::Projection) {
        return measured(measure, now);
    }
    if (landmarks_.count("n") == 0 || now.count(measure.points[0]) == 0) {
        return std::nullopt;
    }
    return (now.at(measure.points[0]).position - landmarks_.at("n").position)
        .dot(face_->axes.col(2));
}

}  // namespace myoface
