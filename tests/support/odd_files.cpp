// SPDX-License-Identifier: Apache-2.0
#include "odd_files.h"

#include <bit>
#include <cstdint>

#include "myoface/io/mesh_file.h"

#include "test_meshes.h"

namespace myoface::test {
namespace {

const std::string kV = "v 0 0 0\nv 200 0 0\nv 0 200 0\n";
const std::string kT = "f 1 2 3\n";

std::string ply(const std::string& format, const std::string& elements, const std::string& body) {
    return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + body;
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kV3 = "element vertex 3\n" + kXyz;
const std::string kF1 = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kBody = "0 0 0\n200 0 0\n0 200 0\n";

void append(std::string& text, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        text += static_cast<char>(value >> shift & 0xFF);
    }
}

void append(std::string& text, float value) {
    append(text, std::bit_cast<std::uint32_t>(value));
}

/// Three vertices and one face in binary, with a chance to spoil each.
std::string binary_body(float last = 0.0F, std::uint8_t corners = 3, std::uint32_t index = 2) {
    std::string body;
    for (const float x : {0.0F, 0.0F, 0.0F, 200.0F, 0.0F, 0.0F, 0.0F, 200.0F, last}) {
        append(body, x);
    }
    body += static_cast<char>(corners);
    for (const std::uint32_t v : {0U, 1U, index}) {
        append(body, v);
    }
    return body;
}

std::string stl(std::uint32_t count, int facets, float first = 0.0F) {
    std::string text(80, ' ');
    append(text, count);
    for (int f = 0; f < facets; ++f) {
        for (const float x : {0.0F, 0.0F, 1.0F, first, 0.0F, 0.0F, 200.0F, 0.0F, 0.0F, 0.0F, 200.0F,
                              static_cast<float>(f)}) {
            append(text, x);
        }
        text += std::string(2, '\0');
    }
    return text;
}

void add_obj(std::vector<OddFile>& files) {
    const auto good = [&](const std::string& text) {
        files.push_back({"good" + std::to_string(files.size()) + ".obj", text, true});
    };
    const auto bad = [&](const std::string& text) {
        files.push_back({"bad" + std::to_string(files.size()) + ".obj", text, false});
    };
    good(kV + kT);
    good("\xEF\xBB\xBF" + kV + kT);
    good("v 0 0 0\r\nv 200 0 0\r\nv 0 200 0\r\nf 1 2 3\r\n");
    good("v 0 0 0\nv 200 0 0\nv 0 200 0\nf 1 2 3");  // no newline at the end
    good("v\t0\t0\t0\nv  200   0 0 \n  v 0 200 0\n f  1  2  3  \n");
    good("f 1 2 3\n" + kV);  // faces first
    good("v 0 0 0\nv 2e2 0 0\nv 0 +2.0E+02 0\nf 1 2 3\n");
    good("v .0 0. 0\nv 200. 0 -0\nv 0 200 .0e0\nf 1 2 3\n");
    good("v 0 0 0\nv 200 0 0\nv 0 0.0000000000000000000000200e25 0\nf 1 2 3\n");
    good("v 0 0 1e-400\nv 200 0 0\nv 0 200 0\nf 1 2 3\n");
    good("v 0 0 0 1\nv 200 0 0 1\nv 0 200 0 1\n" + kT);  // weights
    good("v 0 0 0 1 1 1 0.5\nv 200 0 0 0 0 0 1\nv 0 200 0 0 1 0 1\n" + kT);
    good("v 0 0 0 300 -5 2\nv 200 0 0\nv 0 200 0\n" + kT);  // colours out of range
    good("v 0 0 0\nv 200 0 0\nv 0 200 0\nf -3 -2 -1\n");
    good("v 0 0 0\nv 200 \\\n0 0\nv 0 200 0\nf 1 \\\r\n2 \\\n3\n");
    good(kV + "f 1 2 3 # a comment\n# f 9 9 9\n");
    good(kV + "f 1//1 2//1 3//1\nvn 0 0 1\n");
    good(kV + "vt 0 0\nf 1/1/1 2/1/1 3/1/1\n");
    good(kV + "vt 0\nf 1/1 2/1 3/1\n");
    good(kV + "vt 0 0 0\nf 1/-1 2/-1 3/-1\n");
    good(kV + "f 1/ 2/ 3/\n");
    good(kV + "usemtl\nusemtl a b c\ng\no\ns off\nmtllib\nmtllib no such.mtl\n" + kT);
    good(kV + "l 1 2\np 1\ncurv2 1 2\nxyzzy\n" + kT);
    good(kV + "f 1 2 3\nf 1 1 2\nf 2 2 2\n");  // faces without area
    good(kV + "f 1 2 3 1 2 3\n");              // a face that crosses itself
    good(kV + "v 200 200 0\nv 100 100 0\nf 1 2 5 4 3\n");
    good(kV + "f 1 2 3\nf 1 2 3\nf 3 2 1\n");
    good("mtllib ../../../../etc/passwd\nmtllib /etc/shadow\n" + kV + kT);
    good(kV + kT + "\\\n");
    good(kV + kT + "f 1 2 3 \\");
    good(kV + "g \xE9\xA1\x94\xFF\xFE\n" + kT);  // not UTF-8 in a name
    std::string fan = kV;
    std::string polygon = "f";
    for (int i = 1; i <= 3000; ++i) {
        fan += "v " + std::to_string(i % 60) + " " + std::to_string(i * 7 % 101) + " 0\n";
        polygon += " " + std::to_string(i);
    }
    good(fan + polygon + "\n");

    bad("\n");
    bad("# nothing\n");
    bad("hello\n");
    bad("v\n");
    bad("v 0\n");
    bad("v 0 0\n" + kT);
    bad("v 0 0 0\nv 1 0 zero\nv 0 1 0\n" + kT);
    bad("v 0 0 0\nv 1 0 0x10\nv 0 1 0\n" + kT);
    bad("v 0 0 0\nv 1,5 0 0\nv 0 1 0\n" + kT);  // a comma as in German
    bad("v 0 0 0\nv nan 0 0\nv 0 1 0\n" + kT);
    bad("v 0 0 0\nv inf 0 0\nv 0 1 0\n" + kT);
    bad("v 0 0 0\nv 1e999 0 0\nv 0 1 0\n" + kT);
    bad("v 0 0 0\nv --1 0 0\nv 0 1 0\n" + kT);
    bad("v 0 0 0\nv 1e 0 0\nv 0 1 0\n" + kT);
    bad("v 0 0 0\nv 1e10 0 0\nv 0 1 0\n" + kT);  // beyond any face
    bad("v 0 0 0 1 1 red\nv 1 0 0\nv 0 1 0\n" + kT);
    bad("v 5 5 5\nv 5 5 5\nv 5 5 5\n" + kT);
    bad(kV);
    bad(kT);
    bad(kV + "f\n");
    bad(kV + "f 1\n");
    bad(kV + "f 1 2\n");
    bad(kV + "f 0 1 2\n");
    bad(kV + "f 1 2 4\n");
    bad(kV + "f 1 2 -4\n");
    bad(kV + "f 1 2 3.5\n");
    bad(kV + "f 1 2 99999999999\n");
    bad(kV + "f 1 2 -99999999999\n");
    bad(kV + "f 1 2 two\n");
    bad(kV + "f 1/1 2/1 3/1\n");  // no such texture coordinate
    bad(kV + "vt 0 0\nf 1/2 2/1 3/1\n");
    bad(kV + "vt 0 0\nf 1/-2 2/1 3/1\n");
    bad(kV + "vt 0 0\nf 1/0 2/1 3/1\n");
    bad(kV + "vt u v\n" + kT);
    bad(kV + "vt nan 0\n" + kT);
    bad(kV + "f 1/x 2 3\n");
    bad(kV + "f 1//x 2 3\n");
    bad(kV + "f 1/1/1/1 2 3\n");
    bad(std::string("v 0 0 0\n\0\0\0\0\n", 13) + kV + kT);
    bad(std::string(4096, '\0'));
    bad("<html><body>404 not found</body></html>\n");
    bad("{\"v\": [0, 0, 0]}\n");
    bad("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
}

void add_ply(std::vector<OddFile>& files) {
    const auto good = [&](const std::string& text) {
        files.push_back({"good" + std::to_string(files.size()) + ".ply", text, true});
    };
    const auto bad = [&](const std::string& text) {
        files.push_back({"bad" + std::to_string(files.size()) + ".ply", text, false});
    };
    const std::string little = "binary_little_endian";
    good(ply("ascii", kV3 + kF1, kBody + "3 0 1 2\n"));
    good(ply("ascii", kV3 + kF1, "0 0 0 200 0 0 0 200 0 3 0 1 2"));  // lines do not matter
    good(ply("ascii", "comment x\nobj_info y\n" + kV3 + "comment z\n" + kF1, kBody + "3 0 1 2\n"));
    good(
        "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
        "property float z\r\nelement face 1\r\nproperty list uchar int vertex_index\r\n"
        "end_header\r\n0 0 0\r\n200 0 0\r\n0 200 0\r\n3 0 1 2\r\n");
    good(ply(little, kV3 + kF1, binary_body()));
    good(ply(little, kV3 + kF1, binary_body()) + "trailing");
    good(ply("ascii",
             "element vertex 3\nproperty double z\nproperty uchar red\nproperty int y\n"
             "property float confidence\nproperty short x\nproperty uchar green\n"
             "property uchar blue\n" +
                 kF1,
             "0 1 0 9 0 2 3\n0 1 0 9 200 2 3\n0 1 200 9 0 2 3\n3 0 1 2\n"));
    good(ply("ascii", kV3 + "property list int float weights\n" + kF1,
             "0 0 0 0\n200 0 0 2 1 1\n0 200 0 1 5\n3 0 1 2\n"));
    good(ply("ascii", "element camera 1\nproperty float view\n" + kV3 + kF1,
             "7\n" + kBody + "3 0 1 2\n"));
    good(ply("ascii", kV3 + kF1 + "element edge 1\nproperty int vertex1\nproperty int vertex2\n",
             kBody + "3 0 1 2\n0 1\n"));
    good(ply("ascii",
             kV3 + "element face 1\nproperty list ushort uint vertex_indices\n"
                   "property uchar flags\n",
             kBody + "3 0 1 2 4\n"));
    good(ply("ascii", "element face 1\nproperty list uchar int vertex_indices\n" + kV3,
             "3 0 1 2\n" + kBody));  // faces first
    good(ply("ascii", kV3 + "property float s\nproperty float t\n" + kF1,
             "0 0 0 0 0\n200 0 0 1 0\n0 200 0 0 1\n3 0 1 2\n"));
    good(ply("ascii", "comment TextureFile ../../etc/passwd\n" + kV3 + kF1, kBody + "3 0 1 2\n"));
    good(ply("ascii", kV3 + "element face 2\nproperty list uchar int vertex_indices\n",
             kBody + "3 0 1 2\n3 0 0 0\n"));
    const Scan ball = scan_of(sphere(100.0, 6, 8));
    for (const FileFormat format :
         {FileFormat::PlyAscii, FileFormat::PlyBinaryLittle, FileFormat::PlyBinaryBig}) {
        Scan as = ball;
        as.format = format;
        good(mesh_bytes("a.ply", as, as.mesh.vertices));
    }

    bad("ply\n");
    bad("ply\nformat ascii 1.0\n");
    bad("plyformat ascii 1.0\nend_header\n");
    bad("PLY\nformat ascii 1.0\nend_header\n");
    bad(ply("binary_middle_endian", kV3 + kF1, kBody + "3 0 1 2\n"));
    bad("ply\n" + kV3 + kF1 + "end_header\n" + kBody + "3 0 1 2\n");  // no format
    bad(ply("ascii", kF1, "3 0 1 2\n"));
    bad(ply("ascii", kV3, kBody));
    bad(ply("ascii", kV3 + "element face 0\nproperty list uchar int vertex_indices\n", kBody));
    bad(ply("ascii", "element vertex 0\n" + kXyz + kF1, "3 0 1 2\n"));
    bad(ply("ascii", "element vertex -3\n" + kXyz + kF1, kBody + "3 0 1 2\n"));
    bad(ply("ascii", "element vertex three\n" + kXyz + kF1, kBody + "3 0 1 2\n"));
    bad(ply("ascii", "element vertex 1000000000\n" + kXyz + kF1, kBody + "3 0 1 2\n"));
    bad(ply("ascii", "element vertex 18446744073709551615\n" + kXyz + kF1, kBody + "3 0 1 2\n"));
    bad(ply("ascii", "element vertex 99999999999999999999999\n" + kXyz + kF1, kBody));
    bad(ply(little, "element vertex 4294967295\n" + kXyz + kF1, binary_body()));
    bad(ply("ascii", "element nothing 5\n" + kV3 + kF1, kBody + "3 0 1 2\n"));
    bad(ply("ascii", "property float x\n" + kV3 + kF1, kBody + "3 0 1 2\n"));
    bad(ply("ascii", "element vertex 3\nproperty float x\nproperty float y\n" + kF1,
            "0 0\n200 0\n0 200\n3 0 1 2\n"));
    bad(ply("ascii",
            "element vertex 3\nproperty quaternion x\nproperty float y\nproperty float z\n" + kF1,
            kBody + "3 0 1 2\n"));
    bad(ply("ascii",
            "element vertex 3\nproperty list uchar float x\nproperty float y\n"
            "property float z\n" +
                kF1,
            "1 0 0 0\n1 200 0 0\n1 0 200 0\n3 0 1 2\n"));
    bad(ply("ascii", kV3 + kXyz + kF1, kBody + kBody + "3 0 1 2\n"));  // twice x
    bad(ply("ascii", kV3 + kV3 + kF1, kBody + kBody + "3 0 1 2\n"));
    bad(ply("ascii", kV3 + "property float r\nproperty float red\n" + kF1,
            "0 0 0 1 1\n1 0 0 1 1\n0 1 0 1 1\n3 0 1 2\n"));
    bad(ply("ascii", kV3 + "element face 1\nproperty list float int vertex_indices\n",
            kBody + "3 0 1 2\n"));
    bad(ply("ascii", kV3 + kF1, kBody));
    bad(ply("ascii", kV3 + kF1, kBody + "3 0 1\n"));
    bad(ply("ascii", kV3 + kF1, kBody + "2 0 1\n"));
    bad(ply("ascii", kV3 + kF1, kBody + "3 0 1 3\n"));
    bad(ply("ascii", kV3 + kF1, kBody + "3 0 1 -1\n"));
    bad(ply("ascii", kV3 + kF1, kBody + "3 0 1 1e10\n"));
    bad(ply("ascii", kV3 + kF1, kBody + "-3 0 1 2\n"));
    bad(ply("ascii", kV3 + kF1, kBody + "3000000000 0 1 2\n"));
    bad(ply("ascii", kV3 + kF1, kBody + "3.5 0 1 2\n"));
    bad(ply("ascii", kV3 + kF1, "0 0 0\n200 zero 0\n0 200 0\n3 0 1 2\n"));
    bad(ply("ascii", kV3 + kF1, "0 0 0\n200 nan 0\n0 200 0\n3 0 1 2\n"));
    bad(ply("ascii", kV3 + kF1, "0 0 0\n200 inf 0\n0 200 0\n3 0 1 2\n"));
    bad(ply("ascii", kV3 + kF1, "0 0 0\n1e39 1e39 0\n0 200 0\n3 0 1 2\n"));
    bad(ply("ascii", kV3 + kF1, "0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n"));
    bad(ply(little, kV3 + kF1, binary_body().substr(0, 20)));
    bad(ply(little, kV3 + kF1, binary_body().substr(0, 40)));
    bad(ply(little, kV3 + kF1, ""));
    bad(ply(little, kV3 + kF1, binary_body(std::bit_cast<float>(0x7FC00000U))));
    bad(ply(little, kV3 + kF1, binary_body(std::bit_cast<float>(0xFF800000U))));
    bad(ply(little, kV3 + kF1, binary_body(0.0F, 255)));
    bad(ply(little, kV3 + kF1, binary_body(0.0F, 2)));
    bad(ply(little, kV3 + kF1, binary_body(0.0F, 3, 3)));
    bad(ply(little, kV3 + kF1, binary_body(0.0F, 3, 0xFFFFFFFFU)));
    bad(ply("binary_big_endian", kV3 + kF1, binary_body()));  // the other order
    bad(ply("ascii", kV3 + kF1, binary_body()));              // binary called text
    bad(ply("ascii", kV3 + "element tristrips 1\nproperty list int int vertex_indices\n",
            kBody + "3 0 1 7\n"));
    bad(ply("ascii", kV3 + "property float s\nproperty float t\n" + kF1,
            "0 0 0 nan 0\n200 0 0 1 0\n0 200 0 0 1\n3 0 1 2\n"));
    bad(ply("ascii",
            kV3 + "element face 1\nproperty list uchar int vertex_indices\n"
                  "property list uchar float texcoord\n",
            kBody + "3 0 1 2 6 0 0 1 0 inf 1\n"));
}

void add_stl(std::vector<OddFile>& files) {
    const auto good = [&](const std::string& text) {
        files.push_back({"good" + std::to_string(files.size()) + ".stl", text, true});
    };
    const auto bad = [&](const std::string& text) {
        files.push_back({"bad" + std::to_string(files.size()) + ".stl", text, false});
    };
    const std::string facet =
        "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 200 0 0\n  vertex 0 200 0\n"
        " endloop\nendfacet\n";
    good("solid x\n" + facet + "endsolid x\n");
    good("solid\n" + facet);
    good(stl(1, 1));
    good(stl(2, 2));
    good("solid" + stl(2, 2).substr(5));  // binary that begins like text
    good(stl(1, 1) + "trailing");
    good("solid x\r\n" + facet + facet + "endsolid\r\n");

    bad("solid x\nendsolid x\n");
    bad("solid x\nfacet\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n endloop\nendfacet\n");
    bad("solid x\nfacet\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n"
        "  vertex 1 1 0\n endloop\n");
    bad("solid x\nfacet\n outer loop\n  vertex 0 0\n");
    bad("solid x\nfacet\n outer loop\n  vertex 0 0 zero\n");
    bad("solid x\nfacet\n outer loop\n  vertex 0 0 nan\n");
    bad("solid x\nfacet\n outer loop\n  vertex 0 0 0\n");
    bad(stl(0, 0));
    bad(stl(5, 2));
    bad(stl(0xFFFFFFFFU, 1));
    bad(stl(1, 1).substr(0, 100));
    bad(stl(1, 1, std::bit_cast<float>(0x7FC00000U)));
    bad(stl(1, 1, std::bit_cast<float>(0x7F800000U)));
    bad(std::string(84, '\0'));
    bad("so");
}

void add_glb(std::vector<OddFile>& files) {
    const Scan ball = scan_of(sphere(100.0, 6, 8));
    const std::string whole = mesh_bytes("a.glb", ball, ball.mesh.vertices);
    const auto bad = [&](const std::string& text) {
        files.push_back({"bad" + std::to_string(files.size()) + ".glb", text, false});
    };
    files.push_back({"ball.glb", whole, true});
    bad("glTF");
    bad(whole.substr(0, 19));
    bad(whole.substr(0, 200));
    bad(whole.substr(0, whole.size() - 100));
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = whole;
        const std::size_t at = text.find(from);
        if (at != std::string::npos && from.size() == to.size()) {
            text.replace(at, from.size(), to);
        }
        return text;
    };
    bad(with("\"2.0\"", "\"1.0\""));
    bad(with("JSON", "XXXX"));
    bad(with("\"POSITION\":0", "\"POSITION\":9"));
    bad(with("\"indices\":1", "\"indices\":7"));
    bad(with("\"mesh\":0", "\"mesh\":3"));
    bad(with("{\"mesh\"", "[\"mesh\""));
}

}  // namespace

std::vector<OddFile> odd_files() {
    std::vector<OddFile> files;
    add_obj(files);
    add_ply(files);
    add_stl(files);
    add_glb(files);
    return files;
}

}  // namespace myoface::test
