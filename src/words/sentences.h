// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <QRegularExpression>
#include <QString>

#include "catalogue.h"

namespace myoface {

/// What the core library says about files, scans and gestures, in another language. The core puts
/// English sentences together from words and numbers; the context "sentences" of a translation file
/// has them with %1, %2 … in place of those. A file's name and a colon may stand before any of
/// them.
class Sentences {
public:
    /// @param catalogue of the same language, for the words in between; it must outlive this
    Sentences(const QString& code, const Catalogue& catalogue);

    /// The sentence translated, or as it is where it is not known.
    QString find(const QString& english) const;

private:
    struct Pattern {
        QRegularExpression english;
        QString translation;
        int words = 0;  ///< characters of English that are fixed: the more, the surer
    };
    /// Null where no pattern fits.
    QString known(const QString& english, int depth) const;

    const Catalogue& m_catalogue;
    std::vector<Pattern> m_patterns;
};

}  // namespace myoface
