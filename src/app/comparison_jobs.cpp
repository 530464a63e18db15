// SPDX-License-Identifier: Apache-2.0
#include "comparison_jobs.h"

#include <utility>

#include "myoface/measure/symmetry.h"
#include "myoface/scene/visibility.h"

namespace myoface {

SettleJob::SettleJob(std::shared_ptr<const FaceModel> face, Variant variant, double skinAge,
                     QObject* parent)
    : BackgroundJob(parent),
      m_face(std::move(face)),
      m_variant(std::move(variant)),
      m_skinAge(skinAge) {}

void SettleJob::run() {
    Simulator simulator(m_face);
    const Contractions wanted = contractions_of(*m_face, m_variant.rates, m_variant.strengths);
    for (int m = 0; m < static_cast<int>(m_face->muscles.size()); ++m) {
        simulator.set_strength(m, wanted.strength[static_cast<std::size_t>(m)]);
        simulator.set_contraction(m, wanted.rate[static_cast<std::size_t>(m)]);
    }
    simulator.set_skin_rest(shaped_skin(*m_face, m_variant.shape));
    m_progress.report("settling", 0.5);
    simulator.set_skin_age(m_skinAge);
    const StepReport report = simulator.settle();
    m_result = snapshot_of(simulator);
    m_result.report = report;
}

SidesJob::SidesJob(std::shared_ptr<const FaceModel> face, Points nodes, QObject* parent)
    : BackgroundJob(parent), m_face(std::move(face)), m_nodes(std::move(nodes)) {}

void SidesJob::run() {
    m_result = side_differences(*m_face, m_nodes, &m_progress);
    m_regions = distances_by_region(*m_face, m_result);
}

StillJob::StillJob(std::function<std::unique_ptr<SceneData>()> make, QObject* parent)
    : BackgroundJob(parent), m_make(std::move(make)) {}

ShadeJob::ShadeJob(std::shared_ptr<const Scan> scan, QObject* parent)
    : BackgroundJob(parent), m_scan(std::move(scan)) {}

void ShadeJob::run() {
    m_result = light_visibility(m_scan->mesh, &m_progress);
}

ActualJob::ActualJob(std::shared_ptr<const FaceModel> face, Points plan, QString path,
                     QObject* parent)
    : BackgroundJob(parent),
      m_face(std::move(face)),
      m_plan(std::move(plan)),
      m_path(std::move(path)) {}

void ActualJob::run() {
    OpenedFace after = open_face(m_path.toStdString(), {}, &m_progress);
    if (!find_missing_landmarks(after, &m_progress)) {
        throw InvalidInput(m_path.toStdString() +
                           ": no face was found on it; put a landmark file beside it.");
    }
    m_result = compare_with_result(*m_face, m_plan, after.scan->mesh, *after.landmarks);
}

}  // namespace myoface
