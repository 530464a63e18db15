// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
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
    bool cancelled() const { return m_cancelled; }
    /// Goes on by itself until it notices that it was cancelled, and then away: see retire().
    void leave();
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
    bool m_cancelled = false;
    std::unique_ptr<QThread> m_thread;
};

/// Gives a job up without waiting for it.
template <typename Job>
void retire(std::unique_ptr<Job>& job) {
    if (job) {
        job.release()->leave();
    }
}

/// Work with a file, as a function that may throw.
class FileJob final : public BackgroundJob {
    Q_OBJECT

public:
    explicit FileJob(std::function<void(const Progress&)> work, QObject* parent = nullptr)
        : BackgroundJob(parent), m_work(std::move(work)) {}
    ~FileJob() override { stop(); }

private:
    void run() override { m_work(m_progress); }

    std::function<void(const Progress&)> m_work;
};

}  // namespace myoface
