// SPDX-License-Identifier: Apache-2.0
#include "view_panes.h"

#include <algorithm>

namespace myoface {

std::vector<QString> viewsOf(ViewLayout layout) {
    const std::vector<QString> all{QStringLiteral("front"), QStringLiteral("left"),
                                   QStringLiteral("three-quarter-left"), QStringLiteral("below")};
    const int count = layout == ViewLayout::One ? 1 : layout == ViewLayout::Two ? 2 : 4;
    return {all.begin(), all.begin() + count};
}

std::vector<ViewPane> viewPanes(ViewLayout layout, bool sideBySide, const QSizeF& size) {
    // Two views stand beside each other in a wide widget, else in rows; so do both with before and
    // now beside each other.
    const bool twoRows =
        layout == ViewLayout::Two && (sideBySide || size.width() < 1.15 * size.height());
    const bool four = layout == ViewLayout::Four;
    const int columns = four || (layout == ViewLayout::Two && !twoRows) ? 2 : 1;
    const int rows = four || twoRows ? 2 : 1;
    const double width = size.width() / columns;
    const double height = size.height() / rows;
    std::vector<ViewPane> panes;
    for (int camera = 0; camera < rows * columns; ++camera) {
        const int row = camera / columns, column = camera % columns;
        const QRectF area(column * width, row * height, width, height);
        if (sideBySide) {
            panes.push_back({QRectF(area.x(), area.y(), 0.5 * width, height), camera, true});
            panes.push_back(
                {QRectF(area.x() + 0.5 * width, area.y(), 0.5 * width, height), camera, false});
        } else {
            panes.push_back({area, camera, false});
        }
    }
    return panes;
}

double headFit(const QRectF& pane, ViewLayout layout) {
    // Seen from before, a head is much narrower than high; from the side it is not.
    const double head = layout == ViewLayout::One ? 0.7 : 0.95;
    return std::min(1.0, pane.width() / std::max(head * pane.height(), 1.0));
}

}  // namespace myoface
