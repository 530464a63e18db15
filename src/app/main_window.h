// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <QLabel>
#include <QMainWindow>
#include <QProgressBar>
#include <QPushButton>
#include <QThread>

#include "face_document.h"
#include "face_view.h"
#include "simulation_worker.h"

namespace myoface {

class FitJob;
class LandmarkEditor;
class LandmarkGuide;
class LandmarkPanel;
class LayerPanel;
class MusclePanel;
class OpenJob;
class ScanFrameEditor;
class ReportExport;
class ScanPanel;
class ShapePanel;
class ShapeTools;
struct OpenResult;

/// The only place where view, panels, document, undo and simulation meet.
class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;
    MainWindow(const MainWindow&) = delete;
    MainWindow& operator=(const MainWindow&) = delete;

    /// Opens a scan, a case or "generic" beside the window.
    void openPath(const QString& path);
    FaceDocument& document() { return m_document; }
    FaceView& view() { return *m_view; }
    MusclePanel& muscles() { return *m_muscles; }
    LandmarkPanel& landmarks() { return *m_landmarks; }
    ShapePanel& shape() { return *m_shapePanel; }
    /// At rest: nothing opens and the newest state has been shown.
    bool settled() const;
    const QString& lastProblem() const { return m_lastProblem; }
    void setRates(const std::string& muscle, double rate);
    /// Adds an expression to what the muscles do. @throws InvalidInput for an unknown name
    void addExpression(const std::string& name, double intensity);
    void setLayers(const LayerOpacity& layers);
    /// Writes a report of the face as it stands, beside the window.
    void exportReport(const QString& path, const QString& notes);
    /// Brings the landmarks panel to the front, markers and fitted net on.
    void showLandmarks();
    /// Brings a panel to the front: layers, scan, landmarks, shape, muscles.
    void showPanel(const QString& name);

Q_SIGNALS:
    void opened();
    void openFailed(const QString& sentence);
    void cameToRest();
    void reportWritten(const QString& file);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void buildActions();
    void buildDocks();
    void connectView();
    void connectFrameEditor();
    void connectShapeTools();
    void endPicking();
    void askDistance(double measured);
    void reopen(const OpenOptions& options);
    void startJob(const QString& path, const struct OpenOptions& options);
    void jobFinished();
    void showFace(OpenResult& result);
    void chooseFile();
    void chooseLandmarks();
    void saveScan();
    void saveCase();
    void saveReport();
    void savePicture();
    void landmarksPlaced();
    void showRefitted(FitJob& job);
    void drawOver();
    void showSnapshot();
    void resetFace();
    void restMuscles();
    void pushExpression(std::vector<double> rates, const std::string& name, double intensity,
                        int gesture);
    void nameWhatIsThere(const ViewRay& ray, const std::optional<SurfacePoint>& where);
    void showBefore(bool held);
    void complain(const QString& sentence);
    void rememberRecent(const QString& path);
    void fillRecent();
    void about();
    template <typename Call>
    void inWorker(const Call& call);

    FaceDocument m_document;
    std::unique_ptr<FaceScene> m_scene;
    FaceView* m_view = nullptr;
    MusclePanel* m_muscles = nullptr;
    LayerPanel* m_layers = nullptr;
    ScanPanel* m_scanPanel = nullptr;
    ScanFrameEditor* m_frameEditor = nullptr;
    LandmarkGuide* m_guide = nullptr;
    LandmarkPanel* m_landmarks = nullptr;
    LandmarkEditor* m_landmarkEditor = nullptr;
    ShapePanel* m_shapePanel = nullptr;
    ShapeTools* m_shapeTools = nullptr;
    ReportExport* m_report = nullptr;
    QLabel* m_state = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton* m_cancel = nullptr;
    QMenu* m_recent = nullptr;
    SnapshotBox m_box;
    QThread m_thread;
    SimulationWorker* m_worker = nullptr;
    std::unique_ptr<OpenJob> m_job;
    std::shared_ptr<const SimSnapshot> m_shown;
    int m_springs = 0;  ///< of the face that is shown
    int m_nodes = 0;    ///< of its model, muscle chains in
    QString m_path, m_lastProblem;
    bool m_settled = true;
    bool m_before = false;
};

}  // namespace myoface
