// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace myoface::bench {

inline double milliseconds(const std::function<void()>& action) {
    const auto start = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// @param share 0.5 median, 0.99 …
inline double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const auto last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(share * last + 0.5)];
}

/// Medians of actions that take turns, so that a noisy moment meets all of them.
inline std::vector<double> in_turns(const std::vector<std::function<void()>>& actions, int rounds) {
    std::vector<std::vector<double>> times(actions.size());
    for (int r = 0; r < rounds + 1; ++r) {
        for (std::size_t a = 0; a < actions.size(); ++a) {
            const double time = milliseconds(actions[a]);
            if (r > 0) {  // the first warms up
                times[a].push_back(time);
            }
        }
    }
    std::vector<double> medians;
    for (const auto& list : times) {
        medians.push_back(quantile(list, 0.5));
    }
    return medians;
}

}  // namespace myoface::bench
