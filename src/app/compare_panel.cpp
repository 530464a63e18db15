// SPDX-License-Identifier: Apache-2.0
#include "compare_panel.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "panel_layout.h"

namespace myoface {

ComparePanel::ComparePanel(QWidget* parent) : QWidget(parent) {
    QVBoxLayout* column = scrollingColumn(*this);
    column->addWidget(viewGroup());
    column->addWidget(variantGroup());
    column->addWidget(actualGroup());
    column->addStretch(1);
}

QWidget* ComparePanel::viewGroup() {
    auto* group = new QGroupBox(tr("Before and after"));
    auto* form = new QFormLayout(group);
    m_reference = new QComboBox;
    m_reference->addItem(tr("the scan as it came"));
    m_reference->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_reference->setMinimumContentsLength(12);
    m_reference->setAccessibleName(tr("Compare with"));
    form->addRow(tr("With"), m_reference);
    const std::pair<QString, QString> modes[] = {
        {tr("Only the face as it is now"), tr("Hold the space bar to see the state before")},
        {tr("Side by side"), tr("Both turn together")},
        {tr("Wipe"), tr("Drag the line across the face")},
        {tr("Ghost"), tr("The state before, translucent over the face")}};
    for (const auto& [title, tip] : modes) {
        auto* button = new QRadioButton(title);
        button->setToolTip(tip);
        form->addRow(button);
        m_modes.push_back(button);
        connect(button, &QRadioButton::toggled, this, [this](bool on) {
            if (on) {
                Q_EMIT edited();
            }
        });
    }
    m_map = new QRadioButton(tr("Map of the change"));
    m_map->setToolTip(tr("Orange where the skin has come out, blue where it has gone in"));
    m_most = new QDoubleSpinBox;
    m_most->setRange(0.5, 50.0);
    m_most->setDecimals(1);
    m_most->setSingleStep(0.5);
    m_most->setValue(5.0);
    m_most->setSuffix(tr(" mm"));
    m_most->setAccessibleName(tr("Millimetres of the last colour"));
    m_most->setToolTip(tr("Millimetres of the last colour"));
    auto* map = new QHBoxLayout;
    map->addWidget(m_map, 1);
    map->addWidget(m_most);
    form->addRow(map);
    m_sides = new QRadioButton(tr("Map of the sides"));
    m_sides->setToolTip(tr(
        "Orange where a side stands out over the mirror image of the other, about this patient's "
        "own midplane, blue where it lies behind it"));
    form->addRow(m_sides);
    m_sidesWords = new QLabel;
    m_sidesWords->setObjectName(QStringLiteral("sides"));
    m_sidesWords->setTextFormat(Qt::RichText);
    m_sidesWords->setWordWrap(true);
    m_sidesWords->hide();
    form->addRow(m_sidesWords);
    m_modes.front()->setChecked(true);
    m_share = new QSlider(Qt::Horizontal);
    m_share->setRange(0, 100);
    m_share->setValue(100);
    m_share->setAccessibleName(tr("Share of the change that is shown"));
    m_share->setToolTip(tr("From before (left) to now (right)"));
    m_shareText = new QLabel(tr("%1 %").arg(100));
    m_shareText->setMinimumWidth(44);
    m_shareText->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* share = new QHBoxLayout;
    share->addWidget(m_share, 1);
    share->addWidget(m_shareText);
    form->addRow(tr("Change"), share);
    connect(m_reference, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this](int row) { Q_EMIT referenceChosen(row - 1); });
    connect(m_map, &QRadioButton::toggled, this, &ComparePanel::edited);
    connect(m_sides, &QRadioButton::toggled, this, &ComparePanel::edited);
    connect(m_most, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &ComparePanel::edited);
    connect(m_share, &QSlider::valueChanged, this, [this](int value) {
        m_shareText->setText(tr("%1 %").arg(value));
        Q_EMIT edited();
    });
    return group;
}

