// SPDX-License-Identifier: Apache-2.0
// Writes the seed corpora: write_seeds FOLDER
#include <filesystem>
#include <iostream>

#include "myoface/io/interchange.h"
#include "myoface/io/mesh_file.h"
#include "myoface/io/text_file.h"

#include "odd_files.h"
#include "test_meshes.h"

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
    return 0;
}
