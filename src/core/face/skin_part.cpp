// SPDX-License-Identifier: Apache-2.0
#include "skin_part.h"

#include <algorithm>
#include <vector>

#include "myoface/mesh/adjacency.h"

namespace myoface {

WeldedMesh main_part(const Scan& scan, const Vec3& nose) {
    WeldedMesh welded = weld(scan.mesh);
    const Components parts = connected_components(welded.mesh);
    if (parts.count <= 1 || welded.mesh.triangle_count() == 0) {
        return welded;
    }
    std::vector<double> area(static_cast<std::size_t>(parts.count), 0.0);
    for (int t = 0; t < welded.mesh.triangle_count(); ++t) {
        area[parts.of_vertex[welded.mesh.triangles(0, t)]] +=
            double_area_vector(welded.mesh, t).norm();
    }
    Eigen::Index nearest = 0;
    (welded.mesh.vertices.colwise() - nose).colwise().squaredNorm().minCoeff(&nearest);
    int keep = parts.of_vertex[static_cast<std::size_t>(nearest)];
    const auto largest = std::max_element(area.begin(), area.end());
    if (area[keep] < 0.2 * *largest) {
        keep = static_cast<int>(largest - area.begin());  // a scrap in front of the nose
    }
    std::vector<int> number(static_cast<std::size_t>(welded.mesh.vertex_count()), -1);
    WeldedMesh part;
    int count = 0;
    for (int v = 0; v < welded.mesh.vertex_count(); ++v) {
        if (parts.of_vertex[v] == keep) {
            number[v] = count++;
        }
    }
    part.mesh.vertices.resize(3, count);
    for (int v = 0; v < welded.mesh.vertex_count(); ++v) {
        if (number[v] >= 0) {
            part.mesh.vertices.col(number[v]) = welded.mesh.vertices.col(v);
        }
    }
    std::vector<Eigen::Vector3i> triangles;
    for (int t = 0; t < welded.mesh.triangle_count(); ++t) {
        const Eigen::Vector3i v = welded.mesh.triangles.col(t);
        if (number[v[0]] >= 0) {
            triangles.emplace_back(number[v[0]], number[v[1]], number[v[2]]);
            part.of_triangle.push_back(welded.of_triangle[t]);
        }
    }
    part.mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        part.mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
    }
    for (const int v : welded.of_vertex) {
        part.of_vertex.push_back(v < 0 ? -1 : number[v]);
    }
    return part;
}

}  // namespace myoface