QWidget* ComparePanel::variantGroup() {
    auto* group = new QGroupBox(tr("Variants of the plan"));
    auto* column = new QVBoxLayout(group);
    m_variants = new QListWidget;
    m_variants->setAccessibleName(tr("Variants of the plan"));
    m_variants->setToolTip(tr("Double click shows a variant, F2 renames it"));
    m_variants->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_variants->setMaximumHeight(110);
    column->addWidget(m_variants);
    auto* row = new QHBoxLayout;
    auto* store = new QPushButton(tr("Keep this one"));
    store->setObjectName(QStringLiteral("storeVariant"));
    store->setToolTip(tr("Keeps the face as it is now as variant A, B, C …"));
    m_show = new QPushButton(tr("Show"));
    m_remove = new QPushButton(tr("Remove"));
    for (QPushButton* button : {store, m_show, m_remove}) {
        row->addWidget(button);
    }
    column->addLayout(row);
    connect(store, &QPushButton::clicked, this, &ComparePanel::storeAsked);
    connect(m_show, &QPushButton::clicked, this,
            [this] { Q_EMIT showAsked(m_variants->currentRow()); });
    connect(m_remove, &QPushButton::clicked, this,
            [this] { Q_EMIT removeAsked(m_variants->currentRow()); });
    connect(m_variants, &QListWidget::itemDoubleClicked, this,
            [this] { Q_EMIT showAsked(m_variants->currentRow()); });
    connect(m_variants, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        Q_EMIT renameAsked(m_variants->row(item), item->text());
    });
    connect(m_variants, &QListWidget::currentRowChanged, this, [this](int current) {
        m_show->setEnabled(current >= 0);
        m_remove->setEnabled(current >= 0);
    });
    m_show->setEnabled(false);
    m_remove->setEnabled(false);
    return group;
}

QWidget* ComparePanel::actualGroup() {
    auto* group = new QGroupBox(tr("Against the actual result"));
    auto* column = new QVBoxLayout(group);
    auto* open = new QPushButton(tr("Open a scan of afterwards…"));
    open->setToolTip(
        tr("Lays a scan taken after the operation on the face, by forehead and nasal root, and "
           "measures how far the plan was off"));
    column->addWidget(open);
    m_actual = new QLabel;
    m_actual->setObjectName(QStringLiteral("actual"));
    m_actual->setWordWrap(true);
    m_actual->setTextFormat(Qt::RichText);
    m_actual->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_actual);
    connect(open, &QPushButton::clicked, this, &ComparePanel::actualAsked);
    return group;
}

CompareMode ComparePanel::mode() const {
    for (std::size_t i = 1; i < m_modes.size(); ++i) {
        if (m_modes[i]->isChecked()) {
            return static_cast<CompareMode>(i);
        }
    }
    return CompareMode::Off;
}

void ComparePanel::setMode(CompareMode mode) {
    m_modes[static_cast<std::size_t>(mode)]->setChecked(true);
}

void ComparePanel::setShare(double share) {
    m_share->setValue(qRound(100.0 * share));
}

void ComparePanel::setSidesWords(const QString& words) {
    m_sidesWords->setText(words);
    m_sidesWords->setVisible(!words.isEmpty());
}

void ComparePanel::setActualWords(const QString& words) {
    m_actual->setText(words);
}

void ComparePanel::setVariants(const std::vector<Variant>& variants) {
    const int reference = m_reference->currentIndex();
    {
        const QSignalBlocker a(m_variants);
        const QSignalBlocker b(m_reference);
        const int row = m_variants->currentRow();
        m_variants->clear();
        while (m_reference->count() > 1) {
            m_reference->removeItem(1);
        }
        for (const Variant& variant : variants) {
            const QString name = QString::fromStdString(variant.name);
            auto* item = new QListWidgetItem(name, m_variants);
            item->setFlags(item->flags() | Qt::ItemIsEditable);
            m_reference->addItem(tr("variant %1").arg(name));
        }
        m_variants->setCurrentRow(std::min(row, m_variants->count() - 1));
        m_reference->setCurrentIndex(reference < m_reference->count() ? reference : 0);
    }
    m_show->setEnabled(m_variants->currentRow() >= 0);
    m_remove->setEnabled(m_variants->currentRow() >= 0);
    if (m_reference->currentIndex() != reference) {
        Q_EMIT referenceChosen(-1);
    }
}

}  // namespace myoface
