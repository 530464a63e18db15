// SPDX-License-Identifier: Apache-2.0
#include "myoface/cases/case_file.h"

#include <algorithm>
#include <charconv>
#include <locale>
#include <sstream>
#include <zip.h>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/face/face_search.h"
#include "myoface/face/generic_face.h"
#include "myoface/face/landmark_detection.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int kSchema = 1;
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

std::map<std::string, double> settings(const json& manifest, const char* key, double least,
                                       double most, const std::string& name) {
    std::map<std::string, double> result;
    if (!manifest.contains(key)) {
        return result;
    }
    if (!manifest[key].is_object()) {
        throw IoError(name + ": \"" + key + "\" is damaged.");
    }
    for (const auto& [muscle, value] : manifest[key].items()) {
        const double number = value.is_number() ? value.get<double>() : most + 1.0;
        if (!(number >= least && number <= most)) {
            throw IoError(name + ": the setting of " + muscle + " is out of range.");
        }
        result[muscle] = number;
    }
    return result;
}

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

OpenedFace open_case(const std::string& path, const OpenOptions& options,
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
    face.rates = settings(manifest, "contractions", kLeastContraction, kMostContraction, path);
    face.strengths = settings(manifest, "strengths", 0.0, 1.0, path);
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
    const std::string shape = read_part(archive.handle, "shape.f64", path, false);
    if (shape.size() % (3 * sizeof(double)) != 0) {
        throw IoError(path + ": the shape of the skin is damaged.");
    }
    face.shape.resize(3, static_cast<Eigen::Index>(shape.size() / (3 * sizeof(double))));
    std::copy_n(shape.data(), shape.size(), reinterpret_cast<char*>(face.shape.data()));
    if (!face.shape.allFinite()) {
        throw IoError(path + ": the shape of the skin is damaged.");
    }
    // The shape was kept in the frame of its time.
    const Mat3 change =
        scan->frame.mm_per_unit / kept.mm_per_unit * scan->frame.axes * kept.axes.transpose();
    face.shape = (change * face.shape).eval();
    face.report = describe(*scan);
    face.scan = std::move(scan);
    return face;
}

std::optional<fs::path> landmarks_beside(const fs::path& file) {
    const std::string name = file.stem().string() + ".landmarks.json";
    std::error_code error;
    for (const fs::path& folder : {file.parent_path(), file.parent_path() / "../landmarks"}) {
        if (fs::is_regular_file(folder / name, error)) {
            return folder / name;
        }
    }
    return std::nullopt;
}

/// A place on a scan in the file's own numbers.
Vec3 place_in_file(const std::string& text, const Scan& scan,
                   const std::optional<LandmarkFile>& landmarks) {
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    std::string first;
    words >> first;
    long long number = -1;
    if (first == "vertex" && words >> number) {
        if (number < 0 || number >= scan.mesh.vertex_count()) {
            throw InvalidInput("There is no vertex " + std::to_string(number) + " (the scan has " +
                               std::to_string(scan.mesh.vertex_count()) + ").");
        }
        return scan.file_vertices.col(static_cast<Eigen::Index>(number));
    }
    std::istringstream numbers(text);
    numbers.imbue(std::locale::classic());
    Vec3 point;
    char comma = 0;
    char other = 0;
    if (numbers >> point.x() >> comma >> point.y() >> other >> point.z() && comma == ',' &&
        other == ',' && point.allFinite()) {
        return point;
    }
    const auto found = landmarks ? landmarks->landmarks.find(text) : Landmarks::const_iterator();
    if (!landmarks || found == landmarks->landmarks.end()) {
        throw InvalidInput("'" + text +
                           "' is no place on the scan: give a landmark of its landmark file, "
                           "\"vertex N\" or x,y,z.");
    }
    return found->second.position;
}

double calibrated_unit(const KnownDistance& known, const Scan& scan,
                       const std::optional<LandmarkFile>& landmarks) {
    const double apart =
        (place_in_file(known.from, scan, landmarks) - place_in_file(known.to, scan, landmarks))
            .norm();
    if (!(apart > 1e-12)) {
        throw InvalidInput("The two places of the known distance are the same.");
    }
    return known.mm / apart;
}

/// Looks for the face and takes unit and axes from it where they are not given; a face that is not
/// found leaves what the size of the scan implies.
std::optional<FrameGuess> settle_frame(Scan& scan, const OpenOptions& options,
                                       std::optional<FacePose>& pose, const Progress* progress) {
    pose = find_face(scan.mesh, progress);
    if (!pose || confidence_of(*pose) <= 0.0) {
        return std::nullopt;
    }
    FrameGuess guess = guess_frame(scan, *pose);
    const FileFrame before = scan.frame;
    set_frame(scan, {options.mm_per_unit.value_or(guess.frame.mm_per_unit),
                     options.axes.value_or(guess.frame.axes)});
    pose->to_generic.scale *= before.mm_per_unit / scan.frame.mm_per_unit;
    pose->to_generic.rotation *= before.axes * scan.frame.axes.transpose();
    return guess;
}

