// SPDX-License-Identifier: Apache-2.0
#include "sentences.h"

#include <algorithm>

#include <QXmlStreamReader>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

constexpr int kDeepest = 3;  // sentences within sentences

}  // namespace

Sentences::Sentences(const QString& code, const Catalogue& catalogue) : m_catalogue(catalogue) {
    std::string bytes;
    try {
        bytes = read_file(resource_path("assets/i18n/myoface_" + code.toStdString() + ".ts"));
    } catch (const Error&) {
        return;  // English
    }
    static const QRegularExpression kPlace(QStringLiteral("%(\\d)"));
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
        } else if (xml.name() == QLatin1String("translation") &&
                   context == QLatin1String("sentences")) {
            QString pattern;
            int from = 0;
            Pattern entry;
            for (auto it = kPlace.globalMatch(source); it.hasNext();) {
                const QRegularExpressionMatch place = it.next();
                const QString fixed = source.mid(from, place.capturedStart() - from);
                entry.words += fixed.size();
                pattern += QRegularExpression::escape(fixed) + QStringLiteral("(.*?)");
                from = place.capturedEnd();
            }
            entry.words += source.size() - from;
            pattern += QRegularExpression::escape(source.mid(from));
            entry.english.setPattern(QLatin1Char('^') + pattern + QLatin1Char('$'));
            entry.english.setPatternOptions(QRegularExpression::DotMatchesEverythingOption);
            entry.translation = xml.readElementText();
            if (!entry.translation.isEmpty()) {
                m_patterns.push_back(std::move(entry));
            }
        }
    }
    std::stable_sort(m_patterns.begin(), m_patterns.end(),
                     [](const Pattern& a, const Pattern& b) { return a.words > b.words; });
}

QString Sentences::known(const QString& english, int depth) const {
    QString word = m_catalogue.find(QString::fromLatin1(kCoreWords), english);
    if (!word.isEmpty() || depth > kDeepest) {
        return word;
    }
    for (const Pattern& pattern : m_patterns) {
        const QRegularExpressionMatch match = pattern.english.match(english);
        if (!match.hasMatch()) {
            continue;
        }
        QString text;  // put in at once, so that a value with % in it stays as it is
        for (int i = 0; i < pattern.translation.size(); ++i) {
            const QChar c = pattern.translation[i];
            const QChar next =
                i + 1 < pattern.translation.size() ? pattern.translation[i + 1] : QChar();
            if (c == QLatin1Char('%') && next.isDigit()) {
                const QString value = match.captured(next.digitValue());
                const QString translated = known(value, depth + 1);
                text += translated.isEmpty() ? value : translated;
                ++i;
            } else {
                text += c;
            }
        }
        return text;
    }
    return {};
}

QString Sentences::find(const QString& english) const {
    QString whole = known(english, 0);
    if (!whole.isEmpty()) {
        return whole;
    }
    // The name of a file first, and perhaps the place in it.
    for (int colon = english.indexOf(QLatin1String(": ")); colon > 0;
         colon = english.indexOf(QLatin1String(": "), colon + 1)) {
        const QString rest = known(english.mid(colon + 2), 0);
        if (!rest.isEmpty()) {
            return english.left(colon) + QStringLiteral("：") + rest;
        }
    }
    return english;
}

}  // namespace myoface
