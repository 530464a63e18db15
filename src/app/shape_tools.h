// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QObject>

#include "myoface/measure/landmarks_on_skin.h"
#include "myoface/scene/face_scene.h"

#include "face_document.h"
#include "face_view.h"
#include "shape_panel.h"
#include "simulation_worker.h"

namespace myoface {

/// What the hand does to the face in the window: between the view, which says where, the panel,
/// which says how, and the worker, which does it. Draws what belongs to the hand.
class ShapeTools final : public QObject {
    Q_OBJECT

public:
    /// Runs a call in the worker's thread.
    using InWorker = std::function<void(const std::function<void(SimulationWorker&)>&)>;

    ShapeTools(FaceDocument& document, FaceView& view, ShapePanel& panel, InWorker inWorker,
               QObject* parent = nullptr);

    /// Another face, or the same one fitted anew; null: none.
    void setScene(FaceScene* scene, std::shared_ptr<const LandmarksOnSkin> places = nullptr);
    /// Whether the skin's colours are the hand's: else something else paints them.
    void setPaints(bool paints);
    /// Ring, grabbed point, force and what is protected.
    void draw(SceneData& scene, const SimSnapshot& snapshot);
    /// What the hand feels, in words; empty while there is none.
    QString words(const SimSnapshot& snapshot) const;
    void finished(const DragOutcome& outcome);
    /// Something that cannot be done: said where it was asked for.
    void refused(const QString& sentence) { m_panel.say(sentence); }

Q_SIGNALS:
    void changed();  ///< draw again
    void message(const QString& sentence);

private:
    void grip(const SurfacePoint& where, const ViewRay& ray);
    void hover(const std::optional<SurfacePoint>& where);
    void place(const SurfacePoint& where);
    void brush(const SurfacePoint& where);
    void endStroke();
    void protectionChanged();
    void nudge(double right, double up);
    void meet(double value);
    void paint();
    DepthInset inset(const DragReport& drag, const SimSnapshot& snapshot) const;
    DragRequest request(const SurfacePoint& where) const;
    double radiusAt(const SurfacePoint& where) const;

    FaceDocument& m_document;
    FaceView& m_view;
    ShapePanel& m_panel;
    InWorker m_inWorker;
    FaceScene* m_scene = nullptr;
    std::shared_ptr<const LandmarksOnSkin> m_landmarks;
    std::optional<SurfacePoint> m_under;    ///< the cursor
    std::optional<SurfacePoint> m_gripped;  ///< last: nudging goes on with it
    Eigen::VectorXd m_protection;           ///< with the stroke that is going on
    Plan m_strokes;                         ///< the same for a plan
    bool m_paints = true;
    double m_radiusBefore = 0.0;
};

}  // namespace myoface
