// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <QThread>

#include "myoface/cases/case_file.h"
#include "myoface/face/fitted_net.h"

namespace myoface {

/// What an opening ended with. `simulator` is empty for a scan without landmarks.
struct OpenResult {
    std::shared_ptr<const OpenedFace> opened;
    std::unique_ptr<Simulator> simulator;
    FittedNet net;
    QString problem;  ///< one sentence; empty when all went well
};

/// Reads and fits a face beside the window, with progress and cancel.
class OpenJob final : public QObject {
    Q_OBJECT

public:
    OpenJob(QString path, OpenOptions options, QObject* parent = nullptr);
    ~OpenJob() override;
    OpenJob(const OpenJob&) = delete;
    OpenJob& operator=(const OpenJob&) = delete;

    void start();
    void cancel();
    const QString& path() const { return m_path; }
    OpenResult& result() { return m_result; }

Q_SIGNALS:
    void progressed(const QString& stage, int percent);
    void finished();

private:
    void run();

    QString m_path;
    OpenOptions m_options;
    Progress m_progress;
    OpenResult m_result;
    std::unique_ptr<QThread> m_thread;
};

}  // namespace myoface
