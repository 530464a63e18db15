// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "myoface/io/scan.h"
#include "myoface/io/skin_texture.h"
#include "myoface/mesh/vertex_triangles.h"
#include "myoface/scene/scene.h"

namespace myoface {

/// How a scan's vertices reach the screen: a vertex on a texture seam is drawn more than once, and
/// vertices at the same place share one normal.
class SkinDrawing {
public:
    SkinDrawing() = default;
    explicit SkinDrawing(const Scan& scan);

    /// Three per triangle of the scan, in its order.
    const std::vector<std::uint32_t>& indices() const { return indices_; }

    /// Fills indices, colours, UV, positions, normals and folds of a layer.
    void fill(SurfaceLayer& layer, const Scan& scan, const SkinTexture* texture) const;
    /// Moves a layer to new vertex positions (3×N of the scan, mm). What is off by less than a
    /// tenth of a micrometre stays, and costs nothing.
    /// @param moved per vertex, where it is known which moved
    /// @param normals of the vertices, where they are known; 3×0: taken from the triangles
    void move(SurfaceLayer& layer, const Points& vertices, const std::vector<char>& moved = {},
              const FloatPoints& normals = FloatPoints(3, 0)) const;
    int scan_vertex(int drawn) const { return source_[static_cast<std::size_t>(drawn)]; }
    int drawn_count() const { return static_cast<int>(source_.size()); }

private:
    void turn_normal(SurfaceLayer& layer, const Points& vertices, int welded) const;

    std::vector<int> source_;           ///< drawn vertex -> scan vertex
    std::vector<int> source_uv_;        ///< drawn vertex -> UV, -1
    std::vector<int> source_material_;  ///< drawn vertex -> material, -1
    std::vector<std::uint32_t> indices_;
    std::vector<int> welded_;  ///< scan vertex -> welded vertex, -1 unused
    Triangles welded_triangles_;
    std::vector<int> first_;                   ///< welded vertex -> a scan vertex
    VertexTriangles triangles_;                ///< at welded vertices
    std::vector<int> drawn_start_, drawn_of_;  ///< per welded vertex: drawn vertices
};

/// 0 on open skin … 1 deep in folds, for soft shadows: from the smoothed mean curvature.
Eigen::VectorXf fold_depth(const TriangleMesh& mesh);

}  // namespace myoface
