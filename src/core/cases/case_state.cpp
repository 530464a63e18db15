// SPDX-License-Identifier: Apache-2.0
#include "myoface/cases/case_state.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"

namespace myoface {
namespace {

using nlohmann::json;

constexpr std::size_t kMostVariants = 200;

/// Only what moved: how many there are, then number and value of each that is not zero.
std::string sparse(const Points& values) {
    std::vector<std::int64_t> which;
    for (Eigen::Index v = 0; v < values.cols(); ++v) {
        if (!values.col(v).isZero(0.0)) {
            which.push_back(v);
        }
    }
    std::string bytes;
    const auto put = [&](const void* data, std::size_t size) {
        bytes.append(static_cast<const char*>(data), size);
    };
    const std::int64_t all = values.cols();
    put(&all, sizeof all);
    for (const std::int64_t v : which) {
        put(&v, sizeof v);
        put(values.col(v).data(), 3 * sizeof(double));
    }
    return bytes;
}

Points dense(const std::string& bytes, std::int64_t vertices, const std::string& name) {
    constexpr std::size_t kEntry = sizeof(std::int64_t) + 3 * sizeof(double);
    const auto damaged = [&] { return IoError(name + ": the shape of the skin is damaged."); };
    if (bytes.empty()) {
        return Points(3, 0);
    }
    std::int64_t all = 0;
    if (bytes.size() < sizeof all || (bytes.size() - sizeof all) % kEntry != 0) {
        throw damaged();
    }
    std::memcpy(&all, bytes.data(), sizeof all);
    const auto count = static_cast<std::int64_t>((bytes.size() - sizeof all) / kEntry);
    if (all < 0 || count > all) {
        throw damaged();
    }
    if (all > vertices) {
        throw IoError(name + ": the shape of the skin belongs to a larger scan.");
    }
    Points values = Points::Zero(3, all);
    for (const char* at = bytes.data() + sizeof all; at < bytes.data() + bytes.size();
         at += kEntry) {
        std::int64_t v = 0;
        std::memcpy(&v, at, sizeof v);
        if (v < 0 || v >= all) {
            throw damaged();
        }
        std::memcpy(values.col(v).data(), at + sizeof v, 3 * sizeof(double));
    }
    if (!values.allFinite()) {
        throw damaged();
    }
    return values;
}

std::map<std::string, double> settings(const json& object, const char* key, double least,
                                       double most, const std::string& name) {
    std::map<std::string, double> result;
    if (!object.contains(key)) {
        return result;
    }
    if (!object[key].is_object()) {
        throw IoError(name + ": \"" + key + "\" is damaged.");
    }
    for (const auto& [muscle, value] : object[key].items()) {
        const double number = value.is_number() ? value.get<double>() : most + 1.0;
        if (!(number >= least && number <= most)) {
            throw IoError(name + ": the setting of " + muscle + " is out of range.");
        }
        result[muscle] = number;
    }
    return result;
}

std::string state_text(const json& object, const char* key, const std::string& name) {
    if (!object.contains(key)) {
        return {};
    }
    if (!object[key].is_string()) {
        throw IoError(name + ": \"" + key + "\" is no text.");
    }
    return object[key].get<std::string>();
}

double skin_age_of(const json& object, const std::string& name) {
    if (!object.contains("skin_age")) {
        return kUsualSkin;
    }
    const json& value = object["skin_age"];
    const double years = value.is_number() ? value.get<double>() : 0.0;
    if (!(years >= kYoungestSkin && years <= kOldestSkin)) {
        throw IoError(name + ": the skin's age is out of range.");
    }
    return years;
}

std::string variant_part(std::size_t number) {
    return "variant-" + std::to_string(number);
}

}  // namespace

CaseState case_state(const FaceModel& face, const Contractions& contractions,
                     const Points& skin_rest) {
    CaseState state;
    for (std::size_t m = 0; m < face.muscles.size(); ++m) {
        const std::string& name = face.muscles[m].traits.name;
        if (contractions.rate[m] != 0.0) {
            state.rates[name] = contractions.rate[m];
        }
        if (contractions.strength[m] != 1.0) {
            state.strengths[name] = contractions.strength[m];
        }
    }
    state.shape = shape_of_scan(face, skin_rest);
    return state;
}

Contractions contractions_of(const FaceModel& face, const std::map<std::string, double>& rates,
                             const std::map<std::string, double>& strengths) {
    Contractions result = resting(face);
    for (std::size_t m = 0; m < face.muscles.size(); ++m) {
        const std::string& name = face.muscles[m].traits.name;
        if (const auto rate = rates.find(name); rate != rates.end()) {
            result.rate[m] = rate->second;
        }
        if (const auto strength = strengths.find(name); strength != strengths.end()) {
            result.strength[m] = strength->second;
        }
    }
    return result;
}

Eigen::VectorXd protection_of_scan(const FaceModel& face, const Eigen::VectorXd& of_nodes) {
    if (of_nodes.size() == 0 || of_nodes.isZero(0.0)) {
        return {};
    }
    const SimulatedSkin& skin = face.skin;
    Eigen::VectorXd result = Eigen::VectorXd::Zero(face.own_vertices);
    for (int v = 0; v < face.own_vertices; ++v) {
        for (int k = 0; k < 3 && skin.between(k, v) >= 0; ++k) {
            const bool alone = skin.between(1, v) < 0;
            result[v] += (alone ? 1.0 : double(skin.shares(k, v))) * of_nodes[skin.between(k, v)];
        }
        result[v] = std::clamp(result[v], 0.0, 1.0);
    }
    return result;
}

Eigen::VectorXd protection_of_nodes(const FaceModel& face, const Eigen::VectorXd& of_scan) {
    if (of_scan.size() != face.own_vertices) {
        return {};
    }
    Eigen::VectorXd result = Eigen::VectorXd::Zero(face.node_count());
    for (int node = 0; node < face.own_nodes; ++node) {
        result[node] = of_scan[face.skin.vertex[static_cast<std::size_t>(node)]];
    }
    return result;
}

StateParts to_parts(const CaseState& state) {
    StateParts result;
    json object;
    object["contractions"] = state.rates;
    object["strengths"] = state.strengths;
    object["notes"] = state.notes;
    object["skin_age"] = state.skin_age;
    object["variants"] = json::array();
    for (std::size_t i = 0; i < state.variants.size(); ++i) {
        const Variant& variant = state.variants[i];
        object["variants"].push_back({{"name", variant.name},
                                      {"contractions", variant.rates},
                                      {"strengths", variant.strengths}});
        if (variant.shape.cols() > 0) {
            result.parts[variant_part(i)] = sparse(variant.shape);
        }
    }
    if (state.shape.cols() > 0) {
        result.parts["shape"] = sparse(state.shape);
    }
    if (state.protection.size() > 0) {
        Points padded = Points::Zero(3, state.protection.size());
        padded.row(0) = state.protection;
        result.parts["protection"] = sparse(padded);
    }
    if (!state.plan.edits.empty()) {
        object["plan"] = json::parse(recorded_plan_to_json(state.plan));
    }
    result.json = object.dump(1, ' ', false, json::error_handler_t::replace);
    return result;
}

CaseState from_parts(const std::string& json_text,
                     const std::function<std::string(const std::string&)>& part,
                     std::int64_t vertices, const std::string& name) {
    const json object = json::parse(json_text, nullptr, false);
    if (!object.is_object()) {
        throw IoError(name + ": its settings are damaged.");
    }
    CaseState state;
    state.rates = settings(object, "contractions", kLeastContraction, kMostContraction, name);
    state.strengths = settings(object, "strengths", 0.0, 1.0, name);
    state.notes = state_text(object, "notes", name);
    state.skin_age = skin_age_of(object, name);
    state.shape = dense(part("shape"), vertices, name);
    const Points protection = dense(part("protection"), vertices, name);
    if (protection.cols() > 0) {
        state.protection = protection.row(0);
        if (state.protection.minCoeff() < 0.0 || state.protection.maxCoeff() > 1.0) {
            throw IoError(name + ": what it protects is out of range.");
        }
    }
    if (object.contains("plan")) {
        state.plan = recorded_plan_from_json(object["plan"].dump(), name + ", plan");
    }
    const json variants = object.contains("variants") ? object["variants"] : json::array();
    if (!variants.is_array() || variants.size() > kMostVariants) {
        throw IoError(name + ": its variants are damaged.");
    }
    for (std::size_t i = 0; i < variants.size(); ++i) {
        if (!variants[i].is_object()) {
            throw IoError(name + ": its variants are damaged.");
        }
        Variant variant;
        variant.name = state_text(variants[i], "name", name);
        variant.rates =
            settings(variants[i], "contractions", kLeastContraction, kMostContraction, name);
        variant.strengths = settings(variants[i], "strengths", 0.0, 1.0, name);
        variant.shape = dense(part(variant_part(i)), vertices, name);
        state.variants.push_back(std::move(variant));
    }
    return state;
}

}  // namespace myoface
