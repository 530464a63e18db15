// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/normals.h"

#include "myoface/base/parallel.h"

namespace myoface {
namespace {
constexpr int kNormalGrain = 2048;
}

Points vertex_normals(const TriangleMesh& mesh, const Adjacency& adjacency) {
    Points of_triangle(3, mesh.triangle_count());
    parallel_for(mesh.triangle_count(), kNormalGrain, [&](int begin, int end) {
        for (int t = begin; t < end; ++t) {
            of_triangle.col(t) = double_area_vector(mesh, t);
        }
    });
    Points normals(3, mesh.vertex_count());
    parallel_for(mesh.vertex_count(), kNormalGrain, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            Vec3 sum = Vec3::Zero();
            for (const int t : adjacency.triangles(v)) {
                sum += of_triangle.col(t);
            }
            const double length = sum.norm();
            normals.col(v) = length > 0.0 ? Vec3(sum / length) : Vec3(Vec3::UnitZ());
        }
    });
    return normals;
}

Eigen::VectorXd vertex_areas(const TriangleMesh& mesh) {
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.vertex_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const double third = double_area_vector(mesh, t).norm() / 6.0;
        for (int c = 0; c < 3; ++c) {
            areas[mesh.triangles(c, t)] += third;
        }
    }
    return areas;
}

double signed_volume(const TriangleMesh& mesh) {
    double six_volumes = 0.0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        six_volumes += mesh.corner(t, 0).dot(mesh.corner(t, 1).cross(mesh.corner(t, 2)));
    }
    return six_volumes / 6.0;
}

Points smoothed(const Points& values, const Adjacency& adjacency, int passes) {
    Points now = values;
    Points next = values;
    for (int pass = 0; pass < passes; ++pass) {
        parallel_for(adjacency.vertex_count(), kNormalGrain, [&](int begin, int end) {
            for (int v = begin; v < end; ++v) {
                const auto neighbours = adjacency.neighbours(v);
                if (neighbours.empty()) {
                    continue;
                }
                Vec3 mean = Vec3::Zero();
                for (const int w : neighbours) {
                    mean += now.col(w);
                }
                mean /= static_cast<double>(neighbours.size());
                next.col(v) = 0.5 * (now.col(v) + mean);
            }
        });
        now.swap(next);
    }
    return now;
}

}  // namespace myoface
