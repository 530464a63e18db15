// SPDX-License-Identifier: Apache-2.0
#include "profile_plot.h"

#include <utility>

#include <QPainter>

#include "theme.h"

namespace myoface {

ProfilePlot::ProfilePlot(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Profile before and now"));
    setToolTip(tr("The profile in the midplane: grey before, blue now"));
}

void ProfilePlot::setOutlines(QVector<QLineF> before, QVector<QLineF> now) {
    m_before = std::move(before);
    m_now = std::move(now);
    update();
}

void ProfilePlot::paintEvent(QPaintEvent*) {
    const ThemeColours& colours = themeColours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.plot);
    painter.drawRoundedRect(rect(), 6.0, 6.0);
    if (m_before.isEmpty()) {
        return;
    }
    QRectF bounds;
    for (const QVector<QLineF>* lines : {&m_before, &m_now}) {
        for (const QLineF& line : *lines) {
            bounds |= QRectF(line.p1(), line.p2()).normalized().adjusted(-1e-6, -1e-6, 1e-6, 1e-6);
        }
    }
    constexpr double kMargin = 16.0;  // [px]
    const double scale = std::min((width() - 2.0 * kMargin) / std::max(bounds.width(), 1.0),
                                  (height() - 2.0 * kMargin) / std::max(bounds.height(), 1.0));
    painter.save();
    painter.translate(QRectF(rect()).center());
    painter.scale(scale, -scale);
    painter.translate(-bounds.center());
    const auto draw = [&](const QVector<QLineF>& lines, const QColor& colour, double pixels) {
        painter.setPen(QPen(colour, pixels / scale, Qt::SolidLine, Qt::RoundCap));
        painter.drawLines(lines);
    };
    draw(m_before, colours.before, 1.5);
    draw(m_now, colours.now, 2.0);
    painter.restore();
    const double bar = 20.0 * scale;
    const QPointF foot(width() - kMargin - bar, height() - 10.0);
    painter.setPen(QPen(colours.plotInk, 1.2));
    painter.drawLine(foot, foot + QPointF(bar, 0.0));
    painter.drawText(QRectF(foot - QPointF(20.0, 18.0), QSizeF(bar + 40.0, 16.0)), Qt::AlignCenter,
                     tr("20 mm"));
}

}  // namespace myoface
