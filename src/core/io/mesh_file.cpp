// SPDX-License-Identifier: Apache-2.0
#include "myoface/io/mesh_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/normals.h"
#include "myoface/mesh/weld.h"

#include "readers.h"

namespace myoface {
namespace {

struct NamedUnit {
    const char* name;
    double millimetres;
};
constexpr std::array<NamedUnit, 5> kUnits{
    {{"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}, {"dm", 100.0}, {"m", 1000.0}}};

/// A face scan, from a tight mask to a bust, is between these lengths across [mm].
constexpr double kSmallestScan = 150.0;
constexpr double kLargestScan = 900.0;

double diagonal(const Points& vertices) {
    return (vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff()).norm();
}

/// The unit that makes the scan the size of a head; a scan that fits none is scaled to 400 mm.
double guess_unit(const Points& vertices) {
    const double size = diagonal(vertices);
    for (const NamedUnit& unit : kUnits) {
        const double millimetres = size * unit.millimetres;
        if (std::string_view(unit.name) != "in" && millimetres >= kSmallestScan &&
            millimetres <= kLargestScan) {
            return unit.millimetres;
        }
    }
    return size > 0.0 ? 400.0 / size : 1.0;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// The colour texture that the first material of a library with one names.
std::string texture_of(const std::filesystem::path& library) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(library, error) ||
        std::filesystem::file_size(library, error) > 16'000'000) {
        return {};
    }
    const std::string text = read_file(library);
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string line = text.substr(at, end - at);
        at = end + 1;
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin == std::string::npos || lower(line.substr(begin, 7)) != "map_kd ") {
            continue;
        }
        line = line.substr(begin + 7);
        while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) {
            line.pop_back();
        }
        // Options such as "-s 1 1 1" stand before the name; the name is then the last word.
        if (!line.empty() && line.front() == '-') {
            line = line.substr(line.find_last_of(" \t") + 1);
        }
        std::replace(line.begin(), line.end(), '\\', '/');
        return line;
    }
    return {};
}

/// A file named by another file: inside the same folder or below it, nowhere else.
std::optional<std::filesystem::path> inside(const std::filesystem::path& folder,
                                            const std::string& name) {
    const std::filesystem::path relative = std::filesystem::path(name).lexically_normal();
    if (name.empty() || relative.is_absolute() || *relative.begin() == "..") {
        return std::nullopt;
    }
    return folder / relative;
}

bool looks_like_ply(std::string_view content) {
    return content.substr(0, 4) == "ply\n" || content.substr(0, 5) == "ply\r\n";
}

}  // namespace

