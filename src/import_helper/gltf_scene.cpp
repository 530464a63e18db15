// SPDX-License-Identifier: Apache-2.0
#include "gltf_scene.h"

#include <algorithm>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/importerdesc.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <cctype>
#include <cmath>
#include <cstring>
#include <map>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Lets assimp open files for reading inside one folder only.
class FolderOnly final : public Assimp::DefaultIOSystem {
public:
    explicit FolderOnly(const fs::path& file) {
        std::error_code error;
        folder_ = fs::canonical(file, error).parent_path();
    }

    bool Exists(const char* file) const override {
        return allowed(file) && Assimp::DefaultIOSystem::Exists(file);
    }
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        const bool reading = std::strchr(mode, 'w') == nullptr && std::strchr(mode, 'a') == nullptr;
        return reading && allowed(file) ? Assimp::DefaultIOSystem::Open(file, mode) : nullptr;
    }

private:
    bool allowed(const char* file) const {
        std::error_code error;
        const fs::path real = fs::canonical(file, error);
        return !error &&
               std::mismatch(folder_.begin(), folder_.end(), real.begin(), real.end()).first ==
                   folder_.end();
    }

    fs::path folder_;
};

/// The JSON part of either form of the file. @throws IoError
json header_of(const std::string& bytes) {
    std::string_view text = bytes;
    if (text.substr(0, 4) == "glTF") {
        const auto number = [&](std::size_t at) {
            std::uint32_t value = 0;
            for (std::size_t k = 4; k-- > 0;) {
                value = value << 8 | static_cast<unsigned char>(text[at + k]);
            }
            return value;
        };
        if (text.size() < 20 || number(4) != 2) {
            throw IoError("is not a GLB file of version 2.");
        }
        if (number(8) > text.size() || number(12) > text.size() - 20) {
            throw IoError("is truncated: it promises " + std::to_string(number(8)) +
                          " bytes and has " + std::to_string(text.size()) + ".");
        }
        text = text.substr(20, number(12));
    }
    json document = json::parse(text, nullptr, false);
    if (!document.is_object()) {
        throw IoError("is not glTF: its JSON part cannot be read.");
    }
    return document;
}

/// Refuses what assimp would misread or not read.
void check(const json& document) {
    const auto version = document.find("asset");
    if (version == document.end() || !version->is_object() ||
        !version->value("version", json()).is_string() ||
        version->value("version", std::string()).rfind("2.", 0) != 0) {
        throw IoError("is not glTF of version 2; export it as glTF 2.0.");
    }
    const auto required = document.find("extensionsRequired");
    if (required == document.end() || !required->is_array()) {
        return;
    }
    for (const json& entry : *required) {
        const std::string name = entry.is_string() ? entry.get<std::string>() : "?";
        if (name == "KHR_draco_mesh_compression") {
            throw IoError("is compressed with Draco; export it without compression.");
        }
        if (name.rfind("KHR_materials_", 0) != 0 && name != "KHR_texture_transform") {
            throw IoError("needs the glTF extension " + name.substr(0, 60) +
                          ", which is not supported; export it without.");
        }
    }
}

class Collector {
public:
    Collector(const aiScene& scene, const json& document) : scene_(scene) {
        // Which vertices each of assimp's meshes came from: primitives that share their vertices in
        // the file share them here.
        const auto meshes = document.find("meshes");
        if (meshes == document.end() || !meshes->is_array()) {
            return;
        }
        for (const json& mesh : *meshes) {
            const auto primitives = mesh.find("primitives");
            for (const json& primitive : primitives == mesh.end() ? json::array() : *primitives) {
                vertices_of_.push_back(primitive.is_object()
                                           ? primitive.value("attributes", json()).dump()
                                           : std::string());
            }
        }
        if (vertices_of_.size() != scene.mNumMeshes) {
            vertices_of_.clear();
        }
    }

