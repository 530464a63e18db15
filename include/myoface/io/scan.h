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

enum class FileFormat { Obj, PlyAscii, PlyBinaryLittle, PlyBinaryBig };

/// A statement of an OBJ file that stands before a face: g, o, s, usemtl.
struct ObjStatement {
    int before_face = 0;
    std::string text;
};

/// A scan as a person's file holds it, in our unit and axes. Vertices keep the file's order; faces
/// are kept as they came beside the triangles that computing uses.
struct Scan {
    TriangleMesh mesh;               ///< [mm], every vertex of the file in its order
    Points file_vertices;            ///< the file's own numbers, untouched
    std::vector<int> triangle_face;  ///< triangle -> face
    std::vector<std::array<int, 3>> triangle_corner;  ///< triangle -> corners in `faces`
    Polygons faces;
    Eigen::Matrix3Xf colours;                     ///< 3×N in 0 … 1, or 3×0
    Eigen::Matrix2Xf uv;                          ///< 2×K texture coordinates, (0,0) bottom left
    std::string texture;                          ///< file name of the colour texture, "" for none
    std::vector<std::string> material_libraries;  ///< names after mtllib
    std::vector<ObjStatement> statements;
    FileFrame frame;
    FileFormat format = FileFormat::Obj;
};

/// Fills mesh.triangles, triangle_face and triangle_corner from `faces`: quads along the diagonal
/// that keeps both halves upright, larger faces by clipping ears in the face's own plane.
void triangulate(Scan& scan);

/// Re-expresses the scan in another frame; the file's own numbers stay what they were.
void set_frame(Scan& scan, const FileFrame& frame);

}  // namespace myoface
