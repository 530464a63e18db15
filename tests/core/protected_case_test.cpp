// SPDX-License-Identifier: Apache-2.0
// Passphrases, pseudonyms, plans and thumbnails in cases; many cases; disks that are full.
#include <random>
#include <sys/mount.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/cases/journal.h"
#include "myoface/io/text_file.h"

#include "test_meshes.h"

namespace myoface {
namespace {

OpenedFace scan_named(const test::TemporaryFolder& folder, const std::string& name) {
    const TriangleMesh mesh = test::sphere(90.0, 8, 12);
    write_mesh(folder / name, test::scan_of(mesh), mesh.vertices);
    OpenOptions options;
    options.axes = Mat3::Identity();
    options.mm_per_unit = 1.0;
    return open_face((folder / name).string(), options);
}

std::string refusal(const std::string& path, const OpenOptions& options) {
    try {
        open_face(path, options);
        return "opened";
    } catch (const PassphraseNeeded& locked) {
        return (locked.given() ? "wrong: " : "missing: ") + std::string(locked.what());
    }
}

TEST(ProtectedCase, OpensWithItsPassphraseOnly) {
    const test::TemporaryFolder folder;
    OpenedFace face = scan_named(folder, "a.ply");
    face.passphrase = "seven quiet herons";
    face.thumbnail = "no png, but bytes";
    CaseState state;
    state.notes = "a note that nobody else may read";
    const std::string path = (folder / "c.myoface").string();
    write_case(path, face, state);
    OpenOptions options;
    EXPECT_EQ(refusal(path, options),
              "missing: " + path + ": is protected by a passphrase, which is needed to open it.");
    options.passphrase = "eight loud herons";
    EXPECT_EQ(refusal(path, options),
              "wrong: " + path + ": is protected by another passphrase than this one.");
    options.passphrase = face.passphrase;
    const OpenedFace back = open_face(path, options);
    EXPECT_EQ(back.state.notes, state.notes);
    EXPECT_EQ(back.scan_bytes, face.scan_bytes);
    EXPECT_EQ(back.passphrase, face.passphrase);  // saved again, it is protected again
    EXPECT_EQ(case_thumbnail(path), "");
    const std::string bytes = read_file(path);
    EXPECT_EQ(bytes.find("herons"), std::string::npos);
    EXPECT_EQ(bytes.find("a note"), std::string::npos);
    EXPECT_EQ(bytes.find(face.scan_bytes.substr(200, 60)), std::string::npos);
}

TEST(ProtectedCase, OfOneFlippedBitIsRefusedNotMisread) {
    const test::TemporaryFolder folder;
    OpenedFace face = scan_named(folder, "a.ply");
    face.passphrase = "seven quiet herons";
    write_case(folder / "c.myoface", face, {});
    const std::string whole = read_file(folder / "c.myoface");
    OpenOptions options;
    options.passphrase = face.passphrase;
    std::mt19937 random(5);
    for (int trial = 0; trial < 60; ++trial) {
        std::string bytes = whole;
        bytes[std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random)] ^= 1;
        write_file(folder / "bad.myoface", bytes);
        try {  // a name or a time of the zip may change without harm
            EXPECT_EQ(read_case((folder / "bad.myoface").string(), options).scan_bytes,
                      face.scan_bytes);
        } catch (const Error& error) {
            EXPECT_GT(std::string(error.what()).size(), 15U);
        }
    }
}

TEST(ProtectedCase, HasAProtectedJournal) {
    const test::TemporaryFolder folder;
    OpenedFace face = scan_named(folder, "a.ply");
    face.passphrase = "seven quiet herons";
    CaseState state;
    state.notes = "nobody else";
    {
        Journal journal(folder / "j", face);
        journal.record(state, {}, {});
    }
    const Recovery recovery = recoverable(folder / "j").at(0);
    EXPECT_TRUE(recovery.locked);
    EXPECT_EQ(recovery.gestures, 1);
    EXPECT_EQ(read_file(recovery.folder / "state").find("nobody else"), std::string::npos);
    EXPECT_THROW(recover(recovery), PassphraseNeeded);
    EXPECT_THROW(recover(recovery, nullptr, "another one"), PassphraseNeeded);
    EXPECT_EQ(recover(recovery, nullptr, face.passphrase).state.notes, "nobody else");
}

TEST(CaseFile, SaysNothingOfTheNamesOfFiles) {
    const test::TemporaryFolder folder;
    const OpenedFace face = scan_named(folder, "yamada_taro.ply");
    write_case(folder / "c.myoface", face, {});
    const OpenedFace back = read_case((folder / "c.myoface").string());
    EXPECT_EQ(back.scan_name, "scan.ply");
    EXPECT_EQ(back.pseudonym.rfind("MF-", 0), 0U);
    EXPECT_EQ(back.pseudonym, pseudonym_of(*face.scan));  // the same scan, the same name
    OpenedFace named = back;
    named.pseudonym = "MF-CHOSEN";
    write_case(folder / "d.myoface", named, {});
    EXPECT_EQ(read_case((folder / "d.myoface").string()).pseudonym, "MF-CHOSEN");
}

TEST(CaseFile, KeepsThePlanAndTheThumbnail) {
    const test::TemporaryFolder folder;
    OpenedFace face = scan_named(folder, "a.ply");
    face.thumbnail = std::string("\x89PNG\0bytes", 10);
    CaseState state;
    state.plan = {PlanOrigin{}, {parse_drag("at=prn; move=1,2"), StrengthEdit{"risorius.L", 0.5}}};
    write_case(folder / "c.myoface", face, state);
    const OpenedFace back = read_case((folder / "c.myoface").string());
    EXPECT_EQ(recorded_plan_to_json(back.state.plan), recorded_plan_to_json(state.plan));
    EXPECT_EQ(back.thumbnail, face.thumbnail);
    EXPECT_EQ(case_thumbnail(folder / "c.myoface"), face.thumbnail);
    EXPECT_EQ(case_thumbnail(folder / "a.ply"), "");
}

TEST(CaseFile, AThousandComeBackEqual) {
    const test::TemporaryFolder folder;
    const OpenedFace face = scan_named(folder, "a.ply");
    const Eigen::Index vertices = face.scan->mesh.vertices.cols();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int k = 0; k < 1000; ++k) {
        CaseState state;
        state.rates["risorius.L"] = 0.5 * number(random);
        state.strengths["mentalis"] = std::abs(number(random));
        state.notes = std::to_string(number(random)) + " \xe6\xb3\xa8";
        state.shape = Points::Zero(3, vertices);
        state.shape.col(k % vertices) << number(random), number(random), number(random);
        state.protection = Eigen::VectorXd::Constant(vertices, std::abs(number(random)));
        state.variants.push_back({"A", state.rates, state.strengths, 2.0 * state.shape});
        const std::string path = (folder / "c.myoface").string();
        write_case(path, face, state);
        const CaseState back = read_case(path).state;
        ASSERT_EQ(back.rates, state.rates);
        ASSERT_EQ(back.strengths, state.strengths);
        ASSERT_EQ(back.notes, state.notes);
        ASSERT_EQ(back.shape, state.shape);
        ASSERT_EQ(back.protection, state.protection);
        ASSERT_EQ(back.variants.at(0).shape, state.variants[0].shape);
    }
}

