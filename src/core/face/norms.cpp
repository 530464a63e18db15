// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/norms.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <sstream>

#include <Eigen/Geometry>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> cells;
    std::istringstream stream(text);
    for (std::string cell; std::getline(stream, cell, at);) {
        cells.push_back(cell);
    }
    return cells;
}

MeasureKind kind_of(const std::string& word) {
    if (word == "distance") {
        return MeasureKind::Distance;
    }
    if (word == "angle") {
        return MeasureKind::Angle;
    }
    if (word == "tilt") {
        return MeasureKind::Tilt;
    }
    if (word == "depth") {
        return MeasureKind::Depth;
    }
    throw IoError("assets/norms.csv: there is no kind of measure '" + word + "'.");
}

constexpr double kDegrees = 180.0 / std::numbers::pi;

class Points3 {
public:
    explicit Points3(const Landmarks& landmarks) : landmarks_(landmarks) {}
    std::optional<Vec3> operator()(const std::string& name) const {
        const auto found = landmarks_.find(name);
        return found == landmarks_.end() ? std::nullopt
                                         : std::optional<Vec3>(found->second.position);
    }
    bool paired(const std::string& name) const {
        return landmarks_.count(name) == 0 && landmarks_.count(name + "_l") > 0;
    }

private:
    const Landmarks& landmarks_;
};

std::optional<double> distance(const Points3& at, const std::string& a, const std::string& b) {
    const auto between = [&](const std::string& one,
                             const std::string& other) -> std::optional<double> {
        const auto p = at(one);
        const auto q = at(other);
        return p && q ? std::optional<double>((*p - *q).norm()) : std::nullopt;
    };
    if (a == b) {
        return between(a + "_l", b + "_r");
    }
    if (!at.paired(a) && !at.paired(b)) {
        return between(a, b);
    }
    const auto sided = [&](const std::string& name, const char* side) {
        return at.paired(name) ? name + side : name;
    };
    const auto left = between(sided(a, "_l"), sided(b, "_l"));
    const auto right = between(sided(a, "_r"), sided(b, "_r"));
    return left && right ? std::optional<double>(0.5 * (*left + *right)) : std::nullopt;
}

/// Axes of the face from its own landmarks: across the inner canthi, up from chin to glabella.
struct FaceAxes {
    Vec3 left, up, front;
};
std::optional<FaceAxes> axes_of(const Points3& at) {
    const auto l = at("en_l");
    const auto r = at("en_r");
    const auto top = at("g") ? at("g") : at("n");
    const auto low = at("pg") ? at("pg") : at("gn");
    if (!l || !r || !top || !low) {
        return std::nullopt;
    }
    FaceAxes axes;
    axes.left = (*l - *r).normalized();
    axes.up = *top - *low;
    axes.up = (axes.up - axes.up.dot(axes.left) * axes.left).normalized();
    axes.front = axes.left.cross(axes.up);
    return axes;
}

}  // namespace

std::vector<Norm> norms(std::optional<Sex> sex, double age) {
    const double share = std::clamp((age - 20.0) / 5.0, 0.0, 1.0);
    std::istringstream text(read_file(resource_path("assets/norms.csv")));
    std::vector<Norm> rows;
    std::string line;
    std::getline(text, line);  // header
    while (std::getline(text, line)) {
        const std::vector<std::string> cells = split(line, ',');
        if (cells.size() < 13) {
            continue;
        }
        std::array<double, 8> v{};
        for (std::size_t i = 0; i < v.size(); ++i) {
            const std::string& cell = cells[i + 3];
            if (std::from_chars(cell.data(), cell.data() + cell.size(), v[i]).ec != std::errc()) {
                throw IoError("assets/norms.csv: '" + cell + "' is not a number.");
            }
        }
        const auto blend = [&](std::size_t i) { return v[i] + share * (v[i + 4] - v[i]); };
        Norm norm;
        norm.measure = {cells[0], cells[11], kind_of(cells[1]), split(cells[2], ' ')};
        norm.source = cells[12];
        if (sex) {
            const std::size_t at = *sex == Sex::Male ? 0 : 2;
            norm.mean = blend(at);
            norm.sd = blend(at + 1);
        } else {
            norm.mean = 0.5 * (blend(0) + blend(2));
            norm.sd = 0.5 * (blend(1) + blend(3));
        }
        rows.push_back(std::move(norm));
    }
    return rows;
}

std::optional<double> measured(const Measure& measure, const Landmarks& landmarks) {
    const Points3 at(landmarks);
    const std::vector<std::string>& names = measure.points;
    switch (measure.kind) {
        case MeasureKind::Distance:
            return distance(at, names[0], names[1]);
        case MeasureKind::Angle: {
            const auto a = at(names[0]);
            const auto b = at(names[1]);
            const auto c = at(names[2]);
            if (!a || !b || !c) {
                return std::nullopt;
            }
            const Vec3 u = *a - *b;
            const Vec3 w = *c - *b;
            return kDegrees * std::atan2(u.cross(w).norm(), u.dot(w));
        }
        case MeasureKind::Tilt: {
            const auto axes = axes_of(at);
            double sum = 0.0;
            for (const char* side : {"_l", "_r"}) {
                const auto out = at(names[0] + side);
                const auto in = at(names[1] + side);
                if (!axes || !out || !in) {
                    return std::nullopt;
                }
                const Vec3 d = *out - *in;
                sum += std::atan2(d.dot(axes->up), std::abs(d.dot(axes->left)));
            }
            return kDegrees * 0.5 * sum;
        }
        case MeasureKind::Projection: {
            const auto axes = axes_of(at);
            const auto p = at(names[0]);
            const auto root = at("n");
            if (!axes || !p || !root) {
                return std::nullopt;
            }
            return (*p - *root).dot(axes->front);
        }
        case MeasureKind::Depth: {
            const auto axes = axes_of(at);
            const auto root = at(names[0]);
            const auto l = at(names[1] + "_l");
            const auto r = at(names[1] + "_r");
            if (!axes || !root || !l || !r) {
                return std::nullopt;
            }
            return (*root - 0.5 * (*l + *r)).dot(axes->front);
        }
    }
    return std::nullopt;
}

}  // namespace myoface
