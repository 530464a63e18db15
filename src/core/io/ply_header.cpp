// SPDX-License-Identifier: Apache-2.0
#include "ply_header.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "myoface/base/error.h"

namespace myoface {
namespace {

std::string_view word_of(std::string_view& line) {
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) {
        line.remove_prefix(1);
    }
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
}

std::string shown(std::string_view word) {
    return "'" + std::string(word.substr(0, 40)) + "'";
}

class HeaderParser {
public:
    HeaderParser(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    PlyHeader parse() {
        next_line();  // "ply", seen by the caller
        bool has_format = false;
        for (;;) {
            std::string_view line = next_line();
            const std::string_view key = word_of(line);
            if (key == "end_header") {
                break;
            }
            if (key == "format") {
                format(word_of(line));
                has_format = true;
            } else if (key == "comment") {
                comment(line);
            } else if (key == "element") {
                element(line);
            } else if (key == "property") {
                property(line);
            }
        }
        if (!has_format) {
            fail("the PLY header names no format.");
        }
        header_.size = at_;
        for (const PlyElement& element : header_.elements) {
            check_count(element);
        }
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw IoError(name_ + ": " + what); }

    std::string_view next_line() {
        // Some writers end header lines with a lone carriage return.
        const std::size_t end = bytes_.find_first_of("\r\n", at_);
        if (end == std::string_view::npos) {
            fail("the PLY header has no end (is the file truncated?).");
        }
        const std::string_view line = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        if (bytes_[end] == '\r' && at_ < bytes_.size() && bytes_[at_] == '\n') {
            ++at_;
        }
        return line;
    }

    PlyType type_named(std::string_view name) const {
        static const std::map<std::string_view, PlyType> kTypes{
            {"char", PlyType::Int8},      {"int8", PlyType::Int8},
            {"uchar", PlyType::Uint8},    {"uint8", PlyType::Uint8},
            {"short", PlyType::Int16},    {"int16", PlyType::Int16},
            {"ushort", PlyType::Uint16},  {"uint16", PlyType::Uint16},
            {"int", PlyType::Int32},      {"int32", PlyType::Int32},
            {"uint", PlyType::Uint32},    {"uint32", PlyType::Uint32},
            {"float", PlyType::Float32},  {"float32", PlyType::Float32},
            {"double", PlyType::Float64}, {"float64", PlyType::Float64}};
        const auto found = kTypes.find(name);
        if (found == kTypes.end()) {
            fail("the PLY header names the unknown type " + shown(name) + ".");
        }
        return found->second;
    }

    void format(std::string_view kind) {
        if (kind == "ascii") {
            header_.format = FileFormat::PlyAscii;
        } else if (kind == "binary_little_endian") {
            header_.format = FileFormat::PlyBinaryLittle;
        } else if (kind == "binary_big_endian") {
            header_.format = FileFormat::PlyBinaryBig;
        } else {
            fail("the PLY header names the unknown format " + shown(kind) + ".");
        }
    }

    void comment(std::string_view line) {
        if (word_of(line) == "TextureFile") {
            const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
            header_.textures.emplace_back(line.substr(begin));
        }
    }

    void element(std::string_view line) {
        PlyElement element;
        element.name = word_of(line);
        const std::string_view count = word_of(line);
        const char* const end = count.data() + count.size();
        const auto parsed = std::from_chars(count.data(), end, element.count);
        if (count.empty() || parsed.ec != std::errc() || parsed.ptr != end) {
            fail("the PLY header gives no usable count for element " + shown(element.name) + ".");
        }
        for (const PlyElement& other : header_.elements) {
            if (other.name == element.name) {
                fail("the PLY header has the element " + shown(element.name) + " twice.");
            }
        }
        header_.elements.push_back(std::move(element));
    }

    void property(std::string_view line) {
        if (header_.elements.empty()) {
            fail("the PLY header has a property before any element.");
        }
        PlyProperty property;
        std::string_view type = word_of(line);
        if (type == "list") {
            property.is_list = true;
            property.count_type = type_named(word_of(line));
            if (property.count_type >= PlyType::Float32) {
                fail("the PLY header counts a list with " +
                     std::string("a number that is not whole."));
            }
            type = word_of(line);
        }
        property.type = type_named(type);
        property.name = word_of(line);
        for (const PlyProperty& other : header_.elements.back().properties) {
            if (other.name == property.name) {
                fail("the PLY header has the property " + shown(property.name) + " twice.");
            }
        }
        header_.elements.back().properties.push_back(std::move(property));
    }

    /// A count larger than the rest of the file could hold is a lie: refuse it before any memory
    /// is asked for.
    void check_count(const PlyElement& element) const {
        std::size_t least = 0;
        for (const PlyProperty& property : element.properties) {
            least += header_.format == FileFormat::PlyAscii
                         ? 2
                         : size_of(property.is_list ? property.count_type : property.type);
        }
        const std::size_t left = bytes_.size() - at_ + 1;
        if (least == 0 ? element.count > 0 : element.count > left / least) {
            fail("is truncated: the header promises " + std::to_string(element.count) + " '" +
                 element.name + "' elements, the file is too short for them.");
        }
        if (element.count > 500'000'000) {
            fail("has more '" + element.name + "' elements than this program can hold.");
        }
    }

    std::string_view bytes_;
    const std::string& name_;
    std::size_t at_ = 0;
    PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::Int8:
        case PlyType::Uint8:
            return 1;
        case PlyType::Int16:
        case PlyType::Uint16:
            return 2;
        case PlyType::Float64:
            return 8;
        default:
            return 4;
    }
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) {
    return HeaderParser(bytes, name).parse();
}

}  // namespace myoface
