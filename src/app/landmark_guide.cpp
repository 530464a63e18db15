// SPDX-License-Identifier: Apache-2.0
#include "landmark_guide.h"

#include <QHBoxLayout>

namespace myoface {

LandmarkGuide::LandmarkGuide(QWidget* parent)
    : QWidget(parent), m_names{"prn",  "sn",   "ls",   "sto",  "li",   "pg",  "en_l",
                               "en_r", "ex_l", "ex_r", "ch_l", "ch_r", "t_l", "t_r"} {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 8, 14, 8);
    m_question = new QLabel;
    m_question->setTextFormat(Qt::RichText);
    m_back = new QPushButton(tr("Back"));
    layout->addWidget(m_question, 1);
    layout->addWidget(m_back);
    setAutoFillBackground(true);
    QPalette p = palette();
    p.setColor(QPalette::Window, QColor(47, 102, 144));
    p.setColor(QPalette::WindowText, Qt::white);
    setPalette(p);
    connect(m_back, &QPushButton::clicked, this, &LandmarkGuide::stepBack);
    hide();
}

void LandmarkGuide::begin() {
    m_placed.clear();
    m_next = 0;
    m_active = true;
    ask();
    show();
}

void LandmarkGuide::place(const Vec3& point) {
    if (!m_active) {
        return;
    }
    m_placed[m_names[m_next]] = {point, 2.0};
    ++m_next;
    Q_EMIT changed();
    if (m_next == m_names.size()) {
        m_active = false;
        hide();
        Q_EMIT completed();
        return;
    }
    ask();
}

void LandmarkGuide::stepBack() {
    if (m_next > 0) {
        --m_next;
        m_placed.erase(m_names[m_next]);
        Q_EMIT changed();
    }
    ask();
}

void LandmarkGuide::ask() {
    static const std::map<std::string, const char*> kQuestions{
        {"prn", QT_TR_NOOP("the tip of the nose")},
        {"sn", QT_TR_NOOP("the base of the nose, where it meets the upper lip")},
        {"ls", QT_TR_NOOP("the upper lip's border in the middle")},
        {"sto", QT_TR_NOOP("the middle of the line between the lips")},
        {"li", QT_TR_NOOP("the lower lip's border in the middle")},
        {"pg", QT_TR_NOOP("the foremost point of the chin")},
        {"en_l", QT_TR_NOOP("the inner corner of the patient's left eye")},
        {"en_r", QT_TR_NOOP("the inner corner of the patient's right eye")},
        {"ex_l", QT_TR_NOOP("the outer corner of the patient's left eye")},
        {"ex_r", QT_TR_NOOP("the outer corner of the patient's right eye")},
        {"ch_l", QT_TR_NOOP("the patient's left mouth corner")},
        {"ch_r", QT_TR_NOOP("the patient's right mouth corner")},
        {"t_l", QT_TR_NOOP("the notch in front of the patient's left ear")},
        {"t_r", QT_TR_NOOP("the notch in front of the patient's right ear")}};
    m_question->setText(tr("Point %1 of %2: click <b>%3</b>")
                            .arg(m_next + 1)
                            .arg(m_names.size())
                            .arg(tr(kQuestions.at(m_names[m_next]))));
    m_back->setEnabled(m_next > 0);
}

}  // namespace myoface