double millimetres_per_unit(const std::string& unit) {
    for (const NamedUnit& known : kUnits) {
        if (unit == known.name) {
            return known.millimetres;
        }
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(unit.data(), unit.data() + unit.size(), value);
    if (error != std::errc() || end != unit.data() + unit.size() || !std::isfinite(value) ||
        value <= 0.0) {
        throw InvalidInput("The unit '" + unit +
                           "' is not one of m, dm, cm, mm, in or a number of millimetres.");
    }
    return value;
}

std::string unit_name(double mm_per_unit) {
    for (const NamedUnit& known : kUnits) {
        if (std::abs(mm_per_unit / known.millimetres - 1.0) < 1e-9) {
            return known.name;
        }
    }
    return "other";
}

Mat3 axes_from_text(const std::string& text) {
    Mat3 axes = Mat3::Zero();
    if (text.size() == 6) {
        for (int column = 0; column < 3; ++column) {
            const char sign = text[2 * column];
            const int row = text[2 * column + 1] - 'x';
            if ((sign == '+' || sign == '-') && row >= 0 && row < 3) {
                axes(row, column) = sign == '+' ? 1.0 : -1.0;
            }
        }
    }
    if (std::abs(axes.determinant() - 1.0) > 1e-12) {
        throw InvalidInput("The axes '" + text +
                           "' are not a turn: give three signed letters such as +x+y+z or "
                           "+x-z+y that keep left and right apart.");
    }
    return axes;
}

Scan read_mesh_bytes(const std::string& content, const std::string& name,
                     const ReadOptions& options, const Progress* progress) {
    if (content.empty()) {
        throw IoError(name + ": is empty.");
    }
    const std::string extension = lower(std::filesystem::path(name).extension().string());
    Scan scan;
    if (looks_like_ply(content)) {
        read_ply(content, name, scan, progress);
    } else if (extension == ".ply") {
        throw IoError(name + ": does not begin with 'ply', this is not a PLY file.");
    } else if (extension == ".obj" || content.substr(0, 512).find('\0') == std::string::npos) {
        scan.format = FileFormat::Obj;
        read_obj(content, name, scan, progress);
    } else {
        throw IoError(name + ": is neither OBJ nor PLY.");
    }
    if (scan.mesh.vertices.cwiseAbs().maxCoeff() > 1e9) {
        throw IoError(name + ": has a coordinate beyond 1e9, this cannot be a face.");
    }
    if (!(diagonal(scan.mesh.vertices) > 1e-9)) {
        throw IoError(name + ": all vertices lie in one place, this is not a face.");
    }
    scan.file_vertices = scan.mesh.vertices;
    triangulate(scan);
    FileFrame frame;
    frame.mm_per_unit = options.mm_per_unit.value_or(guess_unit(scan.mesh.vertices));
    frame.axes = options.axes.value_or(Mat3::Identity());
    set_frame(scan, frame);
    return scan;
}

Scan read_mesh(const std::filesystem::path& file, const ReadOptions& options,
               const Progress* progress) {
    Scan scan = read_mesh_bytes(read_file(file), file.string(), options, progress);
    for (const std::string& library : scan.material_libraries) {
        if (!scan.texture.empty()) {
            break;
        }
        if (const auto path = inside(file.parent_path(), library)) {
            scan.texture = texture_of(*path);
        }
    }
    return scan;
}

std::optional<std::filesystem::path> texture_path(const Scan& scan,
                                                  const std::filesystem::path& file) {
    const auto path = inside(file.parent_path(), scan.texture);
    std::error_code error;
    if (path && std::filesystem::is_regular_file(*path, error)) {
        return path;
    }
    return std::nullopt;
}

std::shared_ptr<const Image> load_texture(const Scan& scan, const std::filesystem::path& file,
                                          std::string* note) {
    const auto path = texture_path(scan, file);
    if (!path || scan.uv.cols() == 0) {
        return nullptr;
    }
    try {
        return std::make_shared<Image>(read_image(*path));
    } catch (const Error& error) {
        if (note != nullptr) {
            *note = error.what();
        }
        return nullptr;
    }
}

MeshReadReport describe(const Scan& scan, const std::filesystem::path& file) {
    MeshReadReport report;
    static constexpr std::array<const char*, 4> kFormats{
        "OBJ", "PLY ascii", "PLY binary little-endian", "PLY binary big-endian"};
    report.format = kFormats[static_cast<std::size_t>(scan.format)];
    report.vertices = scan.mesh.vertex_count();
    report.faces = scan.faces.count();
    report.triangles = scan.mesh.triangle_count();
    for (int f = 0; f < scan.faces.count(); ++f) {
        report.quads += scan.faces.size(f) == 4 ? 1 : 0;
        report.larger_faces += scan.faces.size(f) > 4 ? 1 : 0;
    }
    const WeldedMesh welded = weld(scan.mesh);
    report.degenerate_triangles = scan.mesh.triangle_count() - welded.mesh.triangle_count();
    report.unreferenced_vertices =
        static_cast<int>(std::count(welded.of_vertex.begin(), welded.of_vertex.end(), -1));
    report.duplicate_vertices =
        report.vertices - report.unreferenced_vertices - welded.mesh.vertex_count();
    report.has_colours = scan.colours.cols() > 0;
    report.has_uv = !scan.faces.uv.empty();
    report.texture = scan.texture;
    report.texture_found = texture_path(scan, file).has_value();
    report.mm_per_unit = scan.frame.mm_per_unit;
    report.unit = unit_name(scan.frame.mm_per_unit);
    report.size_mm =
        scan.mesh.vertices.rowwise().maxCoeff() - scan.mesh.vertices.rowwise().minCoeff();
    if (welded.mesh.triangle_count() == 0) {
        report.notes.emplace_back("No triangle has any area.");
        return report;
    }
    const Adjacency adjacency(welded.mesh);
    report.components = connected_components(welded.mesh).count;
    const auto loops = boundary_loops(welded.mesh, adjacency);
    report.boundary_loops = static_cast<int>(loops.size());
    if (!loops.empty()) {
        for (std::size_t i = 0; i < loops[0].size(); ++i) {
            report.longest_boundary_mm +=
                (welded.mesh.vertices.col(loops[0][i]) -
                 welded.mesh.vertices.col(loops[0][(i + 1) % loops[0].size()]))
                    .norm();
        }
    }
    for (const MeshEdge& edge : adjacency.edges()) {
        report.non_manifold_edges += edge.triangle_count > 2 ? 1 : 0;
    }
    TriangleMesh centred = welded.mesh;
    centred.vertices.colwise() -= Vec3(welded.mesh.vertices.rowwise().mean());
    report.inward_winding = signed_volume(centred) < 0.0;
    if (report.duplicate_vertices > 0) {
        report.notes.push_back(std::to_string(report.duplicate_vertices) +
                               " vertices repeat the place of another one (texture seams); they "
                               "are joined for computing and kept in the file.");
    }
    if (report.degenerate_triangles > 0) {
        report.notes.push_back(std::to_string(report.degenerate_triangles) +
                               " triangles without area take no part in computing.");
    }
    if (report.inward_winding) {
        report.notes.emplace_back("The faces look inwards.");
    }
    if (!report.texture.empty() && !report.texture_found) {
        report.notes.push_back("The texture " + report.texture + " is not beside the file.");
    }
    return report;
}

void write_mesh(const std::filesystem::path& file, const Scan& scan, const Points& vertices) {
    if (vertices.cols() != scan.mesh.vertices.cols()) {
        throw InvalidInput("The number of vertices to write differs from the scan's.");
    }
    const Mat3 back = scan.frame.axes.transpose() / scan.frame.mm_per_unit;
    // What did not move keeps the file's own numbers, to the last digit.
    const Points in_file = scan.file_vertices + back * (vertices - scan.mesh.vertices);
    const std::string extension = lower(file.extension().string());
    if (extension == ".obj") {
        write_file(file, obj_text(scan, in_file));
    } else if (extension == ".ply") {
        write_file(file, ply_bytes(scan, in_file));
    } else {
        throw InvalidInput(file.string() + ": write to a name that ends in .obj or .ply.");
    }
}

}  // namespace myoface
