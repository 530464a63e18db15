// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/coarse_level.h"

#include <algorithm>

#include "myoface/mesh/coarse_mesh.h"

namespace myoface {
namespace {

constexpr int kFewest = 900;         // nodes; below, relaxation alone is as fast
constexpr float kCoarsening = 1.5F;  // reach of a coarse node over the mean edge around it

template <typename T>
std::vector<T> picked(const std::vector<T>& values, const std::vector<int>& which) {
    std::vector<T> result;
    result.reserve(which.size());
    for (const int i : which) {
        result.push_back(values[static_cast<std::size_t>(i)]);
    }
    return result;
}

/// Pairs of touching lips that a coarse mesh keeps: not nearer to each other than its nodes.
std::vector<std::pair<int, int>> spread_contacts(const FaceModel& face,
                                                 const Eigen::VectorXf& spacing) {
    std::vector<std::pair<int, int>> kept;
    const Points& at = face.skin.mesh.vertices;
    for (const auto& pair : face.lip_contacts) {
        const auto near = [&](const auto& other) {
            const double away = std::min((at.col(pair.first) - at.col(other.first)).norm(),
                                         (at.col(pair.second) - at.col(other.second)).norm());
            return away < spacing[pair.first];
        };
        if (std::none_of(kept.begin(), kept.end(), near)) {
            kept.push_back(pair);
        }
    }
    return kept;
}

using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

Rows smooth_prolongation(const CoarseMesh& coarse, const Adjacency& adjacency) {
    constexpr int kPasses = 1;
    const auto n = static_cast<int>(coarse.between.cols());
    std::vector<Eigen::Triplet<double>> entries;
    for (int v = 0; v < n; ++v) {
        for (int k = 0; k < 3 && coarse.between(k, v) >= 0; ++k) {
            entries.emplace_back(v, coarse.between(k, v), coarse.shares(k, v));
        }
    }
    Rows prolongation(n, static_cast<int>(coarse.fine.size()));
    prolongation.setFromTriplets(entries.begin(), entries.end());
    entries.clear();
    for (int v = 0; v < n; ++v) {
        const auto neighbours = adjacency.neighbours(v);
        entries.emplace_back(v, v, neighbours.empty() ? 1.0 : 0.5);
        for (const int w : neighbours) {
            entries.emplace_back(v, w, 0.5 / static_cast<double>(neighbours.size()));
        }
    }
    Rows average(n, n);
    average.setFromTriplets(entries.begin(), entries.end());
    for (int pass = 0; pass < kPasses; ++pass) {
        prolongation = (average * prolongation).pruned(0.02, 1.0);
    }
    for (int v = 0; v < n; ++v) {  // what was left out is made up for
        const double sum = prolongation.row(v).sum();
        prolongation.row(v) *= 1.0 / sum;
    }
    return prolongation;
}

/// The finer linear stiffness as the coarser nodes feel it, PᵀKP: hinges on the coarser mesh would
/// be far softer than what its edges do to the finer ones.
LinearStiffness between_levels(const MassSpringModel& finer, const Rows& prolongation,
                               const MassSpringModel& coarser) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int v = 0; v < prolongation.rows(); ++v) {
        for (Rows::InnerIterator entry(prolongation, v); entry; ++entry) {
            entries.emplace_back(v, entry.col(), entry.value());
        }
    }
    const auto skin = static_cast<int>(prolongation.rows());
    for (int i = skin; i < finer.node_count(); ++i) {
        entries.emplace_back(i, i - skin + coarser.skin_nodes, 1.0);
    }
    Rows whole(finer.node_count(), coarser.node_count());
    whole.setFromTriplets(entries.begin(), entries.end());
    const Eigen::Map<const Rows> stiffness(finer.node_count(), finer.node_count(),
                                           static_cast<Eigen::Index>(finer.linear.value.size()),
                                           finer.linear.start.data(), finer.linear.column.data(),
                                           finer.linear.value.data());
    const Rows gathered = whole.transpose();
    const Rows product = gathered * Rows(stiffness * whole);
    LinearStiffness result;
    for (int i = 0; i < product.rows(); ++i) {
        for (Rows::InnerIterator entry(product, i); entry; ++entry) {
            result.column.push_back(static_cast<int>(entry.col()));
            result.value.push_back(entry.value());
        }
        result.start.push_back(static_cast<int>(result.column.size()));
    }
    return result;
}

