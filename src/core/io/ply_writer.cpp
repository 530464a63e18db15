// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>

#include "myoface/io/text_file.h"

#include "writers.h"

namespace myoface {
namespace {

/// Values one after another, as text or bytes.
class Values {
public:
    Values(std::string head, bool ascii, bool big) : ascii_(ascii), bytes_(big) {
        bytes_.text = std::move(head);
    }

    template <typename T>
    void add(T value) {
        if (!ascii_) {
            bytes_.add(value);
            return;
        }
        std::array<char, 32> buffer{};
        const auto end = [&] {
            if constexpr (sizeof(T) == 1) {
                return std::to_chars(buffer.data(), buffer.data() + buffer.size(), int{value});
            } else {
                return std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
            }
        }();
        bytes_.text.append(buffer.data(), end.ptr).push_back(' ');
    }
    void end_line() {
        if (ascii_) {
            bytes_.text.back() = '\n';
        }
    }
    std::string take() { return std::move(bytes_.text); }

private:
    bool ascii_;
    ByteWriter bytes_;
};

}  // namespace

std::string ply_bytes(const Scan& scan, const Points& in_file) {
    const bool ascii = scan.format == FileFormat::PlyAscii;
    const bool big = scan.format == FileFormat::PlyBinaryBig;
    const bool colours = scan.colours.cols() > 0;
    const bool alpha = colours && scan.alpha.size() > 0;
    // Colours of an OBJ file are bytes in what other programs expect of a PLY file.
    const bool bytes = scan.byte_colours || scan.format == FileFormat::Obj;
    const bool uv = !scan.faces.uv.empty();
    const bool uv_per_vertex =
        uv && scan.uv.cols() == in_file.cols() && scan.faces.uv == scan.faces.vertex;
    const bool several_textures = scan.textures.size() > 1 && !scan.face_material.empty();
    std::string head = "ply\nformat ";
    head += ascii ? "ascii" : big ? "binary_big_endian" : "binary_little_endian";
    head += std::string(" 1.0\ncomment ") + kWrittenBy + "\n";
    for (const Texture& texture : scan.textures) {
        head += "comment TextureFile " + texture.name + "\n";
    }
    const std::string real = scan.float_coordinates ? "float" : "double";
    head += "element vertex " + std::to_string(in_file.cols()) + "\n";
    for (const char* axis : {"x", "y", "z"}) {
        head += "property " + real + " " + axis + "\n";
    }
    for (const char* channel : {"red", "green", "blue", "alpha"}) {
        if (colours && (alpha || std::string_view(channel) != "alpha")) {
            head += std::string("property ") + (bytes ? "uchar " : "float ") + channel + "\n";
        }
    }
    if (uv_per_vertex) {
        head += "property float s\nproperty float t\n";
    }
    head += "element face " + std::to_string(scan.faces.count()) + "\n";
    int largest = 3;
    for (int f = 0; f < scan.faces.count(); ++f) {
        largest = std::max(largest, scan.faces.size(f));
    }
    const bool short_lists = largest <= 127;
    head +=
        std::string("property list ") + (short_lists ? "uchar" : "int") + " int vertex_indices\n";
    if (uv && !uv_per_vertex) {
        head +=
            std::string("property list ") + (short_lists ? "uchar" : "int") + " float texcoord\n";
    }
    if (several_textures) {
        head += "property int texnumber\n";
    }
    head += "end_header\n";

    Values values(std::move(head), ascii, big);
    for (Eigen::Index v = 0; v < in_file.cols(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            if (scan.float_coordinates) {
                values.add(static_cast<float>(in_file(axis, v)));
            } else {
                values.add(in_file(axis, v));
            }
        }
        for (int channel = 0; channel < (alpha ? 4 : 3) && colours; ++channel) {
            const float value = channel < 3 ? scan.colours(channel, v) : scan.alpha[v];
            if (bytes) {
                values.add(byte_of(value));
            } else {
                values.add(value);
            }
        }
        if (uv_per_vertex) {
            values.add(scan.uv(0, v));
            values.add(scan.uv(1, v));
        }
        values.end_line();
    }
    const auto count = [&](int n) {
        if (short_lists) {
            values.add(static_cast<std::uint8_t>(n));
        } else {
            values.add(n);
        }
    };
    for (int f = 0; f < scan.faces.count(); ++f) {
        count(scan.faces.size(f));
        for (int c = scan.faces.start[f]; c < scan.faces.start[f + 1]; ++c) {
            values.add(scan.faces.vertex[c]);
        }
        if (uv && !uv_per_vertex) {
            count(2 * scan.faces.size(f));
            for (int c = scan.faces.start[f]; c < scan.faces.start[f + 1]; ++c) {
                const int t = scan.faces.uv[c];
                values.add(t < 0 ? 0.0F : scan.uv(0, t));
                values.add(t < 0 ? 0.0F : scan.uv(1, t));
            }
        }
        if (several_textures) {
            const int m = scan.face_material[static_cast<std::size_t>(f)];
            values.add(m < 0 ? -1 : scan.materials[static_cast<std::size_t>(m)].texture);
        }
        values.end_line();
    }
    return values.take();
}

}  // namespace myoface
