// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "myoface/cases/case_file.h"

namespace myoface {

/// Keeps on disk what the user does to a face, gesture by gesture, so that a crash, a kill or a
/// power cut loses nothing: a folder of its own with the face as it was opened and, beside it, the
/// state after the last finished gesture, replaced whole each time. The folder is locked while the
/// program lives; a folder without a lock was left behind. What is written of a protected face is
/// encrypted too, but for its file name and the time.
class Journal {
public:
    /// @param folder that holds the journals; made where it is missing @throws IoError
    Journal(const std::filesystem::path& folder, const OpenedFace& face);
    /// Leaves the journal behind unless finish() was called.
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// Once this returns, the state survives whatever happens. @throws IoError
    void record(const CaseState& state, const Landmarks& landmarks, const FitOptions& fit);
    /// Nothing needs recovering any more: removes everything.
    void finish();

private:
    std::filesystem::path own_;
    std::string name_;  ///< of the face
    std::string passphrase_;
    int lock_ = -1;
    int gestures_ = 0;
};

/// A face that a program left behind.
struct Recovery {
    std::filesystem::path folder;
    std::string name;     ///< of the face
    int gestures = 0;     ///< recorded
    std::string saved;    ///< when the last one was, local time
    bool locked = false;  ///< needs the passphrase of the face
};

/// Those in a folder of journals with something to recover, the latest first. Takes away what holds
/// nothing.
std::vector<Recovery> recoverable(const std::filesystem::path& folder);
/// The face as it was after the last finished gesture. @throws PassphraseNeeded, IoError
OpenedFace recover(const Recovery& recovery, const Progress* progress = nullptr,
                   const std::string& passphrase = {});
void discard(const Recovery& recovery);

}  // namespace myoface
