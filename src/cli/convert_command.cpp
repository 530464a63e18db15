// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "myoface/io/mesh_file.h"

#include "commands.h"
#include "face_arguments.h"

namespace myoface::cli {
namespace {

struct Arguments {
    FaceArguments in;
    std::string output;
};

}  // namespace

void add_convert(CLI::App& app) {
    auto* command = app.add_subcommand("convert", "Write a mesh in another format");
    auto a = std::make_shared<Arguments>();
    a->in.add_to(*command);
    command->add_option("OUT", a->output, "name that ends in .obj, .ply, .stl or .glb")->required();
    command->callback([a] {
        const OpenedFace face = a->in.open();
        write_mesh(a->output, *face.scan, face.scan->mesh.vertices);
    });
}

}  // namespace myoface::cli
