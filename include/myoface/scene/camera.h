// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <Eigen/Geometry>

#include "myoface/base/view_ray.h"

namespace myoface {

/// An orbiting camera. Pixel coordinates run from the top left corner, y down, and may be
/// fractions; width and height are those of the picture.
struct Camera {
    Vec3 target = Vec3::Zero();                                       ///< what it looks at [mm]
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< camera -> world
    double distance = 600.0;                                          ///< eye to target [mm]
    double field_of_view = 0.44;                                      ///< vertical [rad]
    bool orthographic = false;

    Vec3 eye() const { return target + distance * (orientation * Vec3::UnitZ()); }
    /// World -> camera.
    Eigen::Matrix4d view_matrix() const;
    /// Camera -> clip space, depth range fitted to `scene_radius` around the target.
    Eigen::Matrix4d projection_matrix(double aspect, double scene_radius) const;
    /// Millimetres per pixel at the target's depth.
    double mm_per_pixel(int height) const;
};

ViewRay view_ray(const Camera& camera, double pixel_x, double pixel_y, int width, int height);

/// Pixel where a point appears, and its depth before the eye [mm].
struct PixelPoint {
    double x = 0.0, y = 0.0, depth = 0.0;
};
PixelPoint project(const Camera& camera, const Vec3& point, int width, int height);

/// Turns about the target: `right` and `up` are angles [rad] by which the scene seems to follow.
void orbit(Camera& camera, double right, double up);
/// Moves the target in the view plane by pixels of mouse motion.
void pan(Camera& camera, double pixels_right, double pixels_down, int height);
/// Comes nearer by a factor (> 1).
void zoom(Camera& camera, double factor);

/// Points the camera at a box so that all of it is seen with a small margin.
void frame(Camera& camera, const Vec3& centre, double radius, double aspect);

}  // namespace myoface
