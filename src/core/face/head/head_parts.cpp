// SPDX-License-Identifier: Apache-2.0
#include "head_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace myoface {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Grid of rings from one pole to the other. `at(angle from the pole, turn)` gives points.
template <typename Surface>
void add_ball(MeshBuilder& builder, const std::vector<double>& angles, int around,
              const Surface& at) {
    const int pole = builder.add(at(0.0, 0.0));
    int previous = -1;
    for (const double angle : angles) {
        const int first = static_cast<int>(builder.vertices.size());
        for (int k = 0; k < around; ++k) {
            builder.add(at(angle, kTurn * k / around));
        }
        for (int k = 0; k < around; ++k) {
            const int next = (k + 1) % around;
            if (previous < 0) {
                builder.triangles.emplace_back(pole, first + k, first + next);
            } else {
                builder.add_quad(previous + k, first + k, first + next, previous + next);
            }
        }
        previous = first;
    }
    const int back = builder.add(at(std::numbers::pi, 0.0));
    for (int k = 0; k < around; ++k) {
        builder.triangles.emplace_back(previous + k, back, previous + (k + 1) % around);
    }
}

std::vector<double> even_angles(int rings) {
    std::vector<double> angles;
    for (int i = 1; i <= rings; ++i) {
        angles.push_back(std::numbers::pi * i / (rings + 1));
    }
    return angles;
}

double rounded(double x, double sharpness) {
    return std::copysign(std::pow(std::abs(x), sharpness), x);
}

/// The dental arch: an ellipse seen from above, front at the incisors.
struct Arch {
    double half_width, depth, front;
    Vec3 at(double angle, double y) const {
        return {half_width * std::sin(angle), y, front - depth * (1.0 - std::cos(angle))};
    }
    Vec3 along(double angle) const {
        return Vec3(half_width * std::cos(angle), 0.0, -depth * std::sin(angle)).normalized();
    }
};

Arch arch_of(const Vec3& mid_lips, bool upper) {
    constexpr double kBehindLips = 9.6;  // front of the upper incisors
    return upper ? Arch{26.0, 52.0, mid_lips.z() - kBehindLips}
                 : Arch{24.4, 50.0, mid_lips.z() - kBehindLips - 2.6};
}

}  // namespace

void add_eyeball(MeshBuilder& builder, const Vec3& centre, int around) {
    std::vector<double> angles{0.06, 0.12, kPupilAngle - 0.01, kPupilAngle + 0.01, 0.24,
                               0.33, 0.42, kIrisAngle - 0.035, kIrisAngle + 0.01,  0.58};
    for (double a = 0.72; a < 2.2; a += 0.2) {
        angles.push_back(a);
    }
    // The cornea: a smaller sphere set forward.
    constexpr double kCornea = 7.9;
    constexpr double kForward = 5.2;
    add_ball(builder, angles, around, [&](double angle, double turn) -> Vec3 {
        double radius = HeadField::kEyeRadius;
        if (angle < 0.8) {
            const double s = kForward * std::sin(angle);
            radius =
                std::max(radius, kForward * std::cos(angle) + std::sqrt(kCornea * kCornea - s * s));
        }
        return centre + radius * Vec3(std::sin(angle) * std::cos(turn),
                                      std::sin(angle) * std::sin(turn), std::cos(angle));
    });
}

void add_caruncle(MeshBuilder& builder, const Vec3& inner_canthus, const Vec3& eye_centre,
                  int around) {
    const Vec3 in = (eye_centre - inner_canthus).normalized();
    const Vec3 centre = inner_canthus + Vec3(1.9, -0.3, -2.6) + 2.4 * in;
    add_ball(builder, even_angles(5), std::max(around / 2, 8), [&](double angle, double turn) {
        return Vec3(centre + Vec3(2.7 * std::sin(angle) * std::cos(turn),
                                  1.6 * std::sin(angle) * std::sin(turn), 1.5 * std::cos(angle)));
    });
}

