// SPDX-License-Identifier: Apache-2.0
#include "myoface/cases/case_file.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"

#include "archive.h"
#include "case_bytes.h"

namespace myoface {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kCaseSchema = 2;
constexpr const char* kThumbnail = "thumbnail.png";

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

void restore_materials(const json& manifest, const ZipReader& archive, const std::string& path,
                       Scan& scan) {
    try {
        const json textures = manifest.value("textures", json::array());
        scan.textures.resize(std::min<std::size_t>(textures.size(), 64));
        for (std::size_t t = 0; t < scan.textures.size(); ++t) {
            scan.textures[t].name = textures[t].get<std::string>();
            scan.textures[t].bytes = archive.part(texture_part(t), false);
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

/// What kind of file a scan was; the rest of its name may be the patient's.
std::string plain_name(const std::string& stem, const std::string& name) {
    const std::string extension = fs::path(name).extension().string();
    const bool plain = extension.size() > 1 && extension.size() <= 5 &&
                       std::all_of(extension.begin() + 1, extension.end(),
                                   [](unsigned char c) { return std::isalnum(c) != 0; });
    return stem + (plain ? extension : std::string());
}

json read_manifest(const ZipReader& archive, const std::string& path) {
    json manifest = json::parse(archive.part("manifest.json", true), nullptr, false);
    if (!manifest.is_object() || !manifest.contains("format") ||
        manifest["format"] != "myoface-case" || !manifest.contains("schema") ||
        !manifest["schema"].is_number_integer()) {
        throw IoError(path + ": its manifest is damaged.");
    }
    const auto schema = manifest["schema"].get<std::int64_t>();
    if (schema > kCaseSchema) {
        throw IoError(path + ": was written by a newer Myoface; open it with that one.");
    }
    if (schema < 1) {
        throw IoError(path + ": its manifest has no such schema as " + std::to_string(schema) +
                      ".");
    }
    return manifest;
}

std::string manifest_text(const json& manifest, const char* key, const std::string& path) {
    if (!manifest.contains(key)) {
        return {};
    }
    if (!manifest[key].is_string()) {
        throw IoError(path + ": its manifest is damaged (\"" + key + "\" is no text).");
    }
    return manifest[key].get<std::string>();
}

TissueThickness tissue_of(const std::string& name, const std::string& path) {
    try {
        return tissue_thickness(name);
    } catch (const InvalidInput& problem) {
        throw IoError(path + ": " + problem.what());
    }
}

FileFrame frame_of(const json& manifest, const std::string& path) {
    FileFrame frame;
    try {
        frame.mm_per_unit = manifest.at("mm_per_unit").get<double>();
        if (manifest.at("axes").size() != 9) {
            throw IoError(path + ": its unit or axes are damaged.");
        }
        for (int i = 0; i < 9; ++i) {
            frame.axes(i / 3, i % 3) =
                manifest.at("axes").at(static_cast<std::size_t>(i)).get<double>();
        }
    } catch (const json::exception&) {
        throw IoError(path + ": its unit or axes are damaged.");
    }
    const bool turn =
        (frame.axes * frame.axes.transpose()).isIdentity(1e-9) && frame.axes.determinant() > 0.0;
    if (!(frame.mm_per_unit > 1e-6 && frame.mm_per_unit < 1e6) || !turn) {
        throw IoError(path + ": its unit or axes are damaged.");
    }
    return frame;
}

/// All of the manifest that is not state. Names of files stay out: they may be the patient's.
void describe_face(const OpenedFace& opened, json& manifest) {
    manifest["format"] = "myoface-case";
    manifest["schema"] = kCaseSchema;
    manifest["note"] = "A planning and communication aid, not a medical device.";
    manifest["pseudonym"] =
        opened.pseudonym.empty() ? pseudonym_of(*opened.scan) : opened.pseudonym;
    manifest["scan"] = plain_name("scan", opened.scan_name);
    manifest["materials"] = materials_to_json(*opened.scan);
    manifest["textures"] = json::array();
    for (std::size_t t = 0; t < opened.scan->textures.size(); ++t) {
        manifest["textures"].push_back(plain_name(texture_part(t), opened.scan->textures[t].name));
    }
    manifest["mm_per_unit"] = opened.scan->frame.mm_per_unit;
    manifest["axes"] = json::array();
    for (int i = 0; i < 9; ++i) {
        manifest["axes"].push_back(opened.scan->frame.axes(i / 3, i % 3));
    }
    if (opened.landmarks) {
        manifest["landmarks"] =
            json::parse(landmarks_to_json(*opened.landmarks, opened.scan->frame))["landmarks"];
        for (auto& [name, value] : manifest["landmarks"].items()) {
            value = {{"xyz", value}, {"est_error_mm", opened.landmarks->at(name).error_mm}};
        }
    }
    manifest["tissue_depth"] = thickness_name(opened.fit.tissue);
}

OpenedFace read_archive(const ZipReader& archive, const std::string& path,
                        const OpenOptions& options, const Progress* progress) {
    const json manifest = read_manifest(archive, path);
    OpenedFace face;
    face.name = fs::path(path).filename().string();
    face.passphrase = archive.encrypted("manifest.json") ? options.passphrase : "";
    face.scan_bytes = archive.part("scan", true);
    face.thumbnail = archive.part(kThumbnail, false);
    face.pseudonym = manifest_text(manifest, "pseudonym", path);
    face.scan_name = manifest_text(manifest, "scan", path);
    if (manifest.contains("tissue_depth")) {
        face.fit.tissue = tissue_of(manifest_text(manifest, "tissue_depth", path), path);
    }
    const FileFrame kept = frame_of(manifest, path);
    const ReadOptions read{options.mm_per_unit.value_or(kept.mm_per_unit),
                           options.axes.value_or(kept.axes)};
    auto scan =
        std::make_shared<Scan>(read_mesh_bytes(face.scan_bytes, face.scan_name, read, progress));
    restore_materials(manifest, archive, path, *scan);
    face.texture = load_texture(*scan);
    face.state = from_parts(
        manifest.dump(), [&](const std::string& part) { return archive.part(part, false); },
        scan->mesh.vertex_count(), path);
    if (options.placed) {
        face.landmarks = in_model_frame(*options.placed, scan->frame);
    } else if (manifest.contains("landmarks")) {
        face.landmarks = in_model_frame(
            landmarks_from_json(json{{"landmarks", manifest["landmarks"]}}.dump(), path),
            scan->frame);
    }
    if (manifest["schema"].get<int>() < 2) {
        face.state.shape = first_shape(archive.part("shape.f64", false), path);
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

}  // namespace

PassphraseNeeded::PassphraseNeeded(const std::string& file, bool given)
    : IoError(file + (given ? ": is protected by another passphrase than this one."
                            : ": is protected by a passphrase, which is needed to open it.")),
      given_(given) {}

OpenedFace read_case(const std::string& path, const OpenOptions& options,
                     const Progress* progress) {
    return read_archive(ZipReader(fs::path(path), path, options.passphrase), path, options,
                        progress);
}

OpenedFace read_case_bytes(std::string_view bytes, const std::string& name,
                           const OpenOptions& options, const Progress* progress) {
    return read_archive(ZipReader(ZipReader::Memory{bytes}, name, options.passphrase), name,
                        options, progress);
}

void write_case(const std::filesystem::path& file, const OpenedFace& opened, const CaseState& state,
                const Progress* progress) {
    const StateParts state_parts = to_parts(state);
    json manifest = json::parse(state_parts.json);
    describe_face(opened, manifest);
    // A generated face has no file.
    const std::string made = opened.scan_bytes.empty()
                                 ? mesh_bytes("scan.ply", *opened.scan, opened.scan->mesh.vertices)
                                 : std::string();
    const std::string text = manifest.dump(1, ' ', false, json::error_handler_t::replace);
    std::vector<ZipPart> parts{{"manifest.json", text},
                               {"scan", opened.scan_bytes.empty() ? made : opened.scan_bytes}};
    if (!opened.thumbnail.empty()) {
        parts.push_back({kThumbnail, opened.thumbnail});
    }
    for (std::size_t t = 0; t < opened.scan->textures.size(); ++t) {
        if (!opened.scan->textures[t].bytes.empty()) {
            parts.push_back({texture_part(t), opened.scan->textures[t].bytes});
        }
    }
    for (const auto& [name, bytes] : state_parts.parts) {
        parts.push_back({name, bytes});
    }
    write_file(file, zip_bytes(parts, opened.passphrase, file.string(), progress),
               Durability::SurvivesPowerLoss);
}

std::string case_thumbnail(const std::filesystem::path& file) {
    try {
        const ZipReader archive(file, file.string(), {});
        return archive.encrypted(kThumbnail) ? std::string() : archive.part(kThumbnail, false);
    } catch (const IoError&) {
        return {};
    }
}

std::string pseudonym_of(const Scan& scan) {
    std::uint64_t sum = 14695981039346656037ULL;
    for (Eigen::Index k = 0; k < scan.file_vertices.size(); ++k) {
        std::uint64_t word = 0;
        std::memcpy(&word, scan.file_vertices.data() + k, sizeof word);
        sum = (sum ^ word) * 1099511628211ULL;
    }
    sum ^= sum >> 32;
    constexpr const char* kLetters = "23456789ABCDEFGHJKLMNPQRSTUVWXYZ";  // none looks like another
    std::string name = "MF-";
    for (int k = 0; k < 6; ++k) {
        name += k == 4 ? "-" : "";
        name += kLetters[(sum >> (5 * k)) % 32];
    }
    return name;
}

}  // namespace myoface
