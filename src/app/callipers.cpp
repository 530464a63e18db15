// SPDX-License-Identifier: Apache-2.0
#include "callipers.h"

#include <array>
#include <cmath>

#include <QLocale>

#include "myoface/mesh/geodesic.h"
#include "myoface/scene/strokes.h"

namespace myoface {
namespace {

const Eigen::Vector3f kColour(0.98F, 0.80F, 0.35F);
constexpr std::size_t kMost = 3;

/// Way along the skin between two places of it [mm].
double alongSkin(const TriangleMesh& skin, const Adjacency& adjacency, const SurfacePoint& from,
                 const SurfacePoint& to) {
    const Vec3 start = position(skin, from);
    const Vec3 end = position(skin, to);
    if (from.triangle == to.triangle) {
        return (end - start).norm();
    }
    std::array<GeodesicSource, 3> sources;
    for (int c = 0; c < 3; ++c) {
        const int v = skin.triangles(c, from.triangle);
        sources[static_cast<std::size_t>(c)] = {v, (skin.vertices.col(v) - start).norm()};
    }
    const std::vector<double> distances =
        geodesic_distances(skin, adjacency, sources, 2.0 * (end - start).norm() + 40.0);
    double best = std::numeric_limits<double>::infinity();
    for (int c = 0; c < 3; ++c) {
        const int v = skin.triangles(c, to.triangle);
        best = std::min(
            best, distances[static_cast<std::size_t>(v)] + (skin.vertices.col(v) - end).norm());
    }
    return best;
}

}  // namespace

Callipers::Callipers(FaceView& view, QObject* parent) : QObject(parent), m_view(view) {
    connect(&view, &FaceView::measured, this, &Callipers::add);
}

void Callipers::setFace(std::shared_ptr<const FaceModel> face) {
    m_face = std::move(face);
    clear();
}

void Callipers::clear() {
    m_places.clear();
    m_words.clear();
    m_view.setLabels({});
    Q_EMIT changed();
}

void Callipers::add(const SurfacePoint& where) {
    if (!m_face) {
        return;
    }
    if (m_places.size() == kMost) {
        m_places.clear();
    }
    m_places.push_back(where);
    Q_EMIT message(m_places.size() == 1   ? tr("Click the other end of the distance.")
                   : m_places.size() == 2 ? tr("A third click measures the angle at this point; "
                                               "Esc ends.")
                                          : tr("Another click begins anew; Esc ends."));
    Q_EMIT changed();
}

void Callipers::draw(SceneData& scene, const Points& nodes) {
    if (!m_face || m_places.empty()) {
        if (!m_words.isEmpty()) {
            m_words.clear();
            m_view.setLabels({});
        }
        return;
    }
    const TriangleMesh skin{nodes.leftCols(m_face->node_count()), m_face->skin.mesh.triangles};
    std::vector<Vec3> points;
    for (const SurfacePoint& place : m_places) {
        points.push_back(position(skin, place));
        scene.markers.push_back({points.back().cast<float>(), kColour, 5.0F});
    }
    add_line(scene.strokes, points, kColour);
    std::vector<ViewLabel> labels;
    const QLocale locale;
    m_words.clear();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double straight = (points[i] - points[i - 1]).norm();
        const double skin_way = alongSkin(skin, *m_face->adjacency, m_places[i - 1], m_places[i]);
        const QString text =
            std::isfinite(skin_way)
                ? tr("%1 mm, along the skin %2 mm")
                      .arg(locale.toString(straight, 'f', 1), locale.toString(skin_way, 'f', 1))
                : tr("%1 mm").arg(locale.toString(straight, 'f', 1));
        labels.push_back({0.5 * (points[i] + points[i - 1]), text});
        m_words += (m_words.isEmpty() ? QString() : QStringLiteral(" · ")) + text;
    }
    if (points.size() == kMost) {
        const Vec3 a = points[0] - points[1];
        const Vec3 b = points[2] - points[1];
        const double angle = std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / 3.14159265358979;
        const QString text = tr("%1°").arg(locale.toString(angle, 'f', 1));
        labels.push_back({points[1], text});
        m_words += QStringLiteral(" · ") + text;
    }
    m_view.setLabels(std::move(labels));
}

}  // namespace myoface
