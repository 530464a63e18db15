// SPDX-License-Identifier: Apache-2.0
#include "cli_export.h"

#include <QCoreApplication>
#include <QDir>
#include <QProcessEnvironment>
#include <QRegularExpression>

#include "myoface/base/error.h"

#include "language.h"

namespace myoface {

CliExport::CliExport(QObject* parent) : QObject(parent), m_process(this) {
    connect(&m_process, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this,
            &CliExport::finish);
    connect(&m_process, &QProcess::readyReadStandardError, this, &CliExport::listen);
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) {
            m_folder.reset();
            Q_EMIT failed(tr("%1 does not start: it writes the report and belongs beside this "
                             "program.")
                              .arg(m_process.program()));
        }
    });
}

CliExport::~CliExport() {
    m_process.disconnect(this);
    m_process.kill();
    m_process.waitForFinished(1000);
}

void CliExport::start(const FaceDocument& document, const QString& command, const QString& file,
                      const QStringList& options) {
    m_file = file;
    m_said.clear();
    m_cancelled = false;
    m_folder = std::make_unique<QTemporaryDir>();
    const QString copy = m_folder->filePath(QStringLiteral("case.myoface"));
    m_arguments = QStringList{command, copy, QStringLiteral("-o"), file} + options;
    // What is large is shared, so that the copy costs this thread nothing.
    m_passphrase = QString::fromStdString(document.passphrase());
    m_copying =
        std::make_unique<FileJob>([copy, opened = document.opened(), edits = document.edits(),
                                   passphrase = document.passphrase()](const Progress& progress) {
            OpenedFace face = asSaved(*opened, edits);
            face.passphrase = passphrase;
            write_case(copy.toStdString(), face, stateOf(edits), &progress);
        });
    connect(m_copying.get(), &FileJob::finished, this, &CliExport::copied);
    m_copying->start();
}

void CliExport::copied() {
    const std::unique_ptr<FileJob> job = std::move(m_copying);
    if (job->cancelled()) {
        m_folder.reset();
        Q_EMIT cancelled();
    } else if (!job->problem().isEmpty()) {
        m_folder.reset();
        Q_EMIT failed(job->problem());
    } else {
        // The copy is protected as the case is.
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("MYOFACE_PASSPHRASE"), m_passphrase);
        m_process.setProcessEnvironment(environment);
        m_process.start(
            QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("myoface-cli")),
            m_arguments);
    }
}

void CliExport::cancel() {
    m_cancelled = true;
    if (m_copying) {
        m_copying->cancel();
    } else {
        m_process.kill();
    }
}

/// The program says how far it is as "NN %" on a line.
void CliExport::listen() {
    m_said += QString::fromUtf8(m_process.readAllStandardError());
    static const QRegularExpression kShare(QStringLiteral("(\\d+) %"));
    QRegularExpressionMatchIterator found = kShare.globalMatch(m_said);
    int percent = -1;
    while (found.hasNext()) {
        percent = found.next().captured(1).toInt();
    }
    if (percent >= 0) {
        Q_EMIT progressed(percent);
    }
}

void CliExport::finish(int code, QProcess::ExitStatus status) {
    m_folder.reset();
    if (m_cancelled) {
        Q_EMIT cancelled();
        return;
    }
    if (status == QProcess::NormalExit && code == 0) {
        Q_EMIT written(m_file);
        return;
    }
    QString sentence = m_said.trimmed().section(QLatin1Char('\n'), -1);
    const QString name = QStringLiteral("myoface-cli: ");
    if (sentence.startsWith(name)) {
        sentence.remove(0, name.size());
    }
    Q_EMIT failed(sentence.isEmpty() ? tr("%1 was not written.").arg(m_file)
                                     : inWords(sentence.toStdString()));
}

}  // namespace myoface
