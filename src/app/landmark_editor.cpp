// SPDX-License-Identifier: Apache-2.0
#include "landmark_editor.h"

#include <algorithm>
#include <utility>

#include "myoface/mesh/bvh.h"

#include "commands.h"
#include "face_view.h"
#include "landmark_panel.h"
#include "language.h"

namespace myoface {

LandmarkEditor::LandmarkEditor(FaceDocument& document, FaceView& view, LandmarkPanel& panel,
                               QObject* parent)
    : QObject(parent), m_document(document), m_view(view), m_panel(panel) {
    connect(&panel, &LandmarkPanel::displayChanged, this, &LandmarkEditor::changed);
    connect(&panel, &LandmarkPanel::chosen, this, &LandmarkEditor::look);
    connect(&panel, &LandmarkPanel::accepted, this, &LandmarkEditor::accept);
    connect(&panel, &LandmarkPanel::mirrorAsked, this, &LandmarkEditor::mirror);
    connect(&panel, &LandmarkPanel::detectionAsked, this, &LandmarkEditor::detect);
    connect(&view, &FaceView::handlePressed, this, [this](int handle) {
        if (static_cast<std::size_t>(handle) < m_names.size()) {
            m_held = handle;
            m_panel.select(m_names[static_cast<std::size_t>(handle)]);
        }
    });
    connect(&view, &FaceView::handleMoved, this,
            [this](int handle, const SurfacePoint& where) { moved(handle, where, false); });
    connect(&view, &FaceView::handleDropped, this,
            [this](int handle, const SurfacePoint& where) { moved(handle, where, true); });
    connect(&document, &FaceDocument::landmarksChanged, this, [this] {
        bind();
        Q_EMIT changed();
        refit();
    });
    connect(&document, &FaceDocument::tissueChanged, this, [this] {
        m_panel.setTissue(m_document.fit().tissue);
        refit();
    });
    connect(&panel, &LandmarkPanel::tissueChosen, this, [this](TissueThickness tissue) {
        if (m_document.model() && tissue != m_document.fit().tissue) {
            m_document.undoStack()->push(
                new SetTissueCommand(m_document, tissue, tr("depth of the soft tissue")));
        }
    });
    // What is made while a fit runs belongs to the face too.
    const auto outdated = [this] { m_again = m_again || m_job != nullptr; };
    connect(&document, &FaceDocument::skinRestChanged, this, outdated);
    connect(&document, &FaceDocument::rateChanged, this, outdated);
}

LandmarkEditor::~LandmarkEditor() = default;

void LandmarkEditor::setFace(FittedNet net, const Bvh& skin) {
    retire(m_job);
    retire(m_detection);
    m_panel.setDetecting(false);
    m_again = false;
    m_held = -1;
    m_view.setHandles({});
    m_net = std::move(net);
    m_netStale = true;
    bind(skin);
}

void LandmarkEditor::bind() {
    bind(m_document.model() ? Bvh(m_document.model()->skin.mesh) : Bvh());
}

/// Puts the landmarks onto the skin, so that they move with it.
void LandmarkEditor::bind(const Bvh& bvh) {
    m_names.clear();
    m_where.clear();
    m_panel.setLandmarks(m_document.landmarks());
    m_panel.setTissue(m_document.fit().tissue);
    m_panel.setEnabled(m_document.model() != nullptr);
    if (!m_document.model()) {
        return;
    }
    const TriangleMesh& skin = m_document.model()->skin.mesh;
    for (const auto& [name, landmark] : m_document.landmarks()) {
        m_names.push_back(name);
        m_where.push_back(bvh.closest_point(skin, landmark.position).where);
    }
    std::vector<double> off;
    for (const auto& [a, b] : m_net.threads) {
        off.push_back(m_net.distance[a]);
        off.push_back(m_net.distance[b]);
    }
    if (!off.empty()) {
        std::sort(off.begin(), off.end());
        m_panel.setMisfit(off[off.size() / 2], off[off.size() * 95 / 100]);
    }
}

void LandmarkEditor::draw(SceneData& scene, const Points& positions) {
    if (!m_document.model()) {
        return;
    }
    const TriangleMesh& skin = m_document.model()->skin.mesh;
    std::vector<Vec3> handles;
    if (m_panel.markersShown()) {
        for (std::size_t i = 0; i < m_where.size(); ++i) {
            Vec3 p = Vec3::Zero();
            for (int c = 0; c < 3; ++c) {
                p += m_where[i].weights[c] * positions.col(skin.triangles(c, m_where[i].triangle));
            }
            handles.push_back(p);
            const QColor colour = landmarkColour(m_document.landmarks().at(m_names[i]));
            const bool chosen = m_names[i] == m_panel.selected();
            if (chosen) {
                scene.markers.push_back({p.cast<float>(), {1.0F, 1.0F, 1.0F}, 9.0F});
            }
            scene.markers.push_back(
                {p.cast<float>(),
                 {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
                  static_cast<float>(colour.blueF())},
                 chosen ? 6.5F : 5.0F});
        }
    }
    m_view.setHandles(std::move(handles));
    const bool shown = m_panel.netShown();
    scene.net.opacity = shown ? 0.75F : 0.0F;
    if (shown && scene.net.indices.size() != 2 * m_net.threads.size()) {
        m_netStale = true;  // a scene that has not got it yet
    }
    if (shown && std::exchange(m_netStale, false)) {
        constexpr double kFar = 2.0;  // [mm] that is all red
        scene.net.positions = m_net.points.cast<float>();
        scene.net.colours.resize(3, m_net.points.cols());
        scene.net.indices.clear();
        scene.net_version = ++m_netVersion;
        for (Eigen::Index i = 0; i < m_net.points.cols(); ++i) {
            const auto share = static_cast<float>(std::min(m_net.distance[i] / kFar, 1.0));
            scene.net.colours.col(i) = (1.0F - share) * Eigen::Vector3f(0.45F, 0.85F, 0.75F) +
                                       share * Eigen::Vector3f(0.95F, 0.25F, 0.2F);
        }
        for (const auto& [a, b] : m_net.threads) {
            scene.net.indices.push_back(static_cast<std::uint32_t>(a));
            scene.net.indices.push_back(static_cast<std::uint32_t>(b));
        }
    }
}

void LandmarkEditor::push(Landmarks landmarks, const QString& text) {
    m_document.undoStack()->push(new SetLandmarksCommand(m_document, std::move(landmarks), text));
}

void LandmarkEditor::moved(int handle, const SurfacePoint& where, bool dropped) {
    const auto i = static_cast<std::size_t>(handle);
    if (i >= m_names.size() || !m_document.model()) {
        return;
    }
    m_where[i] = where;
    if (!dropped) {
        Q_EMIT changed();
        return;
    }
    m_held = -1;
    Landmarks landmarks = m_document.landmarks();
    landmarks[m_names[i]] = {position(m_document.model()->skin.mesh, where), kCheckedError};
    push(std::move(landmarks), tr("move %1").arg(landmarkInWords(m_names[i])));
}

void LandmarkEditor::accept(const std::string& name) {
    Landmarks landmarks = m_document.landmarks();
    const auto found = landmarks.find(name);
    if (found == landmarks.end()) {
        return;
    }
    found->second.error_mm = kCheckedError;
    push(std::move(landmarks), tr("accept %1").arg(landmarkInWords(name)));
}

void LandmarkEditor::mirror(const std::string& name) {
    const auto& model = m_document.model();
    Landmarks landmarks = m_document.landmarks();
    const auto other = landmarks.find(mirrored_name(name));
    if (!model || other == landmarks.end()) {
        return;
    }
    const Bvh bvh(model->skin.mesh);
    const Vec3 image = mirrored(model->midplane, other->second.position);
    landmarks[name] = {bvh.closest_point(model->skin.mesh, image).point,
                       std::max(2.0, other->second.error_mm)};
    push(std::move(landmarks), tr("%1 from the other side").arg(landmarkInWords(name)));
}

void LandmarkEditor::detect() {
    if (!m_document.opened() || m_detection) {
        return;
    }
    retire(m_detection);
    m_detection = std::make_unique<DetectJob>(m_document.opened()->scan);
    connect(m_detection.get(), &DetectJob::finished, this, &LandmarkEditor::detected);
    m_panel.setDetecting(true);
    m_detection->start();
}

void LandmarkEditor::detected() {
    const std::unique_ptr<DetectJob> job = std::move(m_detection);
    m_panel.setDetecting(false);
    if (job->landmarks()) {
        push(*job->landmarks(), tr("find landmarks"));
    } else {
        Q_EMIT problem(job->problem());
    }
}

/// Turns the view so that a landmark is seen.
void LandmarkEditor::look(const std::string& name) {
    const auto found = m_document.landmarks().find(name);
    if (found != m_document.landmarks().end() && m_panel.markersShown() && m_held < 0) {
        m_view.bringIntoView(found->second.position);
    }
    Q_EMIT changed();
}

void LandmarkEditor::refit() {
    if (!m_document.opened()) {
        return;
    }
    if (m_job) {
        m_again = true;
        return;
    }
    const auto& model = m_document.model();
    Points shape = model ? shape_of_scan(*model, m_document.skinRest()) : Points(3, 0);
    m_job = std::make_unique<FitJob>(m_document.opened()->scan, m_document.landmarks(),
                                     m_document.fit(), m_document.contractions(), std::move(shape),
                                     m_document.opened()->texture);
    connect(m_job.get(), &FitJob::finished, this, &LandmarkEditor::jobFinished);
    m_job->start();
}

void LandmarkEditor::jobFinished() {
    const std::unique_ptr<FitJob> job = std::move(m_job);
    if (std::exchange(m_again, false)) {
        refit();
        return;
    }
    if (!job->simulator()) {
        Q_EMIT problem(job->problem());
        return;
    }
    m_net = job->net();
    m_netStale = true;
    const Bvh skin = job->bvh();
    Q_EMIT fitted(*job);
    bind(skin);
    Q_EMIT changed();
}

}  // namespace myoface
