// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "myoface/io/mesh_file.h"

#include "commands.h"

namespace myoface::cli {
namespace {

struct ConvertArguments {
    std::string input;
    std::string output;
};

}  // namespace

void add_convert(CLI::App& app) {
    auto* command = app.add_subcommand("convert", "Write a mesh in another format");
    auto a = std::make_shared<ConvertArguments>();
    command->add_option("IN", a->input, "OBJ, PLY, STL, glTF or GLB file")->required();
    command->add_option("OUT", a->output, "name that ends in .obj, .ply, .stl or .glb")->required();
    command->callback([a] {
        const Scan scan = read_mesh(a->input);  // unit and axes stay as they came
        write_mesh(a->output, scan, scan.mesh.vertices);
    });
}

}  // namespace myoface::cli
