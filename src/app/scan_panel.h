// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "myoface/cases/case_file.h"

namespace myoface {

/// What was found in the file, what was repaired, and how unit and axes were understood, with the
/// means to change them.
class ScanPanel final : public QWidget {
    Q_OBJECT

public:
    explicit ScanPanel(QWidget* parent = nullptr);
    void setFace(const OpenedFace& face, const FaceModel* model, int springs);

Q_SIGNALS:
    void unitEdited(double mmPerUnit);
    void turnAsked(int axis);
    void calibrationAsked();
    void loosePartsEdited(bool shown);

private:
    void buildFrameControls();

    QLabel* m_text = nullptr;
    QLabel* m_frameText = nullptr;
    QWidget* m_frame = nullptr;
    QComboBox* m_unit = nullptr;
    QCheckBox* m_looseParts = nullptr;
    QLabel* m_notes = nullptr;
};

}  // namespace myoface
