// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>

#include "myoface/face/landmarks.h"
#include "myoface/face/tissue.h"

namespace myoface {

/// Colour of a landmark by how sure it is: green, amber, red; blue once the user has placed or
/// accepted it.
QColor landmarkColour(const Landmark& landmark);
/// Error of a landmark that a person has placed or accepted [mm].
inline constexpr double kCheckedError = 0.5;

/// All landmarks with how sure each is, the definition and a picture of the chosen one, and the
/// next one worth a look. Changes nothing itself.
class LandmarkPanel final : public QWidget {
    Q_OBJECT

public:
    explicit LandmarkPanel(QWidget* parent = nullptr);

    void setLandmarks(const Landmarks& landmarks);
    void select(const std::string& name);
    /// What is chosen, or "".
    std::string selected() const;
    /// Markers and net on, and the landmark chosen that is next to be checked.
    void showAll();
    bool netShown() const { return m_net->isChecked(); }
    bool markersShown() const { return m_edit->isChecked(); }
    void setTissue(TissueThickness tissue);
    /// While landmarks are looked for, they cannot be looked for again.
    void setDetecting(bool detecting);
    /// How far the fitted head lies off the scan.
    void setMisfit(double median, double most);

Q_SIGNALS:
    void chosen(const std::string& name);
    void accepted(const std::string& name);
    void mirrorAsked(const std::string& name);
    void detectionAsked();
    void tissueChosen(myoface::TissueThickness tissue);
    void displayChanged();

private:
    void describe();
    void selectNext();

    Landmarks m_landmarks;
    QTreeWidget* m_list = nullptr;
    QLabel* m_picture = nullptr;
    QLabel* m_definition = nullptr;
    QLabel* m_misfit = nullptr;
    QCheckBox* m_edit = nullptr;
    QCheckBox* m_net = nullptr;
    QPushButton* m_next = nullptr;
    QPushButton* m_accept = nullptr;
    QPushButton* m_mirror = nullptr;
    QPushButton* m_detect = nullptr;
    QComboBox* m_tissue = nullptr;
};

}  // namespace myoface
