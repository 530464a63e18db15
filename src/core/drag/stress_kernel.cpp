// SPDX-License-Identifier: Apache-2.0
#include "myoface/drag/stress_kernel.h"

#include <algorithm>
#include <cmath>

#include "myoface/drag/fibre_way.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/geodesic.h"

namespace myoface {

Grip grip_at(const FaceModel& face, const SurfacePoint& where) {
    Grip grip;
    for (int c = 0; c < 3; ++c) {
        if (where.weights[c] > 1e-9) {
            grip.nodes.push_back(face.skin.mesh.triangles(c, where.triangle));
            grip.weights.push_back(where.weights[c]);
        }
    }
    return grip;
}

Vec3 grip_position(const Grip& grip, const Points& positions) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < grip.nodes.size(); ++k) {
        sum += grip.weights[k] * positions.col(grip.nodes[k]);
    }
    return sum;
}

void spare(StressKernel& kernel, const Eigen::VectorXd& yielding) {
    double sum = 0.0;
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        kernel.profile[k] *= yielding[kernel.nodes[k]];
        kernel.weights[k] *= yielding[kernel.nodes[k]];
        sum += kernel.weights[k];
    }
    for (double& weight : kernel.weights) {
        weight /= std::max(sum, 1e-12);
    }
}

Eigen::VectorXd brushed(const FaceModel& face, const SurfacePoint& where, double radius) {
    const Points& skin = face.skin.mesh.vertices;
    const Grip grip = grip_at(face, where);
    const Vec3 centre = grip_position(grip, skin);
    std::vector<GeodesicSource> sources;
    for (const int node : grip.nodes) {
        sources.push_back({node, (skin.col(node) - centre).norm()});
    }
    const std::vector<double> distance =
        geodesic_distances(face.skin.mesh, *face.adjacency, sources, radius);
    Eigen::VectorXd share = Eigen::VectorXd::Zero(face.node_count());
    for (int i = 0; i < face.node_count(); ++i) {
        if (distance[static_cast<std::size_t>(i)] < radius) {
            const double t =
                std::clamp(2.0 - 2.0 * distance[static_cast<std::size_t>(i)] / radius, 0.0, 1.0);
            share[i] = t * t * (3.0 - 2.0 * t);
        }
    }
    return share;
}

SurfacePoint mirrored_place(const FaceModel& face, const SurfacePoint& where) {
    const TriangleMesh generic{face.generic, face.skin.mesh.triangles};
    Vec3 other = position(generic, where);
    other.x() = -other.x();
    return Bvh(generic).closest_point(generic, other).where;
}

double kernel_radius(const FaceModel& face, const Grip& grip) {
    double radius = 0.0;
    for (std::size_t k = 0; k < grip.nodes.size(); ++k) {
        const TissueProperties& tissue = face.tissue[grip.nodes[k]];
        const Vec3 p = face.generic.col(grip.nodes[k]);
        double own = 18.0;
        switch (tissue.region) {
            case Region::NoseDorsum:
            case Region::NoseSidewall:
            case Region::NoseTip:
            case Region::NoseAla:
            case Region::Columella:
                own = 11.0;
                break;
            case Region::UpperLip:
            case Region::LowerLip:
            case Region::UpperLid:
            case Region::LowerLid:
                own = 12.0;
                break;
            case Region::Brow:
            case Region::Glabella:
            case Region::Forehead:
            case Region::Temple:
                own = 15.0;
                break;
            case Region::Chin:
                own = 22.0;
                break;
            case Region::Cheek:
                // Towards the mouth corner the grip narrows.
                own = std::hypot(std::abs(p.x()) - 24.0, p.y() + 52.0) < 10.0 ? 12.0 : 20.0;
                break;
            default:
                break;
        }
        // Thick tissue is gripped more broadly than skin close to the bone.
        own *= std::clamp(std::sqrt(tissue.depth / 10.0), 0.9, 1.15);
        radius += grip.weights[k] * own;
    }
    return radius;
}

namespace {

/// Shares of the muscles under a grip, and of no muscle at the end.
std::vector<double> muscles_under(const FaceModel& face, const Grip& grip) {
    std::vector<double> shares(face.muscles.size() + 1, 0.0);
    for (std::size_t k = 0; k < grip.nodes.size(); ++k) {
        const auto& under = face.muscles_under[static_cast<std::size_t>(grip.nodes[k])];
        for (const MuscleWeight& entry : under) {
            shares[static_cast<std::size_t>(entry.muscle)] += grip.weights[k] * entry.weight;
        }
        shares.back() += under.empty() ? grip.weights[k] : 0.0;
    }
    return shares;
}

/// 1 where the same muscles lie under a node as under the grip, 0 where none of them does.
double in_common(const FaceModel& face, int node, const std::vector<double>& shares) {
    const auto& under = face.muscles_under[static_cast<std::size_t>(node)];
    double sum = under.empty() ? shares.back() : 0.0;
    for (const MuscleWeight& entry : under) {
        sum += std::min(entry.weight, shares[static_cast<std::size_t>(entry.muscle)]);
    }
    return sum;
}

}  // namespace

StressKernel stress_kernel(const FaceModel& face, const Points& skin, const Grip& grip,
                           double radius, double other_label, double elongation) {
    std::vector<GeodesicSource> sources;
    const Vec3 centre = grip_position(grip, skin);
    for (const int node : grip.nodes) {
        sources.push_back({node, (skin.col(node) - centre).norm()});
    }
    const std::vector<double> under = muscles_under(face, grip);
    const auto weight = [&](int node) {
        return 1.0 + (other_label - 1.0) * (1.0 - in_common(face, node, under));
    };
    const FibreWay fibres(face, grip, elongation);
    const TriangleMesh mesh{skin.leftCols(face.node_count()), face.skin.mesh.triangles};
    const std::vector<double> distance =
        geodesic_distances(mesh, *face.adjacency, sources, radius / fibres.least(),
                           other_label == 1.0 ? WayWeight{} : WayWeight(weight));
    StressKernel kernel;
    kernel.radius = radius;
    double sum = 0.0;
    for (int i = 0; i < face.node_count(); ++i) {
        if (!(distance[i] * fibres.least() < radius) || face.tissue[i].fixed) {
            continue;
        }
        const double counted = elongation == 1.0 ? distance[i] : distance[i] * fibres.factor(i);
        if (!(counted < radius)) {
            continue;
        }
        const double share = 1.0 - counted * counted / (radius * radius);
        const double w = share * share * face.area[i];
        kernel.nodes.push_back(i);
        kernel.weights.push_back(w);
        kernel.profile.push_back(share * share);
        sum += w;
    }
    if (!(sum > 0.0)) {  // a mesh coarser than the kernel: the grip itself
        kernel.nodes = grip.nodes;
        kernel.weights = grip.weights;
        kernel.profile.assign(grip.nodes.size(), 1.0);
        return kernel;
    }
    for (double& w : kernel.weights) {
        w /= sum;
    }
    return kernel;
}

}  // namespace myoface
