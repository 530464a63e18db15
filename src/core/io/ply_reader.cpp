// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

#include "myoface/base/error.h"

#include "readers.h"

namespace myoface {
namespace {

enum class Type { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t type_size(Type type) {
    switch (type) {
        case Type::Int8:
        case Type::Uint8:
            return 1;
        case Type::Int16:
        case Type::Uint16:
            return 2;
        case Type::Float64:
            return 8;
        default:
            return 4;
    }
}

struct Property {
    std::string name;
    Type type = Type::Float32;
    bool is_list = false;
    Type count_type = Type::Uint8;
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

std::string_view word_of(std::string_view& line) {
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) {
        line.remove_prefix(1);
    }
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
}

class PlyParser {
public:
    PlyParser(std::string_view bytes, const std::string& name, Scan& scan, const Progress* progress)
        : bytes_(bytes), name_(name), scan_(scan), progress_(progress) {}

    void parse() {
        header();
        for (const Element& element : elements_) {
            if (element.name == "vertex") {
                vertices(element);
            } else if (element.name == "face") {
                faces(element);
            } else {
                skip(element);
            }
        }
        finish();
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw IoError(name_ + ": " + what); }
    [[noreturn]] void fail_at(const Element& element, std::size_t i,
                              const std::string& what) const {
        throw IoError(name_ + " " + element.name + " " + std::to_string(i) + ": " + what);
    }

    std::string_view header_line() {
        const std::size_t end = bytes_.find('\n', at_);
        if (end == std::string_view::npos) {
            fail("the PLY header has no end (is the file truncated?).");
        }
        std::string_view line = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        if (!line.empty() && line.back() == '\r') {
            line.remove_suffix(1);
        }
        return line;
    }

    Type type_named(std::string_view name) const {
        static const std::map<std::string_view, Type> kTypes{
            {"char", Type::Int8},      {"int8", Type::Int8},       {"uchar", Type::Uint8},
            {"uint8", Type::Uint8},    {"short", Type::Int16},     {"int16", Type::Int16},
            {"ushort", Type::Uint16},  {"uint16", Type::Uint16},   {"int", Type::Int32},
            {"int32", Type::Int32},    {"uint", Type::Uint32},     {"uint32", Type::Uint32},
            {"float", Type::Float32},  {"float32", Type::Float32}, {"double", Type::Float64},
            {"float64", Type::Float64}};
        const auto found = kTypes.find(name);
        if (found == kTypes.end()) {
            fail("the PLY header names the unknown type '" + std::string(name.substr(0, 40)) +
                 "'.");
        }
        return found->second;
    }

    void header() {
        header_line();  // "ply", seen by the caller
        bool has_format = false;
        for (;;) {
            std::string_view line = header_line();
            const std::string_view key = word_of(line);
            if (key == "end_header") {
                break;
            }
            if (key == "format") {
                const std::string_view kind = word_of(line);
                has_format = true;
                if (kind == "ascii") {
                    scan_.format = FileFormat::PlyAscii;
                } else if (kind == "binary_little_endian") {
                    scan_.format = FileFormat::PlyBinaryLittle;
                } else if (kind == "binary_big_endian") {
                    scan_.format = FileFormat::PlyBinaryBig;
                } else {
                    fail("the PLY header names the unknown format '" +
                         std::string(kind.substr(0, 40)) + "'.");
                }
            } else if (key == "comment") {
                if (word_of(line) == "TextureFile") {
                    while (!line.empty() && line.front() == ' ') {
                        line.remove_prefix(1);
                    }
                    scan_.texture = line;
                }
            } else if (key == "element") {
                Element element;
                element.name = word_of(line);
                const std::string_view count = word_of(line);
                const auto parsed =
                    std::from_chars(count.data(), count.data() + count.size(), element.count);
                if (parsed.ec != std::errc() || parsed.ptr != count.data() + count.size() ||
                    count.empty()) {
                    fail("the PLY header gives no usable count for element '" + element.name +
                         "'.");
                }
                elements_.push_back(element);
            } else if (key == "property") {
                if (elements_.empty()) {
                    fail("the PLY header has a property before any element.");
                }
                Property property;
                std::string_view type = word_of(line);
                if (type == "list") {
                    property.is_list = true;
                    property.count_type = type_named(word_of(line));
                    type = word_of(line);
                }
                property.type = type_named(type);
                property.name = word_of(line);
                elements_.back().properties.push_back(property);
            }
        }
        if (!has_format) {
            fail("the PLY header names no format.");
        }
        if (scan_.format == FileFormat::PlyBinaryLittle) {
            swap_ = std::endian::native != std::endian::little;
        } else if (scan_.format == FileFormat::PlyBinaryBig) {
            swap_ = std::endian::native != std::endian::big;
        }
        for (const Element& element : elements_) {
            check_count(element);
        }
    }

