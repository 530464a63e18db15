// SPDX-License-Identifier: Apache-2.0
#include "detect_job.h"

#include <new>
#include <utility>

#include "myoface/face/landmark_detection.h"

namespace myoface {

DetectJob::DetectJob(std::shared_ptr<const Scan> scan)
    : m_scan(std::move(scan)), m_progress([](const std::string&, double) {}) {}

DetectJob::~DetectJob() {
    if (m_thread) {
        m_progress.cancel();
        m_thread->wait();
    }
}

void DetectJob::start() {
    m_thread.reset(QThread::create([this] { run(); }));
    connect(m_thread.get(), &QThread::finished, this, &DetectJob::finished);
    m_thread->start();
}

void DetectJob::run() {
    try {
        m_landmarks = detect_landmarks(m_scan->mesh, nullptr, &m_progress).landmarks;
    } catch (const std::bad_alloc&) {
        m_problem = tr("There is not enough memory to look for the face.");
    } catch (const std::exception& error) {
        m_problem = QString::fromUtf8(error.what());
    }
}

}  // namespace myoface
