// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/io/text_file.h"
#include "myoface/sim/snapshot.h"

#include "commands.h"
#include "face_arguments.h"
#include "output.h"
#include "simulation_report.h"

namespace myoface::cli {
namespace {

struct ReplayArguments {
    std::string plan;
    FaceArguments face;
    std::string output, case_file, plan_out, report;
    bool on_top = false;
    int threads = 0;
};

/// From a plan file, or the plan that a case holds.
RecordedPlan read_plan(const std::string& file, const std::string& passphrase) {
    if (std::filesystem::path(file).extension() != ".myoface") {
        return recorded_plan_from_json(read_file(file), file);
    }
    OpenOptions options;
    options.passphrase = passphrase;
    RecordedPlan plan = open_face(file, options).state.plan;
    if (plan.edits.empty()) {
        throw InvalidInput(file + ": this case holds no plan; save it once more in the window.");
    }
    return plan;
}

CaseState state_of(const Simulator& simulator, CaseState state) {
    const CaseState made =
        case_state(simulator.face(), simulator.contractions(), simulator.skin_rest());
    state.rates = made.rates;
    state.strengths = made.strengths;
    state.shape = made.shape;
    state.protection = protection_of_scan(simulator.face(), simulator.protection());
    return state;
}

void run(const ReplayArguments& a) {
    if (a.threads > 0) {
        set_thread_count(a.threads);
    }
    const RecordedPlan plan = read_plan(a.plan, a.face.passphrase());
    const auto prepared = prepare_fitting();
    OpenedFace opened = a.face.open();
    find_missing_landmarks(opened);
    if (!a.on_top) {  // the plan starts where its face did
        opened.state.rates.clear();
        opened.state.strengths.clear();
        opened.state.shape.resize(3, 0);
        opened.state.protection.resize(0);
        opened.state.plan = {};
    }
    const auto simulator = make_simulator(opened);
    const FaceModel& face = simulator->face();
    const Replay done = replay(*simulator, plan);
    if (simulator->dragging()) {
        simulator->end_drag(false);
        simulator->settle();
    }
    std::cerr << replay_in_words(done) << '\n';
    if (!a.output.empty()) {
        write_face(a.output, *opened.scan, face, simulator->state().positions,
                   jaw_pose(face, simulator->contractions()), simulator->wrinkles());
    }
    CaseState state = state_of(*simulator, opened.state);
    Plan edits = plan_on(face, state.plan);
    edits.insert(edits.end(), done.made.begin(), done.made.end());
    state.plan = {plan_origin(face), std::move(edits)};
    if (!a.case_file.empty()) {
        write_case(a.case_file, opened, state);
    }
    if (!a.plan_out.empty()) {
        write_text(a.plan_out, recorded_plan_to_json(state.plan));
    }
    nlohmann::ordered_json report = nlohmann::ordered_json::parse(replay_to_json(done));
    report.update(simulation_report(*simulator, done.report));
    const bool silent = a.report.empty() && (!a.output.empty() || !a.case_file.empty());
    if (!silent) {
        write_text(a.report, report.dump(1) + "\n");
    }
}

}  // namespace

void add_replay(CLI::App& app) {
    auto* command = app.add_subcommand(
        "replay", "Apply a recorded plan to the same face, another scan or another person");
    auto a = std::make_shared<ReplayArguments>();
    command->add_option("PLAN", a->plan, "plan (JSON), or a case that holds one")->required();
    a->face.add_to(*command);
    command->add_flag("--on-top", a->on_top,
                      "of what a case holds; else the face starts as the scan came");
    command->add_option("-o", a->output, "the face as OUT.obj, OUT.ply, ...");
    command->add_option("--case-out", a->case_file, "the face as CASE.myoface");
    command->add_option("--plan-out", a->plan_out, "the plan as it was carried to this face");
    command->add_option("--report", a->report,
                        "JSON: what was done and what could not be carried over");
    command->add_option("--threads", a->threads, "threads to use; the result does not depend on it")
        ->check(CLI::Range(1, 64));
    command->callback([a] { run(*a); });
}

}  // namespace myoface::cli
