// SPDX-License-Identifier: Apache-2.0
#include "muscle_panel.h"

#include <array>
#include <cmath>

#include <QEvent>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSignalBlocker>
#include <QWheelEvent>
#include <QWidgetAction>

#include "myoface/muscle/user_expressions.h"
#include "myoface/muscle/weakening.h"
#include "myoface/muscle/wrinkle.h"

#include "language.h"

namespace myoface {
namespace {

constexpr int kOwnPreset = Qt::UserRole + 1;  // its name, of presets of the user's own

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
    layout->addLayout(expressionRow());
    layout->addLayout(weakeningRow());
    layout->addLayout(skinAgeRow());
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

QLayout* MusclePanel::expressionRow() {
    auto* grid = new QGridLayout;
    m_expression = new QComboBox;
    m_expression->setObjectName(QStringLiteral("expression"));
    m_expression->setAccessibleName(tr("Expression"));
    m_expression->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_intensity = new QSlider(Qt::Horizontal);
    m_intensity->setRange(0, 100);
    m_intensity->setValue(80);
    m_intensity->setAccessibleName(tr("Intensity of the expression"));
    m_intensity->setToolTip(tr("Intensity of the expression"));
    m_balance = new QSlider(Qt::Horizontal);
    m_balance->setRange(-100, 100);
    m_balance->setAccessibleName(tr("Balance of the sides"));
    m_balance->setToolTip(
        tr("Balance of the sides: to the left, the patient's right side does "
           "more; to the right, the left side"));
    grid->addWidget(m_expression, 0, 0);
    grid->addLayout(intensityRow(), 0, 1);
    grid->addLayout(presetRow(), 1, 0);
    grid->addWidget(m_balance, 1, 1);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    listExpressions();
    connect(m_expression, QOverload<int>::of(&QComboBox::activated), this, [this] {
        ++m_gesture;
        m_remove->setEnabled(!m_expression->currentData(kOwnPreset).toString().isEmpty());
        chooseExpression(true);
    });
    for (QSlider* slider : {m_intensity, m_balance}) {
        connect(slider, &QSlider::sliderPressed, this, [this] { ++m_gesture; });
        connect(slider, &QSlider::valueChanged, this, [this] {
            showIntensity();
            chooseExpression(false);
        });
    }
    showIntensity();
    return grid;
}

/// The slider with the five letters of the Facial Action Coding System.
QLayout* MusclePanel::intensityRow() {
    auto* column = new QVBoxLayout;
    column->setSpacing(0);
    column->addWidget(m_intensity);
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    for (const char letter : {'A', 'B', 'C', 'D', 'E'}) {
        auto* button = new QToolButton;
        button->setText(QString(QLatin1Char(letter)));
        button->setObjectName(QStringLiteral("intensity") + QLatin1Char(letter));
        button->setAutoRaise(true);
        button->setCheckable(true);
        button->setToolTip(tr("Intensity of the expression: A a trace … E the most"));
        connect(button, &QToolButton::clicked, this, [this, letter] {
            ++m_gesture;
            m_intensity->setValue(static_cast<int>(std::lround(100.0 * intensity_of(letter))));
            showIntensity();
        });
        m_letters.push_back(button);
        row->addWidget(button, 1);
    }
    column->addLayout(row);
    return column;
}

void MusclePanel::showIntensity() {
    const QLatin1Char letter(intensity_letter(m_intensity->value() / 100.0));
    for (QToolButton* button : m_letters) {
        button->setChecked(button->text() == QString(letter));
    }
}

/// How presets are used, and the user's own.
QLayout* MusclePanel::presetRow() {
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    m_blend = new QCheckBox(tr("Add"));
    m_blend->setObjectName(QStringLiteral("blend"));
    m_blend->setToolTip(tr("A preset adds to what the muscles do, instead of taking its place"));
    m_glide = new QCheckBox(tr("Glide"));
    m_glide->setObjectName(QStringLiteral("glide"));
    m_glide->setToolTip(tr("A preset is reached by and by, within 0.4 seconds"));
    m_glide->setChecked(QSettings().value(QStringLiteral("glide"), true).toBool());
    connect(m_glide, &QCheckBox::toggled, this,
            [](bool on) { QSettings().setValue(QStringLiteral("glide"), on); });
    m_save = new QToolButton;
    m_save->setText(tr("Save…"));
    m_save->setObjectName(QStringLiteral("savePreset"));
    m_save->setToolTip(tr("Keeps what the sliders show as a preset of your own"));
    m_remove = new QToolButton;
    m_remove->setText(tr("Remove"));
    m_remove->setObjectName(QStringLiteral("removePreset"));
    m_remove->setToolTip(tr("Removes this preset of your own"));
    m_remove->setEnabled(false);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_blend, m_glide, m_save, m_remove}) {
        row->addWidget(widget);
    }
    row->addStretch(1);
    connect(m_save, &QToolButton::clicked, this, &MusclePanel::savePreset);
    connect(m_remove, &QToolButton::clicked, this, [this] {
        Q_EMIT expressionRemoveAsked(m_expression->currentData(kOwnPreset).toString());
    });
    return row;
}

