// SPDX-License-Identifier: Apache-2.0
#include "measure_panel.h"

#include <cmath>

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSplitter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "myoface/base/error.h"
#include "myoface/face/face_model.h"
#include "myoface/io/text_file.h"
#include "myoface/measure/volume.h"
#include "myoface/scene/strokes.h"

#include "language.h"
#include "theme.h"

namespace myoface {
namespace {

enum Column { kTitle, kBefore, kNow, kChange, kNorm };
constexpr int kRow = Qt::UserRole;          // of m_rows, or -1
constexpr int kZBefore = Qt::UserRole + 1;  // standard deviations from the mean
constexpr int kZNow = Qt::UserRole + 2;
constexpr int kEvery = 120;  // while the face moves [ms]

/// The norm as a band of two standard deviations, with marks for before and now.
class BandDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const QVariant before = index.data(kZBefore);
        if (!before.isValid()) {
            return;
        }
        const ThemeColours& colours = themeColours();
        const QRectF area = QRectF(option.rect).adjusted(6, 0, -6, 0);
        const double y = area.center().y();
        const auto at = [&](double z) {
            return area.left() + area.width() * (std::clamp(z, -3.0, 3.0) + 3.0) / 6.0;
        };
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(colours.plotBand);
        painter->drawRoundedRect(QRectF(at(-2.0), y - 4.0, at(2.0) - at(-2.0), 8.0), 2.0, 2.0);
        painter->setPen(QPen(colours.plotInk, 1.0));
        painter->drawLine(QPointF(at(0.0), y - 6.0), QPointF(at(0.0), y + 6.0));
        painter->setPen(QPen(colours.before, 1.5));
        painter->setBrush(Qt::NoBrush);
        painter->drawEllipse(QPointF(at(before.toDouble()), y), 3.2, 3.2);
        painter->setPen(Qt::NoPen);
        const double now = index.data(kZNow).toDouble();
        painter->setBrush(std::abs(now) > 2.0 ? colours.warn : colours.now);
        painter->drawEllipse(QPointF(at(now), y), 3.2, 3.2);
        painter->restore();
    }
};

QString kindInWords(const Measure& measure) {
    switch (measure.kind) {
        case MeasureKind::Angle:
            return MeasurePanel::tr("angle at the middle point");
        case MeasureKind::Tilt:
            return MeasurePanel::tr("angle against the line of the inner canthi");
        case MeasureKind::Depth:
            return MeasurePanel::tr("depth in front of the inner canthi");
        case MeasureKind::Projection:
            return MeasurePanel::tr("in front of the nasion, at right angles to the face's height");
        default:
            return MeasurePanel::tr("straight distance; of pairs the mean of both sides");
    }
}

}  // namespace

MeasurePanel::MeasurePanel(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 8, 8);
    auto* who = new QHBoxLayout;
    m_sex = new QComboBox;
    m_sex->addItems({tr("women and men"), tr("women"), tr("men")});
    m_sex->setAccessibleName(tr("Norm of"));
    m_sex->setToolTip(
        tr("Adults of European descent, 20 to 25 years; band: mean ± 2 standard "
           "deviations"));
    m_age = new QSpinBox;
    m_age->setRange(1, 110);
    m_age->setValue(25);
    m_age->setSuffix(tr(" years"));
    m_age->setAccessibleName(tr("Age"));
    m_age->setToolTip(tr("The norms cover 20 to 25 years and are held beyond"));
    who->addWidget(new QLabel(tr("Norm of")));
    who->addWidget(m_sex, 1);
    who->addWidget(m_age);
    column->addLayout(who);
    auto* split = new QSplitter(Qt::Vertical);
    m_tree = new QTreeWidget;
    m_tree->setObjectName(QStringLiteral("measures"));
    m_tree->setAccessibleName(tr("Measures"));
    m_tree->setHeaderLabels({tr("Measure"), tr("before"), tr("now"), tr("change"), tr("norm")});
    m_tree->setRootIsDecorated(false);
    m_tree->setUniformRowHeights(true);
    m_tree->setAlternatingRowColors(true);
    m_tree->setItemDelegateForColumn(kNorm, new BandDelegate(m_tree));
    m_tree->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_tree->header()->setSectionResizeMode(kTitle, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(kNorm, QHeaderView::Fixed);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->resizeSection(kNorm, 70);
    m_tree->header()->setMinimumSectionSize(44);
    m_tree->headerItem()->setTextAlignment(kNorm, Qt::AlignCenter);
    split->addWidget(m_tree);
    m_plots = new QTabWidget;
    m_plots->setDocumentMode(true);
    m_sections = new SectionView;
    m_volumes = new VolumePlot;
    m_plots->addTab(m_sections, tr("Section"));
    m_plots->addTab(m_volumes, tr("Volumes"));
    split->addWidget(m_plots);
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 2);
    column->addWidget(split, 1);
    auto* buttons = new QHBoxLayout;
    auto* copyButton = new QPushButton(tr("Copy"));
    copyButton->setToolTip(tr("All measures as a table, for a spreadsheet"));
    auto* save = new QPushButton(tr("Export…"));
    save->setToolTip(tr("All measures as CSV or JSON"));
    buttons->addStretch(1);
    buttons->addWidget(copyButton);
    buttons->addWidget(save);
    column->addLayout(buttons);
    connect(copyButton, &QPushButton::clicked, this, &MeasurePanel::copy);
    connect(save, &QPushButton::clicked, this, &MeasurePanel::exportFile);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &MeasurePanel::chosen);
    connect(m_plots, &QTabWidget::currentChanged, this, [this] {
        fillPlots();
        Q_EMIT chosen();
    });
    connect(m_sections, &SectionView::changed, this, [this] {
        showSections();
        fillPlots();
        Q_EMIT chosen();
    });
    connect(m_sections, &SectionView::message, this, &MeasurePanel::message);
    connect(m_sections, &SectionView::problem, this, &MeasurePanel::problem);
    const auto other = [this] {
        fill();
        Q_EMIT populationChanged();
    };
    connect(m_sex, QOverload<int>::of(&QComboBox::currentIndexChanged), this, other);
    connect(m_age, QOverload<int>::of(&QSpinBox::valueChanged), this, other);
}

