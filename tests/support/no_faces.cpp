// SPDX-License-Identifier: Apache-2.0
#include "no_faces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "myoface/face/generic_face.h"
#include "myoface/mesh/isosurface.h"

#include "test_meshes.h"

namespace myoface::test {
namespace {

double ball(const Vec3& p, const Vec3& at, double radius) {
    return (p - at).norm() - radius;
}

double egg(const Vec3& p, const Vec3& at, const Vec3& radii) {
    return ((p - at).cwiseQuotient(radii).norm() - 1.0) * radii.minCoeff();
}

double stick(const Vec3& p, const Vec3& a, const Vec3& b, double radius) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - t * (b - a)).norm() - radius;
}

double joined(double a, double b, double width = 10.0) {
    const double h = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - 0.25 * width * h * h;
}

double brick(const Vec3& p, const Vec3& half) {
    const Vec3 q = p.cwiseAbs() - half;
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

TriangleMesh solid(const ScalarField& field, double half = 160.0) {
    return isosurface(field, {Vec3::Constant(-half), Vec3::Constant(half)}, half / 32.0);
}

/// The triangles of a head whose middle passes a test.
TriangleMesh part_of_head(const std::function<bool(const Vec3&)>& keep) {
    GenericFaceOptions options;
    options.vertices = 12000;
    TriangleMesh mesh = make_generic_face(options).scan.mesh;
    Eigen::Index n = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 c = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
        if (keep(c)) {
            mesh.triangles.col(n++) = mesh.triangles.col(t);
        }
    }
    mesh.triangles.conservativeResize(3, n);
    return mesh;
}

TriangleMesh terrain(std::uint32_t seed, double height) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    TriangleMesh mesh = grid(70, 3.0);
    for (int wave = 0; wave < 24; ++wave) {
        const Vec3 k(0.09 * uniform(random), 0.09 * uniform(random), 0.0);
        const double phase = 6.0 * uniform(random);
        for (Eigen::Index v = 0; v < mesh.vertices.cols(); ++v) {
            mesh.vertices(2, v) +=
                height / 5.0 * std::sin(k.dot(Vec3(mesh.vertices.col(v))) + phase);
        }
    }
    return mesh;
}

}  // namespace

