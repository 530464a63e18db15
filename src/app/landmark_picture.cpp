// SPDX-License-Identifier: Apache-2.0
#include "landmark_picture.h"

#include <cmath>

#include <QPainter>

#include "myoface/face/generic_face.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/normals.h"

namespace myoface {
namespace {

/// The head that is drawn; made once.
struct Model {
    TriangleMesh mesh;
    Points normals;
    Bvh bvh;

    Model() {
        GenericFaceOptions options;
        options.vertices = 8000;
        mesh = make_generic_face(options).scan.mesh;
        normals = vertex_normals(mesh, Adjacency(mesh));
        bvh = Bvh(mesh);
    }
};

const Model& model() {
    static const Model kModel;
    return kModel;
}

/// Orthographic view of the face: right and up in the picture, and towards the viewer.
struct View {
    Vec3 right, up, out, centre;
    double height;  ///< of the picture [mm]
};

View viewFor(const std::string& name) {
    const bool midline = !name.ends_with("_l") && !name.ends_with("_r");
    const bool side = midline || name.starts_with("t_") || name.starts_with("go_");
    const Vec3 at = generic_landmarks().at(name).position;
    const double near =
        name.starts_with("t_") || name.starts_with("go_") || name == "tr" ? 230.0 : 130.0;
    // A neighbourhood large enough to know where one is.
    const Vec3 middle(0.0, std::clamp(at.y(), -60.0, 45.0), near > 200.0 ? 30.0 : 75.0);
    if (!side) {
        return {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), middle, near};
    }
    // Profiles look to the picture's left, as the left side of a patient is seen.
    const double sign = name.ends_with("_r") ? -1.0 : 1.0;
    return {Vec3(0.0, 0.0, -sign), Vec3::UnitY(), Vec3(sign, 0.0, 0.0), middle, near};
}

}  // namespace

QImage landmarkPicture(const std::string& name, int width, int height) {
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(QColor(38, 43, 49));
    if (generic_landmarks().count(name) == 0) {
        return image;
    }
    const Model& head = model();
    const View view = viewFor(name);
    const double mm = view.height / height;
    const Vec3 light = (0.45 * view.up + 0.35 * view.right + view.out).normalized();
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const Vec3 from = view.centre + 300.0 * view.out +
                              mm * (column - 0.5 * width) * view.right -
                              mm * (row - 0.5 * height) * view.up;
            const auto hit = head.bvh.first_hit(head.mesh, {from, -view.out});
            if (!hit) {
                continue;
            }
            Vec3 normal = Vec3::Zero();
            for (int c = 0; c < 3; ++c) {
                normal += hit->where.weights[c] *
                          head.normals.col(head.mesh.triangles(c, hit->where.triangle));
            }
            const double shade = 0.25 + 0.75 * std::max(0.0, normal.normalized().dot(light));
            const auto tone = [&](double full) { return static_cast<int>(full * shade); };
            image.setPixelColor(column, row, QColor(tone(214), tone(196), tone(182)));
        }
    }
    const Vec3 off = generic_landmarks().at(name).position - view.centre;
    const QPointF at(0.5 * width + off.dot(view.right) / mm, 0.5 * height - off.dot(view.up) / mm);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Qt::white, 1.6));
    painter.setBrush(QColor(227, 74, 51));
    painter.drawEllipse(at, 5.0, 5.0);
    return image;
}

}  // namespace myoface