    Scan collect() {
        materials();
        visit(*scene_.mRootNode, aiMatrix4x4(), 0);
        if (scan_.faces.count() == 0) {
            throw IoError("holds no triangles.");
        }
        const auto n = static_cast<Eigen::Index>(positions_.size() / 3);
        scan_.mesh.vertices = Eigen::Map<const Points>(positions_.data(), 3, n);
        if (any_colour_) {
            colours_.resize(static_cast<std::size_t>(4 * n), 1.0F);
            const Eigen::Map<const Eigen::Matrix4Xf> all(colours_.data(), 4, n);
            scan_.colours = all.topRows<3>();
            if ((all.row(3).array() != 1.0F).any()) {
                scan_.alpha = all.row(3).transpose();
            }
            scan_.byte_colours = std::all_of(colours_.begin(), colours_.end(), [](float c) {
                return std::round(c * 255.0F) / 255.0F == c;
            });
        }
        if (any_uv_) {
            uv_.resize(static_cast<std::size_t>(2 * n), 0.0F);
            scan_.uv = Eigen::Map<const Eigen::Matrix2Xf>(uv_.data(), 2, n);
            scan_.faces.uv = scan_.faces.vertex;
        }
        keep_used_materials();
        return std::move(scan_);
    }

private:
    /// assimp makes up a plain material where the file has none.
    void keep_used_materials() {
        std::vector<int> number(scan_.materials.size(), -1);
        std::vector<Material> used;
        for (int& m : scan_.face_material) {
            if (m < 0) {
                continue;
            }
            if (number[static_cast<std::size_t>(m)] < 0) {
                number[static_cast<std::size_t>(m)] = static_cast<int>(used.size());
                used.push_back(scan_.materials[static_cast<std::size_t>(m)]);
            }
            m = number[static_cast<std::size_t>(m)];
        }
        const bool plain = used.size() == 1 && used[0].texture < 0 &&
                           used[0].colour == Material().colour &&
                           (used[0].name.empty() || used[0].name == AI_DEFAULT_MATERIAL_NAME);
        scan_.materials = plain ? std::vector<Material>() : std::move(used);
        if (scan_.materials.empty()) {
            scan_.face_material.clear();
        }
    }

    void materials() {
        for (unsigned m = 0; m < scene_.mNumMaterials; ++m) {
            const aiMaterial& from = *scene_.mMaterials[m];
            Material material;
            material.name = from.GetName().C_Str();
            aiColor4D colour;
            if (from.Get(AI_MATKEY_BASE_COLOR, colour) == AI_SUCCESS ||
                from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS) {
                material.colour = {colour.r, colour.g, colour.b, colour.a};
            }
            aiString path;
            if (from.GetTexture(aiTextureType_BASE_COLOR, 0, &path) == AI_SUCCESS ||
                from.GetTexture(aiTextureType_DIFFUSE, 0, &path) == AI_SUCCESS) {
                material.texture = texture(path.C_Str());
            }
            scan_.materials.push_back(std::move(material));
        }
    }

    int texture(const std::string& path) {
        Texture texture{path, {}};
        if (const aiTexture* inside = scene_.GetEmbeddedTexture(path.c_str())) {
            if (inside->mHeight == 0) {
                texture.bytes.assign(reinterpret_cast<const char*>(inside->pcData), inside->mWidth);
            }
            const bool png = texture.bytes.substr(0, 4) == "\x89PNG";
            std::string number = path.front() == '*' ? path.substr(1) : std::string("0");
            texture.name = "texture" + number + (png ? ".png" : ".jpg");
        } else {
            texture.name = decoded(path);
        }
        for (std::size_t t = 0; t < scan_.textures.size(); ++t) {
            if (scan_.textures[t].name == texture.name) {
                return static_cast<int>(t);
            }
        }
        scan_.textures.push_back(std::move(texture));
        return static_cast<int>(scan_.textures.size()) - 1;
    }

    /// "%20" and its like in an address.
    static std::string decoded(const std::string& path) {
        std::string result;
        for (std::size_t i = 0; i < path.size(); ++i) {
            const bool code = path[i] == '%' && i + 2 < path.size() &&
                              std::isxdigit(static_cast<unsigned char>(path[i + 1])) != 0 &&
                              std::isxdigit(static_cast<unsigned char>(path[i + 2])) != 0;
            result +=
                code ? static_cast<char>(std::stoi(path.substr(i + 1, 2), nullptr, 16)) : path[i];
            i += code ? 2 : 0;
        }
        return result;
    }

