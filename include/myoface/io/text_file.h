// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace myoface {

/// The whole file. @throws IoError "FILE: cannot be opened / is a folder / is empty."
std::string read_file(const std::filesystem::path& file);

/// Writes beside the target under another name, then renames: the file is whole or unchanged.
/// @throws IoError
void write_file(const std::filesystem::path& file, std::string_view content);

/// A number as the shortest text that reads back to the same value, independent of the locale.
void append_number(std::string& text, double value);

}  // namespace myoface