Population MeasurePanel::population() const {
    Population population;
    population.age = m_age->value();
    if (m_sex->currentIndex() > 0) {
        population.sex = m_sex->currentIndex() == 1 ? Sex::Female : Sex::Male;
    }
    return population;
}

void MeasurePanel::setPopulation(const Population& population) {
    m_age->setValue(static_cast<int>(population.age));
    m_sex->setCurrentIndex(!population.sex ? 0 : *population.sex == Sex::Female ? 1 : 2);
}

void MeasurePanel::setFace(std::shared_ptr<const FaceModel> face,
                           std::shared_ptr<const LandmarksOnSkin> places) {
    m_face = std::move(face);
    m_places = std::move(places);
    m_before.resize(3, 0);
    m_rows.clear();
    m_tree->clear();
    m_sections->setFace(m_face);
    m_volumes->setVolumes({});
    setEnabled(m_face != nullptr);
}

void MeasurePanel::show(const Points& before, const Points& now, bool moving) {
    if (!m_places || !isVisible() || (moving && m_since.isValid() && m_since.elapsed() < kEvery)) {
        return;
    }
    m_since.start();
    m_before = before;
    m_now = now.leftCols(m_face->node_count());
    fill();
}

void MeasurePanel::fill() {
    if (!m_places || m_before.cols() == 0) {
        return;
    }
    m_rows = measure_all(*m_places, m_before, m_now, population());
    m_asymmetryBefore = asymmetries(m_places->at(m_before), m_face->midplane);
    m_asymmetryNow = asymmetries(m_places->at(m_now), m_face->midplane);
    fillTree();
    fillPlots();
}

void MeasurePanel::fillTree() {
    const QLocale locale;
    const auto wanted = static_cast<int>(m_rows.size() + m_asymmetryNow.size());
    while (m_tree->topLevelItemCount() > wanted) {
        delete m_tree->takeTopLevelItem(m_tree->topLevelItemCount() - 1);
    }
    while (m_tree->topLevelItemCount() < wanted) {
        auto* item = new QTreeWidgetItem(m_tree);
        for (const int column : {kBefore, kNow, kChange}) {
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        }
    }
    const auto fillRow = [&](QTreeWidgetItem* item, const QString& title, double before, double now,
                             const QString& unit) {
        const double change = now - before;
        item->setText(kTitle, title);
        item->setText(kBefore, locale.toString(before, 'f', 1) + unit);
        item->setText(kNow, locale.toString(now, 'f', 1) + unit);
        item->setText(kChange, std::abs(change) < 0.05
                                   ? QStringLiteral("·")
                                   : (change > 0.0 ? QStringLiteral("+") : QString()) +
                                         locale.toString(change, 'f', 1));
    };
    int at = 0;
    for (const Measurement& row : m_rows) {
        QTreeWidgetItem* item = m_tree->topLevelItem(at);
        const QString unit = row.measure.in_degrees() ? tr("°") : QString();
        fillRow(item, inWords(row.measure.title), row.value, *row.other, unit);
        item->setData(kTitle, kRow, at);
        QString tip = QString::fromStdString(row.measure.id) + QStringLiteral(": ") +
                      kindInWords(row.measure);
        if (row.norm) {
            item->setData(kNorm, kZBefore, (row.value - row.norm->mean) / row.norm->sd);
            item->setData(kNorm, kZNow, (*row.other - row.norm->mean) / row.norm->sd);
            tip += tr("\nnorm %1 ± %2, z = %3\n%4")
                       .arg(locale.toString(row.norm->mean, 'f', 1),
                            locale.toString(row.norm->sd, 'f', 1),
                            locale.toString((*row.other - row.norm->mean) / row.norm->sd, 'f', 1),
                            QString::fromStdString(row.norm->source));
        } else {
            item->setData(kNorm, kZBefore, {});
        }
        item->setToolTip(kTitle, tip);
        item->setToolTip(kNorm, tip);
        ++at;
    }
    for (std::size_t i = 0; i < m_asymmetryNow.size(); ++i, ++at) {
        QTreeWidgetItem* item = m_tree->topLevelItem(at);
        const std::string& name = m_asymmetryNow[i].first;
        fillRow(item, tr("sides differ: %1").arg(landmarkInWords(name)),
                m_asymmetryBefore[i].second, m_asymmetryNow[i].second, {});
        item->setData(kTitle, kRow, -1);
        item->setData(kNorm, kZBefore, {});
        item->setToolTip(kTitle, tr("How far the left one is from the mirror image of the right "
                                    "one about this patient's own midplane [mm]"));
    }
}

