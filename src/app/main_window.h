// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include <QActionGroup>
#include <QHash>
#include <QLabel>
#include <QMainWindow>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QThread>

#include "commands.h"
#include "face_document.h"
#include "face_view.h"
#include "preferences.h"
#include "simulation_worker.h"

namespace myoface {

class Callipers;
class Comparison;
class ComparePanel;
class FaceFiles;
class FitJob;
class JournalKeeper;
class LandmarkEditor;
class LandmarkGuide;
class LandmarkPanel;
class LandmarksOnSkin;
class LayerPanel;
class MeasurePanel;
class MusclePanel;
class OpenJob;
class PatientView;
class PlanFiles;
class ReportPanel;
class ScanFrameEditor;
class ScanPanel;
class ShadeJob;
class ShapePanel;
class ShapeTools;
struct OpenResult;
struct Recovery;

/// A step of the consultation: what it is called, and the panels that it needs.
struct TaskStep {
    QString name, title, icon, tip;
    QStringList panels;
};

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
    void setStrengths(const std::string& muscle, double strength);
    /// Adds an expression to what the muscles do. @throws InvalidInput for an unknown name
    void addExpression(const std::string& name, double intensity);
    /// Years of the skin that wrinkles, held within what there is.
    void setSkinAge(double years);
    void setLayers(const LayerOpacity& layers);
    /// One, two or four sides of the face.
    void setViews(ViewLayout layout);
    FaceFiles& files() { return *m_files; }
    PlanFiles& plans() { return *m_plans; }
    Comparison& comparison() { return *m_comparison; }
    ComparePanel& comparePanel() { return *m_comparePanel; }
    MeasurePanel& measures() { return *m_measures; }
    JournalKeeper& journal() { return *m_journal; }
    void exportFace();
    void exportAnimation(const QString& motion);
    /// Writes a report of the face as it stands, beside the window.
    void exportReport(const QString& path);
    /// Brings the landmarks panel to the front, markers and fitted net on.
    void showLandmarks();
    /// Brings a panel to the front: scan, layers, landmarks, shape, measures, muscles, compare,
    /// report, history.
    void showPanel(const QString& name);
    /// One of scan, fit, shape, expression, compare, report.
    void showStep(const QString& name);
    const QString& step() const { return m_step; }
    /// Language, theme and method, at once.
    void applySettings(const Settings& settings);
    /// Asks whether a face that a program left behind is wanted back.
    void offerRecovery();
    void recover(const Recovery& recovery);

Q_SIGNALS:
    void opened();
    void openFailed(const QString& sentence);
    void cameToRest();
    void reportWritten(const QString& file);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    // In window_menus.cpp and window_bars.cpp.
    void buildActions();
    void buildFileMenu();
    void buildEditMenu();
    void buildViewMenu();
    void buildLayouts(QMenu& view);
    void buildHelpMenu();
    void buildSteps();
    void buildTools();
    void nextLayout();
    void showShortcuts();
    void about();
    void refreshIcons();
    void refreshShortcutTips();

    // In window_panels.cpp.
    void buildDocks();
    void buildStatusBar();
    void widenPanels();
    /// A bar with Cancel for work beside the window.
    void showWork(const QString& what);
    void showShare(int percent);
    void hideWork();
    void showHints();
    void placeHints();
    void presentToPatient();

    // In window_opening.cpp.
    void reopen(const OpenOptions& options);
    void startJob(const QString& path, const struct OpenOptions& options);
    void begin(std::unique_ptr<OpenJob> job);
    void jobFinished();
    void showFace(OpenResult& result);
    void showRefitted(FitJob& job);
    void dropScene();
    void takeScene(Bvh bvh, const std::shared_ptr<const LandmarksOnSkin>& places);
    void shade();
    void landmarksPlaced();
    void endPicking();
    void askDistance(double measured);
    bool unsaved();
    void leaveThen(const std::function<void()>& then);

    // In window_edits.cpp.
    void showMuscles();
    void setMuscles(MuscleSetting setting, const std::string& muscle, double value);
    void pushExpression(std::vector<double> rates, const std::string& name, double left,
                        double right, int gesture);
    void weaken(const std::string& preset, bool left, bool right);
    void restMuscles();
    void resetFace();
    void nameWhatIsThere(const ViewRay& ray, const std::optional<SurfacePoint>& where);

    void connectDocument();
    void connectPanels();
    void connectView();
    void connectFrameEditor();
    void connectShapeTools();
    void askAndOpen(const OpenJob& job);
    void protectCase();
    void colourScene();
    void showSnapshot();
    void chooseExpression(const std::string& name, double left, double right, int gesture,
                          bool fresh);
    void changePresets(const QString& chosen, const std::function<void()>& change);
    void showAgain();
    void drawOver();
    void drawStrokes(const SimSnapshot& shown);
    void complain(const QString& sentence);
    void inWorker(const std::function<void(SimulationWorker&)>& call);

    FaceDocument m_document;
    std::unique_ptr<FaceScene> m_scene;
    Settings m_settings;
    FaceView* m_view = nullptr;
    FaceFiles* m_files = nullptr;
    PlanFiles* m_plans = nullptr;
    JournalKeeper* m_journal = nullptr;
    MusclePanel* m_muscles = nullptr;
    LayerPanel* m_layers = nullptr;
    ScanPanel* m_scanPanel = nullptr;
    ScanFrameEditor* m_frameEditor = nullptr;
    LandmarkGuide* m_guide = nullptr;
    LandmarkPanel* m_landmarks = nullptr;
    LandmarkEditor* m_landmarkEditor = nullptr;
    ShapePanel* m_shapePanel = nullptr;
    ShapeTools* m_shapeTools = nullptr;
    ComparePanel* m_comparePanel = nullptr;
    Comparison* m_comparison = nullptr;
    MeasurePanel* m_measures = nullptr;
    Callipers* m_callipers = nullptr;
    ReportPanel* m_reportPanel = nullptr;
    QPointer<PatientView> m_patient;
    std::vector<TaskStep> m_steps;
    QString m_step;
    QHash<QString, QByteArray> m_layouts;  ///< of docks, by step
    QActionGroup* m_stepActions = nullptr;
    QActionGroup* m_viewLayouts = nullptr;
    QLabel* m_state = nullptr;
    QLabel* m_aid = nullptr;
    QLabel* m_hints = nullptr;
    QProgressBar* m_progress = nullptr;
    QString m_work;  // what the status line says is going on
    QPushButton* m_cancel = nullptr;
    SnapshotBox m_box;
    QThread m_thread;
    SimulationWorker* m_worker = nullptr;
    std::unique_ptr<OpenJob> m_job;
    std::unique_ptr<ShadeJob> m_shading;
    std::shared_ptr<const SimSnapshot> m_shown;
    int m_springs = 0;                     ///< of the face that is shown
    int m_nodes = 0;                       ///< of its model, muscle chains in
    std::vector<double> m_expressionBase;  ///< what the muscles did before the chosen preset
    QString m_lastProblem;
    bool m_settled = true;
    bool m_mayClose = false;
};

}  // namespace myoface
