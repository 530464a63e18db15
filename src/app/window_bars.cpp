// SPDX-License-Identifier: Apache-2.0
// Tool bars of the main window: steps, tools and views.
#include <tuple>

#include <QActionGroup>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include "action_search.h"
#include "comparison.h"
#include "main_window.h"
#include "measure_panel.h"
#include "window_actions.h"

namespace myoface {
namespace {

/// Tooltips of tool bars say the shortcut too.
void sayShortcut(QAction* action) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    const QString plain = action->property("tip").toString();
    if (!key.isEmpty() && !plain.isEmpty()) {
        action->setToolTip(QStringLiteral("%1 (%2)").arg(plain, key));
    }
}

}  // namespace

void MainWindow::buildSteps() {
    m_steps = {{QStringLiteral("scan"),
                tr("Scan"),
                QStringLiteral("scan"),
                tr("What is in the file: unit, axes, size"),
                {QStringLiteral("scan"), QStringLiteral("layers")}},
               {QStringLiteral("fit"),
                tr("Fit"),
                QStringLiteral("fit"),
                tr("Landmarks, bone and muscles on the scan"),
                {QStringLiteral("landmarks"), QStringLiteral("layers")}},
               {QStringLiteral("shape"),
                tr("Shape"),
                QStringLiteral("shape"),
                tr("What an operation changes"),
                {QStringLiteral("shape"), QStringLiteral("layers"), QStringLiteral("measures"),
                 QStringLiteral("history")}},
               {QStringLiteral("expression"),
                tr("Expression"),
                QStringLiteral("expression"),
                tr("What muscles do"),
                {QStringLiteral("layers"), QStringLiteral("muscles")}},
               {QStringLiteral("compare"),
                tr("Compare"),
                QStringLiteral("compare"),
                tr("Before and after, variants"),
                {QStringLiteral("compare"), QStringLiteral("measures")}},
               {QStringLiteral("report"),
                tr("Report"),
                QStringLiteral("report"),
                tr("Paper, pictures and files"),
                {QStringLiteral("report"), QStringLiteral("measures")}}};
    auto* bar = addToolBar(tr("Steps"));
    bar->setObjectName(QStringLiteral("steps"));
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    m_stepActions = new QActionGroup(this);
    int number = 1;
    for (const TaskStep& step : m_steps) {
        QAction* action = bar->addAction(step.title);
        setIcon(action, step.icon);
        action->setCheckable(true);
        action->setData(step.name);
        action->setObjectName(QStringLiteral("step-") + step.name);
        action->setShortcut(QKeySequence(QStringLiteral("Alt+%1").arg(number++)));
        action->setProperty("tip", step.tip);
        m_stepActions->addAction(action);
        connect(action, &QAction::triggered, this, [this, name = step.name] { showStep(name); });
    }
    auto* gap = new QWidget;
    gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(gap);
    QAction* find = bar->addAction(tr("Find"));
    setIcon(find, QStringLiteral("search"));
    find->setShortcut(QKeySequence(QStringLiteral("Ctrl+K")));
    find->setProperty("tip", tr("Everything by its name"));
    connect(find, &QAction::triggered, this,
            [this] { (new ActionSearch(actionsOf(*this), this))->show(); });
    QAction* patient = bar->addAction(tr("Patient"));
    setIcon(patient, QStringLiteral("patient"));
    patient->setShortcut(QKeySequence(QStringLiteral("F11")));
    patient->setProperty("tip", tr("The face alone, full screen on the other screen"));
    connect(patient, &QAction::triggered, this, &MainWindow::presentToPatient);
    addToolBarBreak();
}

void MainWindow::buildTools() {
    auto* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    auto* tools = new QActionGroup(this);
    struct ToolEntry {
        QString title, tip;
        Tool tool;
        const char *key, *icon;
    };
    for (const ToolEntry& entry :
         {ToolEntry{tr("Turn"), tr("Left drag turns the head"), Tool::Navigate, "Q", "turn"},
          ToolEntry{tr("Shape"),
                    tr("Mouse priority: the skin point follows the cursor, depth comes from the "
                       "tissue, the shape stays"),
                    Tool::Shape, "W", "shape"},
          ToolEntry{tr("Feel"),
                    tr("Constraint priority: a stress pulls at the skin, tissue holds it back, on "
                       "release it springs back"),
                    Tool::Feel, "E", "feel"},
          ToolEntry{tr("Volume"),
                    tr("A click adds the volume that the Shape panel says, under the skin"),
                    Tool::Volume, "R", "volume"},
          ToolEntry{tr("Protect"), tr("Left drag paints skin that gestures leave alone"),
                    Tool::Protect, "T", "protect"},
          ToolEntry{tr("Measure"),
                    tr("Two clicks: distance straight and along the skin; a third: angle"),
                    Tool::Measure, "M", "measure"},
          ToolEntry{
              tr("Section"),
              tr("A click cuts the face level through the place; a line drawn across the face "
                 "cuts along it"),
              Tool::Section, "S", "section"}}) {
        QAction* action = bar->addAction(entry.title);
        setIcon(action, QString::fromLatin1(entry.icon));
        action->setCheckable(true);
        action->setShortcut(QKeySequence(QString::fromLatin1(entry.key)));
        action->setProperty("tip", entry.tip);
        action->setObjectName(QStringLiteral("tool%1").arg(QString::fromLatin1(entry.key)));
        tools->addAction(action);
        connect(action, &QAction::triggered, this, [this, action, tool = entry.tool] {
            m_view->setTool(tool);
            if (tool == Tool::Section) {
                showPanel(QStringLiteral("measures"));
                m_measures->showSections();
            }
            statusBar()->showMessage(action->toolTip(), 8000);
        });
        action->setChecked(entry.tool == Tool::Shape);
    }
    bar->addSeparator();
    const auto signAlone = [bar](QAction* action) {
        if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action))) {
            button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        }
    };
    for (const char* name : {"undo", "redo", "reset"}) {
        auto* action = findChild<QAction*>(QString::fromLatin1(name));
        bar->addAction(action);
        signAlone(action);
    }
    bar->addSeparator();
    for (const auto& [title, name] :
         {std::pair(tr("Front"), "front"), std::pair(tr("Patient's left"), "left"),
          std::pair(tr("Patient's right"), "right"),
          std::pair(tr("Three-quarter left"), "three-quarter-left"),
          std::pair(tr("Three-quarter right"), "three-quarter-right")}) {
        QAction* action = bar->addAction(title);
        setIcon(action, QString::fromLatin1(name));
        signAlone(action);
        connect(action, &QAction::triggered, this,
                [this, n = QString::fromLatin1(name)] { m_view->showStandardView(n); });
    }
    bar->addSeparator();
    QAction* before = bar->addAction(tr("Before"));
    setIcon(before, QStringLiteral("before"));
    before->setCheckable(true);
    before->setProperty("tip",
                        tr("Shows the state before; the space bar does so while it is held"));
    before->setToolTip(before->property("tip").toString());
    connect(before, &QAction::toggled, this, [this](bool held) { m_comparison->holdBefore(held); });
    refreshShortcutTips();
}

void MainWindow::refreshIcons() {
    for (QAction* action : findChildren<QAction*>()) {
        const QString name = action->property(kIconName).toString();
        if (!name.isEmpty()) {
            action->setIcon(icon(name));
        }
    }
}

void MainWindow::refreshShortcutTips() {
    for (QAction* action : findChildren<QAction*>()) {
        sayShortcut(action);
    }
}

}  // namespace myoface