void add_teeth(MeshBuilder& builder, const Vec3& mid_lips, bool upper, int around) {
    struct Tooth {
        double breadth, height, thick;
    };
    constexpr std::array<Tooth, 7> kUpper{{{8.5, 10.5, 5.5},
                                           {6.6, 9.2, 5.0},
                                           {7.6, 10.0, 6.5},
                                           {7.0, 8.6, 8.0},
                                           {6.8, 8.0, 8.0},
                                           {10.2, 7.6, 9.5},
                                           {9.6, 7.2, 9.0}}};
    constexpr std::array<Tooth, 7> kLower{{{5.2, 9.0, 5.0},
                                           {5.8, 9.2, 5.0},
                                           {7.0, 10.5, 6.2},
                                           {7.0, 8.6, 7.0},
                                           {7.1, 8.0, 7.5},
                                           {11.0, 7.6, 9.5},
                                           {10.4, 7.2, 9.0}}};
    const Arch arch = arch_of(mid_lips, upper);
    // Upper incisors cover the lower ones by 2 mm and show a little below the upper lip.
    const double edge = mid_lips.y() + (upper ? -2.0 : 1.4);
    double angle = 0.0;
    double done = 0.0;
    for (const Tooth& tooth : upper ? kUpper : kLower) {
        const double middle = done + 0.5 * tooth.breadth;
        for (double walked = 0.0; walked < 0.5 * tooth.breadth; walked += 0.05) {
            const double speed =
                std::hypot(arch.half_width * std::cos(angle), arch.depth * std::sin(angle));
            angle += 0.05 / speed;
        }
        const Vec3 side = arch.along(angle);
        const Vec3 out(-side.z(), 0.0, side.x());
        const double up = upper ? 1.0 : -1.0;
        const Vec3 centre =
            arch.at(angle, edge + up * 0.5 * tooth.height) - 0.5 * tooth.thick * out;
        add_ball(builder, even_angles(around >= 12 ? 7 : 4), around,
                 [&](double polar, double turn) -> Vec3 {
                     const double c = rounded(std::cos(polar), 0.55);
                     const double s = std::pow(std::sin(polar), 0.45);
                     // Crowns narrow towards the gum and thin out towards the edge.
                     const double to_gum = 0.5 - 0.5 * c;  // 0 at the edge
                     const double broad = 0.5 * tooth.breadth * (0.95 - 0.16 * to_gum);
                     const double thick = 0.5 * tooth.thick * (0.55 + 0.45 * to_gum);
                     return centre - up * 0.5 * tooth.height * c * Vec3::UnitY() +
                            (up > 0 ? 1.0 : -1.0) * broad * s * rounded(std::cos(turn), 0.7) *
                                side +
                            thick * s * rounded(std::sin(turn), 0.7) * out;
                 });
        for (double walked = 0.0; walked < 0.5 * tooth.breadth; walked += 0.05) {
            const double speed =
                std::hypot(arch.half_width * std::cos(angle), arch.depth * std::sin(angle));
            angle += 0.05 / speed;
        }
        done = middle + 0.5 * tooth.breadth;
    }
}

void add_gum(MeshBuilder& builder, const Vec3& mid_lips, bool upper, int around) {
    const Arch arch = arch_of(mid_lips, upper);
    const double up = upper ? 1.0 : -1.0;
    const double root = mid_lips.y() + (upper ? 9.8 : -8.6);
    const int spans = std::max(2 * around, 12);
    constexpr double kLast = 1.35;  // behind the last molar [rad]
    std::vector<int> previous;
    for (int i = 0; i <= spans; ++i) {
        const double angle = kLast * i / spans;
        const Vec3 side = arch.along(angle);
        const Vec3 out(-side.z(), 0.0, side.x());
        const double thick = 4.0 + 1.2 * angle;
        // Scalloped: it dips between the teeth.
        const Vec3 centre = arch.at(angle, root) - (thick + 0.2) * out;
        std::vector<int> ring;
        for (int k = 0; k < around; ++k) {
            const double turn = kTurn * k / around;
            Vec3 p = centre + (thick + 0.4) * std::cos(turn) * out +
                     3.2 * std::sin(turn) * up * Vec3::UnitY();
            if (i == 0) {
                p.x() = 0.0;
            }
            ring.push_back(builder.add(p));
        }
        for (int k = 0; k < around && !previous.empty(); ++k) {
            const int next = (k + 1) % around;
            if (upper) {
                builder.add_quad(previous[k], ring[k], ring[next], previous[next]);
            } else {
                builder.add_quad(previous[k], previous[next], ring[next], ring[k]);
            }
        }
        previous = std::move(ring);
    }
    const int end =
        builder.add(arch.at(kLast + 0.06, root) -
                    (4.0 + 1.2 * kLast) * Vec3(-arch.along(kLast).z(), 0.0, arch.along(kLast).x()));
    for (int k = 0; k < around; ++k) {
        const int next = (k + 1) % around;
        if (upper) {
            builder.triangles.emplace_back(previous[k], end, previous[next]);
        } else {
            builder.triangles.emplace_back(previous[k], previous[next], end);
        }
    }
}

}  // namespace myoface
