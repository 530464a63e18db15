// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "myoface/base/error.h"
#include "myoface/face/generic_face.h"
#include "myoface/io/mesh_file.h"

#include "commands.h"

namespace myoface::cli {
namespace {

struct Arguments {
    std::string sex, output, landmarks;
    GenericFaceOptions options;
    std::uint32_t seed = 0;
};

}  // namespace

void add_generate(CLI::App& app) {
    auto* command = app.add_subcommand("generate", "Make a head from the norms");
    auto a = std::make_shared<Arguments>();
    command->add_option("--sex", a->sex, "f or m; the average of both when absent")
        ->check(CLI::IsMember({"f", "m"}));
    command->add_option("--age", a->options.age, "years");
    command->add_option("--vertices", a->options.vertices, "about how many");
    auto* seed = command->add_option("--seed", a->seed, "an individual instead of the mean");
    command->add_option("-o", a->output, "FACE.ply or FACE.obj")->required();
    command->add_option("--landmarks-out", a->landmarks, "landmark file to write");
    command->callback([a, seed] {
        if (!a->sex.empty()) {
            a->options.sex = a->sex == "f" ? Sex::Female : Sex::Male;
        }
        if (seed->count() > 0) {
            a->options.seed = a->seed;
        }
        const GenericFace face = make_generic_face(a->options);
        write_mesh(a->output, face.scan, face.scan.mesh.vertices);
        if (!a->landmarks.empty()) {
            write_landmarks(a->landmarks, face.landmarks, face.scan.frame);
        }
    });
}

}  // namespace myoface::cli
