// SPDX-License-Identifier: Apache-2.0
#include "fit_job.h"

#include <utility>

namespace myoface {

FitJob::FitJob(std::shared_ptr<const Scan> scan, Landmarks landmarks, const FitOptions& options,
               Contractions contractions, Points shape, std::shared_ptr<const SkinTexture> texture)
    : m_scan(std::move(scan)),
      m_landmarks(std::move(landmarks)),
      m_options(options),
      m_contractions(std::move(contractions)),
      m_shape(std::move(shape)),
      m_texture(std::move(texture)) {}

void FitJob::run() {
    m_model = fit_face(m_scan, m_landmarks, &m_progress, m_options);
    auto simulator = std::make_unique<Simulator>(m_model);
    if (m_shape.cols() > 0) {
        simulator->set_skin_rest(shaped_skin(*m_model, m_shape));
    }
    for (std::size_t m = 0; m < m_contractions.rate.size(); ++m) {
        if (m_contractions.rate[m] != 0.0) {
            simulator->set_contraction(static_cast<int>(m), m_contractions.rate[m]);
        }
        if (m_contractions.strength[m] != 1.0) {
            simulator->set_strength(static_cast<int>(m), m_contractions.strength[m]);
        }
    }
    m_net = fitted_net(*m_model);
    m_scene = std::make_unique<FaceScene>(m_model->scan, m_texture);
    m_scene->set_face(m_model, simulator->system().model.springs, simulator->system().chains);
    m_places = std::make_shared<const LandmarksOnSkin>(m_model);
    m_bvh = Bvh(m_model->skin.mesh);
    m_simulator = std::move(simulator);
}

}  // namespace myoface
