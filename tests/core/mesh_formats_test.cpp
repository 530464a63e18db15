// SPDX-License-Identifier: Apache-2.0
// Files of every format: what is read, and that nothing is lost on the way back.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/io/interchange.h"
#include "myoface/io/mesh_file.h"
#include "myoface/io/skin_texture.h"
#include "myoface/io/text_file.h"

#include "test_meshes.h"

namespace myoface {
namespace {

namespace fs = std::filesystem;

/// The smallest picture there is.
const std::string& png() {
    static const std::string kBytes = [] {
        const test::TemporaryFolder folder;
        write_png(folder / "p.png", {1, 1, {200, 150, 130, 255}});
        return read_file(folder / "p.png");
    }();
    return kBytes;
}

void put(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    write_file(file, text);
}

/// Quads, a concave pentagon, a seam, colours with opacity, two materials with pictures.
Scan rich_scan() {
    const test::TemporaryFolder folder;
    put(folder / "rich.mtl",
        "newmtl skin of face\nKd 0.5 0.25 1\nmap_Kd -s 1 1 1 -clamp on C:\\scans\\skin one.png\n"
        "newmtl hair\nKd 0 0 0\nd 0.5\nmap_Kd hair.png\n");
    put(folder / "skin one.png", png());
    put(folder / "hair.png", png());
    put(folder / "rich.obj",
        "mtllib rich.mtl\n"
        "v 0 0 0 0.1 0.2 0.3\nv 100.1 0 0 0 0 0\nv 200 0 0 1 1 1\nv 0 150 0 0 1 0\n"
        "v 100 150 20 1 0 0\nv 200 150 0 0 0 1\nv 100 60 5 0.5 0.5 0.5\n"
        "vt 0 0\nvt 0.5 0\nvt 1 0\nvt 0 1\nvt 0.5 1\nvt 0.25 0.75\nvt 1 1\n"
        "usemtl skin of face\nf 1/1 2/2 5/5 4/4\nusemtl hair\n"
        "f 2/2 3/3 6/7 5/6 7/2\n");
    return read_mesh(folder / "rich.obj");
}

void expect_same(const Scan& a, const Scan& b) {
    EXPECT_EQ(a.file_vertices, b.file_vertices);
    EXPECT_EQ(a.faces.start, b.faces.start);
    EXPECT_EQ(a.faces.vertex, b.faces.vertex);
    EXPECT_EQ(a.colours, b.colours);
    EXPECT_EQ(a.alpha, b.alpha);
    EXPECT_EQ(a.face_material, b.face_material);
    ASSERT_EQ(a.faces.uv.size(), b.faces.uv.size());
    for (std::size_t c = 0; c < a.faces.uv.size(); ++c) {
        ASSERT_EQ(a.faces.uv[c] < 0, b.faces.uv[c] < 0);
        if (a.faces.uv[c] >= 0) {
            EXPECT_EQ(a.uv.col(a.faces.uv[c]), b.uv.col(b.faces.uv[c]));
        }
    }
    ASSERT_EQ(a.textures.size(), b.textures.size());
    for (std::size_t t = 0; t < a.textures.size(); ++t) {
        EXPECT_EQ(a.textures[t].bytes, b.textures[t].bytes);
    }
}

Scan again(const Scan& scan, const char* name) {
    const test::TemporaryFolder folder;
    write_mesh(folder / name, scan, scan.mesh.vertices);
    return read_mesh(folder / name);
}

TEST(RichObj, IsReadWithAllItsMaterials) {
    const Scan scan = rich_scan();
    ASSERT_EQ(scan.materials.size(), 2U);
    EXPECT_EQ(scan.materials[0].name, "skin of face");
    EXPECT_FLOAT_EQ(scan.materials[0].colour[1], 0.25F);
    EXPECT_FLOAT_EQ(scan.materials[1].colour[3], 0.5F);
    EXPECT_EQ(scan.face_material, (std::vector<int>{0, 1}));
    ASSERT_EQ(scan.textures.size(), 2U);
    EXPECT_EQ(scan.textures[0].bytes, png());  // found under its name, without the other folders
    EXPECT_EQ(scan.mesh.triangle_count(), 5);
}

TEST(SkinTexture, PutsSeveralPicturesIntoOne) {
    Scan scan = rich_scan();
    const test::TemporaryFolder folder;
    write_png(folder / "red.png", {1, 1, {255, 0, 0, 255}});
    scan.textures[0].bytes = read_file(folder / "red.png");
    scan.materials.push_back({"paint", {0.0F, 1.0F, 0.0F, 1.0F}, -1});
    const auto texture = load_texture(scan);
    ASSERT_NE(texture, nullptr);
    ASSERT_EQ(texture->tiles.size(), 3U);
    const auto colour_at = [&](int material, const Eigen::Vector2f& uv) {
        const Eigen::Vector2f at = place_in_texture(texture.get(), material, uv);
        const int x = static_cast<int>(at.x() * static_cast<float>(texture->image.width - 1));
        const int y = static_cast<int>(at.y() * static_cast<float>(texture->image.height - 1));
        const auto* rgba =
            &texture->image.rgba[static_cast<std::size_t>(4 * (y * texture->image.width + x))];
        return std::array<int, 3>{rgba[0], rgba[1], rgba[2]};
    };
    for (const Eigen::Vector2f& uv : {Eigen::Vector2f(0, 0), Eigen::Vector2f(1, 1),
                                      Eigen::Vector2f(0.3F, 0.7F), Eigen::Vector2f(2.5F, -3.5F)}) {
        EXPECT_EQ(colour_at(0, uv), (std::array<int, 3>{255, 0, 0}));
        EXPECT_EQ(colour_at(1, uv), (std::array<int, 3>{200, 150, 130}));
        EXPECT_EQ(colour_at(2, uv), (std::array<int, 3>{0, 255, 0}));
    }
    scan.face_material.clear();
    EXPECT_TRUE(load_texture(scan)->tiles.empty());
}

TEST(RoundTrip, OfObjKeepsMaterialsAndPictures) {
    const Scan scan = rich_scan();
    const Scan back = again(scan, "back.obj");
    expect_same(scan, back);
    EXPECT_EQ(back.uv, scan.uv);
    ASSERT_EQ(back.materials.size(), 2U);
    EXPECT_EQ(back.materials[1].colour, scan.materials[1].colour);
    EXPECT_EQ(back.materials[0].name, scan.materials[0].name);
}

TEST(RoundTrip, OfObjToPlyKeepsQuadsSeamsAndPictures) {
    Scan scan = rich_scan();
    for (const FileFormat format :
         {FileFormat::PlyAscii, FileFormat::PlyBinaryLittle, FileFormat::PlyBinaryBig}) {
        scan.format = format;
        const Scan back = again(scan, "back.ply");
        expect_same(scan, back);
        expect_same(back, again(back, "twice.ply"));
    }
}

TEST(RoundTrip, OfStlIsBitForBit) {
    const Scan first = again(test::scan_of(test::sphere(101.3)), "ball.stl");
    EXPECT_EQ(first.format, FileFormat::StlBinary);
    EXPECT_EQ(first.mesh.vertex_count(), test::sphere(101.3).vertex_count());
    expect_same(first, again(first, "ball.stl"));
    Scan text = first;
    text.format = FileFormat::StlAscii;
    const Scan back = again(text, "text.stl");
    EXPECT_EQ(back.format, FileFormat::StlAscii);
    expect_same(first, back);
}

TEST(RoundTrip, OfGlbIsBitForBit) {
    const Scan first = again(rich_scan(), "a.glb");
    EXPECT_EQ(first.format, FileFormat::Glb);
    EXPECT_EQ(first.materials.size(), 2U);
    // The scan's own vertices stand first; two lie on the seam and have copies behind them.
    EXPECT_EQ(first.file_vertices.leftCols(7),
              Points(rich_scan().file_vertices.cast<float>().cast<double>()));
    EXPECT_EQ(first.mesh.vertex_count(), 8);
    expect_same(first, again(first, "b.glb"));
    EXPECT_EQ(first.textures.at(0).bytes, png());
}

TEST(RoundTrip, OfWrongWindingGivesBackTheFilesOwn) {
    TriangleMesh mesh = test::sphere(90.0);
    mesh.triangles.row(0).swap(mesh.triangles.row(1));
    const Scan scan = again(test::scan_of(mesh), "in.stl");
    EXPECT_TRUE(scan.findings.inward);
    expect_same(scan, again(scan, "in.stl"));
}

TEST(RoundTrip, OfFloatPlyStaysFloatAndExact) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "property uchar alpha\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
        "0.1 0 0 1 2 3 4\n200 0 0 255 0 128 255\n0 200 0 7 8 9 0\n3 0 1 2\n";
    const Scan scan = read_mesh_bytes(text, "f.ply");
    EXPECT_TRUE(scan.float_coordinates);
    EXPECT_FLOAT_EQ(scan.alpha[0], 4.0F / 255.0F);
    const Scan back = again(scan, "f.ply");
    expect_same(scan, back);
    EXPECT_TRUE(back.float_coordinates);
}

TEST(Ply, StripsBecomeTriangles) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
        "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0\n0 100 0\n100 0 0\n100 100 0\n200 0 0\n200 100 0\n8 1 0 3 2 -1 2 4 3\n";
    const Scan scan = read_mesh_bytes(text, "strip.ply");
    EXPECT_EQ(scan.faces.vertex, (std::vector<int>{1, 0, 3, 3, 0, 2, 2, 4, 3}));
}

