// SPDX-License-Identifier: Apache-2.0
// clang-format off: epoxy must come before any header of Qt that may bring another OpenGL loader
#include <epoxy/gl.h>
// clang-format on
#include <algorithm>
#include <cmath>

#include <QOpenGLContext>

#include "myoface/base/error.h"

#include "face_view.h"
#include "renderer.h"

namespace myoface {
namespace {
constexpr double kTurnPerFrame = 0.012;  // [rad]
}  // namespace

FaceView::FaceView(QWidget* parent) : QOpenGLWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Face"));
    m_turning.setInterval(33);
    connect(&m_turning, &QTimer::timeout, this,
            [this] { changeCameras([](Camera& camera) { orbit(camera, kTurnPerFrame, 0.0); }); });
}

FaceView::~FaceView() {
    releaseRenderer();
}

void FaceView::releaseRenderer() {
    for (std::unique_ptr<Renderer>* renderer : {&m_renderer, &m_beforeRenderer}) {
        if (*renderer) {
            makeCurrent();
            (*renderer)->release();
            renderer->reset();
            doneCurrent();
        }
    }
}

void FaceView::setCompare(CompareMode mode, std::shared_ptr<const SceneData> before,
                          const QString& title) {
    const double fitted = fit();
    m_compare = before ? mode : CompareMode::Off;
    for (Camera& camera : m_cameras) {
        camera.distance *= fitted / fit();  // the head fills its part of the view as it did
    }
    m_beforeScene = std::move(before);
    m_beforeTitle = title;
    if (m_beforeRenderer) {  // its buffers belong to another picture
        makeCurrent();
        m_beforeRenderer->release();
        m_beforeRenderer.reset();
        doneCurrent();
    }
    update();
}

void FaceView::setWipe(double share) {
    m_wipe = std::clamp(share, 0.0, 1.0);
    update();
}

void FaceView::setLegend(const QVector<QColor>& colours, const QString& low, const QString& high) {
    m_legend = colours;
    m_legendLow = low;
    m_legendHigh = high;
    update();
}

void FaceView::setCamera(const Camera& camera) {
    m_cameras[m_active] = camera;
    update();
}

void FaceView::moved() {
    update();
    Q_EMIT cameraMoved();
}

void FaceView::setLayout(ViewLayout layout) {
    if (layout == m_layout) {
        return;
    }
    const Camera used = camera();
    const double fitted = fit();
    m_layout = layout;
    m_active = 0;
    const std::vector<QString> views = viewsOf(layout);
    for (std::size_t c = 0; c < views.size(); ++c) {
        m_cameras[c] = used;
        m_cameras[c].distance *= fitted / fit();
        if (layout != ViewLayout::One) {
            m_cameras[c].orientation = standard_view(views[c].toStdString());
        }
    }
    moved();
}

ViewPane FaceView::paneAt(const QPointF& at) const {
    const std::vector<ViewPane> all = panes();
    for (const ViewPane& pane : all) {
        if (pane.area.contains(at)) {
            return pane;
        }
    }
    return all.front();
}

ViewPane FaceView::livePane() const {
    const std::vector<ViewPane> all = panes();
    const auto found = std::find_if(all.begin(), all.end(), [this](const ViewPane& pane) {
        return !pane.before && pane.camera == static_cast<int>(m_active);
    });
    return found != all.end() ? *found : all.back();
}

void FaceView::setScene(FaceScene* scene) {
    m_scene = scene;
    update();
}

void FaceView::setSkin(const TriangleMesh& skin, Bvh bvh) {
    m_skin = skin;
    m_bvh = std::move(bvh);
    m_bvhStale = false;
}

void FaceView::setSkinPositions(const Points& positions) {
    m_skin.vertices = positions.leftCols(m_skin.vertices.cols());
    m_bvhStale = true;
}

void FaceView::setTool(Tool tool) {
    m_tool = tool;
    updateCursor(false);
}

void FaceView::setPickMode(bool on) {
    m_pickMode = on;
    updateCursor(false);
}

void FaceView::showStandardView(const QString& name) {
    Camera& camera = m_cameras[m_active];
    camera.orientation = standard_view(name.toStdString());
    camera.target = m_homeCentre;
    moved();
}

void FaceView::frameFace(const Vec3& centre, double radius) {
    m_homeCentre = centre;
    m_homeRadius = radius;
    for (Camera& camera : m_cameras) {
        frame(camera, centre, radius, fit());
    }
    moved();
}

void FaceView::setOrthographic(bool on) {
    for (Camera& camera : m_cameras) {
        camera.orthographic = on;
    }
    moved();
}

void FaceView::setClinicalLight(bool on) {
    m_style.clinical_light = on;
    update();
}

void FaceView::setTextured(bool on) {
    m_style.textured = on;
    update();
}

