// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/landmarks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/io/mesh_file.h"
#include "myoface/io/text_file.h"

#include "../io/lower_case.h"

namespace myoface {
namespace {

using nlohmann::json;

struct Known {
    const char* name;
    const char* long_name;
    const char* title;
    bool paired;
    const char* definition;
};
constexpr std::array<Known, 24> kKnown{
    {{"tr", "trichion", "hairline", false, "The hairline in the middle of the forehead."},
     {"g", "glabella", "glabella", false,
      "The most prominent point of the midline between the eyebrows."},
     {"n", "nasion", "nasion", false,
      "The bony root of the nose in the midline, over the nasofrontal suture: above the deepest "
      "point of the bridge."},
     {"se", "sellion", "nasal root", false,
      "The deepest point of the bridge of the nose in the midline, about as high as the upper "
      "lids."},
     {"prn", "pronasale", "nose tip", false,
      "The foremost point of the nose tip, with the head held upright."},
     {"c", "columella", "columella", false,
      "The foremost point of the columella, at the crest between the nostrils."},
     {"sn", "subnasale", "base of the nose", false,
      "Where the columella meets the upper lip: the deepest point of the angle in the midline."},
     {"ls", "labrale_superius", "upper lip border", false,
      "The border between the skin and the red of the upper lip, in the midline."},
     {"sto", "stomion", "lip contact", false,
      "Where the closed lips meet in the midline; with open lips, halfway between them."},
     {"li", "labrale_inferius", "lower lip border", false,
      "The border between the red of the lower lip and the skin, in the midline."},
     {"sl", "sublabiale", "chin-lip fold", false,
      "The deepest point of the fold between lower lip and chin."},
     {"pg", "pogonion", "chin point", false, "The foremost point of the chin in the midline."},
     {"gn", "gnathion", "lowest chin point", false,
      "The lowest point of the chin in the midline, on its lower border."},
     {"en", "endocanthion", "inner canthus", true,
      "The inner corner of the eye, where the lids meet beside the nose."},
     {"ex", "exocanthion", "outer canthus", true,
      "The outer corner of the eye, where the lids meet; not the end of the fold beyond."},
     {"al", "alare", "wing of the nose", true,
      "The point of the wing of the nose that lies furthest to the side."},
     {"ac", "alar_curvature", "attachment of the wing", true,
      "Where the curved line of the wing begins in the cheek: its hindmost point."},
     {"sbal", "subalare", "base of the wing", true,
      "Where the wing of the nose runs into the upper lip, below the nostril."},
     {"ch", "cheilion", "mouth corner", true,
      "The corner of the mouth, where the line between the lips ends."},
     {"cph", "crista_philtri", "peak of Cupid's bow", true,
      "The peak of Cupid's bow, at the foot of the ridge beside the groove of the upper lip."},
     {"zy", "zygion", "cheekbone arch", true,
      "The point of the cheekbone arch that lies furthest to the side."},
     {"go", "gonion", "jaw angle", true,
      "The angle of the jaw: its lowest, hindmost and outermost point."},
     {"t", "tragion", "tragus", true, "The notch above the tragus, in front of the ear."},
     {"ft", "frontotemporale", "temple", true,
      "The temple at the narrowest place of the forehead, at the ridge beside the brow."}}};

/// Our short name for any accepted spelling, or "".
std::string canonical_name(const std::string& given) {
    std::string base = lower_case(given);
    std::string side;
    if (base.size() > 2 && (base.ends_with("_l") || base.ends_with("_r"))) {
        side = base.substr(base.size() - 2);
        base.resize(base.size() - 2);
    }
    for (const Known& known : kKnown) {
        if ((base == known.name || base == known.long_name) && known.paired == !side.empty()) {
            return known.name + side;
        }
    }
    return {};
}

double unit_from_json(const json& document, const std::string& name) {
    try {
        if (document.is_number()) {
            std::string text;
            append_number(text, document.get<double>());
            return millimetres_per_unit(text);
        }
        return millimetres_per_unit(document.get<std::string>());
    } catch (const std::exception&) {
        throw IoError(name + ": its unit is not one of m, dm, cm, mm, in or a number above 0.");
    }
}

}  // namespace

LandmarkFile landmarks_from_json(const std::string& text, const std::string& name) {
    const json document = json::parse(text, nullptr, false);
    if (document.is_discarded() || !document.is_object()) {
        throw IoError(name + ": is not a JSON file of landmarks.");
    }
    LandmarkFile result;
    if (document.contains("mm_per_unit")) {
        result.mm_per_unit = unit_from_json(document["mm_per_unit"], name);
    } else if (document.contains("unit")) {
        result.mm_per_unit = unit_from_json(document["unit"], name);
    }
    const json& list = document.contains("landmarks") ? document["landmarks"] : document;
    if (!list.is_object()) {
        throw IoError(name + ": holds no \"landmarks\" object.");
    }
    const json& errors = document.contains("est_error_mm") && document["est_error_mm"].is_object()
                             ? document["est_error_mm"]
                             : json::object();
    for (const auto& [key, value] : list.items()) {
        const std::string short_name = canonical_name(key);
        if (short_name.empty()) {
            continue;
        }
        const json& xyz = value.is_object() && value.contains("xyz") ? value["xyz"] : value;
        Landmark landmark;
        const bool three =
            xyz.is_array() && xyz.size() == 3 &&
            std::all_of(xyz.begin(), xyz.end(), [](const json& x) { return x.is_number(); });
        if (!three) {
            throw IoError(name + ": landmark '" + key + "' is not three numbers.");
        }
        landmark.position = Vec3(xyz[0].get<double>(), xyz[1].get<double>(), xyz[2].get<double>());
        if (!landmark.position.allFinite() || landmark.position.cwiseAbs().maxCoeff() > 1e9) {
            throw IoError(name + ": landmark '" + key + "' is not finite.");
        }
        // Beside the point, or in a list of its own as landmarks_to_json() writes it.
        const json& beside = value.is_object() ? value : json::object();
        const json error = beside.contains("est_error_mm") ? beside["est_error_mm"]
                           : errors.contains(key)          ? errors[key]
                                                           : json();
        if (error.is_number()) {
            landmark.error_mm = std::clamp(error.get<double>(), 0.1, 100.0);
        }
        result.landmarks[short_name] = landmark;
    }
    if (result.landmarks.empty()) {
        throw IoError(name + ": holds no landmark with a known name (prn, en_l, ch_r …).");
    }
    return result;
}

LandmarkFile read_landmarks(const std::filesystem::path& file) {
    return landmarks_from_json(read_file(file), file.string());
}

std::string landmarks_to_json(const Landmarks& landmarks, const FileFrame& frame,
                              std::optional<double> confidence) {
    json list = json::object();
    json errors = json::object();
    for (const auto& [name, landmark] : landmarks) {
        const Vec3 p = frame.to_file(landmark.position);
        list[name] = {p.x(), p.y(), p.z()};
        errors[name] = std::round(100.0 * landmark.error_mm) / 100.0;
    }
    const std::string unit = unit_name(frame.mm_per_unit);
    json document;
    document["unit"] = unit == "other" ? json(frame.mm_per_unit) : json(unit);
    document["landmarks"] = list;
    document["est_error_mm"] = errors;
    if (confidence) {
        document["confidence"] = std::round(1000.0 * *confidence) / 1000.0;
    }
    return document.dump(1) + "\n";
}

void write_landmarks(const std::filesystem::path& file, const Landmarks& landmarks,
                     const FileFrame& frame) {
    write_file(file, landmarks_to_json(landmarks, frame));
}

Landmarks in_model_frame(const LandmarkFile& file, const FileFrame& frame) {
    Landmarks result = file.landmarks;
    for (auto& [name, landmark] : result) {
        landmark.position = frame.to_model(landmark.position);
    }
    return result;
}

const std::vector<std::string>& landmark_names() {
    static const std::vector<std::string> kNames = [] {
        std::vector<std::string> names;
        for (const Known& known : kKnown) {
            if (known.paired) {
                names.push_back(std::string(known.name) + "_l");
                names.push_back(std::string(known.name) + "_r");
            } else {
                names.emplace_back(known.name);
            }
        }
        return names;
    }();
    return kNames;
}

std::string landmark_title(const std::string& name) {
    const bool left = name.ends_with("_l");
    const bool right = name.ends_with("_r");
    const std::string base = left || right ? name.substr(0, name.size() - 2) : name;
    for (const Known& known : kKnown) {
        if (base == known.name) {
            return std::string(known.title) + (left ? " (left)" : right ? " (right)" : "");
        }
    }
    return name;
}

std::string landmark_definition(const std::string& name) {
    const bool sided = name.ends_with("_l") || name.ends_with("_r");
    const std::string base = sided ? name.substr(0, name.size() - 2) : name;
    for (const Known& known : kKnown) {
        if (base == known.name) {
            return known.definition;
        }
    }
    return {};
}

std::string mirrored_name(const std::string& name) {
    if (name.ends_with("_l")) {
        return name.substr(0, name.size() - 2) + "_r";
    }
    if (name.ends_with("_r")) {
        return name.substr(0, name.size() - 2) + "_l";
    }
    return name;
}

}  // namespace myoface
