// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <QObject>

#include "myoface/face/face_model.h"
#include "myoface/scene/scene.h"

#include "face_view.h"

namespace myoface {

/// Free measuring on the skin: two clicks give the straight distance and that along the skin, a
/// third the angle at the second. The places go along with the face.
class Callipers final : public QObject {
    Q_OBJECT

public:
    explicit Callipers(FaceView& view, QObject* parent = nullptr);

    void setFace(std::shared_ptr<const FaceModel> face);
    void clear();
    /// Draws lines and labels on a face whose nodes stand at `nodes`.
    void draw(SceneData& scene, const Points& nodes);
    /// What is measured, in words; empty: nothing.
    const QString& words() const { return m_words; }

Q_SIGNALS:
    void changed();
    void message(const QString& sentence);

private:
    void add(const SurfacePoint& where);

    FaceView& m_view;
    std::shared_ptr<const FaceModel> m_face;
    std::vector<SurfacePoint> m_places;
    QString m_words;
};

}  // namespace myoface