std::vector<NoFace> no_faces() {
    std::vector<NoFace> list;
    const auto add = [&](const char* name, TriangleMesh mesh) {
        list.push_back({name, std::move(mesh)});
    };
    add("cube", solid([](const Vec3& p) { return brick(p, {80, 80, 80}); }));
    add("box", solid([](const Vec3& p) { return brick(p, {100, 60, 25}); }));
    add("ball", sphere(100.0, 40, 60));
    add("egg", solid([](const Vec3& p) { return egg(p, Vec3::Zero(), {75, 110, 95}); }));
    add("flat sheet", grid(60, 4.0));
    add("ring", solid([](const Vec3& p) {
            return std::hypot(std::hypot(p.x(), p.y()) - 80.0, p.z()) - 28.0;
        }));
    add("cylinder", solid([](const Vec3& p) {
            return std::max(std::hypot(p.x(), p.z()) - 60.0, std::abs(p.y()) - 120.0);
        }));
    add("cone", solid([](const Vec3& p) {
            return std::max(std::hypot(p.x(), p.z()) - 0.5 * (110.0 - p.y()), -100.0 - p.y());
        }));
    add("mug", solid([](const Vec3& p) {
            const double cup = std::max(std::hypot(p.x(), p.z()) - 55.0, std::abs(p.y()) - 70.0);
            const double hole = std::max(std::hypot(p.x(), p.z()) - 48.0, -62.0 - p.y());
            const double handle = std::hypot(std::hypot(p.x() - 60.0, p.y()) - 35.0, p.z()) - 8.0;
            return std::min(std::max(cup, -hole), std::max(handle, 52.0 - p.x()));
        }));
    add("snowman", solid([](const Vec3& p) {
            return joined(joined(ball(p, {0, -80, 0}, 70), ball(p, {0, 30, 0}, 50)),
                          ball(p, {0, 105, 0}, 34));
        }));
    add("rabbit", solid([](const Vec3& p) {
            double d = joined(egg(p, {0, -50, 0}, {70, 75, 90}), ball(p, {0, 45, 55}, 50), 25.0);
            d = joined(d, stick(p, {20, 80, 45}, {32, 150, 20}, 12));
            d = joined(d, stick(p, {-20, 80, 45}, {-32, 150, 20}, 12));
            return joined(d, ball(p, {0, -90, -95}, 22));
        }));
    add("hand", solid([](const Vec3& p) {
            double d = egg(p, {0, -60, 0}, {48, 55, 18});
            for (int finger = 0; finger < 4; ++finger) {
                const double x = -33.0 + 22.0 * finger;
                d = joined(
                    d, stick(p, {x, -20, 0}, {1.3 * x, 62.0 - std::abs(finger - 2) * 9.0, 6}, 9.5));
            }
            return joined(d, stick(p, {40, -70, 0}, {85, -15, 14}, 11));
        }));
    add("foot", solid([](const Vec3& p) {
            double d = egg(p, {0, -70, 20}, {42, 30, 115});
            d = joined(d, stick(p, {0, -50, -60}, {0, 140, -60}, 34), 30.0);
            for (int toe = 0; toe < 5; ++toe) {
                d = joined(d, ball(p, {-32.0 + 16.0 * toe, -78, 128.0 - 6.0 * toe}, 10), 8.0);
            }
            return d;
        }));
    add("torso", solid([](const Vec3& p) {
            double d = egg(p, {0, 0, 0}, {95, 150, 60});
            d = joined(d, egg(p, {40, 45, 45}, {38, 32, 25}), 30.0);
            d = joined(d, egg(p, {-40, 45, 45}, {38, 32, 25}), 30.0);
            return joined(d, stick(p, {0, 100, 0}, {0, 160, 0}, 35), 20.0);
        }));
    add("knee", solid([](const Vec3& p) {
            return joined(joined(stick(p, {0, -160, 0}, {0, 0, 25}, 48),
                                 stick(p, {0, 0, 25}, {0, 160, -30}, 60), 30.0),
                          ball(p, {0, 8, 62}, 26), 20.0);
        }));
    add("nose without a face", solid([](const Vec3& p) {
            const double plate = brick(p - Vec3(0, 0, -20), {110, 110, 20});
            const double nose = stick(p, {0, 30, 0}, {0, -20, 18}, 12);
            return joined(plate, nose, 14.0);
        }));
    add("blob of balls", solid([](const Vec3& p) {
            std::mt19937 random(5);
            std::uniform_real_distribution<double> uniform(-75.0, 75.0);
            double d = 1e9;
            for (int k = 0; k < 14; ++k) {
                const Vec3 at(uniform(random), uniform(random), uniform(random));
                d = joined(d, ball(p, at, 38.0), 25.0);
            }
            return d;
        }));
    add("hills", terrain(3, 30.0));
    add("crumpled sheet", terrain(9, 70.0));
    {
        TriangleMesh noise = sphere(90.0, 40, 60);
        std::mt19937 random(1);
        std::normal_distribution<double> normal(0.0, 12.0);
        for (Eigen::Index v = 0; v < noise.vertices.cols(); ++v) {
            noise.vertices.col(v) += Vec3(normal(random), normal(random), normal(random));
        }
        add("noisy ball", std::move(noise));
    }
    {
        TriangleMesh soup;
        std::mt19937 random(2);
        std::uniform_real_distribution<double> uniform(-100.0, 100.0);
        soup.vertices.resize(3, 6000);
        soup.triangles.resize(3, 2000);
        for (Eigen::Index t = 0; t < 2000; ++t) {
            const Vec3 at(uniform(random), uniform(random), uniform(random));
            for (Eigen::Index c = 0; c < 3; ++c) {
                soup.vertices.col(3 * t + c) =
                    at + 0.08 * Vec3(uniform(random), uniform(random), uniform(random));
                soup.triangles(c, t) = static_cast<int>(3 * t + c);
            }
        }
        add("triangles in space", std::move(soup));
    }
    add("ear", part_of_head([](const Vec3& p) {
            return p.x() > 62.0 && p.y() > -45.0 && p.y() < 55.0 && p.z() < 30.0;
        }));
    add("back of a head", part_of_head([](const Vec3& p) { return p.z() < 20.0; }));
    add("forehead and crown", part_of_head([](const Vec3& p) { return p.y() > 45.0; }));
    add("neck and jaw angle", part_of_head([](const Vec3& p) { return p.y() < -92.0; }));
    add("lips", part_of_head([](const Vec3& p) {
            return p.z() > 60.0 && std::abs(p.x()) < 34.0 && p.y() < -38.0 && p.y() > -68.0;
        }));
    return list;
}

}  // namespace myoface::test