/// A disk of a megabyte, where the test may make one.
class SmallDisk {
public:
    explicit SmallDisk(const std::filesystem::path& place) : place_(place) {
        std::filesystem::create_directories(place);
        mounted_ = ::mount("tmpfs", place.c_str(), "tmpfs", 0, "size=1m") == 0;
    }
    ~SmallDisk() {
        if (mounted_) {
            ::umount2(place_.c_str(), MNT_DETACH);
        }
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    bool mounted() const { return mounted_; }
    bool make_read_only() const {
        return ::mount("tmpfs", place_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=1m") == 0;
    }

private:
    std::filesystem::path place_;
    bool mounted_ = false;
};

TEST(FullDisk, LeavesTheOldCaseAndTheOldJournal) {
    const test::TemporaryFolder folder;
    const SmallDisk disk(folder / "disk");
    if (!disk.mounted()) {
        GTEST_SKIP() << "needs the right to mount a small disk";
    }
    const OpenedFace face = scan_named(folder, "a.ply");
    const std::filesystem::path file = folder / "disk" / "c.myoface";
    CaseState first;
    first.notes = "first";
    write_case(file, face, first);
    Journal journal(folder / "disk" / "j", face);
    journal.record(first, {}, {});
    const std::string before = read_file(file);
    // Fill it up to the last kilobytes.
    std::string filler(1 << 20, 'x');
    while (filler.size() > 2048) {
        try {
            write_file(folder / "disk" / ("filler" + std::to_string(filler.size())), filler);
        } catch (const IoError&) {
        }
        filler.resize(filler.size() / 2);
    }
    CaseState second;
    std::mt19937 random(2);
    for (int k = 0; k < 60'000; ++k) {  // does not shrink when packed
        second.notes += static_cast<char>('!' + random() % 90);
    }
    for (const auto& attempt : {std::function<void()>([&] { write_case(file, face, second); }),
                                std::function<void()>([&] { journal.record(second, {}, {}); })}) {
        try {
            attempt();
            ADD_FAILURE() << "a full disk was not noticed";
        } catch (const IoError& error) {
            EXPECT_NE(std::string(error.what()).find("not full"), std::string::npos)
                << error.what();
        }
    }
    EXPECT_EQ(read_file(file), before);
    EXPECT_EQ(read_case(file.string()).state.notes, "first");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "disk")) {
        EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
    }
}

TEST(ReadOnlyDisk, IsToldInASentence) {
    const test::TemporaryFolder folder;
    const SmallDisk disk(folder / "disk");
    if (!disk.mounted()) {
        GTEST_SKIP() << "needs the right to mount a small disk";
    }
    const OpenedFace face = scan_named(folder, "a.ply");
    const std::filesystem::path file = folder / "disk" / "c.myoface";
    write_case(file, face, {});
    const std::string before = read_file(file);
    ASSERT_TRUE(disk.make_read_only());
    CaseState state;
    state.notes = "later";
    EXPECT_THROW(write_case(file, face, state), IoError);
    EXPECT_THROW(Journal(folder / "disk" / "j", face), IoError);
    EXPECT_EQ(read_file(file), before);
}

}  // namespace
}  // namespace myoface
