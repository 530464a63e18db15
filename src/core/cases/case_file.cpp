// SPDX-License-Identifier: Apache-2.0
#include "myoface/cases/case_file.h"

#include <algorithm>
#include <zip.h>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kSchema = 2;
constexpr zip_uint64_t kLargestPart = 2'000'000'000;

struct Archive {
    zip_t* handle = nullptr;
    ~Archive() {
        if (handle != nullptr) {
            zip_discard(handle);
        }
    }
};

std::string read_part(zip_t* archive, const char* part, const std::string& name, bool needed) {
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat(archive, part, 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0) {
        if (needed) {
            throw IoError(name + ": is not a Myoface case (" + part + " is missing).");
        }
        return {};
    }
    // A small archive must not unpack to more than a scan can be.
    if (stat.size > kLargestPart || stat.size > 2000 * (stat.comp_size + 1000)) {
        throw IoError(name + ": " + part + " is larger than a case can hold.");
    }
    std::string bytes(stat.size, '\0');
    zip_file_t* file = zip_fopen(archive, part, 0);
    const bool good = file != nullptr && zip_fread(file, bytes.data(), stat.size) ==
                                             static_cast<zip_int64_t>(stat.size);
    if (file != nullptr) {
        zip_fclose(file);
    }
    if (!good) {
        throw IoError(name + ": " + part + " cannot be unpacked, the case is damaged.");
    }
    return bytes;
}

/// A zip that is made in memory, so that the file on disk appears whole or not at all. What is
/// added must outlive bytes().
class MemoryArchive {
public:
    explicit MemoryArchive(std::string name) : name_(std::move(name)) {
        zip_error_init(&error_);
        source_ = zip_source_buffer_create(nullptr, 0, 0, &error_);
        archive_.handle =
            source_ != nullptr ? zip_open_from_source(source_, ZIP_TRUNCATE, &error_) : nullptr;
        if (archive_.handle == nullptr) {
            fail();
        }
        zip_source_keep(source_);
    }
    ~MemoryArchive() {
        zip_source_free(source_);
        zip_error_fini(&error_);
    }
    MemoryArchive(const MemoryArchive&) = delete;
    MemoryArchive& operator=(const MemoryArchive&) = delete;

    void add(const std::string& part, const std::string& bytes) {
        constexpr std::size_t kLarge = 1 << 20;
        zip_source_t* source = zip_source_buffer(archive_.handle, bytes.data(), bytes.size(), 0);
        const zip_int64_t index = source == nullptr ? -1
                                                    : zip_file_add(archive_.handle, part.c_str(),
                                                                   source, ZIP_FL_OVERWRITE);
        if (index < 0) {
            fail();
        }
        // Time counts more than the last tenth of size.
        zip_set_file_compression(archive_.handle, static_cast<zip_uint64_t>(index), ZIP_CM_DEFLATE,
                                 bytes.size() > kLarge ? 1 : 6);
    }
    std::string bytes() {
        if (zip_close(archive_.handle) != 0) {
            fail();
        }
        archive_.handle = nullptr;
        zip_stat_t stat;
        zip_stat_init(&stat);
        if (zip_source_stat(source_, &stat) != 0 || zip_source_open(source_) != 0) {
            fail();
        }
        std::string result(stat.size, '\0');
        const bool whole = zip_source_read(source_, result.data(), stat.size) ==
                           static_cast<zip_int64_t>(stat.size);
        zip_source_close(source_);
        if (!whole) {
            fail();
        }
        return result;
    }

private:
    [[noreturn]] void fail() const {
        throw IoError(name_ + ": the case cannot be packed, memory may be short.");
    }

    std::string name_;
    zip_error_t error_;
    zip_source_t* source_ = nullptr;
    Archive archive_;
};

