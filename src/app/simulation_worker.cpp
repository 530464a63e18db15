// SPDX-License-Identifier: Apache-2.0
#include "simulation_worker.h"

#include <algorithm>
#include <cmath>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"
#include "myoface/measure/volume.h"

#include "language.h"

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
    m_glide.reset();
    m_collecting = false;
    setPace(m_pace);
    setResponse(m_response);
    wake();
}

void SimulationWorker::beginGlide(double seconds) {
    if (!m_simulator || seconds <= 0.0) {
        return;
    }
    const std::vector<double>& now = m_simulator->contractions().rate;
    m_glide = Glide{now, m_glide ? m_glide->to : now, seconds, {}};
    m_glide->clock.start();
    m_collecting = true;
}

void SimulationWorker::endGlide() {
    m_collecting = false;
}

void SimulationWorker::setRate(int muscle, double rate) {
    guarded([&] {
        if (m_collecting) {
            m_glide->to[static_cast<std::size_t>(muscle)] = rate;
            return;
        }
        finishGlide();  // a hand on a slider does not wait
        m_simulator->set_contraction(muscle, rate);
    });
}

void SimulationWorker::finishGlide() {
    if (m_glide) {
        m_simulator->set_contractions(m_glide->to);
        m_glide.reset();
    }
}

/// One frame further.
void SimulationWorker::glide() {
    const double t = static_cast<double>(m_glide->clock.elapsed()) / (1000.0 * m_glide->seconds);
    if (t >= 1.0) {
        finishGlide();
        return;
    }
    const double share = t * t * (3.0 - 2.0 * t);
    std::vector<double> rates = m_glide->from;
    for (std::size_t m = 0; m < rates.size(); ++m) {
        rates[m] += share * (m_glide->to[m] - rates[m]);
    }
    m_simulator->set_contractions(rates);
    m_sinceChange = 0;
}

void SimulationWorker::setStrength(int muscle, double strength) {
    guarded([&] { m_simulator->set_strength(muscle, strength); });
}

void SimulationWorker::setResponse(ResponseForm form) {
    m_response = form;
    guarded([&] { m_simulator->set_response(form); });
}

void SimulationWorker::setSkinAge(double years) {
    guarded([&] { m_simulator->set_skin_age(years); });
}

void SimulationWorker::setSkinRest(const Points& skinRest) {
    guarded([&] {
        if (skinRest != m_simulator->skin_rest()) {
            m_simulator->set_skin_rest(skinRest);
        }
    });
}

void SimulationWorker::beginDrag(const DragRequest& request, const ViewRay& ray) {
    guarded([&] {
        try {
            record(request, ray);
            m_simulator->begin_drag(request, ray);
        } catch (const InvalidInput& refusal) {
            Q_EMIT refused(QString::fromUtf8(refusal.what()));
        }
    });
}

void SimulationWorker::moveDrag(const ViewRay& ray) {
    m_ray = ray;
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
        if (keep) {
            outcome->edits = {recorded()};
            outcome->words =
                tr("The shape has changed by, in mL:") + regions(outcome->before, outcome->after);
        }
        Q_EMIT dragFinished(outcome);
    });
}

/// Begins to write a gesture down.
void SimulationWorker::record(const DragRequest& request, const ViewRay& ray) {
    const FaceModel& face = m_simulator->face();
    m_gesture = {};
    m_gesture.mode = request.mode;
    m_gesture.radius = request.radius;
    m_gesture.mirrored = request.mirrored;
    m_gesture.path = request.path;
    m_gesture.force_N = request.force_mN / 1000.0;
    m_gesture.keep = request.mode == DragMode::ConstraintPriority;
    m_gesture.place = plan_place(face, request.where);
    m_start = position(
        {m_simulator->state().positions.leftCols(face.node_count()), face.skin.mesh.triangles},
        request.where);
    m_ray = ray;
}

/// The gesture as a plan has it: only where the hand ended counts.
DragEdit SimulationWorker::recorded() const {
    DragEdit edit = m_gesture;
    edit.view.clear();
    for (int k = 0; k < 3; ++k) {
        edit.view += k > 0 ? "," : "";
        append_number(edit.view, m_ray.direction[k]);
    }
    edit.move = view_plane(m_ray.direction).transpose() * (m_ray.origin - m_start);
    return edit;
}

/// What came to each region, a line each; nothing below 0.02 mL.
QString SimulationWorker::regions(const Points& before, const Points& after) const {
    QString text;
    for (const auto& [region, ml] : volume_by_region(m_simulator->face(), before, after)) {
        if (std::abs(ml) >= 0.02) {
            text += tr("\n%1 %2%3")
                        .arg(inWords(region_name(region)), QLatin1String(ml > 0.0 ? "+" : ""))
                        .arg(ml, 0, 'f', 2);
        }
    }
    return text.isEmpty() ? tr("\nnothing worth mentioning") : text;
}

