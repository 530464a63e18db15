// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <Eigen/SparseCore>

#include "myoface/physics/build_mass_spring.h"

namespace myoface {

/// The face on fewer nodes, for corrections that reach far: its nodes are some of the finer skin's,
/// its muscle chains the same. Built once per face.
struct CoarseFace {
    std::shared_ptr<const FaceModel> face;  ///< what build_mass_spring() needs of it, no more
    std::vector<int> fine;                  ///< per coarse skin node: the finer skin's node
    /// Finer skin nodes × coarse ones, rows sum to 1: between the coarse nodes linear, then
    /// smoothed, for a kink at every coarse edge would cost much energy of bending.
    Eigen::SparseMatrix<double, Eigen::RowMajor> prolongation;
    std::shared_ptr<const CoarseFace> coarser;  ///< the next level, or null
};
/// All levels below a face, down to a few hundred nodes; null for a face that is as small already.
std::shared_ptr<const CoarseFace> coarser_levels(const FaceModel& face);

/// A finer model on a coarser face.
class CoarseLevel {
public:
    /// @param skin_rest of the finer model, 3×its skin nodes
    CoarseLevel(std::shared_ptr<const CoarseFace> face, const FaceMassSpring& finer,
                const Points& skin_rest, const TissueConstants& constants);

    const MassSpringModel& model() const { return system_.model; }
    const CoarseLevel* coarser() const { return coarser_.get(); }

    /// Finer skin nodes × coarse skin nodes.
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& prolongation() const {
        return face_->prolongation;
    }
    /// The finer skin node that a coarse one stands for.
    int finer_node(int node) const { return face_->fine[static_cast<std::size_t>(node)]; }
    Drive restricted(const Drive& drive) const;

private:
    int finer_skin() const { return static_cast<int>(face_->prolongation.rows()); }

    std::shared_ptr<const CoarseFace> face_;
    const std::vector<MuscleChain>* finer_chains_ = nullptr;
    FaceMassSpring system_;
    std::unique_ptr<const CoarseLevel> coarser_;
};

}  // namespace myoface
