// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>

#include <nlohmann/json.hpp>

#include "commands.h"
#include "face_arguments.h"
#include "output.h"

namespace myoface::cli {

namespace {

/// The largest parts: how many triangles, how large and where.
nlohmann::ordered_json parts_of(const MeshReadReport& report) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    constexpr std::size_t kMost = 50;
    for (std::size_t k = 0; k < std::min(report.findings.parts.size(), kMost); ++k) {
        const ScanPart& part = report.findings.parts[k];
        const Vec3 size = report.mm_per_unit * (part.high - part.low);
        list.push_back({{"triangles", part.triangles},
                        {"area_mm2", part.area * report.mm_per_unit * report.mm_per_unit},
                        {"size_mm", {size.x(), size.y(), size.z()}}});
    }
    return list;
}

}  // namespace

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
        json["axes"] = r.axes;
        json["axes_are_guess"] = r.axes_are_guess;
        json["frame_confidence"] = std::round(100.0 * r.frame_confidence) / 100.0;
        json["needs_calibration"] = r.needs_calibration;
        json["size_mm"] = {r.size_mm.x(), r.size_mm.y(), r.size_mm.z()};
        const ScanFindings& found = r.findings;
        json["components"] = found.parts.size();
        json["parts"] = parts_of(r);
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
