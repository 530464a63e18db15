// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include "myoface/sim/frame_governor.h"
#include "myoface/sim/snapshot.h"

namespace myoface {

/// What came of a gesture in the window.
struct DragOutcome {
    DragReport report;
    Points before, after;  ///< resting skin
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
    void setRate(int muscle, double rate);
    void setSkinRest(const Points& skinRest);
    void beginDrag(const DragRequest& request, const ViewRay& ray);
    void moveDrag(const ViewRay& ray);
    void endDrag(bool keep);
    /// @param pace of time, or 0: straight to rest
    void setPace(double pace);

Q_SIGNALS:
    void snapshotReady();
    void dragFinished(std::shared_ptr<const myoface::DragOutcome> outcome);
    void failed(const QString& sentence);

private:
    void wake();
    void work();
    void publish(const StepReport& report);
    template <typename Action>
    void guarded(const Action& action);

    SnapshotBox& m_box;
    std::unique_ptr<Simulator> m_simulator;
    QTimer m_timer;
    QElapsedTimer m_clock;
    FrameGovernor m_governor;
    double m_pace = 0.0;
    int m_sinceChange = 0;  ///< frames
    std::uint64_t m_frame = 0;
};

}  // namespace myoface

Q_DECLARE_METATYPE(std::shared_ptr<const myoface::DragOutcome>)
