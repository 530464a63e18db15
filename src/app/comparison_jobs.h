// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/cases/case_file.h"
#include "myoface/measure/result_comparison.h"
#include "myoface/sim/snapshot.h"

#include "background_job.h"

namespace myoface {

/// Brings a variant to rest beside the window.
class SettleJob final : public BackgroundJob {
    Q_OBJECT

public:
    SettleJob(std::shared_ptr<const FaceModel> face, Variant variant, double skinAge,
              QObject* parent = nullptr);
    ~SettleJob() override { stop(); }
    const Variant& variant() const { return m_variant; }
    SimSnapshot& result() { return m_result; }

private:
    void run() override;

    std::shared_ptr<const FaceModel> m_face;
    Variant m_variant;
    double m_skinAge;
    SimSnapshot m_result;
};

/// Opens a scan of afterwards and compares a plan with it, beside the window.
class ActualJob final : public BackgroundJob {
    Q_OBJECT

public:
    ActualJob(std::shared_ptr<const FaceModel> face, Points plan, QString path,
              QObject* parent = nullptr);
    ~ActualJob() override { stop(); }
    ResultComparison& result() { return m_result; }
    const QString& path() const { return m_path; }

private:
    void run() override;

    std::shared_ptr<const FaceModel> m_face;
    Points m_plan;
    QString m_path;
    ResultComparison m_result;
};

}  // namespace myoface
