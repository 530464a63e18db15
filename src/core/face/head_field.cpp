// SPDX-License-Identifier: Apache-2.0
#include "head_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace myoface {
namespace {

using Bead = HeadField::Bead;
using Tube = HeadField::Tube;

/// Smooth union: polynomial, k is the width of the blend [mm].
double smooth_min(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - 0.25 * k * h * h;
}
double smooth_max(double a, double b, double k) {
    return -smooth_min(-a, -b, k);
}
double subtract(double d, double hole, double k) {
    return smooth_max(d, -hole, k);
}

double smooth_step(double edge0, double edge1, double x) {
    const double t = std::clamp((x - edge0) / (edge1 - edge0), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double sphere(const Vec3& p, const Vec3& centre, double radius) {
    return (p - centre).norm() - radius;
}

/// First-order distance to an ellipsoid, given its local coordinates.
double ellipsoid_local(const Vec3& local, const Vec3& radii) {
    const double k0 = local.cwiseQuotient(radii).norm();
    const double k1 = local.cwiseQuotient(radii.cwiseProduct(radii)).norm();
    return k1 > 1e-12 ? k0 * (k0 - 1.0) / k1 : -radii.minCoeff();
}
double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii) {
    return ellipsoid_local(p - centre, radii);
}
/// The same, its front turned towards +x by an angle [degrees].
double turned_ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii, double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vec3 d = p - centre;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return ellipsoid_local({c * d.x() - s * d.z(), d.y(), s * d.x() + c * d.z()}, radii);
}

double capsule(const Vec3& p, const Vec3& a, const Vec3& b, double radius_a, double radius_b) {
    const Vec3 ab = b - a;
    const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
    return (p - a - t * ab).norm() - (radius_a + t * (radius_b - radius_a));
}

/// Distance to a chain of beads joined by cones.
double tube_distance(const Vec3& p, const Tube& tube) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < tube.size(); ++i) {
        best = std::min(best, capsule(p, tube[i].centre, tube[i + 1].centre, tube[i].radius,
                                      tube[i + 1].radius));
    }
    return best;
}

/// Catmull-Rom centre line through the given beads, sampled `per_span` times a span.
Tube smooth_tube(const Tube& through, int per_span = 8) {
    Tube result;
    const auto at = [&](std::ptrdiff_t i) -> const Bead& {
        return through[static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(through.size()) - 1))];
    };
    for (std::ptrdiff_t span = 0; span + 1 < static_cast<std::ptrdiff_t>(through.size()); ++span) {
        for (int k = 0; k < per_span; ++k) {
            const double t = static_cast<double>(k) / per_span;
            const double w0 = -0.5 * t + t * t - 0.5 * t * t * t;
            const double w1 = 1.0 - 2.5 * t * t + 1.5 * t * t * t;
            const double w2 = 0.5 * t + 2.0 * t * t - 1.5 * t * t * t;
            const double w3 = -0.5 * t * t + 0.5 * t * t * t;
            result.push_back({w0 * at(span - 1).centre + w1 * at(span).centre +
                                  w2 * at(span + 1).centre + w3 * at(span + 2).centre,
                              w0 * at(span - 1).radius + w1 * at(span).radius +
                                  w2 * at(span + 1).radius + w3 * at(span + 2).radius});
        }
    }
    result.push_back(through.back());
    return result;
}

/// Skips a primitive that lies too far off to change d.
bool reaches(double d, const Vec3& p, const Vec3& centre, double bound, double k) {
    return (p - centre).norm() - bound < d + k + 4.0;
}

}  // namespace

