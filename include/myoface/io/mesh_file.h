// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "myoface/base/progress.h"
#include "myoface/io/image.h"
#include "myoface/io/scan.h"

namespace myoface {

/// What was found in a mesh file and how it was understood.
struct MeshReadReport {
    std::string format;
    int vertices = 0;
    int faces = 0;
    int triangles = 0;
    int quads = 0;
    int larger_faces = 0;
    int duplicate_vertices = 0;  ///< at the place of an earlier one (UV seams)
    int unreferenced_vertices = 0;
    int degenerate_triangles = 0;  ///< no area or a repeated corner
    int components = 0;
    int boundary_loops = 0;
    double longest_boundary_mm = 0.0;
    int non_manifold_edges = 0;
    bool inward_winding = false;
    bool has_colours = false;
    bool has_uv = false;
    std::string texture;
    bool texture_found = false;
    double mm_per_unit = 1.0;
    std::string unit;  ///< m dm cm mm in, or "other"
    bool unit_is_guess = false;
    Vec3 size_mm = Vec3::Zero();
    std::vector<std::string> notes;  ///< sentences for a person
};

struct ReadOptions {
    std::optional<double> mm_per_unit;  ///< guessed from the size of a head when absent
    std::optional<Mat3> axes;           ///< file axes taken as ours when absent
};

/// Reads OBJ or PLY (ASCII, both binary orders), told apart by content.
/// @throws IoError with one sentence: file, line or element, what is wrong. Never returns a number
///         that is not finite or an index out of range.
Scan read_mesh(const std::filesystem::path& file, const ReadOptions& options = {},
               const Progress* progress = nullptr);

/// The same from memory; `name` tells the format and stands in messages. Material libraries are not
/// looked for.
Scan read_mesh_bytes(const std::string& bytes, const std::string& name,
                     const ReadOptions& options = {}, const Progress* progress = nullptr);

/// Counts and findings about a scan; `file` is used to look for the texture beside it.
MeshReadReport describe(const Scan& scan, const std::filesystem::path& file);

/// Writes vertices [mm, our axes] in the scan's own unit, axes, vertex order and faces, as OBJ or
/// PLY by the file's extension (PLY: the scan's own encoding, little-endian if it came from OBJ).
/// The file appears whole or not at all.
/// @throws IoError  InvalidInput for another extension or a wrong number of vertices
void write_mesh(const std::filesystem::path& file, const Scan& scan, const Points& vertices);

/// Full path of the scan's texture beside its file, if it exists and lies inside that folder.
std::optional<std::filesystem::path> texture_path(const Scan& scan,
                                                  const std::filesystem::path& file);

/// The scan's texture if it has one that can be read; otherwise null and perhaps a sentence in
/// `note`.
std::shared_ptr<const Image> load_texture(const Scan& scan, const std::filesystem::path& file,
                                          std::string* note = nullptr);

/// Millimetres of a unit's name (m dm cm mm in) or of a plain number of millimetres.
/// @throws InvalidInput
double millimetres_per_unit(const std::string& unit);
/// Name for a number of millimetres, or "other".
std::string unit_name(double mm_per_unit);

/// Axes from three signed letters: where the file's x, y and z point in our frame, as "+x+y+z"
/// (nothing to do) or "+x-z+y" (file's y is our -z, its z our +y).
/// @throws InvalidInput unless it is a rotation
Mat3 axes_from_text(const std::string& text);

}  // namespace myoface
