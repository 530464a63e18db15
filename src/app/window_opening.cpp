// SPDX-License-Identifier: Apache-2.0
// How faces come into the main window and go.
#include <memory>
#include <tuple>

#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QThreadPool>

#include "callipers.h"
#include "comparison.h"
#include "comparison_jobs.h"
#include "face_files.h"
#include "fit_job.h"
#include "journal_keeper.h"
#include "landmark_editor.h"
#include "landmark_guide.h"
#include "language.h"
#include "layer_panel.h"
#include "main_window.h"
#include "measure_panel.h"
#include "muscle_panel.h"
#include "open_job.h"
#include "passphrase_dialog.h"
#include "patient_view.h"
#include "report_panel.h"
#include "scan_frame_editor.h"
#include "scan_panel.h"
#include "shape_tools.h"

namespace myoface {
namespace {

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

/// What was open goes in another thread: a million vertices take a while to free.
void letGo(std::unique_ptr<FaceScene> scene, std::shared_ptr<const OpenedFace> opened,
           std::shared_ptr<const FaceModel> model) {
    auto held =
        std::make_shared<std::tuple<std::unique_ptr<FaceScene>, std::shared_ptr<const OpenedFace>,
                                    std::shared_ptr<const FaceModel>>>(
            std::move(scene), std::move(opened), std::move(model));
    QThreadPool::globalInstance()->start([held = std::move(held)] {});
}

}  // namespace

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
    leaveThen([this, path] { startJob(path, {}); });
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

/// Soft shadows come a moment after the face.
void MainWindow::shade() {
    const auto& model = m_document.model();
    retire(m_shading);
    m_shading = std::make_unique<ShadeJob>(model ? model->scan : m_document.opened()->scan);
    connect(m_shading.get(), &ShadeJob::finished, this, [this] {
        const std::unique_ptr<ShadeJob> job = std::move(m_shading);
        if (m_scene && job->problem().isEmpty()) {
            m_scene->set_visibility(job->result());
            m_view->update();
        }
    });
    m_shading->start();
}

void MainWindow::begin(std::unique_ptr<OpenJob> job) {
    retire(m_job);
    m_job = std::move(job);
    connect(m_job.get(), &OpenJob::finished, this, &MainWindow::jobFinished);
    connect(m_job.get(), &OpenJob::progressed, this, [this](const QString& stage, int percent) {
        m_progress->setFormat(inWords(stage.toStdString()));
        showShare(percent);
    });
    showWork(tr("Opening"));
    m_job->start();
}

void MainWindow::jobFinished() {
    hideWork();
    const std::unique_ptr<OpenJob> job = std::move(m_job);
    OpenResult& result = job->result();
    if (job->locked() && !qEnvironmentVariableIsSet("MYOFACE_UNATTENDED")) {
        askAndOpen(*job);
        return;
    }
    if (job->cancelled()) {
        statusBar()->showMessage(tr("Opening was cancelled."), 8000);
        Q_EMIT openFailed(job->problem());
        return;
    }
    if (!job->problem().isEmpty()) {
        const QString sentence = inWords(job->problem().toStdString());
        complain(sentence);  // the window stays as it was
        Q_EMIT openFailed(sentence);
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
    letGo(std::move(m_scene), m_document.opened(), m_document.model());
    m_scene = std::move(result.scene);
    std::shared_ptr<const FaceModel> model;
    if (result.simulator) {
        model = result.simulator->shared_face();
        const FaceMassSpring& system = result.simulator->system();
        m_springs = static_cast<int>(system.model.springs.size());
        m_nodes = system.model.node_count();
        m_document.setFace(result.opened, model, result.simulator->contractions(),
                           result.simulator->skin_rest());
        showMuscles();
        m_view->setPickMode(false);
        m_guide->hide();
        auto holder = std::make_shared<std::unique_ptr<Simulator>>(std::move(result.simulator));
        inWorker([holder](SimulationWorker& w) { w.setSimulator(std::move(*holder)); });
    } else {
        m_springs = 0;
        m_document.setFace(result.opened, nullptr, {}, {});
        inWorker([](SimulationWorker& w) { w.setSimulator(nullptr); });
        m_settled = true;
        m_view->setPickMode(true);
        m_guide->begin();
        statusBar()->showMessage(
            tr("This scan has no landmarks yet: click the points above, or open a landmark file."));
    }
    m_landmarkEditor->setFace(std::move(result.net), result.bvh);
    m_reportPanel->setNotes(m_document.notes());
    takeScene(std::move(result.bvh), std::move(result.places));
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
    retire(m_shading);
    m_view->setScene(nullptr);
    m_shapeTools->setScene(nullptr);
    m_comparison->setScene(nullptr);
    if (m_patient) {
        m_patient->setScene(nullptr);
    }
}

/// The new scene in everything that looks at it. The worker has its simulator already.
void MainWindow::takeScene(Bvh bvh, const std::shared_ptr<const LandmarksOnSkin>& places) {
    const auto& model = m_document.model();
    const OpenedFace& face = *m_document.opened();
    m_view->setSkin(model ? model->skin.mesh : face.scan->mesh, std::move(bvh));
    m_scanPanel->setFace(face, model.get(), m_springs);
    m_layers->setEnabled(model != nullptr);
    m_muscles->setEnabled(model != nullptr);
    m_measures->setFace(model, places);
    m_callipers->setFace(model);
    m_scene->set_layers(m_layers->layers());
    m_scene->cut_away(m_layers->cutAway());
    colourScene();
    m_view->setScene(m_scene.get());
    shade();
    m_shapeTools->setScene(m_scene.get(), places);
    m_comparison->setScene(m_scene.get());
    if (m_patient) {
        m_patient->setScene(m_scene.get());
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

/// The same scan with muscles and bone where the moved landmarks put them.
void MainWindow::showRefitted(FitJob& job) {
    dropScene();
    m_document.setModel(job.model(), job.simulator()->skin_rest());
    const FaceMassSpring& system = job.simulator()->system();
    m_springs = static_cast<int>(system.model.springs.size());
    m_nodes = system.model.node_count();
    letGo(std::move(m_scene), nullptr, nullptr);
    m_scene = std::move(job.scene());
    auto holder = std::make_shared<std::unique_ptr<Simulator>>(std::move(job.simulator()));
    inWorker([holder, years = m_document.skinAge()](SimulationWorker& w) {
        w.setSimulator(std::move(*holder));
        w.setSkinAge(years);
    });
    takeScene(job.bvh(), job.places());
}

bool MainWindow::unsaved() {
    return !m_document.undoStack()->isClean() && !qEnvironmentVariableIsSet("MYOFACE_UNATTENDED");
}

/// Goes on when the face may go: asks when there are changes that are not saved.
void MainWindow::leaveThen(const std::function<void()>& then) {
    if (!unsaved()) {
        then();
        return;
    }
    QMessageBox box(QMessageBox::Question, tr("Myoface"), tr("Save the changes to this face?"),
                    QMessageBox::NoButton, this);
    const QAbstractButton* save = box.addButton(tr("Save"), QMessageBox::AcceptRole);
    const QAbstractButton* drop = box.addButton(tr("Don't save"), QMessageBox::DestructiveRole);
    box.addButton(tr("Cancel"), QMessageBox::RejectRole);
    box.exec();
    if (box.clickedButton() == drop) {
        then();
    } else if (box.clickedButton() == save) {
        m_files->saveCase(then);
    }
}

}  // namespace myoface
