// SPDX-License-Identifier: Apache-2.0
// clang-format off: epoxy must come before any header of Qt that may bring another OpenGL loader
#include <epoxy/gl.h>
// clang-format on
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QWheelEvent>

#include "myoface/base/error.h"

#include "face_view.h"
#include "renderer.h"

namespace myoface {
namespace {
constexpr double kOrbitPerPixel = 0.0075;  // [rad]
constexpr double kClickSlack = 4.0;        // a press that moved less is a click [px]
}  // namespace

FaceView::FaceView(QWidget* parent) : QOpenGLWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Face"));
}

FaceView::~FaceView() {
    releaseRenderer();
}

void FaceView::releaseRenderer() {
    if (m_renderer) {
        makeCurrent();
        m_renderer->release();
        m_renderer.reset();
        doneCurrent();
    }
}

void FaceView::setScene(FaceScene* scene) {
    m_scene = scene;
    update();
}

void FaceView::setSkin(const TriangleMesh& skin) {
    m_skin = skin;
    m_bvh = Bvh(m_skin);
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
    m_camera.orientation = standard_view(name.toStdString());
    m_camera.target = m_homeCentre;
    update();
}

void FaceView::frameFace(const Vec3& centre, double radius) {
    m_homeCentre = centre;
    m_homeRadius = radius;
    frame(m_camera, centre, radius, static_cast<double>(width()) / std::max(height(), 1));
    update();
}

void FaceView::setOrthographic(bool on) {
    m_camera.orthographic = on;
    update();
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

void FaceView::paintGL() {
    const double ratio = devicePixelRatioF();
    const int w = static_cast<int>(std::lround(width() * ratio));
    const int h = static_cast<int>(std::lround(height() * ratio));
    if (!m_renderer) {
        return;
    }
    static const SceneData kEmpty;
    m_renderer->draw(m_scene != nullptr ? m_scene->scene() : kEmpty, m_camera, w, h,
                     static_cast<float>(ratio));
}

ViewRay FaceView::rayAt(const QPointF& at) const {
    return view_ray(m_camera, at.x(), at.y(), width(), height());
}

std::optional<RayHit> FaceView::hitAt(const QPointF& at) {
    if (m_skin.triangle_count() == 0) {
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
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        const PixelPoint p = project(m_camera, m_handles[i], width(), height());
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
        const PixelPoint p = project(m_camera, point, width(), height());
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

void FaceView::mousePressEvent(QMouseEvent* event) {
    m_last = m_pressed = event->localPos();
    if (m_action == Action::Grip) {
        return;
    }
    const bool turn = (event->modifiers() & Qt::AltModifier) != 0;
    const bool shift = (event->modifiers() & Qt::ShiftModifier) != 0;
    if (event->button() == Qt::MiddleButton) {
        m_action = shift ? Action::Pan : Action::Orbit;
    } else if (event->button() == Qt::RightButton) {
        m_action = Action::Pan;
    } else if (event->button() == Qt::LeftButton) {
        m_action = Action::Orbit;
        if (m_pickMode) {
            m_action = Action::MaybePick;
        } else if (m_handle = turn ? -1 : handleAt(m_last); m_handle >= 0) {
            m_action = Action::Handle;
            m_handleMoved = false;
            Q_EMIT handlePressed(m_handle);
        } else if (m_tool != Tool::Navigate && !turn) {
            if (const auto hit = hitAt(m_last)) {
                m_action = Action::Grip;
                Q_EMIT gripped(hit->where, rayAt(m_last));
            }
        }
    }
    updateCursor(m_action == Action::Grip);
}

void FaceView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->localPos();
    const QPointF moved = at - m_last;
    m_last = at;
    switch (m_action) {
        case Action::MaybePick:
            if (QPointF(at - m_pressed).manhattanLength() > kClickSlack) {
                m_action = Action::Orbit;
            }
            break;
        case Action::Orbit:
            orbit(m_camera, kOrbitPerPixel * moved.x(), kOrbitPerPixel * moved.y());
            update();
            break;
        case Action::Pan:
            pan(m_camera, moved.x(), moved.y(), height());
            update();
            break;
        case Action::Grip:
            Q_EMIT pulled(rayAt(at));
            break;
        case Action::Handle:
            if (const auto hit = hitAt(at)) {
                m_handleAt = hit->where;
                m_handleMoved = true;
                Q_EMIT handleMoved(m_handle, m_handleAt);
            }
            break;
        default: {
            const std::optional<RayHit> hit = hitAt(at);
            updateCursor(hit.has_value());
            Q_EMIT hovered(rayAt(at), hit ? std::optional(hit->where) : std::nullopt);
        }
    }
}

void FaceView::mouseReleaseEvent(QMouseEvent* event) {
    const Action action = m_action;
    if (action == Action::Grip && event->button() != Qt::LeftButton) {
        return;
    }
    m_action = Action::None;
    if (action == Action::Handle) {
        if (m_handleMoved) {
            Q_EMIT handleDropped(m_handle, m_handleAt);
        }
    } else if (action == Action::Grip) {
        Q_EMIT released(true);
    } else if (action == Action::MaybePick) {
        if (const auto hit = hitAt(event->localPos())) {
            Q_EMIT picked(position(m_skin, hit->where));
        }
    }
    updateCursor(hitAt(event->localPos()).has_value());
}

void FaceView::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event);
}

void FaceView::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    // Zooms towards the point under the cursor.
    const QPointF at = event->position();
    const ViewRay before = rayAt(at);
    const double depth =
        (m_camera.target - before.origin).dot(m_camera.orientation * -Vec3::UnitZ()) /
        before.direction.dot(m_camera.orientation * -Vec3::UnitZ());
    const Vec3 under = before.origin + depth * before.direction;
    const double old = m_camera.distance;
    zoom(m_camera, std::pow(1.12, steps));
    m_camera.target = under + m_camera.distance / old * (m_camera.target - under);
    update();
}

void FaceView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_pickMode) {
        Q_EMIT pickCancelled();
    }
    if (event->key() == Qt::Key_Escape && m_action == Action::Grip) {
        m_action = Action::None;
        updateCursor(false);
        Q_EMIT released(false);
    } else if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        Q_EMIT beforeHeld(true);
    } else if (event->key() == Qt::Key_Home) {
        frameFace(m_homeCentre, m_homeRadius);
    } else {
        QOpenGLWidget::keyPressEvent(event);
    }
}

void FaceView::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        Q_EMIT beforeHeld(false);
    } else {
        QOpenGLWidget::keyReleaseEvent(event);
    }
}

}  // namespace myoface
