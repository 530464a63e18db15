// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "myoface/io/scan.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/orientation.h"
#include "myoface/mesh/weld.h"

namespace myoface {

void examine(Scan& scan) {
    ScanFindings& findings = scan.findings;
    const WeldedMesh welded = weld(scan.mesh);
    const TriangleMesh& mesh = welded.mesh;
    findings.degenerate_triangles = welded.degenerate;
    findings.duplicate_triangles = welded.duplicates;
    findings.unreferenced_vertices =
        static_cast<int>(std::count(welded.of_vertex.begin(), welded.of_vertex.end(), -1));
    findings.duplicate_vertices =
        scan.mesh.vertex_count() - findings.unreferenced_vertices - mesh.vertex_count();
    const double unit = scan.frame.mm_per_unit;
    const SurfaceCheck surface = check_surface(mesh);
    findings.non_manifold_edges = surface.non_manifold_edges;
    findings.holes = surface.border_loops;
    findings.longest_hole = surface.longest_border / unit;
    findings.inward = surface.inward;
    findings.turned_triangles = surface.disagreeing;
    if (!surface.turn.empty() && scan.triangle_corner.empty()) {
        for (int t = 0; t < scan.mesh.triangle_count(); ++t) {
            scan.triangle_corner.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        }
    }
    for (std::size_t t = 0; t < surface.turn.size(); ++t) {
        if (surface.turn[t]) {
            const int in_scan = welded.of_triangle[t];
            std::swap(scan.mesh.triangles(1, in_scan), scan.mesh.triangles(2, in_scan));
            std::swap(scan.triangle_corner[static_cast<std::size_t>(in_scan)][1],
                      scan.triangle_corner[static_cast<std::size_t>(in_scan)][2]);
        }
    }

    const Components components = connected_components(mesh);
    std::vector<ScanPart> parts(static_cast<std::size_t>(components.count));
    for (ScanPart& part : parts) {
        part.low.setConstant(std::numeric_limits<double>::infinity());
        part.high = -part.low;
    }
    const Mat3 back = scan.frame.axes.transpose() / unit;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        ScanPart& part =
            parts[static_cast<std::size_t>(components.of_vertex[mesh.triangles(0, t)])];
        ++part.triangles;
        part.area += 0.5 * double_area_vector(mesh, t).norm() / (unit * unit);
        for (int c = 0; c < 3; ++c) {
            const Vec3 at = back * mesh.corner(t, c);
            part.low = part.low.cwiseMin(at);
            part.high = part.high.cwiseMax(at);
        }
    }
    std::vector<int> order(parts.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int p, int q) { return parts[p].area > parts[q].area; });
    std::vector<int> rank(parts.size());
    findings.parts.clear();
    for (std::size_t k = 0; k < order.size(); ++k) {
        rank[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
        findings.parts.push_back(parts[static_cast<std::size_t>(order[k])]);
    }
    scan.triangle_part.assign(static_cast<std::size_t>(scan.mesh.triangle_count()), -1);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        scan.triangle_part[static_cast<std::size_t>(welded.of_triangle[t])] =
            rank[static_cast<std::size_t>(components.of_vertex[mesh.triangles(0, t)])];
    }
}

}  // namespace myoface
