// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace myoface::test {

enum class BadKind { Case, Plan, Landmarks, Journal };

/// A file of ours that is broken, spoiled or lies, and what must be said of it.
struct BadFile {
    BadKind kind = BadKind::Case;
    std::string name;
    std::string bytes;
    std::string says;  ///< within the sentence that refuses it
};

/// More than 150 cases, plans, landmark files and journals, each bad in its own way.
std::vector<BadFile> bad_files();

/// Good ones: seeds of the fuzz targets, from which the bad ones are made.
std::string good_case(const std::string& passphrase = {});
std::string good_plan();
std::string good_landmarks();
std::string good_journal();
/// What good_case() holds, as the fuzz target for cases takes it apart.
std::string good_case_parts();
/// The body of a journal's record with its head and the right sum.
std::string journal_record(const std::string& body);

}  // namespace myoface::test
