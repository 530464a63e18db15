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
        m_result.net = fitted_net(m_result.simulator->face());
    }
    m_result.opened = std::move(opened);
}

}  // namespace myoface