HeadField::HeadField()
    : front_({-110, -97, -85, -70, -50, -30, -15, 0, 20, 36, 50},
             {72, 85, 91, 93, 94.5, 91, 88, 86, 88, 94, 95.5}),
      back_({-110, -97, -85, -70, -50, -30, -15, 0, 20, 36, 50},
            {-40, -45, -50, -55, -60, -68, -76, -82, -88, -91, -92}),
      half_width_({-110, -97, -85, -70, -50, -30, -15, 0, 20, 36, 50},
                  {34, 38, 43, 49, 56, 61.5, 65, 67.5, 70.5, 72.5, 73.5}),
      width_z_({-110, -97, -85, -70, -50, -30, -15, 0, 20, 36, 50},
               {12, 11, 10, 7, 2, -3, -7, -10, -10, -9, -8}),
      exponent_({-110, -97, -85, -70, -50, -30, -15, 0, 20, 36, 50},
                {1.8, 1.85, 1.9, 1.95, 2.1, 2.3, 2.4, 2.45, 2.45, 2.45, 2.45}),
      ridge_z_({-30, -24, -18, -13, -8, 0, 8, 15, 21, 26, 32, 40},
               {86, 100, 110.2, 113.2, 111.2, 106.3, 100.8, 96.4, 94.0, 93.8, 93.0, 88}),
      ridge_slope_({-18, -10, 0, 10, 20, 30}, {.85, .74, .68, .72, .95, 1.6}),
      ridge_round_({-18, 0, 12, 30}, {7, 5.5, 6, 10}),
      upper_lid_({16.1, 18.5, 22, 26, 30, 34, 38, 41.5, 43.6},
                 {16.3, 18.1, 20.3, 21.6, 22.1, 21.9, 20.9, 19.4, 17.95}),
      lower_lid_({16.1, 18.5, 22, 26, 30, 34, 38, 41.5, 43.6},
                 {16.3, 14.8, 13.2, 12.1, 11.7, 11.9, 13.1, 15.6, 17.95}),
      lip_line_({0, 6, 13, 20, 24.5}, {-52, -51.8, -51.95, -52, -52.2}) {
    mandible_ = smooth_tube({{{48, -38, 4}, 8},
                             {{44.5, -58, 12}, 9},
                             {{37.5, -72, 33}, 10},
                             {{26, -80, 55}, 10},
                             {{13, -84, 72}, 9}});
    brow_ = smooth_tube({{{5, 35, 86}, 5.5},
                         {{16, 38.5, 84}, 6},
                         {{28, 40.5, 79.6}, 6},
                         {{39, 38, 71.5}, 5.8},
                         {{47, 30, 60.5}, 5.5}});
    sternomastoid_ = smooth_tube({{{56, -30, -24}, 9}, {{36, -95, 2}, 8}, {{10, -165, 22}, 7}});
    helix_ = smooth_tube({{{67.5, 5, -7}, 1.6},
                          {{71, 8, -4}, 2.0},
                          {{73.5, 20, -4}, 2.4},
                          {{77.5, 30, -12}, 2.6},
                          {{81.5, 31.5, -22}, 2.6},
                          {{84, 24, -31}, 2.6},
                          {{83.5, 10, -34}, 2.5},
                          {{80, -4, -30.5}, 2.3},
                          {{75.5, -14, -24}, 2.0}});
    antihelix_ = smooth_tube({{{77, 21, -13}, 1.7},
                              {{79.5, 17, -21}, 2.2},
                              {{80.5, 8, -24.5}, 2.4},
                              {{78, -4, -22}, 2.3},
                              {{74, -11, -17.5}, 2.0},
                              {{71.5, -11.5, -12}, 1.8}});
    // Thin features ride on the surface that is there so far.
    lid_crease_ = snapped({{18.5, 20.5, .75, 0},
                           {22.5, 25, .75, 0},
                           {27, 27.4, .75, 0},
                           {31.5, 28, .75, 0},
                           {36, 27.2, .75, 0},
                           {40.5, 24.9, .75, 0},
                           {45, 20.6, .75, 0}},
                          false);
    philtral_column_ =
        snapped({{4.4, -34.5, 1.2, -2.6}, {5.4, -38.5, 1.4, -2.2}, {6.4, -44, 1.3, -1.7}}, false);
    philtral_groove_ =
        snapped({{0, -35, 2.0, 3.2}, {0, -39, 2.3, 2.7}, {0, -43.5, 2.3, 2.4}}, false);
    nasolabial_ = snapped(
        {{20, -22, .8, 2.9}, {25, -29, .8, 2.9}, {30, -39, .8, 2.9}, {33.5, -49, .8, 3.1}}, false);
    upper_lip_ = snapped({{0, -48.4, 3.5, .9},
                          {5.6, -47.8, 3.7, 1},
                          {13, -49, 2.9, .6},
                          {19.5, -50.7, 1.9, 0},
                          {24.3, -52.1, .9, -.7}},
                         true);
    lower_lip_ = snapped({{0, -56.4, 4.2, .1},
                          {6, -56.2, 4.2, .1},
                          {13, -55.4, 3.5, -.1},
                          {19, -54, 2.2, -.5},
                          {24, -52.7, .9, -.9}},
                         true);
}

