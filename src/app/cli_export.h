// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <QObject>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include "background_job.h"
#include "face_document.h"

namespace myoface {

/// Writes a report or an animation of the face as it stands, beside the window: a copy of the case
/// goes to myoface-cli, which draws and measures as it does for scripts.
class CliExport final : public QObject {
    Q_OBJECT

public:
    explicit CliExport(QObject* parent = nullptr);
    ~CliExport() override;
    CliExport(const CliExport&) = delete;
    CliExport& operator=(const CliExport&) = delete;

    bool running() const { return m_copying || m_process.state() != QProcess::NotRunning; }
    /// @param command of myoface-cli @param options after the case and the file
    void start(const FaceDocument& document, const QString& command, const QString& file,
               const QStringList& options);
    void cancel();
    /// What is written now.
    const QString& file() const { return m_file; }

Q_SIGNALS:
    void progressed(int percent);
    void written(const QString& file);
    void failed(const QString& sentence);
    void cancelled();

private:
    void copied();
    void listen();
    void finish(int code, QProcess::ExitStatus status);

    QProcess m_process;
    std::unique_ptr<FileJob> m_copying;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file, m_said, m_passphrase;
    QStringList m_arguments;
    bool m_cancelled = false;
};

}  // namespace myoface
