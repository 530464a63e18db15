// SPDX-License-Identifier: Apache-2.0
#include "action_search.h"

#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QTimer>
#include <QVBoxLayout>

namespace myoface {
namespace {

void collect(const QList<QAction*>& actions, std::vector<QAction*>& into) {
    for (QAction* action : actions) {
        if (action->menu() != nullptr) {
            Q_EMIT action->menu()->aboutToShow();  // lists that are filled when they open
            collect(action->menu()->actions(), into);
        } else if (!action->isSeparator() && !action->text().isEmpty()) {
            into.push_back(action);
        }
    }
}

}  // namespace

QString plainText(const QAction& action) {
    QString text = action.text();
    return text.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
}

std::vector<QAction*> actionsOf(const QWidget& window) {
    std::vector<QAction*> actions;
    for (const QMenuBar* bar : window.findChildren<QMenuBar*>()) {
        collect(bar->actions(), actions);
    }
    return actions;
}

ActionSearch::ActionSearch(const std::vector<QAction*>& actions, QWidget* parent)
    : QDialog(parent, Qt::Popup), m_actions(actions) {
    setAttribute(Qt::WA_DeleteOnClose);
    setAccessibleName(tr("Find an action"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 10, 10);
    m_text = new QLineEdit;
    m_text->setPlaceholderText(tr("What do you want to do?"));
    m_text->setClearButtonEnabled(true);
    m_list = new QListWidget;
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setFocusPolicy(Qt::NoFocus);
    column->addWidget(m_text);
    column->addWidget(m_list);
    m_text->installEventFilter(this);
    connect(m_text, &QLineEdit::textChanged, this, &ActionSearch::filter);
    connect(m_text, &QLineEdit::returnPressed, this, &ActionSearch::run);
    connect(m_list, &QListWidget::itemClicked, this, &ActionSearch::run);
    resize(440, 340);
    if (parent != nullptr) {
        move(parent->mapToGlobal(QPoint((parent->width() - width()) / 2, 110)));
    }
    filter({});
    m_text->setFocus();
}

void ActionSearch::filter(const QString& text) {
    m_list->clear();
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (std::size_t i = 0; i < m_actions.size(); ++i) {
        const QAction& action = *m_actions[i];
        const QString title = plainText(action);
        const QString all = title + QLatin1Char(' ') + action.toolTip();
        const bool found = std::all_of(words.begin(), words.end(), [&](const QString& word) {
            return all.contains(word, Qt::CaseInsensitive);
        });
        if (found && action.isEnabled()) {
            const QString key = action.shortcut().toString(QKeySequence::NativeText);
            auto* item = new QListWidgetItem(
                key.isEmpty() ? title : title + QStringLiteral("     ") + key, m_list);
            item->setData(Qt::UserRole, static_cast<int>(i));
        }
    }
    m_list->setCurrentRow(0);
}

void ActionSearch::run() {
    const QListWidgetItem* item = m_list->currentItem();
    if (item == nullptr) {
        return;
    }
    QAction* action = m_actions[static_cast<std::size_t>(item->data(Qt::UserRole).toInt())];
    close();
    QTimer::singleShot(0, action, &QAction::trigger);  // with the keyboard back in the window
}

bool ActionSearch::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_text && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const int step = key->key() == Qt::Key_Down ? 1 : key->key() == Qt::Key_Up ? -1 : 0;
        if (step != 0) {
            m_list->setCurrentRow(qBound(0, m_list->currentRow() + step, m_list->count() - 1));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

}  // namespace myoface
