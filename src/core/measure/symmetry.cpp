// SPDX-License-Identifier: Apache-2.0
#include "myoface/measure/symmetry.h"

#include <cmath>
#include <limits>

#include "myoface/base/parallel.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/normals.h"

namespace myoface {

Eigen::VectorXd side_differences(const FaceModel& face, const Points& nodes,
                                 const Progress* progress) {
    constexpr double kTooFar = 20.0;  // [mm]
    constexpr int kGrain = 128;
    constexpr int kPieces = 12;  // between two looks at whether to go on
    const int n = face.node_count();
    const TriangleMesh skin{nodes.leftCols(n), face.skin.mesh.triangles};
    const Points normals = vertex_normals(skin, *face.adjacency);
    // Mirrored, with its triangles turned round so that they still face outwards.
    TriangleMesh other = skin;
    for (int i = 0; i < n; ++i) {
        other.vertices.col(i) = mirrored(face.midplane, skin.vertices.col(i));
    }
    other.triangles.row(1).swap(other.triangles.row(2));
    const Bvh bvh(other);
    Eigen::VectorXd result(n);
    for (int piece = 0; piece < kPieces; ++piece) {
        if (progress != nullptr) {
            progress->report("comparing the sides", static_cast<double>(piece) / kPieces);
        }
        const int first = n * piece / kPieces;
        const int last = n * (piece + 1) / kPieces;
        parallel_for(last - first, kGrain, [&](int begin, int end) {
            for (int i = first + begin; i < first + end; ++i) {
                const Vec3 place = skin.vertices.col(i);
                const ClosestPoint closest = bvh.closest_point(other, place);
                const Vec3 way = place - closest.point;
                result[i] = closest.distance < kTooFar
                                ? std::copysign(closest.distance, way.dot(normals.col(i)))
                                : std::numeric_limits<double>::quiet_NaN();
            }
        });
    }
    return result;
}

}  // namespace myoface
