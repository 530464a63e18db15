// SPDX-License-Identifier: Apache-2.0
#include "myoface/io/mesh_file.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"

#include "test_meshes.h"

namespace myoface {
namespace {

const char* const kQuadObj =
    "\xEF\xBB\xBF# a comment\r\n"
    "mtllib skin.mtl\n"
    "v 0 0 0 1 0 0\nv 300 0 0 0 1 0\nv 300 300 \\\n0 0 0 1\nv +0 3e2 0 1 1 1\nv 150 450 0 0 0 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 1\n"
    "usemtl skin\n"
    "f 1/1 2/2 3/3 4/4\n"
    "f -2/4 -3/3 -1/5\n";

/// The sentence an action ends with; empty when it does not fail.
template <typename Action>
std::string problem_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

std::string read_problem(const std::string& bytes, const std::string& name) {
    return problem_of([&] { read_mesh_bytes(bytes, name); });
}

TEST(ObjReader, KeepsQuadsColoursUvAndOrder) {
    const Scan scan = read_mesh_bytes(kQuadObj, "quad.obj");
    EXPECT_EQ(scan.mesh.vertex_count(), 5);
    EXPECT_EQ(scan.faces.count(), 2);
    EXPECT_EQ(scan.faces.size(0), 4);
    EXPECT_EQ(scan.mesh.triangle_count(), 3);
    EXPECT_EQ(scan.colours.cols(), 5);
    EXPECT_FLOAT_EQ(scan.colours(1, 1), 1.0F);
    EXPECT_EQ(scan.faces.vertex[4], 3);  // -2
    EXPECT_EQ(scan.faces.uv[6], 4);
    EXPECT_DOUBLE_EQ(scan.file_vertices(1, 2), 300.0);
    EXPECT_EQ(scan.material_libraries.at(0), "skin.mtl");
}

TEST(ObjReader, TakesBytesOfColourForBytes) {
    const Scan scan = read_mesh_bytes(
        "v 0 0 0 255 128 0\nv 200 0 0 0 0 0\nv 0 200 0 0 0 0\nf 1 2 3\n", "bytes.obj");
    EXPECT_NEAR(scan.colours(1, 0), 128.0 / 255.0, 1e-6);
}

TEST(ObjReader, ClipsTheEarsOfAConcaveFace) {
    // An arrow head: a fan from the first corner would cover the notch.
    const Scan scan =
        read_mesh_bytes("v 0 0 0\nv 200 300 0\nv 0 100 0\nv -200 300 0\nf 4 1 2 3\n", "arrow.obj");
    ASSERT_EQ(scan.mesh.triangle_count(), 2);
    double area = 0.0;
    for (int t = 0; t < 2; ++t) {
        area += 0.5 * double_area_vector(scan.mesh, t).z();
    }
    EXPECT_NEAR(area, 20000.0, 1e-6);  // none is turned over
    for (int t = 0; t < 2; ++t) {
        EXPECT_GT(double_area_vector(scan.mesh, t).z(), 0.0);
    }
}

TEST(MeshFile, SaysFileLineAndReason) {
    EXPECT_EQ(read_problem("v 0 0 0\nv 1 zero 0\n", "a.obj"),
              "a.obj line 2: coordinate 'zero' is not a number.");
    EXPECT_EQ(read_problem("v 0 0 0\nv 1 nan 0\n", "a.obj"),
              "a.obj line 2: coordinate is not a finite number.");
    EXPECT_EQ(read_problem("v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 9\n", "a.obj"),
              "a.obj line 5: face vertex 9 does not exist (the file has 3).");
    EXPECT_NE(read_problem("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "a.obj").find("line 4"),
              std::string::npos);
    EXPECT_NE(read_problem("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj").find("no faces"),
              std::string::npos);
    EXPECT_EQ(read_problem("", "a.obj"), "a.obj: is empty.");
    EXPECT_NE(read_problem("v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "a.obj").find("one place"),
              std::string::npos);
    EXPECT_NE(problem_of([] { read_mesh("no/such/file.obj"); }).find("no such file"),
              std::string::npos);
    EXPECT_NE(problem_of([] { read_mesh("."); }).find("not a regular file"), std::string::npos);
}

class PlyEncodings : public ::testing::TestWithParam<FileFormat> {};

TEST_P(PlyEncodings, ComeBackBitForBit) {
    test::TemporaryFolder folder;
    Scan scan = read_mesh_bytes(kQuadObj, "quad.obj");
    scan.format = GetParam();
    scan.file_vertices(0, 0) = 0.1;  // no float has this value
    set_frame(scan, {1.0, Mat3::Identity()});
    write_mesh(folder / "a.ply", scan, scan.mesh.vertices);
    ReadOptions millimetres;
    millimetres.mm_per_unit = 1.0;
    const Scan back = read_mesh(folder / "a.ply", millimetres);
    EXPECT_EQ(back.format, GetParam());
    EXPECT_EQ(back.file_vertices, scan.file_vertices);
    EXPECT_EQ(back.faces.vertex, scan.faces.vertex);
    EXPECT_EQ(back.faces.start, scan.faces.start);
    EXPECT_EQ(back.colours, scan.colours);
    ASSERT_EQ(back.faces.uv.size(), scan.faces.uv.size());
    for (std::size_t c = 0; c < back.faces.uv.size(); ++c) {
        EXPECT_EQ(back.uv.col(back.faces.uv[c]), scan.uv.col(scan.faces.uv[c]));
    }
}
INSTANTIATE_TEST_SUITE_P(AllThree, PlyEncodings,
                         ::testing::Values(FileFormat::PlyAscii, FileFormat::PlyBinaryLittle,
                                           FileFormat::PlyBinaryBig));

TEST(ObjWriter, GivesBackWhatCame) {
    test::TemporaryFolder folder;
    const Scan scan = read_mesh_bytes(kQuadObj, "quad.obj");
    write_mesh(folder / "b.obj", scan, scan.mesh.vertices);
    const Scan back = read_mesh(folder / "b.obj");
    EXPECT_EQ(back.file_vertices, scan.file_vertices);
    EXPECT_EQ(back.faces.vertex, scan.faces.vertex);
    EXPECT_EQ(back.faces.uv, scan.faces.uv);
    EXPECT_EQ(back.uv, scan.uv);
    EXPECT_EQ(back.statements.at(0).text, "usemtl skin");
}

TEST(MeshWriter, MovesOnlyWhatMoved) {
    test::TemporaryFolder folder;
    Scan scan = read_mesh_bytes("v 0.1 0.2 0.3\nv 4 0 0\nv 0 4 0\nf 1 2 3\n", "c.obj");
    set_frame(scan, {53.2, axes_from_text("+x-z+y")});
    Points moved = scan.mesh.vertices;
    moved.col(1) += Vec3(0.0, 53.2, 0.0);  // our +y is the file's +z
    write_mesh(folder / "c.obj", scan, moved);
    const Scan back = read_mesh(folder / "c.obj");
    EXPECT_EQ(back.file_vertices.col(0), scan.file_vertices.col(0));
    EXPECT_NEAR(back.file_vertices(2, 1), 1.0, 1e-12);
}

TEST(MeshWriter, RefusesAFolderThatIsNotThereAndLeavesNothing) {
    const Scan scan = test::scan_of(test::sphere(100.0));
    EXPECT_NE(problem_of([&] {
                  write_mesh("/no/such/x.obj", scan, scan.mesh.vertices);
              }).find("cannot be written"),
              std::string::npos);
    EXPECT_NE(problem_of([&] { write_mesh("x.off", scan, scan.mesh.vertices); }).find(".obj"),
              std::string::npos);
}

TEST(PlyReader, RefusesLies) {
    const std::string head = "ply\nformat binary_little_endian 1.0\n";
    EXPECT_NE(read_problem(head + "element vertex 1000000000\nproperty float x\nproperty float "
                                  "y\nproperty float z\nend_header\n....",
                           "a.ply")
                  .find("truncated"),
              std::string::npos);
    EXPECT_NE(read_problem("ply\nformat ascii 1.0\nelement vertex 3\n", "a.ply").find("no end"),
              std::string::npos);
    EXPECT_NE(read_problem("ply\nformat ascii 1.0\nelement vertex 1\nproperty number x\n"
                           "end_header\n1\n",
                           "a.ply")
                  .find("unknown type"),
              std::string::npos);
    const std::string good =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_EQ(read_problem(good + "3 0 1 2\n", "a.ply"), "");
    EXPECT_NE(read_problem(good + "3 0 1 7\n", "a.ply").find("names vertex 7"), std::string::npos);
    EXPECT_NE(read_problem(good + "3 0 1\n", "a.ply").find("ends here"), std::string::npos);
    EXPECT_NE(read_problem(good + "200 0 1\n", "a.ply").find("impossible length"),
              std::string::npos);
    EXPECT_NE(read_problem(good + "2 0 1\n", "a.ply").find("fewer than three"), std::string::npos);
}

TEST(MeshFile, SurvivesEveryTruncationAndEveryFlippedByte) {
    test::TemporaryFolder folder;
    Scan scan = test::scan_of(test::sphere(100.0, 3, 4));
    std::vector<std::string> originals{kQuadObj};
    for (const FileFormat format : {FileFormat::PlyAscii, FileFormat::PlyBinaryLittle}) {
        scan.format = format;
        write_mesh(folder / "s.ply", scan, scan.mesh.vertices);
        originals.push_back(read_file(folder / "s.ply"));
    }
    for (const std::string& original : originals) {
        const std::string name = original.substr(0, 3) == "ply" ? "s.ply" : "s.obj";
        for (std::size_t i = 0; i < original.size(); ++i) {
            std::string flipped = original;
            flipped[i] = static_cast<char>(flipped[i] ^ 0x5A);
            for (const std::string& bad : {original.substr(0, i), flipped}) {
                try {
                    const Scan read = read_mesh_bytes(bad, name);
                    ASSERT_TRUE(read.mesh.vertices.allFinite());
                    ASSERT_LT(read.mesh.triangles.maxCoeff(), read.mesh.vertex_count());
                    ASSERT_GE(read.mesh.triangles.minCoeff(), 0);
                } catch (const IoError& error) {
                    ASSERT_GT(std::string(error.what()).size(), 10U);
                }
            }
        }
    }
}

TEST(Unit, IsGuessedFromTheSizeOfAHead) {
    for (const auto& [size, millimetres] : {std::pair(130.0, 1.0), std::pair(13.0, 10.0),
                                            std::pair(1.3, 100.0), std::pair(0.13, 1000.0)}) {
        test::TemporaryFolder folder;
        Scan scan = test::scan_of(test::sphere(size));
        write_mesh(folder / "u.ply", scan, scan.mesh.vertices);
        EXPECT_DOUBLE_EQ(read_mesh(folder / "u.ply").frame.mm_per_unit, millimetres);
    }
}

TEST(Unit, IsReadByNameOrNumber) {
    EXPECT_DOUBLE_EQ(millimetres_per_unit("dm"), 100.0);
    EXPECT_DOUBLE_EQ(millimetres_per_unit("53.2"), 53.2);
    EXPECT_THROW(millimetres_per_unit("ell"), InvalidInput);
    EXPECT_THROW(millimetres_per_unit("-1"), InvalidInput);
}

TEST(Axes, MustBeATurn) {
    EXPECT_EQ(axes_from_text("+x+y+z"), Mat3(Mat3::Identity()));
    EXPECT_THROW(axes_from_text("-x+y+z"), InvalidInput);  // a mirror image
    EXPECT_THROW(axes_from_text("+x+x+z"), InvalidInput);
    EXPECT_THROW(axes_from_text("up"), InvalidInput);
}

TEST(Axes, AreSpeltAsTheyAreRead) {
    for (const char* text : {"+x+y+z", "+x-z+y", "-y+x+z", "+z+x+y"}) {
        EXPECT_EQ(axes_to_text(axes_from_text(text)), text);
    }
}

TEST(Describe, CountsWhatWasFound) {
    const Scan scan = test::scan_of(test::together(test::sphere(100.0), test::grid(3, 10.0)));
    const MeshReadReport report = describe(scan);
    EXPECT_EQ(report.findings.parts.size(), 2U);
    EXPECT_EQ(report.findings.holes, 1);
    EXPECT_NEAR(report.longest_hole_mm, 80.0, 1e-9);
    EXPECT_FALSE(report.findings.inward);
    EXPECT_EQ(report.findings.turned_triangles, 0);
    EXPECT_NEAR(report.findings.parts[1].area, 400.0, 1e-9);
    EXPECT_TRUE(report.findings.parts[1].high.isApprox(Vec3(20, 20, 0)));
}

TEST(Examine, TurnsInwardFacesAndKeepsTheFilesOwn) {
    TriangleMesh mesh = test::sphere(100.0);
    mesh.triangles.row(0).swap(mesh.triangles.row(1));
    const Scan scan = test::scan_of(mesh);
    EXPECT_TRUE(scan.findings.inward);
    for (int t = 0; t < scan.mesh.triangle_count(); ++t) {
        const Vec3 middle = scan.mesh.corner(t, 0) + scan.mesh.corner(t, 1);
        EXPECT_GT(middle.dot(double_area_vector(scan.mesh, t)), 0.0);
    }
    EXPECT_EQ(scan.faces.vertex[1], mesh.triangles(1, 0));
}

TEST(Examine, MakesNeighboursAgree) {
    TriangleMesh mesh = test::sphere(100.0);
    for (const int t : {3, 40, 41, 300}) {
        std::swap(mesh.triangles(0, t), mesh.triangles(1, t));
    }
    const Scan scan = test::scan_of(mesh);
    EXPECT_EQ(scan.findings.turned_triangles, 4);
    EXPECT_FALSE(scan.findings.inward);
    for (int t = 0; t < scan.mesh.triangle_count(); ++t) {
        const Vec3 middle = scan.mesh.corner(t, 0) + scan.mesh.corner(t, 1);
        EXPECT_GT(middle.dot(double_area_vector(scan.mesh, t)), 0.0) << t;
    }
}

TEST(Examine, CountsDuplicatesStraysAndFins) {
    const Scan scan = read_mesh_bytes(
        "v 0 0 0\nv 300 0 0\nv 0 300 0\nv 0 0 300\nv 9 9 9\nv 300 0 0\nv 0 -300 0\n"
        "f 1 2 3\nf 2 3 1\nf 1 6 4\nf 1 1 2\nf 1 2 7\n",
        "odd.obj");
    EXPECT_EQ(scan.findings.duplicate_triangles, 1);
    EXPECT_EQ(scan.findings.degenerate_triangles, 1);
    EXPECT_EQ(scan.findings.unreferenced_vertices, 1);
    EXPECT_EQ(scan.findings.duplicate_vertices, 1);
    EXPECT_EQ(scan.findings.non_manifold_edges, 1);
    EXPECT_EQ(scan.faces.count(), 5);
    EXPECT_EQ(scan.mesh.vertex_count(), 7);
}

}  // namespace
}  // namespace myoface
