// SPDX-License-Identifier: Apache-2.0
#include "shape_panel.h"

#include <cmath>

#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "language.h"
#include "panel_layout.h"

namespace myoface {
namespace {

QDoubleSpinBox* number(double low, double high, double value, int decimals, const QString& unit) {
    auto* box = new QDoubleSpinBox;
    box->setRange(low, high);
    box->setDecimals(decimals);
    box->setSingleStep(std::pow(10.0, -std::min(decimals, 1)));
    box->setValue(value);
    box->setSuffix(unit);
    return box;
}

}  // namespace

ShapePanel::ShapePanel(QWidget* parent) : QWidget(parent), m_measures(all_measures()) {
    QVBoxLayout* column = scrollingColumn(*this);
    column->addWidget(gripGroup());
    column->addWidget(numbersGroup());
    column->addWidget(targetGroup());
    m_words = new QLabel;
    m_words->setObjectName(QStringLiteral("words"));
    m_words->setWordWrap(true);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_words);
    column->addStretch(1);
}

QWidget* ShapePanel::gripGroup() {
    auto* group = new QGroupBox(tr("Hand"));
    auto* form = new QFormLayout(group);
    m_byRegion = new QCheckBox(tr("by region"));
    m_byRegion->setChecked(true);
    m_byRegion->setToolTip(tr("As broad as suits the region and the depth of the tissue"));
    m_radius = number(2.0, 60.0, 12.0, 0, tr(" mm"));
    m_radius->setEnabled(false);
    m_radius->setAccessibleName(tr("Radius of the grip"));
    m_radius->setToolTip(
        tr("Radius of the grip; F and a move of the mouse changes it on the face"));
    auto* radius = new QHBoxLayout;
    radius->addWidget(m_radius, 1);
    radius->addWidget(m_byRegion);
    form->addRow(tr("Radius"), radius);
    m_path = new QComboBox;
    m_path->addItems(
        {tr("anywhere"), tr("in and out of the skin"), tr("in the midplane's direction")});
    m_path->setToolTip(tr("Where the grabbed point may go"));
    form->addRow(tr("Way"), m_path);
    m_mirror = new QCheckBox(tr("Same on the other side (X)"));
    form->addRow(m_mirror);
    m_kernel = new QCheckBox(tr("Show how far the grip reaches"));
    m_kernel->setToolTip(tr(
        "Paints the stress kernel of the place under the cursor: further along the same muscle"));
    form->addRow(m_kernel);
    m_erase = new QCheckBox(tr("Protect tool erases"));
    auto* clear = new QPushButton(tr("Protect nothing"));
    auto* protect = new QHBoxLayout;
    protect->addWidget(m_erase, 1);
    protect->addWidget(clear);
    form->addRow(protect);
    connect(m_byRegion, &QCheckBox::toggled, this, [this](bool on) {
        m_radius->setEnabled(!on);
        Q_EMIT optionsEdited();
    });
    connect(m_radius, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &ShapePanel::optionsEdited);
    connect(m_mirror, &QCheckBox::toggled, this, &ShapePanel::optionsEdited);
    connect(m_kernel, &QCheckBox::toggled, this, &ShapePanel::optionsEdited);
    connect(m_path, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            &ShapePanel::optionsEdited);
    connect(clear, &QPushButton::clicked, this, &ShapePanel::clearProtectionAsked);
    return group;
}

QWidget* ShapePanel::numbersGroup() {
    auto* group = new QGroupBox(tr("By numbers"));
    auto* form = new QFormLayout(group);
    m_right = number(-30.0, 30.0, 0.0, 1, tr(" mm"));
    m_up = number(-30.0, 30.0, 1.0, 1, tr(" mm"));
    m_right->setAccessibleName(tr("To the right"));
    m_up->setAccessibleName(tr("Up"));
    auto* move = new QPushButton(tr("Move"));
    move->setToolTip(
        tr("Moves the point gripped last, in the plane of the picture; arrow keys: "
           "0.1 mm, with Shift 1 mm"));
    auto* way = new QHBoxLayout;
    way->addWidget(m_right, 1);
    way->addWidget(m_up, 1);
    way->addWidget(move);
    form->addRow(tr("Right, up"), way);
    m_millilitres = number(-10.0, 10.0, 0.5, 2, tr(" mL"));
    m_millilitres->setSingleStep(0.1);
    m_millilitres->setAccessibleName(tr("Volume"));
    m_millilitres->setToolTip(
        tr("What a click with the Volume tool adds, or takes away below zero"));
    form->addRow(tr("Volume"), m_millilitres);
    connect(move, &QPushButton::clicked, this,
            [this] { Q_EMIT moveAsked(m_right->value(), m_up->value()); });
    return group;
}

QWidget* ShapePanel::targetGroup() {
    auto* group = new QGroupBox(tr("Until a measure is"));
    auto* form = new QFormLayout(group);
    m_measure = new QComboBox;
    for (const Measure& measure : m_measures) {
        m_measure->addItem(inWords(measure.title));
        if (measure.id == "prn-front") {
            m_measure->setCurrentIndex(m_measure->count() - 1);
        }
    }
    m_measure->setAccessibleName(tr("Measure"));
    m_measure->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_measure->setMinimumContentsLength(14);
    form->addRow(m_measure);
    m_now = new QLabel;
    form->addRow(tr("now"), m_now);
    m_target = number(-50.0, 250.0, 0.0, 1, QString());
    m_target->setAccessibleName(tr("Wanted value"));
    m_target->setObjectName(QStringLiteral("target"));
    auto* meet = new QPushButton(tr("Shape"));
    meet->setObjectName(QStringLiteral("meet"));
    meet->setToolTip(tr("Moves the landmark until the measure is met; tissue follows"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_target, 1);
    row->addWidget(meet);
    form->addRow(tr("wanted"), row);
    connect(m_measure, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
        m_target->clearFocus();
        m_target->setProperty("own", false);
        Q_EMIT optionsEdited();
    });
    connect(m_target, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this] { m_target->setProperty("own", true); });
    connect(meet, &QPushButton::clicked, this, [this] { Q_EMIT targetAsked(m_target->value()); });
    return group;
}

double ShapePanel::radius() const {
    return m_byRegion->isChecked() ? 0.0 : m_radius->value();
}

void ShapePanel::setRadius(double millimetres) {
    m_byRegion->setChecked(false);
    m_radius->setValue(millimetres);
}

void ShapePanel::showMeasure(double before, double value) {
    const bool degrees = measure().in_degrees();
    const QString unit = degrees ? tr("°") : tr(" mm");
    m_target->setSuffix(unit);
    if (!std::isfinite(value)) {
        m_now->setText(tr("unknown: landmarks are missing"));
        return;
    }
    const double change = value - before;
    QString text = locale().toString(value, 'f', 1) + unit;
    if (std::abs(change) >= 0.05) {
        text += tr("  (%1%2 against the scan)")
                    .arg(change > 0.0 ? QStringLiteral("+") : QString(),
                         locale().toString(change, 'f', 1));
    }
    m_now->setText(text);
    if (!m_target->property("own").toBool()) {  // until somebody wants something else
        const QSignalBlocker quiet(m_target);
        m_target->setValue(value);
    }
}

}  // namespace myoface
