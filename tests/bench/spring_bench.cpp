// SPDX-License-Identifier: Apache-2.0
// One pass of springs, dampers and anchors over a jittered sheet the size of a face, six springs a
// vertex, vertices in the order in which a scanner left them (any): the packed kernel beside
// Bullet's soft body, beside a plain loop, and beside what the memory gives.
#include <memory>
#include <numeric>
#include <random>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <benchmark/benchmark.h>

#include "myoface/base/parallel.h"
#include "myoface/physics/packed_model.h"

#include "BulletSoftBody/btSoftBody.h"
#include "measure.h"
#include "physics/packed_data.h"

namespace myoface {

const LaneKernels& native_kernels();

namespace {

using bench::in_turns;

constexpr double kSize = 180.0;        // of the sheet [mm]
constexpr double kEdge = 200.0;        // [mN/mm]
constexpr double kOpposite = 60.0;     // [mN/mm]
constexpr double kAnchor = 5.0;        // [mN/mm]
constexpr double kArealMass = 1e-5;    // 10 kg/m² [kg/mm²]
constexpr double kDampingShare = 0.2;  // of critical

MassSpringModel sheet(int vertices) {
    const int n = static_cast<int>(std::sqrt(vertices));
    const double spacing = kSize / n;
    std::mt19937 random(1);
    std::vector<int> place(static_cast<std::size_t>(n) * n);
    std::iota(place.begin(), place.end(), 0);
    std::shuffle(place.begin(), place.end(), random);
    std::uniform_real_distribution<double> jitter(-0.2, 0.2);
    MassSpringModel model;
    model.rest.resize(3, n * n);
    model.mass = Eigen::VectorXd::Constant(n * n, kArealMass * spacing * spacing);
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            model.rest.col(place[y * n + x]) << spacing * (x + jitter(random)),
                spacing * (y + jitter(random)),
                20.0 * std::cos(0.02 * spacing * (x - 0.5 * n)) + spacing * jitter(random);
        }
    }
    const auto join = [&](int x, int y, int dx, int dy, double stiffness) {
        if (x + dx >= n || y + dy >= n || x + dx < 0 || y + dy < 0) {
            return;
        }
        Spring spring;
        spring.a = place[y * n + x];
        spring.b = place[(y + dy) * n + x + dx];
        spring.stiffness = stiffness;
        spring.length = (model.rest.col(spring.a) - model.rest.col(spring.b)).norm();
        spring.damping = 2.0 * kDampingShare * std::sqrt(stiffness * model.mass[0]);
        model.springs.push_back(spring);
    };
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            join(x, y, 1, 0, kEdge);
            join(x, y, 0, 1, kEdge);
            join(x, y, 1, 1, kEdge);
            join(x, y, 2, 1, kOpposite);
            join(x, y, 1, 2, kOpposite);
            join(x, y, 1, -1, kOpposite);
        }
    }
    model.ties.resize(static_cast<std::size_t>(n) * n);
    for (Tie& tie : model.ties) {
        tie.anchor = kAnchor;
        tie.damping = 1e-5;
    }
    index_rows(model);
    return model;
}

MassSpringState disturbed(const MassSpringModel& model) {
    MassSpringState state = rest_state(model);
    std::srand(1);
    state.positions += 0.1 * Points::Random(3, model.node_count());
    state.velocities = Points::Random(3, model.node_count());
    return state;
}

