// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/measure/volume.h"
#include "myoface/sim/snapshot.h"

#include "commands.h"
#include "face_arguments.h"
#include "output.h"

namespace myoface::cli {
namespace {

struct Arguments {
    FaceArguments face;
    EditArguments edits;
    std::string solver = "equilibrium", response = "smooth";
    std::string output, report;
    double seconds = 0.0;
    int threads = 0;
};

nlohmann::ordered_json drag_json(const FaceModel& face, const DragReport& drag) {
    const int vertex = drag.node < 0 ? -1 : face.skin.vertex[static_cast<std::size_t>(drag.node)];
    const auto list = [](const Vec3& p) {
        return nlohmann::ordered_json::array({p.x(), p.y(), p.z()});
    };
    nlohmann::ordered_json json;
    json["mode"] = drag.mode == DragMode::MousePriority ? "mouse" : "constraint";
    json["vertex"] = vertex;
    json["target"] = list(face.scan->frame.to_file(drag.target));
    json["reached"] = list(face.scan->frame.to_file(drag.reached));
    json["off_ray_mm"] = drag.off_ray_mm;
    json["view_force_residual"] = drag.view_force_residual;
    json["force_mN"] = drag.force_mN;
    json["stage_skin_mN"] = drag.stage_skin_mN;
    json["stage_muscle_mN"] = drag.stage_muscle_mN;
    json["refused_mN"] = drag.refused_mN;
    json["kept_share"] = drag.kept_share;
    json["strain_share_of_limit"] = drag.strain_share;
    return json;
}

std::string report_json(const Simulator& simulator, const PlanReport& plan, int vertices) {
    const FaceModel& face = simulator.face();
    nlohmann::ordered_json json;
    json["note"] = "A planning and communication aid, not a medical device.";
    json["vertices"] = vertices;
    json["nodes"] = simulator.system().model.node_count();
    json["springs"] = simulator.system().model.springs.size();
    for (std::size_t m = 0; m < face.muscles.size(); ++m) {
        json["muscles"][face.muscles[m].traits.name] = simulator.contractions().rate[m];
    }
    json["max_displacement_mm"] = plan.last.max_displacement_mm;
    json["max_strain"] = plan.last.max_strain;
    json["solver"] = {{"name", plan.last.solver},
                      {"iterations", plan.last.iterations},
                      {"residual", plan.last.residual},
                      {"converged", plan.last.converged},
                      {"ms", plan.last.milliseconds}};
    json["drags"] = nlohmann::ordered_json::array();
    for (const DragReport& drag : plan.drags) {
        json["drags"].push_back(drag_json(face, drag));
    }
    for (const VolumeReport& volume : plan.volumes) {
        nlohmann::ordered_json entry{{"ml", volume.ml},
                                     {"pressure_kPa", volume.pressure_kPa},
                                     {"kept_share", volume.kept_share}};
        for (const auto& [region, ml] : volume.by_region) {
            entry["by_region_ml"][region_name(region)] = ml;
        }
        json["volumes"].push_back(entry);
    }
    for (const TargetReport& target : plan.targets) {
        json["targets"].push_back({{"landmark", target.landmark},
                                   {"before", target.before},
                                   {"wanted", target.wanted},
                                   {"reached", target.reached},
                                   {"moved_mm", target.moved_mm},
                                   {"force_mN", target.force_mN}});
    }
    const Points& scan = face.skin.mesh.vertices;
    for (const auto& [region, ml] : volume_by_region(face, scan, simulator.skin_rest())) {
        json["shape_ml"][region_name(region)] = ml;
    }
    char hash[20];
    std::snprintf(hash, sizeof hash, "%016llx",
                  static_cast<unsigned long long>(simulator.state_hash()));
    json["state_hash"] = hash;
    return json.dump(1) + "\n";
}

}  // namespace

void add_simulate(CLI::App& app) {
    auto* command =
        app.add_subcommand("simulate", "Contract muscles and drag skin, without a window");
    auto a = std::make_shared<Arguments>();
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
        const Plan plan = a->edits.edits();
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
            run_plan(*simulator, plan, a->seconds > 0.0 ? std::optional(a->seconds) : std::nullopt);
        if (!report.last.converged && a->seconds == 0.0) {
            std::cerr << "Not at rest after " << report.last.iterations
                      << " steps; the report says how far.\n";
        }
        write_face(a->output, *opened.scan, simulator->face(), simulator->state().positions,
                   jaw_opening(simulator->face(), simulator->contractions()));
        if (!a->report.empty()) {
            write_text(a->report,
                       report_json(*simulator, report, opened.scan->mesh.vertex_count()));
        }
    });
}

}  // namespace myoface::cli
