// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/physics/coarse_level.h"

#include "packed_data.h"

namespace myoface {

/// What goes between the packed models of two levels.
class LevelTransfer {
public:
    /// @param finer, coarser outlive it
    LevelTransfer(const CoarseLevel& level, const PackedModel::Data& finer,
                  const PackedModel::Data& coarser);

    /// The finer ways at the coarser nodes.
    void restrict_ways(const LargeArray<NodeRecord>& finer, LargeArray<NodeRecord>& coarser) const;
    /// Finer forces gathered at the coarser nodes: the transpose of prolong().
    void restrict_forces(const LargeArray<VectorLanes>& finer,
                         LargeArray<VectorLanes>& coarser) const;
    /// What the coarser nodes went, to − from, at the finer ones; those that are fixed stay.
    void prolong(const LargeArray<NodeRecord>& from, const LargeArray<NodeRecord>& to,
                 LargeArray<VectorLanes>& finer) const;
    /// Coarser rows and weights of finer ones.
    void restrict_weights(const std::vector<int>& rows, const std::vector<double>& weights,
                          std::vector<int>& coarse_rows, std::vector<double>& coarse_weights) const;

private:
    /// Sparse rows in single precision.
    struct Rows {
        std::vector<int> start, column;
        std::vector<float> weight;
    };

    int finer_rows_ = 0, coarser_rows_ = 0;
    Rows up_;                     ///< finer rows × coarser
    Rows down_;                   ///< its transpose
    std::vector<int> injected_;   ///< per coarser row: the finer row that it stands for
    std::vector<char> is_fixed_;  ///< per finer row
};

}  // namespace myoface
