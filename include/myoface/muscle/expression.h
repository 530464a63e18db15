// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace myoface {

/// A combination of muscles at full intensity: an action unit of the Facial Action Coding System or
/// a preset made of several.
struct Expression {
    std::string name;  ///< "joy", "AU12", "AU12.L"
    std::string title, title_ja;
    std::vector<std::pair<int, double>> rates;  ///< muscle in the atlas' order, contraction
};

/// The presets that come with the program, in the order to be shown.
/// @throws IoError when the program's own table is damaged
const std::vector<Expression>& expression_presets();

/// Whether a preset or action unit of that name comes with the program.
bool is_own_expression(const std::string& name);

/// A preset, one of the user's own, or an action unit; of an action unit one side with .L or .R.
/// @throws InvalidInput for an unknown name, saying what there is
Expression expression_named(const std::string& name);

/// Strength of an action unit by the letters of the Facial Action Coding System: A trace … E most.
/// @param intensity 0 … 1; nothing has no letter
char intensity_letter(double intensity);
/// In the middle of a letter's range; 1 for E. @cite ekman_facs
double intensity_of(char letter);

/// Adds an expression to contractions, held between rest and full. @param intensity 0 … 1
void add_expression(std::vector<double>& rates, const Expression& expression, double intensity);

}  // namespace myoface