std::shared_ptr<const CoarseFace> next_level(const FaceModel& face) {
    const TriangleMesh& mesh = face.skin.mesh;
    Eigen::VectorXf spacing(mesh.vertex_count());
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        double sum = 0.0;
        const auto neighbours = face.adjacency->neighbours(v);
        for (const int w : neighbours) {
            sum += (mesh.vertices.col(w) - mesh.vertices.col(v)).norm();
        }
        spacing[v] =
            kCoarsening * static_cast<float>(sum / std::max<double>(1.0, neighbours.size())) +
            1e-3F;
    }
    std::vector<std::pair<int, int>> contacts = spread_contacts(face, spacing);
    std::vector<int> kept;
    for (const auto& [upper, lower] : contacts) {
        kept.push_back(upper);
        kept.push_back(lower);
    }
    CoarseMesh coarse = coarsen(mesh, spacing, kept);
    if (coarse.mesh.vertex_count() > 0.7 * mesh.vertex_count()) {
        return nullptr;
    }
    auto fewer = std::make_shared<FaceModel>();
    fewer->skin.mesh = std::move(coarse.mesh);
    fewer->adjacency = std::make_shared<Adjacency>(fewer->skin.mesh);
    auto level = std::make_shared<CoarseFace>();
    level->prolongation = smooth_prolongation(coarse, *face.adjacency);
    fewer->area = level->prolongation.transpose() * face.area;
    fewer->generic = face.generic(Eigen::all, coarse.fine);
    fewer->tissue = picked(face.tissue, coarse.fine);
    fewer->sliding = picked(face.sliding, coarse.fine);
    fewer->label = picked(face.label, coarse.fine);
    fewer->muscles_under = picked(face.muscles_under, coarse.fine);
    fewer->lip_side = picked(face.lip_side, coarse.fine);
    fewer->muscles = face.muscles;
    fewer->axes = face.axes;
    fewer->obstacles = face.obstacles;
    fewer->obstacle_distance = face.obstacle_distance(coarse.fine);
    for (const auto& [upper, lower] : contacts) {
        fewer->lip_contacts.emplace_back(coarse.between(0, upper), coarse.between(0, lower));
    }
    level->face = std::move(fewer);
    level->fine = std::move(coarse.fine);
    level->coarser = coarser_levels(*level->face);
    return level;
}

}  // namespace

std::shared_ptr<const CoarseFace> coarser_levels(const FaceModel& face) {
    return face.node_count() < kFewest ? nullptr : next_level(face);
}

CoarseLevel::CoarseLevel(std::shared_ptr<const CoarseFace> face, const FaceMassSpring& finer,
                         const Points& skin_rest, const TissueConstants& constants)
    : face_(std::move(face)), finer_chains_(&finer.chains) {
    const Points rest = skin_rest(Eigen::all, face_->fine);
    system_ = build_mass_spring(*face_->face, rest, constants);
    system_.model.rest_gravity = finer.model.rest_gravity;
    // The chains' ends follow a reshaped skin; here as there.
    const Eigen::Index chains = finer.model.rest.cols() - finer_skin();
    system_.model.rest.rightCols(chains) = finer.model.rest.rightCols(chains);
    system_.model.linear = between_levels(finer.model, face_->prolongation, system_.model);
    if (face_->coarser) {
        coarser_ = std::make_unique<CoarseLevel>(face_->coarser, system_, rest, constants);
    }
}

Drive CoarseLevel::restricted(const Drive& drive) const {
    const int skin = system_.model.skin_nodes;
    const Eigen::Index total = system_.model.node_count();
    std::vector<int> nodes = face_->fine;
    for (Eigen::Index i = skin; i < total; ++i) {
        nodes.push_back(static_cast<int>(i) - skin + finer_skin());
    }
    Drive coarse;
    coarse.gravity = drive.gravity;
    coarse.obstacle_pose = drive.obstacle_pose;
    if (drive.inertia.size() > 0) {  // where it leads to is the finer level's to say
        coarse.inertia.resize(total);
        coarse.inertia.head(skin) =
            face_->prolongation.transpose() * drive.inertia.head(finer_skin());
        coarse.inertia.tail(total - skin) = drive.inertia.tail(total - skin);
        coarse.ahead = Points::Zero(3, total);
    }
    if (drive.shift.cols() > 0) {
        coarse.shift = drive.shift(Eigen::all, nodes);
    }
    if (drive.carry.cols() > 0) {
        coarse.carry = drive.carry(Eigen::all, nodes);
    }
    if (drive.height.size() > 0) {
        coarse.height = drive.height(nodes);
    }
    if (drive.tether_boost.size() > 0) {
        coarse.tether_boost = drive.tether_boost(nodes);
    }
    const auto of_chains = [&](const std::vector<double>& factors) {
        std::vector<double> result(system_.model.springs.size(), 1.0);
        for (std::size_t m = 0; m < system_.chains.size(); ++m) {
            const MuscleChain& here = system_.chains[m];
            std::copy_n(factors.begin() + (*finer_chains_)[m].first_spring, here.spring_count,
                        result.begin() + here.first_spring);
        }
        return result;
    };
    if (!drive.length_factor.empty()) {
        coarse.length_factor = of_chains(drive.length_factor);
    }
    if (!drive.stiffness_factor.empty()) {
        coarse.stiffness_factor = of_chains(drive.stiffness_factor);
    }
    return coarse;
}

}  // namespace myoface
