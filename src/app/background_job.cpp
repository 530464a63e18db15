// SPDX-License-Identifier: Apache-2.0
#include "background_job.h"

#include <new>

#include <QCoreApplication>

#include "myoface/base/error.h"

namespace myoface {

BackgroundJob::BackgroundJob(QObject* parent)
    : QObject(parent), m_progress([this](const std::string& stage, double share) {
          Q_EMIT progressed(QString::fromStdString(stage), static_cast<int>(100.0 * share));
      }) {}

BackgroundJob::~BackgroundJob() = default;

void BackgroundJob::start() {
    m_thread.reset(QThread::create([this] {
        try {
            run();
        } catch (const Cancelled& word) {
            m_cancelled = true;
            m_problem = QString::fromUtf8(word.what());
        } catch (const std::bad_alloc&) {
            m_problem = tr("There is not enough memory for this.");
        } catch (const std::exception& error) {
            m_problem = QString::fromUtf8(error.what());
        }
    }));
    connect(m_thread.get(), &QThread::finished, this, &BackgroundJob::finished);
    m_thread->start();
}

void BackgroundJob::stop() {
    if (m_thread) {
        m_progress.cancel();
        m_thread->wait();
    }
}

void BackgroundJob::leave() {
    disconnect(this, nullptr, nullptr, nullptr);
    cancel();
    if (m_thread && !m_thread->isFinished()) {
        connect(m_thread.get(), &QThread::finished, this, &QObject::deleteLater);
    }
    if (!m_thread || m_thread->isFinished()) {  // also when it ended just now
        deleteLater();
    }
    setParent(QCoreApplication::instance());  // which waits for it when the program ends
}

}  // namespace myoface
