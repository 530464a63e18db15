// SPDX-License-Identifier: Apache-2.0
#include "myoface/scene/scene_builder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <map>
#include <numeric>
#include <span>

#include "myoface/base/parallel.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/coarse_mesh.h"
#include "myoface/mesh/normals.h"
#include "myoface/mesh/weld.h"

namespace myoface {
namespace {

Eigen::VectorXf fold_depth_everywhere(const TriangleMesh& mesh) {
    const Adjacency adjacency(mesh);
    // How far the surroundings stand out over a point: smoothed position minus position, along the
    // normal, at two scales.
    const Points normal = vertex_normals(mesh, adjacency);
    Eigen::VectorXf folds = Eigen::VectorXf::Zero(mesh.vertex_count());
    double scale = 0.0;
    int edges = 0;
    for (const MeshEdge& edge : adjacency.edges()) {
        scale += (mesh.vertices.col(edge.vertices[0]) - mesh.vertices.col(edge.vertices[1])).norm();
        ++edges;
    }
    const double edge_length = edges > 0 ? scale / edges : 1.0;
    // Umbrella passes reach about edge · √passes: aim at 3.5 mm and 9 mm.
    for (const auto& [reach, full] : {std::pair(3.5, 1.1), std::pair(9.0, 4.2)}) {
        const double ratio = reach / std::max(edge_length, 1e-6);
        const int passes = std::clamp(static_cast<int>(ratio * ratio * 1.5), 1, 400);
        const Points around = smoothed(mesh.vertices, adjacency, passes);
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            const double height = (around.col(v) - mesh.vertices.col(v)).dot(normal.col(v));
            const auto depth = static_cast<float>(std::clamp(height / full, 0.0, 1.0));
            folds[v] = 1.0F - (1.0F - folds[v]) * (1.0F - 0.75F * depth);
        }
    }
    return folds;
}

}  // namespace

SkinDrawing::SkinDrawing(const Scan& scan) {
    const bool uv = !scan.faces.uv.empty();
    const int n = scan.mesh.vertex_count();
    // The first UV of a vertex takes its own number, further ones are appended.
    source_.resize(static_cast<std::size_t>(n));
    source_uv_.assign(static_cast<std::size_t>(n), -1);
    for (int v = 0; v < n; ++v) {
        source_[v] = v;
    }
    source_material_.assign(static_cast<std::size_t>(n), -1);
    const bool materials = uv && scan.materials.size() > 1 && !scan.face_material.empty();
    std::map<std::array<int, 3>, int> more;  // vertex, UV, material -> drawn vertex
    indices_.reserve(3 * static_cast<std::size_t>(scan.mesh.triangle_count()));
    for (int triangle = 0; triangle < scan.mesh.triangle_count(); ++triangle) {
        const int m =
            materials ? scan.face_material[static_cast<std::size_t>(face_of(scan, triangle))] : -1;
        for (const int c : corners_of(scan, triangle)) {
            const int v = scan.faces.vertex[c];
            const int t = uv ? scan.faces.uv[c] : -1;
            int drawn = v;
            if (t >= 0 && source_uv_[v] < 0) {
                source_uv_[v] = t;
                source_material_[v] = m;
            } else if (t >= 0 && (source_uv_[v] != t || source_material_[v] != m)) {
                const auto [found, fresh] =
                    more.try_emplace({v, t, m}, static_cast<int>(source_.size()));
                if (fresh) {
                    source_.push_back(v);
                    source_uv_.push_back(t);
                    source_material_.push_back(m);
                }
                drawn = found->second;
            }
            indices_.push_back(static_cast<std::uint32_t>(drawn));
        }
    }
    WeldedMesh welded = weld(scan.mesh);
    welded_ = std::move(welded.of_vertex);
    triangles_ = VertexTriangles(welded.mesh);
    welded_triangles_ = std::move(welded.mesh.triangles);
    first_.assign(static_cast<std::size_t>(welded.mesh.vertex_count()), 0);
    for (int v = n - 1; v >= 0; --v) {
        if (welded_[v] >= 0) {
            first_[welded_[v]] = v;
        }
    }
    drawn_start_.assign(first_.size() + 1, 0);
    for (const int v : source_) {
        if (welded_[v] >= 0) {
            ++drawn_start_[welded_[v] + 1];
        }
    }
    std::partial_sum(drawn_start_.begin(), drawn_start_.end(), drawn_start_.begin());
    drawn_of_.resize(static_cast<std::size_t>(drawn_start_.back()));
    std::vector<int> next(drawn_start_.begin(), drawn_start_.end() - 1);
    for (int i = 0; i < drawn_count(); ++i) {
        if (welded_[source_[i]] >= 0) {
            drawn_of_[next[welded_[source_[i]]]++] = i;
        }
    }
}

