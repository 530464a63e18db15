// SPDX-License-Identifier: Apache-2.0
#include "head_colour.h"

#include <algorithm>
#include <cmath>

#include "myoface/base/smooth_step.h"

#include "head_parts.h"
#include "spline.h"

namespace myoface {
namespace {

Vec3 mixed(const Vec3& a, const Vec3& b, double share) {
    return a + share * (b - a);
}

/// A random number 0 … 1 of a lattice point.
double lattice(int x, int y, int z) {
    auto h = static_cast<std::uint32_t>(x) * 0x8da6b343U ^
             static_cast<std::uint32_t>(y) * 0xd8163841U ^
             static_cast<std::uint32_t>(z) * 0xcb1ab31fU;
    h = (h ^ (h >> 15U)) * 0x2c1b3c6dU;
    h = (h ^ (h >> 12U)) * 0x297a2d39U;
    return static_cast<double>((h ^ (h >> 15U)) & 0xffffffU) / 16777216.0;
}

/// Smooth noise, -1 … 1, with features of about unit size.
double noise(const Vec3& p) {
    const Vec3 low = p.array().floor().matrix();
    const Vec3 t = p - low;
    const Vec3 s = (t.array() * t.array() * (3.0 - 2.0 * t.array())).matrix();
    const auto at = [&](int dx, int dy, int dz) {
        return lattice(static_cast<int>(low.x()) + dx, static_cast<int>(low.y()) + dy,
                       static_cast<int>(low.z()) + dz);
    };
    double sum = 0.0;
    for (int k = 0; k < 8; ++k) {
        const int dx = k & 1;
        const int dy = (k >> 1) & 1;
        const int dz = (k >> 2) & 1;
        sum += (dx != 0 ? s.x() : 1.0 - s.x()) * (dy != 0 ? s.y() : 1.0 - s.y()) *
               (dz != 0 ? s.z() : 1.0 - s.z()) * at(dx, dy, dz);
    }
    return 2.0 * sum - 1.0;
}

Vec3 eye_colour(const Vec3& local, bool fine) {
    const double angle = std::acos(std::clamp(local.normalized().z(), -1.0, 1.0));
    const Vec3 sclera(0.87, 0.845, 0.825);
    Vec3 iris = mixed({0.40, 0.30, 0.20}, {0.25, 0.20, 0.15}, smooth_step(0.25, kIrisAngle, angle));
    if (fine) {
        const double turn = std::atan2(local.y(), local.x());
        const double rays = noise({turn * 14.0, angle * 6.0, 3.0});
        iris += 0.05 * rays * Vec3(1.0, 0.85, 0.6);
    }
    Vec3 colour =
        mixed(iris, {0.12, 0.10, 0.09}, smooth_step(kIrisAngle - 0.09, kIrisAngle - 0.03, angle));
    colour = mixed(colour, sclera, smooth_step(kIrisAngle - 0.03, kIrisAngle + 0.02, angle));
    colour = mixed(Vec3(0.02, 0.02, 0.02), colour,
                   smooth_step(kPupilAngle - 0.01, kPupilAngle + 0.01, angle));
    // The upper lid throws a shadow on the ball.
    const double shade = smooth_step(0.05, 0.5, local.normalized().y());
    return mixed(mixed(colour, {0.80, 0.62, 0.58}, 0.5 * smooth_step(0.8, 1.2, angle)),
                 {0.2, 0.14, 0.12}, 0.45 * shade);
}

const Spline& brow_line() {
    static const Spline kBrow({7, 12, 18, 26, 34, 42, 50},
                              {32.6, 33.9, 35.0, 36.8, 37.2, 34.8, 30.2});
    return kBrow;
}

/// Share of brow hair at a place.
double brow(const Vec3& q, double x, const HeadLook& look, bool fine) {
    const double lift = 0.9 - 1.1 * look.masculine;
    const double off = q.y() - brow_line()(x) - lift * (0.4 + 0.6 * smooth_step(16.0, 34.0, x));
    const double half = (2.9 + 0.8 * look.masculine) * smooth_step(5.0, 13.0, x) *
                        (1.0 - 0.62 * smooth_step(25.0, 50.0, x));
    if (half < 0.1 || q.z() < 45.0) {
        return 0.0;
    }
    double share = smooth_step(half + 0.7, half - 1.5, std::abs(off)) * smooth_step(6.5, 12.0, x) *
                   smooth_step(52.0, 44.0, x);
    if (fine && share > 0.0) {
        // Hairs lean outwards: streaks along a slanted direction.
        const double slant = 0.9 - 0.6 * smooth_step(14.0, 32.0, x);
        const double across = q.y() * 0.55 - (x - slant * q.y()) * 1.6;
        share *= 0.72 + 0.5 * noise({across, 0.22 * (x + q.y()), 7.0});
    }
    return std::clamp(share, 0.0, 1.0);
}

/// Distance in the frontal plane from a lid margin, positive on the skin's side.
double lid_distance(const Vec3& q, double x, bool upper) {
    const HeadField& head = average_head();
    constexpr double kStep = 0.2;
    const auto height = [&](double at) { return upper ? head.upper_lid(at) : head.lower_lid(at); };
    const double slope = (height(x + kStep) - height(x - kStep)) / (2.0 * kStep);
    const double off = (q.y() - height(x)) / std::sqrt(1.0 + slope * slope);
    return upper ? off : -off;
}

double lips(const Vec3& q, double x, double soft) {
    static const Spline kUpperBorder({0, 3, 6.2, 10, 14, 19, 22.5, 25},
                                     {-45.4, -44.8, -44.2, -45.4, -46.8, -49.2, -51.1, -52.3});
    static const Spline kLowerBorder({0, 6, 12, 17, 21, 25},
                                     {-60.2, -60, -58.6, -56.5, -54.2, -52.4});
    return smooth_step(-soft, soft, kUpperBorder(x) - q.y()) *
           smooth_step(-soft, soft, q.y() - kLowerBorder(x)) * smooth_step(25.5, 23.0, x) *
           smooth_step(70, 80, q.z());
}

const Vec3 kNostrilColour(0.31, 0.14, 0.12);

double hair(const Vec3& q, double x, const HeadLook& look, bool fine) {
    double line = q.z() > 0.0
                      ? 86.0 - 30.0 * smooth_step(40, 76, x) - 30.0 * smooth_step(42, -5, q.z())
                      : 24.0 - 62.0 * smooth_step(0, -62, q.z());
    line += look.old * look.masculine * 8.0 * smooth_step(20.0, 60.0, q.z());
    // A sideburn before the ear, bare skin around it.
    const double near_ear =
        smooth_step(24, 10, (Vec3(x, q.y(), q.z()) - Vec3(77, 3, -18)).norm() - 17.0);
    double share = smooth_step(-6.0, 8.0, q.y() - line + (fine ? 2.5 * noise(q / 6.0) : 0.0)) *
                   (1.0 - near_ear * smooth_step(66, 72, x));
    if (fine && share > 0.0) {
        share *= 0.86 + 0.14 * noise(q * 1.4) + 0.10 * noise(q * 0.6);
    }
    return std::clamp(share, 0.0, 1.0);
}

Vec3 skin(const Vec3& p, const HeadLook& look, bool fine) {
    const Vec3 q = average_head().in_primitives(p);
    const double x = std::abs(q.x());
    Vec3 colour(0.825, 0.64, 0.55);
    colour = mixed(colour, {0.80, 0.60, 0.50}, 0.25 * (look.masculine + 1.0) * 0.5);
    colour = mixed(colour, {0.80, 0.66, 0.58}, 0.35 * look.old);
    // A little blood in cheeks, nose and ears; none over the forehead.
    const double blush = 0.30 * bump((Vec3(x, q.y(), 0) - Vec3(41, -12, 0)).norm() / 24.0) *
                             smooth_step(20, 50, q.z()) +
                         0.30 * bump((Vec3(x, q.y(), 0) - Vec3(4, -20, 0)).norm() / 13.0) *
                             smooth_step(85, 100, q.z()) +
                         0.30 * smooth_step(70, 78, x) +
                         0.12 * bump((q.y() + 84) / 14.0) * smooth_step(60, 85, q.z());
    colour = mixed(colour, {0.80, 0.49, 0.42}, std::min(blush, 0.5));
    if (q.z() > 55.0) {
        const double lids = bump((q.y() - 17.0) / 9.0) * bump((x - 30.0) / 16.0);
        colour = mixed(colour, {0.71, 0.48, 0.42}, 0.32 * lids);
        const double under =
            bump((q.y() - 6.0 + 0.12 * (x - 28.0)) / 4.5) * bump((x - 25.0) / 11.0);
        colour = mixed(colour, {0.62, 0.45, 0.44}, (0.16 + 0.2 * look.old) * under);
    }
    colour = mixed(colour, kNostrilColour, nostril_share(q));
    if (look.stubble > 0.0 && q.z() > 0.0) {
        // Moustache, chin, jaw and throat; lips and the hollow beside the lower lip stay free.
        // Its upper border hangs from the wings of the nose and rises to the sideburns.
        const double border =
            -33.0 - 9.0 * smooth_step(12.0, 34.0, x) + 36.0 * smooth_step(50.0, 66.0, x);
        double beard = smooth_step(5.0, -7.0, q.y() - border + 2.5 * noise(q / 5.0)) *
                       smooth_step(-128.0, -104.0, q.y()) * smooth_step(-6.0, 16.0, q.z());
        beard *= 1.0 - lips(q, x, 2.2);
        if (fine) {
            beard *= 0.75 + 0.6 * noise(q * 2.2);
        }
        colour = mixed(colour, {0.42, 0.36, 0.34}, 0.5 * look.stubble * std::clamp(beard, 0., 1.));
    }
    const double vermilion = lips(q, x, fine ? 0.55 : 0.9);
    Vec3 lip = mixed({0.72, 0.42, 0.39}, {0.68, 0.44, 0.41}, 0.5 + 0.5 * look.masculine);
    lip = mixed(lip, {0.70, 0.50, 0.46}, 0.6 * look.old);
    if (fine) {
        lip += 0.035 * noise({x * 1.1, q.y() * 0.12, 1.0}) * Vec3::Ones();
    }
    colour = mixed(colour, lip, 0.88 * vermilion);
    if (x < 26.0 && q.z() > 70.0) {  // where the lips meet it is dark
        const double slit = bump((q.y() - average_head().lip_line(x)) / (fine ? 0.55 : 0.7)) *
                            smooth_step(25.6, 22.5, x);
        colour = mixed(colour, {0.36, 0.15, 0.14}, 0.75 * slit);
    }
    if (fine) {
        colour *= 1.0 + 0.018 * noise(p * 0.9) + 0.012 * noise(p * 2.3) + 0.02 * noise(p * 0.18);
        const Vec3 shift(0.37 * look.seed, 0.11 * look.seed, 0.0);
        // Two grids turned against each other: round spots instead of the lattice's.
        const Vec3 turned(0.8 * p.x() + 0.6 * p.y(), 0.8 * p.y() - 0.6 * p.x(), p.z());
        const double spot = 0.5 * (noise(p * 0.23 + shift) + noise(turned * 0.31 - shift));
        colour =
            mixed(colour, {0.62, 0.43, 0.34},
                  (0.12 + 0.25 * look.old) * smooth_step(0.50, 0.68, spot) * (1.0 - vermilion));
    }
    const double grey = 0.75 * look.old;
    const Vec3 hair_colour = mixed({0.235, 0.175, 0.14}, {0.55, 0.53, 0.51}, grey);
    colour = mixed(colour, hair_colour, 0.8 * brow(q, x, look, fine));
    if (q.z() > 60.0 && x > 15.0 && x < 46.0) {
        // Lashes: a dark line on the margins, fuller on the upper lid and outwards.
        const double out = smooth_step(17.0, 24.0, x) * smooth_step(46.0, 42.5, x);
        const double width = fine ? 0.75 : 0.5;
        const double upper = std::abs(lid_distance(q, x, true));
        const double lower = std::abs(lid_distance(q, x, false));
        const double lash = std::max(smooth_step(width + 0.5, width * 0.3, upper),
                                     0.45 * smooth_step(width, width * 0.2, lower)) *
                            out;
        colour = mixed(colour, {0.16, 0.11, 0.09}, (0.72 - 0.2 * look.masculine) * lash);
    }
    return mixed(colour, mixed({0.30, 0.235, 0.20}, {0.56, 0.54, 0.52}, grey),
                 0.68 * hair(q, x, look, fine));
}

}  // namespace

double nostril_share(const Vec3& q) {
    if (q.z() < 86.0 || std::abs(q.x()) > 14.0 || q.y() > -6.0 || q.y() < -33.0) {
        return 0.0;
    }
    return 0.95 * smooth_step(1.0, 0.1, average_head().nostril(q)) *
           smooth_step(-30.0, -25.5, q.y());
}

Vec3 head_colour(HeadPart part, const Vec3& p, const HeadLook& look, bool fine) {
    switch (part) {
        case HeadPart::Skin:
            return skin(p, look, fine).cwiseMax(0.0).cwiseMin(1.0);
        case HeadPart::LidMargin:
            return {0.77, 0.53, 0.48};
        case HeadPart::Mouth:
            return {0.45, 0.19, 0.18};
        case HeadPart::Caruncle:
            return {0.79, 0.57, 0.53};
        case HeadPart::Tooth:
            return {0.87, 0.83, 0.75};
        case HeadPart::Gum:
            return {0.68, 0.36, 0.35};
        case HeadPart::Eye: {
            const Vec3 centre =
                average_head().eye_centre().cwiseProduct(Vec3(p.x() > 0.0 ? 1.0 : -1.0, 1.0, 1.0));
            return eye_colour(p - centre, fine);
        }
    }
    return Vec3::Ones();
}

}  // namespace myoface
