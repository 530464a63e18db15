// SPDX-License-Identifier: Apache-2.0
#include "report_panel.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSettings>
#include <QSignalBlocker>

#include "panel_layout.h"

namespace myoface {
namespace {
const QString kLogoKey = QStringLiteral("report/logo");
const QString kTitleKey = QStringLiteral("report/title");
}  // namespace

ReportPanel::ReportPanel(QWidget* parent) : QWidget(parent) {
    QVBoxLayout* column = scrollingColumn(*this);
    auto* printed = new QGroupBox(tr("Printed report"));
    auto* form = new QFormLayout(printed);
    m_title = new QLineEdit(QSettings().value(kTitleKey).toString());
    m_title->setPlaceholderText(tr("Facial simulation"));
    m_patient = new QLineEdit;
    m_patient->setPlaceholderText(tr("a pseudonym"));
    m_logo = new QLineEdit(QSettings().value(kLogoKey).toString());
    m_logo->setPlaceholderText(tr("none"));
    auto* browse = new QPushButton(tr("Choose…"));
    auto* logo = new QHBoxLayout;
    logo->addWidget(m_logo, 1);
    logo->addWidget(browse);
    form->addRow(tr("Title"), m_title);
    form->addRow(tr("Patient"), m_patient);
    form->addRow(tr("Logo"), logo);
    column->addWidget(printed);
    auto* notes = new QGroupBox(tr("Notes"));
    auto* inside = new QVBoxLayout(notes);
    m_notes = new QPlainTextEdit;
    m_notes->setAccessibleName(tr("Notes"));
    m_notes->setMinimumHeight(90);
    m_notes->setTabChangesFocus(true);
    inside->addWidget(m_notes);
    column->addWidget(notes);
    m_anonymous = new QCheckBox(tr("Anonymous: no skin texture, no name, a bar over the eyes"));
    column->addWidget(m_anonymous);
    m_report = new QPushButton(tr("Write the report (PDF)…"));
    m_report->setObjectName(QStringLiteral("writeReport"));
    column->addWidget(m_report);
    auto* other = new QGroupBox(tr("Other files"));
    auto* files = new QVBoxLayout(other);
    const auto add = [&](const QString& text, const QString& tip, void (ReportPanel::*signal)()) {
        auto* button = new QPushButton(text);
        button->setToolTip(tip);
        files->addWidget(button);
        connect(button, &QPushButton::clicked, this, signal);
    };
    add(tr("Save case…"), tr("Scan, fit, plan, variants and notes in one file"),
        &ReportPanel::caseAsked);
    add(tr("Picture…"), tr("The view as it is, as PNG"), &ReportPanel::pictureAsked);
    add(tr("Head turning…"),
        tr("A film all around the head: PNG pictures in a folder, or GIF or MP4 where ffmpeg or "
           "ImageMagick is installed"),
        &ReportPanel::turntableAsked);
    add(tr("Expression moving…"),
        tr("A film from rest to the face as it is and back: PNG pictures, GIF or MP4"),
        &ReportPanel::expressionAsked);
    add(tr("Face as mesh…"), tr("OBJ, PLY, GLB, or STL for printing; anonymous: STL alone"),
        &ReportPanel::faceAsked);
    column->addWidget(other);
    auto* aid =
        new QLabel(tr("A planning and communication aid, not a medical device: what is "
                      "shown is an estimate, not a promise of a result."));
    aid->setWordWrap(true);
    aid->setEnabled(false);
    column->addWidget(aid);
    column->addStretch(1);
    connect(browse, &QPushButton::clicked, this, &ReportPanel::chooseLogo);
    connect(m_title, &QLineEdit::editingFinished, this,
            [this] { QSettings().setValue(kTitleKey, m_title->text()); });
    connect(m_logo, &QLineEdit::textChanged, this,
            [](const QString& file) { QSettings().setValue(kLogoKey, file); });
    connect(m_notes, &QPlainTextEdit::textChanged, this,
            [this] { Q_EMIT notesEdited(m_notes->toPlainText()); });
    connect(m_report, &QPushButton::clicked, this, &ReportPanel::reportAsked);
}

ReportWords ReportPanel::words() const {
    return {m_title->text(), m_patient->text(), m_notes->toPlainText(), m_logo->text(),
            m_anonymous->isChecked()};
}

void ReportPanel::setNotes(const QString& notes) {
    if (notes != m_notes->toPlainText()) {
        const QSignalBlocker quiet(m_notes);
        m_notes->setPlainText(notes);
    }
}

void ReportPanel::setWriting(bool writing) {
    m_report->setEnabled(!writing);
    m_report->setText(writing ? tr("Writing the report…") : tr("Write the report (PDF)…"));
}

void ReportPanel::chooseLogo() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Logo of the clinic"), {},
                                                      tr("Pictures (*.png *.jpg *.jpeg)"));
    if (!file.isEmpty()) {
        m_logo->setText(file);
    }
}

}  // namespace myoface
