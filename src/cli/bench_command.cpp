// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>

#include <nlohmann/json.hpp>

#include "myoface/base/parallel.h"
#include "myoface/face/generic_face.h"
#include "myoface/mesh/bvh.h"
#include "myoface/physics/packed_model.h"
#include "myoface/sim/frame_governor.h"

#include "commands.h"
#include "output.h"

namespace myoface::cli {
namespace {

template <typename Action>
double milliseconds(const Action& action) {
    const auto start = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(std::lround(share * (values.size() - 1.0)))];
}

/// Median time of one pass over all forces of a model [ms].
double pass_time(PackedModel& packed) {
    constexpr int kPasses = 50;
    std::vector<double> times;
    for (int round = 0; round < 9; ++round) {
        times.push_back(milliseconds([&] {
                            for (int k = 0; k < kPasses; ++k) {
                                packed.repeat_pass(false);
                            }
                        }) /
                        kPasses);
    }
    return quantile(times, 0.5);
}

/// Frames of a 10 mm drag of the nose tip as the window makes them [ms].
std::vector<double> drag_frames(Simulator& simulator) {
    constexpr double kBudget = 11.0;
    const FaceModel& face = simulator.face();
    DragRequest request;
    request.where =
        Bvh(face.skin.mesh).closest_point(face.skin.mesh, face.landmarks.at("prn").position).where;
    const Vec3 start = position(face.skin.mesh, request.where);
    const Vec3 view = -Vec3::UnitX();
    FrameGovernor governor;
    governor.learn(simulator.step(6));
    simulator.begin_drag(request, {start, view});
    std::vector<double> frames;
    for (int f = 1; f <= 60; ++f) {
        frames.push_back(milliseconds([&] {
            simulator.move_drag({start + Vec3(0.0, 6.0, 8.0) * std::min(1.0, f / 30.0), view});
            governor.learn(simulator.step(governor.sweeps(kBudget)));
        }));
    }
    simulator.end_drag(false);
    return frames;
}

}  // namespace

void add_bench(CLI::App& app) {
    auto* command = app.add_subcommand("bench", "Measure how fast this machine simulates");
    auto json_wanted = std::make_shared<bool>(false);
    auto vertices = std::make_shared<int>(30000);
    auto output = std::make_shared<std::string>();
    command->add_flag("--json", *json_wanted, "as JSON");
    command->add_option("--vertices", *vertices, "of the built-in head that is measured")
        ->check(CLI::Range(3000, 1000000));
    command->add_option("-o", *output, "write there instead of to standard output");
    command->callback([json_wanted, vertices, output] {
        GenericFaceOptions options;
        options.vertices = *vertices;
        const GenericFace head = make_generic_face(options);
        const auto scan = std::make_shared<const Scan>(head.scan);
        fit_face(scan, head.landmarks);  // the first fit of a process also prepares the skull
        std::shared_ptr<const FaceModel> face;
        nlohmann::ordered_json json;
        const double fit = milliseconds([&] { face = fit_face(scan, head.landmarks); });
        std::unique_ptr<Simulator> simulator;
        const double set_up = milliseconds([&] { simulator = std::make_unique<Simulator>(face); });
        const MassSpringModel& model = simulator->system().model;
        PackedModel packed(model);
        packed.forces(model.rest);
        const int threads = thread_count();
        json["vertices"] = scan->mesh.vertex_count();
        json["nodes"] = model.node_count();
        json["springs"] = model.springs.size();
        json["kernel"] = kernel_name();
        json["threads"] = threads;
        json["fit_ms"] = fit;
        json["set_up_ms"] = set_up;
        set_thread_count(1);
        const double alone = pass_time(packed);
        set_thread_count(threads);
        const double together = pass_time(packed);
        json["force_pass_1t_ms"] = alone;
        json["force_pass_ms"] = together;
        json["springs_per_second"] = 1e3 * static_cast<double>(model.springs.size()) / together;
        const std::vector<double> frames = drag_frames(*simulator);
        json["drag_frame_median_ms"] = quantile(frames, 0.5);
        json["drag_frame_p99_ms"] = quantile(frames, 0.99);
        if (*json_wanted) {
            write_text(*output, json.dump(2) + "\n");
            return;
        }
        std::ostringstream table;
        for (const auto& [name, value] : json.items()) {
            table << std::left << std::setw(22) << name << ' ';
            if (value.is_number_float()) {
                table << std::setprecision(4) << value.get<double>() << '\n';
            } else {
                table << (value.is_string() ? value.get<std::string>() : value.dump()) << '\n';
            }
        }
        write_text(*output, table.str());
    });
}

}  // namespace myoface::cli