double HeadField::base(const Vec3& p) const {
    // Above y = 44 the section is held and a super-ellipse closes the crown.
    const double y = smooth_min(p.y(), 44.0, 24.0);
    const double crown = std::max(0.0, (p.y() - y) / 87.0);
    const double width = half_width_(y);
    const double centre = width_z_(y);
    const double dz = p.z() - centre;
    const double front = front_(y) - centre;
    const double back = centre - back_(y);
    const double along = dz > 0.0 ? dz / front : -dz / back;
    const double n = 2.12 + (exponent_(y) - 2.12) * smooth_step(-0.25, 0.55, dz / front);
    const double section = std::pow(std::abs(p.x()) / width, n) + std::pow(along, n);
    const double level = std::pow(section, 2.2 / n) + std::pow(crown, 2.2);
    const double ratio = std::pow(level, 1.0 / 2.2);
    if (ratio < 1e-6) {
        return -width;
    }
    const double rho = Vec3(p.x(), p.y() - y, dz).norm();
    return rho * (1.0 - 1.0 / ratio);
}

double HeadField::bony_face(const Vec3& q) const {
    const Vec3 p(std::sqrt(q.x() * q.x() + 0.36), q.y(), q.z());      // paired
    const Vec3 broad(std::sqrt(q.x() * q.x() + 36.0), q.y(), q.z());  // paired, merging
    double d = base(q);
    const double under = (-62.0 - 0.42 * (q.z() - 10.0) - q.y()) / std::hypot(1.0, 0.42);
    d = smooth_max(d, under, 22.0);
    d = smooth_min(d, ellipsoid(q, {0, -83, 79.5}, {19, 14.5, 18}), 16.0);
    if (reaches(d, p, {32, -62, 36}, 52.0, 16.0)) {
        d = smooth_min(d, tube_distance(p, mandible_), 16.0);
    }
    if (reaches(d, p, {26, 37, 78}, 34.0, 20.0)) {
        d = smooth_min(d, tube_distance(p, brow_), 20.0);
    }
    d = smooth_min(d, ellipsoid(q, {0, 39, 82.5}, {18, 12, 12.2}), 18.0);
    d = smooth_min(d, ellipsoid(broad, {22, 60, 60}, {34, 30, 33}), 28.0);
    d = smooth_min(d, ellipsoid(q, {0, -50, 66}, {28, 25, 30}), 20.0);
    d = smooth_min(d, turned_ellipsoid(p, {42, -4, 56}, {17, 12, 12}, 40.0), 18.0);
    d = smooth_min(d, capsule(p, {48, -5, 42}, {54, -2, 10}, 6.0, 5.0), 18.0);
    d = smooth_min(d, ellipsoid(p, {34, -28, 54}, {20, 26, 23}), 20.0);
    d = subtract(d, ellipsoid(p, {102, 36, 50}, {27, 31, 38}), 38.0);

    const Vec3 axis = Vec3(0, -150, -28).normalized();
    const Vec3 from_axis = q - Vec3(0, -40, -10);
    const Vec3 radial = from_axis - from_axis.dot(axis) * axis;
    const double neck = Vec3(radial.x() / 52.0, radial.y() / 54.0, radial.z() / 54.0).norm();
    const double neck_top = q.y() + 20.0;  // the neck ends inside the head
    const double neck_distance = smooth_max(53.0 * (neck - 1.0), neck_top, 20.0);
    d = smooth_min(d, neck_distance, 16.0);
    if (reaches(d, p, {34, -98, 0}, 92.0, 22.0)) {
        d = smooth_min(d, tube_distance(p, sternomastoid_), 22.0);
    }
    d = smooth_min(d, ellipsoid(q, {0, -124, 15}, {11, 18, 11}), 18.0);
    d = smooth_min(d, capsule(q, {0, -83, 66}, {0, -86, 36}, 14.0, 17.0), 18.0);
    return d;
}

