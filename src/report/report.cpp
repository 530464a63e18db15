// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <algorithm>
#include <cmath>

#include <QBuffer>
#include <QFont>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"
#include "myoface/scene/colour_map.h"

#include "catalogue.h"

namespace myoface {
namespace {

constexpr int kResolution = 600;                                              // [dots per inch]
constexpr double kLeft = 18.0, kRight = 192.0, kTop = 16.0, kBottom = 281.0;  // [mm] on A4
const QColor kInk(32, 38, 46);
const QColor kFaint(120, 130, 140);
const QColor kRule(208, 214, 220);
const QColor kAccent(44, 110, 168);
const char* const kContext = "report";
const char* const kDisclaimer =
    "A planning and communication aid, not a medical device. What is shown is an estimate, not a "
    "promise of a result.";

QString words(const std::string& text) {
    return QString::fromStdString(text);
}

QImage picture(const Image& image) {
    return QImage(image.rgba.data(), image.width, image.height, 4 * image.width,
                  QImage::Format_RGBA8888)
        .convertToFormat(QImage::Format_RGB32);
}

/// Text needs an application, also on the command line.
void need_application() {
    if (QGuiApplication::instance() == nullptr) {
        if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
            qputenv("QT_QPA_PLATFORM", "offscreen");
        }
        static int count = 1;
        static char name[] = "myoface";
        static char* arguments[] = {name, nullptr};
        static QGuiApplication application(count, arguments);
    }
}

/// Draws down the pages; lengths in mm.
class Sheet {
public:
    Sheet(QPdfWriter& writer, const Catalogue& catalogue)
        : m_writer(writer), m_painter(&writer), m_catalogue(catalogue) {
        foot();
    }

    /// Our own words in the report's language.
    QString say(const char* english) const { return said(kContext, english); }
    /// Words of the core library.
    QString core(const std::string& english) const { return said(kCoreWords, english.c_str()); }

    double y = kTop;

    void need(double height) {
        if (y + height > kBottom - 8.0) {
            m_writer.newPage();
            ++m_page;
            y = kTop;
            foot();
        }
    }
    double text(const QString& what, double x, double width, double points, const QColor& colour,
                int flags = Qt::AlignLeft, bool bold = false) {
        m_painter.setFont(font(points, bold));
        m_painter.setPen(colour);
        const QRectF box(px(x), px(y), px(width), px(200.0));
        QRectF used;
        m_painter.drawText(box, flags | Qt::AlignTop | Qt::TextWordWrap, what, &used);
        return used.height() / px(1.0);
    }
    void heading(const QString& what) {
        need(14.0);
        y += 3.0;
        y += text(what, kLeft, kRight - kLeft, 12.0, kAccent, Qt::AlignLeft, true) + 2.0;
    }
    /// Lines of text, over as many pages as they take.
    void lines(const QString& what, double points) {
        const QFontMetricsF metrics(font(points), &m_writer);
        for (const QString& line : what.split(QLatin1Char('\n'))) {
            need(metrics
                     .boundingRect(QRectF(0.0, 0.0, px(kRight - kLeft), px(250.0)),
                                   Qt::TextWordWrap, line)
                     .height() /
                 px(1.0));
            y += text(line.isEmpty() ? QStringLiteral(" ") : line, kLeft, kRight - kLeft, points,
                      kInk);
        }
    }
    void rule() {
        m_painter.setPen(QPen(kRule, px(0.2)));
        m_painter.drawLine(QPointF(px(kLeft), px(y)), QPointF(px(kRight), px(y)));
    }
    /// @return height it takes
    double image(const Image& source, double x, double width) {
        const double height = width * source.height / std::max(source.width, 1);
        m_painter.drawImage(QRectF(px(x), px(y), px(width), px(height)), picture(source));
        return height;
    }
    /// Mean and two standard deviations as a band, before and after as marks on it.
    void band(const ReportMeasure& m, double x, double width, double height) {
        const double mean = m.norm->first;
        const double deviation = m.norm->second;
        const auto at = [&](double value) {
            const double z = std::clamp((value - mean) / deviation, -3.0, 3.0);
            return px(x + width * (z + 3.0) / 6.0);
        };
        const double middle = px(y + 0.5 * height);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(QColor(226, 234, 242));
        m_painter.drawRect(QRectF(at(mean - 2.0 * deviation), middle - px(1.3),
                                  at(mean + 2.0 * deviation) - at(mean - 2.0 * deviation),
                                  px(2.6)));
        m_painter.setPen(QPen(QColor(150, 165, 180), px(0.25)));
        m_painter.drawLine(QPointF(at(mean), middle - px(1.9)),
                           QPointF(at(mean), middle + px(1.9)));
        m_painter.setPen(QPen(kFaint, px(0.3)));
        m_painter.setBrush(Qt::white);
        m_painter.drawEllipse(QPointF(at(m.before), middle), px(0.9), px(0.9));
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(kAccent);
        m_painter.drawEllipse(QPointF(at(m.after), middle), px(1.0), px(1.0));
    }
    void legend(double x, double width, double most) {
        constexpr int kSteps = 64;
        for (int k = 0; k < kSteps; ++k) {
            const Eigen::Vector3f c = colour_map((k + 0.5) / kSteps);
            m_painter.fillRect(
                QRectF(px(x + width * k / kSteps), px(y), px(width / kSteps) + 1.0, px(3.0)),
                QColor::fromRgbF(c.x(), c.y(), c.z()));
        }
        y += 3.6;
        text(QStringLiteral("0"), x, width, 7.5, kFaint);
        text(QStringLiteral("%1 mm").arg(most, 0, 'f', 1), x, width, 7.5, kFaint, Qt::AlignRight);
        y += 4.0;
    }

private:
    static double px(double mm) { return mm * kResolution / 25.4; }
    void foot() {
        const double back = y;
        y = kBottom - 5.0;
        rule();
        y += 1.2;
        text(say(kDisclaimer), kLeft, 150.0, 7.0, kFaint);
        text(QStringLiteral("Myoface %1 · %2").arg(QStringLiteral(MYOFACE_VERSION)).arg(m_page),
             kRight - 40.0, 40.0, 7.0, kFaint, Qt::AlignRight);
        y = back;
    }

