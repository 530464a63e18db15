// SPDX-License-Identifier: Apache-2.0
// clang-format off: epoxy must come before any header of Qt that may bring another OpenGL loader
#include <epoxy/gl.h>
// clang-format on
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include "myoface/base/error.h"

#include "face_view.h"
#include "renderer.h"

namespace myoface {
namespace {
constexpr double kOrbitPerPixel = 0.0075;  // [rad]
constexpr double kTurnPerFrame = 0.012;    // [rad]
constexpr double kClickSlack = 4.0;        // a press that moved less is a click [px]
}  // namespace

FaceView::FaceView(QWidget* parent) : QOpenGLWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Face"));
    m_turning.setInterval(33);
    connect(&m_turning, &QTimer::timeout, this, [this] {
        orbit(m_camera, kTurnPerFrame, 0.0);
        moved();
    });
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
    m_camera.distance *= fitted / fit();  // the head fills its part of the view as it did
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
    m_camera = camera;
    update();
}

void FaceView::moved() {
    update();
    Q_EMIT cameraMoved();
}

QRectF FaceView::livePane() const {
    return m_compare == CompareMode::SideBySide
               ? QRectF(0.5 * width(), 0.0, 0.5 * width(), height())
               : QRectF(0.0, 0.0, width(), height());
}

double FaceView::fit() const {
    constexpr double kHead = 0.7;  // a head is that much narrower than high
    const QRectF pane = livePane();
    return std::min(1.0, pane.width() / std::max(kHead * pane.height(), 1.0));
}

bool FaceView::onWipe(const QPointF& at) const {
    constexpr double kReach = 8.0;  // [px]
    return m_compare == CompareMode::Wipe && std::abs(at.x() - m_wipe * width()) < kReach;
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
    moved();
}

void FaceView::frameFace(const Vec3& centre, double radius) {
    m_homeCentre = centre;
    m_homeRadius = radius;
    frame(m_camera, centre, radius, fit());
    moved();
}

