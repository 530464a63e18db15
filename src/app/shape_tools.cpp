// SPDX-License-Identifier: Apache-2.0
#include "shape_tools.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "myoface/mesh/cross_section.h"
#include "myoface/scene/colour_map.h"
#include "myoface/scene/strokes.h"

#include "commands.h"

namespace myoface {
namespace {

const Eigen::Vector3f kHand(0.35F, 0.78F, 1.0F);
const Eigen::Vector3f kGap(1.0F, 0.72F, 0.25F);
const Eigen::Vector4f kProtected(0.20F, 0.42F, 0.72F, 0.55F);
constexpr double kNudge = 0.1;           // [mm]
constexpr double kArrowPerNewton = 6.0;  // [mm]

}  // namespace

ShapeTools::ShapeTools(FaceDocument& document, FaceView& view, ShapePanel& panel, InWorker inWorker,
                       QObject* parent)
    : QObject(parent),
      m_document(document),
      m_view(view),
      m_panel(panel),
      m_inWorker(std::move(inWorker)) {
    connect(&view, &FaceView::gripped, this, &ShapeTools::grip);
    connect(&view, &FaceView::pulled, this, [this](const ViewRay& ray) {
        m_inWorker([ray](SimulationWorker& w) { w.moveDrag(ray); });
    });
    connect(&view, &FaceView::released, this, [this](bool keep, bool otherwise) {
        const bool stays = m_view.tool() == Tool::Shape || otherwise;
        m_inWorker([keep, stays](SimulationWorker& w) { w.endDrag(keep && stays); });
    });
    connect(&view, &FaceView::hovered, this,
            [this](const ViewRay&, const std::optional<SurfacePoint>& where) { hover(where); });
    connect(&view, &FaceView::placed, this, &ShapeTools::place);
    connect(&view, &FaceView::brushed, this, &ShapeTools::brush);
    connect(&view, &FaceView::nudged, this,
            [this](double right, double up) { nudge(kNudge * right, kNudge * up); });
    connect(&view, &FaceView::mirrorToggled, &panel, &ShapePanel::toggleMirror);
    connect(&view, &FaceView::radiusStarted, this, [this] {
        m_radiusBefore = m_panel.radius() > 0.0 ? m_panel.radius()
                         : m_under              ? radiusAt(*m_under)
                                                : 12.0;
    });
    connect(&view, &FaceView::radiusMoved, this, [this](double millimetres) {
        m_panel.setRadius(m_radiusBefore + millimetres);
        Q_EMIT message(tr("Radius of the grip %1 mm — click to take it, Esc to leave it")
                           .arg(m_panel.radius(), 0, 'f', 0));
    });
    connect(&view, &FaceView::radiusCancelled, this, [this] { m_panel.setRadius(m_radiusBefore); });
    connect(&panel, &ShapePanel::moveAsked, this, &ShapeTools::nudge);
    connect(&panel, &ShapePanel::targetAsked, this, &ShapeTools::meet);
    connect(&panel, &ShapePanel::optionsEdited, this, [this] {
        paint();
        Q_EMIT changed();
    });
    connect(&panel, &ShapePanel::clearProtectionAsked, this, [this] {
        if (m_protection.size() > 0 && m_protection.maxCoeff() > 0.0) {
            ProtectEdit nothing;
            nothing.none = true;
            m_document.undoStack()->push(
                new SetProtectionCommand(m_document, {}, tr("protect nothing"), {nothing}));
        }
    });
    connect(&view, &FaceView::brushEnded, this, &ShapeTools::endStroke);
    connect(&document, &FaceDocument::protectionChanged, this, &ShapeTools::protectionChanged);
}

void ShapeTools::setScene(FaceScene* scene, std::shared_ptr<const LandmarksOnSkin> places) {
    m_scene = scene;
    m_under.reset();
    m_gripped.reset();
    m_landmarks = std::move(places);
    protectionChanged();
    m_panel.setEnabled(m_document.model() != nullptr);
    m_panel.say({});
}

DragRequest ShapeTools::request(const SurfacePoint& where) const {
    DragRequest request;
    request.where = where;
    request.mode =
        m_view.tool() == Tool::Feel ? DragMode::ConstraintPriority : DragMode::MousePriority;
    request.radius = m_panel.radius();
    request.mirrored = m_panel.mirrored();
    request.path = m_panel.path();
    return request;
}

double ShapeTools::radiusAt(const SurfacePoint& where) const {
    const FaceModel& face = *m_document.model();
    return m_panel.radius() > 0.0 ? m_panel.radius() : kernel_radius(face, grip_at(face, where));
}

void ShapeTools::grip(const SurfacePoint& where, const ViewRay& ray) {
    m_gripped = where;
    m_panel.say({});
    m_inWorker([request = request(where), ray](SimulationWorker& w) { w.beginDrag(request, ray); });
}

void ShapeTools::hover(const std::optional<SurfacePoint>& where) {
    if (!m_document.model() || (!where && !m_under)) {
        return;
    }
    m_under = where;
    if (m_panel.showsKernel()) {
        paint();
    }
    Q_EMIT changed();
}

void ShapeTools::place(const SurfacePoint& where) {
    VolumeRequest volume{where, m_panel.millilitres(), m_panel.radius(), m_panel.mirrored()};
    m_inWorker([volume](SimulationWorker& w) { w.addVolume(volume); });
}

void ShapeTools::brush(const SurfacePoint& where) {
    if (!m_document.model()) {
        return;
    }
    const FaceModel& face = *m_document.model();
    const auto stroke = [&](const SurfacePoint& at) {
        ProtectEdit edit;
        edit.radius = std::max(3.0, 0.6 * radiusAt(at));
        edit.erases = m_panel.erases();
        edit.place = plan_place(face, at);
        m_strokes.emplace_back(edit);
        const Eigen::VectorXd touched = brushed(face, at, edit.radius);
        if (m_panel.erases()) {
            m_protection = m_protection.cwiseMin((1.0 - touched.array()).matrix());
        } else {
            m_protection = m_protection.cwiseMax(touched);
        }
    };
    stroke(where);
    if (m_panel.mirrored()) {
        stroke(mirrored_place(face, where));
    }
    m_inWorker([share = m_protection](SimulationWorker& w) { w.setProtection(share); });
    paint();
    Q_EMIT changed();
}

void ShapeTools::endStroke() {
    const Eigen::VectorXd& kept = m_document.protection();
    const bool same = kept.size() == 0 ? m_protection.isZero(0.0) : m_protection == kept;
    if (m_document.model() && !same) {
        m_document.undoStack()->push(
            new SetProtectionCommand(m_document, m_protection, tr("protected skin"), m_strokes));
    }
    m_strokes.clear();
}

void ShapeTools::protectionChanged() {
    m_protection = m_document.protection();
    if (m_protection.size() == 0 && m_document.model()) {
        m_protection = Eigen::VectorXd::Zero(m_document.model()->node_count());
    }
    m_inWorker([share = m_document.protection()](SimulationWorker& w) { w.setProtection(share); });
    paint();
    Q_EMIT changed();
}

void ShapeTools::setPaints(bool paints) {
    if (paints != m_paints) {
        m_paints = paints;
        paint();
    }
}

void ShapeTools::nudge(double right, double up) {
    if (!m_gripped || (right == 0.0 && up == 0.0)) {
        Q_EMIT message(tr("Grip a place of the face first; then it can be moved by numbers."));
        return;
    }
    const Camera& camera = m_view.camera();
    const Vec3 way =
        right * (camera.orientation * Vec3::UnitX()) + up * (camera.orientation * Vec3::UnitY());
    const Vec3 view = camera.orientation * -Vec3::UnitZ();
    DragRequest moved = request(*m_gripped);
    moved.mode = DragMode::MousePriority;
    m_inWorker([moved, way, view](SimulationWorker& w) { w.nudge(moved, way, view); });
}

void ShapeTools::meet(double value) {
    TargetRequest target{m_panel.measure(), value, false, m_panel.radius()};
    m_inWorker([target](SimulationWorker& w) { w.meetTarget(target); });
}

/// Protected skin, and the kernel of the place under the cursor.
void ShapeTools::paint() {
    if (m_scene == nullptr || !m_document.model() || !m_paints) {
        return;
    }
    const FaceModel& face = *m_document.model();
    const bool kernel = m_panel.showsKernel() && m_under;
    if (!kernel && !(m_protection.size() > 0 && m_protection.maxCoeff() > 0.0)) {
        m_scene->tint_nodes({});
        return;
    }
    Eigen::Matrix4Xf tint = Eigen::Matrix4Xf::Zero(4, face.node_count());
    for (Eigen::Index i = 0; i < m_protection.size(); ++i) {
        tint.col(i) = kProtected;
        tint(3, i) *= static_cast<float>(m_protection[i]);
    }
    if (kernel) {
        const StressKernel reach =
            stress_kernel(face, m_document.skinRest(), grip_at(face, *m_under), radiusAt(*m_under));
        for (std::size_t k = 0; k < reach.nodes.size(); ++k) {
            const double share = reach.profile[k];
            tint.col(reach.nodes[k]) << colour_map(0.25 + 0.75 * share),
                static_cast<float>(0.75 * std::sqrt(share));
        }
    }
    m_scene->tint_nodes(tint);
}

void ShapeTools::draw(SceneData& scene, const SimSnapshot& snapshot) {
    const Vec3 view = m_view.camera().orientation * -Vec3::UnitZ();
    if (m_landmarks && m_document.model()) {
        const auto value = m_landmarks->measure(m_panel.measure(), snapshot.positions);
        const auto before =
            m_landmarks->measure(m_panel.measure(), m_document.model()->skin.mesh.vertices);
        constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
        m_panel.showMeasure(before.value_or(kUnknown), value.value_or(kUnknown));
    }
    m_view.setHandLabel(std::nullopt);
    if (!snapshot.dragging) {
        m_view.setInset(std::nullopt);
    }
    if (snapshot.dragging && snapshot.report.drag) {
        const DragReport& drag = *snapshot.report.drag;
        m_view.setInset(inset(drag, snapshot));
        scene.markers.push_back({drag.reached.cast<float>(), kHand, 6.0F});
        if (drag.off_ray_mm > 0.3) {  // the gap between hand and skin
            scene.markers.push_back({drag.target.cast<float>(), kGap, 4.0F});
            add_line(scene.strokes, {drag.reached, drag.target}, kGap);
        }
        if (drag.mode == DragMode::ConstraintPriority) {
            const Vec3 way = drag.target - drag.reached;
            if (way.norm() > 1e-6) {
                const double newtons = drag.force_mN / 1000.0;
                const Vec3 arrow = kArrowPerNewton * newtons * way.normalized();
                add_arrow(scene.strokes, drag.reached, arrow, view, kHand);
                m_view.setHandLabel(
                    ViewLabel{drag.reached + arrow,
                              tr("%1 N").arg(m_panel.locale().toString(newtons, 'f', 1))});
            }
        }
        return;
    }
    if (m_under && m_document.model() && m_view.tool() != Tool::Navigate &&
        m_view.tool() != Tool::Measure) {
        const double radius = m_view.tool() == Tool::Protect
                                  ? std::max(3.0, 0.6 * radiusAt(*m_under))
                                  : radiusAt(*m_under);
        add_line(scene.strokes, m_view.ringOnSkin(*m_under, radius), kHand);
        if (m_panel.mirrored()) {
            add_line(scene.strokes,
                     m_view.ringOnSkin(mirrored_place(*m_document.model(), *m_under), radius),
                     0.6F * kHand);
        }
    }
    if (m_gripped && m_document.model()) {
        const TriangleMesh& skin = m_document.model()->skin.mesh;
        Vec3 at = Vec3::Zero();
        for (int c = 0; c < 3; ++c) {
            at += m_gripped->weights[c] *
                  snapshot.positions.col(skin.triangles(c, m_gripped->triangle));
        }
        scene.markers.push_back({at.cast<float>(), 0.7F * kHand, 4.0F});
    }
}

/// A cut along the view, through the grabbed point.
DepthInset ShapeTools::inset(const DragReport& drag, const SimSnapshot& snapshot) const {
    constexpr double kReach = 45.0;  // [mm]
    const Camera& camera = m_view.camera();
    const Vec3 front = camera.orientation * Vec3::UnitZ();
    const Vec3 up = camera.orientation * Vec3::UnitY();
    const Vec3 right = camera.orientation * Vec3::UnitX();
    const FaceModel& face = *m_document.model();
    const auto lines = [&](const TriangleMesh& mesh) {
        QVector<QLineF> result;
        for (const auto& [a, b] : cross_section(mesh, drag.reached, right)) {
            if ((a - drag.reached).norm() < kReach) {
                result.append(QLineF(front.dot(a - drag.reached), up.dot(a - drag.reached),
                                     front.dot(b - drag.reached), up.dot(b - drag.reached)));
            }
        }
        return result;
    };
    DepthInset result;
    result.bone = lines(face.bone);
    result.before = lines(face.skin.mesh);
    result.now = lines({snapshot.positions.leftCols(face.node_count()), face.skin.mesh.triangles});
    return result;
}

QString ShapeTools::words(const SimSnapshot& snapshot) const {
    if (!snapshot.dragging || !snapshot.report.drag) {
        return {};
    }
    const DragReport& drag = *snapshot.report.drag;
    const QString newtons = m_panel.locale().toString(drag.force_mN / 1000.0, 'f', 1);
    const QString gap = m_panel.locale().toString(drag.off_ray_mm, 'f', 1);
    if (drag.mode == DragMode::ConstraintPriority) {
        return tr("pull %1 N: skin %2, muscle %3, held back %4 · %5 mm behind the hand")
            .arg(newtons)
            .arg(drag.stage_skin_mN / 1000.0, 0, 'f', 1)
            .arg(drag.stage_muscle_mN / 1000.0, 0, 'f', 1)
            .arg(drag.refused_mN / 1000.0, 0, 'f', 1)
            .arg(gap);
    }
    return drag.off_ray_mm > 0.3 ? tr("hold %1 N · bone holds back %2 mm").arg(newtons, gap)
                                 : tr("hold %1 N").arg(newtons);
}

void ShapeTools::finished(const DragOutcome& outcome) {
    if (outcome.report.kept_share < 1.0) {
        Q_EMIT message(tr("The skin would have folded over itself: %1 % of the shape stay.")
                           .arg(100.0 * outcome.report.kept_share, 0, 'f', 0));
    }
    if (!outcome.words.isEmpty()) {
        m_panel.say(outcome.words);
    }
    if (outcome.before.cols() != outcome.after.cols() || outcome.before == outcome.after) {
        return;
    }
    const double moved =
        std::sqrt((outcome.after - outcome.before).colwise().squaredNorm().maxCoeff());
    const QString title =
        outcome.title.isEmpty() ? tr("shape by %1 mm").arg(moved, 0, 'f', 1) : outcome.title;
    m_document.undoStack()->push(
        new ReshapeCommand(m_document, outcome.before, outcome.after, title, outcome.edits));
}

}  // namespace myoface
