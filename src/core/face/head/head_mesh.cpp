// SPDX-License-Identifier: Apache-2.0
#include "head_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "myoface/base/parallel.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/isosurface.h"
#include "myoface/mesh/remesh.h"

#include "head_openings.h"
#include "head_parts.h"
#include "spline.h"

namespace myoface {
namespace {

/// Share of the general edge length wanted at a place: fine where a face has detail.
double relative_edge_length(const Vec3& p) {
    const double x = std::abs(p.x());
    const auto near = [&](double cx, double cy, double cz, double reach) {
        return bump((Vec3(x, p.y(), p.z()) - Vec3(cx, cy, cz)).norm() / reach);
    };
    double size = 2.0;
    const double face = std::clamp((p.z() - 20.0) / 50.0, 0.0, 1.0) *
                        std::clamp((p.y() + 125.0) / 40.0, 0.0, 1.0) *
                        std::clamp((80.0 - p.y()) / 40.0, 0.0, 1.0);
    size -= 0.9 * face;
    size -= 0.6 * near(30, 17, 82, 17);
    size -= 0.5 * near(10, -51, 98, 18);
    size -= 0.4 * near(24, -52, 90, 8);
    size -= 0.45 * near(8, -23, 102, 15);
    size -= 1.1 * near(78, 3, -18, 26);
    return std::max(size, 0.42);
}

/// Edge length that gives about the wanted number of vertices, from a mesh of any density.
double base_edge_length(const TriangleMesh& mesh, double vertices) {
    double density = 0.0;  // vertices times squared base length
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 centre = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
        const double size = relative_edge_length(centre);
        density += 0.5 * double_area_vector(mesh, t).norm() * 1.1547 / (size * size);
    }
    return std::sqrt(density / vertices);
}

struct Template {
    OpeningCurves curves;
    CutHead rough;

    Template() : curves(average_head()) {
        const Eigen::AlignedBox3d box(Vec3(0, HeadField::kNeckCut - 6.0, -112), Vec3(96, 140, 128));
        const TriangleMesh raw =
            isosurface([](const Vec3& p) { return average_head()(p); }, box, 2.5);
        rough = cut_openings(raw, average_head(), curves);
    }
};

/// The same for all resolutions; made once.
const Template& half_template() {
    static const Template kTemplate;
    return kTemplate;
}

Vec3 onto_head(const Vec3& p, int line) {
    if (line > kMidline) {
        return half_template().curves.nearest(p, line);
    }
    Vec3 at = average_head().onto_surface(p, line == kMidline);
    at.x() = line == kMidline ? 0.0 : std::max(at.x(), 0.0);
    return at;
}

/// Every triangle into four, new points on the surface.
CutHead subdivided(const CutHead& coarse) {
    const TriangleMesh& mesh = coarse.mesh;
    const Adjacency adjacency(mesh);
    const std::vector<MeshEdge>& edges = adjacency.edges();
    const int n = mesh.vertex_count();
    const auto edge_count = static_cast<int>(edges.size());
    CutHead fine;
    fine.mesh.vertices.resize(3, n + edge_count);
    fine.mesh.vertices.leftCols(n) = mesh.vertices;
    fine.lines = coarse.lines;
    fine.lines.resize(static_cast<std::size_t>(n + edge_count), kFreeVertex);
    parallel_for(edge_count, 512, [&](int begin, int end) {
        for (int e = begin; e < end; ++e) {
            const auto [a, b] = edges[e].vertices;
            int line = kFreeVertex;
            if (edges[e].triangle_count == 1) {
                line = std::max(coarse.lines[a], coarse.lines[b]);
            }
            fine.lines[n + e] = line;
            fine.mesh.vertices.col(n + e) =
                onto_head(0.5 * (mesh.vertices.col(a) + mesh.vertices.col(b)), line);
        }
    });
    // Edge opposite to each corner.
    Triangles across(3, mesh.triangle_count());
    for (int e = 0; e < edge_count; ++e) {
        for (int k = 0; k < edges[e].triangle_count; ++k) {
            const int t = edges[e].triangles[k];
            for (int c = 0; c < 3; ++c) {
                if (mesh.triangles(c, t) == edges[e].opposite[k]) {
                    across(c, t) = n + e;
                }
            }
        }
    }
    fine.mesh.triangles.resize(3, 4 * mesh.triangle_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::Vector3i v = mesh.triangles.col(t);
        const Eigen::Vector3i m = across.col(t);
        fine.mesh.triangles.col(4 * t) << v[0], m[2], m[1];
        fine.mesh.triangles.col(4 * t + 1) << v[1], m[0], m[2];
        fine.mesh.triangles.col(4 * t + 2) << v[2], m[1], m[0];
        fine.mesh.triangles.col(4 * t + 3) << m[0], m[1], m[2];
    }
    return fine;
}

/// The outer surface of the left half, open at eye and mouth.
CutHead half_surface(double vertices, const Progress* progress) {
    const auto report = [&](double share) {
        if (progress != nullptr) {
            progress->report("Building the face", share);
        }
    };
    report(0.0);
    const CutHead& rough = half_template().rough;
    report(0.3);
    int levels = 0;
    while (vertices > 40000.0) {
        vertices /= 4.0;
        ++levels;
    }
    const double edge = base_edge_length(rough.mesh, vertices);
    RemeshOptions options;
    options.edge_length = [edge](const Vec3& p) { return edge * relative_edge_length(p); };
    options.project = onto_head;
    options.lines = rough.lines;
    RemeshedSurface surface = remesh(rough.mesh, options);
    CutHead half{std::move(surface.mesh), std::move(surface.lines)};
    report(0.8);
    for (int level = 0; level < levels; ++level) {
        half = subdivided(half);
        report(0.8 + 0.1 * (level + 1) / levels);
    }
    return half;
}

}  // namespace

