// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QObject>

#include "myoface/face/fitted_net.h"
#include "myoface/scene/scene.h"

#include "detect_job.h"
#include "face_document.h"
#include "fit_job.h"

namespace myoface {

class FaceView;
class LandmarkPanel;

/// Landmarks in the window: shows them on the skin, lets them be dragged, accepted, mirrored and
/// found again, each an undo step, and has the face fitted anew after each change.
class LandmarkEditor final : public QObject {
    Q_OBJECT

public:
    LandmarkEditor(FaceDocument& document, FaceView& view, LandmarkPanel& panel,
                   QObject* parent = nullptr);
    ~LandmarkEditor() override;
    LandmarkEditor(const LandmarkEditor&) = delete;
    LandmarkEditor& operator=(const LandmarkEditor&) = delete;

    /// A face was opened; the net of its fit, empty without one.
    void setFace(FittedNet net, const Bvh& skin);
    /// Draws markers and net into a scene whose skin stands at `positions`.
    void draw(SceneData& scene, const Points& positions);
    bool fitting() const { return m_job != nullptr || m_detection != nullptr; }

Q_SIGNALS:
    /// Markers or net have changed.
    void changed();
    void fitted(myoface::FitJob& job);
    void problem(const QString& sentence);

private:
    void bind();
    void bind(const Bvh& skin);
    void push(Landmarks landmarks, const QString& text);
    void moved(int handle, const SurfacePoint& where, bool dropped);
    void accept(const std::string& name);
    void mirror(const std::string& name);
    void detect();
    void detected();
    void look(const std::string& name);
    void refit();
    void jobFinished();

    FaceDocument& m_document;
    FaceView& m_view;
    LandmarkPanel& m_panel;
    std::vector<std::string> m_names;  ///< of the handles
    std::vector<SurfacePoint> m_where;
    int m_held = -1;
    FittedNet m_net;
    bool m_netStale = false;  ///< not yet in the scene
    std::uint64_t m_netVersion = 0;
    std::unique_ptr<FitJob> m_job;
    std::unique_ptr<DetectJob> m_detection;
    bool m_again = false;  ///< landmarks changed while a fit was running
};

}  // namespace myoface