void MusclePanel::savePreset() {
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("Keep a preset"), tr("Name of the preset:"),
                                               QLineEdit::Normal, {}, &accepted)
                             .trimmed();
    if (accepted && !name.isEmpty()) {
        Q_EMIT expressionSaveAsked(name);
    }
}

void MusclePanel::listExpressions(const QString& chosen) {
    m_expression->clear();
    m_expression->addItem(tr("Expression …"));
    for (const Expression& preset : expression_presets()) {
        m_expression->addItem(inWords(preset.title), QString::fromStdString(preset.name));
    }
    const std::vector<Expression> own = user_expressions();
    if (!own.empty()) {
        m_expression->insertSeparator(m_expression->count());
    }
    for (const Expression& preset : own) {
        const QString name = QString::fromStdString(preset.name);
        m_expression->addItem(name, name);
        m_expression->setItemData(m_expression->count() - 1, name, kOwnPreset);
    }
    const int at = chosen.isEmpty() ? 0 : std::max(0, m_expression->findData(chosen));
    m_expression->setCurrentIndex(at);
    m_remove->setEnabled(!m_expression->currentData(kOwnPreset).toString().isEmpty());
}

QLayout* MusclePanel::weakeningRow() {
    auto* row = new QHBoxLayout;
    m_weakening = new QComboBox;
    m_weakening->setObjectName(QStringLiteral("weakening"));
    m_weakening->setAccessibleName(tr("Weak muscles"));
    m_weakening->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_weakening->setToolTip(
        tr("Muscles weakened by toxin or palsy: they do less of every "
           "expression"));
    m_weakening->addItem(tr("All muscles at full strength"));
    for (const Weakening& preset : weakening_presets()) {
        m_weakening->addItem(inWords(preset.title), QString::fromStdString(preset.name));
    }
    m_weakSide = new QComboBox;
    m_weakSide->setAccessibleName(tr("Side"));
    m_weakSide->addItems({tr("both sides"), tr("left"), tr("right")});
    m_untreated = new QToolButton;
    m_untreated->setObjectName(QStringLiteral("untreated"));
    m_untreated->setText(tr("Beside untreated"));
    m_untreated->setToolTip(
        tr("Shows the same expression with all muscles at full strength beside this one"));
    m_untreated->setCheckable(true);
    connect(m_untreated, &QToolButton::clicked, this, &MusclePanel::untreatedAsked);
    row->addWidget(m_weakening, 1);
    row->addWidget(m_weakSide);
    row->addWidget(m_untreated);
    connect(m_weakening, QOverload<int>::of(&QComboBox::activated), this,
            &MusclePanel::chooseWeakening);
    connect(m_weakSide, QOverload<int>::of(&QComboBox::activated), this,
            &MusclePanel::chooseWeakening);
    return row;
}

QLayout* MusclePanel::skinAgeRow() {
    auto* row = new QHBoxLayout;
    m_skinAge = new QSlider(Qt::Horizontal);
    m_skinAge->setObjectName(QStringLiteral("skinAge"));
    m_skinAge->setRange(static_cast<int>(kYoungestSkin), static_cast<int>(kOldestSkin));
    m_skinAge->setAccessibleName(tr("Age of the skin"));
    m_skinAge->setToolTip(tr("Age of the skin: how deep expressions wrinkle it"));
    m_skinAgeWords = new QLabel;
    m_skinAgeWords->setMinimumWidth(64);
    m_skinAgeWords->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(new QLabel(tr("Wrinkles")));
    row->addWidget(m_skinAge, 1);
    row->addWidget(m_skinAgeWords);
    connect(m_skinAge, &QSlider::sliderPressed, this, [this] { ++m_gesture; });
    connect(m_skinAge, &QSlider::valueChanged, this, [this](int years) {
        if (!m_skinAge->isSliderDown()) {
            ++m_gesture;
        }
        m_skinAgeWords->setText(tr("%1 years").arg(years));
        Q_EMIT skinAgeEdited(years, m_gesture);
    });
    setSkinAge(kUsualSkin);
    return row;
}

