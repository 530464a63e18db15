// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/io/text_file.h"
#include "myoface/muscle/wrinkle.h"

namespace myoface {
namespace {

using json = nlohmann::json;

/// Points [x, y] lie wherever the head is met from the front: their depth is not a number.
Points line_from(const json& list) {
    Points line(3, static_cast<Eigen::Index>(list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        line(0, at) = list[i].at(0).get<double>();
        line(1, at) = list[i].at(1).get<double>();
        line(2, at) = list[i].size() > 2 ? list[i].at(2).get<double>()
                                         : std::numeric_limits<double>::quiet_NaN();
    }
    return line;
}

/// @param side Middle: the muscles of both sides
std::vector<int> muscles_from(const json& list, Side side) {
    std::vector<int> muscles;
    for (const json& name : list) {
        for (const int m : muscles_named(name.get<std::string>())) {
            const Side own = muscle_atlas()[static_cast<std::size_t>(m)].traits.side;
            if (side == Side::Middle || own == Side::Middle || own == side) {
                muscles.push_back(m);
            }
        }
    }
    return muscles;
}

void add_furrow(std::vector<FurrowTraits>& atlas, const json& entry) {
    FurrowTraits traits;
    traits.name = entry.at("id").get<std::string>();
    traits.group = entry.at("group").get<std::string>();
    traits.line = line_from(entry.at("line"));
    traits.width = entry.at("width_mm").get<double>();
    traits.share = entry.at("share").get<double>();
    traits.gauge = entry.at("gauge_mm").get<double>();
    traits.lean = entry.value("lean", 0.0);
    traits.first_age = entry.value("first_age", 0.0);
    traits.lip = entry.value("lip", 0);
    if (traits.line.cols() < 2 || !(traits.width > 0.0) || !(traits.gauge > 0.0)) {
        throw InvalidInput("furrow " + traits.name);
    }
    if (entry.at("side").get<std::string>() != "paired") {
        traits.muscles = muscles_from(entry.at("muscles"), Side::Middle);
        atlas.push_back(std::move(traits));
        return;
    }
    FurrowTraits right = traits;
    traits.name += ".L";
    traits.muscles = muscles_from(entry.at("muscles"), Side::Left);
    right.name += ".R";
    right.muscles = muscles_from(entry.at("muscles"), Side::Right);
    right.line.row(0) *= -1.0;
    right.lean *= -1.0;  // seen in a mirror, the other side of the line is ahead
    atlas.push_back(std::move(traits));
    atlas.push_back(std::move(right));
}

std::vector<FurrowTraits> load_furrows() {
    const json document =
        json::parse(read_file(resource_path("assets/wrinkles.json")), nullptr, false);
    try {
        std::vector<FurrowTraits> atlas;
        for (const json& entry : document.at("furrows")) {
            add_furrow(atlas, entry);
        }
        return atlas;
    } catch (const std::exception& error) {
        throw IoError(std::string("assets/wrinkles.json is damaged: ") + error.what());
    }
}

}  // namespace

const std::vector<FurrowTraits>& furrow_atlas() {
    static const std::vector<FurrowTraits> kAtlas = load_furrows();
    return kAtlas;
}

}  // namespace myoface
