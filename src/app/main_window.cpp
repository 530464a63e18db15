// SPDX-License-Identifier: Apache-2.0
#include "main_window.h"

#include <algorithm>

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

#include "myoface/base/error.h"
#include "myoface/muscle/user_expressions.h"

#include "callipers.h"
#include "commands.h"
#include "compare_panel.h"
#include "comparison.h"
#include "comparison_jobs.h"
#include "face_files.h"
#include "icons.h"
#include "journal_keeper.h"
#include "landmark_editor.h"
#include "landmark_guide.h"
#include "landmark_panel.h"
#include "language.h"
#include "layer_panel.h"
#include "measure_panel.h"
#include "muscle_panel.h"
#include "open_job.h"
#include "passphrase_dialog.h"
#include "patient_view.h"
#include "plan_files.h"
#include "report_panel.h"
#include "scan_frame_editor.h"
#include "scan_panel.h"
#include "shape_panel.h"
#include "shape_tools.h"

namespace myoface {

void MainWindow::inWorker(const std::function<void(SimulationWorker&)>& call) {
    m_settled = false;
    QMetaObject::invokeMethod(
        m_worker, [worker = m_worker, call] { call(*worker); }, Qt::QueuedConnection);
}

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), m_settings(Settings::read()) {
    qRegisterMetaType<std::shared_ptr<const DragOutcome>>();
    qRegisterMetaType<std::shared_ptr<const PlanOutcome>>();
    setWindowTitle(tr("Myoface"));
    setWindowIcon(programIcon());
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    resize(1440, 900);

    auto* centre = new QWidget;
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    m_guide = new LandmarkGuide;
    m_view = new FaceView;
    layout->addWidget(m_guide);
    layout->addWidget(m_view, 1);
    setCentralWidget(centre);

    m_worker = new SimulationWorker(m_box);
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    connect(m_worker, &SimulationWorker::snapshotReady, this, &MainWindow::showSnapshot);
    connect(m_worker, &SimulationWorker::failed, this, &MainWindow::complain);
    m_thread.start();

    m_files = new FaceFiles(m_document, *this);
    m_plans = new PlanFiles(
        m_document, *this,
        [this](const std::function<void(SimulationWorker&)>& call) { inWorker(call); });
    m_journal = new JournalKeeper(m_document, JournalKeeper::usualFolder(), this);
    connect(m_journal, &JournalKeeper::problem, this, &MainWindow::complain);
    buildDocks();
    buildStatusBar();
    buildActions();
    connectView();
    connectFrameEditor();
    connectShapeTools();
    connectDocument();
    connectPanels();
    inWorker([form = m_settings.response](SimulationWorker& w) { w.setResponse(form); });
    m_settled = true;
    showStep(QStringLiteral("shape"));
    const QSettings kept;
    if (!qEnvironmentVariableIsSet("MYOFACE_UNATTENDED")) {
        restoreGeometry(kept.value(QStringLiteral("geometry")).toByteArray());
    }
}

void MainWindow::connectDocument() {
    connect(&m_document, &FaceDocument::rateChanged, this, [this](int muscle, double rate) {
        m_muscles->setRate(muscle, rate);
        inWorker([muscle, rate](SimulationWorker& w) { w.setRate(muscle, rate); });
    });
    connect(&m_document, &FaceDocument::strengthChanged, this, [this](int muscle, double strength) {
        m_muscles->setStrength(muscle, strength);
        inWorker([muscle, strength](SimulationWorker& w) { w.setStrength(muscle, strength); });
    });
    connect(&m_document, &FaceDocument::skinAgeChanged, this, [this](double years) {
        m_muscles->setSkinAge(years);
        inWorker([years](SimulationWorker& w) { w.setSkinAge(years); });
    });
    connect(&m_document, &FaceDocument::skinRestChanged, this, [this] {
        inWorker([rest = m_document.skinRest()](SimulationWorker& w) { w.setSkinRest(rest); });
    });
    connect(&m_document, &FaceDocument::notesChanged, this,
            [this] { m_reportPanel->setNotes(m_document.notes()); });
    connect(m_document.undoStack(), &QUndoStack::cleanChanged, this,
            [this](bool clean) { setWindowModified(!clean); });
}

