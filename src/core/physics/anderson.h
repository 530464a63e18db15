// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "packed_data.h"

namespace myoface {

/// Anderson's acceleration of an iteration x → g(x): of the last few pairs the combination whose
/// residual g(x) − x is smallest, in the norm given by masses. @cite walker_2011
class Anderson {
public:
    explicit Anderson(std::size_t slices);

    /// Forgets what it has seen: another iteration, or far from where it was.
    void restart() { count_ = 0; }

    /// @param from x @param to g(x) on entry; where to go on from on return
    /// @param mass per node, 0 where fixed
    /// @return whether `to` was changed
    bool accelerate(const LargeArray<NodeRecord>& from, LargeArray<NodeRecord>& to,
                    const LargeArray<ScalarLanes>& mass);

private:
    struct Pair {
        LargeArray<VectorLanes> to, residual;  ///< differences to the pair before
    };
    std::vector<Pair> pairs_;
    LargeArray<VectorLanes> last_to_, last_residual_;
    int count_ = 0;  ///< calls since the restart
};

}  // namespace myoface
