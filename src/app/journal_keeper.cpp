// SPDX-License-Identifier: Apache-2.0
#include "journal_keeper.h"

#include <utility>

#include <QStandardPaths>

#include "myoface/base/error.h"

namespace myoface {

JournalKeeper::JournalKeeper(FaceDocument& document, std::filesystem::path folder, QObject* parent)
    : QObject(parent), m_document(document), m_folder(std::move(folder)) {
    m_inThread.moveToThread(&m_thread);
    m_thread.start();
    connect(document.undoStack(), &QUndoStack::indexChanged, this, [this] {
        // Opening a face clears the history, which is no gesture.
        if (m_document.opened() && m_document.undoStack()->count() > 0) {
            note();
        }
    });
    connect(&document, &FaceDocument::faceChanged, this, &JournalKeeper::finish);
    connect(&document, &FaceDocument::passphraseChanged, this, [this] {
        if (m_document.undoStack()->count() > 0) {
            finish();  // what is there is protected otherwise
            note();
        }
    });
    m_notes.setSingleShot(true);
    m_notes.setInterval(700);
    connect(&document, &FaceDocument::notesChanged, &m_notes, QOverload<>::of(&QTimer::start));
    connect(&m_notes, &QTimer::timeout, this, &JournalKeeper::note);
}

JournalKeeper::~JournalKeeper() {
    flush();
    m_thread.quit();
    m_thread.wait();
}

std::filesystem::path JournalKeeper::usualFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString() +
           "/journals";
}

void JournalKeeper::note() {
    QMetaObject::invokeMethod(
        &m_inThread,
        [this, edits = m_document.edits(), opened = m_document.opened(),
         passphrase = m_document.passphrase()] {
            try {
                if (!m_journal) {
                    OpenedFace face = *opened;
                    face.passphrase = passphrase;
                    m_journal = std::make_shared<Journal>(m_folder, face);
                }
                m_journal->record(stateOf(edits), edits.landmarks, edits.fit);
            } catch (const std::exception& error) {
                if (!std::exchange(m_told, true)) {  // once is enough
                    Q_EMIT problem(QString::fromUtf8(error.what()));
                }
            }
        },
        Qt::QueuedConnection);
}

void JournalKeeper::finish() {
    m_notes.stop();
    QMetaObject::invokeMethod(
        &m_inThread,
        [this] {
            if (m_journal) {
                m_journal->finish();
                m_journal.reset();
            }
        },
        Qt::QueuedConnection);
}

void JournalKeeper::flush() {
    if (m_thread.isRunning()) {
        QMetaObject::invokeMethod(
            &m_inThread, [] {}, Qt::BlockingQueuedConnection);
    }
}

}  // namespace myoface
