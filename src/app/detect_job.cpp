// SPDX-License-Identifier: Apache-2.0
#include "detect_job.h"

#include <utility>

#include "myoface/face/landmark_detection.h"

namespace myoface {

DetectJob::DetectJob(std::shared_ptr<const Scan> scan) : m_scan(std::move(scan)) {}

void DetectJob::run() {
    m_landmarks = detect_landmarks(m_scan->mesh, nullptr, &m_progress).landmarks;
}

}  // namespace myoface