/// Looks and pictures of a scan's materials, which stand in files of their own beside a scan.
json materials_to_json(const Scan& scan) {
    json list = json::array();
    for (const Material& material : scan.materials) {
        list.push_back({{"colour", material.colour}, {"texture", material.texture}});
    }
    return list;
}

std::string texture_part(std::size_t number) {
    return "texture-" + std::to_string(number);
}

void restore_materials(const json& manifest, zip_t* archive, const std::string& path, Scan& scan) {
    try {
        const json textures = manifest.value("textures", json::array());
        scan.textures.resize(std::min<std::size_t>(textures.size(), 64));
        for (std::size_t t = 0; t < scan.textures.size(); ++t) {
            scan.textures[t].name = textures[t].get<std::string>();
            scan.textures[t].bytes = read_part(archive, texture_part(t).c_str(), path, false);
        }
        const json materials = manifest.value("materials", json::array());
        for (std::size_t m = 0; m < std::min(materials.size(), scan.materials.size()); ++m) {
            scan.materials[m].colour = materials[m].at("colour").get<std::array<float, 4>>();
            scan.materials[m].texture = materials[m].at("texture").get<int>();
        }
    } catch (const json::exception&) {
        throw IoError(path + ": its materials are damaged.");
    }
    for (Material& material : scan.materials) {
        const int count = static_cast<int>(scan.textures.size());
        material.texture = material.texture < count ? std::max(material.texture, -1) : -1;
    }
}

/// The shape as the first schema kept it: all vertices, moved or not.
Points first_shape(const std::string& bytes, const std::string& name) {
    if (bytes.size() % (3 * sizeof(double)) != 0) {
        throw IoError(name + ": the shape of the skin is damaged.");
    }
    Points shape(3, static_cast<Eigen::Index>(bytes.size() / (3 * sizeof(double))));
    std::copy_n(bytes.data(), bytes.size(), reinterpret_cast<char*>(shape.data()));
    if (!shape.allFinite()) {
        throw IoError(name + ": the shape of the skin is damaged.");
    }
    return shape;
}

}  // namespace

OpenedFace read_case(const std::string& path, const OpenOptions& options,
                     const Progress* progress) {
    int code = 0;
    Archive archive{zip_open(path.c_str(), ZIP_RDONLY, &code)};
    if (archive.handle == nullptr) {
        throw IoError(path + ": is not a Myoface case (it is not a zip archive).");
    }
    const json manifest =
        json::parse(read_part(archive.handle, "manifest.json", path, true), nullptr, false);
    if (!manifest.is_object() || manifest.value("format", json()) != "myoface-case" ||
        !manifest.contains("schema") || !manifest["schema"].is_number_integer()) {
        throw IoError(path + ": its manifest is damaged.");
    }
    if (manifest["schema"].get<int>() > kSchema) {
        throw IoError(path + ": was written by a newer Myoface; open it with that one.");
    }
    OpenedFace face;
    face.name = fs::path(path).filename().string();
    face.scan_bytes = read_part(archive.handle, "scan", path, true);
    if (manifest.contains("tissue_depth")) {
        if (!manifest["tissue_depth"].is_string()) {
            throw IoError(path + ": its tissue depth is no text.");
        }
        face.fit.tissue = tissue_thickness(manifest["tissue_depth"]);
    }
    face.state = from_parts(
        manifest.dump(),
        [&](const std::string& part) {
            return read_part(archive.handle, part.c_str(), path, false);
        },
        path);
    ReadOptions read;
    try {
        face.scan_name = manifest.at("scan").get<std::string>();
        read.mm_per_unit = manifest.at("mm_per_unit").get<double>();
        Mat3 axes;
        for (int i = 0; i < 9; ++i) {
            axes(i / 3, i % 3) = manifest.at("axes").at(static_cast<std::size_t>(i)).get<double>();
        }
        read.axes = axes;
    } catch (const json::exception&) {
        throw IoError(path + ": its manifest is damaged.");
    }
    const bool turn =
        (*read.axes * read.axes->transpose()).isIdentity(1e-9) && read.axes->determinant() > 0.0;
    if (!(*read.mm_per_unit > 1e-6 && *read.mm_per_unit < 1e6) || !turn) {
        throw IoError(path + ": its unit or axes are damaged.");
    }
    const FileFrame kept{*read.mm_per_unit, *read.axes};
    if (options.mm_per_unit) {
        read.mm_per_unit = options.mm_per_unit;
    }
    if (options.axes) {
        read.axes = options.axes;
    }
    auto scan =
        std::make_shared<Scan>(read_mesh_bytes(face.scan_bytes, face.scan_name, read, progress));
    restore_materials(manifest, archive.handle, path, *scan);
    face.texture = load_texture(*scan);
    if (options.placed) {
        face.landmarks = in_model_frame(*options.placed, scan->frame);
    } else if (manifest.contains("landmarks")) {
        face.landmarks = in_model_frame(
            landmarks_from_json(json{{"landmarks", manifest["landmarks"]}}.dump(), path),
            scan->frame);
    }
    if (manifest["schema"].get<int>() < 2) {
        face.state.shape = first_shape(read_part(archive.handle, "shape.f64", path, false), path);
    }
    // The shape was kept in the frame of its time.
    const Mat3 change =
        scan->frame.mm_per_unit / kept.mm_per_unit * scan->frame.axes * kept.axes.transpose();
    face.state.shape = (change * face.state.shape).eval();
    for (Variant& variant : face.state.variants) {
        variant.shape = (change * variant.shape).eval();
    }
    face.report = describe(*scan);
    face.scan = std::move(scan);
    return face;
}

