// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <memory>

#include "myoface/base/error.h"
#include "myoface/measure/landmarks_on_skin.h"
#include "myoface/measure/volume.h"
#include "myoface/scene/colour_map.h"
#include "myoface/scene/face_scene.h"

#include "commands.h"
#include "face_arguments.h"
#include "picture.h"
#include "report.h"

namespace myoface::cli {
namespace {

struct Arguments {
    FaceArguments face;
    EditArguments edits;
    std::string title = "Facial simulation", patient, notes, date, logo, sex, output;
    double age = 25.0;
};

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[16];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::localtime(&now));
    return text;
}

/// The face from one side, as a picture for paper.
Image drawn(FaceScene& scene, const Landmarks& landmarks, const std::string& view) {
    constexpr int kWidth = 900;
    constexpr int kHeight = 1000;
    scene.scene().background_top = {0.93F, 0.94F, 0.95F};
    scene.scene().background_bottom = {0.82F, 0.84F, 0.86F};
    Camera camera;
    camera.orientation = standard_view(view);
    const auto nose = landmarks.count("prn") != 0 ? landmarks.at("prn") : landmarks.at("sn");
    frame(camera, nose.position + Vec3(0.0, 4.0, -82.0), 116.0,
          static_cast<double>(kWidth) / kHeight);
    return draw_picture(scene.scene(), camera, kWidth, kHeight);
}

SimSnapshot moment(const Simulator& simulator, bool before) {
    SimSnapshot snapshot;
    snapshot.positions = simulator.state().positions;
    if (before) {
        snapshot.positions.leftCols(simulator.face().node_count()) =
            simulator.face().skin.mesh.vertices;
    } else {
        snapshot.jaw = jaw_opening(simulator.face(), simulator.contractions());
    }
    return snapshot;
}

void add_pictures(Report& report, const Simulator& simulator, const OpenedFace& opened) {
    FaceScene scene(simulator.face().scan, opened.texture);
    scene.set_face(simulator.shared_face(), simulator.system().model.springs,
                   simulator.system().chains);
    const Landmarks& landmarks = simulator.face().landmarks;
    for (const auto& [view, caption] :
         {std::pair("front", "front"), std::pair("three-quarter-left", "three-quarter"),
          std::pair("left", "profile")}) {
        ReportView pair;
        pair.caption = caption;
        scene.show(moment(simulator, true));
        pair.before = drawn(scene, landmarks, view);
        scene.show(moment(simulator, false));
        pair.after = drawn(scene, landmarks, view);
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
    report.heat_map = drawn(scene, landmarks, "three-quarter-left");
}

void add_numbers(Report& report, const Simulator& simulator, const Arguments& a) {
    const std::shared_ptr<const FaceModel> face = simulator.shared_face();
    const LandmarksOnSkin places(face);
    const Points& before = face->skin.mesh.vertices;
    const Points& after = simulator.state().positions;
    std::optional<Sex> sex;
    if (!a.sex.empty()) {
        sex = a.sex == "f" ? Sex::Female : Sex::Male;
    }
    const std::vector<Norm> known = norms(sex, a.age);
    for (const Measure& measure : target_measures()) {
        const auto was = places.measure(measure, before);
        const auto is = places.measure(measure, after);
        if (!was || !is) {
            continue;
        }
        ReportMeasure row{measure.title, measure.in_degrees(), *was, *is, std::nullopt};
        for (const Norm& norm : known) {
            if (norm.measure.id == measure.id) {
                row.norm = {norm.mean, norm.sd};
            }
        }
        report.measures.push_back(std::move(row));
    }
    report.population = "norm: adults of European descent, 20 to 25 years; band: mean ± 2 sd";
    for (const auto& [region, ml] : volume_by_region(*face, before, simulator.skin_rest())) {
        if (std::abs(ml) >= 0.02) {
            report.volumes.emplace_back(region_name(region), ml);
        }
    }
    for (std::size_t m = 0; m < face->muscles.size(); ++m) {
        if (simulator.contractions().rate[m] != 0.0) {
            report.muscles.emplace_back(face->muscles[m].traits.name,
                                        simulator.contractions().rate[m]);
        }
    }
}

void make_report(const Arguments& a) {
    if (std::filesystem::path(a.output).extension() != ".pdf") {
        throw InvalidInput(a.output + ": a report is written as .pdf.");
    }
    const Plan plan = a.edits.edits();
    OpenedFace opened = a.face.open();
    find_missing_landmarks(opened);
    const auto simulator = make_simulator(opened);
    run_plan(*simulator, plan);
    if (simulator->dragging()) {
        simulator->end_drag(false);
        simulator->settle();
    }
    Report report;
    report.title = a.title;
    report.patient = a.patient;
    report.face = opened.name;
    report.date = a.date.empty() ? today() : a.date;
    report.notes = a.notes;
    if (!a.logo.empty()) {
        report.logo = read_image(a.logo);
    }
    add_pictures(report, *simulator, opened);
    add_numbers(report, *simulator, a);
    write_report(a.output, report);
}

}  // namespace

void add_report(CLI::App& app) {
    auto* command = app.add_subcommand("report", "Pictures and measures before and after, as PDF");
    auto a = std::make_shared<Arguments>();
    a->face.add_to(*command);
    a->edits.add_to(*command);
    command->add_option("--title", a->title, "heading");
    command->add_option("--patient", a->patient, "a pseudonym");
    command->add_option("--notes", a->notes, "text at the end");
    command->add_option("--date", a->date, "instead of today");
    command->add_option("--logo", a->logo, "PNG or JPEG of the clinic");
    command->add_option("--sex", a->sex, "f or m; both sexes' norms when absent")
        ->check(CLI::IsMember({"f", "m"}));
    command->add_option("--age", a->age, "years; the norms cover 20 to 25");
    command->add_option("-o", a->output, "PDF file")->required();
    command->callback([a] { make_report(*a); });
}

}  // namespace myoface::cli
