// SPDX-License-Identifier: Apache-2.0
// What survives when a program ends in the middle.
#include "myoface/cases/journal.h"

#include <csignal>
#include <random>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/io/mesh_file.h"
#include "myoface/io/text_file.h"

#include "test_meshes.h"
#include "thorough.h"

namespace myoface {
namespace {

OpenedFace small_scan(const std::filesystem::path& folder) {
    const TriangleMesh mesh = test::sphere(90.0);
    write_mesh(folder / "a.ply", test::scan_of(mesh), mesh.vertices);
    OpenOptions options;
    options.axes = Mat3::Identity();
    options.mm_per_unit = 1.0;
    return open_face((folder / "a.ply").string(), options);
}

/// The state after so many gestures: everything in it says the number.
CaseState state_after(int gestures, Eigen::Index vertices) {
    CaseState state;
    state.rates["risorius.L"] = 1e-4 * gestures;
    state.strengths["risorius.R"] = 1.0 - 1e-4 * gestures;
    state.notes = "gesture " + std::to_string(gestures);
    state.skin_age = 20.0 + gestures % 50;
    state.shape = Points::Zero(3, vertices);
    for (Eigen::Index v = 0; v < vertices; v += 3) {
        state.shape.col(v) << gestures, double(v), 0.5;
    }
    state.protection = Eigen::VectorXd::Zero(vertices);
    state.protection[1] = 0.25;
    state.variants.push_back({"A", state.rates, {}, state.shape});
    return state;
}

void expect_state(const CaseState& state, int gestures, Eigen::Index vertices) {
    const CaseState expected = state_after(gestures, vertices);
    EXPECT_EQ(state.rates, expected.rates);
    EXPECT_EQ(state.strengths, expected.strengths);
    EXPECT_EQ(state.notes, expected.notes);
    EXPECT_EQ(state.skin_age, expected.skin_age);
    EXPECT_EQ(state.shape, expected.shape);
    EXPECT_EQ(state.protection, expected.protection);
    ASSERT_EQ(state.variants.size(), 1U);
    EXPECT_EQ(state.variants[0].shape, expected.shape);
}

/// What a program that was killed while it saved again and again left: nothing, or a whole case.
void expect_whole_case(const std::string& path, int gestures, Eigen::Index vertices) {
    if (!std::filesystem::exists(path)) {
        EXPECT_LE(gestures, 3);  // killed before the first was whole
        return;
    }
    const OpenedFace saved = read_case(path);
    ASSERT_EQ(saved.state.notes.rfind("gesture ", 0), 0U);
    const int then = std::stoi(saved.state.notes.substr(8));
    EXPECT_LE(then, gestures);
    EXPECT_GE(then, gestures - 3);
    expect_state(saved.state, then, vertices);
}

TEST(Journal, GivesBackTheLastFinishedGestureAfterAKill) {
    const test::TemporaryFolder folder;
    const OpenedFace face = small_scan(folder / "");
    const Eigen::Index vertices = face.scan->mesh.vertices.cols();
    std::mt19937 random(7);
    const int kills = test::thorough() ? 500 : 60;
    for (int trial = 0; trial < kills; ++trial) {
        const std::string saved = (folder / ("s" + std::to_string(trial) + ".myoface")).string();
        const std::filesystem::path journals = folder / ("j" + std::to_string(trial));
        int pipe_ends[2];
        ASSERT_EQ(::pipe(pipe_ends), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            ::close(pipe_ends[0]);
            Journal journal(journals, face);
            for (int k = 1;; ++k) {
                journal.record(state_after(k, vertices), {}, {});
                if (::write(pipe_ends[1], &k, sizeof k) != sizeof k) {
                    ::_exit(1);
                }
                if (k % 2 == 1) {
                    write_case(saved, face, state_after(k, vertices));
                }
            }
        }
        ::close(pipe_ends[1]);
        int finished = 0;
        ASSERT_EQ(::read(pipe_ends[0], &finished, sizeof finished), ssize_t(sizeof finished));
        ::usleep(std::uniform_int_distribution<unsigned>(0, 25000)(random));
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        for (int k = 0; ::read(pipe_ends[0], &k, sizeof k) == ssize_t(sizeof k);) {
            finished = k;
        }
        ::close(pipe_ends[0]);
        const std::vector<Recovery> found = recoverable(journals);
        ASSERT_EQ(found.size(), 1U) << trial;
        EXPECT_EQ(found[0].name, "a.ply");
        ASSERT_GE(found[0].gestures, finished);
        ASSERT_LE(found[0].gestures, finished + 1);  // done, but the kill came before the word
        const OpenedFace back = recover(found[0]);
        EXPECT_EQ(back.scan_bytes, face.scan_bytes);
        expect_state(back.state, found[0].gestures, vertices);
        expect_whole_case(saved, found[0].gestures, vertices);
        discard(found[0]);
        EXPECT_TRUE(recoverable(journals).empty());
    }
}

TEST(Journal, OfAProgramThatLivesIsNotOffered) {
    const test::TemporaryFolder folder;
    const OpenedFace face = small_scan(folder / "");
    {
        Journal journal(folder / "j", face);
        journal.record(state_after(1, face.scan->mesh.vertices.cols()), {}, {});
        EXPECT_TRUE(recoverable(folder / "j").empty());
    }
    EXPECT_EQ(recoverable(folder / "j").size(), 1U);
    Journal second(folder / "j", face);
    second.record({}, {}, {});
    second.finish();
    EXPECT_EQ(recoverable(folder / "j").size(), 1U);
}

TEST(Journal, OfDamagedRecordsSaysSo) {
    const test::TemporaryFolder folder;
    const OpenedFace face = small_scan(folder / "");
    {
        Journal journal(folder / "j", face);
        journal.record(state_after(3, face.scan->mesh.vertices.cols()), {}, {});
    }
    const Recovery recovery = recoverable(folder / "j").at(0);
    const std::string whole = read_file(recovery.folder / "state");
    std::mt19937 random(3);
    for (int trial = 0; trial < 200; ++trial) {
        std::string bytes = whole;
        bytes[std::uniform_int_distribution<std::size_t>(8, bytes.size() - 1)(random)] ^= 0x20;
        bytes.resize(trial % 2 == 0 ? bytes.size() : bytes.size() * std::size_t(trial) / 200);
        write_file(recovery.folder / "state", bytes);
        EXPECT_THROW(recover(recovery), IoError) << trial;
    }
}

TEST(CaseFile, OnAFullDiskLeavesTheOldOne) {
    const test::TemporaryFolder folder;
    const OpenedFace face = small_scan(folder / "");
    const std::filesystem::path file = folder / "c.myoface";
    write_case(file, face, state_after(1, face.scan->mesh.vertices.cols()));
    const std::string before = read_file(file);
    const pid_t child = ::fork();
    if (child == 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{4096, 4096};  // no file may be larger: as on a full disk
        ::setrlimit(RLIMIT_FSIZE, &small);
        try {
            write_case(file, face, state_after(2, face.scan->mesh.vertices.cols()));
        } catch (const IoError& error) {
            ::_exit(std::string(error.what()).find("cannot be written") != std::string::npos ? 0
                                                                                             : 2);
        }
        ::_exit(3);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
    EXPECT_EQ(read_file(file), before);
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "")) {
        files += entry.path().filename().string().rfind("c.myoface", 0) == 0 ? 1 : 0;
    }
    EXPECT_EQ(files, 1);  // nothing half written lies about
}

TEST(CaseFile, KeepsVariantsNotesAndProtection) {
    const test::TemporaryFolder folder;
    const OpenedFace face = small_scan(folder / "");
    const Eigen::Index vertices = face.scan->mesh.vertices.cols();
    write_case(folder / "c.myoface", face, state_after(5, vertices));
    expect_state(read_case((folder / "c.myoface").string()).state, 5, vertices);
}

TEST(CaseFile, OfDamagedBytesIsRefusedOrWhole) {
    const test::TemporaryFolder folder;
    const OpenedFace face = small_scan(folder / "");
    write_case(folder / "c.myoface", face, state_after(5, face.scan->mesh.vertices.cols()));
    const std::string whole = read_file(folder / "c.myoface");
    std::mt19937 random(11);
    int refused = 0;
    constexpr int kTrials = 300;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::string bytes = whole;
        for (int k = 0; k < 1 + trial % 4; ++k) {
            bytes[std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random)] ^=
                static_cast<char>(1 << (trial % 8));
        }
        write_file(folder / "bad.myoface", bytes);
        try {
            const OpenedFace back = read_case((folder / "bad.myoface").string());
            EXPECT_TRUE(back.state.shape.allFinite());
        } catch (const Error& error) {
            ++refused;
            EXPECT_GT(std::string(error.what()).size(), 15U);
        }
    }
    EXPECT_GT(refused, kTrials / 2);  // zip keeps a sum of every part
}

}  // namespace
}  // namespace myoface
