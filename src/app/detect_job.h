// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <QThread>

#include "myoface/base/progress.h"
#include "myoface/face/landmarks.h"

namespace myoface {

/// Looks for the landmarks of a scan beside the window.
class DetectJob final : public QObject {
    Q_OBJECT

public:
    explicit DetectJob(std::shared_ptr<const Scan> scan);
    ~DetectJob() override;
    DetectJob(const DetectJob&) = delete;
    DetectJob& operator=(const DetectJob&) = delete;

    void start();
    /// Nothing when there is no face; problem() says so.
    const std::optional<Landmarks>& landmarks() const { return m_landmarks; }
    const QString& problem() const { return m_problem; }

Q_SIGNALS:
    void finished();

private:
    void run();

    std::shared_ptr<const Scan> m_scan;
    Progress m_progress;
    std::optional<Landmarks> m_landmarks;
    QString m_problem;
    std::unique_ptr<QThread> m_thread;
};

}  // namespace myoface
