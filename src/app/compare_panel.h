// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QWidget>

#include "myoface/cases/case_state.h"

#include "face_view.h"

namespace myoface {

/// How before and after are shown, and the variants of the plan. Changes nothing itself.
class ComparePanel final : public QWidget {
    Q_OBJECT

public:
    explicit ComparePanel(QWidget* parent = nullptr);

    void setVariants(const std::vector<Variant>& variants);
    CompareMode mode() const;
    void setMode(CompareMode mode);
    bool map() const { return m_map->isChecked(); }
    void setMap(bool on) { m_map->setChecked(on); }
    /// How far one side stands out over the mirror image of the other.
    bool sides() const { return m_sides->isChecked(); }
    void setSides(bool on) { m_sides->setChecked(on); }
    double mapMillimetres() const { return m_most->value(); }
    /// Share of the change that is shown, 0 … 1.
    double share() const { return m_share->value() / 100.0; }
    void setShare(double share);
    /// What the face is compared with: -1 the scan, else a variant.
    int reference() const { return m_reference->currentIndex() - 1; }
    void setReference(int variant) { m_reference->setCurrentIndex(variant + 1); }
    /// Numbers of the map of the sides; empty: none.
    void setSidesWords(const QString& words);
    /// Numbers of the comparison with an actual result; empty: none.
    void setActualWords(const QString& words);

Q_SIGNALS:
    void edited();
    void referenceChosen(int variant);
    void storeAsked();
    void showAsked(int variant);
    void renameAsked(int variant, const QString& name);
    void removeAsked(int variant);
    void actualAsked();

private:
    QWidget* viewGroup();
    QWidget* variantGroup();
    QWidget* actualGroup();

    std::vector<QRadioButton*> m_modes;
    QRadioButton *m_map = nullptr, *m_sides = nullptr;
    QLabel* m_sidesWords = nullptr;
    QDoubleSpinBox* m_most = nullptr;
    QSlider* m_share = nullptr;
    QLabel* m_shareText = nullptr;
    QComboBox* m_reference = nullptr;
    QListWidget* m_variants = nullptr;
    QPushButton *m_show = nullptr, *m_remove = nullptr;
    QLabel* m_actual = nullptr;
};

}  // namespace myoface
