// SPDX-License-Identifier: Apache-2.0
#include "theme.h"

#include <QPalette>
#include <QStyleFactory>

namespace myoface {

void applyTheme(QApplication& application) {
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QPalette palette;
    palette.setColor(QPalette::Window, QColor(38, 42, 48));
    palette.setColor(QPalette::WindowText, QColor(222, 226, 230));
    palette.setColor(QPalette::Base, QColor(29, 32, 37));
    palette.setColor(QPalette::AlternateBase, QColor(34, 38, 43));
    palette.setColor(QPalette::Text, QColor(222, 226, 230));
    palette.setColor(QPalette::Button, QColor(50, 55, 62));
    palette.setColor(QPalette::ButtonText, QColor(222, 226, 230));
    palette.setColor(QPalette::ToolTipBase, QColor(50, 55, 62));
    palette.setColor(QPalette::ToolTipText, QColor(232, 236, 240));
    palette.setColor(QPalette::Highlight, QColor(74, 144, 196));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(120, 184, 228));
    palette.setColor(QPalette::Disabled, QPalette::Text, QColor(120, 126, 133));
    palette.setColor(QPalette::Disabled, QPalette::WindowText, QColor(120, 126, 133));
    palette.setColor(QPalette::Disabled, QPalette::ButtonText, QColor(120, 126, 133));
    application.setPalette(palette);
    application.setStyleSheet(QStringLiteral(
        "QDockWidget::title { padding: 7px 10px; background: #22262b; }"
        "QToolBar { border: 0; padding: 4px; spacing: 4px; }"
        "QToolButton { padding: 5px 10px; border-radius: 4px; }"
        "QToolButton:hover { background: #3a4149; }"
        "QToolButton:checked { background: #2f6690; }"
        "QStatusBar { background: #22262b; } QStatusBar::item { border: 0; }"
        "QGroupBox { border: 0; margin-top: 22px; font-weight: bold; }"
        "QGroupBox::title { subcontrol-origin: margin; left: 2px; top: 4px; color: #9fb3c4; }"
        "QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: #171a1e; }"
        "QSlider::sub-page:horizontal { background: #171a1e; border-radius: 2px; }"
        "QSlider::handle:horizontal { width: 14px; height: 14px; margin: -5px 0;"
        " border-radius: 7px; background: #a9bccb; }"
        "QSlider::handle:horizontal:hover { background: #d6e4ef; }"
        "QSlider::handle:horizontal:disabled { background: #565d65; }"
        "QScrollArea { border: 0; }"));
}

}  // namespace myoface
