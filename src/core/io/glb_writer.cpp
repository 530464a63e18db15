// SPDX-License-Identifier: Apache-2.0
#include <map>

#include <nlohmann/json.hpp>

#include "writers.h"

namespace myoface {
namespace {

using nlohmann::json;

enum ComponentType { kUnsignedByte = 5121, kUnsignedInt = 5125, kFloat = 5126 };
enum Target { kVertices = 34962, kIndices = 34963 };

/// Vertices as glTF knows them: one texture coordinate each. The scan's own come first and in
/// order; a vertex on a texture seam is followed up by copies at the end.
struct SplitVertices {
    std::vector<int> vertex, uv;    ///< new vertex -> scan's vertex and texture coordinate
    std::vector<std::uint32_t> of;  ///< corner -> new vertex
};

SplitVertices split_at_seams(const Scan& scan) {
    SplitVertices split;
    const auto n = static_cast<std::size_t>(scan.mesh.vertex_count());
    for (std::size_t v = 0; v < n; ++v) {
        split.vertex.push_back(static_cast<int>(v));
    }
    split.uv.assign(n, -2);  // not chosen yet
    split.of.resize(scan.faces.vertex.size());
    std::map<std::pair<int, int>, std::uint32_t> copies;
    for (std::size_t c = 0; c < scan.faces.vertex.size(); ++c) {
        const int v = scan.faces.vertex[c];
        const int t = scan.faces.uv.empty() ? -1 : scan.faces.uv[c];
        int& own = split.uv[static_cast<std::size_t>(v)];
        if (own == -2) {
            own = t;
        }
        if (own == t) {
            split.of[c] = static_cast<std::uint32_t>(v);
            continue;
        }
        const auto [found, is_new] =
            copies.emplace(std::pair(v, t), static_cast<std::uint32_t>(split.vertex.size()));
        if (is_new) {
            split.vertex.push_back(v);
            split.uv.push_back(t);
        }
        split.of[c] = found->second;
    }
    return split;
}

class GlbBuilder {
public:
    GlbBuilder() : body_(false) {
        document_["asset"] = {{"version", "2.0"}, {"generator", kWrittenBy}};
        document_["scene"] = 0;
        document_["scenes"] = {{{"nodes", {0}}}};
        document_["nodes"] = {{{"mesh", 0}, {"name", "face"}}};
    }

    void positions(const SplitVertices& split, const Points& in_file) {
        const Eigen::Matrix3Xf points = in_file.cast<float>();
        const std::size_t at = begin();
        for (const int v : split.vertex) {
            for (int axis = 0; axis < 3; ++axis) {
                body_.add(points(axis, v));
            }
        }
        json entry = accessor(at, kFloat, split.vertex.size(), "VEC3", kVertices);
        const Eigen::Vector3f low = points.rowwise().minCoeff();
        const Eigen::Vector3f high = points.rowwise().maxCoeff();
        entry["min"] = {low.x(), low.y(), low.z()};
        entry["max"] = {high.x(), high.y(), high.z()};
        attributes_["POSITION"] = add(std::move(entry));
    }

    void colours(const SplitVertices& split, const Scan& scan) {
        const std::size_t at = begin();
        for (const int v : split.vertex) {
            for (int channel = 0; channel < 4; ++channel) {
                const float value = channel < 3              ? scan.colours(channel, v)
                                    : scan.alpha.size() == 0 ? 1.0F
                                                             : scan.alpha[v];
                if (scan.byte_colours) {
                    body_.add(byte_of(value));
                } else {
                    body_.add(value);
                }
            }
        }
        json entry = accessor(at, scan.byte_colours ? kUnsignedByte : kFloat, split.vertex.size(),
                              "VEC4", kVertices);
        if (scan.byte_colours) {
            entry["normalized"] = true;
        }
        attributes_["COLOR_0"] = add(std::move(entry));
    }

    void texture_coordinates(const SplitVertices& split, const Scan& scan) {
        const std::size_t at = begin();
        for (const int t : split.uv) {
            body_.add(t < 0 ? 0.0F : scan.uv(0, t));
            body_.add(t < 0 ? 0.0F : 1.0F - scan.uv(1, t));  // glTF counts from the top
        }
        attributes_["TEXCOORD_0"] = add(accessor(at, kFloat, split.uv.size(), "VEC2", kVertices));
    }

