// SPDX-License-Identifier: Apache-2.0
// Mouse and keys of the view.
#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>

#include "face_view.h"

namespace myoface {
namespace {
constexpr double kOrbitPerPixel = 0.0075;  // [rad]
constexpr double kClickSlack = 4.0;        // a press that moved less is a click [px]
}  // namespace

bool FaceView::onWipe(const QPointF& at) const {
    constexpr double kReach = 8.0;  // [px]
    const QRectF area = paneAt(at).area;
    return m_compare == CompareMode::Wipe &&
           std::abs(at.x() - area.left() - m_wipe * area.width()) < kReach;
}

/// What the tool does where the left button goes down. @return whether there is skin
bool FaceView::beginOnSkin(const QPointF& at) {
    const auto hit = hitAt(at);
    if (!hit) {
        return false;
    }
    if (m_tool == Tool::Volume || m_tool == Tool::Measure || m_tool == Tool::Section) {
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

void FaceView::mousePressEvent(QMouseEvent* event) {
    m_last = m_pressed = event->localPos();
    if (m_turning.isActive()) {
        m_turning.stop();
        Q_EMIT turningEnded();
    }
    if (m_action == Action::Radius) {
        m_action = Action::None;  // taken
        return;
    }
    if (m_action == Action::Grip) {
        return;
    }
    if (const ViewPane pane = paneAt(m_last); m_action == Action::None) {
        m_active = static_cast<std::size_t>(pane.camera);
        update();
    }
    const bool turn = (event->modifiers() & Qt::AltModifier) != 0;
    const bool shift = (event->modifiers() & Qt::ShiftModifier) != 0;
    if (event->button() == Qt::MiddleButton) {
        m_action = shift ? Action::Pan : Action::Orbit;
    } else if (event->button() == Qt::RightButton) {
        m_action = Action::Pan;
    } else if (event->button() == Qt::LeftButton) {
        m_action = Action::Orbit;
        if (onWipe(m_last)) {
            m_action = Action::Wipe;
        } else if (m_pickMode) {
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
    const QPointF by = at - m_last;
    m_last = at;
    switch (m_action) {
        case Action::Wipe:
            setWipe((at.x() - livePane().area.left()) / std::max(livePane().area.width(), 1.0));
            Q_EMIT wipeMoved(m_wipe);
            break;
        case Action::Radius:
            Q_EMIT radiusMoved((at.x() - m_pressed.x()) *
                               camera().mm_per_pixel(static_cast<int>(livePane().area.height())));
            break;
        case Action::Brush:
            if (const auto hit = hitAt(at)) {
                Q_EMIT brushed(hit->where);
            }
            break;
        case Action::MaybePlace:
        case Action::MaybePick:
            if (QPointF(at - m_pressed).manhattanLength() > kClickSlack) {
                m_action = m_tool == Tool::Section && m_action == Action::MaybePlace
                               ? Action::Knife
                               : Action::Orbit;
            }
            break;
        case Action::Knife:
            m_knife = QLineF(m_pressed, at);
            update();
            break;
        case Action::Orbit:
            changeCameras([&](Camera& camera) {
                orbit(camera, kOrbitPerPixel * by.x(), kOrbitPerPixel * by.y());
            });
            break;
        case Action::Pan: {
            Camera moving = camera();
            pan(moving, by.x(), by.y(), static_cast<int>(livePane().area.height()));
            const Vec3 target = moving.target - camera().target;
            changeCameras([&](Camera& camera) { camera.target += target; });
            break;
        }
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
            if (onWipe(at)) {
                setCursor(Qt::SplitHCursor);
                break;
            }
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
    } else if (action == Action::Knife) {
        cut(event->localPos());
    } else if (action == Action::Brush) {
        Q_EMIT brushEnded();
    } else if (action == Action::MaybePlace) {
        if (const auto hit = hitAt(event->localPos())) {
            if (m_tool == Tool::Measure) {
                Q_EMIT measured(hit->where);
            } else if (m_tool == Tool::Section) {
                Q_EMIT sectionPlaced(hit->where);
            } else {
                Q_EMIT placed(hit->where);
            }
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

/// The plane that a line drawn across the view stands for.
void FaceView::cut(const QPointF& to) {
    m_knife.reset();
    update();
    const ViewRay from = rayAt(m_pressed);
    const ViewRay end = rayAt(to);
    const double away = camera().distance;
    const Vec3 first = from.origin + away * from.direction;
    const Vec3 normal = (first - from.origin).cross(end.origin + away * end.direction - first);
    if (normal.norm() > 1e-6) {
        Q_EMIT sectionDrawn(first, normal.normalized());
    }
}

void FaceView::wheelEvent(QWheelEvent* event) {
    zoomTowards(event->position(), std::pow(1.12, event->angleDelta().y() / 120.0));
}

/// Two fingers on a touch pad.
bool FaceView::event(QEvent* event) {
    if (event->type() == QEvent::NativeGesture) {
        const auto* gesture = static_cast<QNativeGestureEvent*>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture) {
            zoomTowards(gesture->localPos(), std::clamp(1.0 + gesture->value(), 0.5, 2.0));
            return true;
        }
    }
    return QOpenGLWidget::event(event);
}

/// The point at a place of the view stays there.
void FaceView::zoomTowards(const QPointF& at, double factor) {
    if (m_action == Action::None) {
        m_active = static_cast<std::size_t>(paneAt(at).camera);
    }
    const ViewRay before = rayAt(at);
    const Vec3 forward = camera().orientation * -Vec3::UnitZ();
    const double depth =
        (camera().target - before.origin).dot(forward) / before.direction.dot(forward);
    const Vec3 under = before.origin + depth * before.direction;
    Camera nearer = camera();
    zoom(nearer, factor);
    const Vec3 target = under + nearer.distance / camera().distance * (camera().target - under);
    const Vec3 shift = target - camera().target;
    changeCameras([&](Camera& camera) {
        zoom(camera, factor);
        camera.target += shift;
    });
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
    if (event->key() == Qt::Key_Escape && m_tool == Tool::Measure) {
        Q_EMIT measureEnded();
    }
    if (event->key() == Qt::Key_Escape && m_action == Action::Grip) {
        m_action = Action::None;
        updateCursor(false);
        Q_EMIT released(false, false);
    } else if (event->key() == Qt::Key_Escape && m_action == Action::Knife) {
        m_action = Action::None;
        m_knife.reset();
        update();
    } else if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        Q_EMIT beforeHeld(true);
    } else if (event->key() == Qt::Key_Home) {
        frameAgain();
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
