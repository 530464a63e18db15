// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include <QObject>
#include <QThread>
#include <QTimer>

#include "myoface/cases/journal.h"

#include "face_document.h"

namespace myoface {

/// Writes every finished gesture down in a thread of its own, so that nothing is lost when the
/// program or the machine ends in the middle.
class JournalKeeper final : public QObject {
    Q_OBJECT

public:
    JournalKeeper(FaceDocument& document, std::filesystem::path folder, QObject* parent = nullptr);
    ~JournalKeeper() override;
    JournalKeeper(const JournalKeeper&) = delete;
    JournalKeeper& operator=(const JournalKeeper&) = delete;

    const std::filesystem::path& folder() const { return m_folder; }
    /// Writes the state down now, though nothing was done here yet: of a recovered face.
    void noteNow() { note(); }
    /// What was done is safe elsewhere, or not wanted: takes the journal away.
    void finish();
    /// Waits until everything noted is on the disk.
    void flush();

    /// Where this user's journals are kept.
    static std::filesystem::path usualFolder();

Q_SIGNALS:
    void problem(const QString& sentence);

private:
    void note();

    FaceDocument& m_document;
    std::filesystem::path m_folder;
    QThread m_thread;
    QObject m_inThread;                  ///< lives in m_thread
    std::shared_ptr<Journal> m_journal;  ///< only used there
    QTimer m_notes;                      ///< typing is a gesture once it pauses
    bool m_told = false;
};

}  // namespace myoface
