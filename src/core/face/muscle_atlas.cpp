// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/muscle_atlas.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

using nlohmann::json;

Points points_of(const json& list) {
    Points points(3, static_cast<Eigen::Index>(list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            points(axis, static_cast<Eigen::Index>(i)) =
                list[i].at(static_cast<std::size_t>(axis)).get<double>();
        }
    }
    constexpr double kHead = 1000.0;  // [mm] No part of one is further out.
    if (!(points.cwiseAbs().array() < kHead).all()) {
        throw IoError("a point lies outside every head");
    }
    return points;
}

AtlasMuscle parse_muscle(const json& entry) {
    static const std::map<std::string, MuscleZone> kZones{{"all", MuscleZone::All},
                                                          {"upper_lip", MuscleZone::UpperLip},
                                                          {"lower_lip", MuscleZone::LowerLip},
                                                          {"brow", MuscleZone::Brow},
                                                          {"nose", MuscleZone::Nose}};
    static const std::map<std::string, MuscleKind> kKinds{{"linear", MuscleKind::Linear},
                                                          {"sheet", MuscleKind::Sheet},
                                                          {"sphincter", MuscleKind::Sphincter},
                                                          {"volume", MuscleKind::Volume}};
    static const std::map<std::string, MuscleAction> kActions{
        {"close_lids", MuscleAction::CloseLids},
        {"raise_lid", MuscleAction::RaiseLid},
        {"bulge", MuscleAction::Bulge},
        {"open_jaw", MuscleAction::OpenJaw},
        {"shift_jaw", MuscleAction::ShiftJaw}};
    AtlasMuscle muscle;
    MuscleTraits& t = muscle.traits;
    t.base_name = t.name = entry.at("id").get<std::string>();
    t.title = entry.at("title").get<std::string>();
    t.title_ja = entry.at("title_ja").get<std::string>();
    t.group = entry.at("group").get<std::string>();
    t.action_unit = entry.at("action_unit").get<std::string>();
    t.kind = kKinds.at(entry.at("kind").get<std::string>());
    t.action = t.kind == MuscleKind::Sphincter ? MuscleAction::Purse : MuscleAction::Pull;
    if (entry.contains("action")) {
        t.action = kActions.at(entry.at("action").get<std::string>());
    }
    for (const auto& [field, text] : {std::pair<const char*, std::string*>{"latin", &t.latin},
                                      {"nerve", &t.nerve},
                                      {"origin", &t.origin},
                                      {"insertion", &t.insertion},
                                      {"does", &t.does},
                                      {"does_ja", &t.does_ja},
                                      {"note", &t.note},
                                      {"note_ja", &t.note_ja}}) {
        *text = entry.at(field).get<std::string>();
    }
    muscle.deep = entry.value("deep", false);
    muscle.traits.shares_mouth = entry.value("shares_mouth", false);
    if (entry.contains("depth_share")) {
        muscle.origin_depth = entry.at("depth_share").at(0).get<double>();
        muscle.insertion_depth = entry.at("depth_share").at(1).get<double>();
    }
    t.zone = kZones.at(entry.at("zone").get<std::string>());
    if (t.action == MuscleAction::Pull) {
        t.half_angle = entry.at("half_angle_deg").get<double>() * std::numbers::pi / 180.0;
        t.falloff_start = entry.at("falloff_start").get<double>();
        t.falloff_end = entry.at("falloff_end").get<double>();
    }
    t.forward = entry.value("forward", 0.0);
    t.rise = entry.value("rise", 0.0);
    if (entry.contains("across")) {
        t.across_above = entry["across"].at(0).get<double>();
        t.across_below = entry["across"].at(1).get<double>();
    }
    if (entry.contains("reach")) {
        t.reach_wide = entry["reach"].at(0).get<double>();
        t.reach_high = entry["reach"].at(1).get<double>();
    }
    t.breadth = entry.at("breadth_mm").get<double>();
    t.pull = entry.at("pull_mm").get<double>();
    t.strength = entry.at("strength_N").get<double>();
    t.gain = entry.at("gain").get<double>();
    muscle.path = points_of(entry.at("path"));
    if (entry.contains("edges")) {
        for (const json& edge : entry.at("edges")) {
            muscle.edges.push_back(points_of(edge));
        }
    }
    if (muscle.path.cols() < 2) {
        throw IoError("assets/muscles.json: " + t.name + " has no path.");
    }
    return muscle;
}

AtlasMuscle on_side(const AtlasMuscle& left, Side side) {
    AtlasMuscle muscle = left;
    muscle.traits.side = side;
    muscle.traits.name += side == Side::Left ? ".L" : ".R";
    if (side == Side::Right) {
        muscle.path.row(0) *= -1.0;
        for (Points& edge : muscle.edges) {
            edge.row(0) *= -1.0;
        }
        if (muscle.traits.kind == MuscleKind::Sphincter) {
            muscle.path = muscle.path.rowwise().reverse().eval();  // same sense of turning
        }
    }
    return muscle;
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
            diagonal = above;
        }
    }
    return row.back();
}

}  // namespace

MuscleAtlas muscle_atlas_from_json(std::string_view text) {
    const json document = json::parse(text, nullptr, false);
    try {
        MuscleAtlas atlas;
        for (const json& entry : document.at("muscles")) {
            const AtlasMuscle muscle = parse_muscle(entry);
            if (entry.at("side") == "paired") {
                atlas.push_back(on_side(muscle, Side::Left));
                atlas.push_back(on_side(muscle, Side::Right));
            } else {
                atlas.push_back(muscle);
            }
        }
        return atlas;
    } catch (const std::exception& error) {
        throw IoError(std::string("assets/muscles.json is damaged: ") + error.what());
    }
}

const MuscleAtlas& muscle_atlas() {
    static const MuscleAtlas kAtlas =
        muscle_atlas_from_json(read_file(resource_path("assets/muscles.json")));
    return kAtlas;
}

std::vector<int> muscles_named(const std::string& name) {
    const MuscleAtlas& atlas = muscle_atlas();
    std::vector<int> found;
    for (std::size_t m = 0; m < atlas.size(); ++m) {
        if (name == atlas[m].traits.name || name == atlas[m].traits.base_name) {
            found.push_back(static_cast<int>(m));
        }
    }
    if (!found.empty()) {
        return found;
    }
    const auto nearest =
        std::min_element(atlas.begin(), atlas.end(), [&](const auto& p, const auto& q) {
            return edit_distance(name, p.traits.base_name) <
                   edit_distance(name, q.traits.base_name);
        });
    throw InvalidInput("There is no muscle '" + name + "'; the nearest name is '" +
                       nearest->traits.base_name + "' (with .L or .R for one side).");
}

}  // namespace myoface
