// SPDX-License-Identifier: Apache-2.0
#include "scan_panel.h"

#include <cmath>

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "language.h"
#include "panel_layout.h"
#include "theme.h"

namespace myoface {
namespace {

QLabel* wrappedLabel() {
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return label;
}

/// Where the file's axes point, in words.
QString axesInWords(const std::string& axes) {
    const auto word = [](char sign, char axis) {
        const bool plus = sign == '+';
        switch (axis) {
            case 'x':
                return plus ? ScanPanel::tr("left") : ScanPanel::tr("right");
            case 'y':
                return plus ? ScanPanel::tr("up") : ScanPanel::tr("down");
            default:
                return plus ? ScanPanel::tr("front") : ScanPanel::tr("back");
        }
    };
    return QStringLiteral("x %1, y %2, z %3")
        .arg(word(axes[0], axes[1]), word(axes[2], axes[3]), word(axes[4], axes[5]));
}

}  // namespace

ScanPanel::ScanPanel(QWidget* parent) : QWidget(parent) {
    QVBoxLayout* layout = scrollingColumn(*this);
    m_text = wrappedLabel();
    m_text->setText(tr("No face is open."));
    layout->addWidget(m_text);
    buildFrameControls();
    layout->addWidget(m_frame);
    m_looseParts = new QCheckBox;
    m_looseParts->setToolTip(
        tr("Parts that do not hang together with the face: eyeballs, lashes, hair, scraps"));
    connect(m_looseParts, &QCheckBox::toggled, this, &ScanPanel::loosePartsEdited);
    m_looseParts->hide();
    layout->addWidget(m_looseParts);
    m_notes = wrappedLabel();
    layout->addWidget(m_notes);
    layout->addStretch(1);
}

void ScanPanel::buildFrameControls() {
    m_frame = new QWidget;
    auto* form = new QFormLayout(m_frame);
    form->setContentsMargins(0, 0, 0, 0);
    m_unit = new QComboBox;
    m_unit->setToolTip(tr("What one unit of the file is. Files do not say it."));
    connect(m_unit, qOverload<int>(&QComboBox::activated), this,
            [this](int row) { Q_EMIT unitEdited(m_unit->itemData(row).toDouble()); });
    form->addRow(tr("Unit"), m_unit);
    auto* turns = new QHBoxLayout;
    const std::array<std::pair<QString, QString>, 3> names{
        {{tr("Nod"), tr("Turn by a quarter about the axis from ear to ear")},
         {tr("Spin"), tr("Turn by a quarter about the upright axis")},
         {tr("Tilt"), tr("Turn by a quarter about the axis through the nose")}}};
    for (int axis = 0; axis < 3; ++axis) {
        auto* button = new QPushButton(names[static_cast<std::size_t>(axis)].first);
        button->setToolTip(names[static_cast<std::size_t>(axis)].second);
        connect(button, &QPushButton::clicked, this, [this, axis] { Q_EMIT turnAsked(axis); });
        turns->addWidget(button);
    }
    form->addRow(tr("Turn"), turns);
    auto* calibrate = new QPushButton(tr("Calibrate by a known distance…"));
    calibrate->setToolTip(
        tr("Click two points whose distance you know: a ruler in the scan, the width of the iris "
           "(about 11.7 mm), a measured width of the face."));
    connect(calibrate, &QPushButton::clicked, this, &ScanPanel::calibrationAsked);
    form->addRow(calibrate);
    m_frameText = wrappedLabel();
    form->addRow(m_frameText);
    m_frame->hide();
}

void ScanPanel::setFace(const OpenedFace& face, const FaceModel* model, int springs) {
    const MeshReadReport& r = face.report;
    const QLocale locale;
    QString text = QStringLiteral("<table cellspacing=3>");
    const auto row = [&](const QString& name, const QString& value) {
        text += QStringLiteral("<tr><td style='color:%3'>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
                    .arg(name, value.toHtmlEscaped(), themeColours().quiet.name());
    };
    row(tr("File"), QString::fromStdString(face.name));
    row(tr("Format"), QString::fromStdString(r.format));
    row(tr("Vertices"), locale.toString(r.vertices));
    row(tr("Faces"), locale.toString(r.faces));
    row(tr("Size"), tr("%1 × %2 × %3 mm")
                        .arg(r.size_mm.x(), 0, 'f', 0)
                        .arg(r.size_mm.y(), 0, 'f', 0)
                        .arg(r.size_mm.z(), 0, 'f', 0));
    row(tr("Colour"), face.texture    ? QString::fromStdString(r.texture)
                      : r.has_colours ? tr("per vertex")
                                      : tr("none"));
    row(tr("Openings"), r.findings.holes == 0 ? tr("none")
                                              : tr("%1, the longest %2 mm around")
                                                    .arg(r.findings.holes)
                                                    .arg(r.longest_hole_mm, 0, 'f', 0));
    if (model != nullptr) {
        row(tr("Landmarks"), locale.toString(static_cast<int>(model->landmarks.size())));
        row(tr("Muscles"), locale.toString(static_cast<int>(model->muscles.size())));
        row(tr("Springs"), locale.toString(springs));
    }
    m_text->setText(text + QStringLiteral("</table>"));

    const QSignalBlocker quiet(m_unit);
    m_unit->clear();
    const std::array<std::pair<QString, double>, 5> units{{{tr("millimetre"), 1.0},
                                                           {tr("centimetre"), 10.0},
                                                           {tr("decimetre"), 100.0},
                                                           {tr("metre"), 1000.0},
                                                           {tr("inch"), 25.4}}};
    int current = -1;
    for (const auto& [name, mm] : units) {
        current = std::abs(mm / r.mm_per_unit - 1.0) < 1e-9 ? m_unit->count() : current;
        m_unit->addItem(name, mm);
    }
    if (current < 0) {
        current = m_unit->count();
        m_unit->addItem(tr("%1 mm").arg(r.mm_per_unit, 0, 'g', 5), r.mm_per_unit);
    }
    m_unit->setCurrentIndex(current);
    QString how = tr("The file's axes: %1.").arg(axesInWords(r.axes));
    if (r.unit_is_guess && !r.axes_are_guess && r.frame_confidence == 1.0) {
        how += QStringLiteral(" ") + tr("The unit follows from the landmarks.");
    } else if (r.unit_is_guess || r.axes_are_guess) {
        how += QStringLiteral(" ") + tr("Found by the shape of the face, %1 % sure.")
                                         .arg(std::lround(100.0 * r.frame_confidence));
    }
    m_frameText->setText(how);
    m_frame->setVisible(!face.scan_bytes.empty());

    const auto loose = static_cast<int>(r.findings.parts.size()) - 1;
    {
        const QSignalBlocker silent(m_looseParts);
        m_looseParts->setChecked(true);
    }
    m_looseParts->setText(tr("Show the loose parts (%1)").arg(loose));
    m_looseParts->setVisible(loose > 0);

    QString notes;
    for (const std::string& note : r.notes) {
        notes += QStringLiteral("<p>%1</p>").arg(inWords(note).toHtmlEscaped());
    }
    m_notes->setText(notes);
}

}  // namespace myoface
