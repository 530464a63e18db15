// SPDX-License-Identifier: Apache-2.0
#include "preferences.h"

#include <cmath>

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QSettings>
#include <QTabWidget>
#include <QVBoxLayout>

#include "myoface/base/error.h"

#include "language.h"

namespace myoface {
namespace {

QString formInWords(ResponseForm form) {
    switch (form) {
        case ResponseForm::AsPrinted:
            return Preferences::tr("as printed in the paper");
        case ResponseForm::QuarterTurn:
            return Preferences::tr("as printed, over a quarter turn");
        case ResponseForm::Waters1987:
            return Preferences::tr("Waters 1987");
        case ResponseForm::ZoneNormalised:
            return Preferences::tr("normalised to its zone");
        case ResponseForm::LaterCode:
            return Preferences::tr("as in later programs");
        default:
            return Preferences::tr("smooth (usual)");
    }
}

QString formExplained(ResponseForm form) {
    switch (form) {
        case ResponseForm::AsPrinted:
            return Preferences::tr(
                "Equations (7) and (8) to the letter. The skin tears at the end "
                "of the falloff and at the edge of the sector.");
        case ResponseForm::QuarterTurn:
            return Preferences::tr(
                "The radial cosines scaled to a quarter turn, so that the "
                "falloff ends at nothing.");
        case ResponseForm::Waters1987:
            return Preferences::tr(
                "Half the angle's cosine across the sector, quarter-turn curves "
                "along it.");
        case ResponseForm::ZoneNormalised:
            return Preferences::tr("The cosine across the sector reaches nothing at its edge.");
        case ResponseForm::LaterCode:
            return Preferences::tr(
                "Cosine over that of the sector's edge, less one; ramped down "
                "beyond the start of the falloff.");
        default:
            return Preferences::tr(
                "Smooth in slope along and across the fibre: nothing tears, no "
                "edge is seen.");
    }
}

}  // namespace

Settings Settings::read() {
    const QSettings kept;
    Settings settings;
    settings.language = kept.value(QStringLiteral("language")).toString();
    settings.theme = kept.value(QStringLiteral("theme")).toString() == QLatin1String("light")
                         ? Theme::Light
                         : Theme::Dark;
    try {
        settings.response =
            response_named(kept.value(QStringLiteral("response"), QStringLiteral("smooth"))
                               .toString()
                               .toStdString());
    } catch (const InvalidInput&) {
        settings.response = ResponseForm::Smooth;  // of another version
    }
    return settings;
}

void Settings::write() const {
    QSettings kept;
    kept.setValue(QStringLiteral("language"), language);
    kept.setValue(QStringLiteral("theme"),
                  theme == Theme::Light ? QStringLiteral("light") : QStringLiteral("dark"));
    kept.setValue(QStringLiteral("response"), QString::fromStdString(response_name(response)));
}

ResponsePlot::ResponsePlot(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Response along and across the fibre"));
}

void ResponsePlot::setForm(ResponseForm form) {
    m_form = form;
    update();
}

void ResponsePlot::paintEvent(QPaintEvent*) {
    const ThemeColours& colours = themeColours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr double kFrom = 25.0;  // [mm] of the example: start and end of the falloff
    constexpr double kTo = 40.0;
    constexpr double kHalfAngle = 0.7;  // [rad]
    const auto curve = [&](const QRectF& frame, const QString& title, double least, double most,
                           const auto& value, const std::vector<double>& marks) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colours.plot);
        painter.drawRoundedRect(frame, 6.0, 6.0);
        painter.setPen(colours.plotInk);
        painter.drawText(frame.adjusted(10, 6, -10, -6), Qt::AlignTop | Qt::AlignLeft, title);
        const QRectF inside = frame.adjusted(14, 34, -14, -16);
        const auto x = [&](double at) {
            return inside.left() + inside.width() * (at - least) / (most - least);
        };
        painter.setPen(QPen(colours.plotBand, 1.0));
        painter.drawLine(inside.bottomLeft(), inside.bottomRight());
        for (const double mark : marks) {
            painter.drawLine(QPointF(x(mark), inside.top()), QPointF(x(mark), inside.bottom()));
        }
        QPainterPath path;
        constexpr int kSteps = 240;
        for (int k = 0; k <= kSteps; ++k) {
            const double at = least + (most - least) * k / kSteps;
            const double y = std::clamp(value(at), 0.0, 1.2);
            const QPointF p(x(at), inside.bottom() - y / 1.05 * inside.height());
            if (k == 0) {
                path.moveTo(p);
            } else {
                path.lineTo(p);
            }
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours.now, 2.0));
        painter.drawPath(path);
    };
    const double half = 0.5 * width() - 4.0;
    curve(QRectF(0.0, 0.0, half, height()), tr("along the fibre, from the bone"), 0.0, 1.1 * kTo,
          [&](double d) { return radial_response(d, kFrom, kTo, m_form); }, {kFrom, kTo});
    curve(QRectF(half + 8.0, 0.0, half, height()), tr("across the fibre"), -1.2 * kHalfAngle,
          1.2 * kHalfAngle,
          [&](double a) { return angular_response(std::abs(a), kHalfAngle, m_form); },
          {-kHalfAngle, 0.0, kHalfAngle});
}

