// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <QObject>
#include <QString>
#include <QThread>

#include "myoface/base/progress.h"

namespace myoface {

/// Work beside the window, with progress and cancel. What goes wrong becomes one sentence.
class BackgroundJob : public QObject {
    Q_OBJECT

public:
    BackgroundJob(const BackgroundJob&) = delete;
    BackgroundJob& operator=(const BackgroundJob&) = delete;

    void start();
    void cancel() { m_progress.cancel(); }
    /// Empty when all went well.
    const QString& problem() const { return m_problem; }

Q_SIGNALS:
    void progressed(const QString& stage, int percent);
    void finished();

protected:
    explicit BackgroundJob(QObject* parent = nullptr);
    ~BackgroundJob() override;

    /// In its own thread. May throw.
    virtual void run() = 0;
    /// Cancels and waits: to be called in the destructor of whatever run() uses.
    void stop();

    Progress m_progress;

private:
    QString m_problem;
    std::unique_ptr<QThread> m_thread;
};

}  // namespace myoface
