// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"

#include "number_text.h"
#include "ply_header.h"
#include "readers.h"

namespace myoface {
namespace {

template <typename T>
double load(const char* at, bool swap) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), at, sizeof(T));
    if (swap) {
        std::reverse(raw.begin(), raw.end());
    }
    return static_cast<double>(std::bit_cast<T>(raw));
}

double load(const char* at, PlyType type, bool swap) {
    switch (type) {
        case PlyType::Int8:
            return load<std::int8_t>(at, false);
        case PlyType::Uint8:
            return load<std::uint8_t>(at, false);
        case PlyType::Int16:
            return load<std::int16_t>(at, swap);
        case PlyType::Uint16:
            return load<std::uint16_t>(at, swap);
        case PlyType::Int32:
            return load<std::int32_t>(at, swap);
        case PlyType::Uint32:
            return load<std::uint32_t>(at, swap);
        case PlyType::Float32:
            return load<float>(at, swap);
        default:
            return load<double>(at, swap);
    }
}

/// Where a vertex property goes.
enum Slot { kX, kY, kZ, kRed, kGreen, kBlue, kAlpha, kU, kV, kSlots, kNowhere = -1 };

Slot slot_of(const PlyProperty& property) {
    static const std::map<std::string_view, Slot> kNames{{"x", kX},
                                                         {"y", kY},
                                                         {"z", kZ},
                                                         {"red", kRed},
                                                         {"green", kGreen},
                                                         {"blue", kBlue},
                                                         {"alpha", kAlpha},
                                                         {"r", kRed},
                                                         {"g", kGreen},
                                                         {"b", kBlue},
                                                         {"a", kAlpha},
                                                         {"diffuse_red", kRed},
                                                         {"diffuse_green", kGreen},
                                                         {"diffuse_blue", kBlue},
                                                         {"s", kU},
                                                         {"t", kV},
                                                         {"u", kU},
                                                         {"v", kV},
                                                         {"texture_u", kU},
                                                         {"texture_v", kV}};
    const auto found = kNames.find(property.name);
    return found == kNames.end() || property.is_list ? kNowhere : found->second;
}

class PlyParser {
public:
    PlyParser(std::string_view bytes, const std::string& name, Scan& scan, const Progress* progress)
        : bytes_(bytes), name_(name), scan_(scan), progress_(progress) {}

    void parse() {
        const PlyHeader header = read_ply_header(bytes_, name_);
        at_ = header.size;
        scan_.format = header.format;
        ascii_ = header.format == FileFormat::PlyAscii;
        swap_ = !ascii_ && (header.format == FileFormat::PlyBinaryBig) !=
                               (std::endian::native == std::endian::big);
        for (const PlyElement& element : header.elements) {
            wedge_limit_ = element.name == "vertex" ? element.count : wedge_limit_;
        }
        for (const PlyElement& element : header.elements) {
            if (element.name == "vertex") {
                vertices(element);
            } else if (element.name == "face") {
                faces(element);
            } else if (element.name == "tristrips") {
                strips(element);
            } else {
                skip(element);
            }
        }
        finish();
        textures(header.textures);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw IoError(name_ + ": " + what); }
    [[noreturn]] void fail_at(const PlyElement& element, std::size_t i,
                              const std::string& what) const {
        throw IoError(name_ + " " + element.name + " " + std::to_string(i) + ": " + what);
    }
    [[noreturn]] void fail_end(const PlyElement& element, std::size_t i) const {
        fail_at(element, i, "the file ends here (is it truncated?).");
    }

    double value(const PlyElement& element, std::size_t i, PlyType type) {
        if (ascii_) {
            return ascii_value(element, i);
        }
        const std::size_t size = size_of(type);
        if (bytes_.size() - at_ < size) {
            fail_end(element, i);
        }
        const double result = load(bytes_.data() + at_, type, swap_);
        at_ += size;
        return result;
    }

