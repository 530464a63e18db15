// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>

#include <benchmark/benchmark.h>

#include "myoface/face/generic_face.h"
#include "myoface/mesh/bvh.h"
#include "myoface/physics/forces.h"
#include "myoface/sim/simulator.h"

namespace myoface {
namespace {

std::shared_ptr<const FaceModel> fitted(int vertices) {
    static std::map<int, std::shared_ptr<const FaceModel>> cache;
    auto& face = cache[vertices];
    if (!face) {
        GenericFaceOptions options;
        options.vertices = vertices;
        const GenericFace generic = make_generic_face(options);
        face = fit_face(std::make_shared<const Scan>(generic.scan), generic.landmarks);
    }
    return face;
}

void BM_GenerateFace(benchmark::State& state) {
    GenericFaceOptions options;
    options.vertices = static_cast<int>(state.range(0));
    for (auto _ : state) {
        benchmark::DoNotOptimize(make_generic_face(options));
    }
}
BENCHMARK(BM_GenerateFace)->Arg(10000)->Arg(30000)->Unit(benchmark::kMillisecond);

void BM_FitFace(benchmark::State& state) {
    const auto face = fitted(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        benchmark::DoNotOptimize(fit_face(face->scan, face->landmarks));
    }
}
BENCHMARK(BM_FitFace)->Arg(10000)->Arg(50000)->Unit(benchmark::kMillisecond);

/// All forces once, every term of the model.
void BM_TotalForces(benchmark::State& state) {
    const auto face = fitted(static_cast<int>(state.range(0)));
    const FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    const MassSpringState at = rest_state(system.model);
    for (auto _ : state) {
        benchmark::DoNotOptimize(total_forces(system.model, at, {}, false));
    }
    state.counters["springs"] = static_cast<double>(system.model.springs.size());
}
BENCHMARK(BM_TotalForces)->Arg(10000)->Arg(50000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One frame of a live drag of the nose tip as the window does it: a 10 mm drag in 30 frames.
void BM_DragFrame(benchmark::State& state) {
    Simulator simulator(fitted(static_cast<int>(state.range(0))));
    const FaceModel& face = simulator.face();
    DragRequest request;
    request.where =
        Bvh(face.skin.mesh).closest_point(face.skin.mesh, face.landmarks.at("prn").position).where;
    const Vec3 start = position(face.skin.mesh, request.where);
    simulator.begin_drag(request, {start, -Vec3::UnitX()});
    int frame = 0;
    double furthest = 0.0;
    for (auto _ : state) {
        const double share = 0.5 - 0.5 * std::cos(0.1 * frame++);
        simulator.move_drag({start + Vec3(0.0, 6.0, 8.0) * share, -Vec3::UnitX()});
        furthest = std::max(furthest, simulator.step(20).drag->off_ray_mm);
    }
    state.counters["off_ray_mm"] = furthest;
}
BENCHMARK(BM_DragFrame)->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_ContractAndSettle(benchmark::State& state) {
    const auto face = fitted(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        state.PauseTiming();
        Simulator simulator(face);
        state.ResumeTiming();
        for (const int m : muscles_named("zygomaticus_major")) {
            simulator.set_contraction(m, 1.0);
        }
        benchmark::DoNotOptimize(simulator.settle());
    }
}
BENCHMARK(BM_ContractAndSettle)->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// From a cold 9 mm pull at the corner of the mouth to 5 % of the way (rms), in rounds of six
/// sweeps as a frame has; second argument: with coarser levels or without.
void BM_ColdDrag(benchmark::State& state) {
    const auto face = fitted(static_cast<int>(state.range(0)));
    DragRequest request;
    request.where = Bvh(face->skin.mesh)
                        .closest_point(face->skin.mesh, face->landmarks.at("ch_l").position)
                        .where;
    const Vec3 start = position(face->skin.mesh, request.where);
    const auto begin = [&](Simulator& simulator) {
        simulator.begin_drag(request, {start, -Vec3::UnitZ()});
        simulator.move_drag({start + Vec3(8.0, 4.0, 0.0), -Vec3::UnitZ()});
    };
    Simulator converged(face);
    const Points rest = converged.state().positions;
    begin(converged);
    converged.settle();
    const Points there = converged.state().positions;
    SimulatorOptions options;
    options.levels = state.range(1) != 0;
    int rounds = 0;
    for (auto _ : state) {
        state.PauseTiming();
        Simulator simulator(face, options);
        begin(simulator);
        double left = 1.0;
        for (rounds = 0; left > 0.05 && rounds < 4000; ++rounds) {
            state.ResumeTiming();
            simulator.step(6);
            state.PauseTiming();
            left = (simulator.state().positions - there).norm() / (there - rest).norm();
        }
        state.ResumeTiming();
    }
    state.counters["rounds"] = rounds;
    state.counters["nodes"] = face->node_count();
}
BENCHMARK(BM_ColdDrag)
    ->Args({10000, 0})
    ->Args({10000, 1})
    ->Args({100000, 0})
    ->Args({100000, 1})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_SliderUpdate(benchmark::State& state) {
    Simulator simulator(fitted(static_cast<int>(state.range(0))));
    double rate = 0.0;
    for (auto _ : state) {
        rate = rate > 0.9 ? 0.0 : rate + 0.05;
        simulator.set_contraction(0, rate);
    }
}
BENCHMARK(BM_SliderUpdate)->Arg(10000)->Arg(50000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace myoface