    /// A count larger than the rest of the file could hold is a lie: refuse it before any memory
    /// is asked for.
    void check_count(const Element& element) const {
        std::size_t least = 0;
        for (const Property& property : element.properties) {
            least += scan_.format == FileFormat::PlyAscii
                         ? 2
                         : type_size(property.is_list ? property.count_type : property.type);
        }
        const std::size_t left = bytes_.size() - at_ + 1;
        if (least == 0 ? element.count > 0 : element.count > left / least) {
            fail("is truncated: the header promises " + std::to_string(element.count) + " '" +
                 element.name + "' elements, the file is too short for them.");
        }
    }

    template <typename T>
    double raw(const Element& element, std::size_t i) {
        if (bytes_.size() - at_ < sizeof(T)) {
            fail_at(element, i, "the file ends here (is it truncated?).");
        }
        std::array<char, sizeof(T)> buffer{};
        std::memcpy(buffer.data(), bytes_.data() + at_, sizeof(T));
        at_ += sizeof(T);
        if (swap_) {
            std::reverse(buffer.begin(), buffer.end());
        }
        return static_cast<double>(std::bit_cast<T>(buffer));
    }

    double value(const Element& element, std::size_t i, Type type) {
        if (scan_.format == FileFormat::PlyAscii) {
            return ascii_value(element, i);
        }
        switch (type) {
            case Type::Int8:
                return raw<std::int8_t>(element, i);
            case Type::Uint8:
                return raw<std::uint8_t>(element, i);
            case Type::Int16:
                return raw<std::int16_t>(element, i);
            case Type::Uint16:
                return raw<std::uint16_t>(element, i);
            case Type::Int32:
                return raw<std::int32_t>(element, i);
            case Type::Uint32:
                return raw<std::uint32_t>(element, i);
            case Type::Float32:
                return raw<float>(element, i);
            default:
                return raw<double>(element, i);
        }
    }

    double ascii_value(const Element& element, std::size_t i) {
        while (at_ < bytes_.size() && std::isspace(static_cast<unsigned char>(bytes_[at_]))) {
            ++at_;
        }
        if (at_ == bytes_.size()) {
            fail_at(element, i, "the file ends here (is it truncated?).");
        }
        const std::size_t begin = bytes_[at_] == '+' ? at_ + 1 : at_;
        double result = 0.0;
        const auto [end, error] =
            std::from_chars(bytes_.data() + begin, bytes_.data() + bytes_.size(), result);
        const auto stop = static_cast<std::size_t>(end - bytes_.data());
        const bool whole =
            stop == bytes_.size() || std::isspace(static_cast<unsigned char>(bytes_[stop]));
        if (error != std::errc() || !whole) {
            fail_at(
                element, i,
                "'" +
                    std::string(bytes_.substr(
                        at_, std::min<std::size_t>(20, bytes_.find_first_of(" \r\n", at_) - at_))) +
                    "' is not a number.");
        }
        at_ = stop;
        return result;
    }

    std::size_t list_size(const Element& element, std::size_t i, const Property& property) {
        const double count = value(element, i, property.count_type);
        const double left = static_cast<double>(bytes_.size() - at_) + 1.0;
        const auto least = static_cast<double>(
            scan_.format == FileFormat::PlyAscii ? 1 : type_size(property.type));
        if (!(count >= 0.0) || count != std::floor(count) || count * least > left) {
            fail_at(element, i, "a list has an impossible length.");
        }
        return static_cast<std::size_t>(count);
    }

    void skip(const Element& element) {
        for (std::size_t i = 0; i < element.count; ++i) {
            for (const Property& property : element.properties) {
                const std::size_t count = property.is_list ? list_size(element, i, property) : 1;
                for (std::size_t k = 0; k < count; ++k) {
                    value(element, i, property.type);
                }
            }
        }
    }

    void report(std::size_t i) const {
        if (progress_ != nullptr && i % 65536 == 0) {
            progress_->report("Reading",
                              static_cast<double>(at_) / static_cast<double>(bytes_.size()));
        }
    }

