// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "myoface/base/points.h"
#include "myoface/io/scan.h"

namespace myoface {

struct Landmark {
    Vec3 position = Vec3::Zero();  ///< [mm], our axes, once the file's frame is known
    double error_mm = 1.0;         ///< how far it may be off (one sigma)
};

/// Named points on a face. Names are short anthropometric ones (prn, en_l, ch_r …), _l and _r being
/// the patient's own sides.
using Landmarks = std::map<std::string, Landmark>;

/// A landmark file as it stands, in the scan file's own unit and axes.
struct LandmarkFile {
    Landmarks landmarks;                ///< positions and errors in the file's unit
    std::optional<double> mm_per_unit;  ///< from "unit", "mm_per_unit"
};

/// Reads {"unit":…, "landmarks":{name:[x,y,z] or {"xyz":[…]}}}; short names, long names
/// (endocanthion_L) and either case of the side are understood. Unknown names are left out.
/// @throws IoError with file and landmark
LandmarkFile read_landmarks(const std::filesystem::path& file);

/// Writes landmarks in the scan file's own unit and axes. @throws IoError
void write_landmarks(const std::filesystem::path& file, const Landmarks& landmarks,
                     const FileFrame& frame);
/// The same as text. @param confidence that they belong to a face, when they were found
std::string landmarks_to_json(const Landmarks& landmarks, const FileFrame& frame,
                              std::optional<double> confidence = {});
/// @throws IoError, `name` in its words
LandmarkFile landmarks_from_json(const std::string& text, const std::string& name);

/// Landmarks of a file in our unit and axes.
Landmarks in_model_frame(const LandmarkFile& file, const FileFrame& frame);

/// All short names, the paired ones with both sides.
const std::vector<std::string>& landmark_names();
/// English full name, "inner canthus (left)".
std::string landmark_title(const std::string& name);
/// What the point is and how it is found, in a sentence or two. @cite farkas_1994
std::string landmark_definition(const std::string& name);
/// The same landmark on the other side; midline names stay.
std::string mirrored_name(const std::string& name);

}  // namespace myoface