void MainWindow::connectPanels() {
    const auto say = [this](const QString& sentence) { statusBar()->showMessage(sentence, 8000); };
    connect(m_files, &FaceFiles::openWanted, this, &MainWindow::openPath);
    connect(m_files, &FaceFiles::landmarksWanted, this, [this](const QString& path) {
        OpenOptions options;
        options.landmarks = path.toStdString();
        startJob(m_files->path(), options);
    });
    connect(m_files, &FaceFiles::message, this, say);
    connect(m_files, &FaceFiles::problem, this, &MainWindow::complain);
    connect(m_plans, &PlanFiles::message, this, say);
    connect(m_plans, &PlanFiles::problem, this, &MainWindow::complain);
    connect(m_worker, &SimulationWorker::planApplied, m_plans,
            [this](const std::shared_ptr<const PlanOutcome>& o) { m_plans->finished(*o); });
    connect(m_files, &FaceFiles::reportWritten, this, &MainWindow::reportWritten);
    connect(m_files, &FaceFiles::working, this, &MainWindow::showWork);
    connect(m_files, &FaceFiles::progressed, this, &MainWindow::showShare);
    connect(m_files, &FaceFiles::rested, this, &MainWindow::hideWork);
    connect(m_files, &FaceFiles::reportWriting, m_reportPanel, &ReportPanel::setWriting);

    connect(m_muscles, &MusclePanel::ratesEdited, this,
            [this](const std::vector<int>& which, double rate, int gesture, const QString& title) {
                m_document.undoStack()->push(
                    new SetMusclesCommand(m_document, MuscleSetting::Rate, which,
                                          std::vector<double>(which.size(), rate), gesture, title));
            });
    connect(
        m_muscles, &MusclePanel::strengthsEdited, this,
        [this](const std::vector<int>& which, double strength, int gesture, const QString& title) {
            m_document.undoStack()->push(
                new SetMusclesCommand(m_document, MuscleSetting::Strength, which,
                                      std::vector<double>(which.size(), strength), gesture,
                                      tr("strength of %1").arg(title)));
        });
    connect(m_muscles, &MusclePanel::expressionChosen, this,
            [this](const std::string& name, double left, double right, int gesture, bool fresh) {
                if (m_document.model()) {
                    chooseExpression(name, left, right, gesture, fresh);
                }
            });
    connect(m_muscles, &MusclePanel::expressionSaveAsked, this, [this](const QString& name) {
        changePresets(name, [&] {
            save_user_expression(name.toStdString(), m_document.contractions().rate);
        });
    });
    connect(m_muscles, &MusclePanel::expressionRemoveAsked, this, [this](const QString& name) {
        changePresets({}, [&] { remove_user_expression(name.toStdString()); });
    });
    connect(m_muscles, &MusclePanel::untreatedAsked, this,
            [this](bool beside) { m_comparison->compareUntreated(beside); });
    connect(m_muscles, &MusclePanel::weakeningChosen, this, &MainWindow::weaken);
    connect(m_muscles, &MusclePanel::resetRequested, this, &MainWindow::restMuscles);
    connect(m_muscles, &MusclePanel::skinAgeEdited, this, [this](double years, int gesture) {
        if (m_document.model()) {
            m_document.undoStack()->push(
                new SetSkinAgeCommand(m_document, years, gesture, tr("age of the skin")));
        }
    });
    connect(m_layers, &LayerPanel::layersEdited, this, [this] {
        if (m_scene) {
            m_scene->set_layers(m_layers->layers());
            m_scene->cut_away(m_layers->cutAway());
            m_view->update();
        }
    });
    connect(m_guide, &LandmarkGuide::completed, this, &MainWindow::landmarksPlaced);
    connect(m_guide, &LandmarkGuide::changed, this, [this] {
        if (m_scene) {
            m_scene->scene().markers.clear();
            for (const auto& [name, landmark] : m_guide->placed()) {
                m_scene->scene().markers.push_back(
                    {landmark.position.cast<float>(), {0.35F, 0.78F, 1.0F}, 6.0F});
            }
            m_view->update();
        }
    });

    m_comparison = new Comparison(m_document, *m_view, *m_comparePanel, this);
    connect(m_comparison, &Comparison::untreatedChanged, m_muscles, &MusclePanel::setUntreated);
    connect(m_comparison, &Comparison::changed, this, &MainWindow::showAgain);
    connect(m_comparison, &Comparison::message, this, say);
    connect(m_comparison, &Comparison::problem, this, &MainWindow::complain);
    connect(m_view, &FaceView::beforeHeld, m_comparison, &Comparison::holdBefore);
    m_callipers = new Callipers(*m_view, this);
    connect(m_callipers, &Callipers::changed, this, &MainWindow::drawOver);
    connect(m_callipers, &Callipers::message, this, say);
    connect(m_view, &FaceView::measureEnded, m_callipers, &Callipers::clear);
    connect(m_view, &FaceView::sectionPlaced, this, [this](const SurfacePoint& where) {
        if (m_shown && m_document.model()) {
            const SimSnapshot shown = m_comparison->shown(*m_shown);
            m_measures->sections().place(
                position({shown.positions, m_document.model()->skin.mesh.triangles}, where));
        }
    });
    connect(m_view, &FaceView::sectionDrawn, this, [this](const Vec3& through, const Vec3& normal) {
        m_measures->sections().placeFree(through, normal);
    });
    connect(m_measures, &MeasurePanel::chosen, this, &MainWindow::drawOver);
    connect(m_measures, &MeasurePanel::message, this, say);
    connect(m_measures, &MeasurePanel::problem, this, &MainWindow::complain);

    connect(m_reportPanel, &ReportPanel::notesEdited, &m_document, &FaceDocument::setNotes);
    connect(m_reportPanel, &ReportPanel::reportAsked, this,
            [this] { m_files->chooseReport(m_reportPanel->words(), m_measures->population()); });
    connect(m_reportPanel, &ReportPanel::pictureAsked, this,
            [this] { m_files->exportPicture(*m_view); });
    connect(m_reportPanel, &ReportPanel::turntableAsked, this,
            [this] { exportAnimation(QStringLiteral("turn")); });
    connect(m_reportPanel, &ReportPanel::expressionAsked, this,
            [this] { exportAnimation(QStringLiteral("expression")); });
    connect(m_reportPanel, &ReportPanel::caseAsked, this, [this] { m_files->saveCaseAs(); });
    connect(m_reportPanel, &ReportPanel::faceAsked, this, &MainWindow::exportFace);
}

