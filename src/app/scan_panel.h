// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QWidget>

#include "myoface/cases/case_file.h"

namespace myoface {

/// What was found in the file and how it was understood.
class ScanPanel final : public QWidget {
    Q_OBJECT

public:
    explicit ScanPanel(QWidget* parent = nullptr);
    void setFace(const OpenedFace& face, const FaceModel* model, int springs);

private:
    QLabel* m_text = nullptr;
};

}  // namespace myoface
