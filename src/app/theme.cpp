// SPDX-License-Identifier: Apache-2.0
#include "theme.h"

#include <QPalette>
#include <QStyleFactory>

namespace myoface {
namespace {

/// The tones that everything is painted with.
struct Tones {
    const char *window, *base, *alternate, *button, *text, *disabled, *bar, *groove, *handle,
        *handleHover, *hover, *checked, *group, *link;
};

constexpr Tones kDark{"#262a30", "#1d2025", "#22262b", "#32373e", "#dee2e6", "#787e85", "#22262b",
                      "#171a1e", "#a9bccb", "#d6e4ef", "#3a4149", "#2f6690", "#9fb3c4", "#78b8e4"};
constexpr Tones kLight{"#f1f3f5", "#ffffff", "#f6f8fa", "#e6eaee", "#22272d", "#98a0a8", "#e6eaee",
                       "#c9d1d8", "#4f7b9e", "#2f6690", "#d9e0e7", "#a8cbe6", "#44627c", "#1f6fb0"};

const ThemeColours kDarkColours{{"#8d99a5"}, {"#373c44"}, {"#16181c"}, {"#1d2025"}, {"#8d99a5"},
                                {"#2f3e4c"}, {"#7d8692"}, {"#59c7ff"}, {"#f0b356"}};
const ThemeColours kLightColours{{"#66717c"}, {"#f4f6f8"}, {"#cfd6dd"}, {"#ffffff"}, {"#66717c"},
                                 {"#dbe7f1"}, {"#8d97a1"}, {"#1f78b8"}, {"#b4650a"}};
const ThemeColours* inUse = &kDarkColours;

QString sheet(const Tones& t) {
    QString text = QStringLiteral(
        "QDockWidget::title { padding: 7px 10px; background: @bar; }"
        "QToolBar { border: 0; padding: 4px; spacing: 4px; }"
        "QToolButton { padding: 5px 8px; border-radius: 4px; }"
        "QToolButton:hover { background: @hover; }"
        "QToolButton:checked { background: @checked; }"
        "QToolBar#steps { background: @bar; padding: 5px 8px; }"
        "QToolBar#steps QToolButton { padding: 6px 14px; font-weight: bold; }"
        "QStatusBar { background: @bar; } QStatusBar::item { border: 0; }"
        "QGroupBox { border: 0; margin-top: 22px; font-weight: bold; }"
        "QGroupBox::title { subcontrol-origin: margin; left: 2px; top: 4px; color: @group; }"
        "QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: @groove; }"
        "QSlider::sub-page:horizontal { background: @groove; border-radius: 2px; }"
        "QSlider::handle:horizontal { width: 14px; height: 14px; margin: -5px 0;"
        " border-radius: 7px; background: @knob; }"
        "QSlider::handle:horizontal:hover { background: @over; }"
        "QSlider::handle:horizontal:disabled { background: @disabled; }"
        "QTabWidget::pane { border: 0; }"
        "QTabBar { qproperty-drawBase: 0; }"
        "QTabBar::tab { padding: 6px 14px; border: 0; border-radius: 4px; margin-right: 4px; }"
        "QTabBar::tab:hover { background: @hover; }"
        "QTabBar::tab:selected { background: @checked; }"
        "QToolTip { color: @text; background: @button; border: 1px solid @groove; padding: 4px; }"
        "QScrollArea { border: 0; }");
    const std::pair<const char*, const char*> names[] = {
        {"@bar", t.bar},          {"@hover", t.hover},       {"@checked", t.checked},
        {"@group", t.group},      {"@groove", t.groove},     {"@knob", t.handle},
        {"@over", t.handleHover}, {"@disabled", t.disabled}, {"@text", t.text},
        {"@button", t.button}};
    for (const auto& [name, colour] : names) {
        text.replace(QLatin1String(name), QLatin1String(colour));
    }
    return text;
}

}  // namespace

void applyTheme(QApplication& application, Theme theme) {
    const Tones& t = theme == Theme::Dark ? kDark : kLight;
    inUse = theme == Theme::Dark ? &kDarkColours : &kLightColours;
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QPalette palette;
    const auto set = [&](std::initializer_list<QPalette::ColorRole> roles, const char* colour) {
        for (const QPalette::ColorRole role : roles) {
            palette.setColor(role, QColor(QLatin1String(colour)));
        }
    };
    set({QPalette::Window}, t.window);
    set({QPalette::Base}, t.base);
    set({QPalette::AlternateBase}, t.alternate);
    set({QPalette::Button, QPalette::ToolTipBase}, t.button);
    set({QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText},
        t.text);
    set({QPalette::Link}, t.link);
    palette.setColor(QPalette::Highlight, QColor(74, 144, 196));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::PlaceholderText, QColor(QLatin1String(t.disabled)));
    for (const QPalette::ColorRole role :
         {QPalette::Text, QPalette::WindowText, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, QColor(QLatin1String(t.disabled)));
    }
    application.setPalette(palette);
    application.setStyleSheet(sheet(t));
}

const ThemeColours& themeColours() {
    return *inUse;
}

}  // namespace myoface
