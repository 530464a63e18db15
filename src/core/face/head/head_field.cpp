// SPDX-License-Identifier: Apache-2.0
#include "head_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "myoface/base/smooth_step.h"

#include "head_contour.h"
#include "primitives.h"

namespace myoface {
namespace {

using Bead = HeadField::Bead;
using Tube = HeadField::Tube;

double sphere(const Vec3& p, const Vec3& centre, double radius) {
    return (p - centre).norm() - radius;
}

/// An ellipsoid, its front turned towards +x by an angle [degrees].
double turned_ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii, double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vec3 d = p - centre;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return ellipsoid_local({c * d.x() - s * d.z(), d.y(), s * d.x() + c * d.z()}, radii);
}

/// Distance to a chain of beads joined by cones; a lower bound that is larger than `limit` where
/// it is further off than that.
double tube_distance(const Vec3& p, const Tube& tube, double limit) {
    const double off = tube.box.exteriorDistance(p);
    if (off > limit) {
        return off;
    }
    double best = std::numeric_limits<double>::infinity();
    const std::vector<Bead>& beads = tube.beads;
    for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
        best = std::min(best, capsule(p, beads[i].centre, beads[i + 1].centre, beads[i].radius,
                                      beads[i + 1].radius));
    }
    return best;
}

/// Joins or takes away a tube, which is looked at only where its blend reaches.
double with_tube(double d, const Vec3& p, const Tube& tube, double k) {
    return smooth_min(d, tube_distance(p, tube, d + k), k);
}
double without_tube(double d, const Vec3& p, const Tube& tube, double k) {
    return subtract(d, tube_distance(p, tube, k - d), k);
}

/// Catmull-Rom centre line through the given beads, sampled `per_span` times a span.
Tube smooth_tube(const std::vector<Bead>& through, int per_span = 8) {
    std::vector<Bead> result;
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
    Tube tube;
    for (const Bead& bead : result) {
        tube.box.extend(Vec3(bead.centre.array() - bead.radius));
        tube.box.extend(Vec3(bead.centre.array() + bead.radius));
    }
    tube.beads = std::move(result);
    return tube;
}

constexpr double kCrown = 2.6;  // exponent of the super-ellipse that closes the skull

/// Skips a primitive that lies too far off to change d.
bool reaches(double d, const Vec3& p, const Vec3& centre, double bound, double k) {
    return (p - centre).norm() - bound < d + k + 4.0;
}

}  // namespace

