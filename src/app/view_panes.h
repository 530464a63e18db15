// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <QRectF>
#include <QString>

namespace myoface {

/// How many sides of the face the view shows at once.
enum class ViewLayout { One, Two, Four };

/// A part of the view: which camera looks at what, and where [px].
struct ViewPane {
    QRectF area;
    int camera = 0;
    bool before = false;  ///< shows the state before, beside the one of now
};

/// All parts, in the order of their cameras; a part of before comes ahead of that of now.
std::vector<ViewPane> viewPanes(ViewLayout layout, bool sideBySide, const QSizeF& size);

/// What the cameras of a layout show at first.
std::vector<QString> viewsOf(ViewLayout layout);

/// How far a pane's width limits the size of a head, 0 … 1. Several views show its sides too.
double headFit(const QRectF& pane, ViewLayout layout);

}  // namespace myoface