TEST(Ply, ManyTexturesAreChosenByNumber) {
    const std::string text =
        "ply\nformat ascii 1.0\ncomment TextureFile one.png\ncomment TextureFile two two.png\n"
        "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 2\nproperty list uchar int vertex_indices\n"
        "property list uchar float texcoord\nproperty int texnumber\nend_header\n"
        "0 0 0\n100 0 0\n100 100 0\n0 200 0\n3 0 1 2 6 0 0 1 0 1 1 1\n3 0 2 3 6 0 0 1 1 0 1 0\n";
    const Scan scan = read_mesh_bytes(text, "two.ply");
    EXPECT_EQ(scan.face_material, (std::vector<int>{1, 0}));
    EXPECT_EQ(scan.textures.at(1).name, "two two.png");
    expect_same(scan, again(scan, "two.ply"));
}

TEST(Obj, DoesNotDependOnTheNumberOfThreads) {
    std::string text;
    for (int i = 0; i < 60000; ++i) {
        text += "v " + std::to_string(i % 300) + " " + std::to_string(i / 300) + " 0\n";
        if (i > 301 && i % 300 != 0) {
            text += i % 2 == 0 ? "f -1 -2 -302\n" : "f " + std::to_string(i) + " 1 2\n";
        }
        text += i % 1000 == 0 ? "g part" + std::to_string(i) + " \\\n more\n" : "";
    }
    const int before = thread_count();
    set_thread_count(1);
    const Scan one = read_mesh_bytes(text, "t.obj");
    set_thread_count(3);
    const Scan three = read_mesh_bytes(text, "t.obj");
    set_thread_count(before);
    expect_same(one, three);
    EXPECT_GT(one.faces.count(), 50000);
    EXPECT_EQ(one.statements.size(), three.statements.size());
    EXPECT_EQ(one.statements.back().before_face, three.statements.back().before_face);
}

