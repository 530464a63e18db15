// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <QCheckBox>
#include <QSlider>
#include <QWidget>

#include "myoface/scene/face_scene.h"

namespace myoface {

/// Which layers are shown and how opaque: skin, muscles, bone, springs.
class LayerPanel final : public QWidget {
    Q_OBJECT

public:
    explicit LayerPanel(QWidget* parent = nullptr);

    LayerOpacity layers() const;
    void setLayers(const LayerOpacity& layers);
    /// Share of the skin that is taken away from the patient's left side on.
    double cutAway() const { return m_cut->value() / 100.0; }

Q_SIGNALS:
    void layersEdited();

private:
    struct Row {
        QCheckBox* shown = nullptr;
        QSlider* opacity = nullptr;
    };
    std::array<Row, 4> m_rows;
    QSlider* m_cut = nullptr;
};

}  // namespace myoface