double HeadField::eyes(double d, const Vec3& p) const {
    if (!reaches(d, p, {30, 18, 75}, 40.0, 15.0)) {
        return d;
    }
    d = subtract(d, turned_ellipsoid(p, {28.5, 20, 95}, {18, 12, 18.5}, 18.0), 15.0);
    d = subtract(d, ellipsoid(p, {15.5, 13.5, 94.5}, {4.8, 8, 15}), 9.0);
    d = smooth_min(d, sphere(p, eye_centre(), 14.0), 5.0);
    return d;
}

double HeadField::nose(const Vec3& q) const {
    const Vec3 p(std::sqrt(q.x() * q.x() + 0.36), q.y(), q.z());
    const double e = ridge_round_(q.y());
    const double s = ridge_slope_(q.y());
    const double root = std::sqrt(q.x() * q.x() + e * e);
    const double side = q.x() / (s * root);
    double ridge = (q.z() - (ridge_z_(q.y()) - (root - e) / s)) / std::sqrt(1.0 + side * side);
    const double bound =
        std::max({std::abs(q.y() - 2.0) - 36.0, std::abs(q.x()) - 22.0, 62.0 - q.z()});
    double d = smooth_max(ridge, bound, 6.0);
    d = smooth_min(d, sphere(q, {0, -17.9, 111.8}, 5.9), 10.0);
    d = smooth_min(d, sphere(p, {4.6, -18.4, 108.9}, 5.4), 7.0);
    d = smooth_min(d, capsule(p, {4.6, -15, 106}, {9.4, -12, 97}, 5.6, 5.6), 8.0);
    const Vec3 local = p - Vec3(12.1, -21.2, 98.2);
    const Eigen::AngleAxisd turn(22.0 * std::numbers::pi / 180.0, Vec3::UnitY());
    d = smooth_min(d, ellipsoid_local(turn * local, {5.3, 7.0, 10.6}), 3.8);
    d = smooth_min(d, capsule(q, {0, -27, 98.5}, {0, -21.3, 109}, 3.6, 4.0), 5.0);
    return d;
}

double HeadField::ear(const Vec3& p) const {
    // A dished disc, leaning back and turned forward, with a root that joins it to the skull.
    const double lean = 11.0 * std::numbers::pi / 180.0;
    const double turn = 24.0 * std::numbers::pi / 180.0;
    const Vec3 normal(std::cos(turn), 0.0, std::sin(turn));
    const Vec3 up = Vec3(0.0, std::cos(lean), -std::sin(lean));
    const Vec3 tall = (up - up.dot(normal) * normal).normalized();
    const Vec3 wide = tall.cross(normal);
    const Vec3 r = p - Vec3(74, 3, -18);
    const double a = r.dot(tall) / 29.0;
    const double b = r.dot(wide) / 16.0;
    const double rim = a * a + b * b;
    const double dish = r.dot(normal) - 2.6 * rim + 2.0;
    const double outline = (std::sqrt(rim) - 1.0) * 16.0;
    double d = smooth_max(std::abs(dish) - 2.2, outline, 3.0);
    d = smooth_min(d, ellipsoid(p, {67, 2, -14}, {7, 20, 9}), 6.0);
    d = smooth_min(d, tube_distance(p, helix_), 3.5);
    d = smooth_min(d, tube_distance(p, antihelix_), 3.0);
    d = smooth_min(d, ellipsoid(p, {71.5, -21, -10}, {3.6, 8, 6}), 5.0);
    d = subtract(d, ellipsoid(p, {76, 0, -13}, {7, 9.5, 6.5}), 3.0);
    d = smooth_min(d, ellipsoid(p, {68.5, -1, -1.5}, {3, 6.5, 5}), 4.0);
    return d;
}