TEST(Obj, NamesTheLineFarIntoALargeFile) {
    std::string text = "v 0 0 0\nv 100 0 0\nv 0 100 0\n";
    for (int i = 0; i < 300000; ++i) {
        text += "f 1 2 3\n";
    }
    try {
        read_mesh_bytes(text + "f 1 2 x\n", "long.obj");
        FAIL();
    } catch (const IoError& error) {
        EXPECT_STREQ(error.what(), "long.obj line 300004: face vertex 'x' is not a whole number.");
    }
    EXPECT_NO_THROW(read_mesh_bytes(text + "f 1 2 4\n" + text, "long.obj"));  // further down
}

TEST(Companions, StayInsideTheFolder) {
    const test::TemporaryFolder folder;
    put(folder / "secret.png", png());
    put(folder / "in/tex/skin.png", png());
    put(folder / "in/Upper.PNG", png());
    fs::create_symlink(folder / "secret.png", folder / "in/link.png");
    const auto found = [&](const std::string& name) {
        Scan scan;
        scan.textures.push_back({name, {}});
        read_companions(folder / "in/a.obj", scan);
        return !scan.textures[0].bytes.empty();
    };
    EXPECT_TRUE(found("tex/skin.png"));
    EXPECT_TRUE(found("tex\\skin.png"));
    EXPECT_TRUE(found("upper.png"));
    EXPECT_TRUE(found("D:\\patients\\x\\UPPER.png"));
    EXPECT_FALSE(found("../secret.png"));
    EXPECT_FALSE(found("..\\secret.png"));
    EXPECT_FALSE(found((folder / "secret.png").string()));
    EXPECT_FALSE(found("link.png"));
    EXPECT_FALSE(found("/etc/passwd"));
    EXPECT_FALSE(found(""));
    EXPECT_FALSE(found("."));
    EXPECT_FALSE(found(std::string("skin.png\0", 9)));
}

TEST(Writer, LeavesAnotherPictureOfThatNameAlone) {
    const test::TemporaryFolder folder;
    put(folder / "hair.png", "somebody else's");
    const Scan scan = rich_scan();
    write_mesh(folder / "out.obj", scan, scan.mesh.vertices);
    EXPECT_EQ(read_file(folder / "hair.png"), "somebody else's");
    EXPECT_EQ(read_file(folder / "out_hair.png"), png());
    expect_same(scan, read_mesh(folder / "out.obj"));
}