    void vertices(const Element& element) {
        // Where each property goes: 0-2 position, 3-5 colour, 6-7 UV.
        static const std::map<std::string_view, int> kSlots{{"x", 0},
                                                            {"y", 1},
                                                            {"z", 2},
                                                            {"red", 3},
                                                            {"green", 4},
                                                            {"blue", 5},
                                                            {"r", 3},
                                                            {"g", 4},
                                                            {"b", 5},
                                                            {"s", 6},
                                                            {"t", 7},
                                                            {"u", 6},
                                                            {"v", 7},
                                                            {"texture_u", 6},
                                                            {"texture_v", 7},
                                                            {"diffuse_red", 3},
                                                            {"diffuse_green", 4},
                                                            {"diffuse_blue", 5}};
        std::vector<int> slots;
        std::array<bool, 8> has{};
        double colour_scale = 1.0;
        for (const Property& property : element.properties) {
            const auto found = kSlots.find(property.name);
            const int slot = found == kSlots.end() || property.is_list ? -1 : found->second;
            slots.push_back(slot);
            if (slot >= 0) {
                has[slot] = true;
            }
            if (slot == 3 && type_size(property.type) < 4) {
                colour_scale = type_size(property.type) == 1 ? 1.0 / 255.0 : 1.0 / 65535.0;
            }
        }
        if (!(has[0] && has[1] && has[2])) {
            fail("its vertices have no x, y and z.");
        }
        const auto n = static_cast<Eigen::Index>(element.count);
        scan_.mesh.vertices.resize(3, n);
        if (has[3] && has[4] && has[5]) {
            scan_.colours.resize(3, n);
        }
        if (has[6] && has[7]) {
            scan_.uv.resize(2, n);
        }
        for (std::size_t i = 0; i < element.count; ++i) {
            const auto column = static_cast<Eigen::Index>(i);
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const Property& property = element.properties[p];
                if (property.is_list) {
                    const std::size_t count = list_size(element, i, property);
                    for (std::size_t k = 0; k < count; ++k) {
                        value(element, i, property.type);
                    }
                    continue;
                }
                const double number = value(element, i, property.type);
                const int slot = slots[p];
                if (slot < 0) {
                    continue;
                }
                if (!std::isfinite(number)) {
                    fail_at(element, i, "'" + property.name + "' is not a finite number.");
                }
                if (slot < 3) {
                    scan_.mesh.vertices(slot, column) = number;
                } else if (slot < 6 && scan_.colours.cols() > 0) {
                    scan_.colours(slot - 3, column) =
                        std::clamp(static_cast<float>(number * colour_scale), 0.0F, 1.0F);
                } else if (slot >= 6 && scan_.uv.cols() > 0) {
                    scan_.uv(slot - 6, column) = static_cast<float>(number);
                }
            }
            report(i);
        }
    }

    void faces(const Element& element) {
        std::vector<double> corner_uv;
        for (std::size_t i = 0; i < element.count; ++i) {
            corner_uv.clear();
            const std::size_t begin = scan_.faces.vertex.size();
            for (const Property& property : element.properties) {
                if (!property.is_list) {
                    value(element, i, property.type);
                    continue;
                }
                const std::size_t count = list_size(element, i, property);
                const bool indices =
                    property.name == "vertex_indices" || property.name == "vertex_index";
                for (std::size_t k = 0; k < count; ++k) {
                    const double number = value(element, i, property.type);
                    if (indices) {
                        if (!(number >= 0.0 && number < 2147483647.0)) {
                            fail_at(element, i, "vertex number out of range.");
                        }
                        scan_.faces.vertex.push_back(static_cast<int>(number));
                    } else if (property.name == "texcoord") {
                        corner_uv.push_back(number);
                    }
                }
            }
            const std::size_t corners = scan_.faces.vertex.size() - begin;
            if (corners < 3) {
                fail_at(element, i, "has fewer than three corners.");
            }
            scan_.faces.start.push_back(static_cast<int>(scan_.faces.vertex.size()));
            append_wedge_uv(element, i, corner_uv, corners);
            report(i);
        }
    }

    void append_wedge_uv(const Element& element, std::size_t i,
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
            if (!std::isfinite(corner_uv[2 * k]) || !std::isfinite(corner_uv[2 * k + 1])) {
                fail_at(element, i, "a texture coordinate is not a finite number.");
            }
            scan_.faces.uv.push_back(static_cast<int>(wedge_uv_.size() / 2));
            wedge_uv_.push_back(static_cast<float>(corner_uv[2 * k]));
            wedge_uv_.push_back(static_cast<float>(corner_uv[2 * k + 1]));
        }
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
            scan_.uv = Eigen::Map<const Eigen::Matrix2Xf>(
                wedge_uv_.data(), 2, static_cast<Eigen::Index>(wedge_uv_.size() / 2));
        } else if (scan_.uv.cols() > 0) {
            scan_.faces.uv = scan_.faces.vertex;  // one coordinate per vertex
        }
    }

    std::string_view bytes_;
    const std::string& name_;
    Scan& scan_;
    const Progress* progress_;
    std::size_t at_ = 0;
    bool swap_ = false;
    std::vector<Element> elements_;
    std::vector<float> wedge_uv_;
};

}  // namespace

void read_ply(std::string_view bytes, const std::string& name, Scan& scan,
              const Progress* progress) {
    PlyParser(bytes, name, scan, progress).parse();
}

}  // namespace myoface