void MeasurePanel::fillPlots() {
    if (!m_face || m_before.cols() == 0) {
        return;
    }
    m_sections->show(m_before.leftCols(m_face->node_count()), m_now);
    if (m_volumes->isVisible()) {
        m_volumes->setVolumes(
            volume_by_region(*m_face, m_before.leftCols(m_face->node_count()), m_now));
    }
}

void MeasurePanel::draw(SceneData& scene, const Points& now) const {
    const QList<QTreeWidgetItem*> selected = m_tree->selectedItems();
    if (!m_places || !isVisible()) {
        return;
    }
    if (m_sections->kind() != SectionView::Profile) {  // one that was asked for
        m_sections->draw(scene);
    }
    if (selected.isEmpty()) {
        return;
    }
    const int at = selected.first()->data(kTitle, kRow).toInt();
    if (at < 0 || at >= static_cast<int>(m_rows.size())) {
        return;
    }
    const Measure& measure = m_rows[static_cast<std::size_t>(at)].measure;
    const Landmarks places = m_places->at(now);
    const Eigen::Vector3f colour(0.98F, 0.80F, 0.35F);
    const auto draw_line = [&](const std::vector<std::string>& names) {
        std::vector<Vec3> points;
        for (const std::string& name : names) {
            const auto found = places.find(name);
            if (found != places.end()) {
                points.push_back(found->second.position);
                scene.markers.push_back({found->second.position.cast<float>(), colour, 4.5F});
            }
        }
        add_line(scene.strokes, points, colour);
    };
    const auto sided = [&](const std::string& name, const char* side) {
        return places.count(name) != 0 ? name : name + side;
    };
    std::vector<std::string> left;
    std::vector<std::string> right;
    for (const std::string& name : measure.points) {
        left.push_back(sided(name, "_l"));
        right.push_back(sided(name, "_r"));
    }
    const bool across = measure.points.size() == 2 && measure.points[0] == measure.points[1];
    if (across) {
        draw_line({left[0], right[0]});
    } else {
        draw_line(left);
        if (right != left) {
            draw_line(right);
        }
    }
}

void MeasurePanel::copy() const {
    QString text;
    for (int column = 0; column <= kChange; ++column) {
        text += m_tree->headerItem()->text(column) + QLatin1Char(column == kChange ? '\n' : '\t');
    }
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        for (int column = 0; column <= kChange; ++column) {
            text += m_tree->topLevelItem(i)->text(column) +
                    QLatin1Char(column == kChange ? '\n' : '\t');
        }
    }
    QApplication::clipboard()->setText(text);
}

void MeasurePanel::exportFile() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Export the measures"), {},
                                                      tr("CSV (*.csv);;JSON (*.json)"));
    if (path.isEmpty()) {
        return;
    }
    try {
        write_file(path.toStdString(), path.endsWith(QLatin1String(".json"))
                                           ? measurements_json(m_rows, m_asymmetryNow, population())
                                           : measurements_csv(m_rows));
        Q_EMIT message(tr("Written: %1").arg(path));
    } catch (const Error& error) {
        Q_EMIT problem(QString::fromUtf8(error.what()));
    }
}

void MeasurePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        fill();
    }
    QWidget::changeEvent(event);
}

}  // namespace myoface
