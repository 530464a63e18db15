// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>

namespace myoface {

/// A calm dark look in which the face is the brightest thing.
void applyTheme(QApplication& application);

}  // namespace myoface
