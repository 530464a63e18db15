// SPDX-License-Identifier: Apache-2.0
#include "muscle_panel.h"

#include <array>
#include <cmath>

#include <QEvent>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QWheelEvent>

#include "myoface/muscle/expression.h"

namespace myoface {
namespace {

/// A slider that a double click sets back to rest.
class RestingSlider final : public QSlider {
public:
    RestingSlider() : QSlider(Qt::Horizontal) {
        setRange(-50, 100);
        setSingleStep(1);
        setPageStep(10);
    }

protected:
    void mouseDoubleClickEvent(QMouseEvent*) override { setValue(0); }
    void wheelEvent(QWheelEvent* event) override {
        if (hasFocus()) {  // else scrolling the list would move muscles
            QSlider::wheelEvent(event);
        } else {
            event->ignore();
        }
    }
};

}  // namespace

MusclePanel::MusclePanel(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 8, 6, 8);
    auto* top = new QHBoxLayout;
    m_linked = new QCheckBox(tr("Both sides together"));
    m_linked->setChecked(true);
    auto* rest = new QPushButton(tr("All at rest"));
    rest->setToolTip(tr("Sets every muscle back to rest"));
    top->addWidget(m_linked);
    top->addStretch(1);
    top->addWidget(rest);
    layout->addLayout(top);
    auto* expression = new QHBoxLayout;
    m_expression = new QComboBox;
    m_expression->setAccessibleName(tr("Expression"));
    m_expression->addItem(tr("Expression …"));
    for (const Expression& preset : expression_presets()) {
        m_expression->addItem(
            QString::fromStdString(QLocale().language() == QLocale::Japanese ? preset.title_ja
                                                                             : preset.title),
            QString::fromStdString(preset.name));
    }
    m_intensity = new QSlider(Qt::Horizontal);
    m_intensity->setRange(0, 100);
    m_intensity->setValue(80);
    m_intensity->setAccessibleName(tr("Intensity of the expression"));
    m_intensity->setToolTip(tr("Intensity of the expression"));
    expression->addWidget(m_expression, 1);
    expression->addWidget(m_intensity, 1);
    layout->addLayout(expression);
    connect(m_expression, QOverload<int>::of(&QComboBox::activated), this, [this] {
        ++m_gesture;
        chooseExpression();
    });
    connect(m_intensity, &QSlider::sliderPressed, this, [this] { ++m_gesture; });
    connect(m_intensity, &QSlider::valueChanged, this, &MusclePanel::chooseExpression);
    m_filter = new QLineEdit;
    m_filter->setPlaceholderText(tr("Find a muscle or action unit"));
    m_filter->setClearButtonEnabled(true);
    layout->addWidget(m_filter);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list = new QWidget;
    m_listLayout = new QVBoxLayout(m_list);
    m_listLayout->setContentsMargins(0, 0, 8, 0);
    m_listLayout->setSpacing(2);
    m_listLayout->setSizeConstraint(QLayout::SetMinimumSize);  // rows are never squeezed
    scroll->setWidget(m_list);
    layout->addWidget(scroll, 1);
    connect(m_linked, &QCheckBox::toggled, this, &MusclePanel::applyLink);
    connect(m_filter, &QLineEdit::textChanged, this, &MusclePanel::applyFilter);
    connect(rest, &QPushButton::clicked, this, &MusclePanel::resetRequested);
}

