// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QLineF>
#include <QOpenGLWidget>
#include <QVector>

#include "myoface/mesh/bvh.h"
#include "myoface/scene/camera.h"
#include "myoface/scene/face_scene.h"

namespace myoface {

class Renderer;

/// What the left mouse button does on the skin.
enum class Tool { Navigate, Shape, Feel, Volume, Protect };

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
    void setSkin(const TriangleMesh& skin);
    void setSkinPositions(const Points& positions);
    void setTool(Tool tool);
    Tool tool() const { return m_tool; }
    /// Clicks on the skin are reported instead of gripping.
    void setPickMode(bool on);
    /// Places that the left button takes hold of before anything else, to move them on the skin.
    void setHandles(std::vector<Vec3> handles) { m_handles = std::move(handles); }
    /// Turns the camera so that a place on the skin is seen from before it, if it is not.
    void bringIntoView(const Vec3& point);

    /// Drawn in a corner while there is one.
    void setInset(std::optional<DepthInset> inset) { m_inset = std::move(inset); }
    /// A closed line on the skin around a place [mm].
    std::vector<Vec3> ringOnSkin(const SurfacePoint& where, double radius);

    const Camera& camera() const { return m_camera; }
    void showStandardView(const QString& name);
    void frameFace(const Vec3& centre, double radius);
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

protected:
    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    enum class Action { None, Orbit, Pan, Grip, MaybePick, Handle, MaybePlace, Brush, Radius };

    ViewRay rayAt(const QPointF& at) const;
    std::optional<RayHit> hitAt(const QPointF& at);
    void updateCursor(bool onSkin);
    /// Number of the handle under a pixel that the skin does not hide, or -1.
    int handleAt(const QPointF& at);
    void releaseRenderer();
    void drawInset();
    bool beginOnSkin(const QPointF& at);
    bool nudgeKey(const QKeyEvent& event);

    FaceScene* m_scene = nullptr;
    std::unique_ptr<Renderer> m_renderer;
    TriangleMesh m_skin;
    Bvh m_bvh;
    bool m_bvhStale = true;
    Camera m_camera;
    Tool m_tool = Tool::Shape;
    Action m_action = Action::None;
    bool m_pickMode = false;
    std::vector<Vec3> m_handles;
    int m_handle = -1;
    SurfacePoint m_handleAt;
    bool m_handleMoved = false;
    QPointF m_last, m_pressed;
    std::optional<DepthInset> m_inset;
    Vec3 m_homeCentre = Vec3::Zero();
    double m_homeRadius = 130.0;
};

}  // namespace myoface
