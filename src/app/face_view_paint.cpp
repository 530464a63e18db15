// SPDX-License-Identifier: Apache-2.0
// clang-format off: epoxy must come before any header of Qt that may bring another OpenGL loader
#include <epoxy/gl.h>
// clang-format on
#include <algorithm>
#include <cmath>

#include <QElapsedTimer>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QPainterPath>

#include "face_view.h"
#include "renderer.h"

namespace myoface {
namespace {

double g_drawingTime = 0.0;  // [ms], of all views

/// Adds how long a scope lasts to the time that drawing takes.
class DrawingClock {
public:
    DrawingClock() { m_clock.start(); }
    ~DrawingClock() { g_drawingTime += static_cast<double>(m_clock.nsecsElapsed()) / 1e6; }
    DrawingClock(const DrawingClock&) = delete;
    DrawingClock& operator=(const DrawingClock&) = delete;

private:
    QElapsedTimer m_clock;
};

/// Words on a dark plate, kept inside an area.
void drawTag(QPainter& painter, const QRectF& inside, const QPointF& centre, const QString& text) {
    const QFontMetricsF metrics(painter.font());
    QRectF box(0.0, 0.0, metrics.horizontalAdvance(text) + 16.0, metrics.height() + 8.0);
    box.moveCenter(centre);
    box.moveLeft(std::clamp(box.left(), inside.left() + 4.0,
                            std::max(inside.left() + 4.0, inside.right() - box.width() - 4.0)));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 24, 30, 205));
    painter.drawRoundedRect(box, 5.0, 5.0);
    painter.setPen(QColor(232, 236, 240));
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace

double FaceView::drawingTime() {
    return g_drawingTime;
}

void FaceView::paintGL() {
    const DrawingClock clock;
    const double ratio = devicePixelRatioF();
    const int w = static_cast<int>(std::lround(width() * ratio));
    const int h = static_cast<int>(std::lround(height() * ratio));
    if (!m_renderer) {
        return;
    }
    drawScenes(ratio);
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

void FaceView::drawScenes(double ratio) {
    static const SceneData kEmpty;
    m_renderer->style = m_style;
    const SceneData& now = m_scene != nullptr ? m_scene->scene() : kEmpty;
    const bool compares = m_compare != CompareMode::Off && m_beforeScene;
    if (compares && !m_beforeRenderer) {
        m_beforeRenderer = std::make_unique<Renderer>();
        m_beforeRenderer->initialise();
    }
    if (compares) {
        m_beforeRenderer->style = m_style;
    }
    const auto pixels = static_cast<float>(ratio);
    const int bottom = static_cast<int>(std::lround(height() * ratio));
    for (const ViewPane& part : panes()) {
        const auto at = [&](double value) { return static_cast<int>(std::lround(value * ratio)); };
        const int left = at(part.area.left());
        const int right = at(part.area.right());
        Pane pane{left, bottom - at(part.area.bottom()), right - left,
                  at(part.area.bottom()) - at(part.area.top())};
        const Camera& camera = cameraOf(part);
        if (part.before) {
            m_beforeRenderer->draw(*m_beforeScene, camera, pane, pixels);
            continue;
        }
        pane.clip_to = right;
        if (compares && m_compare == CompareMode::Wipe) {
            const int edge = at(part.area.left() + m_wipe * part.area.width());
            Pane early = pane;
            early.clip_to = edge;
            m_beforeRenderer->draw(*m_beforeScene, camera, early, pixels);
            pane.clip_from = edge;
        }
        m_renderer->draw(now, camera, pane, pixels);
        if (compares && m_compare == CompareMode::Ghost) {
            pane.over = true;
            m_beforeRenderer->draw(*m_beforeScene, camera, pane, pixels);
        }
    }
}

/// Labels of places, titles of both states, the wipe's line and the legend.
void FaceView::drawWords(QPainter& painter) {
    const std::vector<ViewPane> all = panes();
    for (const ViewPane& pane : all) {
        drawPaneWords(painter, pane);
    }
    if (all.size() > 1) {
        painter.setPen(QPen(QColor(255, 255, 255, 70), 1.0));
        for (const ViewPane& pane : all) {
            if (pane.area.left() > 0.5) {
                painter.drawLine(pane.area.topLeft(), pane.area.bottomLeft());
            }
            if (pane.area.top() > 0.5) {
                painter.drawLine(pane.area.topLeft(), pane.area.topRight());
            }
        }
    }
    if (m_layout != ViewLayout::One) {
        painter.setPen(QPen(QColor(89, 199, 255, 150), 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(livePane().area.adjusted(1.0, 1.0, -1.5, -1.5));
    }
    if (m_knife) {
        painter.setPen(QPen(QColor(255, 255, 255, 200), 1.5, Qt::DashLine));
        painter.drawLine(*m_knife);
    }
    if (!m_legend.isEmpty()) {
        const auto live =
            std::find_if(all.begin(), all.end(), [](const ViewPane& pane) { return !pane.before; });
        drawLegend(painter, {live->area.x(), 0.0, width() - live->area.x(), double(height())});
    }
}

void FaceView::drawPaneWords(QPainter& painter, const ViewPane& pane) {
    const QRectF& area = pane.area;
    if (!pane.before) {
        const auto tag = [&](const ViewLabel& label) {
            const PixelPoint p = pixelOf(label.at, pane);
            if (area.contains(QPointF(p.x, p.y))) {
                drawTag(painter, area, {p.x, p.y - 20.0}, label.text);
            }
        };
        std::for_each(m_labels.begin(), m_labels.end(), tag);
        if (m_handLabel) {
            tag(*m_handLabel);
        }
    }
    const double top = area.top() + 22.0;
    const double middle = area.center().x();
    if (m_compare == CompareMode::SideBySide) {
        drawTag(painter, area, {middle, top}, pane.before ? m_beforeTitle : tr("now"));
    } else if (m_compare == CompareMode::Wipe) {
        const double x = area.left() + m_wipe * area.width();
        painter.setPen(QPen(QColor(255, 255, 255, 190), 1.5));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setBrush(QColor(245, 248, 250));
        painter.setPen(Qt::NoPen);
        const double y = area.center().y();
        painter.drawEllipse(QPointF(x, y), 13.0, 13.0);
        painter.setPen(QPen(QColor(40, 46, 54), 2.0, Qt::SolidLine, Qt::RoundCap));
        for (const double side : {-1.0, 1.0}) {
            painter.drawLine(QPointF(x + 7.0 * side, y), QPointF(x + 3.5 * side, y - 3.5));
            painter.drawLine(QPointF(x + 7.0 * side, y), QPointF(x + 3.5 * side, y + 3.5));
        }
        drawTag(painter, area, {x - 60.0, top}, m_beforeTitle);
        drawTag(painter, area, {x + 60.0, top}, tr("now"));
    } else if (m_compare == CompareMode::Ghost) {
        drawTag(painter, area, {middle, top}, tr("%1 as a ghost over now").arg(m_beforeTitle));
    }
}

/// Colours and what they mean, in the lower left corner of an area.
void FaceView::drawLegend(QPainter& painter, const QRectF& area) {
    const QRectF bar(area.x() + 18.0, area.bottom() - 46.0, 190.0, 10.0);
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
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setPen(QColor(222, 226, 230));
    const QRectF words = bar.adjusted(0.0, 13.0, 0.0, 16.0);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, m_legendLow);
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, m_legendHigh);
}

void FaceView::drawInset(QPainter& painter) {
    constexpr double kPixelsPerMm = 3.6;
    const QRectF pane = livePane().area;
    const double side = std::min({210.0, 0.5 * pane.width(), 0.5 * pane.height()});  // [px]
    const QRectF frame(pane.right() - side - 14.0, pane.top() + 14.0, side, side);
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

}  // namespace myoface
