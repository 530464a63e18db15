// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <memory>
#include <optional>

#include "myoface/base/error.h"
#include "myoface/measure/section.h"

#include "commands.h"
#include "face_arguments.h"
#include "output.h"

namespace myoface::cli {
namespace {

struct SectionArguments {
    FaceArguments face;
    EditArguments edits;
    std::string at = "prn", plane = "profile", output;
};

/// Three numbers with commas between, or nothing.
std::optional<Vec3> three_numbers(const std::string& text) {
    Vec3 v;
    char extra = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &v.x(), &v.y(), &v.z(), &extra) == 3 &&
        v.allFinite()) {
        return v;
    }
    return std::nullopt;
}

SectionPlane plane_of(const SectionArguments& a, const FaceModel& face) {
    Vec3 through;
    if (const auto place = three_numbers(a.at)) {
        through = *place;
    } else if (const auto found = face.landmarks.find(a.at); found != face.landmarks.end()) {
        through = found->second.position;
    } else {
        throw InvalidInput("There is no landmark '" + a.at + "' on this face to cut through.");
    }
    if (a.plane == "profile") {
        return profile_plane(face);
    }
    if (a.plane == "horizontal") {
        return horizontal_plane(face, through);
    }
    if (a.plane == "sagittal") {
        return sagittal_plane(face, through);
    }
    const auto normal = three_numbers(a.plane);
    if (!normal || normal->norm() == 0.0) {
        throw InvalidInput("The plane '" + a.plane +
                           "' is none of profile, horizontal, sagittal, or a normal x,y,z.");
    }
    return free_plane(face, through, *normal);
}

void cut(const SectionArguments& a) {
    const RecordedPlan plan = a.edits.edits();
    OpenedFace opened = a.face.open();
    find_missing_landmarks(opened);
    const auto simulator = make_simulator(opened);
    run_plan(*simulator, plan_on(simulator->face(), plan));
    const FaceModel& face = simulator->face();
    const SectionPlane where = plane_of(a, face);
    const Triangles skin = seen_skin(face);
    const auto before = section(face, skin, face.skin.mesh.vertices, where);
    const auto now = section(face, skin, simulator->state().positions, where);
    if (before.empty() && now.empty()) {
        throw InvalidInput("The plane does not meet the face.");
    }
    write_text(a.output, section_csv(before, now));
    std::fprintf(stderr, "Apart by up to %.1f mm.\n", largest_gap(before, now));
}

}  // namespace

void add_section(CLI::App& app) {
    auto* command =
        app.add_subcommand("section", "A cut through the face before and now, as lines");
    auto a = std::make_shared<SectionArguments>();
    a->face.add_to(*command);
    a->edits.add_to(*command);
    command->add_option("--plane", a->plane,
                        "profile, horizontal, sagittal, or a normal x,y,z of the face's axes");
    command->add_option("--at", a->at, "a landmark or x,y,z [mm] that it goes through");
    command->add_option("-o", a->output, "CSV file, instead of standard output");
    command->callback([a] { cut(*a); });
}

}  // namespace myoface::cli
