// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCheckBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QWidget>

namespace myoface {

/// What goes into a report beside the face.
struct ReportWords {
    QString title, patient, notes, logo;
    bool anonymous = false;  ///< no texture, eyes covered
};

/// Words for the printed report, and everything that can be written to files.
class ReportPanel final : public QWidget {
    Q_OBJECT

public:
    explicit ReportPanel(QWidget* parent = nullptr);

    ReportWords words() const;
    void setNotes(const QString& notes);
    void setWriting(bool writing);

Q_SIGNALS:
    void notesEdited(const QString& notes);
    void reportAsked();
    void pictureAsked();
    void turntableAsked();
    void expressionAsked();
    void faceAsked();
    void caseAsked();

private:
    void chooseLogo();

    QLineEdit *m_title = nullptr, *m_patient = nullptr, *m_logo = nullptr;
    QPlainTextEdit* m_notes = nullptr;
    QCheckBox* m_anonymous = nullptr;
    QPushButton* m_report = nullptr;
};

}  // namespace myoface
