// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <QAction>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>

namespace myoface {

/// Everything a window can do, found by typing: Enter does it.
class ActionSearch final : public QDialog {
    Q_OBJECT

public:
    ActionSearch(const std::vector<QAction*>& actions, QWidget* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter(const QString& text);
    void run();

    std::vector<QAction*> m_actions;
    QLineEdit* m_text = nullptr;
    QListWidget* m_list = nullptr;
};

/// All actions of a window that do something and have words, menus before tool bars.
std::vector<QAction*> actionsOf(const QWidget& window);
/// Words of an action without marks for the keyboard.
QString plainText(const QAction& action);

}  // namespace myoface
