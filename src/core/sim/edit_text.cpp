// SPDX-License-Identifier: Apache-2.0
#include "edit_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "myoface/base/error.h"
#include "myoface/base/view_ray.h"

namespace myoface {

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    const std::size_t end = text.find_last_not_of(" \t");
    return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

bool read_number(const std::string& text, double& value) {
    const std::string word = trimmed(text);
    const char* begin = word.data() + (!word.empty() && word[0] == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    return !word.empty() && error == std::errc() && end == word.data() + word.size() &&
           std::isfinite(value);
}

/// Numbers between commas; empty when one of them is not a number.
std::vector<double> numbers(const std::string& text) {
    std::vector<double> result;
    std::size_t at = 0;
    while (at <= text.size()) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        double value = 0.0;
        if (!read_number(text.substr(at, comma - at), value)) {
            return {};
        }
        result.push_back(value);
        at = comma + 1;
    }
    return result;
}

void each_part(const std::string& text,
               const std::function<void(const std::string& key, const std::string& value)>& take) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(';', at), text.size());
        const std::string part = trimmed(text.substr(at, end - at));
        at = end + 1;
        if (!part.empty()) {
            const std::size_t equals = part.find('=');
            take(trimmed(part.substr(0, equals)),
                 equals == std::string::npos ? "" : trimmed(part.substr(equals + 1)));
        }
    }
}

ViewAxes view_axes(const std::string& name) {
    const std::vector<double> xyz = numbers(name);
    if (xyz.size() == 3) {
        const Vec3 direction(xyz[0], xyz[1], xyz[2]);
        if (!(direction.norm() > 1e-9 && direction.norm() < 1e9)) {
            throw InvalidInput("View '" + name + "': the direction has no usable length.");
        }
        const auto plane = view_plane(direction);
        return {plane.col(0), plane.col(1), direction.normalized()};
    }
    const Eigen::Quaterniond q = standard_view(name);
    return {q * Vec3::UnitX(), q * Vec3::UnitY(), q * -Vec3::UnitZ()};
}

}  // namespace myoface