void SkinDrawing::fill(SurfaceLayer& layer, const Scan& scan, const SkinTexture* texture) const {
    const auto n = static_cast<Eigen::Index>(source_.size());
    layer.indices = indices_;
    layer.colours.resize(3, scan.colours.cols() > 0 ? n : 0);
    for (Eigen::Index i = 0; i < layer.colours.cols(); ++i) {
        layer.colours.col(i) = scan.colours.col(source_[static_cast<std::size_t>(i)]);
    }
    const bool uv = scan.uv.cols() > 0;
    layer.uv.resize(2, uv ? n : 0);
    for (Eigen::Index i = 0; i < layer.uv.cols(); ++i) {
        const int t = source_uv_[static_cast<std::size_t>(i)];
        layer.uv.col(i) =
            t >= 0 ? place_in_texture(texture, source_material_[static_cast<std::size_t>(i)],
                                      scan.uv.col(t))
                   : Eigen::Vector2f(0.0F, 0.0F);
    }
    layer.positions.setConstant(3, n, std::numeric_limits<float>::max());  // all are to be moved
    layer.normals.setZero(3, n);
    layer.normals.row(2).setOnes();
    layer.cavity = Eigen::VectorXf::Zero(n);
    const Eigen::VectorXf folds =
        fold_depth({scan.mesh.vertices(Eigen::all, first_), welded_triangles_});
    for (Eigen::Index i = 0; i < n; ++i) {
        const int w = welded_[source_[static_cast<std::size_t>(i)]];
        layer.cavity[i] = w >= 0 ? folds[w] : 0.0F;
    }
    move(layer, scan.mesh.vertices);
}

void SkinDrawing::move(SurfaceLayer& layer, const Points& vertices, const std::vector<char>& moved,
                       const FloatPoints& normals) const {
    constexpr double kUnseen = 1e-4;  // [mm]
    const bool known = !moved.empty();
    if (known && normals.cols() > 0) {
        parallel_for(drawn_count(), 4096, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                const int v = source_[i];
                if (moved[v] != 0) {
                    layer.positions.col(i) = vertices.col(v).cast<float>();
                    layer.normals.col(i) = normals.col(v);
                }
            }
        });
        return;
    }
    // Which normals are stale. Several threads may set one flag.
    std::vector<char> stale(first_.size(), 0);
    parallel_for(drawn_count(), 4096, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const int v = source_[i];
            if (known && moved[v] == 0) {
                continue;
            }
            const Vec3 to = vertices.col(v);
            if (!known &&
                (layer.positions.col(i).cast<double>() - to).cwiseAbs().maxCoeff() < kUnseen) {
                continue;
            }
            layer.positions.col(i) = to.cast<float>();
            const int w = welded_[v];
            for (const int t : w >= 0 ? triangles_.at(w) : std::span<const int>()) {
                for (int c = 0; c < 3; ++c) {
                    std::atomic_ref(stale[welded_triangles_(c, t)])
                        .store(1, std::memory_order_relaxed);
                }
            }
        }
    });
    parallel_for(static_cast<int>(first_.size()), 4096, [&](int begin, int end) {
        for (int w = begin; w < end; ++w) {
            if (stale[w] != 0) {
                turn_normal(layer, vertices, w);
            }
        }
    });
}

void SkinDrawing::turn_normal(SurfaceLayer& layer, const Points& vertices, int welded) const {
    const auto corner = [&](int c, int t) { return vertices.col(first_[welded_triangles_(c, t)]); };
    Vec3 sum = Vec3::Zero();
    for (const int t : triangles_.at(welded)) {
        sum += (corner(1, t) - corner(0, t)).cross(corner(2, t) - corner(0, t));
    }
    const double length = sum.norm();
    const Eigen::Vector3f normal =
        length > 0.0 ? Eigen::Vector3f((sum / length).cast<float>()) : Eigen::Vector3f(0, 0, 1);
    for (int d = drawn_start_[welded]; d < drawn_start_[welded + 1]; ++d) {
        layer.normals.col(drawn_of_[d]) = normal;
    }
}

Eigen::VectorXf fold_depth(const TriangleMesh& mesh) {
    constexpr int kFinest = 60000;
    constexpr float kSpacing = 1.2F;  // [mm] finer folds throw no soft shadow
    if (mesh.vertex_count() <= kFinest) {
        return fold_depth_everywhere(mesh);
    }
    const CoarseMesh coarse =
        coarsen(mesh, Eigen::VectorXf::Constant(mesh.vertex_count(), kSpacing));
    const Eigen::VectorXf known = fold_depth_everywhere(coarse.mesh);
    Eigen::VectorXf folds = Eigen::VectorXf::Zero(mesh.vertex_count());
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        for (int k = 0; k < 3 && coarse.between(k, v) >= 0; ++k) {
            folds[v] += coarse.shares(k, v) * known[coarse.between(k, v)];
        }
    }
    return folds;
}

}  // namespace myoface
