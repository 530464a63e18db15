// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <QLineF>
#include <QOpenGLWidget>
#include <QTimer>
#include <QVector>

#include "myoface/mesh/bvh.h"
#include "myoface/scene/camera.h"
#include "myoface/scene/face_scene.h"

#include "view_panes.h"

namespace myoface {

class Renderer;

/// What the left mouse button does on the skin.
enum class Tool { Navigate, Shape, Feel, Volume, Protect, Measure, Section };

/// How a face and an earlier state of it share the view.
enum class CompareMode { Off, SideBySide, Wipe, Ghost };

/// Words beside a place of the face.
struct ViewLabel {
    Vec3 at;
    QString text;
};

/// A cut through the face at the hand, seen from the side [mm]: to the right is towards the viewer.
struct DepthInset {
    QVector<QLineF> before, now, bone;
    QPointF point;
};

/// The 3D view: draws a FaceScene and turns mouse and keys into camera moves and grips. It never
/// changes the face itself.
class FaceView final : public QOpenGLWidget {
    Q_OBJECT

public:
    explicit FaceView(QWidget* parent = nullptr);
    ~FaceView() override;
    FaceView(const FaceView&) = delete;
    FaceView& operator=(const FaceView&) = delete;

    /// The scene to draw; null for an empty view. The view does not own its contents.
    void setScene(FaceScene* scene);
    /// What can be gripped: the skin's triangles, at positions that setSkinPositions() updates.
    void setSkin(const TriangleMesh& skin) { setSkin(skin, Bvh(skin)); }
    void setSkin(const TriangleMesh& skin, Bvh bvh);
    void setSkinPositions(const Points& positions);
    void setTool(Tool tool);
    Tool tool() const { return m_tool; }
    /// Clicks on the skin are reported instead of gripping.
    void setPickMode(bool on);
    /// Places that the left button takes hold of before anything else, to move them on the skin.
    void setHandles(std::vector<Vec3> handles) { m_handles = std::move(handles); }
    /// Turns the camera so that a place on the skin is seen from before it, if it is not.
    void bringIntoView(const Vec3& point);

    /// Shows another state beside, instead of or over the face. @param before null: none
    void setCompare(CompareMode mode, std::shared_ptr<const SceneData> before,
                    const QString& title = {});
    CompareMode compareMode() const { return m_compare; }
    /// Where the wipe stands: 0 left … 1 right.
    void setWipe(double share);
    double wipe() const { return m_wipe; }
    void setLabels(std::vector<ViewLabel> labels) { m_labels = std::move(labels); }
    /// How hard the hand pulls, at the tip of its arrow; or nothing.
    void setHandLabel(std::optional<ViewLabel> label) { m_handLabel = std::move(label); }
    /// Colours of a legend in the lower left corner, lowest first, and words at its ends; none: no
    /// legend.
    void setLegend(const QVector<QColor>& colours, const QString& low, const QString& high);

    /// Drawn in a corner while there is one.
    void setInset(std::optional<DepthInset> inset) { m_inset = std::move(inset); }
    /// A closed line on the skin around a place [mm].
    std::vector<Vec3> ringOnSkin(const SurfacePoint& where, double radius);

    /// Of the part that was worked in last.
    const Camera& camera() const { return m_cameras[m_active]; }
    void setCamera(const Camera& camera);
    /// The part that was worked in last, from another side.
    void showStandardView(const QString& name);
    /// One, two or four sides of the face at once; each can be worked in.
    void setLayout(ViewLayout layout);
    ViewLayout layout() const { return m_layout; }
    /// Whether turning, panning and zooming one part does the same to all.
    void setLinked(bool on) { m_linked = on; }
    bool linked() const { return m_linked; }
    const Camera& cameraOf(int part) const { return m_cameras[static_cast<std::size_t>(part)]; }
    /// The parts as they lie in the widget.
    std::vector<ViewPane> panes() const {
        return viewPanes(m_layout, m_compare == CompareMode::SideBySide, size());
    }
    /// Time that drawing has taken since the program began [ms].
    static double drawingTime();
    void frameFace(const Vec3& centre, double radius);
    /// Even light from the front instead of a portrait's.
    void setClinicalLight(bool on);
    void setTextured(bool on);
    void setWireframe(bool on);
    /// Turns the head slowly until the mouse takes it.
    void setTurning(bool on);
    /// Frames the head again as frameFace() did, seen from where it is.
    void frameAgain() { frameFace(m_homeCentre, m_homeRadius); }
    void setOrthographic(bool on);

