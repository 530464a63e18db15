// SPDX-License-Identifier: Apache-2.0
#include "catalogue.h"

#include <QXmlStreamReader>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/io/text_file.h"

namespace myoface {

Catalogue::Catalogue(const QString& code) {
    std::string bytes;
    try {
        bytes = read_file(resource_path("assets/i18n/myoface_" + code.toStdString() + ".ts"));
    } catch (const Error&) {
        return;  // English
    }
    QXmlStreamReader xml(QByteArray::fromStdString(bytes));
    QString context;
    QString source;
    while (!xml.atEnd()) {
        if (!xml.readNextStartElement()) {
            continue;
        }
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("source")) {
            source = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            const QString translation = xml.readElementText();
            if (!translation.isEmpty()) {
                m_texts[context + QLatin1Char('|') + source] = translation;
                m_words[source] = translation;
            }
        }
    }
}

QString Catalogue::find(const QString& context, const QString& source) const {
    return m_texts.value(context + QLatin1Char('|') + source);
}

}  // namespace myoface