double HeadField::without_lips(const Vec3& q) const {
    const Vec3 p(std::sqrt(q.x() * q.x() + 0.36), q.y(), q.z());
    double d = eyes(bony_face(q), p);
    if (reaches(d, q, {0, 0, 95}, 45.0, 10.0)) {
        d = smooth_min(d, ellipsoid(q, {0, -32, 90}, {11.5, 7, 10}), 10.0);
        d = smooth_min(d, nose(q), 7.0);
        const Vec3 local = p - Vec3(7, -23.2, 101.6);
        const Eigen::AngleAxisd turn(20.0 * std::numbers::pi / 180.0, Vec3::UnitY());
        d = subtract(d, ellipsoid_local(turn * local, {2.9, 8.8, 4.9}), 1.8);
    }
    if (reaches(d, p, {75, 3, -15}, 40.0, 6.0)) {
        d = smooth_min(d, ear(p), 5.0);
    }
    return d;
}

double HeadField::operator()(const Vec3& q) const {
    const Vec3 p(std::sqrt(q.x() * q.x() + 0.36), q.y(), q.z());
    double d = without_lips(q);
    if (reaches(d, p, {31.5, 25, 75}, 20.0, 4.0)) {
        d = subtract(d, tube_distance(p, lid_crease_), 3.2);
    }
    if (reaches(d, q, {0, -45, 95}, 42.0, 11.0)) {
        d = smooth_min(d, tube_distance(p, philtral_column_), 6.0);
        d = subtract(d, tube_distance(q, philtral_groove_), 5.0);
        d = subtract(d, ellipsoid(q, {0, -68.2, 104.5}, {19, 5.5, 8}), 11.0);
        d = subtract(d, tube_distance(p, nasolabial_), 11.0);
        // Each lip blends with the skin, never with the other lip: that would fill the slit.
        d = std::min(smooth_min(d, tube_distance(q, upper_lip_), 2.6),
                     smooth_min(d, tube_distance(q, lower_lip_), 3.2));
    }
    return smooth_max(d, kNeckCut - q.y(), 16.0);
}

double HeadField::front_z(double x, double y) const {
    double z = 135.0;
    while (z > 0.0 && without_lips({x, y, z}) > 0.0) {
        z -= 1.0;
    }
    double low = z;
    double high = z + 1.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (without_lips({x, y, middle}) > 0.0 ? high : low) = middle;
    }
    return low;
}

Tube HeadField::snapped(const std::vector<Eigen::Vector4d>& points, bool across) const {
    Tube through;
    if (across) {  // mirror it: one tube from corner to corner
        for (auto q = points.rbegin(); q + 1 != points.rend(); ++q) {
            through.push_back({{-(*q)[0], (*q)[1], front_z((*q)[0], (*q)[1]) + (*q)[3]}, (*q)[2]});
        }
    }
    for (const auto& q : points) {
        through.push_back({{q[0], q[1], front_z(q[0], q[1]) + q[3]}, q[2]});
    }
    return smooth_tube(through, across ? 20 : 8);
}

Vec3 HeadField::onto_surface(const Vec3& p, bool keep_x) const {
    Vec3 at = p;
    for (int step = 0; step < 3; ++step) {
        constexpr double kStep = 1e-3;
        const double value = (*this)(at);
        Vec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 ahead = at;
            ahead[axis] += kStep;
            gradient[axis] = ((*this)(ahead)-value) / kStep;
        }
        if (keep_x) {
            gradient.x() = 0.0;
        }
        const double square = gradient.squaredNorm();
        if (square < 1e-6) {
            break;
        }
        Vec3 move = -value / square * gradient;
        const double longest = 3.0;
        if (move.norm() > longest) {
            move *= longest / move.norm();
        }
        at += move;
        if (std::abs(value) < 1e-4) {
            break;
        }
    }
    return at;
}

Vec3 HeadField::front_point(double x, double y) const {
    // The field is roughly a distance: half of it is a safe step.
    double z = 135.0;
    double step = 0.5;
    for (double value = (*this)({x, y, z}); z > 0.0 && value > 0.0; value = (*this)({x, y, z})) {
        step = std::max(0.5, 0.5 * value);
        z -= step;
    }
    double low = z;
    double high = z + step;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        ((*this)({x, y, middle}) > 0.0 ? high : low) = middle;
    }
    return {x, y, low};
}

}  // namespace myoface
