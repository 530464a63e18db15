// SPDX-License-Identifier: Apache-2.0
#include "spoiled_scan.h"

#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "myoface/face/face_model.h"
#include "myoface/face/generic_face.h"
#include "myoface/muscle/expression.h"
#include "myoface/sim/simulator.h"

#include "test_meshes.h"

namespace myoface::test {
namespace {

constexpr std::array<const char*, 4> kExpressions{"", "full_smile", "surprise", "sadness"};

/// The generic head at one resolution with the ways of its vertices under each expression. All
/// heads of that resolution share their vertices.
struct Poses {
    Points neutral;
    std::vector<Points> ways;
};

const Poses& poses(int vertices) {
    static std::map<int, Poses> known;
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    Poses& result = known[vertices];
    if (result.neutral.cols() == 0) {
        GenericFaceOptions options;
        options.vertices = vertices;
        GenericFace face = make_generic_face(options);
        result.neutral = face.scan.mesh.vertices;
        const auto scan = std::make_shared<Scan>(std::move(face.scan));
        const auto model = fit_face(scan, face.landmarks);
        for (const char* name : kExpressions) {
            Points way = Points::Zero(3, result.neutral.cols());
            if (*name != '\0') {
                Simulator simulator(model);
                std::vector<double> rates(model->muscles.size(), 0.0);
                add_expression(rates, expression_named(name), 1.0);
                for (std::size_t m = 0; m < rates.size(); ++m) {
                    simulator.set_contraction(static_cast<int>(m), rates[m]);
                }
                simulator.step(400);
                way = simulator.scan_vertices() - result.neutral;
            }
            result.ways.push_back(std::move(way));
        }
    }
    return result;
}

void keep_triangles(TriangleMesh& mesh, const std::vector<char>& keep) {
    Eigen::Index n = 0;
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
        if (keep[static_cast<std::size_t>(t)] != 0) {
            mesh.triangles.col(n++) = mesh.triangles.col(t);
        }
    }
    mesh.triangles.conservativeResize(3, n);
}

}  // namespace

SpoiledScan spoiled_scan(std::uint32_t seed) {
    std::mt19937 random(seed * 7919U + 13U);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    const auto chance = [&](double share) { return uniform(random) < share; };
    SpoiledScan scan;

    GenericFaceOptions options;
    options.vertices = std::array{4000, 7000, 15000}[random() % 3];
    options.seed = seed;
    options.sex = chance(0.5) ? Sex::Female : Sex::Male;
    options.age = 18.0 + 55.0 * uniform(random);
    options.asymmetry = 1.5 * uniform(random);
    GenericFace face = make_generic_face(options);
    scan.mesh = face.scan.mesh;
    scan.truth = face.landmarks;
    scan.story = std::to_string(options.vertices) + " vertices";

    // A mild expression takes the landmarks along with the vertex beside them.
    const Poses& known = poses(options.vertices);
    const std::size_t pose = random() % kExpressions.size();
    const double intensity = 0.2 + 0.4 * uniform(random);
    for (auto& [name, landmark] : scan.truth) {
        Eigen::Index nearest = 0;
        (scan.mesh.vertices.colwise() - landmark.position)
            .colwise()
            .squaredNorm()
            .minCoeff(&nearest);
        landmark.position += intensity * known.ways[pose].col(nearest);
    }
    scan.mesh.vertices += intensity * known.ways[pose];
    scan.story += std::string(", ") + kExpressions[pose];

    // Tufts: waves along the scalp and the forehead.
    if (chance(0.6)) {
        const double height = 2.0 + 8.0 * uniform(random);
        const Vec3 wave(0.2 + 0.2 * uniform(random), 0.25, 0.2 + 0.2 * uniform(random));
        const double hairline = 78.0 + 20.0 * uniform(random);
        for (Eigen::Index v = 0; v < scan.mesh.vertices.cols(); ++v) {
            const Vec3 p = scan.mesh.vertices.col(v);
            const double line = std::max(p.y() - hairline, -20.0 - p.z() - 0.5 * p.y());
            const double share = std::clamp(line / 15.0, 0.0, 1.0);
            const double bump =
                1.0 + std::sin(wave.x() * p.x() + wave.y() * p.y()) * std::cos(wave.z() * p.z());
            scan.mesh.vertices.col(v) += share * height * bump * p.normalized();
        }
        scan.story += ", hair";
    }
    for (Eigen::Index v = 0; v < scan.mesh.vertices.cols(); ++v) {
        scan.mesh.vertices.col(v) +=
            0.3 * Vec3(normal(random), normal(random), normal(random)) / std::sqrt(3.0);
    }

    // What the scanner did not see: behind, above, below, holes.
    std::vector<char> keep(static_cast<std::size_t>(scan.mesh.triangle_count()), 1);
    const double behind = chance(0.5) ? -40.0 + 70.0 * uniform(random) : -1e9;
    const double above = chance(0.3) ? 85.0 + 30.0 * uniform(random) : 1e9;
    const double below = chance(0.4) ? -105.0 - 25.0 * uniform(random) : -1e9;
    std::vector<std::pair<Vec3, double>> holes;
    for (int k = chance(0.6) ? static_cast<int>(random() % 8) : 0; k > 0; --k) {
        const Vec3 at = scan.mesh.vertices.col(
            static_cast<Eigen::Index>(random() % static_cast<unsigned>(scan.mesh.vertex_count())));
        const double radius = 3.0 + 6.0 * uniform(random);
        const bool on_landmark =
            std::any_of(scan.truth.begin(), scan.truth.end(), [&](const auto& landmark) {
                return (landmark.second.position - at).norm() < radius + 4.0;
            });
        if (!on_landmark) {
            holes.emplace_back(at, radius);
        }
    }
    for (int t = 0; t < scan.mesh.triangle_count(); ++t) {
        const Vec3 c =
            (scan.mesh.corner(t, 0) + scan.mesh.corner(t, 1) + scan.mesh.corner(t, 2)) / 3.0;
        bool gone = c.z() < behind || c.y() > above || c.y() < below;
        for (const auto& [at, radius] : holes) {
            gone = gone || (c - at).norm() < radius;
        }
        keep[static_cast<std::size_t>(t)] = gone ? 0 : 1;
    }
    keep_triangles(scan.mesh, keep);
    for (int k = chance(0.5) ? static_cast<int>(random() % 6) : 0; k > 0; --k) {
        TriangleMesh scrap = sphere(1.0 + 6.0 * uniform(random), 5, 7);
        const Vec3 way = Vec3(normal(random), normal(random), normal(random)).normalized();
        scrap.vertices.colwise() += (130.0 + 60.0 * uniform(random)) * way;
        scan.mesh = together(scan.mesh, scrap);
    }

    scan.unit = std::array{1.0, 10.0, 100.0, 1000.0}[random() % 4];
    scan.turn = Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                    .normalized()
                    .toRotationMatrix();
    const Vec3 offset = 100.0 * Vec3(normal(random), normal(random), normal(random));
    const auto place = [&](const Vec3& p) { return Vec3((scan.turn * p + offset) / scan.unit); };
    for (Eigen::Index v = 0; v < scan.mesh.vertices.cols(); ++v) {
        scan.mesh.vertices.col(v) = place(scan.mesh.vertices.col(v));
    }
    for (auto& [name, landmark] : scan.truth) {
        landmark.position = place(landmark.position);
    }
    return scan;
}

}  // namespace myoface::test