void FaceView::setWireframe(bool on) {
    m_style.wireframe = on;
    update();
}

void FaceView::setTurning(bool on) {
    if (on) {
        m_turning.start();
    } else {
        m_turning.stop();
    }
}

void FaceView::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &FaceView::releaseRenderer);
    try {
        m_renderer = std::make_unique<Renderer>();
        m_renderer->initialise();
    } catch (const Error& error) {
        m_renderer.reset();
        Q_EMIT drawingFailed(QString::fromUtf8(error.what()));
    }
}

ViewRay FaceView::rayAt(const QPointF& at) const {
    // A hand that holds something stays in the part where it took it.
    const ViewPane pane = m_action == Action::None ? paneAt(at) : livePane();
    return view_ray(cameraOf(pane), at.x() - pane.area.x(), at.y() - pane.area.y(),
                    static_cast<int>(pane.area.width()), static_cast<int>(pane.area.height()));
}

PixelPoint FaceView::pixelOf(const Vec3& point, const ViewPane& pane) const {
    PixelPoint p = project(cameraOf(pane), point, static_cast<int>(pane.area.width()),
                           static_cast<int>(pane.area.height()));
    p.x += pane.area.x();
    p.y += pane.area.y();
    return p;
}

std::optional<RayHit> FaceView::hitAt(const QPointF& at) {
    const ViewPane pane = m_action == Action::None ? paneAt(at) : livePane();
    if (m_skin.triangle_count() == 0 || pane.before || !pane.area.contains(at)) {
        return std::nullopt;
    }
    if (m_bvhStale) {
        m_bvh.refit(m_skin);
        m_bvhStale = false;
    }
    return m_bvh.first_hit(m_skin, rayAt(at));
}

void FaceView::updateCursor(bool onSkin) {
    if (m_pickMode) {
        setCursor(onSkin ? Qt::CrossCursor : Qt::ArrowCursor);
    } else if (m_action == Action::Grip || m_action == Action::Handle) {
        setCursor(Qt::ClosedHandCursor);
    } else {
        setCursor(onSkin && m_tool != Tool::Navigate ? Qt::OpenHandCursor : Qt::ArrowCursor);
    }
}

int FaceView::handleAt(const QPointF& at) {
    constexpr double kReach = 11.0;   // [px]
    constexpr double kHidden = 12.0;  // [mm] behind the skin
    int best = -1;
    double nearest = kReach;
    const ViewPane pane = paneAt(at);
    if (pane.before) {
        return -1;
    }
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        const PixelPoint p = pixelOf(m_handles[i], pane);
        const double off = std::hypot(p.x - at.x(), p.y - at.y());
        if (off < nearest) {
            const auto hit = hitAt({p.x, p.y});
            const ViewRay ray = rayAt({p.x, p.y});
            if (!hit || (m_handles[i] - ray.origin).dot(ray.direction) < hit->distance + kHidden) {
                nearest = off;
                best = static_cast<int>(i);
            }
        }
    }
    return best;
}

void FaceView::bringIntoView(const Vec3& point) {
    const auto hit = hitAt([&] {
        const PixelPoint p = pixelOf(point, livePane());
        return QPointF(p.x, p.y);
    }());
    const bool seen = hit && (position(m_skin, hit->where) - point).norm() < 8.0;
    if (!seen) {
        const Vec3 side = point - m_homeCentre;
        showStandardView(std::abs(side.x()) < 25.0 ? QStringLiteral("front")
                         : side.x() > 0.0          ? QStringLiteral("three-quarter-left")
                                                   : QStringLiteral("three-quarter-right"));
    }
    update();
}

std::vector<Vec3> FaceView::ringOnSkin(const SurfacePoint& where, double radius) {
    if (where.triangle < 0 || where.triangle >= m_skin.triangle_count()) {
        return {};
    }
    if (m_bvhStale) {
        m_bvh.refit(m_skin);
        m_bvhStale = false;
    }
    constexpr int kPoints = 40;
    constexpr double kLift = 0.4;  // [mm] off the skin
    const Vec3 centre = position(m_skin, where);
    const Eigen::Matrix<double, 3, 2> plane =
        view_plane(-double_area_vector(m_skin, where.triangle).normalized());
    std::vector<Vec3> ring;
    for (int k = 0; k <= kPoints; ++k) {
        const double turn = 2.0 * 3.14159265358979 * k / kPoints;
        const Vec3 off = radius * (plane * Eigen::Vector2d(std::cos(turn), std::sin(turn)));
        const ClosestPoint found = m_bvh.closest_point(m_skin, centre + off);
        ring.push_back(found.point +
                       kLift * double_area_vector(m_skin, found.where.triangle).normalized());
    }
    return ring;
}

}  // namespace myoface
