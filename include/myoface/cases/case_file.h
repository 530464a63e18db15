// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "myoface/base/error.h"
#include "myoface/base/progress.h"
#include "myoface/cases/case_state.h"
#include "myoface/face/face_search.h"
#include "myoface/face/landmarks.h"
#include "myoface/io/mesh_file.h"
#include "myoface/io/skin_texture.h"
#include "myoface/sim/simulator.h"

namespace myoface {

/// A case is protected by a passphrase that was not given, or by another one.
class PassphraseNeeded : public IoError {
public:
    PassphraseNeeded(const std::string& file, bool given);
    bool given() const { return given_; }  ///< else none was

private:
    bool given_;
};

/// A face as it was opened: from a scan file, from a case, or generated.
struct OpenedFace {
    std::shared_ptr<const Scan> scan;
    MeshReadReport report;
    std::shared_ptr<const SkinTexture> texture;
    std::optional<Landmarks> landmarks;  ///< our frame
    bool landmarks_detected = false;     ///< found by the shape of the face, not given
    std::optional<FacePose> pose;        ///< where the face is on the scan, where it was looked for
    CaseState state;                     ///< what a case had made of it
    FitOptions fit;
    std::string name;        ///< for the window's title
    std::string scan_name;   ///< file name of the scan
    std::string scan_bytes;  ///< the scan's file, byte for byte
    std::string pseudonym;   ///< what a case calls the patient; empty: made when it is written
    std::string thumbnail;   ///< PNG, or nothing
    std::string passphrase;  ///< of the case it came from; cases written from it have it too
};

/// A distance on the scan that somebody knows, for calibration: "from=…; to=…; mm=…" with ends
/// given as a landmark, "vertex N" (from 0, in file order) or x,y,z in the file's own numbers.
struct KnownDistance {
    std::string from, to;
    double mm = 0.0;
};
/// @throws InvalidInput
KnownDistance parse_known_distance(const std::string& text);

struct OpenOptions {
    std::optional<std::filesystem::path> landmarks;
    std::optional<LandmarkFile> placed;  ///< landmarks from somewhere else than a file
    std::optional<double> mm_per_unit;
    std::optional<Mat3> axes;
    std::optional<KnownDistance> known;  ///< wins over mm_per_unit
    std::optional<TissueThickness> tissue;
    std::string passphrase;  ///< of a protected case, or nothing
};

/// Opens OBJ, PLY, STL, glTF, a .myoface case, or the word "generic". Without given landmarks a
/// file STEM.landmarks.json beside the scan, or in ../landmarks, is used when it is there. Unit and
/// axes that are not given follow the landmarks, or else the face as find_face() sees it.
/// @throws IoError, InvalidInput
OpenedFace open_face(const std::string& path, const OpenOptions& options = {},
                     const Progress* progress = nullptr);

/// Finds the landmarks of a face that came without, and says so in its report. A face that is not
/// sure enough is left without. @return whether there are landmarks now
bool find_missing_landmarks(OpenedFace& opened, const Progress* progress = nullptr);

/// Fits the opened face and puts a case's settings and shape back.
/// @throws InvalidInput when there are no landmarks or the fit fails
std::unique_ptr<Simulator> make_simulator(const OpenedFace& opened,
                                          const SimulatorOptions& options = {},
                                          const Progress* progress = nullptr);

/// Reads a case of this or an older version.
/// @throws PassphraseNeeded when it is protected, IoError
OpenedFace read_case(const std::string& path, const OpenOptions& options = {},
                     const Progress* progress = nullptr);

/// Writes a case: a zip with manifest.json (schema 2), the scan byte for byte, its textures and the
/// parts of the state; see docs/dev/case-format.md. The file appears whole or not at all, also when
/// power fails meanwhile. May be called from any thread, as long as nobody changes what it is
/// given.
/// @throws IoError, Cancelled
void write_case(const std::filesystem::path& file, const OpenedFace& opened, const CaseState& state,
                const Progress* progress = nullptr);

/// What of a case can be shown without opening it: a PNG, or nothing where there is none, where it
/// is protected, or where it is no case.
std::string case_thumbnail(const std::filesystem::path& file);
/// A name for a patient that says nothing of him, the same for the same scan: "MF-7K3Q-W2".
std::string pseudonym_of(const Scan& scan);

}  // namespace myoface
