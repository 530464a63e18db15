// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <QTranslator>

#include "catalogue.h"

namespace myoface {

/// The language of the interface, changed while the program runs. Translations stand in
/// assets/i18n/myoface_CODE.ts, in the form of Qt Linguist; English stands in the code.
class Language final : public QTranslator {
    Q_OBJECT

public:
    /// The one of this program.
    static Language& instance();

    /// "en", "ja", or "" for the system's. An unknown one is English. Widgets that are there change
    /// their fixed words at once; those that put words together do so on QEvent::LanguageChange.
    void choose(const QString& code);
    const QString& code() const { return m_code; }
    bool japanese() const { return m_code == QLatin1String("ja"); }

    QString translate(const char* context, const char* source, const char* disambiguation,
                      int n) const override;
    bool isEmpty() const override { return m_catalogue.isEmpty(); }

private:
    Language() = default;
    void changeWords(const QHash<QString, QString>& words) const;

    QString m_code = QStringLiteral("en");
    Catalogue m_catalogue;
};

/// English words of the core library, in the language of the interface.
QString inWords(const std::string& english);
/// Title of a landmark, with its side.
QString landmarkInWords(const std::string& name);

}  // namespace myoface
