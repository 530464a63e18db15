// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>

namespace myoface {

/// One of the program's own drawings (assets/icons), in the colour of the theme's text.
QIcon icon(const QString& name);
/// The program's sign.
QIcon programIcon();

}  // namespace myoface
