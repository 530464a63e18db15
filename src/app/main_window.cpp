// SPDX-License-Identifier: Apache-2.0
#include "main_window.h"

#include <numeric>

#include <QAction>
#include <QActionGroup>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QToolTip>
#include <QVBoxLayout>

#include "myoface/base/error.h"
#include "myoface/muscle/expression.h"
#include "myoface/scene/muscle_drawing.h"

#include "commands.h"
#include "landmark_editor.h"
#include "landmark_guide.h"
#include "landmark_panel.h"
#include "layer_panel.h"
#include "muscle_panel.h"
#include "open_job.h"
#include "report_export.h"
#include "scan_frame_editor.h"
#include "scan_panel.h"
#include "shape_panel.h"
#include "shape_tools.h"

namespace myoface {
namespace {

constexpr int kRecentFiles = 8;
const char* const kRecentKey = "recentFiles";

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

template <typename Call>
void MainWindow::inWorker(const Call& call) {
    m_settled = false;
    QMetaObject::invokeMethod(
        m_worker, [worker = m_worker, call] { call(*worker); }, Qt::QueuedConnection);
}

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
    qRegisterMetaType<std::shared_ptr<const DragOutcome>>();
    setWindowTitle(tr("Myoface"));
    setAcceptDrops(true);
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

    buildDocks();
    buildActions();
    connectView();
    connectFrameEditor();
    connectShapeTools();
    m_report = new ReportExport(this);
    connect(m_report, &ReportExport::written, this, [this](const QString& file) {
        statusBar()->showMessage(tr("Written: %1").arg(file), 8000);
        Q_EMIT reportWritten(file);
    });
    connect(m_report, &ReportExport::failed, this, &MainWindow::complain);

    connect(&m_document, &FaceDocument::rateChanged, this, [this](int muscle, double rate) {
        m_muscles->setRate(muscle, rate);
        inWorker([muscle, rate](SimulationWorker& w) { w.setRate(muscle, rate); });
    });
    connect(&m_document, &FaceDocument::skinRestChanged, this, [this] {
        inWorker([rest = m_document.skinRest()](SimulationWorker& w) { w.setSkinRest(rest); });
    });
    connect(m_muscles, &MusclePanel::ratesEdited, this,
            [this](const std::vector<int>& which, double rate, int gesture, const QString& title) {
                m_document.undoStack()->push(new SetRatesCommand(
                    m_document, which, std::vector<double>(which.size(), rate), gesture, title));
            });
    connect(m_muscles, &MusclePanel::expressionChosen, this,
            [this](const std::string& name, double intensity, int gesture) {
                if (m_document.model()) {  // from rest: the list shows one expression at a time
                    pushExpression(std::vector<double>(m_document.contractions().rate.size(), 0.0),
                                   name, intensity, gesture);
                }
            });
    connect(m_muscles, &MusclePanel::resetRequested, this, &MainWindow::restMuscles);
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

    auto* note = new QLabel(tr("A planning and communication aid, not a medical device"));
    note->setStyleSheet(QStringLiteral("color: #8d99a5; padding: 0 10px;"));
    m_state = new QLabel;
    m_progress = new QProgressBar;
    m_progress->setMaximumWidth(220);
    m_cancel = new QPushButton(tr("Cancel"));
    statusBar()->addPermanentWidget(m_progress);
    statusBar()->addPermanentWidget(m_cancel);
    statusBar()->addPermanentWidget(m_state);
    statusBar()->addPermanentWidget(note);
    m_progress->hide();
    m_cancel->hide();
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_job) {
            m_job->cancel();
        }
    });
}

