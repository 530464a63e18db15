// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/fitted_net.h"

#include <algorithm>
#include <cmath>

#include "myoface/base/parallel.h"
#include "myoface/mesh/bvh.h"

#include "head/head_mesh.h"

namespace myoface {

FittedNet fitted_net(const FaceModel& face, double spacing) {
    // Which points of the average head's front belong to the net: those of the template's reach.
    constexpr double kHalfWidth = 64.0;
    constexpr double kTop = 66.0;
    constexpr double kBottom = -96.0;
    constexpr double kSteepest = 4.0;  // of the spacing, from one point to the next
    const HeadField& head = average_head();
    const int columns = 2 * static_cast<int>(kHalfWidth / spacing) + 1;
    const int rows = static_cast<int>((kTop - kBottom) / spacing) + 1;
    Points front(3, static_cast<Eigen::Index>(columns) * rows);
    parallel_for(rows, 1, [&](int begin, int end) {
        for (int r = begin; r < end; ++r) {
            for (int c = 0; c < columns; ++c) {
                front.col(static_cast<Eigen::Index>(r) * columns + c) =
                    head.front_point((c - columns / 2) * spacing, kTop - r * spacing);
            }
        }
    });
    FittedNet net;
    net.points.resize(3, front.cols());
    net.distance.resize(front.cols());
    const Bvh bvh(face.skin.mesh);
    const Similarity back = face.to_generic.inverse();
    parallel_for(static_cast<int>(front.cols()), 64, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            net.points.col(i) = back(face.from_generic(Vec3(front.col(i))));
            net.distance[i] = bvh.closest_point(face.skin.mesh, net.points.col(i)).distance;
        }
    });
    const auto tie = [&](int a, int b) {
        if ((front.col(a) - front.col(b)).norm() < kSteepest * spacing &&
            std::min(front(2, a), front(2, b)) > 25.0) {
            net.threads.emplace_back(a, b);
        }
    };
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            const int i = r * columns + c;
            if (c + 1 < columns) {
                tie(i, i + 1);
            }
            if (r + 1 < rows) {
                tie(i, i + columns);
            }
        }
    }
    return net;
}

}  // namespace myoface
