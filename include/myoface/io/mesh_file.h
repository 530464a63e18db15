// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "myoface/base/progress.h"
#include "myoface/io/scan.h"

namespace myoface {

/// What was found in a mesh file and how it was understood, in words and millimetres.
struct MeshReadReport {
    std::string format;
    int vertices = 0;
    int faces = 0;
    int triangles = 0;
    int quads = 0;
    int larger_faces = 0;
    ScanFindings findings;  ///< lengths in the file's unit, see scan.h
    double longest_hole_mm = 0.0;
    bool has_colours = false;
    bool has_uv = false;
    std::string texture;  ///< name of the first one
    bool texture_found = false;
    double mm_per_unit = 1.0;
    std::string unit;  ///< m dm cm mm in, or "other"
    bool unit_is_guess = false;
    bool needs_calibration = false;  ///< no usual unit makes it the size of a face
    std::string axes;                ///< where the file's x, y and z point, as "+x+y+z"
    bool axes_are_guess = false;
    double frame_confidence = 1.0;  ///< of a search by shape, 0 … 1; 1 where none was needed
    Vec3 size_mm = Vec3::Zero();
    std::vector<std::string> notes;  ///< sentences for a person
};

struct ReadOptions {
    std::optional<double> mm_per_unit;  ///< guessed from the size of a head when absent
    std::optional<Mat3> axes;           ///< file axes taken as ours when absent
    bool examine = true;                ///< fill Scan::findings and make the faces look outwards
};

/// Reads OBJ, PLY, STL, glTF or GLB, told apart by content, with the materials and textures beside
/// it. glTF is read by a process of its own, which may use at most 60 s.
/// @throws IoError with one sentence: file, line or element, what is wrong. Never returns a number
///         that is not finite or an index out of range.
/// @throws Cancelled
Scan read_mesh(const std::filesystem::path& file, const ReadOptions& options = {},
               const Progress* progress = nullptr);

/// The same from memory; `name` tells the format and stands in messages. Materials and textures are
/// not looked for.
Scan read_mesh_bytes(std::string_view bytes, const std::string& name,
                     const ReadOptions& options = {}, const Progress* progress = nullptr);

/// Looks materials and textures up beside the file that a scan came from; what is missing or lies
/// outside the file's folder stays without.
void read_companions(const std::filesystem::path& file, Scan& scan);

/// Counts and findings about a scan.
MeshReadReport describe(const Scan& scan);

/// Writes vertices [mm, our axes] in the scan's own unit, axes, vertex order and faces: OBJ (with
/// material library and textures beside it), PLY, STL or GLB by the file's extension. PLY and STL
/// keep the scan's own encoding (little-endian binary if it came from another format). STL and GLB
/// know triangles only; GLB repeats vertices on texture seams after the others. Files appear whole
/// or not at all; a texture that is there already is not touched.
/// @throws IoError  InvalidInput for another extension or a wrong number of vertices
void write_mesh(const std::filesystem::path& file, const Scan& scan, const Points& vertices);

/// The bytes of write_mesh's main file. @throws InvalidInput
std::string mesh_bytes(const std::string& name, const Scan& scan, const Points& vertices);

/// Millimetres of a unit's name (m dm cm mm in) or of a plain number of millimetres.
/// @throws InvalidInput
double millimetres_per_unit(const std::string& unit);
/// Name for a number of millimetres, or "other".
std::string unit_name(double mm_per_unit);

/// Axes from three signed letters: where the file's x, y and z point in our frame, as "+x+y+z"
/// (nothing to do) or "+x-z+y" (file's y is our -z, its z our +y).
/// @throws InvalidInput unless it is a rotation
Mat3 axes_from_text(const std::string& text);
/// The one of the 24 quarter turns that is nearest to a rotation.
Mat3 nearest_quarter_turn(const Mat3& rotation);
/// The way back; the nearest such text for a turn that is no quarter turn.
std::string axes_to_text(const Mat3& axes);

}  // namespace myoface
