// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "face_view.h"

namespace myoface {

/// The face alone, full screen for the patient, on another screen where there is one. Follows the
/// view of the surgeon; Esc closes it.
class PatientView final : public QWidget {
    Q_OBJECT

public:
    explicit PatientView(FaceView& leader, QWidget* parent = nullptr);

    void setScene(FaceScene* scene) { m_view->setScene(scene); }
    void refresh() { m_view->update(); }
    /// On the screen that the window is not on, where there is one.
    void present();

Q_SIGNALS:
    void closed();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void follow();

    FaceView& m_leader;
    FaceView* m_view = nullptr;
};

}  // namespace myoface
