// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "myoface/face/face_model.h"
#include "myoface/face/generic_face.h"
#include "myoface/mesh/triangle_mesh.h"
#include "myoface/physics/mass_spring_model.h"

namespace myoface::test {

/// n × n vertices in the plane z = 0, `spacing` apart, two triangles a cell, facing +z.
TriangleMesh grid(int n, double spacing = 1.0);
/// A closed sphere about the origin from `rings` rings of `around` vertices.
TriangleMesh sphere(double radius, int rings = 16, int around = 24);
/// Two meshes as one, not joined.
TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b);

/// A scan around a mesh, in mm.
Scan scan_of(const TriangleMesh& mesh);

/// The generic face with about 4,000 vertices and its fit; built once per process.
const GenericFace& small_face();
std::shared_ptr<const FaceModel> small_model();
/// Index of a muscle by its full name.
int muscle(const FaceModel& face, const std::string& name);

/// n points in a row joined by springs, nothing else.
MassSpringModel spring_row(int n, double stiffness, double length, double mass,
                           double damping = 0.0);

/// A folder that is removed with everything in it.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

}  // namespace myoface::test
