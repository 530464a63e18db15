// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <QObject>
#include <QString>
#include <QThread>

#include "myoface/face/fitted_net.h"
#include "myoface/sim/simulator.h"

namespace myoface {

/// Fits a scan anew to moved landmarks, beside the window. Shape and contractions are kept.
class FitJob final : public QObject {
    Q_OBJECT

public:
    FitJob(std::shared_ptr<const Scan> scan, Landmarks landmarks, const FitOptions& options,
           Contractions contractions, Points shape);
    ~FitJob() override;
    FitJob(const FitJob&) = delete;
    FitJob& operator=(const FitJob&) = delete;

    void start();
    /// Empty when the fit failed; problem() says why.
    std::unique_ptr<Simulator>& simulator() { return m_simulator; }
    const std::shared_ptr<const FaceModel>& model() const { return m_model; }
    const FittedNet& net() const { return m_net; }
    const QString& problem() const { return m_problem; }

Q_SIGNALS:
    void finished();

private:
    void run();

    std::shared_ptr<const Scan> m_scan;
    Landmarks m_landmarks;
    FitOptions m_options;
    Contractions m_contractions;
    Points m_shape;  ///< see shape_of_scan()
    Progress m_progress;
    std::shared_ptr<const FaceModel> m_model;
    std::unique_ptr<Simulator> m_simulator;
    FittedNet m_net;
    QString m_problem;
    std::unique_ptr<QThread> m_thread;
};

}  // namespace myoface
