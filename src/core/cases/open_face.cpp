// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <locale>
#include <sstream>

#include "myoface/base/error.h"
#include "myoface/cases/case_file.h"
#include "myoface/face/generic_face.h"
#include "myoface/face/landmark_detection.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

namespace fs = std::filesystem;

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
        return read_case(path, options, progress);
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
    const FaceModel& face = simulator->face();
    const CaseState& state = opened.state;
    const Contractions kept = contractions_of(face, state.rates, state.strengths);
    for (int m = 0; m < static_cast<int>(face.muscles.size()); ++m) {
        const auto at = static_cast<std::size_t>(m);
        if (kept.rate[at] != 0.0) {
            simulator->set_contraction(m, kept.rate[at]);
        }
        if (kept.strength[at] != 1.0) {
            simulator->set_strength(m, kept.strength[at]);
        }
    }
    simulator->set_skin_age(state.skin_age);
    if (state.shape.cols() > 0) {
        simulator->set_skin_rest(shaped_skin(face, state.shape));
    }
    if (const Eigen::VectorXd share = protection_of_nodes(face, state.protection);
        share.size() > 0) {
        simulator->set_protection(share);
    }
    return simulator;
}

}  // namespace myoface
