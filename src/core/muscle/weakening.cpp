// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/weakening.h"

#include <map>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/face/muscle_atlas.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

using nlohmann::json;

/// Muscles of the facial nerve: the others chew and lift the lid.
bool of_facial_nerve(const MuscleTraits& traits) {
    return traits.nerve.find('(') == std::string::npos;  // others are named with their number
}

std::vector<Weakening> load_weakenings() {
    const json document =
        json::parse(read_file(resource_path("assets/weakening.json")), nullptr, false);
    try {
        std::vector<Weakening> presets;
        for (const json& entry : document.at("presets")) {
            Weakening preset;
            preset.name = entry.at("name").get<std::string>();
            preset.title = entry.at("title").get<std::string>();
            std::map<int, double> strengths;
            const json& muscles = entry.at("muscles");
            if (muscles.contains("*")) {
                for (std::size_t m = 0; m < muscle_atlas().size(); ++m) {
                    if (of_facial_nerve(muscle_atlas()[m].traits)) {
                        strengths[static_cast<int>(m)] = muscles["*"].get<double>();
                    }
                }
            }
            for (const auto& [muscle, strength] : muscles.items()) {
                if (muscle != "*") {
                    for (const int m : muscles_named(muscle)) {
                        strengths[m] = strength.get<double>();
                    }
                }
            }
            preset.strengths.assign(strengths.begin(), strengths.end());
            presets.push_back(std::move(preset));
        }
        return presets;
    } catch (const std::exception& error) {
        throw IoError(std::string("assets/weakening.json is damaged: ") + error.what());
    }
}

}  // namespace

const std::vector<Weakening>& weakening_presets() {
    static const std::vector<Weakening> kPresets = load_weakenings();
    return kPresets;
}

Weakening weakening_named(const std::string& name) {
    std::string plain = name;
    std::string side;
    if (name.ends_with(".L") || name.ends_with(".R")) {
        side = name.substr(name.size() - 2);
        plain.resize(name.size() - 2);
    }
    std::string known;
    for (const Weakening& preset : weakening_presets()) {
        if (preset.name == plain) {
            Weakening result = preset;
            std::erase_if(result.strengths, [&](const auto& entry) {
                const MuscleTraits& traits =
                    muscle_atlas()[static_cast<std::size_t>(entry.first)].traits;
                // A palsy of one side leaves half of a muscle in the middle to the other.
                return !side.empty() && traits.side != Side::Middle && !traits.name.ends_with(side);
            });
            if (!side.empty()) {
                for (auto& [muscle, strength] : result.strengths) {
                    if (muscle_atlas()[static_cast<std::size_t>(muscle)].traits.side ==
                        Side::Middle) {
                        strength = 0.5 * (1.0 + strength);
                    }
                }
            }
            return result;
        }
        known += (known.empty() ? "" : ", ") + preset.name;
    }
    throw InvalidInput("There is no weakening '" + name + "'; there are " + known +
                       ", each also with .L or .R.");
}

}  // namespace myoface