    /// One part of the faces; `material` below 0 for none.
    void triangles(const std::vector<std::uint32_t>& corners, int material) {
        const std::size_t at = begin();
        for (const std::uint32_t v : corners) {
            body_.add(v);
        }
        json primitive{
            {"attributes", attributes_},
            {"indices", add(accessor(at, kUnsignedInt, corners.size(), "SCALAR", kIndices))}};
        if (material >= 0) {
            primitive["material"] = material;
        }
        primitives_.push_back(std::move(primitive));
    }

    void materials(const Scan& scan) {
        std::vector<int> texture_number(scan.textures.size(), -1);
        for (std::size_t t = 0; t < scan.textures.size(); ++t) {
            const std::string& bytes = scan.textures[t].bytes;
            const bool png = bytes.substr(0, 4) == "\x89PNG";
            if (!png && bytes.substr(0, 2) != "\xFF\xD8") {
                continue;  // missing, or a picture that glTF does not know
            }
            const std::size_t at = begin();
            body_.text += bytes;
            const std::size_t view = views_.size();
            views_.push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes.size()}});
            texture_number[t] = static_cast<int>(document_["images"].size());
            document_["images"].push_back(
                {{"bufferView", view}, {"mimeType", png ? "image/png" : "image/jpeg"}});
            document_["textures"].push_back({{"source", texture_number[t]}});
        }
        for (const Material& material : scan.materials) {
            json look{{"metallicFactor", 0.0}, {"roughnessFactor", 0.8}};
            look["baseColorFactor"] = material.colour;
            if (material.texture >= 0 &&
                texture_number[static_cast<std::size_t>(material.texture)] >= 0) {
                look["baseColorTexture"] = {
                    {"index", texture_number[static_cast<std::size_t>(material.texture)]}};
            }
            document_["materials"].push_back(
                {{"name", material.name}, {"pbrMetallicRoughness", look}, {"doubleSided", true}});
        }
    }

    std::string take() {
        begin();
        document_["meshes"] = {{{"primitives", primitives_}}};
        document_["accessors"] = accessors_;
        document_["bufferViews"] = views_;
        document_["buffers"] = {{{"byteLength", body_.text.size()}}};
        std::string head = document_.dump(-1, ' ', false, json::error_handler_t::replace);
        head.resize((head.size() + 3) / 4 * 4, ' ');
        ByteWriter file(false);
        file.text = "glTF";
        file.add(std::uint32_t{2});
        file.add(static_cast<std::uint32_t>(28 + head.size() + body_.text.size()));
        file.add(static_cast<std::uint32_t>(head.size()));
        file.text += "JSON" + head;
        file.add(static_cast<std::uint32_t>(body_.text.size()));
        file.text.append("BIN\0", 4).append(body_.text);
        return std::move(file.text);
    }

private:
    /// Pads to four bytes, as every part must begin.
    std::size_t begin() {
        body_.text.resize((body_.text.size() + 3) / 4 * 4, '\0');
        return body_.text.size();
    }

    json accessor(std::size_t at, ComponentType component, std::size_t count, const char* type,
                  Target target) {
        views_.push_back({{"buffer", 0},
                          {"byteOffset", at},
                          {"byteLength", body_.text.size() - at},
                          {"target", target}});
        return {{"bufferView", views_.size() - 1},
                {"componentType", component},
                {"count", count},
                {"type", type}};
    }

    std::size_t add(json accessor) {
        accessors_.push_back(std::move(accessor));
        return accessors_.size() - 1;
    }

    json document_;
    json attributes_ = json::object();
    json accessors_ = json::array();
    json views_ = json::array();
    json primitives_ = json::array();
    ByteWriter body_;
};

}  // namespace

std::string glb_bytes(const Scan& scan, const Points& in_file) {
    const SplitVertices split = split_at_seams(scan);
    GlbBuilder builder;
    builder.positions(split, in_file);
    if (scan.colours.cols() > 0) {
        builder.colours(split, scan);
    }
    if (!scan.faces.uv.empty()) {
        builder.texture_coordinates(split, scan);
    }
    std::map<int, std::vector<std::uint32_t>> corners;  // material -> corners of its triangles
    for (int t = 0; t < scan.mesh.triangle_count(); ++t) {
        const int face = face_of(scan, t);
        std::vector<std::uint32_t>& list =
            corners[scan.face_material.empty()
                        ? -1
                        : scan.face_material[static_cast<std::size_t>(face)]];
        for (const int c : in_file_order(corners_of(scan, t))) {
            list.push_back(split.of[static_cast<std::size_t>(c)]);
        }
    }
    for (const auto& [material, list] : corners) {
        builder.triangles(list, material);
    }
    builder.materials(scan);
    return builder.take();
}

}  // namespace myoface
