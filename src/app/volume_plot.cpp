// SPDX-License-Identifier: Apache-2.0
#include "volume_plot.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QLocale>
#include <QPainter>

#include "language.h"
#include "theme.h"

namespace myoface {

VolumePlot::VolumePlot(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Volume by region"));
    setToolTip(tr("Millilitres that came to each region since before, or went from it"));
}

void VolumePlot::setVolumes(const std::map<Region, double>& millilitres) {
    m_volumes = millilitres;
    update();
}

void VolumePlot::paintEvent(QPaintEvent*) {
    const ThemeColours& colours = themeColours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.plot);
    painter.drawRoundedRect(rect(), 6.0, 6.0);
    constexpr double kLeast = 0.02;  // what is less is not worth a bar [mL]
    std::vector<std::pair<Region, double>> rows;
    double sum = 0.0;
    for (const auto& [region, ml] : m_volumes) {
        sum += ml;
        if (std::abs(ml) >= kLeast) {
            rows.emplace_back(region, ml);
        }
    }
    painter.setPen(colours.plotInk);
    if (rows.empty()) {
        painter.drawText(rect(), Qt::AlignCenter, tr("No volume has changed."));
        return;
    }
    std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
        return std::abs(a.second) > std::abs(b.second);
    });
    const QFontMetricsF metrics(painter.font());
    const double row = metrics.height() + 5.0;
    const auto fit = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::max(0.0, (height() - 18.0) / row - 1.0)));
    rows.resize(std::min(rows.size(), fit));
    double most = 0.0;
    double names = 0.0;
    for (const auto& [region, ml] : rows) {
        most = std::max(most, std::abs(ml));
        names = std::max(names, metrics.horizontalAdvance(inWords(region_name(region))));
    }
    const QLocale locale;
    const auto number = [&](double ml) {
        return QLatin1String(ml > 0.0 ? "+" : "") + locale.toString(ml, 'f', 2);
    };
    constexpr double kMargin = 10.0;  // [px]
    const double numbers = metrics.horizontalAdvance(QStringLiteral("+00.00"));
    const QRectF bars(kMargin + names + 8.0, 8.0, width() - 2.0 * kMargin - names - numbers - 16.0,
                      height() - 16.0);
    const double middle = bars.center().x();
    double y = bars.top();
    for (const auto& [region, ml] : rows) {
        const QRectF line(kMargin, y, width() - 2.0 * kMargin, row);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, inWords(region_name(region)));
        painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, number(ml));
        const double length = 0.5 * bars.width() * ml / most;
        painter.setPen(Qt::NoPen);
        painter.setBrush(ml > 0.0 ? colours.warn : colours.now);
        painter.drawRect(QRectF(middle, y + 0.22 * row, length, 0.56 * row).normalized());
        y += row;
    }
    painter.setPen(QPen(colours.plotInk, 1.0));
    painter.drawLine(QPointF(middle, bars.top()), QPointF(middle, y));
    painter.drawText(QRectF(kMargin, y, width() - 2.0 * kMargin, row),
                     Qt::AlignRight | Qt::AlignVCenter, tr("in all %1 mL").arg(number(sum)));
}

}  // namespace myoface