void write_case(const std::filesystem::path& file, const OpenedFace& opened,
                const CaseState& state) {
    const StateParts parts = to_parts(state);
    json manifest = json::parse(parts.json);
    manifest["format"] = "myoface-case";
    manifest["schema"] = kSchema;
    manifest["note"] = "A planning and communication aid, not a medical device.";
    manifest["scan"] = opened.scan_name;
    manifest["materials"] = materials_to_json(*opened.scan);
    manifest["textures"] = json::array();
    for (const Texture& texture : opened.scan->textures) {
        manifest["textures"].push_back(texture.name);
    }
    manifest["mm_per_unit"] = opened.scan->frame.mm_per_unit;
    json axes = json::array();
    for (int i = 0; i < 9; ++i) {
        axes.push_back(opened.scan->frame.axes(i / 3, i % 3));
    }
    manifest["axes"] = axes;
    if (opened.landmarks) {
        manifest["landmarks"] =
            json::parse(landmarks_to_json(*opened.landmarks, opened.scan->frame))["landmarks"];
        for (auto& [name, value] : manifest["landmarks"].items()) {
            value = {{"xyz", value}, {"est_error_mm", opened.landmarks->at(name).error_mm}};
        }
    }
    manifest["tissue_depth"] = thickness_name(opened.fit.tissue);
    const std::string made = opened.scan_bytes.empty()  // generated: it has no file
                                 ? mesh_bytes("scan.ply", *opened.scan, opened.scan->mesh.vertices)
                                 : std::string();
    const std::string& scan_bytes = opened.scan_bytes.empty() ? made : opened.scan_bytes;
    const std::string text = manifest.dump(1, ' ', false, json::error_handler_t::replace);
    MemoryArchive archive(file.string());
    archive.add("manifest.json", text);
    archive.add("scan", scan_bytes);
    for (std::size_t t = 0; t < opened.scan->textures.size(); ++t) {
        if (!opened.scan->textures[t].bytes.empty()) {
            archive.add(texture_part(t), opened.scan->textures[t].bytes);
        }
    }
    for (const auto& [name, bytes] : parts.parts) {
        archive.add(name, bytes);
    }
    write_file(file, archive.bytes(), Durability::SurvivesPowerLoss);
}

}  // namespace myoface
