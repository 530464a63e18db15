// SPDX-License-Identifier: Apache-2.0
#include "test_meshes.h"

#include <atomic>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <unistd.h>

namespace myoface::test {

TriangleMesh grid(int n, double spacing) {
    TriangleMesh mesh;
    mesh.vertices.resize(3, n * n);
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            mesh.vertices.col(j * n + i) << spacing * i, spacing * j, 0.0;
        }
    }
    mesh.triangles.resize(3, 2 * (n - 1) * (n - 1));
    int t = 0;
    for (int j = 0; j + 1 < n; ++j) {
        for (int i = 0; i + 1 < n; ++i) {
            const int a = j * n + i;
            mesh.triangles.col(t++) << a, a + 1, a + n + 1;
            mesh.triangles.col(t++) << a, a + n + 1, a + n;
        }
    }
    return mesh;
}

TriangleMesh sphere(double radius, int rings, int around) {
    TriangleMesh mesh;
    mesh.vertices.resize(3, rings * around + 2);
    for (int r = 0; r < rings; ++r) {
        const double polar = std::numbers::pi * (r + 1) / (rings + 1);
        for (int k = 0; k < around; ++k) {
            const double turn = 2.0 * std::numbers::pi * k / around;
            mesh.vertices.col(r * around + k) << radius * std::sin(polar) * std::cos(turn),
                radius * std::sin(polar) * std::sin(turn), radius * std::cos(polar);
        }
    }
    const int top = rings * around;
    const int bottom = top + 1;
    mesh.vertices.col(top) << 0.0, 0.0, radius;
    mesh.vertices.col(bottom) << 0.0, 0.0, -radius;
    mesh.triangles.resize(3, 2 * around * rings);
    int t = 0;
    for (int k = 0; k < around; ++k) {
        const int next = (k + 1) % around;
        mesh.triangles.col(t++) << top, k, next;
        for (int r = 0; r + 1 < rings; ++r) {
            const int a = r * around;
            const int b = a + around;
            mesh.triangles.col(t++) << a + k, b + k, b + next;
            mesh.triangles.col(t++) << a + k, b + next, a + next;
        }
        const int last = (rings - 1) * around;
        mesh.triangles.col(t++) << last + k, bottom, last + next;
    }
    return mesh;
}

TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b) {
    TriangleMesh both;
    both.vertices.resize(3, a.vertex_count() + b.vertex_count());
    both.vertices << a.vertices, b.vertices;
    both.triangles.resize(3, a.triangle_count() + b.triangle_count());
    both.triangles << a.triangles, (b.triangles.array() + a.vertex_count()).matrix();
    return both;
}

Scan scan_of(const TriangleMesh& mesh) {
    Scan scan;
    scan.mesh.vertices = scan.file_vertices = mesh.vertices;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) {
            scan.faces.vertex.push_back(mesh.triangles(c, t));
        }
        scan.faces.start.push_back(static_cast<int>(scan.faces.vertex.size()));
    }
    triangulate(scan);
    examine(scan);
    return scan;
}

const GenericFace& small_face() {
    static const GenericFace kFace = [] {
        GenericFaceOptions options;
        options.vertices = 4000;
        return make_generic_face(options);
    }();
    return kFace;
}

std::shared_ptr<const FaceModel> small_model() {
    static const auto kModel =
        fit_face(std::make_shared<const Scan>(small_face().scan), small_face().landmarks);
    return kModel;
}

int muscle(const FaceModel& face, const std::string& name) {
    for (std::size_t m = 0; m < face.muscles.size(); ++m) {
        if (face.muscles[m].traits.name == name) {
            return static_cast<int>(m);
        }
    }
    throw std::runtime_error("no muscle " + name);
}

MassSpringModel spring_row(int n, double stiffness, double length, double mass, double damping) {
    MassSpringModel model;
    model.rest = Points::Zero(3, n);
    model.mass = Eigen::VectorXd::Constant(n, mass);
    for (int i = 0; i < n; ++i) {
        model.rest(0, i) = length * i;
    }
    for (int i = 0; i + 1 < n; ++i) {
        Spring spring;
        spring.a = i;
        spring.b = i + 1;
        spring.stiffness = stiffness;
        spring.length = length;
        spring.damping = damping;
        model.springs.push_back(spring);
    }
    index_rows(model);
    return model;
}

TemporaryFolder::TemporaryFolder() {
    static std::atomic<int> count{0};
    path_ = std::filesystem::temp_directory_path() /
            ("myoface-test-" + std::to_string(::getpid()) + "-" + std::to_string(++count));
    std::filesystem::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace myoface::test
