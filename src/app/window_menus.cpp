// SPDX-License-Identifier: Apache-2.0
// Menus, tool bars and shortcuts of the main window.
#include <algorithm>
#include <tuple>

#include <QActionGroup>
#include <QDesktopServices>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QStatusBar>
#include <QTextBrowser>
#include <QToolBar>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "myoface/base/resources.h"

#include "action_search.h"
#include "compare_panel.h"
#include "comparison.h"
#include "face_files.h"
#include "icons.h"
#include "landmark_guide.h"
#include "language.h"
#include "main_window.h"
#include "measure_panel.h"
#include "plan_files.h"
#include "report_panel.h"

namespace myoface {
namespace {

constexpr const char* kIconName = "iconName";

/// An icon that is drawn again when the theme changes.
void setIcon(QAction* action, const QString& name) {
    action->setProperty(kIconName, name);
    action->setIcon(icon(name));
}

/// Tooltips of tool bars say the shortcut too.
void sayShortcut(QAction* action) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    const QString plain = action->property("tip").toString();
    if (!key.isEmpty() && !plain.isEmpty()) {
        action->setToolTip(QStringLiteral("%1 (%2)").arg(plain, key));
    }
}

template <typename Call>
QAction* add(QMenu* menu, const QString& text, const QKeySequence& key, QObject* context,
             const Call& call, const QString& iconName = {}) {
    QAction* action = menu->addAction(text);
    action->setShortcut(key);
    QObject::connect(action, &QAction::triggered, context, call);
    if (!iconName.isEmpty()) {
        setIcon(action, iconName);
    }
    return action;
}

}  // namespace

void MainWindow::buildActions() {
    buildFileMenu();
    buildEditMenu();
    buildSteps();
    buildTools();
    buildViewMenu();
    buildHelpMenu();
}

void MainWindow::buildFileMenu() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    add(
        file, tr("&Open…"), QKeySequence::Open, m_files, [this] { m_files->chooseFace(); },
        QStringLiteral("open"));
    QMenu* recent = file->addMenu(tr("Open &recent"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { m_files->fillRecent(*recent); });
    add(file, tr("Open the &built-in face"), {}, this,
        [this] { openPath(QStringLiteral("generic")); });
    add(file, tr("Open &landmarks…"), QKeySequence(QStringLiteral("Ctrl+L")), m_files,
        [this] { m_files->chooseLandmarks(); });
    add(file, tr("&Place landmarks by hand"), {}, this, [this] {
        if (m_document.opened()) {
            m_view->setPickMode(true);
            m_guide->begin();
        }
    });
    file->addSeparator();
    add(
        file, tr("&Save case"), QKeySequence::Save, m_files, [this] { m_files->saveCase(); },
        QStringLiteral("save"));
    add(file, tr("Save case &as…"), QKeySequence(QStringLiteral("Ctrl+Shift+S")), m_files,
        [this] { m_files->saveCaseAs(); });
    add(file, tr("Protect the case…"), {}, this, [this] { protectCase(); });
    add(file, tr("&Export face…"), QKeySequence(QStringLiteral("Ctrl+E")), this, [this] {
        if (m_document.model() && m_shown) {
            m_files->exportFace(*m_shown);
        }
    });
    add(file, tr("Export p&icture…"), QKeySequence(QStringLiteral("Ctrl+Shift+E")), this,
        [this] { m_files->exportPicture(*m_view); });
    add(file, tr("Export turning pictures…"), {}, this,
        [this] { m_files->exportTurntable(*m_view); });
    add(
        file, tr("Export &report…"), QKeySequence(QStringLiteral("Ctrl+R")), this,
        [this] { m_files->chooseReport(m_reportPanel->words(), m_measures->population()); },
        QStringLiteral("report"));
    file->addSeparator();
    add(file, tr("Export plan…"), {}, m_plans, [this] { m_plans->chooseExport(); });
    add(file, tr("Apply plan…"), {}, m_plans, [this] { m_plans->chooseApply(); });
    file->addSeparator();
    add(file, tr("&Quit"), QKeySequence::Quit, this, [this] { close(); });
}

