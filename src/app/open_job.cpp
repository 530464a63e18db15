// SPDX-License-Identifier: Apache-2.0
#include "open_job.h"

#include <new>

#include "myoface/base/error.h"

namespace myoface {

OpenJob::OpenJob(QString path, OpenOptions options, QObject* parent)
    : QObject(parent),
      m_path(std::move(path)),
      m_options(std::move(options)),
      m_progress([this](const std::string& stage, double share) {
          Q_EMIT progressed(QString::fromStdString(stage), static_cast<int>(100.0 * share));
      }) {}

OpenJob::~OpenJob() {
    if (m_thread) {
        m_progress.cancel();
        m_thread->wait();
    }
}

void OpenJob::start() {
    m_thread.reset(QThread::create([this] { run(); }));
    connect(m_thread.get(), &QThread::finished, this, &OpenJob::finished);
    m_thread->start();
}

void OpenJob::cancel() {
    m_progress.cancel();
}

void OpenJob::run() {
    try {
        const auto prepared = prepare_fitting();
        auto opened =
            std::make_shared<OpenedFace>(open_face(m_path.toStdString(), m_options, &m_progress));
        if (find_missing_landmarks(*opened, &m_progress)) {
            m_result.simulator = make_simulator(*opened, {}, &m_progress);
            m_result.net = fitted_net(m_result.simulator->face());
        }
        m_result.opened = std::move(opened);
    } catch (const std::bad_alloc&) {
        m_result.problem = tr("There is not enough memory for this file.");
    } catch (const std::exception& error) {
        m_result.problem = QString::fromUtf8(error.what());
    }
}

}  // namespace myoface
