// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include <QObject>
#include <QWidget>

#include "face_document.h"
#include "simulation_worker.h"

namespace myoface {

/// Plans of the window: the history written as a plan, and a plan applied as one step of it.
class PlanFiles final : public QObject {
    Q_OBJECT

public:
    /// Runs a call in the worker's thread.
    using InWorker = std::function<void(const std::function<void(SimulationWorker&)>&)>;

    PlanFiles(FaceDocument& document, QWidget& window, InWorker inWorker);

    /// Ask with the system's dialogs.
    void chooseExport();
    void chooseApply();
    /// @return whether it was written
    bool exportTo(const QString& path);
    /// Beside the window; `applied` tells the end.
    void apply(const QString& path);
    void finished(const PlanOutcome& outcome);

Q_SIGNALS:
    void message(const QString& sentence);
    void problem(const QString& sentence);
    void applied();

private:
    FaceDocument& m_document;
    QWidget& m_window;
    InWorker m_inWorker;
    QString m_folder, m_title;
};

}  // namespace myoface