bool MainWindow::settled() const {
    return m_settled && !m_job && !m_landmarkEditor->fitting();
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
        result->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
        addDockWidget(area, result);
        return result;
    };
    m_muscles = new MusclePanel;
    m_muscles->setMinimumWidth(310);
    m_layers = new LayerPanel;
    m_scanPanel = new ScanPanel;
    m_scanPanel->setMinimumWidth(230);
    dock(tr("Muscles"), QStringLiteral("muscles"), m_muscles, Qt::RightDockWidgetArea);
    auto* layers = dock(tr("Layers"), QStringLiteral("layers"), m_layers, Qt::LeftDockWidgetArea);
    auto* scan = dock(tr("Scan"), QStringLiteral("scan"), m_scanPanel, Qt::LeftDockWidgetArea);
    splitDockWidget(layers, scan, Qt::Vertical);
    m_landmarks = new LandmarkPanel;
    m_landmarks->setMinimumWidth(250);
    auto* landmarks =
        dock(tr("Landmarks"), QStringLiteral("landmarks"), m_landmarks, Qt::LeftDockWidgetArea);
    tabifyDockWidget(scan, landmarks);
    m_shapePanel = new ShapePanel;
    m_shapePanel->setMinimumWidth(250);
    auto* shape = dock(tr("Shape"), QStringLiteral("shape"), m_shapePanel, Qt::LeftDockWidgetArea);
    tabifyDockWidget(landmarks, shape);
    scan->raise();
    m_landmarkEditor = new LandmarkEditor(m_document, *m_view, *m_landmarks, this);
    connect(m_landmarkEditor, &LandmarkEditor::changed, this, &MainWindow::drawOver);
    connect(m_landmarkEditor, &LandmarkEditor::fitted, this, &MainWindow::showRefitted);
    connect(m_landmarkEditor, &LandmarkEditor::problem, this, &MainWindow::complain);
    resizeDocks({layers, scan}, {190, 500}, Qt::Vertical);
    m_layers->setEnabled(false);
    m_muscles->setEnabled(false);
}