void MainWindow::buildEditMenu() {
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    // Our own words, so that they follow the language; what is undone stands in the history.
    QUndoStack* history = m_document.undoStack();
    QAction* undo = add(
        edit, tr("&Undo"), QKeySequence::Undo, history, [history] { history->undo(); },
        QStringLiteral("undo"));
    QAction* redo = add(
        edit, tr("&Redo"), {}, history, [history] { history->redo(); }, QStringLiteral("redo"));
    redo->setShortcuts(
        {QKeySequence(QStringLiteral("Ctrl+Shift+Z")), QKeySequence(QStringLiteral("Ctrl+Y"))});
    undo->setObjectName(QStringLiteral("undo"));
    redo->setObjectName(QStringLiteral("redo"));
    undo->setEnabled(false);
    redo->setEnabled(false);
    connect(history, &QUndoStack::canUndoChanged, undo, &QAction::setEnabled);
    connect(history, &QUndoStack::canRedoChanged, redo, &QAction::setEnabled);
    edit->addSeparator();
    add(edit, tr("All muscles at &rest"), {}, this, [this] { restMuscles(); });
    QAction* reset = add(
        edit, tr("Reset &face"), {}, this, [this] { resetFace(); }, QStringLiteral("reset"));
    reset->setObjectName(QStringLiteral("reset"));
    reset->setProperty("tip", tr("Back to the scan: muscles at rest, shape as it came"));
    reset->setToolTip(reset->property("tip").toString());
    add(edit, tr("&Keep as variant"), QKeySequence(QStringLiteral("Ctrl+D")), this,
        [this] { m_comparison->storeVariant(); });
    edit->addSeparator();
    add(edit, tr("&Preferences…"), QKeySequence(QStringLiteral("Ctrl+,")), this, [this] {
        auto* dialog = new Preferences(m_settings, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &Preferences::edited, this, &MainWindow::applySettings);
        dialog->show();
    });
}

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
                    Tool::Measure, "M", "measure"}}) {
        QAction* action = bar->addAction(entry.title);
        setIcon(action, QString::fromLatin1(entry.icon));
        action->setCheckable(true);
        action->setShortcut(QKeySequence(QString::fromLatin1(entry.key)));
        action->setProperty("tip", entry.tip);
        action->setObjectName(QStringLiteral("tool%1").arg(QString::fromLatin1(entry.key)));
        tools->addAction(action);
        connect(action, &QAction::triggered, this, [this, action, tool = entry.tool] {
            m_view->setTool(tool);
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

void MainWindow::buildViewMenu() {
    QMenu* view = menuBar()->addMenu(tr("&View"));
    struct StandardView {
        QString title;
        const char* name;
        const char* key;
    };
    for (const StandardView& v :
         {StandardView{tr("&Front"), "front", "Ctrl+1"},
          StandardView{tr("Patient's &left"), "left", "Ctrl+3"},
          StandardView{tr("Patient's &right"), "right", "Ctrl+Shift+3"},
          StandardView{tr("Three-quarter left"), "three-quarter-left", "Ctrl+5"},
          StandardView{tr("Three-quarter right"), "three-quarter-right", "Ctrl+Shift+5"},
          StandardView{tr("From &below"), "below", "Ctrl+7"},
          StandardView{tr("From &above"), "above", "Ctrl+Shift+7"}}) {
        add(view, v.title, QKeySequence(QString::fromLatin1(v.key)), this,
            [this, name = QString::fromLatin1(v.name)] { m_view->showStandardView(name); });
    }
    view->addSeparator();
    QAction* orthographic = view->addAction(tr("&Orthographic"));
    orthographic->setCheckable(true);
    orthographic->setShortcut(QKeySequence(QStringLiteral("Ctrl+P")));
    connect(orthographic, &QAction::toggled, m_view, &FaceView::setOrthographic);
    QAction* flat = view->addAction(tr("&Clinical light"));
    flat->setCheckable(true);
    flat->setToolTip(tr("Even light from the front, as in clinical photographs"));
    connect(flat, &QAction::toggled, m_view, &FaceView::setClinicalLight);
    QAction* texture = view->addAction(tr("Skin &texture"));
    texture->setCheckable(true);
    texture->setChecked(true);
    texture->setToolTip(tr("The colours of the scan, or plain skin that shows the shape"));
    connect(texture, &QAction::toggled, m_view, &FaceView::setTextured);
    QAction* wires = view->addAction(tr("&Wireframe"));
    wires->setCheckable(true);
    wires->setToolTip(tr("The triangles of the scan"));
    connect(wires, &QAction::toggled, m_view, &FaceView::setWireframe);
    QAction* turning = view->addAction(tr("T&urn slowly"));
    turning->setCheckable(true);
    turning->setToolTip(tr("Turns the head until the mouse takes it"));
    connect(turning, &QAction::toggled, m_view, &FaceView::setTurning);
    connect(m_view, &FaceView::turningEnded, turning, [turning] { turning->setChecked(false); });

    // Whether tissue swings is a matter of looking, not of the result.
    QMenu* motion = view->addMenu(tr("&Motion of tissue"));
    auto* paces = new QActionGroup(this);
    for (const auto& [title, pace] : {std::pair(tr("Straight to &rest"), 0.0),
                                      std::pair(tr("&Swings, as fast as in life"), 1.0),
                                      std::pair(tr("Swings, &4 times slower"), 0.25),
                                      std::pair(tr("Swings, &10 times slower"), 0.1)}) {
        QAction* action = motion->addAction(title);
        action->setCheckable(true);
        action->setChecked(pace == 0.0);
        paces->addAction(action);
        connect(action, &QAction::triggered, this,
                [this, p = pace] { inWorker([p](SimulationWorker& w) { w.setPace(p); }); });
    }
    view->addSeparator();
    QMenu* compare = view->addMenu(tr("Before and &after"));
    for (const auto& [title, mode, key] :
         {std::tuple(tr("&Now alone"), CompareMode::Off, "Ctrl+Alt+1"),
          std::tuple(tr("&Side by side"), CompareMode::SideBySide, "Ctrl+Alt+2"),
          std::tuple(tr("&Wipe"), CompareMode::Wipe, "Ctrl+Alt+3"),
          std::tuple(tr("&Ghost"), CompareMode::Ghost, "Ctrl+Alt+4")}) {
        add(compare, title, QKeySequence(QString::fromLatin1(key)), this,
            [this, m = mode] { m_comparePanel->setMode(m); });
    }
    add(compare, tr("&Map of the change"), QKeySequence(QStringLiteral("Ctrl+Alt+5")), this,
        [this] { m_comparePanel->setMap(true); });
    QMenu* panels = view->addMenu(tr("&Panels"));
    for (auto* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        panels->addAction(dock->toggleViewAction());
    }
    QMenu* steps = view->addMenu(tr("S&teps"));
    steps->addActions(m_stepActions->actions());
    add(view, tr("Patient &view"), {}, this, [this] { presentToPatient(); });
    add(view, tr("F&ull screen"), QKeySequence(QStringLiteral("Ctrl+F11")), this,
        [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
}

void MainWindow::buildHelpMenu() {
    QMenu* help = menuBar()->addMenu(tr("&Help"));
    add(help, tr("&Keys and mouse"), QKeySequence(QStringLiteral("F1")), this,
        [this] { showShortcuts(); });
    add(help, tr("&Find an action…"), {}, this,
        [this] { (new ActionSearch(actionsOf(*this), this))->show(); });
    add(help, tr("&Manual"), {}, this, [this] {
        const std::filesystem::path page = resource_path("docs/user/manual.md");
        if (!QDesktopServices::openUrl(
                QUrl::fromLocalFile(QString::fromStdString(page.string())))) {
            complain(tr("The manual is %1, and no program that shows it was found.")
                         .arg(QString::fromStdString(page.string())));
        }
    });
    add(help, tr("&About Myoface"), {}, this, [this] { about(); });
}

/// All keys, made from the actions themselves, and what the mouse does.
void MainWindow::showShortcuts() {
    QString text =
        tr("<h3>Mouse</h3><table cellspacing=4>"
           "<tr><td><b>Left drag on skin</b></td><td>what the tool says</td></tr>"
           "<tr><td><b>Left drag beside the face, Alt + left, middle</b></td><td>turn</td></tr>"
           "<tr><td><b>Right drag, Shift + middle</b></td><td>pan</td></tr>"
           "<tr><td><b>Wheel</b></td><td>zoom towards the cursor</td></tr>"
           "<tr><td><b>Double click on a slider</b></td><td>muscle at rest</td></tr></table>"
           "<h3>Keys on the face</h3><table cellspacing=4>"
           "<tr><td><b>F</b></td><td>radius of the grip, then move the mouse</td></tr>"
           "<tr><td><b>X</b></td><td>same on the other side</td></tr>"
           "<tr><td><b>Arrows</b></td><td>0.1 mm, with Shift 1 mm</td></tr>"
           "<tr><td><b>Space</b></td><td>hold to see the state before</td></tr>"
           "<tr><td><b>Home</b></td><td>whole head</td></tr>"
           "<tr><td><b>Esc</b></td><td>give up the gesture</td></tr></table>");
    text += tr("<h3>Everywhere</h3>") + QStringLiteral("<table cellspacing=4>");
    std::vector<QAction*> actions = actionsOf(*this);
    for (QAction* action : findChildren<QAction*>()) {
        if (action->objectName().startsWith(QLatin1String("tool")) &&
            std::find(actions.begin(), actions.end(), action) == actions.end()) {
            actions.push_back(action);
        }
    }
    for (const QAction* action : actions) {
        const QString key = action->shortcut().toString(QKeySequence::NativeText);
        if (!key.isEmpty()) {
            text += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>")
                        .arg(key.toHtmlEscaped(), plainText(*action).toHtmlEscaped());
        }
    }
    auto* sheet = new QDialog(this);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->setWindowTitle(tr("Keys and mouse"));
    auto* column = new QVBoxLayout(sheet);
    auto* browser = new QTextBrowser;
    browser->setHtml(text + QStringLiteral("</table>"));
    browser->setFrameShape(QFrame::NoFrame);
    column->addWidget(browser);
    sheet->resize(560, 640);
    sheet->show();
}

void MainWindow::about() {
    QMessageBox::about(
        this, tr("About Myoface"),
        tr("<h3>Myoface %1</h3><p>Facial surgery consultation simulator on a muscle-spring "
           "model.</p><p>A planning and communication aid, not a medical device: what it shows is "
           "an estimate, not a promise of a result.</p><p>Apache License 2.0. Uses Qt (LGPL 3), "
           "Eigen (MPL 2), assimp, libzip, GLFW (BSD and zlib), libepoxy, nlohmann-json, CLI11 and "
           "nanoflann (MIT and BSD).</p>")
            .arg(QStringLiteral(MYOFACE_VERSION)));
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
