// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include <QWidget>

#include "myoface/face/tissue.h"

namespace myoface {

/// Millilitres that came to each region, as bars around a middle line: to the right what was added.
class VolumePlot final : public QWidget {
    Q_OBJECT

public:
    explicit VolumePlot(QWidget* parent = nullptr);

    void setVolumes(const std::map<Region, double>& millilitres);
    const std::map<Region, double>& volumes() const { return m_volumes; }

    QSize sizeHint() const override { return {230, 220}; }
    QSize minimumSizeHint() const override { return {150, 120}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::map<Region, double> m_volumes;
};

}  // namespace myoface