void MainWindow::buildActions() {
    const auto add = [this](QMenu* menu, const QString& text, const QKeySequence& key,
                            auto&& call) {
        QAction* action = menu->addAction(text);
        action->setShortcut(key);
        connect(action, &QAction::triggered, this, call);
        return action;
    };
    QMenu* file = menuBar()->addMenu(tr("&File"));
    add(file, tr("&Open…"), QKeySequence::Open, [this] { chooseFile(); });
    m_recent = file->addMenu(tr("Open &recent"));
    connect(m_recent, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
    add(file, tr("Open the &built-in face"), {}, [this] { openPath(QStringLiteral("generic")); });
    add(file, tr("Open &landmarks…"), QKeySequence(tr("Ctrl+L")), [this] { chooseLandmarks(); });
    add(file, tr("&Place landmarks by hand"), {}, [this] {
        if (m_document.opened()) {
            m_view->setPickMode(true);
            m_guide->begin();
        }
    });
    file->addSeparator();
    add(file, tr("&Save case…"), QKeySequence::Save, [this] { saveCase(); });
    add(file, tr("&Export face…"), QKeySequence(tr("Ctrl+E")), [this] { saveScan(); });
    add(file, tr("Export p&icture…"), QKeySequence(tr("Ctrl+Shift+E")), [this] { savePicture(); });
    add(file, tr("Export &report…"), QKeySequence(tr("Ctrl+R")), [this] { saveReport(); });
    file->addSeparator();
    add(file, tr("&Quit"), QKeySequence::Quit, [this] { close(); });

    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    QAction* undo = m_document.undoStack()->createUndoAction(this, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction* redo = m_document.undoStack()->createRedoAction(this, tr("&Redo"));
    redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
    edit->addActions({undo, redo});
    edit->addSeparator();
    add(edit, tr("All muscles at &rest"), {}, [this] { restMuscles(); });
    QAction* reset = add(edit, tr("Reset &face"), {}, [this] { resetFace(); });
    reset->setToolTip(tr("Back to the scan: muscles at rest, shape as it came"));

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
        add(view, v.title, QKeySequence(QString::fromLatin1(v.key)),
            [this, name = QString::fromLatin1(v.name)] { m_view->showStandardView(name); });
    }
    view->addSeparator();
    QAction* orthographic = view->addAction(tr("&Orthographic"));
    orthographic->setCheckable(true);
    orthographic->setShortcut(QKeySequence(tr("Ctrl+P")));
    connect(orthographic, &QAction::toggled, m_view, &FaceView::setOrthographic);

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

    auto* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    auto* tools = new QActionGroup(this);
    struct ToolEntry {
        QString title, tip;
        Tool tool;
        const char* key;
    };
    for (const ToolEntry& entry :
         {ToolEntry{tr("Turn"), tr("Left drag turns the head (Q)"), Tool::Navigate, "Q"},
          ToolEntry{tr("Shape"),
                    tr("Mouse priority: the skin point follows the cursor, depth comes from the "
                       "tissue, the shape stays (W)"),
                    Tool::Shape, "W"},
          ToolEntry{tr("Feel"),
                    tr("Constraint priority: a stress pulls at the skin, tissue holds it back, on "
                       "release it springs back (E)"),
                    Tool::Feel, "E"},
          ToolEntry{tr("Volume"),
                    tr("A click adds the volume that the Shape panel says, under the skin (R)"),
                    Tool::Volume, "R"},
          ToolEntry{tr("Protect"), tr("Left drag paints skin that gestures leave alone (T)"),
                    Tool::Protect, "T"}}) {
        QAction* action = bar->addAction(entry.title);
        action->setCheckable(true);
        action->setToolTip(entry.tip);
        action->setShortcut(QKeySequence(QString::fromLatin1(entry.key)));
        action->setObjectName(QStringLiteral("tool%1").arg(QString::fromLatin1(entry.key)));
        tools->addAction(action);
        connect(action, &QAction::triggered, this, [this, entry] {
            m_view->setTool(entry.tool);
            statusBar()->showMessage(entry.tip, 8000);
        });
        action->setChecked(entry.tool == Tool::Shape);
    }
    bar->addSeparator();
    bar->addActions({undo, redo});
    bar->addSeparator();
    for (const auto& [title, name] :
         {std::pair(tr("Front"), "front"), std::pair(tr("Left"), "left"),
          std::pair(tr("Right"), "right"), std::pair(tr("¾ Left"), "three-quarter-left"),
          std::pair(tr("¾ Right"), "three-quarter-right")}) {
        QAction* action = bar->addAction(title);
        connect(action, &QAction::triggered, this,
                [this, n = QString::fromLatin1(name)] { m_view->showStandardView(n); });
    }
    bar->addSeparator();
    QAction* before = bar->addAction(tr("Before"));
    before->setCheckable(true);
    before->setToolTip(tr("Shows the scan as it came; the space bar does so while it is held"));
    connect(before, &QAction::toggled, this, &MainWindow::showBefore);
    bar->addAction(reset);

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    add(help, tr("&Mouse and keys"), QKeySequence::HelpContents, [this] {
        QMessageBox::information(
            this, tr("Mouse and keys"),
            tr("<p><b>Left drag on skin</b>: shape or feel, as the tool says<br>"
               "<b>Left drag beside the face</b>, <b>Alt + left</b>, <b>middle</b>: turn<br>"
               "<b>Right drag</b>, <b>Shift + middle</b>: pan · <b>Wheel</b>: zoom<br>"
               "<b>Q W E R T</b>: turn, shape, feel, volume, protect<br>"
               "<b>F</b>: radius of the grip · <b>X</b>: both sides · <b>Arrows</b>: 0.1 mm, with "
               "Shift 1 mm<br>"
               "<b>Ctrl+1, 3, 5, 7</b>: standard views<br>"
               "<b>Space</b>: hold to see the scan as it came · <b>Home</b>: whole head<br>"
               "<b>Esc</b>: give up the gesture · <b>Ctrl+Z, Ctrl+Shift+Z</b>: undo, redo<br>"
               "<b>Double click on a slider</b>: muscle at rest</p>"));
    });
    add(help, tr("&About Myoface"), {}, [this] { about(); });
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
    connect(m_view, &FaceView::beforeHeld, this, &MainWindow::showBefore);
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
    startJob(m_path, options);
}

void MainWindow::openPath(const QString& path) {
    startJob(path, {});
}

void MainWindow::startJob(const QString& path, const OpenOptions& options) {
    m_job = std::make_unique<OpenJob>(path, options);
    connect(m_job.get(), &OpenJob::finished, this, &MainWindow::jobFinished);
    connect(m_job.get(), &OpenJob::progressed, this, [this](const QString& stage, int percent) {
        m_progress->setFormat(stage);
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
    if (!job->problem().isEmpty()) {
        complain(job->problem());  // the window stays as it was
        Q_EMIT openFailed(job->problem());
        return;
    }
    m_path = job->path();
    showFace(result);
    rememberRecent(m_path);
    Q_EMIT opened();
}

void MainWindow::showFace(OpenResult& result) {
    const OpenedFace& face = *result.opened;
    m_frameEditor->setFace(result.opened);
    m_view->setScene(nullptr);
    m_shapeTools->setScene(nullptr);
    m_shown.reset();
    std::shared_ptr<const FaceModel> model;
    if (result.simulator) {
        model = result.simulator->shared_face();
    }
    m_scene = std::make_unique<FaceScene>(model ? model->scan : face.scan, face.texture);
    if (result.simulator) {
        m_scene->set_face(model, result.simulator->system().model.springs,
                          result.simulator->system().chains);
        m_muscles->setMuscles(model->muscles);
        for (std::size_t m = 0; m < model->muscles.size(); ++m) {
            m_muscles->setRate(static_cast<int>(m), result.simulator->contractions().rate[m]);
        }
        m_document.setFace(result.opened, model, result.simulator->contractions(),
                           result.simulator->skin_rest());
        m_view->setSkin(model->skin.mesh);
        m_view->setPickMode(false);
        m_guide->hide();
        m_springs = static_cast<int>(result.simulator->system().model.springs.size());
        m_nodes = result.simulator->system().model.node_count();
        m_scanPanel->setFace(face, model.get(), m_springs);
        auto holder = std::make_shared<std::unique_ptr<Simulator>>(std::move(result.simulator));
        inWorker([holder](SimulationWorker& w) { w.setSimulator(std::move(*holder)); });
    } else {
        m_document.setFace(result.opened, nullptr, {}, {});
        m_view->setSkin(face.scan->mesh);
        m_springs = 0;
        m_scanPanel->setFace(face, nullptr, 0);
        inWorker([](SimulationWorker& w) { w.setSimulator(nullptr); });
        m_settled = true;
        m_view->setPickMode(true);
        m_guide->begin();
        statusBar()->showMessage(
            tr("This scan has no landmarks yet: click the points above, or open a landmark file."));
    }
    m_landmarkEditor->setFace(std::move(result.net));
    m_layers->setEnabled(model != nullptr);
    m_muscles->setEnabled(model != nullptr);
    m_scene->set_layers(m_layers->layers());
    m_scene->cut_away(m_layers->cutAway());
    m_view->setScene(m_scene.get());
    m_shapeTools->setScene(m_scene.get());
    const auto [centre, radius] = faceSphere(face);
    m_view->showStandardView(QStringLiteral("front"));
    m_view->frameFace(centre, radius);
    setWindowTitle(tr("%1 — Myoface").arg(QString::fromStdString(face.name)));
}

void MainWindow::chooseFile() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open a face"), QFileInfo(m_path).absolutePath(),
        tr("Faces (*.obj *.ply *.stl *.glb *.gltf *.myoface);;All files (*)"));
    if (!path.isEmpty()) {
        openPath(path);
    }
}

void MainWindow::chooseLandmarks() {
    if (!m_document.opened()) {
        return;
    }
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open landmarks"), QFileInfo(m_path).absolutePath(),
                                     tr("Landmarks (*.json);;All files (*)"));
    if (!path.isEmpty()) {
        OpenOptions options;
        options.landmarks = path.toStdString();
        startJob(m_path, options);
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
    startJob(m_path, options);
}

void MainWindow::saveScan() {
    if (!m_document.model() || !m_shown) {
        return;
    }
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Export the face as it is shown"), QFileInfo(m_path).absolutePath(),
        tr("OBJ (*.obj);;PLY (*.ply);;GLB (*.glb);;STL (*.stl)"));
    if (path.isEmpty()) {
        return;
    }
    try {
        write_face(path.toStdString(), *m_document.opened()->scan, *m_document.model(),
                   m_shown->positions, m_shown->jaw);
        statusBar()->showMessage(tr("Written: %1").arg(path), 6000);
    } catch (const Error& error) {
        complain(QString::fromUtf8(error.what()));
    }
}

