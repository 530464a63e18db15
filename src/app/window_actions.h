// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QMenu>

#include "icons.h"

namespace myoface {

inline constexpr const char* kIconName = "iconName";  ///< property of an action

/// An icon that is drawn again when the theme changes.
inline void setIcon(QAction* action, const QString& name) {
    action->setProperty(kIconName, name);
    action->setIcon(icon(name));
}

template <typename Call>
QAction* addTo(QMenu* menu, const QString& text, const QKeySequence& key, QObject* context,
               const Call& call, const QString& iconName = {}) {
    QAction* action = menu->addAction(text);
    action->setShortcut(key);
    QObject::connect(action, &QAction::triggered, context, call);
    if (!iconName.isEmpty()) {
        setIcon(action, iconName);
    }
    return action;
}

}  // namespace myoface
