// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineF>
#include <QVector>
#include <QWidget>

namespace myoface {

/// The profile in the midplane before and now, as a drawing in millimetres that looks to the left.
class ProfilePlot final : public QWidget {
    Q_OBJECT

public:
    explicit ProfilePlot(QWidget* parent = nullptr);

    /// Pieces of both outlines [mm]: front to the left, up is up.
    void setOutlines(QVector<QLineF> before, QVector<QLineF> now);

    QSize sizeHint() const override { return {230, 250}; }
    QSize minimumSizeHint() const override { return {150, 160}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QVector<QLineF> m_before, m_now;
};

}  // namespace myoface
