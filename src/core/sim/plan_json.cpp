// SPDX-License-Identifier: Apache-2.0
// Plans as JSON.
#include <charconv>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/sim/plan_file.h"

namespace myoface {
namespace {

using nlohmann::ordered_json;

constexpr int kPlanSchema = 1;
constexpr std::size_t kMostEdits = 100'000;
constexpr double kFarthestMove = 1e5;  // of a place [mm]
constexpr std::int64_t kMostVertices = 100'000'000;

ordered_json list_of(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

std::string hex(std::uint64_t value) {
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

ordered_json place_to_json(const PlanPlace& place) {
    ordered_json written;
    written["triangle"] = place.where.triangle;
    written["weights"] = list_of(place.where.weights);
    written["xyz"] = list_of(place.xyz);
    written["head"] = list_of(place.head);
    if (!place.near.empty()) {
        written["near"] = place.near;
        written["off"] = list_of(place.off);
    }
    return written;
}

ordered_json shape_to_json(const ShapeEdit& shape) {
    if (shape.vertices == 0) {
        return "scan";
    }
    ordered_json moved = ordered_json::array();
    for (std::size_t k = 0; k < shape.moved.size(); ++k) {
        const auto by = shape.by.col(static_cast<Eigen::Index>(k));
        moved.push_back({shape.moved[k], by.x(), by.y(), by.z()});
    }
    return {{"vertices", shape.vertices}, {"moved", std::move(moved)}};
}

/// Reads one edit; complains in the words of its place.
class EditReader {
public:
    EditReader(const ordered_json& edit, std::string place)
        : edit_(edit), place_(std::move(place)) {}

    Edit read() const {
        if (!edit_.is_object()) {
            fail("is not an object.");
        }
        if (is_text("drag")) {
            return with_place(parse_drag(text("drag")));
        }
        if (is_text("volume")) {
            return with_place(parse_volume(text("volume")));
        }
        if (is_text("protect")) {
            return with_place(parse_protect(text("protect")));
        }
        if (is_text("target")) {
            return parse_target(text("target"));
        }
        if (is_text("muscle") && is_number("rate")) {
            return ContractionEdit{text("muscle"), edit_["rate"].get<double>()};
        }
        if (is_text("muscle") && is_number("strength")) {
            return StrengthEdit{text("muscle"), edit_["strength"].get<double>()};
        }
        if (is_text("expression") && is_number("intensity")) {
            return ExpressionEdit{text("expression"), edit_["intensity"].get<double>()};
        }
        if (edit_.contains("shape")) {
            return shape(edit_["shape"]);
        }
        fail(
            "is none of drag, volume, target, protect and shape, nor a muscle with a rate or "
            "strength, nor an expression with an intensity.");
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw IoError(place_ + what); }
    bool is_text(const char* key) const { return edit_.contains(key) && edit_[key].is_string(); }
    bool is_number(const char* key) const { return edit_.contains(key) && edit_[key].is_number(); }
    std::string text(const char* key) const { return edit_[key].get<std::string>(); }

    Vec3 vector(const ordered_json& object, const char* key) const {
        Vec3 v = Vec3::Zero();
        const bool list = object.contains(key) && object[key].is_array() && object[key].size() == 3;
        for (std::size_t k = 0; k < 3; ++k) {
            const double value =
                list && object[key][k].is_number() ? object[key][k].get<double>() : kFarthestMove;
            if (!(std::abs(value) < kFarthestMove)) {
                fail(std::string("its \"") + key + "\" is not three numbers of millimetres.");
            }
            v[static_cast<Eigen::Index>(k)] = value;
        }
        return v;
    }

    PlanPlace place(const ordered_json& object) const {
        if (!object.is_object() || !object.contains("triangle") ||
            !object["triangle"].is_number_integer()) {
            fail("its place has no triangle: take the place away and write \"at=prn\" instead.");
        }
        PlanPlace place;
        const auto triangle = object["triangle"].get<std::int64_t>();
        place.where.weights = vector(object, "weights");
        const Vec3& w = place.where.weights;
        if (triangle < 0 || triangle >= kMostVertices || w.minCoeff() < -1e-9 ||
            std::abs(w.sum() - 1.0) > 1e-6) {
            fail("its place is not on a triangle: weights are not negative and sum to 1.");
        }
        place.where.triangle = static_cast<int>(triangle);
        place.xyz = vector(object, "xyz");
        place.head = vector(object, "head");
        if (object.contains("near")) {
            if (!object["near"].is_string()) {
                fail("\"near\" is not the name of a landmark.");
            }
            place.near = object["near"].get<std::string>();
            place.off = vector(object, "off");
        }
        return place;
    }

    template <typename Placed>
    Edit with_place(Placed edit) const {
        if (edit_.contains("place")) {
            edit.place = place(edit_["place"]);
        }
        return edit;
    }

    ShapeEdit shape(const ordered_json& object) const {
        ShapeEdit shape;
        if (object == "scan") {
            return shape;
        }
        if (!object.is_object() || !object.contains("vertices") || !object.contains("moved") ||
            !object["vertices"].is_number_integer() || !object["moved"].is_array()) {
            fail("its shape is neither \"scan\" nor {\"vertices\", \"moved\"}.");
        }
        const auto count = object["vertices"].get<std::int64_t>();
        const ordered_json& moved = object["moved"];
        if (count < 1 || count > kMostVertices || moved.size() > static_cast<std::size_t>(count)) {
            fail("its shape has an impossible number of vertices.");
        }
        shape.vertices = static_cast<int>(count);
        shape.by.resize(3, static_cast<Eigen::Index>(moved.size()));
        for (const ordered_json& entry : moved) {
            bool good = entry.is_array() && entry.size() == 4 && entry[0].is_number_integer();
            const std::int64_t v = good ? entry[0].get<std::int64_t>() : -1;
            good = good && v >= 0 && v < count;
            for (std::size_t k = 1; good && k < 4; ++k) {
                good = entry[k].is_number() && std::abs(entry[k].get<double>()) < kFarthestMove;
                if (good) {
                    shape.by(static_cast<Eigen::Index>(k - 1),
                             static_cast<Eigen::Index>(shape.moved.size())) =
                        entry[k].get<double>();
                }
            }
            if (!good) {
                fail("its shape does not move vertices by [number, x, y, z].");
            }
            shape.moved.push_back(static_cast<int>(v));
        }
        return shape;
    }

    const ordered_json& edit_;
    std::string place_;
};

PlanOrigin origin_from_json(const ordered_json& object, const std::string& name) {
    const auto damaged = [&](const std::string& what) {
        return IoError(name + ": \"made_on\" " + what +
                       "; take it away to have its places found by landmarks.");
    };
    if (!object.is_object()) {
        throw damaged("is not an object");
    }
    PlanOrigin origin;
    for (const auto& [key, value] : {std::pair("scan", &origin.scan), {"skin", &origin.skin}}) {
        const std::string text =
            object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
        const auto [end, error] =
            std::from_chars(text.data(), text.data() + text.size(), *value, 16);
        if (text.size() != 16 || error != std::errc() || end != text.data() + text.size()) {
            throw damaged(std::string("has no sum of the ") + key);
        }
    }
    const auto number = [&](const ordered_json& value) {
        if (!value.is_number() || !(std::abs(value.get<double>()) < kFarthestMove)) {
            throw damaged("holds something else than numbers");
        }
        return value.get<double>();
    };
    if (!object.contains("axes") || !object["axes"].is_array() || object["axes"].size() != 9) {
        throw damaged("has no nine numbers of axes");
    }
    for (int i = 0; i < 9; ++i) {
        origin.axes(i / 3, i % 3) = number(object["axes"][static_cast<std::size_t>(i)]);
    }
    if (!(origin.axes * origin.axes.transpose()).isIdentity(1e-6)) {
        throw damaged("has axes that are no rotation");
    }
    if (object.contains("landmarks")) {
        if (!object["landmarks"].is_object()) {
            throw damaged("has damaged landmarks");
        }
        for (const auto& [key, value] : object["landmarks"].items()) {
            if (!value.is_array() || value.size() != 3) {
                throw damaged("has damaged landmarks");
            }
            origin.landmarks[key] = {number(value[0]), number(value[1]), number(value[2])};
        }
    }
    return origin;
}

struct EditWriter {
    ordered_json operator()(const ContractionEdit& e) const {
        return {{"muscle", e.muscle}, {"rate", e.rate}};
    }
    ordered_json operator()(const StrengthEdit& e) const {
        return {{"muscle", e.muscle}, {"strength", e.strength}};
    }
    ordered_json operator()(const ExpressionEdit& e) const {
        return {{"expression", e.expression}, {"intensity", e.intensity}};
    }
    ordered_json operator()(const DragEdit& e) const {
        return placed("drag", drag_to_text(e), e.place);
    }
    ordered_json operator()(const VolumeEdit& e) const {
        return placed("volume", volume_to_text(e), e.place);
    }
    ordered_json operator()(const ProtectEdit& e) const {
        return placed("protect", protect_to_text(e), e.place);
    }
    ordered_json operator()(const TargetEdit& e) const { return {{"target", target_to_text(e)}}; }
    ordered_json operator()(const ShapeEdit& e) const { return {{"shape", shape_to_json(e)}}; }

private:
    static ordered_json placed(const char* key, const std::string& text,
                               const std::optional<PlanPlace>& place) {
        ordered_json edit{{key, text}};
        if (place) {
            edit["place"] = place_to_json(*place);
        }
        return edit;
    }
};

}  // namespace

RecordedPlan recorded_plan_from_json(const std::string& text, const std::string& name) {
    const ordered_json document = ordered_json::parse(text, nullptr, false);
    if (document.is_discarded()) {
        throw IoError(name + ": is not a plan: it is not JSON.");
    }
    if (!document.is_object() || !document.contains("plan") || !document["plan"].is_array()) {
        throw IoError(name + ": is not a plan: a JSON object with a list \"plan\" is needed.");
    }
    if (document.contains("format") && document["format"] != "myoface-plan") {
        throw IoError(name + ": is not a plan: its \"format\" is another one.");
    }
    if (document.contains("schema")) {
        if (!document["schema"].is_number_integer() || document["schema"].get<std::int64_t>() < 1) {
            throw IoError(name + ": its \"schema\" is no whole number from 1.");
        }
        if (document["schema"].get<std::int64_t>() > kPlanSchema) {
            throw IoError(name + ": was written by a newer Myoface; apply it with that one.");
        }
    }
    if (document["plan"].size() > kMostEdits) {
        throw IoError(name + ": has more than 100000 edits.");
    }
    RecordedPlan plan;
    if (document.contains("made_on")) {
        plan.origin = origin_from_json(document["made_on"], name);
    }
    for (const ordered_json& edit : document["plan"]) {
        const std::string place = name + " edit " + std::to_string(plan.edits.size() + 1) + ": ";
        try {
            plan.edits.push_back(EditReader(edit, place).read());
        } catch (const InvalidInput& problem) {
            throw InvalidInput(place + problem.what());
        }
    }
    return plan;
}

std::string recorded_plan_to_json(const RecordedPlan& plan) {
    ordered_json document;
    document["format"] = "myoface-plan";
    document["schema"] = kPlanSchema;
    document["note"] = "A planning and communication aid, not a medical device.";
    if (plan.origin) {
        ordered_json origin;
        origin["scan"] = hex(plan.origin->scan);
        origin["skin"] = hex(plan.origin->skin);
        for (int i = 0; i < 9; ++i) {
            origin["axes"].push_back(plan.origin->axes(i / 3, i % 3));
        }
        for (const auto& [name, at] : plan.origin->landmarks) {
            origin["landmarks"][name] = list_of(at);
        }
        document["made_on"] = origin;
    }
    document["plan"] = ordered_json::array();
    for (const Edit& edit : plan.edits) {
        document["plan"].push_back(std::visit(EditWriter{}, edit));
    }
    return document.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

Plan plan_from_json(const std::string& text, const std::string& name) {
    return recorded_plan_from_json(text, name).edits;
}

std::string plan_to_json(const Plan& plan) {
    return recorded_plan_to_json({std::nullopt, plan});
}

}  // namespace myoface