    void visit(const aiNode& node, const aiMatrix4x4& parent, int depth) {
        if (depth > 200) {
            throw IoError("nests its nodes deeper than 200 levels.");
        }
        const aiMatrix4x4 here = parent * node.mTransformation;
        std::map<std::string, std::size_t> placed;  // vertices of this node -> first one
        for (unsigned m = 0; m < node.mNumMeshes; ++m) {
            const unsigned number = node.mMeshes[m];
            const aiMesh& mesh = *scene_.mMeshes[number];
            std::size_t base = positions_.size() / 3;
            if (number < vertices_of_.size()) {
                const auto [found, is_new] =
                    placed.emplace(vertices_of_[number] + std::to_string(mesh.mNumVertices), base);
                base = found->second;
            }
            if (base == positions_.size() / 3) {
                add_vertices(mesh, here);
            }
            add_faces(mesh, base);
        }
        for (unsigned c = 0; c < node.mNumChildren; ++c) {
            visit(*node.mChildren[c], here, depth + 1);
        }
    }

    void add_vertices(const aiMesh& mesh, const aiMatrix4x4& place) {
        const std::size_t base = positions_.size() / 3;
        if (base + mesh.mNumVertices > 200'000'000) {
            throw IoError("has more vertices than this program can hold.");
        }
        const bool still = place.IsIdentity();
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D& p = mesh.mVertices[v];
            // In double precision; a mesh that is not moved keeps its numbers to the last bit.
            const auto row = [&](float a, float b, float c, float d) {
                return static_cast<double>(a) * static_cast<double>(p.x) +
                       static_cast<double>(b) * static_cast<double>(p.y) +
                       static_cast<double>(c) * static_cast<double>(p.z) + static_cast<double>(d);
            };
            positions_.push_back(still ? static_cast<double>(p.x)
                                       : row(place.a1, place.a2, place.a3, place.a4));
            positions_.push_back(still ? static_cast<double>(p.y)
                                       : row(place.b1, place.b2, place.b3, place.b4));
            positions_.push_back(still ? static_cast<double>(p.z)
                                       : row(place.c1, place.c2, place.c3, place.c4));
        }
        if (mesh.HasVertexColors(0)) {
            any_colour_ = true;
            colours_.resize(4 * base, 1.0F);
            for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
                const aiColor4D& c = mesh.mColors[0][v];
                colours_.insert(colours_.end(), {c.r, c.g, c.b, c.a});
            }
        }
        if (mesh.HasTextureCoords(0)) {
            any_uv_ = true;
            uv_.resize(2 * base, 0.0F);
            for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
                uv_.push_back(mesh.mTextureCoords[0][v].x);
                uv_.push_back(mesh.mTextureCoords[0][v].y);
            }
        }
    }

    void add_faces(const aiMesh& mesh, std::size_t base) {
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) {
                continue;  // points and lines
            }
            for (unsigned c = 0; c < 3; ++c) {
                if (face.mIndices[c] >= mesh.mNumVertices) {
                    throw IoError("triangle " + std::to_string(f) + " names vertex " +
                                  std::to_string(face.mIndices[c]) + " of " +
                                  std::to_string(mesh.mNumVertices) + ".");
                }
                scan_.faces.vertex.push_back(static_cast<int>(base + face.mIndices[c]));
            }
            scan_.faces.start.push_back(static_cast<int>(scan_.faces.vertex.size()));
            scan_.face_material.push_back(mesh.mMaterialIndex < scene_.mNumMaterials
                                              ? static_cast<int>(mesh.mMaterialIndex)
                                              : -1);
        }
    }

    const aiScene& scene_;
    std::vector<std::string> vertices_of_;
    Scan scan_;
    std::vector<double> positions_;
    std::vector<float> colours_, uv_;
    bool any_colour_ = false;
    bool any_uv_ = false;
};

}  // namespace

Scan read_gltf_scene(const fs::path& file) {
    bool binary = false;
    json document;
    {
        const std::string bytes = read_file(file);
        binary = bytes.substr(0, 4) == "glTF";
        document = header_of(bytes);
        check(document);
    }
    Assimp::Importer importer;
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        if (std::string_view(importer.GetImporterInfo(i)->mName).substr(0, 5) != "glTF2") {
            importer.UnregisterLoader(importer.GetImporter(i));
        }
    }
    importer.SetIOHandler(new FolderOnly(file));  // the importer owns it
    const aiScene* scene = importer.ReadFile(fs::absolute(file).string(), 0);
    if (scene == nullptr || scene->mRootNode == nullptr) {
        std::string why = importer.GetErrorString();
        std::replace(why.begin(), why.end(), '\n', ' ');
        throw IoError("cannot be read: " + why.substr(0, 200) + ".");
    }
    Scan scan = Collector(*scene, document).collect();
    scan.format = binary ? FileFormat::Glb : FileFormat::Gltf;
    return scan;
}

}  // namespace myoface
