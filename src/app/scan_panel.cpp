// SPDX-License-Identifier: Apache-2.0
#include "scan_panel.h"

#include <QLocale>
#include <QVBoxLayout>

namespace myoface {

ScanPanel::ScanPanel(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 8, 12, 8);
    m_text = new QLabel(tr("No face is open."));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::RichText);
    m_text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    layout->addWidget(m_text);
    layout->addStretch(1);
}

void ScanPanel::setFace(const OpenedFace& face, const FaceModel* model, int springs) {
    const MeshReadReport& r = face.report;
    const QLocale locale;
    QString text = QStringLiteral("<table cellspacing=3>");
    const auto row = [&](const QString& name, const QString& value) {
        text += QStringLiteral("<tr><td style='color:#9fb3c4'>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
                    .arg(name, value.toHtmlEscaped());
    };
    row(tr("File"), QString::fromStdString(face.name));
    row(tr("Vertices"), locale.toString(r.vertices));
    row(tr("Faces"), locale.toString(r.faces));
    row(tr("Size"), tr("%1 × %2 × %3 mm")
                        .arg(r.size_mm.x(), 0, 'f', 0)
                        .arg(r.size_mm.y(), 0, 'f', 0)
                        .arg(r.size_mm.z(), 0, 'f', 0));
    row(tr("Unit"), r.unit == "other" ? tr("%1 mm each").arg(r.mm_per_unit, 0, 'g', 5)
                                      : QString::fromStdString(r.unit));
    row(tr("Colour"), face.texture    ? QString::fromStdString(r.texture)
                      : r.has_colours ? tr("per vertex")
                                      : tr("none"));
    if (model != nullptr) {
        row(tr("Landmarks"), locale.toString(static_cast<int>(model->landmarks.size())));
        row(tr("Muscles"), locale.toString(static_cast<int>(model->muscles.size())));
        row(tr("Springs"), locale.toString(springs));
    }
    text += QStringLiteral("</table>");
    for (const std::string& note : r.notes) {
        text += QStringLiteral("<p>%1</p>").arg(QString::fromStdString(note).toHtmlEscaped());
    }
    m_text->setText(text);
}

}  // namespace myoface