Preferences::Preferences(const Settings& settings, QWidget* parent)
    : QDialog(parent), m_settings(settings) {
    setWindowTitle(tr("Preferences"));
    auto* column = new QVBoxLayout(this);
    auto* pages = new QTabWidget;
    pages->addTab(lookPage(), tr("Look"));
    pages->addTab(methodPage(), tr("Method"));
    column->addWidget(pages);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
}

QWidget* Preferences::lookPage() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    auto* language = new QComboBox;
    language->setObjectName(QStringLiteral("language"));
    language->addItem(tr("as the system"), QString());
    language->addItem(QStringLiteral("English"), QStringLiteral("en"));
    language->addItem(QStringLiteral("日本語"), QStringLiteral("ja"));
    language->setCurrentIndex(std::max(0, language->findData(m_settings.language)));
    form->addRow(tr("Language"), language);
    auto* theme = new QComboBox;
    theme->setObjectName(QStringLiteral("theme"));
    theme->addItem(tr("dark: the face is the brightest thing"));
    theme->addItem(tr("light: for bright rooms"));
    theme->setCurrentIndex(m_settings.theme == Theme::Light ? 1 : 0);
    form->addRow(tr("Theme"), theme);
    connect(language, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [=, this] {
        m_settings.language = language->currentData().toString();
        Q_EMIT edited(m_settings);
    });
    connect(theme, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int row) {
        m_settings.theme = row == 1 ? Theme::Light : Theme::Dark;
        Q_EMIT edited(m_settings);
    });
    return page;
}

QWidget* Preferences::methodPage() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    auto* form = new QFormLayout;
    auto* response = new QComboBox;
    response->setObjectName(QStringLiteral("response"));
    for (const ResponseForm each : kResponseForms) {
        response->addItem(formInWords(each), static_cast<int>(each));
    }
    response->setCurrentIndex(response->findData(static_cast<int>(m_settings.response)));
    form->addRow(tr("Response of linear muscles"), response);
    column->addLayout(form);
    auto* plot = new ResponsePlot;
    plot->setForm(m_settings.response);
    column->addWidget(plot);
    auto* words = new QLabel(formExplained(m_settings.response));
    words->setWordWrap(true);
    words->setMinimumHeight(44);
    words->setAlignment(Qt::AlignTop);
    column->addWidget(words);
    column->addStretch(1);
    connect(response, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [=, this] {
        m_settings.response = static_cast<ResponseForm>(response->currentData().toInt());
        plot->setForm(m_settings.response);
        words->setText(formExplained(m_settings.response));
        Q_EMIT edited(m_settings);
    });
    return page;
}

}  // namespace myoface