    QString said(const char* context, const char* english) const {
        const QString source = QString::fromUtf8(english);
        const QString found = m_catalogue.find(QString::fromUtf8(context), source);
        return found.isEmpty() ? source : found;
    }
    static QFont font(double points, bool bold = false) {
        QFont result;
        result.setFamilies({QStringLiteral("DejaVu Sans"), QStringLiteral("IPAPGothic"),
                            QStringLiteral("Noto Sans CJK JP")});
        result.setPointSizeF(points);
        result.setBold(bold);
        return result;
    }

    QPdfWriter& m_writer;
    QPainter m_painter;
    const Catalogue& m_catalogue;
    int m_page = 1;
};

QString title_of(const Sheet& sheet, const Report& report) {
    return report.title.empty() ? sheet.say("Facial simulation") : words(report.title);
}

void draw_head(Sheet& sheet, const Report& report) {
    if (report.logo) {
        const double height = 14.0;
        sheet.image(*report.logo, kRight - height * report.logo->width / report.logo->height,
                    height * report.logo->width / report.logo->height);
    }
    sheet.y +=
        sheet.text(title_of(sheet, report), kLeft, 130.0, 19.0, kInk, Qt::AlignLeft, true) + 1.5;
    QString line = words(report.date);
    for (const std::string& part : {report.patient, report.face}) {
        if (!part.empty()) {
            line += QStringLiteral("  ·  ") + words(part);
        }
    }
    sheet.y += sheet.text(line, kLeft, 170.0, 9.5, kFaint) + 3.0;
    sheet.rule();
    sheet.y += 4.0;
}

void draw_views(Sheet& sheet, const Report& report) {
    constexpr double kWidth = 62.0;
    const double columns[2] = {kLeft + 22.0, kLeft + 22.0 + kWidth + 6.0};
    sheet.text(sheet.say("before"), columns[0], kWidth, 9.0, kFaint);
    sheet.text(sheet.say("after"), columns[1], kWidth, 9.0, kAccent);
    sheet.y += 5.0;
    for (const ReportView& view : report.views) {
        const double height = kWidth * view.before.height / std::max(view.before.width, 1);
        sheet.need(height + 4.0);
        sheet.text(sheet.core(view.caption), kLeft, 21.0, 9.0, kInk);
        sheet.image(view.before, columns[0], kWidth);
        sheet.image(view.after, columns[1], kWidth);
        sheet.y += height + 3.0;
    }
}

void draw_change(Sheet& sheet, const Report& report) {
    if (!report.heat_map) {
        return;
    }
    sheet.heading(sheet.say("What moves"));
    constexpr double kWidth = 54.0;
    sheet.need(kWidth * report.heat_map->height / std::max(report.heat_map->width, 1) + 12.0);
    const double top = sheet.y;
    const double height = sheet.image(*report.heat_map, kLeft, kWidth);
    const double x = kLeft + kWidth + 8.0;
    const double width = kRight - x;
    sheet.y +=
        sheet.text(
            sheet.say("The skin moves by up to %1 mm.").arg(report.largest_move_mm, 0, 'f', 1), x,
            width, 9.5, kInk) +
        3.0;
    for (const auto& [region, ml] : report.volumes) {
        sheet.text(sheet.core(region), x, 40.0, 9.0, kInk);
        sheet.text(
            QStringLiteral("%1%2 mL").arg(QLatin1String(ml > 0.0 ? "+" : "")).arg(ml, 0, 'f', 2),
            x + 40.0, 24.0, 9.0, kInk, Qt::AlignRight);
        sheet.y += 5.0;
    }
    for (const auto& [muscle, rate] : report.muscles) {
        sheet.text(sheet.core(muscle), x, 70.0, 9.0, kFaint);
        sheet.text(QStringLiteral("%1 %").arg(100.0 * rate, 0, 'f', 0), x + 70.0, 24.0, 9.0, kFaint,
                   Qt::AlignRight);
        sheet.y += 4.6;
        if (sheet.y > top + height - 6.0) {
            break;  // the whole list stands in the case
        }
    }
    sheet.y = std::max(sheet.y, top + height) + 2.0;
    sheet.legend(kLeft, kWidth, report.heat_map_mm);
}

void draw_measures(Sheet& sheet, const Report& report) {
    if (report.measures.empty()) {
        return;
    }
    sheet.heading(sheet.say("Measures"));
    const double columns[5] = {kLeft, kLeft + 66.0, kLeft + 86.0, kLeft + 106.0, kLeft + 130.0};
    const auto row = [&](const QString(&cells)[4], const QColor& colour) {
        sheet.text(cells[0], columns[0], 66.0, 8.5, colour);
        for (int c = 1; c < 4; ++c) {
            sheet.text(cells[c], columns[c], 18.0, 8.5, colour, Qt::AlignRight);
        }
    };
    row({QString(), sheet.say("before"), sheet.say("after"), sheet.say("change")}, kFaint);
    if (!report.population.empty()) {
        sheet.text(sheet.core(report.population), columns[4], kRight - columns[4], 6.5, kFaint,
                   Qt::AlignHCenter);
    }
    sheet.y += 6.0;
    for (const ReportMeasure& m : report.measures) {
        sheet.need(5.5);
        const QString unit = m.degrees ? QStringLiteral("°") : QStringLiteral(" mm");
        const double change = m.after - m.before;
        const bool changed = std::abs(change) >= 0.05;
        row({sheet.core(m.title), QString::number(m.before, 'f', 1) + unit,
             QString::number(m.after, 'f', 1) + unit,
             changed ? QLatin1String(change > 0.0 ? "+" : "") + QString::number(change, 'f', 1)
                     : QStringLiteral("·")},
            changed ? kInk : kFaint);
        if (m.norm) {
            sheet.band(m, columns[4], kRight - columns[4], 4.0);
        }
        sheet.y += 4.75;
    }
}

}  // namespace

void write_report(const std::filesystem::path& file, const Report& report) {
    need_application();
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0));
        writer.setResolution(kResolution);
        writer.setCreator(QStringLiteral("Myoface"));
        writer.setTitle(words(report.title.empty() ? "Facial simulation" : report.title));
        const Catalogue catalogue(QString::fromStdString(report.language));
        Sheet sheet(writer, catalogue);
        draw_head(sheet, report);
        draw_views(sheet, report);
        draw_change(sheet, report);
        draw_measures(sheet, report);
        if (!report.notes.empty()) {
            sheet.heading(sheet.say("Notes"));
            sheet.lines(words(report.notes), 9.5);
        }
    }
    const QByteArray& bytes = buffer.data();
    write_file(file, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace myoface
