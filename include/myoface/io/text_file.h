// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace myoface {

/// The whole file. @throws IoError "FILE: cannot be opened / is a folder / is empty."
std::string read_file(const std::filesystem::path& file);

/// Whether a file that was written is also on the disk when power fails a moment later.
enum class Durability { Usual, SurvivesPowerLoss };

/// Writes beside the target under another name, then renames: the file is whole or unchanged.
/// @throws IoError that says why it cannot be written
void write_file(const std::filesystem::path& file, std::string_view content,
                Durability durability = Durability::Usual);

/// A number as the shortest text that reads back to the same value, independent of the locale.
void append_number(std::string& text, double value);

}  // namespace myoface