/// Puts what should be looked at before what is merely told.
void warn(MeshReadReport& report, std::string sentence) {
    report.notes.insert(report.notes.begin(), std::move(sentence));
}

/// Says how unit and axes came about and how sure they are.
void report_frame(MeshReadReport& report, const std::optional<FrameGuess>& guess,
                  const std::optional<LandmarkFile>& landmarks, const OpenOptions& options) {
    report.unit_is_guess = !options.mm_per_unit && !(landmarks && landmarks->mm_per_unit);
    report.axes_are_guess = !options.axes && !landmarks;
    const bool searched = !landmarks && (report.unit_is_guess || report.axes_are_guess);
    report.frame_confidence = !searched ? 1.0 : guess ? guess->confidence : 0.0;
    report.needs_calibration = report.unit == "other" && !options.mm_per_unit;
    if (report.needs_calibration) {
        warn(report,
             report.unit_is_guess
                 ? "The unit is none of m, dm, cm, mm and in: the size of an average face was "
                   "taken, which may be off by a tenth. Calibrate it with a known distance."
                 : "The unit is none of m, dm, cm, mm and in: the size is what the landmark file "
                   "says. Check it with a known distance.");
    }
    if (report.frame_confidence < 0.5) {
        warn(report,
             guess
                 ? "Whether this is a face, and which way it looks, is not sure: check unit and "
                   "axes."
                 : "No face was found by its shape: unit and axes are taken from the size alone.");
    }
}

OpenedFace open_generic() {
    GenericFaceOptions options;
    options.vertices = 24000;
    options.picture = 1536;
    GenericFace generic = make_generic_face(options);
    OpenedFace face;
    face.name = face.scan_name = "generic.ply";
    face.landmarks = std::move(generic.landmarks);
    face.report = describe(generic.scan);
    face.texture = load_texture(generic.scan);
    face.scan = std::make_shared<const Scan>(std::move(generic.scan));
    return face;
}

OpenedFace opened(const std::string& path, const OpenOptions& options, const Progress* progress) {
    if (path == "generic") {
        return open_generic();
    }
    const fs::path file(path);
    if (file.extension() == ".myoface") {
        std::error_code error;
        if (!fs::is_regular_file(file, error)) {
            throw IoError(path + ": there is no such file.");
        }
        return open_case(path, options, progress);
    }
    OpenedFace face;
    face.name = face.scan_name = file.filename().string();
    const std::optional<fs::path> landmark_path =
        options.landmarks ? options.landmarks : landmarks_beside(file);
    std::optional<LandmarkFile> landmarks = options.placed;
    if (!landmarks && landmark_path) {
        landmarks = read_landmarks(*landmark_path);
    }
    ReadOptions read{options.mm_per_unit, options.axes};
    if (landmarks) {
        const FileFrame frame = frame_from_landmarks(*landmarks, options.mm_per_unit, options.axes);
        read = {frame.mm_per_unit, frame.axes};
    }
    auto scan = std::make_shared<Scan>(read_mesh(file, read, progress));
    if (scan->format == FileFormat::Gltf) {  // its parts lie in several files: kept as one
        face.scan_name = file.stem().string() + ".glb";
        face.scan_bytes = mesh_bytes(face.scan_name, *scan, scan->mesh.vertices);
    } else {
        face.scan_bytes = read_file(file);
    }
    OpenOptions settled = options;
    if (options.known) {
        settled.mm_per_unit = calibrated_unit(*options.known, *scan, landmarks);
        set_frame(*scan, {*settled.mm_per_unit, scan->frame.axes});
    }
    const std::optional<FrameGuess> guess = landmarks || (settled.mm_per_unit && settled.axes)
                                                ? std::nullopt
                                                : settle_frame(*scan, settled, face.pose, progress);
    face.report = describe(*scan);
    report_frame(face.report, guess, landmarks, settled);
    std::string note;
    face.texture = load_texture(*scan, &note);
    if (!note.empty()) {
        face.report.notes.push_back(note);
    }
    if (landmarks) {
        face.landmarks = in_model_frame(*landmarks, scan->frame);
    }
    face.scan = std::move(scan);
    return face;
}

}  // namespace

KnownDistance parse_known_distance(const std::string& text) {
    KnownDistance known;
    const auto fail = [&] {
        throw InvalidInput("The known distance '" + text +
                           "' is not of the form \"from=PLACE; to=PLACE; mm=NUMBER\".");
    };
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ';');) {
        const std::size_t begin = part.find_first_not_of(' ');
        const std::size_t equals = part.find('=');
        if (begin == std::string::npos) {
            continue;
        }
        if (equals == std::string::npos) {
            fail();
        }
        const std::string key = part.substr(begin, equals - begin);
        std::string value = part.substr(equals + 1);
        value.erase(value.find_last_not_of(' ') + 1);
        if (key == "from") {
            known.from = value;
        } else if (key == "to") {
            known.to = value;
        } else if (key == "mm") {
            const auto [end, error] =
                std::from_chars(value.data(), value.data() + value.size(), known.mm);
            if (error != std::errc() || end != value.data() + value.size()) {
                fail();
            }
        } else {
            fail();
        }
    }
    if (known.from.empty() || known.to.empty() || !(known.mm > 0.0 && known.mm < 1e5)) {
        fail();
    }
    return known;
}

