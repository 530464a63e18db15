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
    std::vector<std::pair<int, double>> rates;  ///< muscle in the atlas' order, contraction 0 … 1
};

/// The presets that come with the program, in the order to be shown.
/// @throws IoError when the program's own table is damaged
const std::vector<Expression>& expression_presets();

/// A preset or an action unit; of an action unit one side with .L or .R.
/// @throws InvalidInput for an unknown name, saying what there is
Expression expression_named(const std::string& name);

/// Adds an expression to contractions, held between rest and full. @param intensity 0 … 1
void add_expression(std::vector<double>& rates, const Expression& expression, double intensity);

}  // namespace myoface
