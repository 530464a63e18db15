// SPDX-License-Identifier: Apache-2.0
// Panels of the main window, and which of them a step shows.
#include <algorithm>
#include <tuple>

#include <QDockWidget>
#include <QSettings>
#include <QStatusBar>
#include <QUndoView>

#include "compare_panel.h"
#include "face_files.h"
#include "landmark_editor.h"
#include "landmark_panel.h"
#include "layer_panel.h"
#include "main_window.h"
#include "measure_panel.h"
#include "muscle_panel.h"
#include "open_job.h"
#include "patient_view.h"
#include "report_panel.h"
#include "scan_panel.h"
#include "shape_panel.h"

namespace myoface {
namespace {

const char* const kLeast = "least";  ///< property of a dock: least width of its content [px]

}  // namespace

void MainWindow::buildStatusBar() {
    m_aid = new QLabel(tr("A planning and communication aid, not a medical device"));
    m_state = new QLabel;
    m_progress = new QProgressBar;
    m_progress->setMaximumWidth(220);
    m_cancel = new QPushButton(tr("Cancel"));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_progress, m_cancel, m_state, m_aid}) {
        statusBar()->addPermanentWidget(widget);
    }
    m_progress->hide();
    m_cancel->hide();
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_job) {
            m_job->cancel();
        } else {
            m_files->cancel();
        }
    });
}

void MainWindow::showWork(const QString& what) {
    m_progress->setRange(0, 0);  // nobody knows yet how long
    m_progress->setFormat(what);
    m_progress->show();
    m_cancel->show();
    m_work = what + QStringLiteral("…");
    statusBar()->showMessage(m_work, 8000);
}

void MainWindow::showShare(int percent) {
    m_progress->setRange(0, percent < 0 ? 0 : 100);
    m_progress->setValue(percent);
}

void MainWindow::hideWork() {
    if (statusBar()->currentMessage() == m_work) {
        statusBar()->clearMessage();
    }
    m_progress->hide();
    m_cancel->hide();
}

void MainWindow::buildDocks() {
    const auto dock = [this](const QString& title, const QString& name, QWidget* content,
                             Qt::DockWidgetArea area) {
        auto* result = new QDockWidget(title);
        result->setObjectName(name);
        result->setWidget(content);
        result->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable |
                            QDockWidget::DockWidgetFloatable);
        addDockWidget(area, result);
        return result;
    };
    constexpr int kLeft = 270;  // least width of the panels [px]
    constexpr int kRight = 390;
    m_scanPanel = new ScanPanel;
    m_landmarks = new LandmarkPanel;
    m_shapePanel = new ShapePanel;
    m_comparePanel = new ComparePanel;
    m_reportPanel = new ReportPanel;
    m_layers = new LayerPanel;
    m_muscles = new MusclePanel;
    m_measures = new MeasurePanel;
    const auto left = Qt::LeftDockWidgetArea;
    const auto right = Qt::RightDockWidgetArea;
    for (const auto& [title, name, widget] :
         {std::tuple<QString, QString, QWidget*>{tr("Scan"), QStringLiteral("scan"), m_scanPanel},
          {tr("Landmarks"), QStringLiteral("landmarks"), m_landmarks},
          {tr("Shape"), QStringLiteral("shape"), m_shapePanel},
          {tr("Compare"), QStringLiteral("compare"), m_comparePanel},
          {tr("Report"), QStringLiteral("report"), m_reportPanel},
          {tr("Layers"), QStringLiteral("layers"), m_layers}}) {
        dock(title, name, widget, left)->setProperty(kLeast, kLeft);
    }
    auto* history = new QUndoView(m_document.undoStack());
    history->setEmptyLabel(tr("the face as it was opened"));
    history->setAccessibleName(tr("History"));
    history->setCleanIcon(QIcon());
    for (const auto& [title, name, widget] :
         {std::tuple<QString, QString, QWidget*>{tr("Muscles"), QStringLiteral("muscles"),
                                                 m_muscles},
          {tr("Measures"), QStringLiteral("measures"), m_measures},
          {tr("History"), QStringLiteral("history"), history}}) {
        dock(title, name, widget, right)->setProperty(kLeast, kRight);
    }
    widenPanels();
    m_landmarkEditor = new LandmarkEditor(m_document, *m_view, *m_landmarks, this);
    connect(m_landmarkEditor, &LandmarkEditor::changed, this, &MainWindow::drawOver);
    connect(m_landmarkEditor, &LandmarkEditor::fitted, this, &MainWindow::showRefitted);
    connect(m_landmarkEditor, &LandmarkEditor::problem, this, &MainWindow::complain);
    m_layers->setEnabled(false);
    m_muscles->setEnabled(false);
    m_measures->setEnabled(false);
    m_comparePanel->setEnabled(false);
}

