// SPDX-License-Identifier: Apache-2.0
// Writes the seed corpora: write_seeds FOLDER
#include <filesystem>
#include <iostream>

#include "myoface/base/resources.h"
#include "myoface/io/interchange.h"
#include "myoface/io/mesh_file.h"
#include "myoface/io/text_file.h"

#include "bad_files.h"
#include "odd_files.h"
#include "test_meshes.h"

namespace {

/// Cases, plans, landmarks and journals: good ones, and those that were ever found bad.
void write_our_files(const std::filesystem::path& folder) {
    using namespace myoface;
    for (const char* kind : {"case", "plan", "landmarks", "journal"}) {
        std::filesystem::create_directories(folder / kind);
    }
    write_file(folder / "case/good", test::good_case());
    write_file(folder / "case/parts", test::good_case_parts());
    write_file(folder / "plan/good", test::good_plan());
    write_file(folder / "landmarks/good", test::good_landmarks());
    write_file(folder / "journal/good", test::good_journal().substr(16));
    for (const char* kind : {"atlas", "expression"}) {
        std::filesystem::create_directories(folder / kind);
    }
    const std::string atlas = read_file(resource_path("assets/muscles.json"));
    write_file(folder / "atlas/one", atlas.substr(0, atlas.find("},\n")) + "}]}");
    write_file(
        folder / "expression/good",
        R"({"name": "mine", "contractions": {"zygomaticus_major": 0.5, "mentalis.L": -0.2}})");
    for (const test::BadFile& file : test::bad_files()) {
        const bool text = file.kind == test::BadKind::Plan;
        if ((text || file.kind == test::BadKind::Landmarks) && file.bytes.size() < 5000) {
            write_file(folder / (text ? "plan" : "landmarks") / file.name, file.bytes);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    using namespace myoface;
    if (argc != 2) {
        std::cerr << "usage: write_seeds FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    for (const test::OddFile& file : test::odd_files()) {
        const std::string kind = std::filesystem::path(file.name).extension().string().substr(1);
        if (file.bytes.size() < 5000) {
            std::filesystem::create_directories(folder / kind);
            write_file(folder / kind / file.name, file.bytes);
        }
    }
    std::filesystem::create_directories(folder / "mtl");
    write_file(folder / "mtl/plain.mtl",
               "newmtl a\nKd 1 0.5 0\nd 0.5\nmap_Kd -s 1 1 1 -clamp on skin.png\n"
               "newmtl b c\nTr 0.2\nmap_Kd C:\\x\\SKIN.PNG\n");
    std::filesystem::create_directories(folder / "interchange");
    Scan scan = test::scan_of(test::grid(3));
    scan.materials = {{"skin", {}, 0}};
    scan.textures = {{"a.png", "x"}};
    scan.face_material.assign(static_cast<std::size_t>(scan.faces.count()), 0);
    write_file(folder / "interchange/grid", encode_scan(scan));
    write_our_files(folder);
    return 0;
}
