// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QVBoxLayout>
#include <QWidget>

namespace myoface {

/// Gives a panel a column that scrolls when the window is low. @return where its contents go
QVBoxLayout* scrollingColumn(QWidget& panel);

}  // namespace myoface
