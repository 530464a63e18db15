// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <QObject>
#include <QProcess>
#include <QTemporaryDir>

#include "myoface/measure/measurement.h"

#include "face_document.h"
#include "report_panel.h"

namespace myoface {

/// Writes a report of the face as it stands, beside the window: a copy of the case goes to
/// myoface-cli, which draws and measures as it does for scripts.
class ReportExport final : public QObject {
    Q_OBJECT

public:
    explicit ReportExport(QObject* parent = nullptr);

    bool running() const { return m_process.state() != QProcess::NotRunning; }
    /// @param file of the PDF @throws IoError when the case cannot be copied
    void start(const FaceDocument& document, const QString& file, const ReportWords& words,
               const Population& population);

Q_SIGNALS:
    void written(const QString& file);
    void failed(const QString& sentence);

private:
    void finish(int code, QProcess::ExitStatus status);

    std::unique_ptr<QTemporaryDir> m_folder;
    QProcess m_process;
    QString m_file;
};

}  // namespace myoface
