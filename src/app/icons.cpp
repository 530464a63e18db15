// SPDX-License-Identifier: Apache-2.0
#include "icons.h"

#include <QGuiApplication>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

QByteArray drawing(const QString& name) {
    try {
        const std::string file = "assets/icons/" + name.toStdString() + ".svg";
        return QByteArray::fromStdString(read_file(resource_path(file)));
    } catch (const Error&) {
        return {};  // a button with words alone
    }
}

QPixmap painted(const QByteArray& svg, int pixels) {
    QPixmap picture(pixels, pixels);
    picture.fill(Qt::transparent);
    QSvgRenderer renderer(svg);
    QPainter painter(&picture);
    renderer.render(&painter);
    return picture;
}

}  // namespace

QIcon icon(const QString& name) {
    const QByteArray svg = drawing(name);
    QIcon result;
    if (svg.isEmpty()) {
        return result;
    }
    const QPalette palette = QGuiApplication::palette();
    const auto coloured = [&](QPalette::ColorGroup group) {
        QByteArray text = svg;
        return text.replace("#000", palette.color(group, QPalette::ButtonText).name().toLatin1());
    };
    for (const int pixels : {20, 40, 60}) {
        result.addPixmap(painted(coloured(QPalette::Active), pixels));
        result.addPixmap(painted(coloured(QPalette::Disabled), pixels), QIcon::Disabled);
    }
    return result;
}

QIcon programIcon() {
    const QByteArray svg = drawing(QStringLiteral("myoface"));
    QIcon result;
    if (!svg.isEmpty()) {
        for (const int pixels : {16, 32, 48, 64, 128, 256}) {
            result.addPixmap(painted(svg, pixels));
        }
    }
    return result;
}

}  // namespace myoface