bool MainWindow::settled() const {
    return m_settled && !m_job && !m_files->busy() && !m_shading && !m_landmarkEditor->fitting() &&
           !m_comparison->busy();
}

MainWindow::~MainWindow() {
    m_job.reset();
    m_shading.reset();
    m_thread.quit();
    m_thread.wait();
}

void MainWindow::connectView() {
    connect(m_view, &FaceView::hovered, this, &MainWindow::nameWhatIsThere);
    connect(m_view, &FaceView::picked, this, [this](const Vec3& point) {
        if (m_frameEditor->calibrating()) {
            m_frameEditor->place(point);
        } else {
            m_guide->place(point);
        }
    });
    connect(m_view, &FaceView::pickCancelled, this, [this] {
        if (m_frameEditor->calibrating()) {
            m_frameEditor->cancelCalibration();
            endPicking();
        }
    });
    connect(m_view, &FaceView::drawingFailed, this, &MainWindow::complain);
}

void MainWindow::connectShapeTools() {
    m_shapeTools = new ShapeTools(
        m_document, *m_view, *m_shapePanel,
        [this](const std::function<void(SimulationWorker&)>& call) { inWorker(call); }, this);
    connect(m_shapeTools, &ShapeTools::changed, this, &MainWindow::drawOver);
    connect(m_shapeTools, &ShapeTools::message, this,
            [this](const QString& sentence) { statusBar()->showMessage(sentence, 8000); });
    connect(m_worker, &SimulationWorker::dragFinished, this,
            [this](const std::shared_ptr<const DragOutcome>& outcome) {
                m_shapeTools->finished(*outcome);
            });
    connect(m_worker, &SimulationWorker::refused, this, [this](const QString& said) {
        const QString sentence = inWords(said.toStdString());
        m_shapeTools->refused(sentence);
        statusBar()->showMessage(sentence, 12000);
    });
}

void MainWindow::connectFrameEditor() {
    m_frameEditor = new ScanFrameEditor(this);
    connect(m_scanPanel, &ScanPanel::unitEdited, m_frameEditor, &ScanFrameEditor::setUnit);
    connect(m_scanPanel, &ScanPanel::turnAsked, m_frameEditor, &ScanFrameEditor::turnQuarter);
    connect(m_scanPanel, &ScanPanel::loosePartsEdited, this, [this](bool shown) {
        if (m_scene) {
            m_scene->show_loose_parts(shown);
            m_view->update();
        }
    });
    connect(m_scanPanel, &ScanPanel::calibrationAsked, m_frameEditor,
            &ScanFrameEditor::beginCalibration);
    connect(m_frameEditor, &ScanFrameEditor::asked, this, [this](const QString& instruction) {
        m_view->setPickMode(true);
        m_view->setFocus();
        statusBar()->showMessage(instruction);
    });
    connect(m_frameEditor, &ScanFrameEditor::distanceNeeded, this, &MainWindow::askDistance);
    connect(m_frameEditor, &ScanFrameEditor::reopenWanted, this, &MainWindow::reopen);
}

void MainWindow::colourScene() {
    const auto colour = [](const QColor& c) {
        return Eigen::Vector3f(float(c.redF()), float(c.greenF()), float(c.blueF()));
    };
    if (m_scene) {
        m_scene->scene().background_top = colour(themeColours().viewTop);
        m_scene->scene().background_bottom = colour(themeColours().viewBottom);
    }
}

