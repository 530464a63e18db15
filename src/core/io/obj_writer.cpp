// SPDX-License-Identifier: Apache-2.0
#include <charconv>

#include "myoface/io/text_file.h"

#include "writers.h"

namespace myoface {
namespace {

/// A float as the shortest text that reads back to it.
void append_float(std::string& text, float value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(buffer.data(), end.ptr);
}

void append_whole(std::string& text, int value) {
    std::array<char, 16> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(buffer.data(), end.ptr);
}

void append_colour(std::string& text, float value, bool as_byte) {
    text += ' ';
    if (as_byte) {
        append_whole(text, byte_of(value));
    } else {
        append_float(text, value);
    }
}

/// Material changes of a scan that did not come from an OBJ file.
class MaterialChanges {
public:
    explicit MaterialChanges(const Scan& scan)
        : scan_(scan), needed_(scan.statements.empty() && !scan.face_material.empty()) {}

    void before(int face, std::string& text) {
        const int now = needed_ ? scan_.face_material[static_cast<std::size_t>(face)] : -1;
        if (now != current_ && now >= 0) {
            text += "usemtl " + scan_.materials[static_cast<std::size_t>(now)].name + "\n";
        }
        current_ = now;
    }

private:
    const Scan& scan_;
    bool needed_;
    int current_ = -1;
};

}  // namespace

std::string obj_text(const Scan& scan, const Points& in_file, const std::string& library) {
    std::string text = std::string("# ") + kWrittenBy + "\n";
    if (!library.empty()) {
        text += "mtllib " + library + "\n";
    } else {
        for (const std::string& name : scan.material_libraries) {
            text += "mtllib " + name + "\n";
        }
    }
    for (Eigen::Index v = 0; v < in_file.cols(); ++v) {
        text += "v";
        for (int axis = 0; axis < 3; ++axis) {
            text += ' ';
            if (scan.float_coordinates) {
                append_float(text, static_cast<float>(in_file(axis, v)));
            } else {
                append_number(text, in_file(axis, v));
            }
        }
        for (int channel = 0; channel < 3 && scan.colours.cols() > 0; ++channel) {
            append_colour(text, scan.colours(channel, v), scan.byte_colours);
        }
        if (scan.alpha.size() > 0) {
            append_colour(text, scan.alpha[v], scan.byte_colours);
        }
        text += '\n';
    }
    for (Eigen::Index t = 0; t < scan.uv.cols(); ++t) {
        text += "vt ";
        append_float(text, scan.uv(0, t));
        text += ' ';
        append_float(text, scan.uv(1, t));
        text += '\n';
    }
    MaterialChanges materials(scan);
    auto statement = scan.statements.begin();
    for (int f = 0; f < scan.faces.count(); ++f) {
        for (; statement != scan.statements.end() && statement->before_face <= f; ++statement) {
            text += statement->text + "\n";
        }
        materials.before(f, text);
        text += 'f';
        for (int c = scan.faces.start[f]; c < scan.faces.start[f + 1]; ++c) {
            text += ' ';
            append_whole(text, scan.faces.vertex[c] + 1);
            if (!scan.faces.uv.empty() && scan.faces.uv[c] >= 0) {
                text += '/';
                append_whole(text, scan.faces.uv[c] + 1);
            }
        }
        text += '\n';
    }
    for (; statement != scan.statements.end(); ++statement) {
        text += statement->text + "\n";
    }
    return text;
}

std::string mtl_text(const Scan& scan, const std::vector<std::string>& textures) {
    std::string text = std::string("# ") + kWrittenBy + "\n";
    for (const Material& material : scan.materials) {
        text += "\nnewmtl " + material.name + "\nKd";
        for (std::size_t c = 0; c < 3; ++c) {
            text += ' ';
            append_float(text, material.colour[c]);
        }
        text += "\nd ";
        append_float(text, material.colour[3]);
        text += "\n";
        if (material.texture >= 0) {
            text += "map_Kd " + textures[static_cast<std::size_t>(material.texture)] + "\n";
        }
    }
    return text;
}

}  // namespace myoface
