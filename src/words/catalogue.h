// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QString>

namespace myoface {

/// Translations of one language, from assets/i18n/myoface_CODE.ts in the form of Qt Linguist.
/// English stands in the code and has no file.
class Catalogue {
public:
    Catalogue() = default;
    /// Empty where there is no such file.
    explicit Catalogue(const QString& code);

    bool isEmpty() const { return m_texts.isEmpty(); }
    /// The translation, or nothing.
    QString find(const QString& context, const QString& source) const;
    /// Source -> translation, whatever the context.
    const QHash<QString, QString>& words() const { return m_words; }

private:
    QHash<QString, QString> m_texts;  ///< context, a bar and source -> translation
    QHash<QString, QString> m_words;
};

/// Context of the words that come from the core library.
inline const char* const kCoreWords = "core";

}  // namespace myoface
