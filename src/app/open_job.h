// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "myoface/cases/case_file.h"
#include "myoface/cases/journal.h"
#include "myoface/face/fitted_net.h"
#include "myoface/measure/landmarks_on_skin.h"
#include "myoface/mesh/bvh.h"
#include "myoface/scene/face_scene.h"

#include "background_job.h"

namespace myoface {

/// What an opening ended with. `simulator` is empty for a scan without landmarks.
struct OpenResult {
    std::shared_ptr<const OpenedFace> opened;
    std::unique_ptr<Simulator> simulator;
    FittedNet net;
    std::unique_ptr<FaceScene> scene;
    std::shared_ptr<const LandmarksOnSkin> places;
    Bvh bvh;  ///< of the skin, or of the scan that was not fitted
};

/// Reads and fits a face beside the window, with progress and cancel.
class OpenJob final : public BackgroundJob {
    Q_OBJECT

public:
    OpenJob(QString path, OpenOptions options, QObject* parent = nullptr);
    /// A face that was left behind.
    explicit OpenJob(Recovery recovery, std::string passphrase = {}, QObject* parent = nullptr);
    ~OpenJob() override { stop(); }

    const QString& path() const { return m_path; }
    const std::optional<Recovery>& recovery() const { return m_recovery; }
    const OpenOptions& options() const { return m_options; }
    /// It ended because a passphrase is wanted.
    bool locked() const { return m_locked; }
    OpenResult& result() { return m_result; }

private:
    void run() override;
    void open();

    QString m_path;
    OpenOptions m_options;
    std::optional<Recovery> m_recovery;
    bool m_locked = false;
    OpenResult m_result;
};

}  // namespace myoface
