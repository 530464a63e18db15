// SPDX-License-Identifier: Apache-2.0
#include "section_view.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"
#include "myoface/scene/strokes.h"

#include "theme.h"

namespace myoface {
namespace {

/// A step of 1, 2 or 5 times a power of ten that is at least so many pixels long [mm].
double niceStep(double scale, double pixels) {
    const double least = pixels / scale;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

}  // namespace

SectionPlot::SectionPlot(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Section before and now"));
    setToolTip(tr("A cut through the face: grey before, blue now; the grid is in millimetres"));
}

void SectionPlot::setLines(std::vector<SectionLine> before, std::vector<SectionLine> now) {
    m_before = std::move(before);
    m_now = std::move(now);
    update();
}

void SectionPlot::paintEvent(QPaintEvent*) {
    const ThemeColours& colours = themeColours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.plot);
    painter.drawRoundedRect(rect(), 6.0, 6.0);
    Eigen::AlignedBox2d bounds;
    for (const std::vector<SectionLine>* lines : {&m_before, &m_now}) {
        for (const SectionLine& line : *lines) {
            for (const Eigen::Vector2d& p : line) {
                bounds.extend(p);
            }
        }
    }
    if (bounds.isEmpty()) {
        return;
    }
    constexpr double kMargin = 14.0;  // [px]
    const Eigen::Vector2d size = bounds.sizes().cwiseMax(1.0);
    const double scale =
        std::min((width() - 2.0 * kMargin) / size.x(), (height() - 2.0 * kMargin) / size.y());
    const Eigen::Vector2d middle = bounds.center();
    const auto at = [&](const Eigen::Vector2d& p) {
        return QPointF(0.5 * width() + scale * (p.x() - middle.x()),
                       0.5 * height() - scale * (p.y() - middle.y()));
    };
    // A grid in round millimetres, with a bar that says how many.
    const double step = niceStep(scale, 28.0);
    QColor grid = colours.plotInk;
    grid.setAlpha(45);
    painter.setPen(QPen(grid, 1.0));
    const double half_width = 0.5 * width() / scale;
    const double half_height = 0.5 * height() / scale;
    for (double x = step * std::ceil((middle.x() - half_width) / step); x < middle.x() + half_width;
         x += step) {
        painter.drawLine(QPointF(at({x, 0.0}).x(), 0.0), QPointF(at({x, 0.0}).x(), height()));
    }
    for (double y = step * std::ceil((middle.y() - half_height) / step);
         y < middle.y() + half_height; y += step) {
        painter.drawLine(QPointF(0.0, at({0.0, y}).y()), QPointF(width(), at({0.0, y}).y()));
    }
    const auto draw = [&](const std::vector<SectionLine>& lines, const QColor& colour,
                          double pixels) {
        painter.setPen(QPen(colour, pixels, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        for (const SectionLine& line : lines) {
            QPolygonF polygon;
            for (const Eigen::Vector2d& p : line) {
                polygon << at(p);
            }
            painter.drawPolyline(polygon);
        }
    };
    draw(m_before, colours.before, 1.6);
    draw(m_now, colours.now, 2.0);
    const QString words = tr("%1 mm").arg(QLocale().toString(step));
    const QFontMetricsF metrics(painter.font());
    const double bar = step * scale;
    QRectF plate(0.0, 0.0, std::max(bar, metrics.horizontalAdvance(words)) + 12.0,
                 metrics.height() + 12.0);
    plate.moveBottomRight(QPointF(width() - 6.0, height() - 4.0));
    painter.setPen(Qt::NoPen);
    QColor behind = colours.plot;
    behind.setAlpha(220);
    painter.setBrush(behind);
    painter.drawRoundedRect(plate, 4.0, 4.0);
    painter.setPen(QPen(colours.plotInk, 1.4));
    const double y = plate.bottom() - 5.0;
    painter.drawLine(QPointF(plate.center().x() - 0.5 * bar, y),
                     QPointF(plate.center().x() + 0.5 * bar, y));
    painter.drawText(plate.adjusted(0.0, 1.0, 0.0, -8.0), Qt::AlignCenter, words);
}

SectionView::SectionView(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    column->setSpacing(6);
    auto* row = new QHBoxLayout;
    m_kind = new QComboBox;
    m_kind->addItems(
        {tr("Profile"), tr("Level cut"), tr("Upright cut beside the midplane"), tr("Free cut")});
    m_kind->setAccessibleName(tr("Kind of section"));
    m_kind->setToolTip(
        tr("With the tool Section (S), a click on the face says where it is cut; a line drawn "
           "across the face cuts along it"));
    m_kind->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_kind->setMinimumContentsLength(10);
    auto* save = new QPushButton(tr("CSV…"));
    save->setToolTip(tr("The lines of the section in millimetres, for a spreadsheet"));
    row->addWidget(m_kind, 1);
    row->addWidget(save);
    column->addLayout(row);
    m_plot = new SectionPlot;
    column->addWidget(m_plot, 1);
    m_gap = new QLabel;
    m_gap->setObjectName(QStringLiteral("gap"));
    column->addWidget(m_gap);
    connect(m_kind, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
        choose();
        Q_EMIT changed();
    });
    connect(save, &QPushButton::clicked, this, &SectionView::exportFile);
}

void SectionView::setFace(std::shared_ptr<const FaceModel> face) {
    m_face = std::move(face);
    m_skin = m_face ? seen_skin(*m_face) : Triangles(3, 0);
    m_plot->setLines({}, {});
    m_gap->clear();
    if (m_face) {
        m_through = profile_plane(*m_face).through;
        m_freeNormal = (m_face->axes.col(0) + m_face->axes.col(1)).normalized();
        choose();
    }
}

void SectionView::choose() {
    if (m_face) {
        m_plane = kind() == Profile  ? profile_plane(*m_face)
                  : kind() == Level  ? horizontal_plane(*m_face, m_through)
                  : kind() == Beside ? sagittal_plane(*m_face, m_through)
                                     : free_plane(*m_face, m_through, m_freeNormal);
    }
}

void SectionView::place(const Vec3& through) {
    m_through = through;
    if (kind() == Profile) {
        const QSignalBlocker quiet(m_kind);
        setKind(Level);
    }
    choose();
    Q_EMIT changed();
}

void SectionView::placeFree(const Vec3& through, const Vec3& normal) {
    if (!m_face) {
        return;
    }
    // A place of the plane near the face, so that distances along it start there.
    const Vec3 tip = profile_plane(*m_face).through;
    m_through = tip - normal.dot(tip - through) * normal;
    m_freeNormal = normal;
    const QSignalBlocker quiet(m_kind);
    setKind(Free);
    choose();
    Q_EMIT changed();
}

void SectionView::show(const Points& before, const Points& now) {
    if (m_face && isVisible()) {
        m_plot->setLines(section(*m_face, m_skin, before, m_plane),
                         section(*m_face, m_skin, now, m_plane));
        sayGap();
    }
}

void SectionView::sayGap() {
    const double gap = largest_gap(m_plot->before(), m_plot->now());
    m_gap->setText(m_plot->now().empty()
                       ? tr("The plane does not meet the face.")
                       : tr("Apart by up to %1 mm").arg(QLocale().toString(gap, 'f', 1)));
}

void SectionView::draw(SceneData& scene) const {
    if (!m_face || !isVisible()) {
        return;
    }
    constexpr double kLift = 0.25;  // [mm] off the skin
    const auto lines = [&](const std::vector<SectionLine>& cut, const Eigen::Vector3f& colour) {
        for (const SectionLine& line : cut) {
            std::vector<Vec3> points;
            for (const Eigen::Vector2d& p : line) {
                points.push_back(m_plane.through + p.x() * m_plane.right + p.y() * m_plane.up +
                                 kLift * m_face->axes.col(2));
            }
            add_line(scene.strokes, points, colour);
        }
    };
    lines(m_plot->before(), {0.62F, 0.66F, 0.70F});
    lines(m_plot->now(), {0.25F, 0.74F, 1.0F});
}

void SectionView::exportFile() {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Export the section"), {}, tr("CSV (*.csv)"));
    if (path.isEmpty()) {
        return;
    }
    try {
        write_file(path.toStdString(), section_csv(m_plot->before(), m_plot->now()));
        Q_EMIT message(tr("Written: %1").arg(path));
    } catch (const Error& error) {
        Q_EMIT problem(QString::fromUtf8(error.what()));
    }
}

void SectionView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange && !m_gap->text().isEmpty()) {
        sayGap();
    }
    QWidget::changeEvent(event);
}

}  // namespace myoface
