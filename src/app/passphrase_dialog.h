// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <QWidget>

namespace myoface {

/// Asks for the passphrase of a case. @return nothing where it was left
std::optional<std::string> askPassphrase(QWidget* parent, const QString& sentence);
/// Asks for a new passphrase, twice. @return empty: none is wanted any more
std::optional<std::string> askNewPassphrase(QWidget* parent, bool hasOne);

}  // namespace myoface