/// An edit of the shape; `action` fills in title and words.
template <typename Action>
void SimulationWorker::reshaped(const Action& action) {
    guarded([&] {
        auto outcome = std::make_shared<DragOutcome>();
        outcome->before = m_simulator->skin_rest();
        try {
            action(*outcome);
        } catch (const InvalidInput& refusal) {
            Q_EMIT refused(QString::fromUtf8(refusal.what()));
            return;
        }
        outcome->after = m_simulator->skin_rest();
        Q_EMIT dragFinished(outcome);
    });
}

void SimulationWorker::nudge(const DragRequest& request, const Vec3& way, const Vec3& view) {
    reshaped([&](DragOutcome& outcome) {
        m_simulator->settle();
        const FaceModel& face = m_simulator->face();
        const Points skin = m_simulator->state().positions.leftCols(face.node_count());
        const Vec3 start = position({skin, face.skin.mesh.triangles}, request.where);
        const double away = 300.0;  // [mm]
        record(request, {start - away * view, view});
        m_ray = {start + way - away * view, view};
        m_simulator->begin_drag(request, {start - away * view, view});
        m_simulator->move_drag(m_ray);
        outcome.edits = {recorded()};
        m_simulator->settle();
        outcome.report = m_simulator->end_drag(true);
        outcome.words = tr("Moved by %1 mm; the hand would have to hold %2 N.")
                            .arg(way.norm(), 0, 'f', 1)
                            .arg(outcome.report.force_mN / 1000.0, 0, 'f', 1);
    });
}

void SimulationWorker::addVolume(const VolumeRequest& request) {
    reshaped([&](DragOutcome& outcome) {
        const VolumeReport report = add_volume(*m_simulator, request);
        outcome.report.kept_share = report.kept_share;
        VolumeEdit edit{"", request.ml, request.radius, request.mirrored, std::nullopt};
        edit.place = plan_place(m_simulator->face(), request.where);
        outcome.edits = {edit};
        outcome.title = tr("volume %1 mL").arg(report.ml, 0, 'f', 2);
        outcome.words = tr("%1 mL, at %2 kPa in the middle.")
                            .arg(report.ml, 0, 'f', 2)
                            .arg(report.pressure_kPa, 0, 'f', 0);
        outcome.words += regions(outcome.before, m_simulator->skin_rest());
    });
}

void SimulationWorker::meetTarget(const TargetRequest& request) {
    reshaped([&](DragOutcome& outcome) {
        const TargetReport report = meet_target(*m_simulator, request);
        outcome.edits = {
            TargetEdit{request.measure.id, request.value, request.relative, request.radius}};
        const int decimals = request.measure.in_degrees() ? 1 : 2;
        const QString measure = inWords(request.measure.title);
        QStringList moved;
        for (const std::string& landmark : report.landmarks) {
            moved += landmarkInWords(landmark);
        }
        outcome.title = tr("%1 %2").arg(measure).arg(report.reached, 0, 'f', 1);
        outcome.words = tr("%1: %2 before, %3 now; %4 moved by %5 mm.")
                            .arg(measure)
                            .arg(report.before, 0, 'f', decimals)
                            .arg(report.reached, 0, 'f', decimals)
                            .arg(moved.join(QStringLiteral(", ")))
                            .arg(report.moved_mm, 0, 'f', 1);
    });
}

void SimulationWorker::setProtection(const Eigen::VectorXd& share) {
    guarded([&] { m_simulator->set_protection(share); });
}

void SimulationWorker::applyPlan(const RecordedPlan& plan) {
    guarded([&] {
        auto outcome = std::make_shared<PlanOutcome>();
        outcome->before = m_simulator->skin_rest();
        outcome->replay = replay(*m_simulator, plan);
        if (m_simulator->dragging()) {  // a last constraint drag is let go
            m_simulator->end_drag(false);
        }
        outcome->after = m_simulator->skin_rest();
        outcome->rates = m_simulator->contractions().rate;
        outcome->strengths = m_simulator->contractions().strength;
        outcome->protection = m_simulator->protection();
        Q_EMIT planApplied(outcome);
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
        if (m_glide) {
            glide();
        }
        const bool waited =
            m_simulator->live() || m_simulator->dragging() || m_sinceChange < kQuickFrames;
        ++m_sinceChange;
        StepReport report =
            m_simulator->step(m_governor.sweeps(waited ? kFrameBudget : kSettleBudget));
        m_governor.learn(report);
        report.converged = report.converged && !m_glide;
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
    auto snapshot = std::make_shared<SimSnapshot>(snapshot_of(*m_simulator));
    snapshot->report = report;
    snapshot->frame = ++m_frame;
    m_box.put(std::move(snapshot));
    Q_EMIT snapshotReady();
}

}  // namespace myoface