void MainWindow::saveCase() {
    if (!m_document.opened()) {
        return;
    }
    QString path =
        QFileDialog::getSaveFileName(this, tr("Save the case"), QFileInfo(m_path).absolutePath(),
                                     tr("Myoface case (*.myoface)"));
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += QStringLiteral(".myoface");
    }
    try {
        CaseState state;
        if (m_document.model()) {
            state =
                case_state(*m_document.model(), m_document.contractions(), m_document.skinRest());
        }
        write_case(path.toStdString(), m_document.asSaved(), state);
        m_document.undoStack()->setClean();
        rememberRecent(path);
        statusBar()->showMessage(tr("Saved: %1").arg(path), 6000);
    } catch (const Error& error) {
        complain(QString::fromUtf8(error.what()));
    }
}

void MainWindow::saveReport() {
    if (!m_document.model() || m_report->running()) {
        return;
    }
    QString path = QFileDialog::getSaveFileName(
        this, tr("Export a report"), QFileInfo(m_path).absolutePath(), tr("PDF (*.pdf)"));
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo(path).suffix().isEmpty()) {
        path += QStringLiteral(".pdf");
    }
    bool accepted = false;
    const QString notes = QInputDialog::getMultiLineText(
        this, tr("Export a report"), tr("Notes at the end of the report:"), {}, &accepted);
    if (accepted) {
        exportReport(path, notes);
    }
}