TEST(Gltf, TakesNodesIntoAccountAndRefusesWhatItCannotRead) {
    const test::TemporaryFolder folder;
    const auto document = [&](const std::string& extra, const std::string& node) {
        return "{\"asset\":{\"version\":\"2.0\"}," + extra +
               "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0" + node +
               "}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
               "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,"
               "\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]}],"
               "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
               "\"buffers\":[{\"uri\":\"t.bin\",\"byteLength\":36}]}";
    };
    const float corners[9] = {0, 0, 0, 0.25F, 0, 0, 0, 0.25F, 0};
    put(folder / "t.bin", std::string(reinterpret_cast<const char*>(corners), sizeof corners));
    put(folder / "t.gltf", document("", ",\"translation\":[1,2,3],\"scale\":[2,2,2]"));
    const Scan scan = read_mesh(folder / "t.gltf");
    ASSERT_EQ(scan.mesh.vertex_count(), 3);
    EXPECT_TRUE(scan.file_vertices.col(1).isApprox(Vec3(1.5, 2, 3)));
    EXPECT_EQ(describe(scan).unit, "m");

    const auto problem = [&](const std::string& text) {
        put(folder / "x.gltf", text);
        try {
            read_mesh(folder / "x.gltf");
        } catch (const IoError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(problem(document("\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],", ""))
                  .find("Draco"),
              std::string::npos);
    EXPECT_NE(problem(document("\"extensionsRequired\":[\"EXT_x\"],", "")).find("EXT_x"),
              std::string::npos);
    EXPECT_NE(problem("{\"asset\":{\"version\":\"1.0\"}}").find("2.0"), std::string::npos);
    EXPECT_NE(problem("{").find("JSON"), std::string::npos);
    std::string outside = document("", "");
    outside.replace(outside.find("t.bin"), 5, "../t.bin");
    put(folder / "sub/x.gltf", outside);
    EXPECT_THROW(read_mesh(folder / "sub/x.gltf"), IoError);
}

TEST(Gltf, WithoutTheHelperSaysSo) {
    const char* before = std::getenv("MYOFACE_IMPORT");
    const std::string kept = before != nullptr ? before : "";
    ::setenv("MYOFACE_IMPORT", "/no/such/helper", 1);
    EXPECT_THROW(read_mesh_bytes("glTF____", "a.glb"), IoError);
    kept.empty() ? ::unsetenv("MYOFACE_IMPORT") : ::setenv("MYOFACE_IMPORT", kept.c_str(), 1);
}

TEST(Gltf, SurvivesDamageOfEveryKind) {
    const test::TemporaryFolder folder;
    write_mesh(folder / "a.glb", rich_scan(), rich_scan().mesh.vertices);
    const std::string good = read_file(folder / "a.glb");
    int refused = 0;
    for (int k = 0; k < 60; ++k) {
        std::string bad = good;
        const std::size_t at = 12 + static_cast<std::size_t>(k) * (good.size() - 12) / 60;
        if (k % 3 == 0) {
            bad.resize(at);
        } else {
            bad[at] = static_cast<char>(bad[at] ^ (k % 3 == 1 ? 0x11 : 0xFF));
        }
        try {
            EXPECT_TRUE(read_mesh_bytes(bad, "bad.glb").mesh.vertices.allFinite());
        } catch (const IoError& error) {
            ++refused;
            EXPECT_EQ(std::string(error.what()).find("bad.glb: "), 0U) << error.what();
        }
    }
    EXPECT_GT(refused, 20);
}

TEST(Gltf, ReadingCanBeCancelled) {
    const std::string good = [] {
        const test::TemporaryFolder folder;
        write_mesh(folder / "a.glb", rich_scan(), rich_scan().mesh.vertices);
        return read_file(folder / "a.glb");
    }();
    Progress progress;
    progress.cancel();
    EXPECT_THROW(read_mesh_bytes(good, "a.glb", {}, &progress), Cancelled);
}

TEST(Interchange, BelievesNothing) {
    const std::string good = encode_scan(rich_scan());
    EXPECT_EQ(decode_scan(good, "x").file_vertices.cols(), 0);
    EXPECT_EQ(decode_scan(good, "x").mesh.vertices, rich_scan().file_vertices);
    for (std::size_t cut = 0; cut < good.size(); cut += 7) {
        EXPECT_THROW(decode_scan(std::string_view(good).substr(0, cut), "x"), IoError);
    }
    for (std::size_t at = 0; at < good.size(); ++at) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0xFF);
        try {
            EXPECT_TRUE(decode_scan(bad, "x").mesh.vertices.allFinite());
        } catch (const IoError&) {
        }
    }
}

}  // namespace
}  // namespace myoface
