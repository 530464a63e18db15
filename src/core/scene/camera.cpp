// SPDX-License-Identifier: Apache-2.0
#include "myoface/scene/camera.h"

#include <algorithm>
#include <cmath>

namespace myoface {

Eigen::Matrix4d Camera::view_matrix() const {
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    const Mat3 rotation = orientation.toRotationMatrix().transpose();
    view.topLeftCorner<3, 3>() = rotation;
    view.topRightCorner<3, 1>() = -(rotation * eye());
    return view;
}

Eigen::Matrix4d Camera::projection_matrix(double aspect, double scene_radius) const {
    const double near = std::max(distance - scene_radius, 0.02 * distance);
    const double far = distance + scene_radius;
    const double half = std::tan(0.5 * field_of_view);
    Eigen::Matrix4d p = Eigen::Matrix4d::Zero();
    if (orthographic) {
        p(0, 0) = 1.0 / (half * distance * aspect);
        p(1, 1) = 1.0 / (half * distance);
        p(2, 2) = -2.0 / (far - near);
        p(2, 3) = -(far + near) / (far - near);
        p(3, 3) = 1.0;
    } else {
        p(0, 0) = 1.0 / (half * aspect);
        p(1, 1) = 1.0 / half;
        p(2, 2) = -(far + near) / (far - near);
        p(2, 3) = -2.0 * far * near / (far - near);
        p(3, 2) = -1.0;
    }
    return p;
}

double Camera::mm_per_pixel(int height) const {
    return 2.0 * std::tan(0.5 * field_of_view) * distance / std::max(height, 1);
}

ViewRay view_ray(const Camera& camera, double pixel_x, double pixel_y, int width, int height) {
    const double scale = camera.mm_per_pixel(height);
    const Vec3 on_plane(scale * (pixel_x - 0.5 * width), scale * (0.5 * height - pixel_y), 0.0);
    const Vec3 through = camera.target + camera.orientation * on_plane;
    if (camera.orthographic) {
        const Vec3 forward = camera.orientation * -Vec3::UnitZ();
        return {through - camera.distance * forward, forward};
    }
    return {camera.eye(), (through - camera.eye()).normalized()};
}

PixelPoint project(const Camera& camera, const Vec3& point, int width, int height) {
    const Vec3 local = camera.orientation.conjugate() * (point - camera.target);
    const double depth = camera.distance - local.z();
    const double shrink = camera.orthographic ? 1.0 : camera.distance / std::max(depth, 1e-9);
    const double scale = shrink / camera.mm_per_pixel(height);
    return {0.5 * width + scale * local.x(), 0.5 * height - scale * local.y(), depth};
}

void orbit(Camera& camera, double right, double up) {
    // Turntable: yaw about the world's vertical, pitch about the camera's own right.
    const Eigen::AngleAxisd yaw(-right, Vec3::UnitY());
    const Eigen::AngleAxisd pitch(-up, Vec3::UnitX());
    camera.orientation = (yaw * camera.orientation * pitch).normalized();
}

void pan(Camera& camera, double pixels_right, double pixels_down, int height) {
    const double scale = camera.mm_per_pixel(height);
    camera.target -= camera.orientation * Vec3(scale * pixels_right, -scale * pixels_down, 0.0);
}

void zoom(Camera& camera, double factor) {
    camera.distance = std::clamp(camera.distance / factor, 20.0, 20000.0);
}

void frame(Camera& camera, const Vec3& centre, double radius, double aspect) {
    camera.target = centre;
    const double half = std::tan(0.5 * camera.field_of_view) * std::min(1.0, aspect);
    camera.distance = 1.06 * radius / half;
}

}  // namespace myoface
