// SPDX-License-Identifier: Apache-2.0
#include "plan_files.h"

#include <numeric>
#include <utility>

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"

#include "commands.h"

namespace myoface {
namespace {

/// What came of a plan, in the language of the interface.
QString inSentences(const Replay& replay) {
    QString text =
        PlanFiles::tr("%1 of %2 edits of the plan were made.").arg(replay.done).arg(replay.edits);
    if (replay.face == CarriedPlan::Face::Other) {
        text += QLatin1Char(' ') +
                PlanFiles::tr("They were carried over from another scan through the fit.");
    }
    for (const RefusedEdit& edit : replay.refused) {
        text += PlanFiles::tr("\nEdit %1 (%2) was left out: %3")
                    .arg(edit.edit)
                    .arg(QString::fromStdString(edit.what), QString::fromStdString(edit.why));
    }
    if (replay.largest_doubt_mm > kDoubtfulPlace) {
        text += PlanFiles::tr("\nLook at edit %1: fit and landmarks put its place %2 mm apart.")
                    .arg(replay.most_doubtful)
                    .arg(replay.largest_doubt_mm, 0, 'f', 0);
    }
    return text;
}

}  // namespace

PlanFiles::PlanFiles(FaceDocument& document, QWidget& window, InWorker inWorker)
    : QObject(&window), m_document(document), m_window(window), m_inWorker(std::move(inWorker)) {}

void PlanFiles::chooseExport() {
    if (m_document.plan().empty()) {
        Q_EMIT problem(tr("Nothing has been done to this face yet: there is no plan to write."));
        return;
    }
    QString path = QFileDialog::getSaveFileName(&m_window, tr("Export the plan"), m_folder,
                                                tr("Plan (*.json)"));
    if (!path.isEmpty()) {
        exportTo(QFileInfo(path).suffix().isEmpty() ? path + QStringLiteral(".json") : path);
    }
}

bool PlanFiles::exportTo(const QString& path) {
    try {
        write_file(path.toStdString(),
                   recorded_plan_to_json({plan_origin(*m_document.model()), m_document.plan()}));
    } catch (const Error& error) {
        Q_EMIT problem(QString::fromUtf8(error.what()));
        return false;
    }
    m_folder = QFileInfo(path).absolutePath();
    Q_EMIT message(tr("Written: %1").arg(path));
    return true;
}

void PlanFiles::chooseApply() {
    if (!m_document.model()) {
        return;
    }
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Apply a plan"), m_folder,
                                                      tr("Plans (*.json);;All files (*)"));
    if (!path.isEmpty()) {
        apply(path);
    }
}

void PlanFiles::apply(const QString& path) {
    if (!m_document.model()) {
        return;
    }
    try {
        const RecordedPlan plan =
            recorded_plan_from_json(read_file(path.toStdString()), path.toStdString());
        m_folder = QFileInfo(path).absolutePath();
        m_title = QFileInfo(path).completeBaseName();
        Q_EMIT message(tr("Applying the plan…"));
        m_inWorker([plan](SimulationWorker& w) { w.applyPlan(plan); });
    } catch (const Error& error) {
        Q_EMIT problem(QString::fromUtf8(error.what()));
    }
}

void PlanFiles::finished(const PlanOutcome& outcome) {
    const auto& model = m_document.model();
    if (!model || outcome.after.cols() != m_document.skinRest().cols()) {
        return;  // another face was opened meanwhile
    }
    if (outcome.replay.done > 0) {
        std::vector<int> all(outcome.rates.size());
        std::iota(all.begin(), all.end(), 0);
        std::vector<std::unique_ptr<QUndoCommand>> parts;
        parts.push_back(std::make_unique<SetMusclesCommand>(m_document, MuscleSetting::Rate, all,
                                                            outcome.rates, -1, QString()));
        parts.push_back(std::make_unique<SetMusclesCommand>(m_document, MuscleSetting::Strength,
                                                            all, outcome.strengths, -1, QString()));
        parts.push_back(
            std::make_unique<SetProtectionCommand>(m_document, outcome.protection, QString()));
        parts.push_back(
            std::make_unique<ReshapeCommand>(m_document, outcome.before, outcome.after, QString()));
        m_document.undoStack()->push(new PlanCommand(tr("plan %1").arg(m_title),
                                                     outcome.replay.made, model, std::move(parts)));
    }
    const QString sentences = inSentences(outcome.replay);
    const bool smooth =
        outcome.replay.refused.empty() && outcome.replay.largest_doubt_mm <= kDoubtfulPlace;
    if (smooth) {
        Q_EMIT message(sentences);
    } else {
        Q_EMIT problem(sentences);
    }
    Q_EMIT applied();
}

}  // namespace myoface