/// What one writes first: nodes and springs as structs, one loop over springs, double precision.
class PlainLoop {
public:
    explicit PlainLoop(const MassSpringModel& model) : springs_(model.springs) {
        const MassSpringState state = disturbed(model);
        for (int i = 0; i < model.node_count(); ++i) {
            nodes_.push_back({state.positions.col(i), state.velocities.col(i), Vec3::Zero(),
                              model.rest.col(i), model.ties[i].anchor, model.ties[i].damping});
        }
    }
    void pass() {
        for (Node& node : nodes_) {
            node.f = -node.anchor * (node.x - node.rest) - node.damping * node.v;
        }
        for (const Spring& s : springs_) {
            Node& a = nodes_[s.a];
            Node& b = nodes_[s.b];
            const Vec3 r = a.x - b.x;
            const Vec3 f = s.stiffness * (1.0 - s.length / r.norm()) * r + s.damping * (a.v - b.v);
            a.f -= f;
            b.f += f;
        }
        benchmark::DoNotOptimize(nodes_.data());
    }

private:
    struct Node {
        Vec3 x, v, f, rest;
        double anchor, damping;
    };
    std::vector<Node> nodes_;
    std::vector<Spring> springs_;
};

/// The same springs as a soft body of Bullet; one iteration of its solver for links.
class BulletSheet {
public:
    explicit BulletSheet(const MassSpringModel& model) {
        std::vector<btVector3> x;
        for (int i = 0; i < model.node_count(); ++i) {
            x.emplace_back(static_cast<btScalar>(model.rest(0, i)),
                           static_cast<btScalar>(model.rest(1, i)),
                           static_cast<btScalar>(model.rest(2, i)));
        }
        body_ = std::make_unique<btSoftBody>(&world_, model.node_count(), x.data(), nullptr);
        for (const Spring& spring : model.springs) {
            body_->appendLink(spring.a, spring.b, nullptr, false);
        }
        body_->randomizeConstraints();
        body_->updateLinkConstants();
        for (int i = 0; i < body_->m_links.size(); ++i) {
            btSoftBody::Link& link = body_->m_links[i];
            link.m_c3 = link.m_n[1]->m_q - link.m_n[0]->m_q;
            link.m_c2 = 1.0F / (link.m_c3.length2() * link.m_c0);
        }
    }
    void pass() { btSoftBody::PSolve_Links(body_.get(), 1.0F, 0.0F); }

private:
    btSoftBodyWorldInfo world_;
    std::unique_ptr<btSoftBody> body_;
};

constexpr int kTriad = 24'000'000;

/// a = b + s c over arrays far larger than the cache, on all threads.
void triad() {
    static LargeArray<float> a(kTriad), b(kTriad), c(kTriad);
    parallel_for(kTriad, 1 << 16, [](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            a[i] = b[i] + 0.5F * c[i];
        }
    });
    benchmark::DoNotOptimize(a.data());
}

/// Calls `pass` as often as takes some milliseconds, so that the clock counts for nothing.
std::function<void()> often(const std::function<void()>& pass, int times) {
    return [pass, times] {
        for (int k = 0; k < times; ++k) {
            pass();
        }
    };
}

struct Packed {
    explicit Packed(int vertices) : model(sheet(vertices)), packed(model) {
        Drive still;
        packed.set_drive(still);
        packed.damped_forces(disturbed(model));
    }
    std::function<void()> on(int threads, int times) {
        return [this, threads, times] {
            set_thread_count(threads);
            for (int k = 0; k < times; ++k) {
                packed.repeat_pass(true);
            }
        };
    }
    double springs() const { return static_cast<double>(model.springs.size()); }
    MassSpringModel model;
    PackedModel packed;
};