    double ascii_value(const PlyElement& element, std::size_t i) {
        const char* const end = bytes_.data() + bytes_.size();
        const char* p = bytes_.data() + at_;
        while (p != end && ends_word(*p)) {
            ++p;
        }
        if (p == end) {
            fail_end(element, i);
        }
        double result = 0.0;
        const char* const stop = read_number(p, end, result);
        if (stop == nullptr || (stop != end && !ends_word(*stop))) {
            fail_at(element, i, quoted(p, end) + " is not a number.");
        }
        at_ = static_cast<std::size_t>(stop - bytes_.data());
        return result;
    }

    std::size_t list_size(const PlyElement& element, std::size_t i, const PlyProperty& property) {
        const double count = value(element, i, property.count_type);
        const double left = static_cast<double>(bytes_.size() - at_) + 1.0;
        const auto least = static_cast<double>(ascii_ ? 1 : size_of(property.type));
        if (!std::isfinite(count) || count < 0.0 || count != std::floor(count) ||
            count * least > left) {
            fail_at(element, i, "a list has an impossible length.");
        }
        return static_cast<std::size_t>(count);
    }

    void skip(const PlyElement& element, std::size_t i, const PlyProperty& property) {
        const std::size_t count = property.is_list ? list_size(element, i, property) : 1;
        for (std::size_t k = 0; k < count; ++k) {
            value(element, i, property.type);
        }
    }

    void skip(const PlyElement& element) {
        scan_.findings.other_statements += static_cast<int>(element.count);
        for (std::size_t i = 0; i < element.count; ++i) {
            report(i);
            for (const PlyProperty& property : element.properties) {
                skip(element, i, property);
            }
        }
    }

    void report(std::size_t i) const {
        if (progress_ != nullptr && i % 65536 == 0) {
            progress_->report("Reading",
                              static_cast<double>(at_) / static_cast<double>(bytes_.size()));
        }
    }

