// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// How a file's coordinates become ours (mm, +x the patient's left, +y up, +z out of the face):
/// ours = mm_per_unit · axes · file.
struct FileFrame {
    double mm_per_unit = 1.0;
    Mat3 axes = Mat3::Identity();  ///< a rotation by quarter turns

    Vec3 to_model(const Vec3& in_file) const { return mm_per_unit * (axes * in_file); }
    Vec3 to_file(const Vec3& in_model) const { return axes.transpose() * in_model / mm_per_unit; }
};

/// Faces with any number of corners, in the file's order.
struct Polygons {
    std::vector<int> start{0};  ///< faces + 1 offsets into the corner arrays
    std::vector<int> vertex;    ///< vertex of each corner
    std::vector<int> uv;        ///< texture coordinate of each corner, -1 for none; empty: no UV

    int count() const { return static_cast<int>(start.size()) - 1; }
    int size(int face) const { return start[face + 1] - start[face]; }
};

enum class FileFormat {
    Obj,
    PlyAscii,
    PlyBinaryLittle,
    PlyBinaryBig,
    StlAscii,
    StlBinary,
    Gltf,
    Glb
};

/// A statement of an OBJ file that stands before a face: g, o, s, usemtl.
struct ObjStatement {
    int before_face = 0;
    std::string text;
};

/// A picture that belongs to a scan, as the bytes of its file.
struct Texture {
    std::string name;   ///< as the scan names it
    std::string bytes;  ///< empty where the picture is missing
};

struct Material {
    std::string name;
    std::array<float, 4> colour{1.0F, 1.0F, 1.0F, 1.0F};  ///< red, green, blue, opacity
    int texture = -1;                                     ///< number in Scan::textures
};

/// A connected part of a scan, seams joined.
struct ScanPart {
    int triangles = 0;
    double area = 0.0;                             ///< in the file's unit, squared
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< bounding box in the file's unit and axes
};

/// What was found wrong or odd while reading. Nothing of it is taken out of what is written back.
struct ScanFindings {
    int duplicate_vertices = 0;  ///< at the place of an earlier one (texture seams)
    int unreferenced_vertices = 0;
    int degenerate_triangles = 0;  ///< no area or a repeated corner; take no part in computing
    int duplicate_triangles = 0;   ///< the corners of an earlier one; take no part in computing
    int turned_triangles = 0;      ///< turned over in Scan::mesh to agree with their neighbours
    bool inward = false;           ///< the faces looked inwards; turned over in Scan::mesh
    int non_manifold_edges = 0;    ///< shared by more than two triangles
    int holes = 0;                 ///< border loops
    double longest_hole = 0.0;     ///< its length in the file's unit
    std::vector<ScanPart> parts;   ///< the largest area first
    int other_statements = 0;      ///< points, lines, curves, faces of extra elements: not kept
};

/// A scan as a person's file holds it, in our unit and axes. Vertices keep the file's order; faces
/// are kept as they came beside the triangles that computing uses.
struct Scan {
    TriangleMesh mesh;               ///< [mm], every vertex of the file in its order; faces outward
    Points file_vertices;            ///< the file's own numbers, untouched
    bool float_coordinates = false;  ///< the file holds them in single precision
    std::vector<int> triangle_face;  ///< triangle -> face; empty where all faces are triangles
    /// Triangle -> corners in `faces`; empty where they are the faces' own in their order.
    std::vector<std::array<int, 3>> triangle_corner;
    std::vector<int> triangle_part;  ///< triangle -> part of `findings`, -1 for unusable ones
    Polygons faces;
    Eigen::Matrix3Xf colours;   ///< 3×N in 0 … 1, or 3×0
    Eigen::VectorXf alpha;      ///< N in 0 … 1, or empty
    bool byte_colours = false;  ///< the file holds colours as 0 … 255
    Eigen::Matrix2Xf uv;        ///< 2×K texture coordinates, (0,0) bottom left
    std::vector<Material> materials;
    std::vector<int> face_material;  ///< face -> material, -1 for none; empty: no materials
    std::vector<Texture> textures;
    std::vector<std::string> material_libraries;  ///< names after mtllib
    std::vector<ObjStatement> statements;
    ScanFindings findings;
    FileFrame frame;
    FileFormat format = FileFormat::Obj;
};

inline int face_of(const Scan& scan, int triangle) {
    return scan.triangle_face.empty() ? triangle
                                      : scan.triangle_face[static_cast<std::size_t>(triangle)];
}

inline std::array<int, 3> corners_of(const Scan& scan, int triangle) {
    return scan.triangle_corner.empty()
               ? std::array<int, 3>{3 * triangle, 3 * triangle + 1, 3 * triangle + 2}
               : scan.triangle_corner[static_cast<std::size_t>(triangle)];
}

/// Fills mesh.triangles, triangle_face and triangle_corner from `faces`: quads along the diagonal
/// that keeps both halves upright, larger faces by clipping ears in the face's own plane.
void triangulate(Scan& scan);

/// Fills `findings` and triangle_part, and turns triangles of `mesh` so that neighbours agree and
/// the surface looks outwards; `faces` stay as they came. @pre triangulate(scan)
void examine(Scan& scan);

/// Re-expresses the scan in another frame; the file's own numbers stay what they were.
void set_frame(Scan& scan, const FileFrame& frame);

}  // namespace myoface