OpenedFace open_face(const std::string& path, const OpenOptions& options,
                     const Progress* progress) {
    OpenedFace face = opened(path, options, progress);
    if (options.tissue) {
        face.fit.tissue = *options.tissue;
    }
    return face;
}

bool find_missing_landmarks(OpenedFace& opened, const Progress* progress) {
    constexpr double kSureEnough = 0.4;
    if (opened.landmarks) {
        return true;
    }
    try {
        DetectedLandmarks found =
            detect_landmarks(opened.scan->mesh, opened.pose ? &*opened.pose : nullptr, progress);
        if (found.confidence < kSureEnough) {
            return false;
        }
        opened.landmarks = std::move(found.landmarks);
        opened.landmarks_detected = true;
        warn(opened.report, "The landmarks were found by the shape of the face, " +
                                std::to_string(static_cast<int>(100.0 * found.confidence)) +
                                " % sure. Look whether eyes and mouth fit, and place them by hand "
                                "where they do not.");
        return true;
    } catch (const InvalidInput&) {
        return false;
    }
}

std::unique_ptr<Simulator> make_simulator(const OpenedFace& opened, const SimulatorOptions& options,
                                          const Progress* progress) {
    if (!opened.landmarks) {
        throw InvalidInput(opened.name +
                           ": no face was found on this scan by its shape; give a landmark file "
                           "with --landmarks, or place the points in the window.");
    }
    auto simulator = std::make_unique<Simulator>(
        fit_face(opened.scan, *opened.landmarks, progress, opened.fit), options);
    const auto& muscles = simulator->face().muscles;
    for (std::size_t m = 0; m < muscles.size(); ++m) {
        const auto rate = opened.rates.find(muscles[m].traits.name);
        if (rate != opened.rates.end()) {
            simulator->set_contraction(static_cast<int>(m), rate->second);
        }
        const auto strength = opened.strengths.find(muscles[m].traits.name);
        if (strength != opened.strengths.end()) {
            simulator->set_strength(static_cast<int>(m), strength->second);
        }
    }
    if (opened.shape.cols() > 0) {
        simulator->set_skin_rest(shaped_skin(simulator->face(), opened.shape));
    }
    return simulator;
}

CaseState case_state(const FaceModel& face, const Contractions& contractions,
                     const Points& skin_rest) {
    CaseState state;
    for (std::size_t m = 0; m < face.muscles.size(); ++m) {
        const std::string& name = face.muscles[m].traits.name;
        if (contractions.rate[m] != 0.0) {
            state.rates[name] = contractions.rate[m];
        }
        if (contractions.strength[m] != 1.0) {
            state.strengths[name] = contractions.strength[m];
        }
    }
    state.shape = shape_of_scan(face, skin_rest);
    return state;
}

void write_case(const std::filesystem::path& file, const OpenedFace& opened,
                const CaseState& state) {
    json manifest;
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
    manifest["contractions"] = state.rates;
    manifest["strengths"] = state.strengths;
    const std::string shape(reinterpret_cast<const char*>(state.shape.data()),
                            static_cast<std::size_t>(state.shape.size()) * sizeof(double));
    const std::string made = opened.scan_bytes.empty()  // generated: it has no file
                                 ? mesh_bytes("scan.ply", *opened.scan, opened.scan->mesh.vertices)
                                 : std::string();
    const std::string& scan_bytes = opened.scan_bytes.empty() ? made : opened.scan_bytes;
    const std::string text = manifest.dump(1, ' ', false, json::error_handler_t::replace);
    const fs::path part = file.string() + ".part";
    int code = 0;
    Archive archive{zip_open(part.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code)};
    const auto fail = [&] {
        std::error_code ignored;
        fs::remove(part, ignored);
        throw IoError(file.string() +
                      ": cannot be written (is the folder there, writable and not full?).");
    };
    if (archive.handle == nullptr) {
        fail();
    }
    const auto add = [&](const char* name, const std::string& bytes) {
        zip_source_t* source = zip_source_buffer(archive.handle, bytes.data(), bytes.size(), 0);
        if (source == nullptr || zip_file_add(archive.handle, name, source, ZIP_FL_OVERWRITE) < 0) {
            fail();
        }
    };
    add("manifest.json", text);
    add("scan", scan_bytes);
    for (std::size_t t = 0; t < opened.scan->textures.size(); ++t) {
        if (!opened.scan->textures[t].bytes.empty()) {
            add(texture_part(t).c_str(), opened.scan->textures[t].bytes);
        }
    }
    if (!shape.empty()) {
        add("shape.f64", shape);
    }
    if (zip_close(archive.handle) != 0) {
        fail();
    }
    archive.handle = nullptr;
    std::error_code error;
    fs::rename(part, file, error);
    if (error) {
        fail();
    }
}

}  // namespace myoface
