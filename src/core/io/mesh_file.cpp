// SPDX-License-Identifier: Apache-2.0
#include "myoface/io/mesh_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <unistd.h>

#include "myoface/base/error.h"
#include "myoface/io/mapped_file.h"
#include "myoface/io/text_file.h"

#include "lower_case.h"
#include "readers.h"
#include "writers.h"

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

bool looks_like_ply(std::string_view content) {
    return content.substr(0, 4) == "ply\n" || content.substr(0, 4) == "ply\r";
}

bool looks_like_gltf(std::string_view content, const std::string& extension) {
    return content.substr(0, 4) == "glTF" || extension == ".gltf" || extension == ".glb";
}

bool looks_like_stl(std::string_view content, const std::string& extension) {
    const std::string_view head = content.substr(0, 1024);
    return extension == ".stl" ||
           (head.substr(0, 6) == "solid " && head.find("facet") != std::string_view::npos);
}

/// A folder for one file that another process is to read.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "myoface-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) {
            throw IoError("No temporary folder can be made in " +
                          std::filesystem::temp_directory_path().string() + ".");
        }
        path = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path path;
};

/// What all formats have in common once the file's own numbers are there.
void finish(Scan& scan, const std::string& name, const ReadOptions& options,
            const Progress* progress) {
    if (scan.mesh.vertices.cwiseAbs().maxCoeff() > 1e9) {
        throw IoError(name + ": has a coordinate beyond 1e9, this cannot be a face.");
    }
    if (!(diagonal(scan.mesh.vertices) > 1e-9)) {
        throw IoError(name + ": all vertices lie in one place, this is not a face.");
    }
    const auto report = [&](double share) {
        if (progress != nullptr) {
            progress->report("Checking", share);
        }
    };
    report(0.0);
    scan.file_vertices = scan.mesh.vertices;
    triangulate(scan);
    report(0.3);
    FileFrame frame;
    frame.mm_per_unit = options.mm_per_unit.value_or(guess_unit(scan.mesh.vertices));
    frame.axes = options.axes.value_or(Mat3::Identity());
    set_frame(scan, frame);
    if (options.examine) {
        examine(scan);
    }
    report(1.0);
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

Mat3 nearest_quarter_turn(const Mat3& rotation) {
    static constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    Mat3 best = Mat3::Identity();
    double agreement = -10.0;
    for (int code = 0; code < 6 * 8; ++code) {
        const auto& order = kOrders[static_cast<std::size_t>(code / 8)];
        Mat3 turn = Mat3::Zero();
        for (int row = 0; row < 3; ++row) {
            turn(row, order[static_cast<std::size_t>(row)]) = (code >> row & 1) != 0 ? -1.0 : 1.0;
        }
        const double now = (turn.transpose() * rotation).trace();
        if (turn.determinant() > 0.0 && now > agreement) {
            agreement = now;
            best = turn;
        }
    }
    return best;
}

std::string axes_to_text(const Mat3& axes) {
    std::string text;
    for (int column = 0; column < 3; ++column) {
        Eigen::Index row = 0;
        axes.col(column).cwiseAbs().maxCoeff(&row);
        text += axes(row, column) < 0.0 ? '-' : '+';
        text += static_cast<char>('x' + row);
    }
    return text;
}

Scan read_mesh_bytes(std::string_view content, const std::string& name, const ReadOptions& options,
                     const Progress* progress) {
    if (content.empty()) {
        throw IoError(name + ": is empty.");
    }
    const std::string extension = lower_case(std::filesystem::path(name).extension().string());
    Scan scan;
    if (looks_like_ply(content)) {
        read_ply(content, name, scan, progress);
    } else if (extension == ".ply") {
        throw IoError(name + ": does not begin with 'ply', this is not a PLY file.");
    } else if (looks_like_gltf(content, extension)) {
        const TemporaryFolder folder;
        const auto file = folder.path / (content.substr(0, 4) == "glTF" ? "scan.glb" : "scan.gltf");
        write_file(file, content);
        try {
            read_gltf(file, scan, progress);
        } catch (const IoError& error) {  // in the words of the file that was asked for
            const std::string what = error.what();
            const std::string there = file.string();
            throw IoError(what.rfind(there, 0) == 0 ? name + what.substr(there.size()) : what);
        }
    } else if (looks_like_stl(content, extension)) {
        read_stl(content, name, scan, progress);
    } else if (extension == ".obj" || content.substr(0, 512).find('\0') == std::string_view::npos) {
        scan.format = FileFormat::Obj;
        read_obj(content, name, scan, progress);
    } else {
        throw IoError(name + ": is none of OBJ, PLY, STL, glTF and GLB.");
    }
    finish(scan, name, options, progress);
    return scan;
}

Scan read_mesh(const std::filesystem::path& file, const ReadOptions& options,
               const Progress* progress) {
    const MappedFile mapped(file);
    Scan scan;
    if (looks_like_gltf(mapped.bytes(), lower_case(file.extension().string())) &&
        !mapped.bytes().empty()) {
        read_gltf(file, scan, progress);
        finish(scan, file.string(), options, progress);
    } else {
        scan = read_mesh_bytes(mapped.bytes(), file.string(), options, progress);
    }
    read_companions(file, scan);
    return scan;
}

void read_companions(const std::filesystem::path& file, Scan& scan) {
    read_materials(file.parent_path(), scan);
}

MeshReadReport describe(const Scan& scan) {
    MeshReadReport report;
    static constexpr std::array<const char*, 8> kFormats{"OBJ",
                                                         "PLY ascii",
                                                         "PLY binary little-endian",
                                                         "PLY binary big-endian",
                                                         "STL ascii",
                                                         "STL binary",
                                                         "glTF",
                                                         "GLB"};
    report.format = kFormats[static_cast<std::size_t>(scan.format)];
    report.vertices = scan.mesh.vertex_count();
    report.faces = scan.faces.count();
    report.triangles = scan.mesh.triangle_count();
    for (int f = 0; f < scan.faces.count(); ++f) {
        report.quads += scan.faces.size(f) == 4 ? 1 : 0;
        report.larger_faces += scan.faces.size(f) > 4 ? 1 : 0;
    }
    const ScanFindings& found = report.findings = scan.findings;
    report.longest_hole_mm = found.longest_hole * scan.frame.mm_per_unit;
    report.has_colours = scan.colours.cols() > 0;
    report.has_uv = !scan.faces.uv.empty();
    report.texture = scan.textures.empty() ? "" : scan.textures[0].name;
    report.texture_found = !scan.textures.empty() && !scan.textures[0].bytes.empty();
    report.mm_per_unit = scan.frame.mm_per_unit;
    report.unit = unit_name(scan.frame.mm_per_unit);
    report.axes = axes_to_text(scan.frame.axes);
    report.size_mm =
        scan.mesh.vertices.rowwise().maxCoeff() - scan.mesh.vertices.rowwise().minCoeff();

    if (found.parts.empty()) {
        report.notes.emplace_back("No triangle has any area.");
        return report;
    }
    const auto note = [&](std::size_t count, const std::string& what, const std::string& done) {
        if (count > 0) {
            report.notes.push_back(what + ": " + std::to_string(count) + ". " + done);
        }
    };
    const auto some = [&](int count, const char* what, const char* done) {
        note(static_cast<std::size_t>(count), what, done);
    };
    some(found.duplicate_vertices, "Vertices at the place of another one (texture seams)",
         "Joined for computing, kept in the file.");
    some(found.unreferenced_vertices, "Vertices of no triangle with area", "Kept in the file.");
    some(found.degenerate_triangles, "Triangles without area",
         "Left out of computing, kept in the file.");
    some(found.duplicate_triangles, "Triangles that repeat another one",
         "Left out of computing, kept in the file.");
    some(found.turned_triangles, "Triangles wound against their neighbours",
         "Turned over for computing, kept in the file as they came.");
    if (found.inward) {
        report.notes.emplace_back(
            "The faces look inwards. Turned over for computing, kept in the file as they came.");
    }
    some(found.non_manifold_edges, "Edges of more than two triangles", "Left as they are.");
    note(found.parts.size() - 1, "Loose parts beside the largest one",
         "The face is fitted to the part that holds it; the others are shown and kept.");
    some(found.other_statements, "Entries that are neither vertices nor faces",
         "They are not kept in what is written.");
    for (const Texture& texture : scan.textures) {
        if (texture.bytes.empty()) {
            report.notes.push_back("The texture " + texture.name + " is not beside the file.");
        }
    }
    return report;
}

namespace {

Points in_file(const Scan& scan, const Points& vertices) {
    if (vertices.cols() != scan.mesh.vertices.cols()) {
        throw InvalidInput("The number of vertices to write differs from the scan's.");
    }
    const Mat3 back = scan.frame.axes.transpose() / scan.frame.mm_per_unit;
    // What did not move keeps the file's own numbers, to the last digit.
    return scan.file_vertices + back * (vertices - scan.mesh.vertices);
}

std::string main_file(const std::string& name, const Scan& scan, const Points& vertices,
                      const std::string& library) {
    const std::string extension = lower_case(std::filesystem::path(name).extension().string());
    const Points points = in_file(scan, vertices);
    if (extension == ".obj") {
        return obj_text(scan, points, library);
    }
    if (extension == ".ply") {
        return ply_bytes(scan, points);
    }
    if (extension == ".stl") {
        return stl_bytes(scan, points);
    }
    if (extension == ".glb") {
        return glb_bytes(scan, points);
    }
    throw InvalidInput(name + ": write to a name that ends in .obj, .ply, .stl or .glb.");
}

/// A texture's name beside `file`: its own, or one with the file's name where another picture of
/// that name is there.
OutputFile place_texture(const std::filesystem::path& file, const Texture& texture) {
    std::string name = texture.name;
    std::replace(name.begin(), name.end(), '\\', '/');
    name = name.substr(name.find_last_of('/') + 1);
    OutputFile out{file.parent_path() / name, texture.bytes};
    std::error_code error;
    if (std::filesystem::exists(out.file, error)) {
        const MappedFile there(out.file);
        if (there.bytes() == texture.bytes) {
            out.bytes.clear();  // nothing to do
        } else {
            out.file = file.parent_path() / (file.stem().string() + "_" + name);
        }
    }
    return out;
}

}  // namespace

std::string mesh_bytes(const std::string& name, const Scan& scan, const Points& vertices) {
    return main_file(name, scan, vertices, {});
}

void write_mesh(const std::filesystem::path& file, const Scan& scan, const Points& vertices) {
    const std::string extension = lower_case(file.extension().string());
    const bool library =
        extension == ".obj" &&
        std::any_of(scan.materials.begin(), scan.materials.end(), [](const Material& m) {
            return m.texture >= 0 || m.colour != Material().colour;
        });
    const std::string library_name = library ? file.stem().string() + ".mtl" : std::string();
    const std::string content = main_file(file.string(), scan, vertices, library_name);
    if (library || extension == ".ply") {
        std::vector<std::string> names;
        for (const Texture& texture : scan.textures) {
            names.push_back(texture.name);
            if (texture.bytes.empty()) {
                continue;
            }
            const OutputFile out = place_texture(file, texture);
            names.back() = out.file.filename().string();
            if (!out.bytes.empty()) {
                write_file(out.file, out.bytes);
            }
        }
        if (library) {
            write_file(file.parent_path() / library_name, mtl_text(scan, names));
        }
    }
    write_file(file, content);
}

}  // namespace myoface
