// SPDX-License-Identifier: Apache-2.0
// clang-format off: epoxy must come before any header of Qt that may bring another OpenGL loader
#include <epoxy/gl.h>
// clang-format on
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <QPainterPath>
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
    if (m_inset) {
        drawInset();
    }
}

void FaceView::drawInset() {
    constexpr int kSide = 210;  // [px]
    constexpr double kPixelsPerMm = 3.6;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame(width() - kSide - 14.0, 14.0, kSide, kSide);
    QPainterPath rounded;
    rounded.addRoundedRect(frame, 8.0, 8.0);
    painter.fillPath(rounded, QColor(20, 24, 30, 215));
    painter.setPen(QColor(141, 153, 165));
    painter.drawText(frame.adjusted(10, 6, -10, -6), Qt::AlignTop | Qt::AlignLeft,
                     tr("from the side"));
    painter.setClipPath(rounded);
    painter.translate(frame.center());
    painter.scale(kPixelsPerMm, -kPixelsPerMm);
    painter.translate(-m_inset->point);
    const auto lines = [&](const QVector<QLineF>& segments, const QColor& colour, double width) {
        painter.setPen(QPen(colour, width / kPixelsPerMm, Qt::SolidLine, Qt::RoundCap));
        painter.drawLines(segments);
    };
    lines(m_inset->bone, QColor(206, 192, 160), 1.4);
    lines(m_inset->before, QColor(125, 134, 146), 1.4);
    lines(m_inset->now, QColor(235, 240, 245), 2.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(89, 199, 255));
    painter.drawEllipse(m_inset->point, 4.0 / kPixelsPerMm, 4.0 / kPixelsPerMm);
    painter.resetTransform();
    painter.setClipping(false);
    painter.setPen(QColor(141, 153, 165));
    const double bar = 10.0 * kPixelsPerMm;
    const QPointF foot = frame.bottomRight() - QPointF(12.0 + bar, 12.0);
    painter.drawLine(foot, foot + QPointF(bar, 0.0));
    painter.drawText(QRectF(foot - QPointF(0.0, 18.0), QSizeF(bar, 16.0)), Qt::AlignCenter,
                     tr("10 mm"));
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

/// What the tool does where the left button goes down. @return whether there is skin
bool FaceView::beginOnSkin(const QPointF& at) {
    const auto hit = hitAt(at);
    if (!hit) {
        return false;
    }
    if (m_tool == Tool::Volume) {
        m_action = Action::MaybePlace;
    } else if (m_tool == Tool::Protect) {
        m_action = Action::Brush;
        Q_EMIT brushed(hit->where);
    } else {
        m_action = Action::Grip;
        Q_EMIT gripped(hit->where, rayAt(at));
    }
    return true;
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

void FaceView::mousePressEvent(QMouseEvent* event) {
    m_last = m_pressed = event->localPos();
    if (m_action == Action::Radius) {
        m_action = Action::None;  // taken
        return;
    }
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
            beginOnSkin(m_last);
        }
    }
    updateCursor(m_action == Action::Grip);
}

void FaceView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->localPos();
    const QPointF moved = at - m_last;
    m_last = at;
    switch (m_action) {
        case Action::Radius:
            Q_EMIT radiusMoved((at.x() - m_pressed.x()) * 2.0 * m_camera.distance *
                               std::tan(0.5 * m_camera.field_of_view) / std::max(height(), 1));
            break;
        case Action::Brush:
            if (const auto hit = hitAt(at)) {
                Q_EMIT brushed(hit->where);
            }
            break;
        case Action::MaybePlace:
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
        Q_EMIT released(true, (event->modifiers() & Qt::ShiftModifier) != 0);
    } else if (action == Action::MaybePlace) {
        if (const auto hit = hitAt(event->localPos())) {
            Q_EMIT placed(hit->where);
        }
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

bool FaceView::nudgeKey(const QKeyEvent& event) {
    const double steps = (event.modifiers() & Qt::ShiftModifier) != 0 ? 10.0 : 1.0;
    switch (event.key()) {
        case Qt::Key_Left:
            Q_EMIT nudged(-steps, 0.0);
            return true;
        case Qt::Key_Right:
            Q_EMIT nudged(steps, 0.0);
            return true;
        case Qt::Key_Up:
            Q_EMIT nudged(0.0, steps);
            return true;
        case Qt::Key_Down:
            Q_EMIT nudged(0.0, -steps);
            return true;
        default:
            return false;
    }
}

void FaceView::keyPressEvent(QKeyEvent* event) {
    if (m_action == Action::Radius &&
        (event->key() == Qt::Key_Escape || event->key() == Qt::Key_Return)) {
        m_action = Action::None;
        if (event->key() == Qt::Key_Escape) {
            Q_EMIT radiusCancelled();
        }
        return;
    }
    if (m_action == Action::None && !m_pickMode) {
        if (nudgeKey(*event)) {
            return;
        }
        if (event->key() == Qt::Key_X) {
            Q_EMIT mirrorToggled();
            return;
        }
        if (event->key() == Qt::Key_F && m_tool != Tool::Navigate) {
            m_pressed = mapFromGlobal(QCursor::pos());
            m_action = Action::Radius;
            Q_EMIT radiusStarted();
            return;
        }
    }
    if (event->key() == Qt::Key_Escape && m_pickMode) {
        Q_EMIT pickCancelled();
    }
    if (event->key() == Qt::Key_Escape && m_action == Action::Grip) {
        m_action = Action::None;
        updateCursor(false);
        Q_EMIT released(false, false);
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
