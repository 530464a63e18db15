// SPDX-License-Identifier: Apache-2.0
#include "passphrase_dialog.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace myoface {
namespace {

constexpr int kShortest = 12;  // letters: anybody can try millions of shorter ones

class PassphraseWords {
    Q_DECLARE_TR_FUNCTIONS(PassphraseWords)
};

}  // namespace

std::optional<std::string> askPassphrase(QWidget* parent, const QString& sentence) {
    bool accepted = false;
    const QString text =
        QInputDialog::getText(parent, PassphraseWords::tr("Protected case"),
                              sentence + QLatin1Char('\n') + PassphraseWords::tr("Passphrase:"),
                              QLineEdit::Password, QString(), &accepted);
    return accepted && !text.isEmpty() ? std::optional(text.toStdString()) : std::nullopt;
}

std::optional<std::string> askNewPassphrase(QWidget* parent, bool hasOne) {
    QDialog dialog(parent);
    dialog.setWindowTitle(PassphraseWords::tr("Protect the case"));
    auto* layout = new QFormLayout(&dialog);
    auto* words = new QLabel(PassphraseWords::tr(
        "The case and what is kept for recovery are encrypted (AES-256) the next time they are "
        "written. Without the passphrase nobody can open them, not even you: keep it somewhere "
        "safe. Several words are better than a short riddle."));
    words->setWordWrap(true);
    words->setMinimumWidth(420);
    layout->addRow(words);
    auto* first = new QLineEdit;
    auto* second = new QLineEdit;
    first->setEchoMode(QLineEdit::Password);
    second->setEchoMode(QLineEdit::Password);
    layout->addRow(PassphraseWords::tr("Passphrase"), first);
    layout->addRow(PassphraseWords::tr("Once more"), second);
    auto* problem = new QLabel;
    layout->addRow(problem);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QPushButton* none = hasOne ? buttons->addButton(PassphraseWords::tr("No passphrase any more"),
                                                    QDialogButtonBox::DestructiveRole)
                               : nullptr;
    layout->addRow(buttons);
    bool removed = false;
    const auto check = [=] {
        const bool longEnough = first->text().size() >= kShortest;
        const bool same = first->text() == second->text();
        problem->setText(first->text().isEmpty() ? QString()
                         : !longEnough ? PassphraseWords::tr("At least %1 letters.").arg(kShortest)
                         : !same       ? PassphraseWords::tr("The two are not the same yet.")
                                       : QString());
        buttons->button(QDialogButtonBox::Ok)->setEnabled(longEnough && same);
    };
    QObject::connect(first, &QLineEdit::textChanged, &dialog, check);
    QObject::connect(second, &QLineEdit::textChanged, &dialog, check);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    if (none != nullptr) {
        QObject::connect(none, &QPushButton::clicked, &dialog, [&] {
            removed = true;
            dialog.accept();
        });
    }
    check();
    if (dialog.exec() != QDialog::Accepted) {
        return std::nullopt;
    }
    return removed ? std::string() : first->text().toStdString();
}

}  // namespace myoface