    void vertices(const PlyElement& element) {
        std::vector<Slot> slots;
        std::array<bool, kSlots> has{};
        scan_.float_coordinates = true;
        for (const PlyProperty& property : element.properties) {
            const Slot slot = slot_of(property);
            slots.push_back(slot);
            if (slot == kNowhere) {
                continue;
            }
            if (has[slot]) {
                fail("the PLY header gives '" + property.name + "' a second time.");
            }
            has[slot] = true;
            if (slot <= kZ && property.type != PlyType::Float32) {
                scan_.float_coordinates = false;
            }
            if (slot == kRed && property.type < PlyType::Float32) {
                scan_.byte_colours = true;
                colour_scale_ = size_of(property.type) == 1   ? 1.0 / 255.0
                                : size_of(property.type) == 2 ? 1.0 / 65535.0
                                                              : 1.0 / 255.0;
            }
        }
        if (!(has[kX] && has[kY] && has[kZ])) {
            fail("its vertices have no x, y and z.");
        }
        const auto n = static_cast<Eigen::Index>(element.count);
        scan_.mesh.vertices.resize(3, n);
        if (has[kRed] && has[kGreen] && has[kBlue]) {
            scan_.colours.resize(3, n);
            scan_.alpha.resize(has[kAlpha] ? n : 0);
        }
        if (has[kU] && has[kV]) {
            scan_.uv.resize(2, n);
        }
        const bool fixed =
            !ascii_ && std::none_of(element.properties.begin(), element.properties.end(),
                                    [](const auto& p) { return p.is_list; });
        if (fixed) {
            fixed_vertices(element, slots);
            return;
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            report(i);
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (property.is_list) {
                    skip(element, i, property);
                    continue;
                }
                const double number = value(element, i, property.type);
                if (!put(slots[p], static_cast<Eigen::Index>(i), number)) {
                    fail_at(element, i, "'" + property.name + "' is not a finite number.");
                }
            }
        }
    }

    /// Vertices that all take the same number of bytes are read side by side.
    void fixed_vertices(const PlyElement& element, const std::vector<Slot>& slots) {
        std::vector<std::size_t> offset;
        std::size_t stride = 0;
        for (const PlyProperty& property : element.properties) {
            offset.push_back(stride);
            stride += size_of(property.type);
        }
        if (element.count * stride > bytes_.size() - at_) {
            fail_end(element, (bytes_.size() - at_) / stride);
        }
        constexpr int kGrain = 16384;
        const auto count = static_cast<int>(element.count);
        std::vector<int> bad(static_cast<std::size_t>(count / kGrain) + 1, -1);
        report(0);
        parallel_for(count, kGrain, [&](int begin, int end) {
            int& first_bad = bad[static_cast<std::size_t>(begin / kGrain)];
            for (int i = begin; i < end; ++i) {
                const char* const at = bytes_.data() + at_ + static_cast<std::size_t>(i) * stride;
                for (std::size_t p = 0; p < slots.size(); ++p) {
                    if (slots[p] != kNowhere &&
                        !put(slots[p], i,
                             load(at + offset[p], element.properties[p].type, swap_)) &&
                        first_bad < 0) {
                        first_bad = i;
                    }
                }
            }
        });
        for (const int i : bad) {
            if (i >= 0) {
                fail_at(element, static_cast<std::size_t>(i), "holds a number that is not finite.");
            }
        }
        at_ += element.count * stride;
    }

    /// @return false for a number that is not finite
    bool put(Slot slot, Eigen::Index i, double number) {
        if (slot == kNowhere) {
            return true;
        }
        if (!is_usable(number)) {
            return false;
        }
        if (slot <= kZ) {
            scan_.mesh.vertices(slot, i) = number;
        } else if (slot <= kBlue && scan_.colours.cols() > 0) {
            scan_.colours(slot - kRed, i) =
                std::clamp(static_cast<float>(number * colour_scale_), 0.0F, 1.0F);
        } else if (slot == kAlpha && scan_.alpha.size() > 0) {
            scan_.alpha[i] = std::clamp(static_cast<float>(number * colour_scale_), 0.0F, 1.0F);
        } else if (slot >= kU && scan_.uv.cols() > 0) {
            scan_.uv(slot - kU, i) = static_cast<float>(number);
        }
        return true;
    }

    /// Binary faces that all have as many corners as the first one and nothing else in lists are
    /// read side by side. @return false with nothing done for others
    bool fixed_faces(const PlyElement& element) {
        std::size_t before = 0;
        std::size_t after = 0;
        const PlyProperty* list = nullptr;
        for (const PlyProperty& property : element.properties) {
            if (property.is_list) {
                const bool plain =
                    list == nullptr && size_of(property.count_type) == 1 &&
                    (property.type == PlyType::Int32 || property.type == PlyType::Uint32) &&
                    is_vertex_list(property);
                if (!plain) {
                    return false;
                }
                list = &property;
            } else if (property.name == "texnumber") {
                return false;
            } else {
                (list == nullptr ? before : after) += size_of(property.type);
            }
        }
        const std::size_t left = bytes_.size() - at_;
        if (ascii_ || list == nullptr || element.count == 0 || left <= before) {
            return false;
        }
        const char* const first = bytes_.data() + at_ + before;
        const char corners = *first;
        const std::size_t stride = before + 1 + 4 * static_cast<std::size_t>(corners) + after;
        if (corners < 3 || element.count > left / stride ||
            element.count * static_cast<std::size_t>(corners) > 500'000'000) {
            return false;
        }
        const auto count = static_cast<int>(element.count);
        scan_.faces.vertex.resize(element.count * static_cast<std::size_t>(corners));
        scan_.faces.start.resize(element.count + 1);
        std::atomic<bool> alike = true;
        report(0);
        parallel_for(count, 65536, [&](int begin, int end) {
            for (int f = begin; f < end; ++f) {
                const char* at = first + static_cast<std::size_t>(f) * stride;
                scan_.faces.start[static_cast<std::size_t>(f) + 1] = (f + 1) * corners;
                bool good = *at++ == corners;
                for (int c = f * corners; c < (f + 1) * corners; ++c, at += 4) {
                    std::uint32_t v = 0;
                    std::memcpy(&v, at, 4);
                    v = swap_ ? __builtin_bswap32(v) : v;
                    good = good && v < 2147483647U;
                    scan_.faces.vertex[static_cast<std::size_t>(c)] = static_cast<int>(v);
                }
                if (!good) {
                    alike = false;
                    return;
                }
            }
        });
        if (!alike) {
            scan_.faces = {};
            return false;
        }
        at_ += element.count * stride;
        return true;
    }

    static bool is_vertex_list(const PlyProperty& property) {
        return property.name == "vertex_indices" || property.name == "vertex_index";
    }

    void faces(const PlyElement& element) {
        if (scan_.faces.count() == 0 && fixed_faces(element)) {
            return;
        }
        scan_.faces.start.reserve(element.count + 1);
        scan_.faces.vertex.reserve(3 * element.count);
        std::vector<double> corner_uv;
        std::vector<int> texture_numbers;
        for (std::size_t i = 0; i < element.count; ++i) {
            report(i);
            corner_uv.clear();
            const std::size_t begin = scan_.faces.vertex.size();
            for (const PlyProperty& property : element.properties) {
                if (!property.is_list) {
                    const double number = value(element, i, property.type);
                    if (property.name == "texnumber") {
                        texture_numbers.push_back(std::isfinite(number) && number >= 0.0 &&
                                                          number < 1e6
                                                      ? static_cast<int>(number)
                                                      : -1);
                    }
                    continue;
                }
                const std::size_t count = list_size(element, i, property);
                if (is_vertex_list(property)) {
                    for (std::size_t k = 0; k < count; ++k) {
                        scan_.faces.vertex.push_back(vertex_number(element, i, property.type));
                    }
                } else {
                    const bool uv = property.name == "texcoord";
                    for (std::size_t k = 0; k < count; ++k) {
                        const double number = value(element, i, property.type);
                        if (uv) {
                            corner_uv.push_back(number);
                        }
                    }
                }
            }
            const std::size_t corners = scan_.faces.vertex.size() - begin;
            if (corners < 3) {
                fail_at(element, i, "has fewer than three corners.");
            }
            scan_.faces.start.push_back(static_cast<int>(scan_.faces.vertex.size()));
            append_wedge_uv(element, i, corner_uv, corners);
        }
        scan_.face_material = std::move(texture_numbers);
    }

    int vertex_number(const PlyElement& element, std::size_t i, PlyType type) {
        const double number = value(element, i, type);
        if (!std::isfinite(number) || number < 0.0 || number >= 2147483647.0) {
            fail_at(element, i, "vertex number out of range.");
        }
        return static_cast<int>(number);
    }

    /// Triangle strips as the scans of the Stanford archive have them: every vertex after the
    /// second makes a triangle with the two before it, sides alternating; -1 begins anew.
    void strips(const PlyElement& element) {
        for (std::size_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) {
                if (!property.is_list || property.name != "vertex_indices") {
                    skip(element, i, property);
                    continue;
                }
                const std::size_t count = list_size(element, i, property);
                int run = 0;
                int a = 0;
                int b = 0;
                for (std::size_t k = 0; k < count; ++k) {
                    report(k);
                    const double number = value(element, i, property.type);
                    if (number == -1.0 || number == 4294967295.0) {
                        run = 0;
                        continue;
                    }
                    if (!std::isfinite(number) || number < 0.0 || number >= 2147483647.0) {
                        fail_at(element, i, "vertex number out of range.");
                    }
                    const int c = static_cast<int>(number);
                    if (++run >= 3 && a != b && b != c && c != a) {
                        const bool odd = run % 2 == 1;
                        scan_.faces.vertex.insert(scan_.faces.vertex.end(),
                                                  {odd ? a : b, odd ? b : a, c});
                        scan_.faces.start.push_back(static_cast<int>(scan_.faces.vertex.size()));
                    }
                    a = b;
                    b = c;
                }
            }
        }
    }

    void append_wedge_uv(const PlyElement& element, std::size_t i,
                         const std::vector<double>& corner_uv, std::size_t corners) {
        const bool given = corner_uv.size() == 2 * corners;
        if (given && wedge_uv_.empty()) {
            scan_.faces.uv.assign(scan_.faces.vertex.size() - corners, -1);
        }
        if (!given && wedge_uv_.empty()) {
            return;
        }
        for (std::size_t k = 0; k < corners; ++k) {
            if (!given) {
                scan_.faces.uv.push_back(-1);
                continue;
            }
            if (!is_usable(corner_uv[2 * k]) || !is_usable(corner_uv[2 * k + 1])) {
                fail_at(element, i, "a texture coordinate is not a finite number.");
            }
            scan_.faces.uv.push_back(wedge(
                scan_.faces.vertex[scan_.faces.vertex.size() - corners + k],
                static_cast<float>(corner_uv[2 * k]), static_cast<float>(corner_uv[2 * k + 1])));
        }
    }

    /// Number of a vertex' texture coordinate: corners that agree share one.
    int wedge(int vertex, float u, float v) {
        const auto at = static_cast<std::size_t>(vertex);
        if (first_wedge_.size() <= at) {
            if (vertex >= static_cast<int>(wedge_limit_)) {
                return add_wedge(u, v, -1);  // no such vertex: refused later
            }
            first_wedge_.resize(wedge_limit_, -1);
        }
        for (int t = first_wedge_[at]; t >= 0; t = next_wedge_[static_cast<std::size_t>(t)]) {
            if (wedge_uv_[2 * static_cast<std::size_t>(t)] == u &&
                wedge_uv_[2 * static_cast<std::size_t>(t) + 1] == v) {
                return t;
            }
        }
        return first_wedge_[at] = add_wedge(u, v, first_wedge_[at]);
    }

    int add_wedge(float u, float v, int next) {
        wedge_uv_.push_back(u);
        wedge_uv_.push_back(v);
        next_wedge_.push_back(next);
        return static_cast<int>(next_wedge_.size()) - 1;
    }

    void finish() {
        const auto n = static_cast<int>(scan_.mesh.vertices.cols());
        if (n == 0) {
            fail("holds no vertices, this is not a face scan.");
        }
        if (scan_.faces.count() == 0) {
            fail("holds points but no faces; export the scan as a mesh.");
        }
        for (int f = 0; f < scan_.faces.count(); ++f) {
            for (int c = scan_.faces.start[f]; c < scan_.faces.start[f + 1]; ++c) {
                if (scan_.faces.vertex[c] >= n) {
                    fail("face " + std::to_string(f) + " names vertex " +
                         std::to_string(scan_.faces.vertex[c]) + ", the file has only " +
                         std::to_string(n) + ".");
                }
            }
        }
        if (!wedge_uv_.empty()) {
            scan_.faces.uv.resize(scan_.faces.vertex.size(), -1);
            scan_.uv = Eigen::Map<const Eigen::Matrix2Xf>(
                wedge_uv_.data(), 2, static_cast<Eigen::Index>(wedge_uv_.size() / 2));
        } else if (scan_.uv.cols() > 0) {
            scan_.faces.uv = scan_.faces.vertex;  // one coordinate per vertex
        }
    }

    /// One material per texture file; faces choose theirs by number.
    void textures(const std::vector<std::string>& names) {
        for (const std::string& name : names) {
            scan_.materials.push_back(
                {name, {1.0F, 1.0F, 1.0F, 1.0F}, static_cast<int>(scan_.textures.size())});
            scan_.textures.push_back({name, {}});
        }
        if (names.empty()) {
            scan_.face_material.clear();
            return;
        }
        const auto faces = static_cast<std::size_t>(scan_.faces.count());
        const bool chosen = scan_.face_material.size() == faces && names.size() > 1;
        if (!chosen) {
            scan_.face_material.assign(faces, 0);
        }
        for (int& material : scan_.face_material) {
            material = material < static_cast<int>(names.size()) ? material : -1;
        }
    }

    std::string_view bytes_;
    const std::string& name_;
    Scan& scan_;
    const Progress* progress_;
    std::size_t at_ = 0;
    bool ascii_ = false;
    bool swap_ = false;
    double colour_scale_ = 1.0;
    std::vector<float> wedge_uv_;
    std::vector<int> first_wedge_, next_wedge_;  ///< lists of the coordinates of each vertex
    std::size_t wedge_limit_ = 0;                ///< vertices that the header promises
};

}  // namespace

void read_ply(std::string_view bytes, const std::string& name, Scan& scan,
              const Progress* progress) {
    PlyParser(bytes, name, scan, progress).parse();
}

}  // namespace myoface
