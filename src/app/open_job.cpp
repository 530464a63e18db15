// SPDX-License-Identifier: Apache-2.0
#include "open_job.h"

#include <utility>

namespace myoface {

OpenJob::OpenJob(QString path, OpenOptions options, QObject* parent)
    : BackgroundJob(parent), m_path(std::move(path)), m_options(std::move(options)) {}

OpenJob::OpenJob(Recovery recovery, std::string passphrase, QObject* parent)
    : BackgroundJob(parent),
      m_path(QString::fromStdString(recovery.name)),
      m_recovery(std::move(recovery)) {
    m_options.passphrase = std::move(passphrase);
}

void OpenJob::run() {
    try {
        open();
    } catch (const PassphraseNeeded&) {
        m_locked = true;
        throw;
    }
}

void OpenJob::open() {
    const auto prepared = prepare_fitting();
    auto opened = std::make_shared<OpenedFace>(
        m_recovery ? recover(*m_recovery, &m_progress, m_options.passphrase)
                   : open_face(m_path.toStdString(), m_options, &m_progress));
    if (find_missing_landmarks(*opened, &m_progress)) {
        m_result.simulator = make_simulator(*opened, {}, &m_progress);
        const auto model = m_result.simulator->shared_face();
        const FaceMassSpring& system = m_result.simulator->system();
        m_result.net = fitted_net(*model);
        m_progress.report("drawing", 0.95);
        m_result.scene = std::make_unique<FaceScene>(model->scan, opened->texture);
        m_result.scene->set_face(model, system.model.springs, system.chains);
        m_result.places = std::make_shared<const LandmarksOnSkin>(model);
        m_result.bvh = Bvh(model->skin.mesh);
    } else {
        m_result.scene = std::make_unique<FaceScene>(opened->scan, opened->texture);
        m_result.bvh = Bvh(opened->scan->mesh);
    }
    m_result.opened = std::move(opened);
}

}  // namespace myoface