const HeadField& average_head() {
    static const HeadField kHead;
    return kHead;
}

HeadMesh average_head_mesh(int vertices, const Progress* progress) {
    const int around = std::clamp(static_cast<int>(std::sqrt(vertices) / 4.5), 14, 64);
    const int tooth = vertices < 8000 ? 6 : 12;
    const double beside = 2.0 * 18.0 * around + (vertices < 8000 ? 900.0 : 3200.0);
    const double rings = 14.0 * 0.9 * std::sqrt(vertices);  // lid margins and mouth bag
    const CutHead half =
        half_surface(0.47 * std::max(vertices - beside - rings, 0.36 * vertices), progress);
    MeshBuilder builder(half.mesh);
    std::vector<HeadPart> part(builder.vertices.size(), HeadPart::Skin);
    const auto mark = [&](HeadPart kind) { part.resize(builder.vertices.size(), kind); };
    const Vec3 eye = average_head().eye_centre();
    add_lid_margins(builder, half, eye);
    mark(HeadPart::LidMargin);
    add_mouth_bag(builder, half);
    mark(HeadPart::Mouth);
    add_eyeball(builder, eye, around);
    mark(HeadPart::Eye);
    const OpeningCurves& curves = half_template().curves;
    add_caruncle(builder, curves.inner_canthus(), eye, around);
    mark(HeadPart::Caruncle);
    for (const bool upper : {true, false}) {
        add_teeth(builder, curves.mid_lips(), upper, tooth);
        mark(HeadPart::Tooth);
        add_gum(builder, curves.mid_lips(), upper, tooth);
        mark(HeadPart::Gum);
    }
    // The right half mirrors the left; points on x = 0 are shared.
    const std::size_t left = builder.vertices.size();
    const std::size_t left_triangles = builder.triangles.size();
    std::vector<int> other(left);
    for (std::size_t v = 0; v < left; ++v) {
        const Vec3 p = builder.vertices[v];
        if (p.x() == 0.0) {
            other[v] = static_cast<int>(v);
        } else {
            other[v] = builder.add({-p.x(), p.y(), p.z()});
            part.push_back(part[v]);
        }
    }
    for (std::size_t t = 0; t < left_triangles; ++t) {
        const Eigen::Vector3i v = builder.triangles[t];
        builder.triangles.emplace_back(other[v[0]], other[v[2]], other[v[1]]);
    }
    return {builder.mesh(), std::move(part)};
}

}  // namespace myoface
