// SPDX-License-Identifier: Apache-2.0
#include "myoface/cases/case_file.h"

#include <fstream>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"

#include "test_meshes.h"

namespace myoface {
namespace {

/// The small face on disk with its landmarks beside it, opened.
struct OnDisk {
    test::TemporaryFolder folder;
    std::string path;

    OnDisk() {
        path = (folder / "face.ply").string();
        write_mesh(path, test::small_face().scan, test::small_face().scan.mesh.vertices);
        write_landmarks(folder / "face.landmarks.json", test::small_face().landmarks, {});
    }
};

TEST(OpenFace, FindsLandmarksBesideTheScan) {
    const OnDisk disk;
    const OpenedFace face = open_face(disk.path);
    ASSERT_TRUE(face.landmarks);
    EXPECT_EQ(face.landmarks->size(), test::small_face().landmarks.size());
    EXPECT_DOUBLE_EQ(face.report.mm_per_unit, 1.0);
}

TEST(OpenFace, WithoutLandmarksSaysWhatToDo) {
    const OnDisk disk;
    std::filesystem::remove(disk.folder / "face.landmarks.json");
    const OpenedFace face = open_face(disk.path);
    EXPECT_FALSE(face.landmarks);
    try {
        make_simulator(face);
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("--landmarks"), std::string::npos);
    }
}

TEST(CaseFile, GivesBackScanLandmarksMusclesAndShape) {
    const OnDisk disk;
    const OpenedFace opened = open_face(disk.path);
    const auto simulator = make_simulator(opened);
    simulator->set_contraction(3, 0.5);
    simulator->set_strength(4, 0.25);
    Points rest = simulator->skin_rest();
    rest.col(100) += Vec3(1.0, 2.0, 3.0);
    simulator->set_skin_rest(rest);
    const std::string file = (disk.folder / "c.myoface").string();
    write_case(file, opened,
               case_state(simulator->face(), simulator->contractions(), simulator->skin_rest()));

    const OpenedFace back = open_face(file);
    EXPECT_EQ(back.scan_bytes, opened.scan_bytes);
    EXPECT_EQ(back.scan->mesh.vertices, opened.scan->mesh.vertices);
    const auto again = make_simulator(back);
    EXPECT_EQ(again->contractions().rate, simulator->contractions().rate);
    EXPECT_EQ(again->contractions().strength, simulator->contractions().strength);
    EXPECT_LT((again->skin_rest() - rest).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(CaseFile, RefusesWhatIsNotACase) {
    const OnDisk disk;
    const std::string file = (disk.folder / "bad.myoface").string();
    EXPECT_THROW(open_face(file), IoError);  // not there
    std::ofstream(file) << "this is no archive";
    EXPECT_THROW(open_face(file), IoError);
}

TEST(CaseFile, SurvivesTruncation) {
    const OnDisk disk;
    const OpenedFace opened = open_face(disk.path);
    const std::string file = (disk.folder / "c.myoface").string();
    write_case(file, opened, {});
    const std::string whole = read_file(file);
    for (std::size_t size = 0; size < whole.size(); size += whole.size() / 37) {
        write_file(file, whole.substr(0, size));
        EXPECT_THROW(open_face(file), IoError) << size;
    }
}

TEST(CaseFile, IsNotTouchedWhenItCannotBeWritten) {
    const OnDisk disk;
    const OpenedFace opened = open_face(disk.path);
    EXPECT_THROW(write_case("/no/such/folder/c.myoface", opened, {}), IoError);
}

}  // namespace
}  // namespace myoface
