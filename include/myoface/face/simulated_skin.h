// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// The skin that carries masses and springs, and how the scan follows it. "Skin node" means a
/// vertex of `mesh`.
struct SimulatedSkin {
    /// The scan's main part with seams welded; of a scan that is finer than the simulation needs,
    /// a coarser mesh on some of its vertices.
    TriangleMesh mesh;
    Points normals;           ///< 3×nodes, unit
    std::vector<int> vertex;  ///< per node: a vertex of the scan in its place
    /// Per vertex of the scan: the nodes it lies between. The first alone where it is in a node's
    /// place or hangs on one; -1 in loose parts, which ride along unmoved.
    Eigen::Matrix<int, 3, Eigen::Dynamic> between;
    Eigen::Matrix<float, 3, Eigen::Dynamic> shares;
    /// Of a coarser mesh, per node: inverse of Σ eeᵀ + s nnᵀ over the edges e to its neighbours,
    /// s their mean square length; nothing where every vertex is in a node's place.
    std::vector<Mat3> surroundings;
    int part = -1;  ///< which of the scan's connected parts it is

    bool coarse() const { return !surroundings.empty(); }
};

/// Where the scan's vertices are when the nodes have moved. Between nodes a vertex goes with the
/// affine motion of each, so that what is finer than the nodes keeps its shape and turns along:
/// x' = Σ w (p' + F (x − p)), F the best fit of the moved edges and normal.
/// @param scan 3×vertices at rest @cite sumner_2007
Points follow(const SimulatedSkin& skin, const Adjacency& adjacency, const Points& scan,
              const Points& nodes);

/// The scan as it is shown, frame after frame: only what follows nodes that have moved since the
/// frame before is touched.
class FollowingScan {
public:
    /// @param skin, adjacency outlive it @param normals 3×vertices of the scan at rest, unit
    FollowingScan(const SimulatedSkin& skin, const Adjacency& adjacency, const Points& scan,
                  const Eigen::Matrix3Xf& normals);

    /// As follow(), to within about a hundredth of a millimetre.
    const Points& follow(const Points& nodes);
    /// Of a scan that is finer than its nodes: normals turned by the affine motion of the nodes,
    /// which spares a walk over all triangles; else 3×0.
    const Eigen::Matrix3Xf& normals() const { return normals_; }
    /// Per vertex of the scan: whether the last follow() touched it.
    const std::vector<char>& touched() const { return touched_; }

private:
    void follow_vertex(int v);

    const SimulatedSkin& skin_;
    const Adjacency& adjacency_;
    const Points scan_;
    Points vertices_;
    Eigen::Matrix3Xf rest_normals_, normals_;
    Points nodes_;              ///< as they were when `vertices_` last followed them
    std::vector<Mat3> motion_;  ///< per node: affine motion less 1
    std::vector<char> moved_, stale_, touched_;
};

}  // namespace myoface