void MusclePanel::setUntreated(bool beside) {
    m_untreated->setChecked(beside);
}

void MusclePanel::setSkinAge(double years) {
    const QSignalBlocker blocker(m_skinAge);
    m_skinAge->setValue(static_cast<int>(std::lround(years)));
    m_skinAgeWords->setText(tr("%1 years").arg(m_skinAge->value()));
}

void MusclePanel::chooseWeakening() {
    const int side = m_weakSide->currentIndex();
    Q_EMIT weakeningChosen(m_weakening->currentData().toString().toStdString(), side != 2,
                           side != 1);
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

void MusclePanel::chooseExpression(bool fresh) {
    const std::string name = m_expression->currentData().toString().toStdString();
    if (!name.empty()) {
        const double whole = m_intensity->value() / 100.0;
        const double balance = m_balance->value() / 100.0;
        Q_EMIT expressionChosen(name, whole * std::min(1.0, 1.0 + balance),
                                whole * std::min(1.0, 1.0 - balance), m_gesture, fresh);
    }
}

void MusclePanel::addRow(QVBoxLayout* into, const std::vector<Muscle>& muscles, int muscle) {
    const MuscleTraits& traits = muscles[static_cast<std::size_t>(muscle)].traits;
    Row& row = m_rows[static_cast<std::size_t>(muscle)];
    row.muscle = muscle;
    row.title =
        QString::fromStdString(Language::instance().japanese() ? traits.title_ja : traits.title);
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
    const bool japanese = Language::instance().japanese();
    row.label->setToolTip(QString::fromStdString(traits.name + " · " + traits.action_unit + "\n" +
                                                 traits.latin + "\n" +
                                                 (japanese ? traits.does_ja : traits.does) + "\n" +
                                                 (japanese ? traits.note_ja : traits.note)));
    row.value = new QLabel;
    row.value->setMinimumWidth(44);
    row.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.strength = new QToolButton;
    row.strength->setAutoRaise(true);
    row.strength->setObjectName(QString::fromStdString(traits.name) + QStringLiteral(".strength"));
    row.strength->setToolTip(tr("Strength: how much of its contraction the muscle can do"));
    row.strength->setAccessibleName(tr("Strength"));
    connect(row.strength, &QToolButton::clicked, this, [this, muscle] { editStrength(muscle); });
    line->addWidget(row.label, 1);
    line->addWidget(row.strength);
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
    const bool weak = row.share < 0.995;
    row.strength->setText(weak ? tr("%1 % strong").arg(std::lround(100.0 * row.share))
                               : QStringLiteral("⋯"));
}

/// A slider that comes up beside the row.
void MusclePanel::editStrength(int muscle) {
    Row& row = m_rows[static_cast<std::size_t>(muscle)];
    QMenu menu(this);
    auto* content = new QWidget;
    auto* line = new QHBoxLayout(content);
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setRange(0, 100);
    slider->setValue(static_cast<int>(std::lround(100.0 * row.share)));
    slider->setMinimumWidth(180);
    slider->setAccessibleName(tr("Strength"));
    line->addWidget(new QLabel(tr("Strength")));
    line->addWidget(slider);
    auto* action = new QWidgetAction(&menu);
    action->setDefaultWidget(content);
    menu.addAction(action);
    const int gesture = ++m_gesture;
    connect(slider, &QSlider::valueChanged, this, [&, gesture](int value) {
        std::vector<int> which{row.muscle};
        if (m_linked->isChecked() && row.other >= 0) {
            which.push_back(row.other);
        }
        Q_EMIT strengthsEdited(which, value / 100.0, gesture, row.title);
    });
    menu.exec(row.strength->mapToGlobal(QPoint(0, row.strength->height())));
}

void MusclePanel::setStrength(int muscle, double strength) {
    Row& row = m_rows[static_cast<std::size_t>(muscle)];
    if (row.slider != nullptr) {
        row.share = strength;
        showValue(row);
    }
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
