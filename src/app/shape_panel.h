// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "myoface/sim/shaping.h"
#include "myoface/sim/target.h"

namespace myoface {

/// How the hand grips, and shaping by numbers: millimetres, millilitres, measures.
class ShapePanel final : public QWidget {
    Q_OBJECT

public:
    explicit ShapePanel(QWidget* parent = nullptr);

    /// 0: by region.
    double radius() const;
    bool mirrored() const { return m_mirror->isChecked(); }
    DragPath path() const { return static_cast<DragPath>(m_path->currentIndex()); }
    bool showsKernel() const { return m_kernel->isChecked(); }
    double millilitres() const { return m_millilitres->value(); }
    bool erases() const { return m_erase->isChecked(); }
    const Measure& measure() const {
        return m_measures[static_cast<std::size_t>(m_measure->currentIndex())];
    }

    void setRadius(double millimetres);
    void toggleMirror() { m_mirror->toggle(); }
    /// @param value of the chosen measure now, or not a number
    void showMeasure(double before, double value);
    void say(const QString& sentence) { m_words->setText(sentence); }

Q_SIGNALS:
    void optionsEdited();
    void moveAsked(double right, double up);
    void targetAsked(double value);
    void clearProtectionAsked();

private:
    QWidget* gripGroup();
    QWidget* numbersGroup();
    QWidget* targetGroup();

    std::vector<Measure> m_measures;
    QCheckBox* m_byRegion = nullptr;
    QDoubleSpinBox* m_radius = nullptr;
    QCheckBox* m_mirror = nullptr;
    QComboBox* m_path = nullptr;
    QCheckBox* m_kernel = nullptr;
    QCheckBox* m_erase = nullptr;
    QDoubleSpinBox* m_millilitres = nullptr;
    QDoubleSpinBox *m_right = nullptr, *m_up = nullptr;
    QComboBox* m_measure = nullptr;
    QLabel* m_now = nullptr;
    QDoubleSpinBox* m_target = nullptr;
    QLabel* m_words = nullptr;
};

}  // namespace myoface