void MusclePanel::setMuscles(const std::vector<Muscle>& muscles) {
    m_rows.clear();
    m_rows.resize(muscles.size());
    while (QLayoutItem* item = m_listLayout->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    struct Group {
        const char* key;
        QString title;
    };
    const std::array<Group, 7> groups{{{"brow", tr("Forehead and brow")},
                                       {"eye", tr("Eyes")},
                                       {"nose", tr("Nose")},
                                       {"mouth", tr("Mouth and cheek")},
                                       {"chin", tr("Chin")},
                                       {"neck", tr("Neck")},
                                       {"jaw", tr("Jaw and chewing")}}};
    for (const Group& group : groups) {
        auto* box = new QGroupBox(group.title);
        auto* inside = new QVBoxLayout(box);
        inside->setContentsMargins(0, 4, 0, 4);
        inside->setSpacing(2);
        for (std::size_t m = 0; m < muscles.size(); ++m) {
            if (muscles[m].traits.group == group.key) {
                addRow(inside, muscles, static_cast<int>(m));
            }
        }
        m_listLayout->addWidget(box);
    }
    m_listLayout->addStretch(1);
    applyLink();
}

void MusclePanel::chooseExpression() {
    const std::string name = m_expression->currentData().toString().toStdString();
    if (!name.empty()) {
        Q_EMIT expressionChosen(name, m_intensity->value() / 100.0, m_gesture);
    }
}

void MusclePanel::addRow(QVBoxLayout* into, const std::vector<Muscle>& muscles, int muscle) {
    const MuscleTraits& traits = muscles[static_cast<std::size_t>(muscle)].traits;
    Row& row = m_rows[static_cast<std::size_t>(muscle)];
    row.muscle = muscle;
    row.title = QString::fromStdString(QLocale().language() == QLocale::Japanese ? traits.title_ja
                                                                                 : traits.title);
    row.right = traits.side == Side::Right;
    if (traits.side == Side::Left) {
        row.other = muscle + 1;  // the atlas lists left and right next to each other
    } else if (row.right) {
        row.other = muscle - 1;
    }
    row.widget = new QWidget;
    auto* layout = new QVBoxLayout(row.widget);
    layout->setContentsMargins(2, 1, 2, 3);
    layout->setSpacing(0);
    auto* line = new QHBoxLayout;
    row.label = new QLabel;
    const bool japanese = QLocale().language() == QLocale::Japanese;
    row.label->setToolTip(QString::fromStdString(traits.name + " · " + traits.action_unit + "\n" +
                                                 traits.latin + "\n" +
                                                 (japanese ? traits.does_ja : traits.does) + "\n" +
                                                 (japanese ? traits.note_ja : traits.note)));
    row.value = new QLabel;
    row.value->setMinimumWidth(44);
    row.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    line->addWidget(row.label, 1);
    line->addWidget(row.value);
    layout->addLayout(line);
    row.slider = new RestingSlider;
    row.slider->setObjectName(QString::fromStdString(traits.name));
    row.slider->setAccessibleName(QString::fromStdString(traits.name));
    row.slider->setToolTip(tr("Contraction; double click: at rest"));
    layout->addWidget(row.slider);
    into->addWidget(row.widget);
    connect(row.slider, &QSlider::sliderPressed, this, [this] { ++m_gesture; });
    connect(row.slider, &QSlider::valueChanged, this, [this, muscle](int value) {
        Row& edited = m_rows[static_cast<std::size_t>(muscle)];
        if (!edited.slider->isSliderDown()) {
            ++m_gesture;  // keys and clicks are steps of their own
        }
        std::vector<int> which{muscle};
        if (m_linked->isChecked() && edited.other >= 0) {
            which.push_back(edited.other);
        }
        showValue(edited);
        Q_EMIT ratesEdited(which, value / 100.0, m_gesture, edited.title);
    });
    showValue(row);
}

void MusclePanel::showValue(Row& row) {
    const int value = row.slider->value();
    row.value->setText(tr("%1 %").arg(value));
    row.value->setEnabled(value != 0);
}

void MusclePanel::setRate(int muscle, double rate) {
    Row& row = m_rows[static_cast<std::size_t>(muscle)];
    if (row.slider == nullptr) {
        return;
    }
    const QSignalBlocker blocker(row.slider);
    row.slider->setValue(static_cast<int>(std::lround(100.0 * rate)));
    showValue(row);
}

QSlider* MusclePanel::slider(int muscle) const {
    return m_rows[static_cast<std::size_t>(muscle)].slider;
}

void MusclePanel::applyLink() {
    for (Row& row : m_rows) {
        if (row.label == nullptr) {
            continue;
        }
        const bool paired = row.other >= 0;
        const bool apart = paired && !m_linked->isChecked();
        row.label->setText(!apart      ? row.title
                           : row.right ? tr("%1, right").arg(row.title)
                                       : tr("%1, left").arg(row.title));
    }
    applyFilter(m_filter->text());
}

void MusclePanel::applyFilter(const QString& text) {
    for (Row& row : m_rows) {
        if (row.widget == nullptr) {
            continue;
        }
        const bool found = text.isEmpty() || row.title.contains(text, Qt::CaseInsensitive) ||
                           row.label->toolTip().contains(text, Qt::CaseInsensitive);
        row.widget->setVisible(found && !(row.right && m_linked->isChecked()));
    }
}

}  // namespace myoface