void FaceView::setOrthographic(bool on) {
    m_camera.orthographic = on;
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

void FaceView::paintGL() {
    const double ratio = devicePixelRatioF();
    const int w = static_cast<int>(std::lround(width() * ratio));
    const int h = static_cast<int>(std::lround(height() * ratio));
    if (!m_renderer) {
        return;
    }
    drawScenes(w, h, static_cast<float>(ratio));
    // Straight into the framebuffer: a painter on the widget would be led elsewhere in a
    // screenshot.
    QOpenGLPaintDevice device(w, h);
    device.setDevicePixelRatio(ratio);
    QPainter painter(&device);
    painter.setRenderHint(QPainter::Antialiasing);
    drawWords(painter);
    if (m_inset) {
        drawInset(painter);
    }
}

void FaceView::drawScenes(int width, int height, float ratio) {
    static const SceneData kEmpty;
    m_renderer->style = m_style;
    const SceneData& now = m_scene != nullptr ? m_scene->scene() : kEmpty;
    const Pane whole{0, 0, width, height};
    if (m_compare == CompareMode::Off || !m_beforeScene) {
        m_renderer->draw(now, m_camera, whole, ratio);
        return;
    }
    if (!m_beforeRenderer) {
        m_beforeRenderer = std::make_unique<Renderer>();
        m_beforeRenderer->initialise();
    }
    m_beforeRenderer->style = m_style;
    const SceneData& before = *m_beforeScene;
    const int half = width / 2;
    switch (m_compare) {
        case CompareMode::SideBySide:
            m_beforeRenderer->draw(before, m_camera, {0, 0, half, height}, ratio);
            m_renderer->draw(now, m_camera, {half, 0, width - half, height}, ratio);
            break;
        case CompareMode::Wipe: {
            const int edge = static_cast<int>(std::lround(m_wipe * width));
            m_beforeRenderer->draw(before, m_camera, {0, 0, width, height, 0, edge}, ratio);
            m_renderer->draw(now, m_camera, {0, 0, width, height, edge}, ratio);
            break;
        }
        default:
            m_renderer->draw(now, m_camera, whole, ratio);
            m_beforeRenderer->draw(before, m_camera, {0, 0, width, height, 0, width, true}, ratio);
    }
}

/// Labels of places, titles of both states, the wipe's line and the legend.
void FaceView::drawWords(QPainter& painter) {
    const auto tag = [&](const QPointF& centre, const QString& text) {
        const QFontMetricsF metrics(painter.font());
        QRectF box(0.0, 0.0, metrics.horizontalAdvance(text) + 16.0, metrics.height() + 8.0);
        box.moveCenter(centre);
        box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, width() - box.width() - 4.0)));
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(20, 24, 30, 205));
        painter.drawRoundedRect(box, 5.0, 5.0);
        painter.setPen(QColor(232, 236, 240));
        painter.drawText(box, Qt::AlignCenter, text);
    };
    const QRectF live = livePane();
    for (const ViewLabel& label : m_labels) {
        const PixelPoint p = pixelOf(label.at);
        tag({p.x, p.y - 20.0}, label.text);
    }
    const double top = 22.0;
    if (m_compare == CompareMode::SideBySide) {
        tag({0.25 * width(), top}, m_beforeTitle);
        tag({0.75 * width(), top}, tr("now"));
        painter.setPen(QPen(QColor(255, 255, 255, 70), 1.0));
        painter.drawLine(QPointF(0.5 * width(), 0.0), QPointF(0.5 * width(), height()));
    } else if (m_compare == CompareMode::Wipe) {
        const double x = m_wipe * width();
        painter.setPen(QPen(QColor(255, 255, 255, 190), 1.5));
        painter.drawLine(QPointF(x, 0.0), QPointF(x, height()));
        painter.setBrush(QColor(245, 248, 250));
        painter.setPen(Qt::NoPen);
        const double y = 0.5 * height();
        painter.drawEllipse(QPointF(x, y), 13.0, 13.0);
        painter.setPen(QPen(QColor(40, 46, 54), 2.0, Qt::SolidLine, Qt::RoundCap));
        for (const double side : {-1.0, 1.0}) {
            painter.drawLine(QPointF(x + 7.0 * side, y), QPointF(x + 3.5 * side, y - 3.5));
            painter.drawLine(QPointF(x + 7.0 * side, y), QPointF(x + 3.5 * side, y + 3.5));
        }
        tag({x - 60.0, top}, m_beforeTitle);
        tag({x + 60.0, top}, tr("now"));
    } else if (m_compare == CompareMode::Ghost) {
        tag({0.5 * width(), top}, tr("%1 as a ghost over now").arg(m_beforeTitle));
    }
    if (!m_legend.isEmpty()) {
        const QRectF bar(live.x() + 18.0, height() - 46.0, 190.0, 10.0);
        const QRectF plate = bar.adjusted(-10.0, -8.0, 10.0, 28.0);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(20, 24, 30, 205));
        painter.drawRoundedRect(plate, 6.0, 6.0);
        const double step = bar.width() / m_legend.size();
        painter.setRenderHint(QPainter::Antialiasing, false);
        for (int i = 0; i < m_legend.size(); ++i) {
            painter.fillRect(QRectF(bar.x() + i * step, bar.y(), step + 1.0, bar.height()),
                             m_legend[i]);
        }
        painter.setPen(QColor(222, 226, 230));
        const QRectF words = bar.adjusted(0.0, 13.0, 0.0, 16.0);
        painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, m_legendLow);
        painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, m_legendHigh);
    }
}

void FaceView::drawInset(QPainter& painter) {
    constexpr int kSide = 210;  // [px]
    constexpr double kPixelsPerMm = 3.6;
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
    const QRectF pane = livePane();
    return view_ray(m_camera, at.x() - pane.x(), at.y(), static_cast<int>(pane.width()),
                    static_cast<int>(pane.height()));
}

PixelPoint FaceView::pixelOf(const Vec3& point) const {
    const QRectF pane = livePane();
    PixelPoint p =
        project(m_camera, point, static_cast<int>(pane.width()), static_cast<int>(pane.height()));
    p.x += pane.x();
    return p;
}

std::optional<RayHit> FaceView::hitAt(const QPointF& at) {
    if (m_skin.triangle_count() == 0 || !livePane().contains(at)) {
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
        const PixelPoint p = pixelOf(m_handles[i]);
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
        const PixelPoint p = pixelOf(point);
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
    if (m_tool == Tool::Volume || m_tool == Tool::Measure) {
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
            setWipe(at.x() / std::max(width(), 1));
            Q_EMIT wipeMoved(m_wipe);
            break;
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
            orbit(m_camera, kOrbitPerPixel * by.x(), kOrbitPerPixel * by.y());
            moved();
            break;
        case Action::Pan:
            pan(m_camera, by.x(), by.y(), height());
            moved();
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
    } else if (action == Action::Brush) {
        Q_EMIT brushEnded();
    } else if (action == Action::MaybePlace) {
        if (const auto hit = hitAt(event->localPos())) {
            if (m_tool == Tool::Measure) {
                Q_EMIT measured(hit->where);
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
    moved();
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
