// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>

#include "myoface/base/error.h"
#include "myoface/face/generic_face.h"
#include "myoface/io/mesh_file.h"

#include "commands.h"

namespace myoface::cli {
namespace {

struct GenerateArguments {
    std::string sex, output, landmarks;
    GenericFaceOptions options;
    std::uint32_t seed = 0;
};

}  // namespace

void add_generate(CLI::App& app) {
    auto* command = app.add_subcommand("generate", "Make a head from the norms");
    auto a = std::make_shared<GenerateArguments>();
    command->add_option("--sex", a->sex, "f or m; the average of both when absent")
        ->check(CLI::IsMember({"f", "m"}));
    command->add_option("--age", a->options.age, "years");
    command->add_option("--vertices", a->options.vertices, "about how many");
    auto* seed = command->add_option("--seed", a->seed, "an individual instead of the mean");
    command->add_option("--asymmetry", a->options.asymmetry,
                        "how far left and right differ, one sigma [mm]");
    command->add_option("--stubble", a->options.stubble, "0 shaved to 1, three days' beard");
    auto* picture = command->add_option("--picture", a->options.picture,
                                        "side of the skin's texture [pixels], 0 for none");
    command->add_option("-o", a->output, "FACE.ply, .obj, .glb or .stl")->required();
    command->add_option("--landmarks-out", a->landmarks, "landmark file to write");
    command->callback([a, seed, picture] {
        if (!a->sex.empty()) {
            a->options.sex = a->sex == "f" ? Sex::Female : Sex::Male;
        }
        if (seed->count() > 0) {
            a->options.seed = a->seed;
        }
        const std::string kind = std::filesystem::path(a->output).extension().string();
        if (picture->count() == 0 && (kind == ".obj" || kind == ".glb")) {
            a->options.picture = 1536;  // formats that usually come with one
        }
        const GenericFace face = make_generic_face(a->options);
        write_mesh(a->output, face.scan, face.scan.mesh.vertices);
        if (!a->landmarks.empty()) {
            write_landmarks(a->landmarks, face.landmarks, face.scan.frame);
        }
    });
}

}  // namespace myoface::cli