void MainWindow::showSnapshot() {
    const auto snapshot = m_box.take();
    if (!snapshot || !m_scene || !m_document.model()) {
        return;
    }
    if (snapshot->positions.cols() != m_nodes) {
        return;  // of a face that was closed or fitted anew meanwhile
    }
    m_shown = snapshot;
    showAgain();
    const QString hand = m_shapeTools->words(*snapshot);
    m_state->setText(!hand.isEmpty() ? hand
                     : !m_callipers->words().isEmpty()
                         ? m_callipers->words()
                         : tr("largest move %1 mm · %2")
                               .arg(snapshot->report.max_displacement_mm, 0, 'f', 1)
                               .arg(snapshot->report.converged ? tr("at rest") : tr("moving")));
    if (snapshot->report.converged && !snapshot->dragging) {
        m_settled = true;
        Q_EMIT cameToRest();
    }
}

/// The newest moment, as the comparison wants it, with everything that lies over the face.
void MainWindow::showAgain() {
    if (!m_scene || !m_document.model() || !m_shown) {
        return;
    }
    const SimSnapshot shown = m_comparison->shown(*m_shown);
    m_view->setSkinPositions(shown.positions);
    m_scene->show(shown);
    m_comparison->paint(shown);
    m_shapeTools->setPaints(!m_comparison->paints());
    m_measures->show(m_comparison->before(), shown.positions,
                     m_shown->dragging || !m_shown->report.converged);
    drawStrokes(shown);
}

void MainWindow::drawStrokes(const SimSnapshot& shown) {
    SceneData& scene = m_scene->scene();
    scene.markers.clear();
    scene.strokes = {};
    m_shapeTools->draw(scene, shown);
    m_measures->draw(scene, shown.positions);
    m_callipers->draw(scene, shown.positions);
    m_landmarkEditor->draw(scene, shown.positions);
    m_view->update();
    if (m_patient) {
        m_patient->refresh();
    }
}

/// Redraws what lies over the face, without waiting for the next step of the simulation.
void MainWindow::drawOver() {
    if (m_scene && m_document.model() && m_shown && !m_shown->dragging) {
        drawStrokes(m_comparison->shown(*m_shown));
    }
}

void MainWindow::complain(const QString& said) {
    const QString sentence = inWords(said.toStdString());
    m_lastProblem = sentence;
    if (qEnvironmentVariableIsSet("MYOFACE_UNATTENDED")) {
        statusBar()->showMessage(sentence);
        return;
    }
    auto* box =
        new QMessageBox(QMessageBox::Warning, tr("Myoface"), sentence, QMessageBox::Ok, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().first().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    openPath(event->mimeData()->urls().first().toLocalFile());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (unsaved() && !m_mayClose) {
        event->ignore();
        leaveThen([this] {
            m_mayClose = true;
            QMetaObject::invokeMethod(
                this, [this] { close(); }, Qt::QueuedConnection);
        });
        return;
    }
    m_journal->finish();
    if (!qEnvironmentVariableIsSet("MYOFACE_UNATTENDED")) {
        QSettings().setValue(QStringLiteral("geometry"), saveGeometry());
    }
    if (m_patient) {
        m_patient->close();
    }
    event->accept();
}

void MainWindow::applySettings(const Settings& settings) {
    m_settings = settings;
    settings.write();
    applyTheme(*qApp, settings.theme);
    refreshIcons();
    colourScene();
    Language::instance().choose(settings.language);
    inWorker([form = settings.response](SimulationWorker& w) { w.setResponse(form); });
    m_settled = m_document.model() == nullptr;
    m_view->update();
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange && m_scanPanel != nullptr) {
        refreshShortcutTips();
        widenPanels();
        showMuscles();
        if (m_document.opened()) {
            m_scanPanel->setFace(*m_document.opened(), m_document.model().get(), m_springs);
            m_landmarks->setLandmarks(m_document.landmarks());
            setWindowTitle(
                tr("%1[*] — Myoface").arg(QString::fromStdString(m_document.opened()->name)));
        }
        showAgain();
    }
    QMainWindow::changeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    placeHints();
}

void MainWindow::exportFace() {
    if (m_document.model() && m_shown) {
        m_files->exportFace(*m_shown, m_reportPanel->words().anonymous);
    }
}

void MainWindow::exportAnimation(const QString& motion) {
    m_files->chooseAnimation(motion, m_reportPanel->words().anonymous);
}

void MainWindow::exportReport(const QString& path) {
    m_files->exportReport(path, m_reportPanel->words(), m_measures->population());
}

}  // namespace myoface
