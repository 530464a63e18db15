// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "myoface/cases/case_file.h"
#include "myoface/measure/result_comparison.h"
#include "myoface/scene/scene.h"
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

/// How far the sides of a face differ at a moment.
class SidesJob final : public BackgroundJob {
    Q_OBJECT

public:
    SidesJob(std::shared_ptr<const FaceModel> face, Points nodes, QObject* parent = nullptr);
    ~SidesJob() override { stop(); }
    const Points& nodes() const { return m_nodes; }
    const Eigen::VectorXd& result() const { return m_result; }
    const std::vector<RegionDistance>& regions() const { return m_regions; }

private:
    void run() override;

    std::shared_ptr<const FaceModel> m_face;
    Points m_nodes;
    Eigen::VectorXd m_result;
    std::vector<RegionDistance> m_regions;
};

/// Makes the picture of a state that stays.
class StillJob final : public BackgroundJob {
    Q_OBJECT

public:
    explicit StillJob(std::function<std::unique_ptr<SceneData>()> make, QObject* parent = nullptr);
    ~StillJob() override { stop(); }
    std::unique_ptr<SceneData>& result() { return m_result; }

private:
    void run() override { m_result = m_make(); }

    std::function<std::unique_ptr<SceneData>()> m_make;
    std::unique_ptr<SceneData> m_result;
};

/// Where soft shadows fall on a scan.
class ShadeJob final : public BackgroundJob {
    Q_OBJECT

public:
    explicit ShadeJob(std::shared_ptr<const Scan> scan, QObject* parent = nullptr);
    ~ShadeJob() override { stop(); }
    const Eigen::Matrix4Xf& result() const { return m_result; }

private:
    void run() override;

    std::shared_ptr<const Scan> m_scan;
    Eigen::Matrix4Xf m_result;
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
