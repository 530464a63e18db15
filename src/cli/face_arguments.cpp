// SPDX-License-Identifier: Apache-2.0
#include "face_arguments.h"

#include <cstdlib>

#include "myoface/base/error.h"
#include "myoface/face/muscle_atlas.h"
#include "myoface/io/text_file.h"
#include "myoface/muscle/expression.h"
#include "myoface/muscle/weakening.h"

namespace myoface::cli {

void PopulationArguments::add_to(CLI::App& command) {
    command.add_option("--sex", sex, "f or m; both sexes' norms when absent")
        ->check(CLI::IsMember({"f", "m"}));
    command.add_option("--age", age, "years; the norms cover 20 to 25");
}

Population PopulationArguments::chosen() const {
    Population population;
    population.age = age;
    if (!sex.empty()) {
        population.sex = sex == "f" ? Sex::Female : Sex::Male;
    }
    return population;
}

void FaceArguments::add_to(CLI::App& command) {
    command
        .add_option("FACE", face, "OBJ, PLY, STL, glTF, GLB or .myoface file, or the word generic")
        ->required();
    command.add_option("--landmarks", landmarks,
                       "landmark file (JSON) in the scan's unit and axes");
    command.add_option("--unit", unit, "unit of the scan: m dm cm mm in, or millimetres per unit");
    command.add_option("--axes", axes,
                       "where the scan's x, y and z point, +x left +y up +z front: such as +x-z+y");
    command.add_option("--known", known,
                       "calibrates by a known distance: \"from=en_l; to=en_r; mm=31.5\", ends as "
                       "landmark, \"vertex N\" or x,y,z");
    command.add_option("--tissue", tissue,
                       "depth of the soft tissue over the bone: thin, mean or heavy");
    command
        .add_option("--skin-age", skin_age,
                    "years of the skin, 18 to 80: how deep expressions wrinkle it (40 when absent)")
        ->check(CLI::Range(kYoungestSkin, kOldestSkin));
    command.add_option("--passphrase-file", passphrase_file,
                       "file whose first line is the passphrase of protected cases, read or "
                       "written; MYOFACE_PASSPHRASE does the same");
}

std::string FaceArguments::passphrase() const {
    if (passphrase_file.empty()) {
        const char* given = std::getenv("MYOFACE_PASSPHRASE");
        return given != nullptr ? given : "";
    }
    const std::string text = read_file(passphrase_file);
    const std::string line = text.substr(0, text.find_first_of("\r\n"));
    if (line.empty()) {
        throw InvalidInput(passphrase_file + ": its first line, the passphrase, is empty.");
    }
    return line;
}

OpenedFace FaceArguments::open() const {
    OpenOptions options;
    if (!landmarks.empty()) {
        options.landmarks = landmarks;
    }
    if (!unit.empty()) {
        options.mm_per_unit = millimetres_per_unit(unit);
    }
    if (!axes.empty()) {
        options.axes = axes_from_text(axes);
    }
    if (!known.empty()) {
        options.known = parse_known_distance(known);
    }
    if (!tissue.empty()) {
        options.tissue = tissue_thickness(tissue);
    }
    options.passphrase = passphrase();
    try {
        OpenedFace opened = open_face(face, options);
        opened.passphrase = options.passphrase;
        if (skin_age) {
            opened.state.skin_age = *skin_age;
        }
        return opened;
    } catch (const PassphraseNeeded& locked) {
        throw IoError(std::string(locked.what()) +
                      " Give it with --passphrase-file FILE or in MYOFACE_PASSPHRASE.");
    }
}

void EditArguments::add_to(CLI::App& command) {
    command.add_option("--muscle", muscles, "NAME=c, contraction from -0.5 to 1; repeatable")
        ->allow_extra_args(false);
    command
        .add_option("--expression", expressions,
                    "NAME=w, a preset (joy, full_smile, ...) or action unit (AU12, AU12.L) with "
                    "its intensity from 0 to 1; repeatable, they add up")
        ->allow_extra_args(false);
    command.add_option("--strength", strengths, "NAME=s, strength from 0 to 1; repeatable")
        ->allow_extra_args(false);
    command
        .add_option("--weaken", weakenings,
                    "a ready set of weak muscles (glabella, crows_feet, palsy_4.L, ...); "
                    "repeatable, before --strength")
        ->allow_extra_args(false);
    command
        .add_option("--drag", drags,
                    "\"at=prn; view=left; move=RIGHT,UP; mode=mouse|constraint; radius=MM; "
                    "mirror=0|1; path=free|normal|midplane\"; repeatable")
        ->allow_extra_args(false);
    command
        .add_option("--volume", volumes,
                    "\"at=zy_l; ml=0.5; radius=MM; mirror=0|1\": tissue added, or taken away below "
                    "zero; repeatable")
        ->allow_extra_args(false);
    command
        .add_option("--target", targets,
                    "\"nasolabial angle=100\", \"tip projection by -2\": the face is shaped until "
                    "a measure is met; repeatable")
        ->allow_extra_args(false);
    command
        .add_option("--protect", protects,
                    "\"at=prn; radius=MM; mirror=0|1\": skin that drags, volumes and targets leave "
                    "alone; repeatable")
        ->allow_extra_args(false);
    command.add_option("--plan", plan, "edits from a JSON file, before all others");
}

RecordedPlan EditArguments::edits() const {
    RecordedPlan plan_file;
    if (!plan.empty()) {
        plan_file = recorded_plan_from_json(read_file(plan), plan);
    }
    Plan& result = plan_file.edits;
    for (const std::string& name : weakenings) {
        for (const auto& [muscle, strength] : weakening_named(name).strengths) {
            const MuscleTraits& traits = muscle_atlas()[static_cast<std::size_t>(muscle)].traits;
            result.emplace_back(StrengthEdit{traits.name, strength});
        }
    }
    for (const std::string& text : strengths) {
        const auto [name, value] = parse_setting(text);
        muscles_named(name);
        result.emplace_back(StrengthEdit{name, value});
    }
    for (const std::string& text : expressions) {
        const auto [name, value] = parse_setting(text);
        expression_named(name);
        result.emplace_back(ExpressionEdit{name, value});
    }
    for (const std::string& text : muscles) {
        const auto [name, value] = parse_setting(text);
        muscles_named(name);
        result.emplace_back(ContractionEdit{name, value});
    }
    for (const std::string& text : protects) {
        result.emplace_back(parse_protect(text));
    }
    for (const std::string& text : drags) {
        result.emplace_back(parse_drag(text));
    }
    for (const std::string& text : volumes) {
        result.emplace_back(parse_volume(text));
    }
    for (const std::string& text : targets) {
        result.emplace_back(parse_target(text));
    }
    return plan_file;
}

}  // namespace myoface::cli
