// SPDX-License-Identifier: Apache-2.0
#include "patient_view.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QScreen>
#include <QVBoxLayout>
#include <QWindow>

namespace myoface {

PatientView::PatientView(FaceView& leader, QWidget* parent)
    : QWidget(parent, Qt::Window), m_leader(leader) {
    setWindowTitle(tr("Myoface — patient"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    m_view = new FaceView;
    m_view->setAttribute(Qt::WA_TransparentForMouseEvents);  // the surgeon has the mouse
    m_view->setFocusPolicy(Qt::NoFocus);
    layout->addWidget(m_view);
    connect(&leader, &FaceView::cameraMoved, this, &PatientView::follow);
}

void PatientView::follow() {
    m_view->setCamera(m_leader.camera());
}

void PatientView::present() {
    const QScreen* own = m_leader.window()->screen();
    QScreen* other = nullptr;
    for (QScreen* screen : QGuiApplication::screens()) {
        if (screen != own) {
            other = screen;
        }
    }
    if (other != nullptr) {
        setGeometry(other->geometry());
    }
    showFullScreen();
    follow();
}

void PatientView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape || event->key() == Qt::Key_F11) {
        close();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void PatientView::closeEvent(QCloseEvent* event) {
    QWidget::closeEvent(event);
    Q_EMIT closed();
}

}  // namespace myoface
