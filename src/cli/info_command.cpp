// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <nlohmann/json.hpp>

#include "commands.h"
#include "face_arguments.h"
#include "output.h"

namespace myoface::cli {

void add_info(CLI::App& app) {
    auto* command = app.add_subcommand("info", "Tell what is in a face file, as JSON");
    auto arguments = std::make_shared<FaceArguments>();
    auto output = std::make_shared<std::string>();
    arguments->add_to(*command);
    command->add_option("-o", *output, "write there instead of to standard output");
    command->callback([arguments, output] {
        const OpenedFace face = arguments->open();
        const MeshReadReport& r = face.report;
        nlohmann::ordered_json json;
        json["file"] = arguments->face;
        json["format"] = r.format;
        json["vertices"] = r.vertices;
        json["faces"] = r.faces;
        json["triangles"] = r.triangles;
        json["quads"] = r.quads;
        json["larger_faces"] = r.larger_faces;
        json["unit"] = r.unit;
        json["mm_per_unit"] = r.mm_per_unit;
        json["unit_is_guess"] = r.unit_is_guess;
        json["size_mm"] = {r.size_mm.x(), r.size_mm.y(), r.size_mm.z()};
        const ScanFindings& found = r.findings;
        json["components"] = found.parts.size();
        json["boundary_loops"] = found.holes;
        json["longest_boundary_mm"] = r.longest_hole_mm;
        json["duplicate_vertices"] = found.duplicate_vertices;
        json["unreferenced_vertices"] = found.unreferenced_vertices;
        json["degenerate_triangles"] = found.degenerate_triangles;
        json["duplicate_triangles"] = found.duplicate_triangles;
        json["turned_triangles"] = found.turned_triangles;
        json["non_manifold_edges"] = found.non_manifold_edges;
        json["inward_winding"] = found.inward;
        json["colours"] = r.has_colours;
        json["uv"] = r.has_uv;
        json["texture"] = r.texture;
        json["texture_found"] = face.texture != nullptr;
        json["landmarks"] = face.landmarks ? static_cast<int>(face.landmarks->size()) : 0;
        json["notes"] = r.notes;
        write_text(*output, json.dump(1) + "\n");
    });
}

}  // namespace myoface::cli
