// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "myoface/io/text_file.h"

#include "readers.h"

namespace myoface {
namespace {

/// Appends numbers in a fixed byte order.
class Bytes {
public:
    explicit Bytes(bool big) : swap_((std::endian::native == std::endian::big) != big) {}

    template <typename T>
    void add(T value) {
        auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
        if (swap_) {
            std::reverse(raw.begin(), raw.end());
        }
        text.append(raw.data(), raw.size());
    }

    std::string text;

private:
    bool swap_;
};

std::uint8_t byte_of(float colour) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(colour, 0.0F, 1.0F) * 255.0F));
}

}  // namespace

std::string obj_text(const Scan& scan, const Points& in_file) {
    std::string text = "# Written by Myoface. A planning aid, not a medical device.\n";
    for (const std::string& library : scan.material_libraries) {
        text += "mtllib " + library + "\n";
    }
    for (Eigen::Index v = 0; v < in_file.cols(); ++v) {
        text += "v";
        for (int axis = 0; axis < 3; ++axis) {
            text += ' ';
            append_number(text, in_file(axis, v));
        }
        for (int channel = 0; channel < 3 && scan.colours.cols() > 0; ++channel) {
            text += ' ';
            append_number(text, std::round(scan.colours(channel, v) * 1e6) / 1e6);
        }
        text += '\n';
    }
    for (Eigen::Index t = 0; t < scan.uv.cols(); ++t) {
        text += "vt ";
        append_number(text, static_cast<double>(scan.uv(0, t)));
        text += ' ';
        append_number(text, static_cast<double>(scan.uv(1, t)));
        text += '\n';
    }
    auto statement = scan.statements.begin();
    for (int f = 0; f < scan.faces.count(); ++f) {
        for (; statement != scan.statements.end() && statement->before_face <= f; ++statement) {
            text += statement->text + "\n";
        }
        text += 'f';
        for (int c = scan.faces.start[f]; c < scan.faces.start[f + 1]; ++c) {
            text += ' ' + std::to_string(scan.faces.vertex[c] + 1);
            if (!scan.faces.uv.empty() && scan.faces.uv[c] >= 0) {
                text += '/' + std::to_string(scan.faces.uv[c] + 1);
            }
        }
        text += '\n';
    }
    return text;
}

std::string ply_bytes(const Scan& scan, const Points& in_file) {
    const bool ascii = scan.format == FileFormat::PlyAscii;
    const bool big = scan.format == FileFormat::PlyBinaryBig;
    const bool colours = scan.colours.cols() > 0;
    const bool uv = !scan.faces.uv.empty();
    std::string head = "ply\nformat ";
    head += ascii ? "ascii" : big ? "binary_big_endian" : "binary_little_endian";
    head += " 1.0\ncomment Written by Myoface. A planning aid, not a medical device.\n";
    if (!scan.texture.empty()) {
        head += "comment TextureFile " + scan.texture + "\n";
    }
    head += "element vertex " + std::to_string(in_file.cols()) +
            "\nproperty double x\nproperty double y\nproperty double z\n";
    if (colours) {
        head += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    }
    head += "element face " + std::to_string(scan.faces.count()) +
            "\nproperty list int int vertex_indices\n";
    if (uv) {
        head += "property list int float texcoord\n";
    }
    head += "end_header\n";

    Bytes bytes(big);
    bytes.text = head;
    for (Eigen::Index v = 0; v < in_file.cols(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            if (ascii) {
                append_number(bytes.text, in_file(axis, v));
                bytes.text += ' ';
            } else {
                bytes.add(in_file(axis, v));
            }
        }
        for (int channel = 0; channel < 3 && colours; ++channel) {
            const std::uint8_t value = byte_of(scan.colours(channel, v));
            if (ascii) {
                bytes.text += std::to_string(value) + ' ';
            } else {
                bytes.add(value);
            }
        }
        if (ascii) {
            bytes.text.back() = '\n';
        }
    }
    for (int f = 0; f < scan.faces.count(); ++f) {
        const int corners = scan.faces.size(f);
        const auto count = [&](int n) {
            ascii ? void(bytes.text += std::to_string(n) + ' ') : bytes.add(n);
        };
        const auto real = [&](float x) {
            if (ascii) {
                append_number(bytes.text, static_cast<double>(x));
                bytes.text += ' ';
            } else {
                bytes.add(x);
            }
        };
        count(corners);
        for (int c = scan.faces.start[f]; c < scan.faces.start[f + 1]; ++c) {
            count(scan.faces.vertex[c]);
        }
        if (uv) {
            count(2 * corners);
            for (int c = scan.faces.start[f]; c < scan.faces.start[f + 1]; ++c) {
                const int t = scan.faces.uv[c];
                real(t < 0 ? 0.0F : scan.uv(0, t));
                real(t < 0 ? 0.0F : scan.uv(1, t));
            }
        }
        if (ascii) {
            bytes.text.back() = '\n';
        }
    }
    return std::move(bytes.text);
}

}  // namespace myoface
