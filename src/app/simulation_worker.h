// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include "myoface/sim/frame_governor.h"
#include "myoface/sim/plan_file.h"
#include "myoface/sim/shaping.h"
#include "myoface/sim/snapshot.h"
#include "myoface/sim/target.h"

namespace myoface {

/// What came of a gesture or of another edit of the shape.
struct DragOutcome {
    DragReport report;
    Points before, after;  ///< resting skin
    QString title;         ///< for the history; empty: a gesture
    QString words;         ///< what was done, in numbers
    Plan edits;            ///< the same for a plan
};

/// What came of a plan.
struct PlanOutcome {
    std::vector<double> rates, strengths;
    Eigen::VectorXd protection;
    Points before, after;  ///< resting skin
    Replay replay;
};

/// Owns the simulator and lives in a thread of its own. Works in pieces of a few milliseconds while
/// something moves and sleeps when all is at rest. Snapshots go into a one-slot box. No exception
/// leaves it.
class SimulationWorker final : public QObject {
    Q_OBJECT

public:
    explicit SimulationWorker(SnapshotBox& box);

    // All of these are called in the worker's thread.
    void setSimulator(std::unique_ptr<Simulator> simulator);
    /// Contractions set until endGlide() are reached over some time instead of at once.
    /// @param seconds 0: at once
    void beginGlide(double seconds);
    void endGlide();
    void setRate(int muscle, double rate);
    void setStrength(int muscle, double strength);
    void setResponse(ResponseForm form);
    void setSkinAge(double years);
    void setSkinRest(const Points& skinRest);
    void beginDrag(const DragRequest& request, const ViewRay& ray);
    void moveDrag(const ViewRay& ray);
    void endDrag(bool keep);
    /// A gesture by numbers: the grabbed point goes by `way`, seen along `view`.
    void nudge(const DragRequest& request, const Vec3& way, const Vec3& view);
    void addVolume(const VolumeRequest& request);
    void meetTarget(const TargetRequest& request);
    void setProtection(const Eigen::VectorXd& share);
    void applyPlan(const RecordedPlan& plan);
    /// @param pace of time, or 0: straight to rest
    void setPace(double pace);

Q_SIGNALS:
    void snapshotReady();
    void dragFinished(std::shared_ptr<const myoface::DragOutcome> outcome);
    void planApplied(std::shared_ptr<const myoface::PlanOutcome> outcome);
    void failed(const QString& sentence);
    /// An edit that cannot be done; nothing has changed.
    void refused(const QString& sentence);

private:
    /// The way from the contractions of a moment to those that are wanted.
    struct Glide {
        std::vector<double> from, to;
        double seconds = 0.0;
        QElapsedTimer clock;
    };

    void wake();
    void work();
    void glide();
    void finishGlide();
    void publish(const StepReport& report);
    void record(const DragRequest& request, const ViewRay& ray);
    DragEdit recorded() const;
    QString regions(const Points& before, const Points& after) const;
    template <typename Action>
    void guarded(const Action& action);
    template <typename Action>
    void reshaped(const Action& action);

    SnapshotBox& m_box;
    std::unique_ptr<Simulator> m_simulator;
    QTimer m_timer;
    QElapsedTimer m_clock;
    FrameGovernor m_governor;
    std::optional<Glide> m_glide;
    bool m_collecting = false;  ///< contractions that come are the glide's aim
    double m_pace = 0.0;
    ResponseForm m_response = ResponseForm::Smooth;
    int m_sinceChange = 0;  ///< frames
    std::uint64_t m_frame = 0;
    DragEdit m_gesture;           ///< that goes on, for plans
    Vec3 m_start = Vec3::Zero();  ///< of its grip [mm]
    ViewRay m_ray;                ///< where the hand is
};

}  // namespace myoface

Q_DECLARE_METATYPE(std::shared_ptr<const myoface::DragOutcome>)
Q_DECLARE_METATYPE(std::shared_ptr<const myoface::PlanOutcome>)
