// SPDX-License-Identifier: Apache-2.0
#include "landmark_panel.h"

#include <algorithm>
#include <array>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPainter>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "landmark_picture.h"
#include "language.h"

namespace myoface {
namespace {

constexpr double kSure = 3.1;    // [mm]
constexpr double kUnsure = 5.5;  // [mm]
constexpr int kPictureWidth = 116;
constexpr int kPictureHeight = 132;

/// Those the muscles hang on come first; the others are rough by nature.
bool matters(const std::string& name) {
    static constexpr std::array<const char*, 9> kWeak{"tr",   "zy_l", "zy_r", "go_l", "go_r",
                                                      "ft_l", "ft_r", "t_l",  "t_r"};
    return std::none_of(kWeak.begin(), kWeak.end(), [&](const char* w) { return name == w; });
}

QIcon dot(const QColor& colour) {
    QPixmap pixmap(14, 14);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(2, 2, 10, 10);
    return pixmap;
}

}  // namespace

QColor landmarkColour(const Landmark& landmark) {
    return landmark.error_mm <= kCheckedError ? QColor(86, 166, 240)
           : landmark.error_mm <= kSure       ? QColor(88, 190, 110)
           : landmark.error_mm <= kUnsure     ? QColor(240, 176, 64)
                                              : QColor(230, 84, 68);
}

LandmarkPanel::LandmarkPanel(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    m_edit = new QCheckBox(tr("Show and move landmarks"));
    m_edit->setToolTip(
        tr("Drag a marker on the skin: the fit follows. Markers are green where the "
           "program is sure, red where it is not, blue once you have placed them."));
    m_net = new QCheckBox(tr("Show the fitted head"));
    m_net->setToolTip(
        tr("A net of the built-in head as it was fitted; where it is red it lies off the scan"));
    layout->addWidget(m_edit);
    layout->addWidget(m_net);
    m_list = new QTreeWidget;
    m_list->setColumnCount(2);
    m_list->setHeaderLabels({tr("Landmark"), tr("± mm")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_list->setAccessibleName(tr("Landmarks"));
    layout->addWidget(m_list, 1);

    auto* about = new QHBoxLayout;
    m_picture = new QLabel;
    m_picture->setFixedSize(kPictureWidth, kPictureHeight);
    m_definition = new QLabel;
    m_definition->setWordWrap(true);
    m_definition->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_definition->setTextFormat(Qt::RichText);
    about->addWidget(m_picture);
    about->addWidget(m_definition, 1);
    layout->addLayout(about);

    auto* buttons = new QHBoxLayout;
    m_next = new QPushButton(tr("Next to check"));
    m_next->setToolTip(tr("The landmark that the program is least sure of"));
    m_accept = new QPushButton(tr("Accept"));
    m_accept->setToolTip(tr("This one is right as it is"));
    buttons->addWidget(m_next);
    buttons->addWidget(m_accept);
    layout->addLayout(buttons);
    auto* more = new QHBoxLayout;
    m_mirror = new QPushButton(tr("From other side"));
    m_mirror->setToolTip(
        tr("Places it at the mirror image of the other side's, about this "
           "patient's own midplane"));
    m_detect = new QPushButton(tr("Find again"));
    m_detect->setToolTip(tr("Finds all landmarks by the shape of the face"));
    more->addWidget(m_mirror);
    more->addWidget(m_detect);
    layout->addLayout(more);
    auto* depth = new QHBoxLayout;
    m_tissue = new QComboBox;
    for (const auto& [thickness, name] : {std::pair{TissueThickness::Thin, tr("thin")},
                                          std::pair{TissueThickness::Mean, tr("mean")},
                                          std::pair{TissueThickness::Heavy, tr("heavy")}}) {
        m_tissue->addItem(name, static_cast<int>(thickness));
    }
    m_tissue->setCurrentIndex(1);
    m_tissue->setAccessibleName(tr("Soft tissue"));
    m_tissue->setToolTip(
        tr("How much soft tissue lies over the bone: the scan does not show it. Mean values of the "
           "forensic tables, or 15 % (forehead) to 35 % (cheeks) beside them."));
    auto* caption = new QLabel(tr("Soft tissue"));
    caption->setBuddy(m_tissue);
    depth->addWidget(caption);
    depth->addWidget(m_tissue, 1);
    layout->addLayout(depth);
    m_misfit = new QLabel;
    m_misfit->setWordWrap(true);
    layout->addWidget(m_misfit);

    connect(m_list, &QTreeWidget::currentItemChanged, this, [this] {
        describe();
        if (!selected().empty()) {
            Q_EMIT chosen(selected());
        }
    });
    connect(m_edit, &QCheckBox::toggled, this, &LandmarkPanel::displayChanged);
    connect(m_net, &QCheckBox::toggled, this, &LandmarkPanel::displayChanged);
    connect(m_next, &QPushButton::clicked, this, &LandmarkPanel::selectNext);
    connect(m_accept, &QPushButton::clicked, this, [this] { Q_EMIT accepted(selected()); });
    connect(m_mirror, &QPushButton::clicked, this, [this] { Q_EMIT mirrorAsked(selected()); });
    connect(m_tissue, qOverload<int>(&QComboBox::activated), this, [this] {
        Q_EMIT tissueChosen(static_cast<TissueThickness>(m_tissue->currentData().toInt()));
    });
    connect(m_detect, &QPushButton::clicked, this, &LandmarkPanel::detectionAsked);
    describe();
}

void LandmarkPanel::setLandmarks(const Landmarks& landmarks) {
    const std::string before = selected();
    m_landmarks = landmarks;
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const std::string& name : landmark_names()) {
        const auto found = landmarks.find(name);
        auto* row = new QTreeWidgetItem(m_list);
        row->setText(0, landmarkInWords(name));
        row->setData(0, Qt::UserRole, QString::fromStdString(name));
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        if (found != landmarks.end()) {
            row->setIcon(0, dot(landmarkColour(found->second)));
            row->setText(1, found->second.error_mm <= kCheckedError
                                ? tr("checked")
                                : QString::number(found->second.error_mm, 'f', 1));
        } else {
            row->setIcon(0, dot(QColor(110, 118, 126)));
            row->setText(1, tr("missing"));
        }
        if (name == before) {
            m_list->setCurrentItem(row);
        }
    }
    describe();
}

void LandmarkPanel::showAll() {
    m_edit->setChecked(true);
    m_net->setChecked(true);
    selectNext();
}

void LandmarkPanel::select(const std::string& name) {
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        QTreeWidgetItem* row = m_list->topLevelItem(i);
        if (row->data(0, Qt::UserRole).toString().toStdString() == name) {
            m_list->setCurrentItem(row);
            m_list->scrollToItem(row);
        }
    }
}

std::string LandmarkPanel::selected() const {
    const QTreeWidgetItem* row = m_list->currentItem();
    return row != nullptr ? row->data(0, Qt::UserRole).toString().toStdString() : std::string();
}

void LandmarkPanel::setTissue(TissueThickness tissue) {
    m_tissue->setCurrentIndex(m_tissue->findData(static_cast<int>(tissue)));
}

void LandmarkPanel::setDetecting(bool detecting) {
    m_detect->setEnabled(!detecting);
    m_detect->setText(detecting ? tr("Searching …") : tr("Find again"));
}

void LandmarkPanel::setMisfit(double median, double most) {
    m_misfit->setText(tr("The fitted head lies %1 mm off the scan in the middle, %2 mm at 95 %.")
                          .arg(median, 0, 'f', 2)
                          .arg(most, 0, 'f', 2));
}

void LandmarkPanel::describe() {
    const std::string name = selected();
    const bool there = m_landmarks.count(name) != 0;
    m_accept->setEnabled(there && m_landmarks.at(name).error_mm > kCheckedError);
    m_mirror->setEnabled(!name.empty() && mirrored_name(name) != name &&
                         m_landmarks.count(mirrored_name(name)) != 0);
    m_next->setEnabled(!m_landmarks.empty());
    if (name.empty()) {
        m_picture->hide();
        m_definition->setText(tr("Choose a landmark to see what it is."));
        return;
    }
    m_picture->setPixmap(QPixmap::fromImage(landmarkPicture(name, kPictureWidth, kPictureHeight)));
    m_picture->show();
    m_definition->setText(QStringLiteral("<b>%1</b> (%2)<br>%3")
                              .arg(landmarkInWords(name).toHtmlEscaped(),
                                   QString::fromStdString(name),
                                   inWords(landmark_definition(name)).toHtmlEscaped()));
}

void LandmarkPanel::selectNext() {
    std::string worst;
    double most = kCheckedError;
    for (const bool important : {true, false}) {
        for (const auto& [name, landmark] : m_landmarks) {
            if (matters(name) == important && landmark.error_mm > most) {
                most = landmark.error_mm;
                worst = name;
            }
        }
        if (!worst.empty()) {
            break;
        }
    }
    if (!worst.empty()) {
        m_edit->setChecked(true);
        select(worst);
    }
}

}  // namespace myoface
