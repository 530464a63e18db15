// SPDX-License-Identifier: Apache-2.0
// What a surgeon waits for: a pull, a frame of a drag, the opening of a scan. On generated heads;
// with MYOFACE_BENCH_SCAN=FILE on that scan too.
#include <cstdlib>
#include <filesystem>
#include <map>

#include <benchmark/benchmark.h>

#include "myoface/cases/case_file.h"
#include "myoface/face/generic_face.h"
#include "myoface/io/mesh_file.h"
#include "myoface/mesh/bvh.h"
#include "myoface/physics/euler.h"
#include "myoface/physics/forces.h"
#include "myoface/physics/packed_model.h"
#include "myoface/scene/face_scene.h"
#include "myoface/sim/frame_governor.h"

#include "measure.h"

namespace myoface {
namespace {

using bench::milliseconds;
using bench::quantile;

constexpr double kFrame = 16.7;       // [ms]
constexpr double kSceneMargin = 1.5;  // [ms] of a frame left free

GenericFace head(int vertices) {
    GenericFaceOptions options;
    options.vertices = vertices;
    return make_generic_face(options);
}

std::shared_ptr<const FaceModel> fitted(int vertices, int finest) {
    const GenericFace generic = head(vertices);
    return fit_face(std::make_shared<const Scan>(generic.scan), generic.landmarks, nullptr,
                    {finest, TissueThickness::Mean});
}

/// A hand in the cheek that pulls 10 mm sideways.
struct CheekPull {
    explicit CheekPull(const FaceModel& face) {
        const Vec3 between =
            0.5 * (face.landmarks.at("ch_l").position + face.landmarks.at("go_l").position) +
            Vec3(12.0, 0.0, 25.0);  // outside, not in the mouth
        request.where = Bvh(face.skin.mesh).closest_point(face.skin.mesh, between).where;
        ray.origin = position(face.skin.mesh, request.where) + Vec3(0, 0, 300);
        ray.direction = -Vec3::UnitZ();
    }
    ViewRay at(double share) const {
        ViewRay moved = ray;
        moved.origin += share * Vec3(10.0, 0.0, 0.0);
        return moved;
    }
    DragRequest request;
    ViewRay ray;
};

/// Ten millimetres in thirty frames as the window makes them, each with its sweeps, the scan that
/// follows and its normals; then a second in which the hand holds still.
void live_drag(benchmark::State& state, const std::shared_ptr<const FaceModel>& face,
               const std::string& name) {
    const CheekPull pull(*face);
    Simulator converged(face);
    const Points rest = converged.state().positions;
    converged.begin_drag(pull.request, pull.at(0.0));
    converged.move_drag(pull.at(1.0));
    converged.settle();
    const Points there = converged.state().positions;
    const auto left = [&](const Simulator& simulator) {
        return (simulator.state().positions - there).norm() / (there - rest).norm();
    };
    for (auto _ : state) {
        std::vector<double> frames;
        double at_end = 0.0;
        double after = 0.0;
        for (int gesture = 0; gesture < 4; ++gesture) {
            Simulator simulator(face);
            FaceScene scene(face->scan, nullptr);
            scene.set_face(face, {}, {});
            SimSnapshot still;
            still.positions = rest;
            scene.show(still);
            FrameGovernor governor;
            governor.learn(simulator.step(4));  // as a window that has been open for a while
            double showing = 1.0;
            simulator.begin_drag(pull.request, pull.at(0.0));
            const auto frame = [&](double share) {
                return milliseconds([&] {
                    simulator.move_drag(pull.at(share));
                    const double budget = 0.75 * (kFrame - kSceneMargin - showing);
                    const StepReport report = simulator.step(governor.sweeps(budget));
                    governor.learn(report);
                    SimSnapshot snapshot;
                    snapshot.positions = simulator.state().positions;
                    snapshot.rates = simulator.contractions().rate;
                    const double shown = milliseconds([&] { scene.show(snapshot); });
                    showing = std::max(shown, 0.8 * showing);
                });
            };
            for (int f = 1; f <= 30; ++f) {
                const double time = frame(f / 30.0);
                if (f > 1 || gesture > 0) {
                    frames.push_back(time);
                }
            }
            at_end = std::max(at_end, left(simulator));
            double waited = 0.0;
            while (waited < 1000.0) {
                waited += std::max(frame(1.0), 1000.0 / 60.0);
            }
            after = std::max(after, left(simulator));
        }
        state.counters["live_drag_p99_" + name + "_ms"] = quantile(frames, 0.99);
        state.counters["live_drag_median_" + name + "_ms"] = quantile(frames, 0.5);
        state.counters["live_drag_rms_" + name + "_share"] = at_end;
        state.counters["live_drag_rms_1s_after_" + name + "_share"] = after;
    }
}
void live_drag_of_generated(benchmark::State& state) {
    const auto size = static_cast<int>(state.range(0));
    live_drag(state, fitted(size, FitOptions{}.finest),
              size == 1'000'000 ? "1m" : std::to_string(size / 1000) + "k");
}
BENCHMARK(live_drag_of_generated)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

void live_drag_of_a_scan(benchmark::State& state) {
    const char* file = std::getenv("MYOFACE_BENCH_SCAN");
    if (file == nullptr) {
        state.SkipWithError("MYOFACE_BENCH_SCAN names no file");
        return;
    }
    OpenedFace opened = open_face(file);
    find_missing_landmarks(opened);
    live_drag(state, fit_face(opened.scan, *opened.landmarks), "scan");
}
BENCHMARK(live_drag_of_a_scan)->Iterations(1)->Unit(benchmark::kMillisecond);

/// A cold 10 mm pull by a handle of 5 mm on every vertex of a head of 100,000, to 1 % of the energy
/// that is still to be lost: the solver beside explicit Euler at its stable step, which works with
/// the same packed forces.
void cold_pull_beside_explicit(benchmark::State& state) {
    const auto vertices = static_cast<int>(state.range(0));
    const auto face = fitted(vertices, 10'000'000);
    FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    system.model.rest_gravity = kUprightGravity;
    std::shared_ptr<const CoarseFace> levels_of_face;
    std::unique_ptr<CoarseLevel> coarser;
    const double set_up = milliseconds([&] {
        levels_of_face = coarser_levels(*face);
        coarser = std::make_unique<CoarseLevel>(levels_of_face, system, face->skin.mesh.vertices,
                                                TissueConstants{});
        EquilibriumSolver(system.model, coarser.get());
    });
    const CheekPull pull(*face);
    const StressKernel kernel =
        stress_kernel(*face, face->skin.mesh.vertices, grip_at(*face, pull.request.where), 5.0);
    Handle handle{kernel.nodes, kernel.weights, view_plane(-Vec3::UnitZ()), {}};
    Vec3 centre = Vec3::Zero();
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        centre += kernel.weights[k] * system.model.rest.col(kernel.nodes[k]);
    }
    const Vec3 jump(10.0, 0.0, 0.0);
    handle.target = handle.plane.transpose() * (centre + jump);
    Drive drive;
    drive.gravity = kUprightGravity;
    PackedModel packed(system.model);
    packed.set_drive(drive);
    // Both begin where the kernel's nodes have jumped with the hand and all others are at rest.
    MassSpringState begun = rest_state(system.model);
    double carried = 0.0;
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        carried += kernel.weights[k] * kernel.profile[k];
    }
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        begun.positions.col(kernel.nodes[k]) += kernel.profile[k] / carried * jump;
    }
    for (auto _ : state) {
        MassSpringState settled = begun;
        RelaxOptions thorough;
        thorough.iterations = 8000;
        EquilibriumSolver(system.model, coarser.get())
            .relax(settled, drive, thorough, {&handle, 1});
        const double least = packed.energy(settled.positions);
        const double wanted = least + 0.01 * (packed.energy(begun.positions) - least);
        // Ours, in rounds of a few sweeps.
        MassSpringState ours = begun;
        EquilibriumSolver fresh(system.model, coarser.get());
        RelaxOptions few;
        few.iterations = 6;
        double our_time = 0.0;
        for (int round = 0; round < 400; ++round) {
            our_time += milliseconds([&] { fresh.relax(ours, drive, few, {&handle, 1}); });
            if (packed.energy(ours.positions) < wanted) {
                break;
            }
        }
        // Explicit Euler at its stable step, the handle put back in its place after every one.
        MassSpringState theirs = begun;
        const double step = stable_time_step(system.model, Integrator::ExplicitEuler);
        const Eigen::VectorXd pace = system.model.mass.cwiseInverse();
        double give = 0.0;
        for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
            give += kernel.weights[k] * kernel.weights[k] * pace[kernel.nodes[k]];
        }
        constexpr double kPatience = 20'000.0;  // [ms]
        double their_time = 0.0;
        while (their_time < kPatience) {
            their_time += milliseconds([&] {
                for (int n = 0; n < 50; ++n) {
                    const Points forces = packed.damped_forces(theirs);
                    theirs.positions += step * theirs.velocities;
                    theirs.velocities += step * (forces * pace.asDiagonal());
                    Vec3 at = Vec3::Zero();
                    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
                        at += kernel.weights[k] * theirs.positions.col(kernel.nodes[k]);
                    }
                    const Vec3 error =
                        handle.plane * (handle.target - handle.plane.transpose() * at);
                    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
                        const int node = kernel.nodes[k];
                        theirs.positions.col(node) += kernel.weights[k] * pace[node] / give * error;
                    }
                }
            });
            if (packed.energy(theirs.positions) < wanted) {
                break;
            }
        }
        const std::string name = std::to_string(vertices / 1000) + "k";
        state.counters["levels_set_up_" + name + "_ms"] = set_up;
        state.counters["cold_pull_" + name + "_ms"] = our_time;
        state.counters["cold_pull_explicit_" + name + "_ms"] = their_time;
        state.counters["cold_pull_vs_explicit_" + name + "_x"] = their_time / our_time;
    }
}
BENCHMARK(cold_pull_beside_explicit)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// From a file to a face that answers: read, face and landmarks found, fitted, springs built. In a
/// fresh process each time, for the first face of a process pays for the average head.
void open_to_interactive(benchmark::State& state) {
    const auto size = static_cast<int>(state.range(0));
    const auto file =
        std::filesystem::temp_directory_path() / ("myoface_bench_" + std::to_string(size) + ".ply");
    const Scan scan = head(size).scan;
    write_mesh(file, scan, scan.mesh.vertices);
    const std::string again =
        std::filesystem::read_symlink("/proc/self/exe").string() + " --open=" + file.string();
    for (auto _ : state) {
        std::vector<double> times;
        for (int k = 0; k < 3; ++k) {
            times.push_back(milliseconds([&] {
                if (std::system(again.c_str()) != 0) {
                    state.SkipWithError("a process that opens the scan failed");
                }
            }));
        }
        state.counters["open_to_interactive_" +
                       (size == 1'000'000 ? std::string("1m") : std::to_string(size / 1000) + "k") +
                       "_ms"] = quantile(times, 0.5);
    }
    std::filesystem::remove(file);
}
BENCHMARK(open_to_interactive)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// From a move of the slider to the picture's data: contraction, sweeps as the window makes them,
/// wrinkles, the scan that follows and its normals. Both frontales go up and down four times.
void slider_update(benchmark::State& state) {
    const auto face = fitted(100'000, FitOptions{}.finest);
    std::vector<int> muscles = muscles_named("frontalis_medial");
    for (const int m : muscles_named("zygomaticus_major")) {
        muscles.push_back(m);
    }
    for (auto _ : state) {
        Simulator simulator(face);
        FaceScene scene(face->scan, nullptr);
        scene.set_face(face, {}, {});
        FrameGovernor governor;
        governor.learn(simulator.step(4));  // as a window that has been open for a while
        scene.show(snapshot_of(simulator));
        std::vector<double> frames;
        double showing = 1.0;
        for (int f = 0; f <= 160; ++f) {
            std::vector<double> rates(face->muscles.size(), 0.0);
            for (const int m : muscles) {
                rates[static_cast<std::size_t>(m)] = 0.5 - 0.5 * std::cos(f * 2.0 * 3.14159 / 40.0);
            }
            const double time = milliseconds([&] {
                simulator.set_contractions(rates);
                const double budget = 0.75 * (kFrame - kSceneMargin - showing);
                governor.learn(simulator.step(governor.sweeps(budget)));
                const SimSnapshot snapshot = snapshot_of(simulator);
                const double shown = milliseconds([&] { scene.show(snapshot); });
                showing = std::max(shown, 0.8 * showing);
            });
            if (f > 2) {  // the first acting muscle maps the furrows
                frames.push_back(time);
            }
        }
        state.counters["slider_update_100k_ms"] = quantile(frames, 0.5);
        state.counters["slider_update_p99_100k_ms"] = quantile(frames, 0.99);
    }
}
BENCHMARK(slider_update)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace myoface
