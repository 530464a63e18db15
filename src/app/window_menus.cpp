// SPDX-License-Identifier: Apache-2.0
// Menus of the main window.
#include <algorithm>
#include <tuple>

#include <QActionGroup>
#include <QDesktopServices>
#include <QDockWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include "myoface/base/resources.h"

#include "action_search.h"
#include "compare_panel.h"
#include "comparison.h"
#include "face_files.h"
#include "landmark_guide.h"
#include "language.h"
#include "main_window.h"
#include "measure_panel.h"
#include "plan_files.h"
#include "report_panel.h"
#include "window_actions.h"

namespace myoface {

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
    addTo(
        file, tr("&Open…"), QKeySequence::Open, m_files, [this] { m_files->chooseFace(); },
        QStringLiteral("open"));
    QMenu* recent = file->addMenu(tr("Open &recent"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { m_files->fillRecent(*recent); });
    addTo(file, tr("Open the &built-in face"), {}, this,
          [this] { openPath(QStringLiteral("generic")); });
    addTo(file, tr("Open &landmarks…"), QKeySequence(QStringLiteral("Ctrl+L")), m_files,
          [this] { m_files->chooseLandmarks(); });
    addTo(file, tr("&Place landmarks by hand"), {}, this, [this] {
        if (m_document.opened()) {
            m_view->setPickMode(true);
            m_guide->begin();
        }
    });
    file->addSeparator();
    addTo(
        file, tr("&Save case"), QKeySequence::Save, m_files, [this] { m_files->saveCase(); },
        QStringLiteral("save"));
    addTo(file, tr("Save case &as…"), QKeySequence(QStringLiteral("Ctrl+Shift+S")), m_files,
          [this] { m_files->saveCaseAs(); });
    addTo(file, tr("Protect the case…"), {}, this, [this] { protectCase(); });
    addTo(file, tr("&Export face…"), QKeySequence(QStringLiteral("Ctrl+E")), this,
          [this] { exportFace(); });
    addTo(file, tr("Export p&icture…"), QKeySequence(QStringLiteral("Ctrl+Shift+E")), this,
          [this] { m_files->exportPicture(*m_view); });
    addTo(file, tr("Export the head &turning…"), {}, this,
          [this] { exportAnimation(QStringLiteral("turn")); });
    addTo(file, tr("Export the e&xpression moving…"), {}, this,
          [this] { exportAnimation(QStringLiteral("expression")); });
    addTo(
        file, tr("Export &report…"), QKeySequence(QStringLiteral("Ctrl+R")), this,
        [this] { m_files->chooseReport(m_reportPanel->words(), m_measures->population()); },
        QStringLiteral("report"));
    file->addSeparator();
    addTo(file, tr("Export plan…"), {}, m_plans, [this] { m_plans->chooseExport(); });
    addTo(file, tr("Apply plan…"), {}, m_plans, [this] { m_plans->chooseApply(); });
    file->addSeparator();
    addTo(file, tr("&Quit"), QKeySequence::Quit, this, [this] { close(); });
}

void MainWindow::buildEditMenu() {
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    // Our own words, so that they follow the language; what is undone stands in the history.
    QUndoStack* history = m_document.undoStack();
    QAction* undo = addTo(
        edit, tr("&Undo"), QKeySequence::Undo, history, [history] { history->undo(); },
        QStringLiteral("undo"));
    QAction* redo = addTo(
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
    addTo(edit, tr("All muscles at &rest"), {}, this, [this] { restMuscles(); });
    QAction* reset = addTo(
        edit, tr("Reset &face"), {}, this, [this] { resetFace(); }, QStringLiteral("reset"));
    reset->setObjectName(QStringLiteral("reset"));
    reset->setProperty("tip", tr("Back to the scan: muscles at rest, shape as it came"));
    reset->setToolTip(reset->property("tip").toString());
    addTo(edit, tr("&Keep as variant"), QKeySequence(QStringLiteral("Ctrl+D")), this,
          [this] { m_comparison->storeVariant(); });
    edit->addSeparator();
    addTo(edit, tr("&Preferences…"), QKeySequence(QStringLiteral("Ctrl+,")), this, [this] {
        auto* dialog = new Preferences(m_settings, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &Preferences::edited, this, &MainWindow::applySettings);
        dialog->show();
    });
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
        addTo(view, v.title, QKeySequence(QString::fromLatin1(v.key)), this,
              [this, name = QString::fromLatin1(v.name)] { m_view->showStandardView(name); });
    }
    view->addSeparator();
    buildLayouts(*view);
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
        addTo(compare, title, QKeySequence(QString::fromLatin1(key)), this,
              [this, m = mode] { m_comparePanel->setMode(m); });
    }
    addTo(compare, tr("&Map of the change"), QKeySequence(QStringLiteral("Ctrl+Alt+5")), this,
          [this] { m_comparePanel->setMap(true); });
    QMenu* panels = view->addMenu(tr("&Panels"));
    for (auto* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        panels->addAction(dock->toggleViewAction());
    }
    QMenu* steps = view->addMenu(tr("S&teps"));
    steps->addActions(m_stepActions->actions());
    addTo(view, tr("Patient &view"), {}, this, [this] { presentToPatient(); });
    addTo(view, tr("F&ull screen"), QKeySequence(QStringLiteral("Ctrl+F11")), this,
          [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
}

/// One, two or four sides of the face at once.
void MainWindow::buildLayouts(QMenu& view) {
    QMenu* layouts = view.addMenu(tr("Several &views"));
    m_viewLayouts = new QActionGroup(this);
    for (const auto& [title, layout, name] :
         {std::tuple(tr("&One view"), ViewLayout::One, "view-one"),
          std::tuple(tr("&Two: front and profile"), ViewLayout::Two, "view-two"),
          std::tuple(tr("&Four: front, profile, three-quarter, from below"), ViewLayout::Four,
                     "view-four")}) {
        QAction* action = layouts->addAction(title);
        action->setCheckable(true);
        action->setObjectName(QString::fromLatin1(name));
        setIcon(action, QString::fromLatin1(name));
        action->setData(static_cast<int>(layout));
        action->setChecked(layout == ViewLayout::One);
        m_viewLayouts->addAction(action);
        connect(action, &QAction::triggered, this, [this, l = layout] { m_view->setLayout(l); });
    }
    layouts->addSeparator();
    QAction* next = addTo(layouts, tr("&Next: one, two, four"), QKeySequence(QStringLiteral("V")),
                          this, [this] { nextLayout(); });
    next->setToolTip(tr("One view, two, four, and one again"));
    QAction* linked = layouts->addAction(tr("&Cameras linked"));
    linked->setCheckable(true);
    linked->setChecked(true);
    linked->setShortcut(QKeySequence(QStringLiteral("Shift+V")));
    linked->setToolTip(tr("Turning, moving and zooming one view does the same to all"));
    connect(linked, &QAction::toggled, m_view, &FaceView::setLinked);
}

void MainWindow::setViews(ViewLayout layout) {
    for (QAction* action : m_viewLayouts->actions()) {
        if (action->data().toInt() == static_cast<int>(layout)) {
            action->trigger();
        }
    }
}

void MainWindow::nextLayout() {
    const ViewLayout now = m_view->layout();
    setViews(now == ViewLayout::One   ? ViewLayout::Two
             : now == ViewLayout::Two ? ViewLayout::Four
                                      : ViewLayout::One);
}

void MainWindow::buildHelpMenu() {
    QMenu* help = menuBar()->addMenu(tr("&Help"));
    addTo(help, tr("&Keys and mouse"), QKeySequence(QStringLiteral("F1")), this,
          [this] { showShortcuts(); });
    addTo(help, tr("&Find an action…"), {}, this,
          [this] { (new ActionSearch(actionsOf(*this), this))->show(); });
    addTo(help, tr("&Manual"), {}, this, [this] {
        const std::filesystem::path page = resource_path("docs/user/manual.md");
        if (!QDesktopServices::openUrl(
                QUrl::fromLocalFile(QString::fromStdString(page.string())))) {
            complain(tr("The manual is %1, and no program that shows it was found.")
                         .arg(QString::fromStdString(page.string())));
        }
    });
    addTo(help, tr("&About Myoface"), {}, this, [this] { about(); });
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

}  // namespace myoface
