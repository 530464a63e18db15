// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/sim/snapshot.h"

#include "commands.h"
#include "face_arguments.h"
#include "output.h"
#include "simulation_report.h"

namespace myoface::cli {
namespace {

struct SimulateArguments {
    FaceArguments face;
    EditArguments edits;
    std::string solver = "equilibrium", response = "smooth";
    std::string output, report;
    double seconds = 0.0;
    int threads = 0;
};

}  // namespace

void add_simulate(CLI::App& app) {
    auto* command =
        app.add_subcommand("simulate", "Contract muscles and drag skin, without a window");
    auto a = std::make_shared<SimulateArguments>();
    a->face.add_to(*command);
    a->edits.add_to(*command);
    command->add_option("--solver", a->solver, "equilibrium, symplectic or explicit")
        ->check(CLI::IsMember({"equilibrium", "symplectic", "explicit"}));
    command->add_option("--response", a->response,
                        "form of the linear muscles' response: smooth, as-printed, quarter-turn, "
                        "1987, zone-normalised or later-code");
    command
        ->add_option("--seconds", a->seconds,
                     "how the face is so long after the last edit, while tissue still swings; a "
                     "last drag with mode=constraint is let go")
        ->check(CLI::Range(0.01, 60.0));
    command->add_option("--threads", a->threads, "threads to use; the result does not depend on it")
        ->check(CLI::Range(1, 64));
    command->add_option("-o", a->output, "OUT.obj or OUT.ply")->required();
    command->add_option("--report", a->report, "JSON report");
    command->callback([a] {
        if (a->threads > 0) {
            set_thread_count(a->threads);
        }
        const RecordedPlan plan = a->edits.edits();
        const auto prepared = prepare_fitting();
        OpenedFace opened = a->face.open();
        find_missing_landmarks(opened);
        SimulatorOptions options;
        options.response = response_named(a->response);
        options.solver = a->solver == "explicit"     ? SolverKind::ExplicitEuler
                         : a->solver == "symplectic" ? SolverKind::SymplecticEuler
                                                     : SolverKind::Equilibrium;
        const auto simulator = make_simulator(opened, options);
        if (a->seconds > 0.0 && options.solver != SolverKind::Equilibrium) {
            throw InvalidInput("--seconds goes with --solver equilibrium only.");
        }
        const PlanReport report =
            run_plan(*simulator, plan_on(simulator->face(), plan),
                     a->seconds > 0.0 ? std::optional(a->seconds) : std::nullopt);
        if (!report.last.converged && a->seconds == 0.0) {
            std::cerr << "Not at rest after " << report.last.iterations
                      << " steps; the report says how far.\n";
        }
        write_face(a->output, *opened.scan, simulator->face(), simulator->state().positions,
                   jaw_pose(simulator->face(), simulator->contractions()), simulator->wrinkles());
        if (!a->report.empty()) {
            write_text(a->report, simulation_report(*simulator, report).dump(1) + "\n");
        }
    });
}

}  // namespace myoface::cli