HeadField::HeadField()
    : front_({-110, -97, -85, -70, -50, -30, -15, 0, 20, 36, 50},
             {72, 85, 91, 93, 94.5, 91, 88, 86, 88, 94, 95.5}),
      back_({-110, -97, -85, -70, -50, -30, -15, 0, 20, 36, 50},
            {-46, -52, -58, -64, -71, -78, -82, -86, -94, -97.5, -98.5}),
      half_width_({-110, -97, -85, -70, -50, -30, -15, 0, 20, 36, 50},
                  {34, 38, 43, 49, 56, 61.5, 65, 67.5, 70.5, 72.5, 73.5}),
      width_z_({-110, -97, -85, -70, -50, -30, -15, 0, 20, 36, 50},
               {12, 11, 10, 7, 2, -3, -7, -10, -10, -9, -8}),
      exponent_({-110, -97, -85, -70, -50, -30, -15, 0, 20, 36, 50},
                {1.8, 1.85, 1.9, 1.95, 2.1, 2.3, 2.4, 2.4, 2.3, 2.15, 2.05}),
      ridge_z_({-30, -24, -18, -13, -8, 0, 8, 15, 21, 26, 32, 40},
               {86, 100, 110.4, 113.8, 112.4, 108.8, 104.0, 99.8, 97.4, 96.8, 95.8, 90}),
      ridge_slope_({-18, -10, 0, 10, 20, 30}, {.85, .74, .68, .72, .95, 1.6}),
      ridge_round_({-18, 0, 12, 30}, {7, 5.5, 6, 10}),
      upper_lid_({16.1, 18.5, 22, 26, 30, 34, 38, 41.5, 43.6},
                 {16.3, 18.1, 20.3, 21.6, 22.1, 21.9, 20.9, 19.4, 17.95}),
      lower_lid_({16.1, 18.5, 22, 26, 30, 34, 38, 41.5, 43.6},
                 {16.3, 14.8, 13.2, 12.1, 11.7, 11.9, 13.1, 15.6, 17.95}),
      lip_line_({0, 6, 13, 20, 24.5}, {-52, -51.8, -51.95, -52, -52.2}) {
    mandible_ = smooth_tube({{{48, -34, 6}, 9},
                             {{46.5, -56, 13}, 10},
                             {{41.5, -68, 34}, 11.5},
                             {{30, -78, 56}, 11.5},
                             {{13, -84, 72}, 9}});
    brow_ = smooth_tube({{{5, 34, 86}, 5.5},
                         {{16, 36, 85}, 6},
                         {{28, 37, 82.2}, 6},
                         {{39, 34.5, 75.5}, 5.8},
                         {{48, 26.5, 64}, 5.5}});
    sternomastoid_ = smooth_tube({{{53, -30, -27}, 8}, {{35, -95, 0}, 8}, {{10, -165, 22}, 7}});
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
    alar_groove_ = smooth_tube({{{19.0, -19.0, 92.8}, 0.2},
                                {{19.2, -22.5, 92.4}, 0.35},
                                {{18.6, -26.0, 92.2}, 0.3},
                                {{17.2, -28.6, 92.4}, 0.1}});
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
        snapped({{4.6, -35, 0.9, -2.4}, {5.4, -38.5, 1.2, -2.2}, {6.2, -43.6, 1.2, -1.7}}, false);
    philtral_groove_ =
        snapped({{0, -35, 2.0, 3.4}, {0, -39, 2.3, 3.0}, {0, -43.5, 2.3, 3.0}}, false);
    nasolabial_ = snapped(
        {{20, -22, .8, 2.9}, {25, -29, .8, 2.9}, {30, -39, .8, 2.9}, {33.5, -49, .8, 3.1}}, false);
    upper_lip_ = snapped({{0, -48.5, 3.3, -1.2},
                          {5.6, -47.9, 3.5, -1.2},
                          {13, -49, 2.8, -1.3},
                          {19.5, -50.7, 1.8, -1.2},
                          {24.3, -52.1, .9, -1.2}},
                         true);
    lower_lip_ = snapped({{0, -56.4, 4.1, -.3},
                          {6, -56.2, 4.1, -.3},
                          {13, -55.4, 3.5, -.1},
                          {19, -54, 2.2, -.5},
                          {24, -52.7, .9, -.9}},
                         true);
    lip_groove_ = snapped({{0, -52, .3, 2.4},
                           {6, -51.8, .4, 2.4},
                           {13, -51.95, .4, 1.7},
                           {18, -52, .4, 1.1},
                           {21.5, -52.1, .3, 1.5},
                           {24.5, -52.2, .1, 3.0}},
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
    const double level = std::pow(section, kCrown / n) + std::pow(crown, kCrown);
    const double ratio = std::pow(level, 1.0 / kCrown);
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
    if (reaches(d, p, {32, -62, 36}, 54.0, 22.0)) {
        d = with_tube(d, p, mandible_, 22.0);
    }
    if (reaches(d, p, {26, 37, 78}, 34.0, 20.0)) {
        d = with_tube(d, p, brow_, 20.0);
    }
    d = smooth_min(d, ellipsoid(q, {0, 39, 82.5}, {18, 12, 12.2}), 18.0);
    d = smooth_min(d, ellipsoid(broad, {18, 58, 60}, {30, 28, 32}), 24.0);
    d = smooth_min(d, ellipsoid(q, {0, -50, 66}, {28, 25, 30}), 20.0);
    d = smooth_min(d, turned_ellipsoid(p, {42, -4, 56}, {17, 12, 12}, 40.0), 18.0);
    d = smooth_min(d, capsule(p, {48, -5, 42}, {54, -2, 10}, 6.0, 5.0), 18.0);
    d = smooth_min(d, ellipsoid(p, {34, -28, 54}, {20, 26, 23}), 20.0);
    d = subtract(d, ellipsoid(p, {102, 36, 50}, {27, 31, 38}), 38.0);

    const Vec3 axis = Vec3(0, -150, -28).normalized();
    const Vec3 from_axis = q - Vec3(0, -40, -10);
    const Vec3 radial = from_axis - from_axis.dot(axis) * axis;
    const double neck = Vec3(radial.x() / 49.5, radial.y() / 55.0, radial.z() / 55.0).norm();
    const double neck_top = q.y() + 20.0;  // the neck ends inside the head
    const double neck_distance = smooth_max(53.0 * (neck - 1.0), neck_top, 20.0);
    d = smooth_min(d, neck_distance, 16.0);
    if (reaches(d, p, {34, -98, 0}, 92.0, 22.0)) {
        d = with_tube(d, p, sternomastoid_, 22.0);
    }
    d = smooth_min(d, ellipsoid(q, {0, -124, 15}, {11, 18, 11}), 18.0);
    d = smooth_min(d, capsule(p, {48, -20, -10}, {41, -66, -4}, 10.0, 11.0), 26.0);
    d = smooth_min(d, capsule(q, {0, -83, 66}, {0, -86, 36}, 14.0, 17.0), 18.0);
    d = smooth_min(d, capsule(p, {25, -78, 40}, {36, -70, 6}, 9.0, 11.0), 20.0);
    return d;
}

double HeadField::eyes(double d, const Vec3& p) const {
    if (!reaches(d, p, {30, 18, 75}, 40.0, 15.0)) {
        return d;
    }
    d = subtract(d, turned_ellipsoid(p, {28.5, 18.8, 95}, {17.5, 10.4, 17.0}, 18.0), 13.0);
    d = subtract(d, ellipsoid(p, {15.5, 13.5, 94.5}, {4.8, 8, 15}), 9.0);
    d = smooth_min(d, sphere(p, kEyeCentre, 14.0), 5.0);
    return d;
}

double HeadField::nose_ridge(const Vec3& q) const {
    const double e = ridge_round_(q.y());
    const double s = ridge_slope_(q.y());
    const double root = std::sqrt(q.x() * q.x() + e * e);
    const double side = q.x() / (s * root);
    double ridge = (q.z() - (ridge_z_(q.y()) - (root - e) / s)) / std::sqrt(1.0 + side * side);
    const double bound =
        std::max({std::abs(q.y() - 2.0) - 36.0, std::abs(q.x()) - 22.0, 62.0 - q.z()});
    return smooth_max(ridge, bound, 6.0);
}

double HeadField::nose(const Vec3& q) const {
    const Vec3 p(std::sqrt(q.x() * q.x() + 0.36), q.y(), q.z());
    double d = nose_ridge(q);
    d = smooth_min(d, sphere(q, {0, -17.4, 112.4}, 5.3), 9.0);
    d = smooth_min(d, sphere(p, {4.0, -18.6, 109.2}, 4.7), 6.0);
    d = smooth_min(d, capsule(p, {4.0, -14.0, 106}, {8.0, -8, 96.0}, 4.6, 4.4), 8.0);
    const Vec3 local = p - Vec3(11.9, -21.4, 97.8);
    const Eigen::AngleAxisd turn(24.0 * std::numbers::pi / 180.0, Vec3::UnitY());
    d = smooth_min(d, ellipsoid_local(turn * local, {4.6, 6.4, 10.4}), 4.2);
    d = smooth_min(d, capsule(q, {0, -27, 98.5}, {0, -21.3, 109}, 3.2, 3.8), 5.0);
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
    d = with_tube(d, p, helix_, 3.5);
    d = with_tube(d, p, antihelix_, 3.0);
    d = smooth_min(d, ellipsoid(p, {71.5, -21, -10}, {3.6, 8, 6}), 5.0);
    d = subtract(d, ellipsoid(p, {76, 0, -13}, {7, 9.5, 6.5}), 3.0);
    d = smooth_min(d, ellipsoid(p, {68.5, -1, -1.5}, {3, 6.5, 5}), 4.0);
    return d;
}

double HeadField::nostril(const Vec3& q) const {
    // Leans inwards and forward on its way up; long axis towards the tip.
    const Vec3 local = Vec3(std::abs(q.x()), q.y(), q.z()) - Vec3(6.6, -20.2, 100.4);
    const Eigen::AngleAxisd turn(24.0 * std::numbers::pi / 180.0, Vec3::UnitY());
    const Eigen::AngleAxisd lean(-10.0 * std::numbers::pi / 180.0, Vec3::UnitZ());
    return ellipsoid_local(turn * (lean * local), {3.2, 9.6, 5.5});
}

double HeadField::without_lips(const Vec3& q) const {
    const Vec3 p(std::sqrt(q.x() * q.x() + 0.36), q.y(), q.z());
    double d = eyes(bony_face(q), p);
    if (reaches(d, q, {0, 0, 95}, 45.0, 10.0)) {
        d = smooth_min(d, ellipsoid(q, {0, -32, 90}, {11.5, 7, 10}), 10.0);
        d = smooth_min(d, nose(q), 7.0);
        d = without_tube(d, p, alar_groove_, 5.0);
        d = subtract(d, nostril(p), 1.8);
    }
    if (reaches(d, p, {75, 3, -15}, 40.0, 6.0)) {
        d = smooth_min(d, ear(p), 5.0);
    }
    return d;
}

Vec3 HeadField::in_primitives(const Vec3& p) const {
    return p - contour_shift(average_contour(), p);
}

double HeadField::operator()(const Vec3& p) const {
    return primitives(in_primitives(p));
}

double HeadField::smooth_face(const Vec3& p) const {
    const Vec3 q = in_primitives(p);
    double d = bony_face(q);
    // The bridge of the nose is bone; its lower half is not.
    const double ridge =
        smooth_max(nose_ridge(q) + 0.35 * std::max(0.0, 12.0 - q.y()), 5.0 - q.y(), 8.0);
    return smooth_min(d, ridge, 7.0);
}

double HeadField::primitives(const Vec3& q) const {
    const Vec3 p(std::sqrt(q.x() * q.x() + 0.36), q.y(), q.z());
    double d = without_lips(q);
    if (reaches(d, p, {31.5, 25, 75}, 20.0, 4.0)) {
        d = without_tube(d, p, lid_crease_, 3.2);
    }
    if (reaches(d, q, {0, -45, 95}, 42.0, 11.0)) {
        d = with_tube(d, p, philtral_column_, 6.0);
        d = without_tube(d, q, philtral_groove_, 5.0);
        d = subtract(d, ellipsoid(q, {0, -68.2, 104.5}, {19, 5.5, 8}), 11.0);
        d = without_tube(d, p, nasolabial_, 11.0);
        // Each lip blends with the skin for itself. Where they meet only a shallow groove is left:
        // the mesh is slit there, and no triangle must dive into a crease.
        d = smooth_min(with_tube(d, q, upper_lip_, 4.2), with_tube(d, q, lower_lip_, 4.2), 1.2);
        d = without_tube(d, q, lip_groove_, 4.0);
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
    std::vector<Bead> through;
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

namespace {

/// The field is roughly a distance: half of it is a safe step.
template <typename Field>
Vec3 foremost(const Field& field, double x, double y) {
    double z = 135.0;
    double step = 0.5;
    for (double value = field({x, y, z}); z > 0.0 && value > 0.0; value = field({x, y, z})) {
        step = std::max(0.5, 0.5 * value);
        z -= step;
    }
    double low = z;
    double high = z + step;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (field({x, y, middle}) > 0.0 ? high : low) = middle;
    }
    return {x, y, low};
}

}  // namespace

Vec3 HeadField::from_primitives(const Vec3& q) const {
    Vec3 p = q;
    for (int i = 0; i < 30; ++i) {
        p = q + contour_shift(average_contour(), p);
    }
    return p;
}

Vec3 HeadField::front_point(double x, double y) const {
    return foremost([this](const Vec3& p) { return (*this)(p); }, x, y);
}

Vec3 HeadField::front_point_at(double x, double y) const {
    return from_primitives(foremost([this](const Vec3& p) { return primitives(p); }, x, y));
}

}  // namespace myoface
