// SPDX-License-Identifier: Apache-2.0
#include "report_export.h"

#include <QCoreApplication>
#include <QDir>
#include <QProcessEnvironment>

#include "myoface/base/error.h"

#include "language.h"

namespace myoface {

ReportExport::ReportExport(QObject* parent) : QObject(parent), m_process(this) {
    connect(&m_process, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this,
            &ReportExport::finish);
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) {
            Q_EMIT failed(tr("%1 does not start: it writes the report and belongs beside this "
                             "program.")
                              .arg(m_process.program()));
        }
    });
}

void ReportExport::start(const FaceDocument& document, const QString& file,
                         const ReportWords& words, const Population& population) {
    m_file = file;
    m_folder = std::make_unique<QTemporaryDir>();
    if (!m_folder->isValid()) {
        throw IoError("There is no place for temporary files: " +
                      m_folder->errorString().toStdString());
    }
    const QString copy = m_folder->filePath(QStringLiteral("case.myoface"));
    write_case(copy.toStdString(), document.asSaved(), document.state());
    QStringList arguments{QStringLiteral("report"),     copy,
                          QStringLiteral("-o"),         file,
                          QStringLiteral("--age"),      QString::number(population.age),
                          QStringLiteral("--language"), Language::instance().code()};
    for (const auto& [option, value] :
         {std::pair("--title", words.title), std::pair("--patient", words.patient),
          std::pair("--notes", words.notes), std::pair("--logo", words.logo)}) {
        if (!value.trimmed().isEmpty()) {
            arguments << QString::fromLatin1(option) + QLatin1Char('=') + value;
        }
    }
    if (population.sex) {
        arguments << QStringLiteral("--sex")
                  << (*population.sex == Sex::Female ? QStringLiteral("f") : QStringLiteral("m"));
    }
    if (words.anonymous) {
        arguments << QStringLiteral("--anonymous");
    }
    // The copy is protected as the case is.
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("MYOFACE_PASSPHRASE"),
                       QString::fromStdString(document.passphrase()));
    m_process.setProcessEnvironment(environment);
    m_process.start(
        QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("myoface-cli")),
        arguments);
}

void ReportExport::finish(int code, QProcess::ExitStatus status) {
    m_folder.reset();
    if (status == QProcess::NormalExit && code == 0) {
        Q_EMIT written(m_file);
        return;
    }
    const QString sentence = QString::fromUtf8(m_process.readAllStandardError())
                                 .trimmed()
                                 .section(QLatin1Char('\n'), -1);
    Q_EMIT failed(sentence.isEmpty() ? tr("The report was not written.") : sentence);
}

}  // namespace myoface
