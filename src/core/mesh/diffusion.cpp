// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/diffusion.h"

#include <algorithm>
#include <vector>

#include <Eigen/SparseCholesky>

#include "myoface/mesh/normals.h"

namespace myoface {

struct Diffusion::Solver {
    Eigen::VectorXd mass;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
};

Diffusion::Diffusion(const TriangleMesh& mesh, const Adjacency& adjacency, double time)
    : solver_(std::make_unique<Solver>()) {
    solver_->mass = vertex_areas(mesh).cwiseMax(1e-6);
    const auto cotangent = [&](int apex, int a, int b) {
        const Vec3 p = mesh.vertices.col(a) - mesh.vertices.col(apex);
        const Vec3 q = mesh.vertices.col(b) - mesh.vertices.col(apex);
        const double sine = p.cross(q).norm();
        return sine > 1e-12 ? p.dot(q) / sine : 0.0;
    };
    std::vector<Eigen::Triplet<double>> entries;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        entries.emplace_back(v, v, solver_->mass[v]);
    }
    for (const MeshEdge& edge : adjacency.edges()) {
        const auto [a, b] = edge.vertices;
        double weight = 0.0;
        for (int side = 0; side < std::min(edge.triangle_count, 2); ++side) {
            weight += 0.5 * cotangent(edge.opposite[side], a, b);
        }
        // Obtuse pairs would make it negative and the result overshoot.
        weight = time * std::clamp(weight, 0.02, 10.0);
        entries.emplace_back(a, a, weight);
        entries.emplace_back(b, b, weight);
        entries.emplace_back(a, b, -weight);
        entries.emplace_back(b, a, -weight);
    }
    Eigen::SparseMatrix<double> matrix(mesh.vertex_count(), mesh.vertex_count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_->factor.compute(matrix);
}

Diffusion::~Diffusion() = default;
Diffusion::Diffusion(Diffusion&&) noexcept = default;
Diffusion& Diffusion::operator=(Diffusion&&) noexcept = default;

Points Diffusion::apply(const Points& values, int times) const {
    Eigen::MatrixX3d now = values.transpose();
    for (int k = 0; k < times; ++k) {
        now = solver_->factor.solve((solver_->mass.asDiagonal() * now).eval()).eval();
    }
    return now.transpose();
}

}  // namespace myoface
