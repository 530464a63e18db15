// SPDX-License-Identifier: Apache-2.0
#include "sliding_surface.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "myoface/base/parallel.h"
#include "myoface/mesh/diffusion.h"
#include "myoface/mesh/normals.h"

namespace myoface {
namespace {

/// Heat-flow time of one smoothing step [mm²]; two steps on positions and then on normals do what
/// 25 and 30 half umbrella passes did on the 2.7 mm mesh where the model was tried.
constexpr double kSmoothing = 11.4;
constexpr double kSlideReach = 7.0;  // of the least squares [mm]

}  // namespace

SmoothFace smooth_face(const TriangleMesh& mesh, const Adjacency& adjacency) {
    const Diffusion diffusion(mesh, adjacency, kSmoothing);
    SmoothFace face;
    face.vertices = diffusion.apply(mesh.vertices, 1);
    TriangleMesh smooth;
    smooth.triangles = mesh.triangles;
    smooth.vertices = diffusion.apply(face.vertices, 1);
    face.normals = diffusion.apply(vertex_normals(smooth, adjacency), 2);
    for (Eigen::Index v = 0; v < face.normals.cols(); ++v) {
        const double length = face.normals.col(v).norm();
        face.normals.col(v) =
            length > 1e-6 ? Vec3(face.normals.col(v) / length) : Vec3(Vec3::UnitZ());
    }
    return face;
}

std::vector<SlidingSurface> sliding_surfaces(const TriangleMesh& mesh, const Adjacency& adjacency,
                                             const Points& smooth_normals) {
    std::vector<SlidingSurface> surfaces(static_cast<std::size_t>(mesh.vertex_count()));
    parallel_for(mesh.vertex_count(), 256, [&](int begin, int end) {
        std::vector<int> ring;
        for (int v = begin; v < end; ++v) {
            SlidingSurface& surface = surfaces[v];
            const Vec3 n = smooth_normals.col(v);
            surface.normal = n;
            // Breadth first up to kSlideReach, at least two rings, at most 80 nodes.
            ring.assign(1, v);
            std::size_t two_rings = 0;
            for (std::size_t i = 0; i < ring.size() && ring.size() < 80; ++i) {
                if (i == 1) {
                    two_rings = ring.size();
                }
                const double away = (mesh.vertices.col(ring[i]) - mesh.vertices.col(v)).norm();
                if (i >= std::max<std::size_t>(two_rings, 1) && away > kSlideReach) {
                    continue;
                }
                for (const int w : adjacency.neighbours(ring[i])) {
                    if (std::find(ring.begin(), ring.end(), w) == ring.end()) {
                        ring.push_back(w);
                    }
                }
            }
            const Vec3 a = n.unitOrthogonal();
            const Vec3 b = n.cross(a);
            // dn·a = q11 da + q12 db,  dn·b = q12 da + q22 db
            Mat3 normal_matrix = Mat3::Zero();
            Vec3 right = Vec3::Zero();
            for (const int w : ring) {
                const Vec3 dx = mesh.vertices.col(w) - mesh.vertices.col(v);
                const Vec3 dn = smooth_normals.col(w) - n;
                const double da = dx.dot(a);
                const double db = dx.dot(b);
                const double weight = std::exp(-dx.squaredNorm() / (kSlideReach * kSlideReach));
                const Vec3 first(da, db, 0.0);
                const Vec3 second(0.0, da, db);
                normal_matrix += weight * (first * first.transpose() + second * second.transpose());
                right += weight * (first * dn.dot(a) + second * dn.dot(b));
            }
            if (std::abs(normal_matrix.determinant()) < 1e-9) {
                continue;
            }
            const Vec3 q = normal_matrix.ldlt().solve(right);
            Eigen::Matrix2d tangential;
            tangential << q[0], q[1], q[1], q[2];
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(tangential);
            const Eigen::Vector2d limited =
                eigen.eigenvalues().cwiseMax(-1.0 / 25.0).cwiseMin(1.0 / 12.0);
            const Eigen::Matrix2d back =
                eigen.eigenvectors() * limited.asDiagonal() * eigen.eigenvectors().transpose();
            Eigen::Matrix<double, 3, 2> frame;
            frame << a, b;
            if (back.allFinite()) {
                surface.curvature = frame * back * frame.transpose();
            }
        }
    });
    return surfaces;
}

}  // namespace myoface
