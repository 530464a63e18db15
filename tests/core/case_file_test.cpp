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

TEST(KnownDistance, IsReadOrRefused) {
    const KnownDistance known = parse_known_distance("from=en_l; to=vertex 7; mm=31.5");
    EXPECT_EQ(known.from, "en_l");
    EXPECT_EQ(known.to, "vertex 7");
    EXPECT_DOUBLE_EQ(known.mm, 31.5);
    for (const char* bad : {"", "from=a; to=b", "from=a; to=b; mm=-1", "from=a; to=b; mm=x",
                            "from=a; to=b; mm=1; by=2", "from a to b"}) {
        EXPECT_THROW(parse_known_distance(bad), InvalidInput) << bad;
    }
}

TEST(OpenFace, IsCalibratedByAKnownDistance) {
    const test::TemporaryFolder folder;
    write_mesh(folder / "a.ply", test::scan_of(test::sphere(100.0)), test::sphere(100.0).vertices);
    OpenOptions options;
    options.axes = Mat3::Identity();
    options.known = KnownDistance{"0,0,-100", "0,0,100", 50.0};
    const OpenedFace face = open_face((folder / "a.ply").string(), options);
    EXPECT_NEAR(face.report.mm_per_unit, 0.25, 1e-12);
    EXPECT_NEAR(face.scan->mesh.vertices.row(2).maxCoeff(), 25.0, 0.2);
    EXPECT_FALSE(face.report.unit_is_guess);
    for (const char* nowhere : {"nose", "vertex 99999", "vertex -1", "1,2"}) {
        options.known = KnownDistance{nowhere, "0,0,100", 50.0};
        EXPECT_THROW(open_face((folder / "a.ply").string(), options), InvalidInput) << nowhere;
    }
}

TEST(CaseFile, CarriesTheShapeIntoAnotherFrame) {
    const test::TemporaryFolder folder;
    OpenedFace face = open_face("generic");
    CaseState state;
    state.shape = Points::Zero(3, 5);
    state.shape.col(2) << 0.0, 2.0, 0.0;
    write_case(folder / "c.myoface", face, state);
    OpenOptions options;
    options.mm_per_unit = 10.0 * face.scan->frame.mm_per_unit;
    options.axes = axes_from_text("+x-z+y");  // the file's y is our -z
    const OpenedFace back = open_face((folder / "c.myoface").string(), options);
    EXPECT_TRUE(back.state.shape.col(2).isApprox(Vec3(0.0, 0.0, -20.0)));
}

TEST(CaseFile, KeepsMaterialsAndPictures) {
    const test::TemporaryFolder folder;
    write_png(folder / "skin.png", {1, 1, {200, 150, 130, 255}});
    write_file(folder / "a.mtl", "newmtl skin\nKd 0.5 1 1\nmap_Kd skin.png\n");
    write_file(folder / "a.obj",
               "mtllib a.mtl\nv 0 0 0\nv 200 0 0\nv 0 200 0\nvt 0 0\nusemtl skin\n"
               "f 1/1 2/1 3/1\n");
    const OpenedFace face = open_face((folder / "a.obj").string());
    ASSERT_NE(face.texture, nullptr);
    write_case(folder / "c.myoface", face, {});
    std::filesystem::remove(folder / "skin.png");
    const OpenedFace back = open_face((folder / "c.myoface").string());
    ASSERT_NE(back.texture, nullptr);
    EXPECT_EQ(back.texture->image.rgba, face.texture->image.rgba);
    EXPECT_EQ(back.scan->materials.at(0).colour, face.scan->materials.at(0).colour);
}

}  // namespace
}  // namespace myoface
