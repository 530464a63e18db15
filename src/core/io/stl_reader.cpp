// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

#include "myoface/base/error.h"

#include "number_text.h"
#include "readers.h"

namespace myoface {
namespace {

constexpr std::size_t kHead = 84;
constexpr std::size_t kFacet = 50;

std::uint32_t little_endian(const char* at) {
    std::uint32_t value = 0;
    for (int byte = 3; byte >= 0; --byte) {
        value = value << 8 | static_cast<unsigned char>(at[byte]);
    }
    return value;
}

/// Numbers points by first appearance; equal coordinates share a number.
class PointNumbers {
public:
    explicit PointNumbers(std::size_t expected) {
        std::size_t size = 64;
        while (size < 2 * expected) {
            size *= 2;
        }
        slots_.assign(size, -1);
    }

    int number(std::array<float, 3> point) {
        for (float& x : point) {
            x += 0.0F;  // -0 and 0 are one place
        }
        std::uint64_t hash = 0;
        for (const float x : point) {
            hash = (hash ^ std::bit_cast<std::uint32_t>(x)) * 0x9E3779B97F4A7C15U;
            hash ^= hash >> 32;
        }
        std::size_t slot = hash & (slots_.size() - 1);
        while (slots_[slot] >= 0 && points_[static_cast<std::size_t>(slots_[slot])] != point) {
            slot = (slot + 1) & (slots_.size() - 1);
        }
        if (slots_[slot] < 0) {
            slots_[slot] = static_cast<int>(points_.size());
            points_.push_back(point);
            if (2 * points_.size() > slots_.size()) {
                grow();
                return static_cast<int>(points_.size()) - 1;
            }
        }
        return slots_[slot];
    }

    const std::vector<std::array<float, 3>>& points() const { return points_; }

private:
    void grow() {
        std::vector<std::array<float, 3>> points = std::move(points_);
        PointNumbers larger(2 * slots_.size());
        for (const auto& point : points) {
            larger.number(point);
        }
        *this = std::move(larger);
    }

    std::vector<int> slots_;
    std::vector<std::array<float, 3>> points_;
};

class StlParser {
public:
    StlParser(std::string_view bytes, const std::string& name, Scan& scan, const Progress* progress)
        : bytes_(bytes), name_(name), scan_(scan), progress_(progress) {}

    void parse() {
        const bool text = !stl_is_binary(bytes_);
        scan_.format = text ? FileFormat::StlAscii : FileFormat::StlBinary;
        scan_.float_coordinates = true;
        PointNumbers numbers(text ? 1024 : bytes_.size() / kFacet / 2 + 16);
        text ? read_text(numbers) : read_binary(numbers);
        const auto& points = numbers.points();
        if (scan_.faces.count() == 0) {
            throw IoError(name_ + ": holds no triangles.");
        }
        scan_.mesh.vertices.resize(3, static_cast<Eigen::Index>(points.size()));
        for (std::size_t v = 0; v < points.size(); ++v) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                scan_.mesh.vertices(static_cast<Eigen::Index>(axis), static_cast<Eigen::Index>(v)) =
                    static_cast<double>(points[v][axis]);
            }
        }
    }

private:
    void report(std::size_t at) const {
        if (progress_ != nullptr) {
            progress_->report("Reading",
                              static_cast<double>(at) / static_cast<double>(bytes_.size()));
        }
    }

    void add(PointNumbers& numbers, const std::array<std::array<float, 3>, 3>& corners) {
        for (const auto& corner : corners) {
            scan_.faces.vertex.push_back(numbers.number(corner));
        }
        scan_.faces.start.push_back(static_cast<int>(scan_.faces.vertex.size()));
    }

    void read_binary(PointNumbers& numbers) {
        const std::size_t count = little_endian(bytes_.data() + 80);
        if (count > (bytes_.size() - kHead) / kFacet) {
            throw IoError(name_ + ": is truncated: it promises " + std::to_string(count) +
                          " triangles and holds " +
                          std::to_string((bytes_.size() - kHead) / kFacet) + ".");
        }
        scan_.faces.vertex.reserve(3 * count);
        scan_.faces.start.reserve(count + 1);
        for (std::size_t f = 0; f < count; ++f) {
            if (f % 65536 == 0) {
                report(kHead + f * kFacet);
            }
            std::array<std::array<float, 3>, 3> corners{};
            const char* at = bytes_.data() + kHead + f * kFacet + 12;
            for (auto& corner : corners) {
                for (float& x : corner) {
                    x = std::bit_cast<float>(little_endian(at));
                    at += 4;
                    if (!std::isfinite(x)) {
                        throw IoError(name_ + " triangle " + std::to_string(f) +
                                      ": a coordinate is not a finite number.");
                    }
                }
            }
            add(numbers, corners);
        }
    }

    void read_text(PointNumbers& numbers) {
        std::array<std::array<float, 3>, 3> corners{};
        std::size_t corner = 0;
        int line_number = 0;
        std::string_view text = bytes_;
        const auto fail = [&](const std::string& what) {
            throw IoError(name_ + " line " + std::to_string(line_number) + ": " + what);
        };
        while (!text.empty()) {
            const std::size_t stop = std::min(text.find('\n'), text.size());
            const char* at = text.data();
            const char* const end = at + stop;
            text.remove_prefix(std::min(stop + 1, text.size()));
            if (++line_number % 65536 == 0) {
                report(bytes_.size() - text.size());
            }
            while (at != end && is_blank(*at)) {
                ++at;
            }
            const std::string_view line(at, static_cast<std::size_t>(end - at));
            if (line.substr(0, 7) == "endloop") {
                if (corner != 3) {
                    fail("a facet needs three vertices, this one has " + std::to_string(corner) +
                         ".");
                }
                add(numbers, corners);
                corner = 0;
            } else if (line.substr(0, 6) == "vertex") {
                if (corner == 3) {
                    fail("a facet has more than three vertices.");
                }
                at += 6;
                for (float& x : corners[corner]) {
                    while (at != end && is_blank(*at)) {
                        ++at;
                    }
                    double value = 0.0;
                    at = read_number(at, end, value);
                    if (at == nullptr || (at != end && !is_blank(*at))) {
                        fail("a vertex needs three numbers.");
                    }
                    if (!is_usable(value)) {
                        fail("a coordinate is not a finite number.");
                    }
                    x = static_cast<float>(value);
                }
                ++corner;
            } else if (line.find('\0') != std::string_view::npos) {
                fail("holds binary data where text is expected (is the file truncated?).");
            }
        }
        if (corner != 0) {
            fail("the file ends within a facet (is it truncated?).");
        }
    }

    std::string_view bytes_;
    const std::string& name_;
    Scan& scan_;
    const Progress* progress_;
};

}  // namespace

bool stl_is_binary(std::string_view bytes) {
    if (bytes.size() < kHead) {
        return false;
    }
    const std::size_t count = little_endian(bytes.data() + 80);
    if (bytes.size() == kHead + count * kFacet) {
        return true;  // also where the head begins with "solid"
    }
    const std::string_view head = bytes.substr(0, 512);
    return head.substr(0, 5) != "solid" || head.find('\0') != std::string_view::npos;
}

void read_stl(std::string_view bytes, const std::string& name, Scan& scan,
              const Progress* progress) {
    StlParser(bytes, name, scan, progress).parse();
}

}  // namespace myoface
