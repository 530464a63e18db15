// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "myoface/face/landmarks.h"

#include "background_job.h"

namespace myoface {

/// Looks for the landmarks of a scan beside the window.
class DetectJob final : public BackgroundJob {
    Q_OBJECT

public:
    explicit DetectJob(std::shared_ptr<const Scan> scan);
    ~DetectJob() override { stop(); }

    /// Nothing when there is no face; problem() says so.
    const std::optional<Landmarks>& landmarks() const { return m_landmarks; }

private:
    void run() override;

    std::shared_ptr<const Scan> m_scan;
    std::optional<Landmarks> m_landmarks;
};

}  // namespace myoface