void MainWindow::exportReport(const QString& path, const QString& notes) {
    try {
        m_report->start(m_document, path, {}, notes);
        statusBar()->showMessage(tr("Writing the report…"));
    } catch (const Error& error) {
        complain(QString::fromUtf8(error.what()));
    }
}

void MainWindow::savePicture() {
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Export a picture"), QFileInfo(m_path).absolutePath(), tr("PNG (*.png)"));
    if (!path.isEmpty() && !m_view->grabFramebuffer().save(path)) {
        complain(tr("%1: cannot be written.").arg(path));
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
    m_view->setSkinPositions(snapshot->positions);
    if (!m_before) {
        m_scene->show(*snapshot);
    }
    SceneData& scene = m_scene->scene();
    scene.markers.clear();
    scene.strokes = {};
    m_shapeTools->draw(scene, *snapshot);
    const QString hand = m_shapeTools->words(*snapshot);
    m_state->setText(!hand.isEmpty()
                         ? hand
                         : tr("largest move %1 mm · %2")
                               .arg(snapshot->report.max_displacement_mm, 0, 'f', 1)
                               .arg(snapshot->report.converged ? tr("at rest") : tr("moving")));
    m_landmarkEditor->draw(scene, snapshot->positions);
    m_view->update();
    if (snapshot->report.converged && !snapshot->dragging) {
        m_settled = true;
        Q_EMIT cameToRest();
    }
}

/// Redraws what lies over the face, without waiting for the next step of the simulation.
void MainWindow::drawOver() {
    if (!m_scene || !m_document.model() || !m_shown || m_shown->dragging) {
        return;
    }
    m_scene->scene().markers.clear();
    m_scene->scene().strokes = {};
    m_shapeTools->draw(m_scene->scene(), *m_shown);
    m_landmarkEditor->draw(m_scene->scene(), m_shown->positions);
    m_view->update();
}

/// The same scan with muscles and bone where the moved landmarks put them.
void MainWindow::showRefitted(FitJob& job) {
    m_document.setModel(job.model(), job.simulator()->skin_rest());
    const FaceMassSpring& system = job.simulator()->system();
    m_springs = static_cast<int>(system.model.springs.size());
    m_nodes = system.model.node_count();
    m_shown.reset();
    m_view->setScene(nullptr);
    m_shapeTools->setScene(nullptr);
    m_scene = std::make_unique<FaceScene>(job.model()->scan, m_document.opened()->texture);
    m_scene->set_face(job.model(), system.model.springs, system.chains);
    m_view->setSkin(job.model()->skin.mesh);
    m_view->setScene(m_scene.get());
    m_shapeTools->setScene(m_scene.get());
    m_scene->set_layers(m_layers->layers());
    m_scene->cut_away(m_layers->cutAway());
    m_scanPanel->setFace(*m_document.opened(), job.model().get(), m_springs);
    auto holder = std::make_shared<std::unique_ptr<Simulator>>(std::move(job.simulator()));
    inWorker([holder](SimulationWorker& w) { w.setSimulator(std::move(*holder)); });
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
        m_document.undoStack()->push(new SetRatesCommand(
            m_document, which, std::vector<double>(which.size(), 0.0), -1, tr("muscles at rest")));
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
    const bool japanese = locale().language() == QLocale::Japanese;
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

void MainWindow::showBefore(bool held) {
    m_before = held;
    if (!m_scene || !m_document.model() || !m_shown) {
        return;
    }
    SimSnapshot snapshot = *m_shown;
    if (held) {
        snapshot.positions.leftCols(m_document.model()->node_count()) =
            m_document.model()->skin.mesh.vertices;
        snapshot.jaw = 0.0;
    }
    m_scene->show(snapshot);
    m_view->update();
}

void MainWindow::setRates(const std::string& muscle, double rate) {
    const std::vector<int> which = muscles_named(muscle);
    m_document.undoStack()->push(new SetRatesCommand(
        m_document, which, std::vector<double>(which.size(), rate), -2,
        QString::fromStdString(
            m_document.model()->muscles[static_cast<std::size_t>(which[0])].traits.title)));
}

void MainWindow::pushExpression(std::vector<double> rates, const std::string& name,
                                double intensity, int gesture) {
    const Expression expression = expression_named(name);
    add_expression(rates, expression, intensity);
    std::vector<int> which(rates.size());
    std::iota(which.begin(), which.end(), 0);
    m_document.undoStack()->push(new SetRatesCommand(
        m_document, which, rates, gesture,
        QString::fromStdString(locale().language() == QLocale::Japanese ? expression.title_ja
                                                                        : expression.title)));
}

void MainWindow::addExpression(const std::string& name, double intensity) {
    if (m_document.model()) {
        pushExpression(m_document.contractions().rate, name, intensity, -2);
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

void MainWindow::rememberRecent(const QString& path) {
    if (path == QStringLiteral("generic")) {
        return;
    }
    QSettings settings;
    QStringList files = settings.value(QString::fromLatin1(kRecentKey)).toStringList();
    const QString full = QFileInfo(path).absoluteFilePath();
    files.removeAll(full);
    files.prepend(full);
    settings.setValue(QString::fromLatin1(kRecentKey), QStringList(files.mid(0, kRecentFiles)));
}

void MainWindow::fillRecent() {
    m_recent->clear();
    const QStringList files = QSettings().value(QString::fromLatin1(kRecentKey)).toStringList();
    for (const QString& path : files) {
        QAction* action = m_recent->addAction(QFileInfo(path).fileName());
        action->setToolTip(path);
        connect(action, &QAction::triggered, this, [this, path] { openPath(path); });
    }
    if (files.isEmpty()) {
        m_recent->addAction(tr("None yet"))->setEnabled(false);
    }
}

void MainWindow::about() {
    QMessageBox::about(
        this, tr("About Myoface"),
        tr("<h3>Myoface %1</h3><p>Facial surgery consultation simulator on a muscle-spring "
           "model.</p><p>A planning and communication aid, not a medical device: what it shows is "
           "an estimate, not a promise of a result.</p><p>Apache License 2.0.</p>")
            .arg(QStringLiteral(MYOFACE_VERSION)));
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
    if (m_document.undoStack()->isClean() || qEnvironmentVariableIsSet("MYOFACE_UNATTENDED")) {
        event->accept();
        return;
    }
    const auto answer = QMessageBox::question(
        this, tr("Myoface"), tr("Save the changes to this face before closing?"),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) {
        saveCase();
    }
    const bool leave = answer == QMessageBox::Discard ||
                       (answer == QMessageBox::Save && m_document.undoStack()->isClean());
    event->setAccepted(leave);
}

}  // namespace myoface