void springs_beside_bullet_100k(benchmark::State& state) {
    Packed ours(100'000);
    BulletSheet bullet(ours.model);
    PlainLoop plain(ours.model);
    constexpr int kTimes = 10;
    for (auto _ : state) {
        const auto t =
            in_turns({ours.on(1, kTimes), ours.on(2, kTimes), often([&] { bullet.pass(); }, kTimes),
                      often([&] { plain.pass(); }, kTimes)},
                     15);
        const double ns = 1e6 / kTimes / ours.springs();
        state.counters["spring_100k_1t_ns"] = ns * t[0];
        state.counters["spring_100k_2t_ns"] = ns * t[1];
        state.counters["spring_100k_bullet_ns"] = ns * t[2];
        state.counters["spring_100k_naive_ns"] = ns * t[3];
        state.counters["springs_vs_bullet_100k_1t_x"] = t[2] / t[0];
        state.counters["springs_vs_bullet_100k_2t_x"] = t[2] / t[1];
        state.counters["springs_vs_naive_100k_2t_x"] = t[3] / t[1];
    }
}
BENCHMARK(springs_beside_bullet_100k)->Iterations(1)->Unit(benchmark::kMillisecond);

void springs_beside_memory_1m(benchmark::State& state) {
    Packed ours(1'000'000);
    PlainLoop plain(ours.model);
    for (auto _ : state) {
        const auto t = in_turns(
            {ours.on(1, 8), ours.on(2, 8), often([&] { plain.pass(); }, 2), often(triad, 4)}, 9);
        set_thread_count(2);
        const double ns = 1e6 / 8 / ours.springs();
        state.counters["spring_1m_1t_ns"] = ns * t[0];
        state.counters["spring_1m_2t_ns"] = ns * t[1];
        state.counters["spring_1m_naive_ns"] = 4.0 * ns * t[2];
        state.counters["springs_vs_naive_1m_2t_x"] = 4.0 * t[2] / t[1];
        const double memory = 4.0 * 3.0 * sizeof(float) * kTriad / t[3];  // bytes per ms
        state.counters["stream_2t_gb_per_s"] = memory * 1e-6;
        state.counters["stream_1m_2t_share"] =
            8.0 * ours.packed.bytes_of_pass(true) / t[1] / memory;
    }
}
BENCHMARK(springs_beside_memory_1m)->Iterations(1)->Unit(benchmark::kMillisecond);

void springs_by_size(benchmark::State& state) {
    const auto size = static_cast<int>(state.range(0));
    Packed ours(size);
    const int times = std::max(2, 2'000'000 / size);
    for (auto _ : state) {
        const auto t = in_turns({ours.on(1, times), ours.on(2, times)}, 9);
        const std::string name = std::to_string(size / 1000) + "k";
        state.counters["spring_by_size_" + name + "_1t_ns"] = 1e6 * t[0] / times / ours.springs();
        state.counters["spring_by_size_" + name + "_2t_ns"] = 1e6 * t[1] / times / ours.springs();
    }
}
BENCHMARK(springs_by_size)
    ->Arg(5'000)
    ->Arg(20'000)
    ->Arg(80'000)
    ->Arg(320'000)
    ->Arg(1'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

#ifdef MYOFACE_NATIVE_KERNELS
/// Kernels chosen at run time in a build for any processor, beside those built for this one.
void springs_of_any_build(benchmark::State& state) {
    Packed ours(100'000);
    const auto native = [&] {
        use_kernels(&native_kernels());
        ours.on(1, 10)();
        use_kernels(nullptr);
    };
    for (auto _ : state) {
        const auto t = in_turns({ours.on(1, 10), native}, 25);
        state.counters["baseline_vs_native_x"] = t[1] / t[0];
    }
}
BENCHMARK(springs_of_any_build)->Iterations(1)->Unit(benchmark::kMillisecond);
#endif

/// While another process keeps one processor busy.
void springs_beside_a_busy_neighbour(benchmark::State& state) {
    Packed ours(100'000);
    const pid_t neighbour = fork();
    if (neighbour == 0) {
        for (volatile bool stop = false; !stop;) {
        }
    }
    for (auto _ : state) {
        const auto t = in_turns({ours.on(1, 40), ours.on(2, 40)}, 15);
        state.counters["busy_neighbour_2t_vs_1t_x"] = t[0] / t[1];
    }
    kill(neighbour, SIGKILL);
    waitpid(neighbour, nullptr, 0);
}
BENCHMARK(springs_beside_a_busy_neighbour)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace myoface
