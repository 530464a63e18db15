// SPDX-License-Identifier: Apache-2.0
// How quickly the window answers, and that it goes on answering. MYOFACE_LONG_TESTS=1: a million
// vertices and 200 openings instead of a quick look.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>

#include <QElapsedTimer>
#include <QThread>

#include "face_files.h"
#include "gui_watchdog.h"
#include "simulation_worker.h"
#include "thorough.h"
#include "window_fixture.h"

namespace myoface {
namespace {

/// A face of so many vertices, written once.
QString written_face(const test::TemporaryFolder& folder, int vertices) {
    GenericFaceOptions options;
    options.vertices = vertices;
    const GenericFace face = make_generic_face(options);
    const std::filesystem::path file = folder / "large.ply";
    write_mesh(file, face.scan, face.scan.mesh.vertices);
    write_landmarks(folder / "large.landmarks.json", face.landmarks, {});
    return QString::fromStdString(file.string());
}

/// Memory of this process that is in use [MiB].
double memory() {
    std::ifstream status("/proc/self/statm");
    long all = 0;
    long resident = 0;
    status >> all >> resident;
    return static_cast<double>(resident) * 4096.0 / (1024.0 * 1024.0);
}

class Responsiveness : public test::Window {};

TEST_F(Responsiveness, OpeningAndSavingNeverHoldUpTheWindow) {
    // [ms] The quick look only finds work of seconds that is done in the window's own thread.
    const double most = test::thorough() ? 50.0 : 600.0;
    const QString file = written_face(folder_, test::thorough() ? 1000000 : 60000);
    open(path_);
    ASSERT_TRUE(settle());
    constexpr int kLong = 400000;  // [ms]
    const auto held_up = [&](const char* what) {
        std::printf("%s: busy %.1f ms at most (%s), %.1f ms by the clock\n", what,
                    test::WatchedApplication::longestBusy(),
                    qPrintable(test::WatchedApplication::culprit()),
                    test::WatchedApplication::longestWall());
        EXPECT_LT(test::WatchedApplication::longestBusy(), most)
            << what << ": " << test::WatchedApplication::culprit().toStdString();
        test::WatchedApplication::beginWatch();
    };
    test::WatchedApplication::beginWatch();
    open(file, kLong);
    ASSERT_TRUE(settle(kLong));
    held_up("opening");
    window_.addExpression("joy", 0.4);
    ASSERT_TRUE(settle(kLong));
    held_up("smiling");
    bool saved = false;
    window_.files().saveCaseTo(QString::fromStdString((folder_ / "large.myoface").string()),
                               [&] { saved = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, kLong));
    held_up("saving");
    open(path_, kLong);
    ASSERT_TRUE(settle(kLong));
    held_up("closing it");
}

TEST_F(Responsiveness, OpeningAndClosingAgainAndAgainLeavesNoMemoryBehind) {
    const int rounds = test::thorough() ? 200 : 4;
    double early = 0.0;
    for (int round = 0; round < rounds; ++round) {
        open(round % 2 == 0 ? path_ : QStringLiteral("generic"));
        ASSERT_TRUE(settle());
        if (round == rounds / 4) {
            early = memory();
        }
    }
    const double late = memory();
    std::printf("%d openings: %.0f MiB after a quarter, %.0f MiB at the end\n", rounds, early,
                late);
    if (test::thorough()) {
        EXPECT_LT(late, 1.1 * early + 20.0);
    }
}

/// A hand's move, from the event to the snapshot that has it; drawing left out.
TEST(Latency, OfADragIsAFrame) {
    GenericFaceOptions options;
    options.vertices = test::thorough() ? 100000 : 12000;
    const GenericFace generic = make_generic_face(options);
    const auto scan = std::make_shared<const Scan>(generic.scan);
    auto simulator = std::make_unique<Simulator>(fit_face(scan, generic.landmarks));
    const auto face = simulator->shared_face();
    SnapshotBox box;
    auto* worker = new SimulationWorker(box);
    QThread thread;
    worker->moveToThread(&thread);
    QObject::connect(&thread, &QThread::finished, worker, &QObject::deleteLater);
    std::atomic<std::int64_t> taken{0};  // when the event came that waits for its snapshot
    std::vector<double> latencies;
    QElapsedTimer clock;
    clock.start();
    QObject::connect(
        worker, &SimulationWorker::snapshotReady, worker,
        [&] {
            if (const std::int64_t at = taken.exchange(0); at != 0) {
                latencies.push_back(static_cast<double>(clock.nsecsElapsed() - at) / 1e6);
            }
        },
        Qt::DirectConnection);
    thread.start();
    const auto in_worker = [&](const std::function<void()>& call, Qt::ConnectionType how) {
        QMetaObject::invokeMethod(worker, call, how);
    };
    in_worker([&] { worker->setSimulator(std::move(simulator)); }, Qt::BlockingQueuedConnection);
    QThread::msleep(500);
    const Vec3 tip = face->landmarks.at("prn").position;
    const Bvh bvh(face->skin.mesh);
    DragRequest request;
    request.where = bvh.closest_point(face->skin.mesh, tip).where;
    const Vec3 start = position(face->skin.mesh, request.where);
    const Vec3 view = -Vec3::UnitZ();
    const auto ray = [&](double up) {
        return ViewRay{start + Vec3(0.0, up, 0.0) - 600.0 * view, view};
    };
    in_worker([&] { worker->beginDrag(request, ray(0.0)); }, Qt::BlockingQueuedConnection);
    const int events = test::thorough() ? 600 : 60;
    for (int k = 0; k < events; ++k) {
        const double up = 6.0 * std::sin(0.05 * k);
        const std::int64_t now = clock.nsecsElapsed();
        in_worker(
            [&, up, now] {
                worker->moveDrag(ray(up));
                taken = now;
            },
            Qt::QueuedConnection);
        QThread::usleep(16667);
    }
    in_worker([&] { worker->endDrag(false); }, Qt::BlockingQueuedConnection);
    thread.quit();
    thread.wait();
    ASSERT_GT(latencies.size(), static_cast<std::size_t>(events / 3));
    std::sort(latencies.begin(), latencies.end());
    const auto share = [&](double s) {
        return latencies[static_cast<std::size_t>(s * static_cast<double>(latencies.size() - 1))];
    };
    std::printf("%d events on %d nodes: median %.1f ms, 99 %% %.1f ms\n", events,
                face->node_count(), share(0.5), share(0.99));
    if (test::thorough()) {
        EXPECT_LE(share(0.99), 16.7);
    }
}

}  // namespace
}  // namespace myoface
