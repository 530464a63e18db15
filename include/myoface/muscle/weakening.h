// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace myoface {

/// A ready set of weak muscles: what toxin does where it is usually given, or a facial palsy.
struct Weakening {
    std::string name;                               ///< "glabella", "palsy_4"
    std::string title;                              ///< English
    std::vector<std::pair<int, double>> strengths;  ///< muscle in the atlas' order, what is left
};

/// In the order to be shown. @throws IoError when the program's own table is damaged
/// @cite house_1985
const std::vector<Weakening>& weakening_presets();

/// A set by name; with .L or .R only that side. @throws InvalidInput that lists them
Weakening weakening_named(const std::string& name);

}  // namespace myoface
