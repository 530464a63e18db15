// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "myoface/face/fitted_net.h"
#include "myoface/measure/landmarks_on_skin.h"
#include "myoface/mesh/bvh.h"
#include "myoface/scene/face_scene.h"
#include "myoface/sim/simulator.h"

#include "background_job.h"

namespace myoface {

/// Fits a scan anew to moved landmarks, beside the window. Shape and contractions are kept.
class FitJob final : public BackgroundJob {
    Q_OBJECT

public:
    FitJob(std::shared_ptr<const Scan> scan, Landmarks landmarks, const FitOptions& options,
           Contractions contractions, Points shape, std::shared_ptr<const SkinTexture> texture);
    ~FitJob() override { stop(); }

    /// Empty when the fit failed; problem() says why.
    std::unique_ptr<Simulator>& simulator() { return m_simulator; }
    const std::shared_ptr<const FaceModel>& model() const { return m_model; }
    const FittedNet& net() const { return m_net; }
    std::unique_ptr<FaceScene>& scene() { return m_scene; }
    const std::shared_ptr<const LandmarksOnSkin>& places() const { return m_places; }
    const Bvh& bvh() const { return m_bvh; }

private:
    void run() override;

    std::shared_ptr<const Scan> m_scan;
    Landmarks m_landmarks;
    FitOptions m_options;
    Contractions m_contractions;
    Points m_shape;  ///< see shape_of_scan()
    std::shared_ptr<const FaceModel> m_model;
    std::unique_ptr<Simulator> m_simulator;
    FittedNet m_net;
    std::shared_ptr<const SkinTexture> m_texture;
    std::unique_ptr<FaceScene> m_scene;
    std::shared_ptr<const LandmarksOnSkin> m_places;
    Bvh m_bvh;
};

}  // namespace myoface
