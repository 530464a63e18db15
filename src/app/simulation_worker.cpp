// SPDX-License-Identifier: Apache-2.0
#include "simulation_worker.h"

#include <algorithm>

#include "myoface/base/error.h"

namespace myoface {
namespace {
constexpr double kFrameBudget = 11.0;   // of simulation in a frame of 16.7 [ms]
constexpr double kSettleBudget = 40.0;  // when no hand waits for it [ms]
constexpr int kQuickFrames = 12;        // after a change, before the longer budget
}  // namespace

SimulationWorker::SimulationWorker(SnapshotBox& box) : m_box(box), m_timer(this) {
    m_timer.setInterval(0);
    connect(&m_timer, &QTimer::timeout, this, &SimulationWorker::work);
}

template <typename Action>
void SimulationWorker::guarded(const Action& action) {
    if (!m_simulator) {
        return;
    }
    try {
        action();
        wake();
    } catch (const std::exception& error) {
        Q_EMIT failed(QString::fromUtf8(error.what()));
    }
}

void SimulationWorker::setSimulator(std::unique_ptr<Simulator> simulator) {
    m_simulator = std::move(simulator);
    setPace(m_pace);
    wake();
}

void SimulationWorker::setRate(int muscle, double rate) {
    guarded([&] { m_simulator->set_contraction(muscle, rate); });
}

void SimulationWorker::setSkinRest(const Points& skinRest) {
    guarded([&] {
        if (skinRest != m_simulator->skin_rest()) {
            m_simulator->set_skin_rest(skinRest);
        }
    });
}

void SimulationWorker::beginDrag(const DragRequest& request, const ViewRay& ray) {
    guarded([&] { m_simulator->begin_drag(request, ray); });
}

void SimulationWorker::moveDrag(const ViewRay& ray) {
    guarded([&] { m_simulator->move_drag(ray); });
}

void SimulationWorker::endDrag(bool keep) {
    guarded([&] {
        if (!m_simulator->dragging()) {
            return;
        }
        auto outcome = std::make_shared<DragOutcome>();
        outcome->before = m_simulator->skin_rest();
        if (keep) {
            m_simulator->settle();  // the shape that stays is one at rest
        }
        outcome->report = m_simulator->end_drag(keep);
        outcome->after = m_simulator->skin_rest();
        Q_EMIT dragFinished(outcome);
    });
}

void SimulationWorker::setPace(double pace) {
    m_pace = pace;
    guarded([&] { m_simulator->set_live(pace); });
}

void SimulationWorker::wake() {
    m_sinceChange = 0;
    if (!m_timer.isActive()) {
        m_timer.start();
    }
}

void SimulationWorker::work() {
    if (!m_simulator) {
        m_timer.stop();
        return;
    }
    try {
        m_clock.start();
        const bool waited =
            m_simulator->live() || m_simulator->dragging() || m_sinceChange < kQuickFrames;
        ++m_sinceChange;
        const StepReport report =
            m_simulator->step(m_governor.sweeps(waited ? kFrameBudget : kSettleBudget));
        m_governor.learn(report);
        publish(report);
        if (report.converged) {
            m_timer.stop();
        }
        // Time goes no faster than it should.
        const double left = 1000.0 * kLiveFrame - static_cast<double>(m_clock.elapsed());
        m_timer.setInterval(m_simulator->live() ? std::max(0, static_cast<int>(left)) : 0);
    } catch (const std::exception& error) {
        m_timer.stop();
        Q_EMIT failed(QString::fromUtf8(error.what()));
    }
}

void SimulationWorker::publish(const StepReport& report) {
    auto snapshot = std::make_shared<SimSnapshot>();
    snapshot->positions = m_simulator->state().positions;
    snapshot->rates = m_simulator->contractions().rate;
    snapshot->jaw = jaw_opening(m_simulator->face(), m_simulator->contractions());
    snapshot->report = report;
    snapshot->dragging = m_simulator->dragging();
    snapshot->frame = ++m_frame;
    m_box.put(std::move(snapshot));
    Q_EMIT snapshotReady();
}

}  // namespace myoface
