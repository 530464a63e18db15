// SPDX-License-Identifier: Apache-2.0
#include "main_window.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QInputDialog>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <QToolTip>
#include <QUndoView>
#include <QVBoxLayout>

#include "myoface/base/error.h"
#include "myoface/muscle/user_expressions.h"
#include "myoface/muscle/weakening.h"
#include "myoface/scene/muscle_drawing.h"

#include "callipers.h"
#include "commands.h"
#include "compare_panel.h"
#include "comparison.h"
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
namespace {

constexpr double kGlideSeconds = 0.4;  // in which a chosen preset is reached
const char* const kLeast = "least";    ///< property of a dock: least width of its content [px]

/// The head in the picture: hairline to chin, ears in.
std::pair<Vec3, double> faceSphere(const OpenedFace& opened) {
    const Points& v = opened.scan->mesh.vertices;
    if (opened.landmarks) {
        const Landmarks& l = *opened.landmarks;
        const auto nose = l.count("prn") != 0 ? l.find("prn") : l.find("sn");
        if (nose != l.end()) {
            return {nose->second.position + Vec3(0.0, 8.0, -75.0), 128.0};
        }
    }
    return {0.5 * (v.rowwise().maxCoeff() + v.rowwise().minCoeff()),
            0.45 * (v.rowwise().maxCoeff() - v.rowwise().minCoeff()).norm()};
}

}  // namespace

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
        }
    });
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
    connect(m_measures, &MeasurePanel::chosen, this, &MainWindow::drawOver);
    connect(m_measures, &MeasurePanel::message, this, say);
    connect(m_measures, &MeasurePanel::problem, this, &MainWindow::complain);

    connect(m_reportPanel, &ReportPanel::notesEdited, &m_document, &FaceDocument::setNotes);
    connect(m_reportPanel, &ReportPanel::reportAsked, this,
            [this] { m_files->chooseReport(m_reportPanel->words(), m_measures->population()); });
    connect(m_reportPanel, &ReportPanel::pictureAsked, this,
            [this] { m_files->exportPicture(*m_view); });
    connect(m_reportPanel, &ReportPanel::turntableAsked, this,
            [this] { m_files->exportTurntable(*m_view); });
    connect(m_reportPanel, &ReportPanel::caseAsked, m_files, &FaceFiles::saveCaseAs);
    connect(m_reportPanel, &ReportPanel::faceAsked, this, [this] {
        if (m_document.model() && m_shown) {
            m_files->exportFace(*m_shown);
        }
    });
}

bool MainWindow::settled() const {
    return m_settled && !m_job && !m_landmarkEditor->fitting() && !m_comparison->busy();
}

