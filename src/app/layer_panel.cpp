// SPDX-License-Identifier: Apache-2.0
#include "layer_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

namespace myoface {

LayerPanel::LayerPanel(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(12, 8, 12, 8);
    grid->setVerticalSpacing(6);
    const std::array<QString, 4> names{tr("Skin"), tr("Muscles"), tr("Bone"), tr("Springs")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        Row& row = m_rows[i];
        row.shown = new QCheckBox(names[i]);
        row.opacity = new QSlider(Qt::Horizontal);
        row.opacity->setRange(5, 100);
        row.opacity->setAccessibleName(tr("Opacity of %1").arg(names[i]));
        row.opacity->setToolTip(tr("Opacity"));
        grid->addWidget(row.shown, static_cast<int>(i), 0);
        grid->addWidget(row.opacity, static_cast<int>(i), 1);
        connect(row.shown, &QCheckBox::toggled, this, [this, i](bool on) {
            m_rows[i].opacity->setEnabled(on);
            Q_EMIT layersEdited();
        });
        connect(row.opacity, &QSlider::valueChanged, this, &LayerPanel::layersEdited);
    }
    m_cut = new QSlider(Qt::Horizontal);
    m_cut->setRange(0, 100);
    m_cut->setAccessibleName(tr("Cut-away"));
    m_cut->setToolTip(tr("Takes the skin away from the patient's left side on"));
    grid->addWidget(new QLabel(tr("Cut-away")), 4, 0);
    grid->addWidget(m_cut, 4, 1);
    connect(m_cut, &QSlider::valueChanged, this, &LayerPanel::layersEdited);
    auto* presets = new QHBoxLayout;
    struct Preset {
        QString name;
        LayerOpacity layers;
    };
    const std::array<Preset, 4> list{{{tr("Skin"), {1.0F, 0.0F, 0.0F, 0.0F}},
                                      {tr("Muscles"), {0.0F, 1.0F, 1.0F, 0.0F}},
                                      {tr("Bone"), {0.0F, 0.0F, 1.0F, 0.0F}},
                                      {tr("All"), {0.35F, 1.0F, 1.0F, 0.0F}}}};
    for (const Preset& preset : list) {
        auto* button = new QPushButton(preset.name);
        button->setFlat(false);
        connect(button, &QPushButton::clicked, this, [this, layers = preset.layers] {
            setLayers(layers);
            Q_EMIT layersEdited();
        });
        presets->addWidget(button);
    }
    grid->addLayout(presets, 5, 0, 1, 2);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(6, 1);
    setLayers({});
}

LayerOpacity LayerPanel::layers() const {
    const auto value = [&](std::size_t i) {
        return m_rows[i].shown->isChecked()
                   ? static_cast<float>(m_rows[i].opacity->value()) / 100.0F
                   : 0.0F;
    };
    return {value(0), value(1), value(2), value(3)};
}

void LayerPanel::setLayers(const LayerOpacity& layers) {
    const std::array<float, 4> values{layers.skin, layers.muscles, layers.bone, layers.springs};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const QSignalBlocker a(m_rows[i].shown);
        const QSignalBlocker b(m_rows[i].opacity);
        m_rows[i].shown->setChecked(values[i] > 0.0F);
        m_rows[i].opacity->setEnabled(values[i] > 0.0F);
        m_rows[i].opacity->setValue(values[i] > 0.0F ? qRound(100.0F * values[i]) : 100);
    }
}

}  // namespace myoface
