// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "myoface/muscle/expression.h"

namespace myoface {

/// Where presets of the user's own are kept, one JSON file each: MYOFACE_EXPRESSIONS, else
/// myoface/expressions in the user's data folder (XDG_DATA_HOME, ~/.local/share, %APPDATA%).
std::filesystem::path user_expression_folder();

/// A preset as such a file holds it. @param name of the file, for the sentence
/// @throws IoError when it is damaged or names what is no muscle
Expression user_expression_from_json(std::string_view text, const std::string& name);

/// All of them by name; files that are damaged are left out. Read anew at each call.
std::vector<Expression> user_expressions();

/// Keeps contractions as a preset that expression_named() knows; one of that name is replaced.
/// @param rates in the atlas' order, −0.5 … 1
/// @throws InvalidInput for a name that is empty, too long, has '=' or a control character, or is a
/// preset or action unit of the program; IoError when it cannot be written
void save_user_expression(const std::string& name, const std::vector<double>& rates);

/// @throws InvalidInput when there is none of that name; IoError when it cannot be removed
void remove_user_expression(const std::string& name);

}  // namespace myoface
