// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace myoface {

/// A smooth bump of height 1 around 0.
inline double bump(double x) {
    return std::exp(-x * x);
}

/// Natural cubic spline through a table (C2), constant beyond its ends.
class Spline {
public:
    Spline(std::initializer_list<double> x, std::initializer_list<double> y)
        : x_(x), y_(y), curvature_(x.size(), 0.0) {
        const std::size_t n = x_.size();
        std::vector<double> diagonal(n, 1.0);
        std::vector<double> right(n, 0.0);
        for (std::size_t i = 1; i + 1 < n; ++i) {  // Thomas' algorithm, forward
            const double h0 = x_[i] - x_[i - 1];
            const double h1 = x_[i + 1] - x_[i];
            const double m = i > 1 ? h0 / diagonal[i - 1] : 0.0;
            diagonal[i] = 2.0 * (h0 + h1) - m * h0;
            right[i] = 6.0 * ((y_[i + 1] - y_[i]) / h1 - (y_[i] - y_[i - 1]) / h0) -
                       (i > 1 ? m * right[i - 1] : 0.0);
        }
        for (std::size_t i = n - 2; i >= 1; --i) {
            curvature_[i] = (right[i] - (x_[i + 1] - x_[i]) * curvature_[i + 1]) / diagonal[i];
        }
    }

    double operator()(double x) const {
        const double clamped = std::clamp(x, x_.front(), x_.back());
        const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, clamped);
        const auto i = static_cast<std::size_t>(above - x_.begin()) - 1;
        const double h = x_[i + 1] - x_[i];
        const double b = (clamped - x_[i]) / h;
        const double a = 1.0 - b;
        return a * y_[i] + b * y_[i + 1] +
               ((a * a * a - a) * curvature_[i] + (b * b * b - b) * curvature_[i + 1]) * h * h /
                   6.0;
    }

private:
    std::vector<double> x_, y_, curvature_;
};

}  // namespace myoface
