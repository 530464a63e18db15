// SPDX-License-Identifier: Apache-2.0
#include "myoface/scene/visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "myoface/base/parallel.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/coarse_mesh.h"
#include "myoface/mesh/normals.h"
#include "myoface/mesh/weld.h"

namespace myoface {
namespace {

constexpr int kRays = 48;
constexpr double kLowest = 0.14;       // sine of the least height of a ray over the surface
constexpr double kLift = 0.7;          // where a ray starts over the surface [mm]
constexpr double kShadeReach = 140.0;  // what is further away throws no shadow that is seen [mm]
constexpr int kFinest = 12000;         // vertices; finer meshes are taken on a coarser one
constexpr float kShadeSpacing = 2.4F;  // [mm] of that one
constexpr int kPasses = 2;             // of smoothing, against the noise of few rays
constexpr double kSmallPart = 8.0;     // [mm] across: a caruncle, no tooth
constexpr int kMostSmallParts = 32;
constexpr double kBesidePart = 2.0;  // [mm]

/// Directions over the plane z = 0, a spiral that fills the half sphere evenly.
Points directions() {
    Points all(3, kRays);
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (int k = 0; k < kRays; ++k) {
        const double z = kLowest + (1.0 - kLowest) * (k + 0.5) / kRays;
        const double flat = std::sqrt(1.0 - z * z);
        all.col(k) << flat * std::cos(golden * k), flat * std::sin(golden * k), z;
    }
    return all;
}

Mat3 frame_at(const Vec3& normal) {
    const Vec3 aside = std::abs(normal.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
    Mat3 frame;
    frame.col(0) = normal.cross(aside).normalized();
    frame.col(1) = normal.cross(frame.col(0));
    frame.col(2) = normal;
    return frame;
}

Eigen::Matrix4Xd everywhere(const TriangleMesh& mesh, const Progress* progress) {
    const Adjacency adjacency(mesh);
    const Points normals = vertex_normals(mesh, adjacency);
    const Bvh bvh(mesh);
    const Points rays = directions();
    Eigen::Matrix<double, kRays, 4> system;
    system << rays.transpose(), Eigen::VectorXd::Ones(kRays);
    const Eigen::Matrix<double, 4, kRays> solve =
        (system.transpose() * system).ldlt().solve(system.transpose());
    Eigen::Matrix4Xd result(4, mesh.vertex_count());
    constexpr int kPieces = 16;  // between two looks at whether to go on
    const int n = mesh.vertex_count();
    for (int piece = 0; piece < kPieces; ++piece) {
        if (progress != nullptr) {
            progress->report("shading", static_cast<double>(piece) / kPieces);
        }
        const int first = static_cast<int>(static_cast<long long>(n) * piece / kPieces);
        const int last = static_cast<int>(static_cast<long long>(n) * (piece + 1) / kPieces);
        parallel_for(last - first, 64, [&](int begin, int end) {
            for (int v = first + begin; v < first + end; ++v) {
                const Mat3 frame = frame_at(normals.col(v));
                Eigen::Matrix<double, kRays, 1> open;
                for (int k = 0; k < kRays; ++k) {
                    const auto hit = bvh.first_hit(
                        mesh, {mesh.vertices.col(v) + kLift * normals.col(v), frame * rays.col(k)});
                    open[k] = hit && hit->distance < kShadeReach ? 0.0 : 1.0;
                }
                const Eigen::Vector4d fit = solve * open;
                result.col(v) << frame * fit.head<3>(), fit[3];
            }
        });
    }
    Eigen::Matrix4Xd next = result;
    for (int pass = 0; pass < kPasses; ++pass) {
        for (int v = 0; v < n; ++v) {
            Eigen::Vector4d sum = result.col(v);
            for (const int other : adjacency.neighbours(v)) {
                sum += result.col(other);
            }
            next.col(v) = sum / (1.0 + static_cast<double>(adjacency.neighbours(v).size()));
        }
        std::swap(result, next);
    }
    return result;
}

/// A small part that hangs together with nothing lies half sunk in what is around it, where the few
/// rays find hardly a way out: it is lit as the openest place beside it is.
void light_small_parts(const TriangleMesh& mesh, Eigen::Matrix4Xf& of_vertices) {
    const Components parts = connected_components(mesh);
    std::vector<Eigen::AlignedBox3d> boxes(static_cast<std::size_t>(parts.count));
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        boxes[static_cast<std::size_t>(parts.of_vertex[static_cast<std::size_t>(v)])].extend(
            Vec3(mesh.vertices.col(v)));
    }
    const auto small = [](const Eigen::AlignedBox3d& box) {
        return box.diagonal().norm() < kSmallPart;
    };
    if (std::count_if(boxes.begin(), boxes.end(), small) > kMostSmallParts) {
        return;  // crumbs of a scanner
    }
    const Eigen::Matrix4Xf known = of_vertices;
    for (int part = 0; part < parts.count; ++part) {
        Eigen::AlignedBox3d near = boxes[static_cast<std::size_t>(part)];
        if (!small(near)) {
            continue;
        }
        near.min().array() -= kBesidePart;
        near.max().array() += kBesidePart;
        int openest = -1;
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            if (near.contains(Vec3(mesh.vertices.col(v))) &&
                (openest < 0 || known(3, v) > known(3, openest))) {
                openest = v;
            }
        }
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            if (parts.of_vertex[static_cast<std::size_t>(v)] == part) {
                of_vertices.col(v) = known.col(openest);
            }
        }
    }
}

}  // namespace

Eigen::Matrix4Xf light_visibility(const TriangleMesh& mesh, const Progress* progress) {
    Eigen::Matrix4Xf result(4, mesh.vertex_count());
    result.colwise() = Eigen::Vector4f(0.0F, 0.0F, 0.0F, 1.0F);
    const WeldedMesh welded = weld(mesh);
    const int n = welded.mesh.vertex_count();
    if (n == 0) {
        return result;
    }
    Eigen::Matrix4Xf found(4, n);
    if (n <= kFinest) {
        found = everywhere(welded.mesh, progress).cast<float>();
    } else {
        const CoarseMesh coarse = coarsen(welded.mesh, Eigen::VectorXf::Constant(n, kShadeSpacing));
        const Eigen::Matrix4Xf known = everywhere(coarse.mesh, progress).cast<float>();
        found.setZero();
        for (int v = 0; v < n; ++v) {
            const bool alone = coarse.between(1, v) < 0;
            for (int k = 0; k < 3 && coarse.between(k, v) >= 0; ++k) {
                found.col(v) +=
                    (alone ? 1.0F : coarse.shares(k, v)) * known.col(coarse.between(k, v));
            }
        }
    }
    light_small_parts(welded.mesh, found);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (welded.of_vertex[static_cast<std::size_t>(v)] >= 0) {
            result.col(v) = found.col(welded.of_vertex[static_cast<std::size_t>(v)]);
        }
    }
    return result;
}

}  // namespace myoface
