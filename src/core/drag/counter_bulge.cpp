// SPDX-License-Identifier: Apache-2.0
#include "myoface/drag/counter_bulge.h"

#include <algorithm>
#include <unordered_map>

namespace myoface {
namespace {

/// Slope of a function given at the corners of triangles, per vertex: mean over its triangles by
/// their area. Only at the vertices of the kernel. @return 3×kernel nodes [1/mm]
Points slopes(const FaceModel& face, const Points& skin, const StressKernel& kernel,
              const std::unordered_map<int, int>& place) {
    Points sum = Points::Zero(3, static_cast<Eigen::Index>(kernel.nodes.size()));
    Eigen::VectorXd area = Eigen::VectorXd::Zero(sum.cols());
    const auto profile = [&](int node) {
        const auto found = place.find(node);
        return found == place.end() ? 0.0 : kernel.profile[static_cast<std::size_t>(found->second)];
    };
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        for (const int t : face.adjacency->triangles(kernel.nodes[k])) {
            const auto corners = face.skin.mesh.triangles.col(t);
            const Vec3 a = skin.col(corners[0]);
            const Vec3 b = skin.col(corners[1]);
            const Vec3 c = skin.col(corners[2]);
            const Vec3 normal = (b - a).cross(c - a);  // twice the area long
            const double square = normal.squaredNorm();
            if (!(square > 0.0)) {
                continue;
            }
            const Vec3 slope =
                normal.cross(profile(corners[0]) * (c - b) + profile(corners[1]) * (a - c) +
                             profile(corners[2]) * (b - a)) /
                square;
            const double weight = 0.5 * std::sqrt(square);
            const auto i = static_cast<Eigen::Index>(k);
            sum.col(i) += weight * slope;
            area[i] += weight;
        }
    }
    for (Eigen::Index i = 0; i < sum.cols(); ++i) {
        sum.col(i) /= std::max(area[i], 1e-12);
    }
    return sum;
}

}  // namespace

Points counter_bulge(const FaceModel& face, const MassSpringModel& model, const Points& skin,
                     const StressKernel& kernel) {
    std::unordered_map<int, int> place;
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        place.emplace(kernel.nodes[k], static_cast<int>(k));
    }
    double work = 0.0;
    double stiffness = 0.0;
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        const int i = kernel.nodes[k];
        const double own = kernel.profile[k];
        work += kernel.weights[k] * own;
        stiffness += (model.ties[i].tether + model.ties[i].anchor) * own * own;
        for (int e = model.spring_start[i]; e < model.spring_start[i + 1]; ++e) {
            const SpringEnd& spring = model.spring_ends[e];
            const auto other = place.find(spring.other);
            const double there = other == place.end()
                                     ? 0.0
                                     : kernel.profile[static_cast<std::size_t>(other->second)];
            // A spring resists along itself only: half of it on average. Seen from both ends.
            const double counted = other == place.end() ? 0.5 : 0.25;
            stiffness += counted * spring.stiffness * (own - there) * (own - there);
        }
    }
    const double give = stiffness > 0.0 ? work / stiffness : 0.0;  // [mm/mN]
    Points bulge = slopes(face, skin, kernel, place);
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        const auto i = static_cast<std::size_t>(kernel.nodes[k]);
        const Vec3& normal = face.sliding[i].normal;
        auto push = bulge.col(static_cast<Eigen::Index>(k));
        push -= push.dot(normal) * normal;
        push *= -model.ties[i].thickness * face.tissue[i].depth * give;
    }
    return bulge;
}

}  // namespace myoface
