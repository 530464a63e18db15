// SPDX-License-Identifier: Apache-2.0
#include "anderson.h"

#include <algorithm>

#include <Eigen/Cholesky>

#include "myoface/base/parallel.h"

namespace myoface {
namespace {

constexpr int kPairs = 4;
constexpr int kBlockGrain = 64;       // slices
constexpr double kSlack = 1e-6;       // of the largest pair: keeps like pairs from cancelling
constexpr double kLargestMix = 30.0;  // a combination beyond this is noise

double weighted_dot(const LargeArray<VectorLanes>& a, const LargeArray<VectorLanes>& b,
                    const LargeArray<ScalarLanes>& mass) {
    const auto slices = static_cast<int>(a.size());
    std::vector<double> sums(static_cast<std::size_t>(slices / kBlockGrain + 1), 0.0);
    parallel_for(slices, kBlockGrain, [&](int begin, int end) {
        double sum = 0.0;
        for (int s = begin; s < end; ++s) {
            for (int k = 0; k < kLanes; ++k) {
                const float product = a[s].v[0][k] * b[s].v[0][k] + a[s].v[1][k] * b[s].v[1][k] +
                                      a[s].v[2][k] * b[s].v[2][k];
                sum += static_cast<double>(mass[s].s[k] * product);
            }
        }
        sums[begin / kBlockGrain] = sum;
    });
    double total = 0.0;
    for (const double sum : sums) {
        total += sum;
    }
    return total;
}

}  // namespace

Anderson::Anderson(std::size_t slices) : last_to_(slices), last_residual_(slices) {
    for (int p = 0; p < kPairs; ++p) {
        pairs_.push_back({LargeArray<VectorLanes>(slices), LargeArray<VectorLanes>(slices)});
    }
}

bool Anderson::accelerate(const LargeArray<NodeRecord>& from, LargeArray<NodeRecord>& to,
                          const LargeArray<ScalarLanes>& mass) {
    const auto slices = static_cast<int>(last_to_.size());
    Pair& newest = pairs_[static_cast<std::size_t>(std::max(count_ - 1, 0) % kPairs)];
    parallel_for(slices, kBlockGrain, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            for (int k = 0; k < kLanes; ++k) {
                const auto row = static_cast<std::size_t>(s * kLanes + k);
                for (int axis = 0; axis < 3; ++axis) {
                    const float there = to[row].moved[axis];
                    const float residual = there - from[row].moved[axis];
                    newest.to[s].v[axis][k] = there - last_to_[s].v[axis][k];
                    newest.residual[s].v[axis][k] = residual - last_residual_[s].v[axis][k];
                    last_to_[s].v[axis][k] = there;
                    last_residual_[s].v[axis][k] = residual;
                }
            }
        }
    });
    ++count_;
    const int n = std::min(count_ - 1, kPairs);
    if (n == 0) {
        return false;
    }
    Eigen::MatrixXd normal(n, n);
    Eigen::VectorXd right(n);
    for (int i = 0; i < n; ++i) {
        right[i] = weighted_dot(pairs_[i].residual, last_residual_, mass);
        for (int j = 0; j <= i; ++j) {
            normal(i, j) = normal(j, i) =
                weighted_dot(pairs_[i].residual, pairs_[j].residual, mass);
        }
    }
    normal.diagonal().array() += kSlack * normal.diagonal().maxCoeff() + 1e-30;
    const Eigen::VectorXd mix = normal.ldlt().solve(right);
    if (!mix.allFinite() || mix.cwiseAbs().maxCoeff() > kLargestMix) {
        restart();
        return false;
    }
    const Eigen::VectorXf share = mix.cast<float>();
    parallel_for(slices, kBlockGrain, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            for (int k = 0; k < kLanes; ++k) {
                for (int axis = 0; axis < 3; ++axis) {
                    float less = 0.0F;
                    for (int i = 0; i < n; ++i) {
                        less += share[i] * pairs_[i].to[s].v[axis][k];
                    }
                    to[static_cast<std::size_t>(s * kLanes + k)].moved[axis] -= less;
                }
            }
        }
    });
    return true;
}

}  // namespace myoface
