// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/expression.h"

#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/face/muscle_atlas.h"
#include "myoface/io/text_file.h"
#include "myoface/muscle/contraction.h"
#include "myoface/muscle/user_expressions.h"

namespace myoface {
namespace {

using json = nlohmann::json;

struct ExpressionTable {
    std::map<std::string, std::map<std::string, double>> action_units;
    std::vector<Expression> presets;
};

/// Puts an action unit's muscles, on the side its name asks for, into rates per muscle.
void collect(const ExpressionTable& table, const std::string& name, double intensity,
             std::map<int, double>& rates) {
    std::string unit = name;
    std::string side;
    const bool own = table.action_units.count(name) > 0;  // one that says itself what a side means
    if (!own && (unit.ends_with(".L") || unit.ends_with(".R"))) {
        side = unit.substr(unit.size() - 2);
        unit.resize(unit.size() - 2);
    }
    const auto found = table.action_units.find(unit);
    if (found == table.action_units.end()) {
        throw InvalidInput("There is no expression '" + name + "'.");
    }
    for (const auto& [muscle, rate] : found->second) {
        for (const int m : muscles_named(muscle)) {
            const MuscleTraits& traits = muscle_atlas()[static_cast<std::size_t>(m)].traits;
            if (side.empty() || traits.side == Side::Middle || traits.name.ends_with(side)) {
                rates[m] += intensity * rate;
            }
        }
    }
}

std::vector<std::pair<int, double>> as_list(const std::map<int, double>& rates) {
    std::vector<std::pair<int, double>> list;
    for (const auto& [muscle, rate] : rates) {
        list.emplace_back(muscle, std::min(rate, kMostContraction));
    }
    return list;
}

ExpressionTable load_expressions() {
    const json document =
        json::parse(read_file(resource_path("assets/expressions.json")), nullptr, false);
    try {
        ExpressionTable table;
        table.action_units =
            document.at("action_units").get<std::map<std::string, std::map<std::string, double>>>();
        for (const json& entry : document.at("presets")) {
            Expression preset;
            preset.name = entry.at("name").get<std::string>();
            preset.title = entry.at("title").get<std::string>();
            preset.title_ja = entry.at("title_ja").get<std::string>();
            std::map<int, double> rates;
            for (const auto& [unit, intensity] : entry.at("action_units").items()) {
                collect(table, unit, intensity.get<double>(), rates);
            }
            preset.rates = as_list(rates);
            table.presets.push_back(std::move(preset));
        }
        return table;
    } catch (const std::exception& error) {
        throw IoError(std::string("assets/expressions.json is damaged: ") + error.what());
    }
}

const ExpressionTable& table() {
    static const ExpressionTable kTable = load_expressions();
    return kTable;
}

}  // namespace

const std::vector<Expression>& expression_presets() {
    return table().presets;
}

bool is_own_expression(const std::string& name) {
    std::map<int, double> rates;
    try {
        collect(table(), name, 1.0, rates);
        return true;
    } catch (const InvalidInput&) {
        return std::any_of(table().presets.begin(), table().presets.end(),
                           [&](const Expression& preset) { return preset.name == name; });
    }
}

char intensity_letter(double intensity) {
    return intensity <= 0.0    ? ' '
           : intensity <= 0.15 ? 'A'
           : intensity <= 0.35 ? 'B'
           : intensity <= 0.65 ? 'C'
           : intensity <= 0.90 ? 'D'
                               : 'E';
}

double intensity_of(char letter) {
    return letter == 'A'   ? 0.1
           : letter == 'B' ? 0.25
           : letter == 'C' ? 0.5
           : letter == 'D' ? 0.8
                           : 1.0;
}

Expression expression_named(const std::string& name) {
    for (const Expression& preset : table().presets) {
        if (preset.name == name) {
            return preset;
        }
    }
    for (const Expression& preset : user_expressions()) {
        if (preset.name == name) {
            return preset;
        }
    }
    std::map<int, double> rates;
    try {
        collect(table(), name, 1.0, rates);
    } catch (const InvalidInput&) {
        std::string known;
        for (const Expression& preset : table().presets) {
            known += preset.name + ' ';
        }
        throw InvalidInput("There is no expression '" + name + "'; there are " + known +
                           "and action units such as AU12 or AU12.L.");
    }
    return {name, name, name, as_list(rates)};
}

void add_expression(std::vector<double>& rates, const Expression& expression, double intensity) {
    for (const auto& [muscle, rate] : expression.rates) {
        double& sum = rates[static_cast<std::size_t>(muscle)];
        sum = std::clamp(sum + intensity * rate, kLeastContraction, kMostContraction);
    }
}

}  // namespace myoface