/// Panels as wide as their words need in this language.
void MainWindow::widenPanels() {
    for (auto* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        QWidget* content = dock->widget();
        content->setMinimumWidth(0);
        content->setMinimumWidth(
            std::max(dock->property(kLeast).toInt(), content->minimumSizeHint().width()));
    }
}

void MainWindow::showStep(const QString& name) {
    const auto wanted = std::find_if(m_steps.begin(), m_steps.end(),
                                     [&](const TaskStep& step) { return step.name == name; });
    if (wanted == m_steps.end()) {
        return;
    }
    if (!m_step.isEmpty()) {
        m_layouts[m_step] = saveState();
    }
    m_step = name;
    for (QAction* action : m_stepActions->actions()) {
        action->setChecked(action->data().toString() == name);
    }
    if (!m_layouts.contains(name) || !restoreState(m_layouts[name])) {
        QDockWidget* last[2] = {nullptr, nullptr};
        for (auto* dock : findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            dock->hide();
        }
        for (const QString& panel : wanted->panels) {
            auto* dock = findChild<QDockWidget*>(panel);
            const bool left = dockWidgetArea(dock) == Qt::LeftDockWidgetArea;
            if (QDockWidget*& above = last[left ? 0 : 1]; above != nullptr) {
                splitDockWidget(above, dock, Qt::Vertical);
                above = dock;
            } else {
                above = dock;
            }
            dock->show();
            resizeDocks({dock}, {dock->widget()->minimumWidth()}, Qt::Horizontal);
        }
        if (auto* layers = findChild<QDockWidget*>(QStringLiteral("layers"));
            layers->isVisibleTo(this)) {
            resizeDocks({layers}, {210}, Qt::Vertical);
        }
        if (wanted->panels.contains(QStringLiteral("history"))) {
            resizeDocks({findChild<QDockWidget*>(QStringLiteral("history"))}, {150}, Qt::Vertical);
        }
    }
    if (m_shown && m_document.model()) {  // panels that were hidden catch up
        showAgain();
    }
}

void MainWindow::setLayers(const LayerOpacity& layers) {
    m_layers->setLayers(layers);
    if (m_scene) {
        m_scene->set_layers(layers);
    }
    m_view->update();
}

void MainWindow::showPanel(const QString& name) {
    if (auto* dock = findChild<QDockWidget*>(name)) {
        dock->show();
        dock->raise();
    }
}

void MainWindow::showLandmarks() {
    showPanel(QStringLiteral("landmarks"));
    m_landmarks->showAll();
}

/// Three hints over the face at the first start, until the first click on them or gesture.
void MainWindow::showHints() {
    const QString key = QStringLiteral("hintsSeen");
    if (m_hints != nullptr || QSettings().value(key).toBool() ||
        qEnvironmentVariableIsSet("MYOFACE_UNATTENDED")) {
        return;
    }
    m_hints = new QLabel(m_view);
    m_hints->setText(
        tr("<p><b>Drag the skin</b> to shape it. Beside the face, the left button "
           "turns the head; the wheel zooms.</p>"
           "<p><b>The steps above</b> lead from the scan to the report.</p>"
           "<p><b>Ctrl+K</b> finds everything by name, <b>F1</b> shows all keys.</p>"));
    m_hints->setStyleSheet(
        QStringLiteral("background: #1b2027; color: #e8ecf0;"
                       " border-radius: 10px; padding: 6px 18px;"));
    m_hints->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_hints->adjustSize();
    m_hints->show();
    placeHints();
    connect(m_document.undoStack(), &QUndoStack::indexChanged, m_hints, [this, key] {
        QSettings().setValue(key, true);
        m_hints->hide();
    });
}

void MainWindow::placeHints() {
    if (m_hints != nullptr) {
        m_hints->move((m_view->width() - m_hints->width()) / 2,
                      m_view->height() - m_hints->height() - 24);
    }
}

void MainWindow::presentToPatient() {
    if (m_patient) {
        m_patient->close();
        return;
    }
    m_patient = new PatientView(*m_view);
    m_patient->setAttribute(Qt::WA_DeleteOnClose);
    m_patient->setScene(m_scene.get());
    m_patient->present();
}

}  // namespace myoface