    QSize minimumSizeHint() const override { return {320, 320}; }

Q_SIGNALS:
    void gripped(const myoface::SurfacePoint& where, const myoface::ViewRay& ray);
    void pulled(const myoface::ViewRay& ray);
    /// @param otherwise Shift was held: keep what would spring back
    void released(bool keep, bool otherwise);
    /// A click on the skin with the Volume tool, and a stroke with the Protect tool.
    void placed(const myoface::SurfacePoint& where);
    void brushed(const myoface::SurfacePoint& where);
    void brushEnded();
    /// A click on the skin with the Measure tool.
    void measured(const myoface::SurfacePoint& where);
    void measureEnded();
    /// A click on the skin with the Section tool, or a line drawn across the face: the plane that
    /// the eye sees as that line.
    void sectionPlaced(const myoface::SurfacePoint& where);
    void sectionDrawn(const myoface::Vec3& through, const myoface::Vec3& normal);
    /// Arrow keys: steps to the right and up; with Shift ten.
    void nudged(double right, double up);
    void mirrorToggled();
    /// F, then the mouse to the right or left: by so many mm.
    void radiusStarted();
    void radiusMoved(double millimetres);
    void radiusCancelled();
    void picked(const myoface::Vec3& point);
    void pickCancelled();
    /// The mouse rests over this line of sight, and over this place of the skin or none.
    void hovered(const myoface::ViewRay& ray, const std::optional<myoface::SurfacePoint>& where);
    void handlePressed(int handle);
    void handleMoved(int handle, const myoface::SurfacePoint& where);
    void handleDropped(int handle, const myoface::SurfacePoint& where);
    void drawingFailed(const QString& sentence);
    void beforeHeld(bool held);
    void wipeMoved(double share);
    void cameraMoved();
    void turningEnded();

protected:
    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    enum class Action {
        None,
        Orbit,
        Pan,
        Grip,
        MaybePick,
        Handle,
        MaybePlace,
        Brush,
        Radius,
        Wipe,
        Knife
    };

    // In face_view.cpp.
    ViewPane paneAt(const QPointF& at) const;
    /// The part that shows the face as it is now, of the camera in use.
    ViewPane livePane() const;
    const Camera& cameraOf(const ViewPane& pane) const {
        return m_cameras[static_cast<std::size_t>(pane.camera)];
    }
    ViewRay rayAt(const QPointF& at) const;
    void zoomTowards(const QPointF& at, double factor);
    PixelPoint pixelOf(const Vec3& point, const ViewPane& pane) const;
    std::optional<RayHit> hitAt(const QPointF& at);
    void updateCursor(bool onSkin);
    /// Number of the handle under a pixel that the skin does not hide, or -1.
    int handleAt(const QPointF& at);
    void releaseRenderer();
    double fit() const { return headFit(livePane().area, m_layout); }
    void moved();
    /// Moves the camera in use, and the others alike where they are linked.
    template <typename Change>
    void changeCameras(const Change& change) {
        for (std::size_t c = 0; c < m_cameras.size(); ++c) {
            if (m_linked || c == m_active) {
                change(m_cameras[c]);
            }
        }
        moved();
    }

    // In face_view_paint.cpp.
    void drawScenes(double ratio);
    void drawWords(QPainter& painter);
    void drawPaneWords(QPainter& painter, const ViewPane& pane);
    void drawLegend(QPainter& painter, const QRectF& area);
    void drawInset(QPainter& painter);

    // In face_view_input.cpp.
    bool onWipe(const QPointF& at) const;
    bool beginOnSkin(const QPointF& at);
    void cut(const QPointF& to);
    bool nudgeKey(const QKeyEvent& event);

    FaceScene* m_scene = nullptr;
    std::unique_ptr<Renderer> m_renderer, m_beforeRenderer;
    std::shared_ptr<const SceneData> m_beforeScene;
    CompareMode m_compare = CompareMode::Off;
    QString m_beforeTitle;
    double m_wipe = 0.5;
    ViewStyle m_style;
    QTimer m_turning;
    std::vector<ViewLabel> m_labels;
    std::optional<ViewLabel> m_handLabel;
    QVector<QColor> m_legend;
    QString m_legendLow, m_legendHigh;
    TriangleMesh m_skin;
    Bvh m_bvh;
    bool m_bvhStale = true;
    std::array<Camera, 4> m_cameras;
    std::size_t m_active = 0;  ///< camera that was worked with last
    ViewLayout m_layout = ViewLayout::One;
    bool m_linked = true;
    Tool m_tool = Tool::Shape;
    Action m_action = Action::None;
    bool m_pickMode = false;
    std::vector<Vec3> m_handles;
    int m_handle = -1;
    SurfacePoint m_handleAt;
    bool m_handleMoved = false;
    QPointF m_last, m_pressed;
    std::optional<QLineF> m_knife;  ///< drawn across the face [px]
    std::optional<DepthInset> m_inset;
    Vec3 m_homeCentre = Vec3::Zero();
    double m_homeRadius = 130.0;
};

}  // namespace myoface
