// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "myoface/base/error.h"

#include "commands.h"
#include "face_arguments.h"
#include "output.h"

namespace myoface::cli {
namespace {

struct FitArguments {
    FaceArguments face;
    std::string output, muscles, bone;
};

}  // namespace

void add_fit(CLI::App& app) {
    auto* command =
        app.add_subcommand("fit", "Put bone and muscles on a scan and write a case file");
    auto a = std::make_shared<FitArguments>();
    a->face.add_to(*command);
    command->add_option("-o", a->output, "CASE.myoface")->required();
    command->add_option("--muscles-out", a->muscles, "muscle paths as JSON");
    command->add_option("--bone-out", a->bone, "bone surface as PLY or OBJ");
    command->callback([a] {
        const auto prepared = prepare_fitting();
        OpenedFace opened = a->face.open();
        find_missing_landmarks(opened);
        const auto simulator = make_simulator(opened);
        write_case(
            a->output, opened,
            case_state(simulator->face(), simulator->contractions(), simulator->skin_rest()));
        if (!a->muscles.empty()) {
            write_text(a->muscles, muscles_to_json(simulator->face()));
        }
        if (!a->bone.empty()) {
            Scan bone;
            bone.mesh = simulator->face().bone;
            bone.frame = opened.scan->frame;
            bone.format = FileFormat::PlyBinaryLittle;
            for (int t = 0; t < bone.mesh.triangle_count(); ++t) {
                for (int c = 0; c < 3; ++c) {
                    bone.faces.vertex.push_back(bone.mesh.triangles(c, t));
                }
                bone.faces.start.push_back(static_cast<int>(bone.faces.vertex.size()));
            }
            bone.file_vertices =
                bone.frame.axes.transpose() / bone.frame.mm_per_unit * bone.mesh.vertices;
            write_mesh(a->bone, bone, bone.mesh.vertices);
        }
    });
}

}  // namespace myoface::cli
