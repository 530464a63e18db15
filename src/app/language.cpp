// SPDX-License-Identifier: Apache-2.0
#include "language.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QTabBar>
#include <QTreeWidget>

#include "myoface/face/landmarks.h"

#include "sentences.h"

namespace myoface {
namespace {

/// The words of a widget that never change but with the language.
void change(QWidget& widget, const std::function<QString(const QString&)>& changed) {
    const auto set = [&](const QString& now, const auto& setter) {
        const QString wanted = changed(now);
        if (wanted != now) {
            setter(wanted);
        }
    };
    set(widget.toolTip(), [&](const QString& t) { widget.setToolTip(t); });
    set(widget.accessibleName(), [&](const QString& t) { widget.setAccessibleName(t); });
    set(widget.windowTitle(), [&](const QString& t) { widget.setWindowTitle(t); });
    if (auto* label = qobject_cast<QLabel*>(&widget)) {
        set(label->text(), [&](const QString& t) { label->setText(t); });
    } else if (auto* button = qobject_cast<QAbstractButton*>(&widget)) {
        set(button->text(), [&](const QString& t) { button->setText(t); });
    } else if (auto* group = qobject_cast<QGroupBox*>(&widget)) {
        set(group->title(), [&](const QString& t) { group->setTitle(t); });
    } else if (auto* menu = qobject_cast<QMenu*>(&widget)) {
        set(menu->title(), [&](const QString& t) { menu->setTitle(t); });
    } else if (auto* edit = qobject_cast<QLineEdit*>(&widget)) {
        set(edit->placeholderText(), [&](const QString& t) { edit->setPlaceholderText(t); });
    } else if (auto* spin = qobject_cast<QDoubleSpinBox*>(&widget)) {
        set(spin->suffix(), [&](const QString& t) { spin->setSuffix(t); });
    } else if (auto* combo = qobject_cast<QComboBox*>(&widget)) {
        for (int i = 0; i < combo->count(); ++i) {
            set(combo->itemText(i), [&](const QString& t) { combo->setItemText(i, t); });
        }
    } else if (auto* tabs = qobject_cast<QTabBar*>(&widget)) {
        for (int i = 0; i < tabs->count(); ++i) {
            set(tabs->tabText(i), [&](const QString& t) { tabs->setTabText(i, t); });
        }
    } else if (auto* tree = qobject_cast<QTreeWidget*>(&widget)) {
        for (int i = 0; i < tree->columnCount(); ++i) {
            QTreeWidgetItem* head = tree->headerItem();
            set(head->text(i), [&](const QString& t) { head->setText(i, t); });
        }
    }
    for (QAction* action : widget.actions()) {
        set(action->text(), [&](const QString& t) { action->setText(t); });
        set(action->toolTip(), [&](const QString& t) { action->setToolTip(t); });
    }
}

}  // namespace

Language& Language::instance() {
    static Language language;
    return language;
}

QString Language::translate(const char* context, const char* source, const char*, int) const {
    QString plain = QString::fromUtf8(context);
    plain.remove(QStringLiteral("myoface::"));
    return m_catalogue.find(plain, QString::fromUtf8(source));
}

void Language::changeWords(const QHash<QString, QString>& words) const {
    for (QWidget* widget : QApplication::allWidgets()) {
        change(*widget, [&](const QString& now) { return words.value(now, now); });
    }
}

void Language::choose(const QString& wanted) {
    QString code = wanted;
    if (code.isEmpty()) {
        code = QLocale::system().language() == QLocale::Japanese ? QStringLiteral("ja")
                                                                 : QStringLiteral("en");
    }
    if (code == m_code) {
        return;
    }
    QHash<QString, QString> back;  // to English first
    for (auto it = m_catalogue.words().cbegin(); it != m_catalogue.words().cend(); ++it) {
        back[it.value()] = it.key();
    }
    QCoreApplication::removeTranslator(this);
    m_code = code;
    m_catalogue = japanese() ? Catalogue(code) : Catalogue();
    QLocale::setDefault(japanese() ? QLocale(QLocale::Japanese, QLocale::Japan)
                                   : QLocale(QLocale::English));
    changeWords(back);
    changeWords(m_catalogue.words());
    if (!isEmpty()) {
        QCoreApplication::installTranslator(this);  // tells every widget
    } else {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            QEvent event(QEvent::LanguageChange);
            QCoreApplication::sendEvent(widget, &event);
        }
    }
}

QString inWords(const std::string& english) {
    QString word = QCoreApplication::translate(kCoreWords, english.c_str());
    if (!Language::instance().japanese() || word != QString::fromStdString(english)) {
        return word;
    }
    static const Catalogue catalogue(QStringLiteral("ja"));
    static const Sentences sentences(QStringLiteral("ja"), catalogue);
    return sentences.find(word);
}

QString landmarkInWords(const std::string& name) {
    const bool left = name.ends_with("_l");
    const bool right = name.ends_with("_r");
    const QString title =
        inWords(landmark_title(left || right ? name.substr(0, name.size() - 2) : name));
    return left    ? QCoreApplication::translate("MusclePanel", "%1, left").arg(title)
           : right ? QCoreApplication::translate("MusclePanel", "%1, right").arg(title)
                   : title;
}

}  // namespace myoface
