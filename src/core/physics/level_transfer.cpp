// SPDX-License-Identifier: Apache-2.0
#include "level_transfer.h"

#include <map>
#include <numeric>

#include "myoface/base/parallel.h"

namespace myoface {
namespace {
constexpr int kTransferGrain = 512;  // rows
}

LevelTransfer::LevelTransfer(const CoarseLevel& level, const PackedModel::Data& finer,
                             const PackedModel::Data& coarser)
    : finer_rows_(finer.nodes), coarser_rows_(coarser.nodes) {
    const auto& prolongation = level.prolongation();
    const auto finer_skin = static_cast<int>(prolongation.rows());
    const auto coarser_skin = static_cast<int>(prolongation.cols());
    up_.start.assign(1, 0);
    is_fixed_.resize(static_cast<std::size_t>(finer_rows_));
    for (int r = 0; r < finer_rows_; ++r) {
        const int node = finer.node_of[r];
        is_fixed_[r] = finer.model.fixed[node];
        if (node >= finer_skin) {  // the muscles' chains are the same
            up_.column.push_back(coarser.row_of[node - finer_skin + coarser_skin]);
            up_.weight.push_back(1.0F);
        } else {
            using Entry = std::decay_t<decltype(prolongation)>::InnerIterator;
            for (Entry entry(prolongation, node); entry; ++entry) {
                up_.column.push_back(coarser.row_of[entry.col()]);
                up_.weight.push_back(static_cast<float>(entry.value()));
            }
        }
        up_.start.push_back(static_cast<int>(up_.column.size()));
    }
    down_.start.assign(static_cast<std::size_t>(coarser_rows_) + 1, 0);
    for (const int c : up_.column) {
        ++down_.start[c + 1];
    }
    std::partial_sum(down_.start.begin(), down_.start.end(), down_.start.begin());
    down_.column.resize(up_.column.size());
    down_.weight.resize(up_.column.size());
    std::vector<int> next(down_.start.begin(), down_.start.end() - 1);
    for (int r = 0; r < finer_rows_; ++r) {
        for (int e = up_.start[r]; e < up_.start[r + 1]; ++e) {
            const int at = next[up_.column[e]]++;
            down_.column[at] = r;
            down_.weight[at] = up_.weight[e];
        }
    }
    injected_.resize(static_cast<std::size_t>(coarser_rows_));
    for (int r = 0; r < coarser_rows_; ++r) {
        const int node = coarser.node_of[r];
        injected_[r] = finer.row_of[node < coarser_skin ? level.finer_node(node)
                                                        : node - coarser_skin + finer_skin];
    }
}

void LevelTransfer::restrict_ways(const LargeArray<NodeRecord>& finer,
                                  LargeArray<NodeRecord>& coarser) const {
    for (int r = 0; r < coarser_rows_; ++r) {
        for (int axis = 0; axis < 3; ++axis) {
            coarser[r].moved[axis] = finer[injected_[r]].moved[axis];
        }
    }
}

void LevelTransfer::restrict_forces(const LargeArray<VectorLanes>& finer,
                                    LargeArray<VectorLanes>& coarser) const {
    parallel_for(coarser_rows_, kTransferGrain, [&](int begin, int end) {
        const FlushTiny flush;
        for (int r = begin; r < end; ++r) {
            float sum[3] = {};
            for (int e = down_.start[r]; e < down_.start[r + 1]; ++e) {
                for (int axis = 0; axis < 3; ++axis) {
                    sum[axis] += down_.weight[e] * of_row(finer, down_.column[e], axis);
                }
            }
            for (int axis = 0; axis < 3; ++axis) {
                of_row(coarser, r, axis) = sum[axis];
            }
        }
    });
}

void LevelTransfer::prolong(const LargeArray<NodeRecord>& from, const LargeArray<NodeRecord>& to,
                            LargeArray<VectorLanes>& finer) const {
    parallel_for(finer_rows_, kTransferGrain, [&](int begin, int end) {
        const FlushTiny flush;
        for (int r = begin; r < end; ++r) {
            float sum[3] = {};
            if (is_fixed_[r] == 0) {
                for (int e = up_.start[r]; e < up_.start[r + 1]; ++e) {
                    const int c = up_.column[e];
                    for (int axis = 0; axis < 3; ++axis) {
                        sum[axis] += up_.weight[e] * (to[c].moved[axis] - from[c].moved[axis]);
                    }
                }
            }
            for (int axis = 0; axis < 3; ++axis) {
                of_row(finer, r, axis) = sum[axis];
            }
        }
    });
}

void LevelTransfer::restrict_weights(const std::vector<int>& rows,
                                     const std::vector<double>& weights,
                                     std::vector<int>& coarse_rows,
                                     std::vector<double>& coarse_weights) const {
    std::map<int, double> sum;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        for (int e = up_.start[rows[k]]; e < up_.start[rows[k] + 1]; ++e) {
            sum[up_.column[e]] += weights[k] * static_cast<double>(up_.weight[e]);
        }
    }
    coarse_rows.clear();
    coarse_weights.clear();
    for (const auto& [row, weight] : sum) {
        coarse_rows.push_back(row);
        coarse_weights.push_back(weight);
    }
}

}  // namespace myoface
