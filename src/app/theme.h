// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>
#include <QColor>

namespace myoface {

enum class Theme { Dark, Light };

/// A calm look in which the face is the brightest thing (dark), or one for bright rooms (light).
void applyTheme(QApplication& application, Theme theme);

/// What the theme in use paints with, where a palette has no name for it.
struct ThemeColours {
    QColor quiet;                    ///< words of second rank
    QColor viewTop, viewBottom;      ///< behind the face
    QColor plot, plotInk, plotBand;  ///< small diagrams
    QColor before, now, warn;        ///< in diagrams
};
const ThemeColours& themeColours();

}  // namespace myoface