MainWindow::~MainWindow() {
    m_job.reset();
    m_thread.quit();
    m_thread.wait();
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
    connect(m_worker, &SimulationWorker::refused, this, [this](const QString& sentence) {
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

void MainWindow::endPicking() {
    m_view->setPickMode(m_guide->active());
    statusBar()->clearMessage();
}

void MainWindow::askDistance(double measured) {
    endPicking();
    bool accepted = false;
    const double mm = QInputDialog::getDouble(
        this, tr("Calibrate"),
        tr("The two points are %1 mm apart as the scan is understood now.\nTheir true distance in "
           "mm (the iris is about 11.7 mm wide):")
            .arg(measured, 0, 'f', 1),
        measured, 0.1, 2000.0, 2, &accepted);
    if (accepted) {
        m_frameEditor->calibrate(mm);
    }
}

void MainWindow::reopen(const OpenOptions& options) {
    if (m_document.undoStack()->index() > 0 &&
        QMessageBox::question(this, tr("Change unit or axes"),
                              tr("The face is fitted anew, which ends the changes made to its "
                                 "shape and muscles. Go on?")) != QMessageBox::Yes) {
        m_scanPanel->setFace(*m_document.opened(), m_document.model().get(), m_springs);
        return;
    }
    startJob(m_files->path(), options);
}

void MainWindow::openPath(const QString& path) {
    if (mayLeave()) {
        startJob(path, {});
    }
}

void MainWindow::startJob(const QString& path, const OpenOptions& options) {
    OpenOptions known = options;
    if (known.passphrase.empty() && path == m_files->path()) {  // the same case once more
        known.passphrase = m_document.passphrase();
    }
    begin(std::make_unique<OpenJob>(path, known));
}

/// A protected case: asks for its passphrase and tries once more.
void MainWindow::askAndOpen(const OpenJob& job) {
    const std::optional<std::string> passphrase = askPassphrase(this, job.problem());
    if (!passphrase) {
        return;
    }
    if (job.recovery()) {
        begin(std::make_unique<OpenJob>(*job.recovery(), *passphrase));
        return;
    }
    OpenOptions options = job.options();
    options.passphrase = *passphrase;
    begin(std::make_unique<OpenJob>(job.path(), options));
}

void MainWindow::protectCase() {
    if (!m_document.opened()) {
        return;
    }
    if (const auto wanted = askNewPassphrase(this, !m_document.passphrase().empty())) {
        m_document.setPassphrase(*wanted);
        statusBar()->showMessage(wanted->empty()
                                     ? tr("The case will be saved without a passphrase.")
                                     : tr("The case will be saved with the passphrase."),
                                 8000);
    }
}

void MainWindow::recover(const Recovery& recovery) {
    begin(std::make_unique<OpenJob>(recovery));
}

void MainWindow::offerRecovery() {
    for (const Recovery& recovery : recoverable(m_journal->folder())) {
        QMessageBox box(QMessageBox::Question, tr("Myoface"),
                        tr("Myoface ended while %1 had changes that were not saved "
                           "(%2 steps, the last at %3).")
                            .arg(QString::fromStdString(recovery.name))
                            .arg(recovery.gestures)
                            .arg(QString::fromStdString(recovery.saved)),
                        QMessageBox::NoButton, this);
        const QAbstractButton* again = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
        const QAbstractButton* never = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
        box.addButton(tr("Not now"), QMessageBox::RejectRole);
        box.exec();
        if (box.clickedButton() == again) {
            recover(recovery);
            return;
        }
        if (box.clickedButton() == never) {
            discard(recovery);
        }
    }
}

void MainWindow::begin(std::unique_ptr<OpenJob> job) {
    m_job = std::move(job);
    connect(m_job.get(), &OpenJob::finished, this, &MainWindow::jobFinished);
    connect(m_job.get(), &OpenJob::progressed, this, [this](const QString& stage, int percent) {
        m_progress->setFormat(inWords(stage.toStdString()));
        m_progress->setValue(percent);
    });
    m_progress->setValue(0);
    m_progress->setFormat(tr("Opening"));
    m_progress->show();
    m_cancel->show();
    m_job->start();
}

void MainWindow::jobFinished() {
    m_progress->hide();
    m_cancel->hide();
    const std::unique_ptr<OpenJob> job = std::move(m_job);
    OpenResult& result = job->result();
    if (job->locked() && !qEnvironmentVariableIsSet("MYOFACE_UNATTENDED")) {
        askAndOpen(*job);
        return;
    }
    if (!job->problem().isEmpty()) {
        complain(job->problem());  // the window stays as it was
        Q_EMIT openFailed(job->problem());
        return;
    }
    m_files->setOpened(job->recovery() ? QStringLiteral("generic") : job->path());
    showFace(result);
    if (job->recovery()) {  // not saved yet: in a journal of its own before the old one goes
        m_document.undoStack()->resetClean();
        m_journal->noteNow();
        m_journal->flush();
        discard(*job->recovery());
    }
    Q_EMIT opened();
}

void MainWindow::showFace(OpenResult& result) {
    const OpenedFace& face = *result.opened;
    m_frameEditor->setFace(result.opened);
    dropScene();
    std::shared_ptr<const FaceModel> model;
    if (result.simulator) {
        model = result.simulator->shared_face();
        const FaceMassSpring& system = result.simulator->system();
        m_springs = static_cast<int>(system.model.springs.size());
        m_nodes = system.model.node_count();
        m_scene = std::make_unique<FaceScene>(model->scan, face.texture);
        m_scene->set_face(model, system.model.springs, system.chains);
        m_document.setFace(result.opened, model, result.simulator->contractions(),
                           result.simulator->skin_rest());
        showMuscles();
        m_view->setPickMode(false);
        m_guide->hide();
        auto holder = std::make_shared<std::unique_ptr<Simulator>>(std::move(result.simulator));
        inWorker([holder](SimulationWorker& w) { w.setSimulator(std::move(*holder)); });
    } else {
        m_springs = 0;
        m_scene = std::make_unique<FaceScene>(face.scan, face.texture);
        m_document.setFace(result.opened, nullptr, {}, {});
        inWorker([](SimulationWorker& w) { w.setSimulator(nullptr); });
        m_settled = true;
        m_view->setPickMode(true);
        m_guide->begin();
        statusBar()->showMessage(
            tr("This scan has no landmarks yet: click the points above, or open a landmark file."));
    }
    m_landmarkEditor->setFace(std::move(result.net));
    m_reportPanel->setNotes(m_document.notes());
    takeScene();
    const auto [centre, radius] = faceSphere(face);
    m_view->showStandardView(QStringLiteral("front"));
    m_view->frameFace(centre, radius);
    setWindowTitle(tr("%1[*] — Myoface").arg(QString::fromStdString(face.name)));
    setWindowModified(!m_document.undoStack()->isClean());
    showHints();
}

/// Nothing looks at the scene any more.
void MainWindow::dropScene() {
    m_shown.reset();
    m_view->setScene(nullptr);
    m_shapeTools->setScene(nullptr);
    m_comparison->setScene(nullptr);
    if (m_patient) {
        m_patient->setScene(nullptr);
    }
}

/// The new scene in everything that looks at it. The worker has its simulator already.
void MainWindow::takeScene() {
    const auto& model = m_document.model();
    const OpenedFace& face = *m_document.opened();
    m_view->setSkin(model ? model->skin.mesh : face.scan->mesh);
    m_scanPanel->setFace(face, model.get(), m_springs);
    m_layers->setEnabled(model != nullptr);
    m_muscles->setEnabled(model != nullptr);
    m_measures->setFace(model);
    m_callipers->setFace(model);
    m_scene->set_layers(m_layers->layers());
    m_scene->cut_away(m_layers->cutAway());
    colourScene();
    m_view->setScene(m_scene.get());
    m_shapeTools->setScene(m_scene.get());
    m_comparison->setScene(m_scene.get());
    if (m_patient) {
        m_patient->setScene(m_scene.get());
    }
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

/// The list of muscles with their settings, in the language of the interface.
void MainWindow::showMuscles() {
    const auto& model = m_document.model();
    if (!model) {
        return;
    }
    m_muscles->setMuscles(model->muscles);
    m_muscles->setSkinAge(m_document.skinAge());
    for (std::size_t m = 0; m < model->muscles.size(); ++m) {
        m_muscles->setRate(static_cast<int>(m), m_document.contractions().rate[m]);
        m_muscles->setStrength(static_cast<int>(m), m_document.contractions().strength[m]);
    }
}

void MainWindow::landmarksPlaced() {
    // Back into the file's own numbers: unit and axes are found anew from the points.
    LandmarkFile file;
    const FileFrame& frame = m_document.opened()->scan->frame;
    for (const auto& [name, landmark] : m_guide->placed()) {
        file.landmarks[name] = {frame.to_file(landmark.position), landmark.error_mm};
    }
    OpenOptions options;
    options.placed = file;
    startJob(m_files->path(), options);
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

/// The same scan with muscles and bone where the moved landmarks put them.
void MainWindow::showRefitted(FitJob& job) {
    dropScene();
    m_document.setModel(job.model(), job.simulator()->skin_rest());
    const FaceMassSpring& system = job.simulator()->system();
    m_springs = static_cast<int>(system.model.springs.size());
    m_nodes = system.model.node_count();
    m_scene = std::make_unique<FaceScene>(job.model()->scan, m_document.opened()->texture);
    m_scene->set_face(job.model(), system.model.springs, system.chains);
    auto holder = std::make_shared<std::unique_ptr<Simulator>>(std::move(job.simulator()));
    inWorker([holder, years = m_document.skinAge()](SimulationWorker& w) {
        w.setSimulator(std::move(*holder));
        w.setSkinAge(years);
    });
    takeScene();
}

void MainWindow::restMuscles() {
    std::vector<int> which;
    const std::vector<double>& rates = m_document.contractions().rate;
    for (std::size_t m = 0; m < rates.size(); ++m) {
        if (rates[m] != 0.0) {
            which.push_back(static_cast<int>(m));
        }
    }
    if (!which.empty()) {
        m_document.undoStack()->push(new SetMusclesCommand(m_document, MuscleSetting::Rate, which,
                                                           std::vector<double>(which.size(), 0.0),
                                                           -1, tr("muscles at rest")));
    }
}

void MainWindow::resetFace() {
    if (!m_document.model()) {
        return;
    }
    m_document.undoStack()->beginMacro(tr("reset"));
    restMuscles();
    const Points& scan = m_document.model()->skin.mesh.vertices;
    if (m_document.skinRest() != scan) {
        m_document.undoStack()->push(
            new ReshapeCommand(m_document, m_document.skinRest(), scan, tr("shape of the scan")));
    }
    m_document.undoStack()->endMacro();
}

void MainWindow::nameWhatIsThere(const ViewRay& ray, const std::optional<SurfacePoint>& where) {
    const auto& model = m_document.model();
    if (!model) {
        return;
    }
    const bool japanese = Language::instance().japanese();
    const LayerOpacity layers = m_layers->layers();
    const bool muscles = layers.muscles > 0.0F && (layers.skin < 0.9F || m_layers->cutAway() > 0.0);
    const std::optional<int> muscle = muscles ? muscle_on_ray(*model, ray) : std::nullopt;
    if (muscle) {
        const MuscleTraits& traits = model->muscles[static_cast<std::size_t>(*muscle)].traits;
        QToolTip::showText(QCursor::pos(),
                           QString::fromStdString(muscle_in_words(traits, japanese)), m_view);
        return;
    }
    QToolTip::hideText();
    if (where) {
        int corner = 0;
        where->weights.maxCoeff(&corner);
        statusBar()->showMessage(
            QString::fromStdString(tissue_in_words(
                *model, model->skin.mesh.triangles(corner, where->triangle), japanese)),
            2500);
    }
}

void MainWindow::setRates(const std::string& muscle, double rate) {
    setMuscles(MuscleSetting::Rate, muscle, rate);
}

void MainWindow::setStrengths(const std::string& muscle, double strength) {
    setMuscles(MuscleSetting::Strength, muscle, strength);
}

void MainWindow::setMuscles(MuscleSetting setting, const std::string& muscle, double value) {
    const std::vector<int> which = muscles_named(muscle);
    m_document.undoStack()->push(new SetMusclesCommand(
        m_document, setting, which, std::vector<double>(which.size(), value), -2,
        QString::fromStdString(
            m_document.model()->muscles[static_cast<std::size_t>(which[0])].traits.title)));
}

void MainWindow::pushExpression(std::vector<double> rates, const std::string& name, double left,
                                double right, int gesture) {
    const Expression expression = expression_named(name);
    Expression sided = expression;
    for (auto& [muscle, rate] : sided.rates) {
        const Side side = m_document.model()->muscles[static_cast<std::size_t>(muscle)].traits.side;
        rate *= side == Side::Left ? left : side == Side::Right ? right : 0.5 * (left + right);
    }
    add_expression(rates, sided, 1.0);
    std::vector<int> which(rates.size());
    std::iota(which.begin(), which.end(), 0);
    m_document.undoStack()->push(new SetMusclesCommand(m_document, MuscleSetting::Rate, which,
                                                       rates, gesture, inWords(expression.title)));
}

/// A preset from the list: alone, or on top of what the muscles did when it was chosen.
void MainWindow::chooseExpression(const std::string& name, double left, double right, int gesture,
                                  bool fresh) {
    const std::vector<double>& now = m_document.contractions().rate;
    if (fresh || m_expressionBase.size() != now.size()) {
        m_expressionBase = m_muscles->blends() ? now : std::vector<double>(now.size(), 0.0);
    }
    const double seconds = fresh && m_muscles->glides() ? kGlideSeconds : 0.0;
    inWorker([seconds](SimulationWorker& w) { w.beginGlide(seconds); });
    pushExpression(m_expressionBase, name, left, right, gesture);
    inWorker([](SimulationWorker& w) { w.endGlide(); });
}

/// Changes the user's own presets and lists them anew.
void MainWindow::changePresets(const QString& chosen, const std::function<void()>& change) {
    try {
        change();
        m_muscles->listExpressions(chosen);
    } catch (const Error& error) {
        complain(QString::fromUtf8(error.what()));
    }
}

void MainWindow::addExpression(const std::string& name, double intensity) {
    if (m_document.model()) {
        pushExpression(m_document.contractions().rate, name, intensity, intensity, -2);
    }
}

/// Sets a ready set of weak muscles, and all others back to full strength.
void MainWindow::weaken(const std::string& preset, bool left, bool right) {
    if (!m_document.model()) {
        return;
    }
    std::vector<double> strengths(m_document.model()->muscles.size(), 1.0);
    QString title = tr("full strength");
    if (!preset.empty()) {
        const Weakening set = weakening_named(preset + (left && right ? "" : left ? ".L" : ".R"));
        for (const auto& [muscle, strength] : set.strengths) {
            strengths[static_cast<std::size_t>(muscle)] = strength;
        }
        title = inWords(set.title);
    }
    std::vector<int> all(strengths.size());
    std::iota(all.begin(), all.end(), 0);
    m_document.undoStack()->push(
        new SetMusclesCommand(m_document, MuscleSetting::Strength, all, strengths, -1, title));
}

void MainWindow::setSkinAge(double years) {
    m_document.undoStack()->push(new SetSkinAgeCommand(
        m_document, std::clamp(years, kYoungestSkin, kOldestSkin), -2, tr("age of the skin")));
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

void MainWindow::complain(const QString& sentence) {
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

/// Whether the face may go: asks when there are changes that are not saved.
bool MainWindow::mayLeave() {
    if (m_document.undoStack()->isClean() || qEnvironmentVariableIsSet("MYOFACE_UNATTENDED")) {
        return true;
    }
    QMessageBox box(QMessageBox::Question, tr("Myoface"), tr("Save the changes to this face?"),
                    QMessageBox::NoButton, this);
    const QAbstractButton* save = box.addButton(tr("Save"), QMessageBox::AcceptRole);
    const QAbstractButton* drop = box.addButton(tr("Don't save"), QMessageBox::DestructiveRole);
    box.addButton(tr("Cancel"), QMessageBox::RejectRole);
    box.exec();
    return box.clickedButton() == drop || (box.clickedButton() == save && m_files->saveCase());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayLeave()) {
        event->ignore();
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

void MainWindow::exportReport(const QString& path) {
    m_files->exportReport(path, m_reportPanel->words(), m_measures->population());
}

}  // namespace myoface
