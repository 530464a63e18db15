// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <memory>

#include "myoface/base/error.h"
#include "myoface/measure/measurement.h"
#include "myoface/measure/volume.h"
#include "myoface/scene/colour_map.h"
#include "myoface/scene/face_scene.h"

#include "commands.h"
#include "face_arguments.h"
#include "picture.h"
#include "portrait.h"
#include "report.h"

namespace myoface::cli {
namespace {

struct ReportArguments {
    FaceArguments face;
    EditArguments edits;
    PopulationArguments population;
    std::string title, patient, notes, date, logo, output, language = "en";
    bool anonymous = false;
};

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[16];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::localtime(&now));
    return text;
}

/// The face from one side, as a picture for paper.
Image drawn(FaceScene& scene, const Landmarks& landmarks, const std::string& view, bool anonymous) {
    constexpr int kWidth = 900;
    constexpr int kHeight = 1000;
    scene.scene().background_top = {0.93F, 0.94F, 0.95F};
    scene.scene().background_bottom = {0.82F, 0.84F, 0.86F};
    Camera camera;
    camera.orientation = standard_view(view);
    const auto nose = landmarks.count("prn") != 0 ? landmarks.at("prn") : landmarks.at("sn");
    frame(camera, nose.position + Vec3(0.0, 4.0, -82.0), 116.0,
          static_cast<double>(kWidth) / kHeight);
    Image picture = draw_picture(scene.scene(), camera, kWidth, kHeight);
    if (anonymous) {
        cover_eyes(picture, camera, landmarks);
    }
    return picture;
}

SimSnapshot moment(const Simulator& simulator, bool before) {
    SimSnapshot snapshot = snapshot_of(simulator);
    if (before) {
        snapshot.positions.leftCols(simulator.face().node_count()) =
            simulator.face().skin.mesh.vertices;
        snapshot.jaw = {};
        snapshot.wrinkles.depth.resize(0);
    }
    return snapshot;
}

void add_pictures(Report& report, const Simulator& simulator, const OpenedFace& opened,
                  bool anonymous) {
    FaceScene scene(simulator.face().scan, anonymous ? nullptr : opened.texture);
    if (anonymous) {
        scene.scene().skin.colours.resize(3, 0);
    }
    scene.set_face(simulator.shared_face(), simulator.system().model.springs,
                   simulator.system().chains);
    scene.shade();
    const Landmarks& landmarks = simulator.face().landmarks;
    for (const auto& [view, caption] :
         {std::pair("front", "front"), std::pair("three-quarter-left", "three-quarter"),
          std::pair("left", "profile")}) {
        ReportView pair;
        pair.caption = caption;
        scene.show(moment(simulator, true));
        pair.before = drawn(scene, landmarks, view, anonymous);
        scene.show(moment(simulator, false));
        pair.after = drawn(scene, landmarks, view, anonymous);
        report.views.push_back(std::move(pair));
    }
    const int n = simulator.face().node_count();
    const Points moved =
        simulator.state().positions.leftCols(n) - simulator.face().skin.mesh.vertices;
    report.largest_move_mm = std::sqrt(moved.colwise().squaredNorm().maxCoeff());
    if (report.largest_move_mm < 0.05) {
        return;
    }
    report.heat_map_mm = std::max(1.0, std::ceil(report.largest_move_mm));
    Eigen::Matrix4Xf tint(4, n);
    for (int i = 0; i < n; ++i) {
        tint.col(i) << colour_map(moved.col(i).norm() / report.heat_map_mm), 1.0F;
    }
    scene.tint_nodes(tint);
    report.heat_map = drawn(scene, landmarks, "three-quarter-left", anonymous);
}

void add_numbers(Report& report, const Simulator& simulator, const ReportArguments& a) {
    const std::shared_ptr<const FaceModel> face = simulator.shared_face();
    const LandmarksOnSkin places(face);
    const Points& before = face->skin.mesh.vertices;
    const Points& after = simulator.state().positions;
    for (const Measurement& row : measure_all(places, before, after, a.population.chosen())) {
        ReportMeasure line{row.measure.title, row.measure.in_degrees(), row.value, *row.other,
                           std::nullopt};
        if (row.norm) {
            line.norm = {row.norm->mean, row.norm->sd};
        }
        report.measures.push_back(std::move(line));
    }
    report.population = std::string("norm: ") + Population::name() + "; band: mean ± 2 sd";
    for (const auto& [region, ml] : volume_by_region(*face, before, simulator.skin_rest())) {
        if (std::abs(ml) >= 0.02) {
            report.volumes.emplace_back(region_name(region), ml);
        }
    }
    for (std::size_t m = 0; m < face->muscles.size(); ++m) {
        if (simulator.contractions().rate[m] != 0.0) {
            report.muscles.emplace_back(face->muscles[m].traits.title,
                                        simulator.contractions().rate[m]);
        }
    }
}

void make_report(const ReportArguments& a) {
    if (std::filesystem::path(a.output).extension() != ".pdf") {
        throw InvalidInput(a.output + ": a report is written as .pdf.");
    }
    const RecordedPlan plan = a.edits.edits();
    OpenedFace opened = a.face.open();
    find_missing_landmarks(opened);
    const auto simulator = make_simulator(opened);
    run_plan(*simulator, plan_on(simulator->face(), plan));
    if (simulator->dragging()) {
        simulator->end_drag(false);
    }
    simulator->settle();
    Report report;
    report.language = a.language;
    report.title = a.title;
    report.patient = a.patient;
    report.face = a.anonymous ? std::string() : opened.name;
    report.date = a.date.empty() ? today() : a.date;
    report.notes = a.notes.empty() ? opened.state.notes : a.notes;
    if (!a.logo.empty()) {
        report.logo = read_image(a.logo);
    }
    add_pictures(report, *simulator, opened, a.anonymous);
    add_numbers(report, *simulator, a);
    write_report(a.output, report);
}

}  // namespace

void add_report(CLI::App& app) {
    auto* command = app.add_subcommand("report", "Pictures and measures before and after, as PDF");
    auto a = std::make_shared<ReportArguments>();
    a->face.add_to(*command);
    a->edits.add_to(*command);
    command->add_option("--title", a->title, "heading");
    command->add_option("--patient", a->patient, "a pseudonym");
    command->add_option("--notes", a->notes, "text at the end");
    command->add_option("--date", a->date, "instead of today");
    command->add_option("--logo", a->logo, "PNG or JPEG of the clinic");
    a->population.add_to(*command);
    command->add_option("--language", a->language, "of the report: en or ja")
        ->check(CLI::IsMember({"en", "ja"}));
    command->add_flag("--anonymous", a->anonymous, "plain skin and a bar over the eyes");
    command->add_option("-o", a->output, "PDF file")->required();
    command->callback([a] { make_report(*a); });
}

}  // namespace myoface::cli
