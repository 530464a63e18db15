// SPDX-License-Identifier: Apache-2.0
// Opening a scan of 1,000,000 vertices and 2,000,000 triangles, beside assimp and tinyobjloader.
#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <cmath>
#include <fstream>
#include <numbers>
#include <tiny_obj_loader.h>
#include <unistd.h>

#include <benchmark/benchmark.h>

#include "myoface/cases/case_file.h"
#include "myoface/io/mesh_file.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

namespace fs = std::filesystem;

constexpr int kAround = 1000;
constexpr int kRings = 1001;

/// A bumpy ball the size of a head, as files with numbers in single precision.
Scan ball() {
    Scan scan;
    scan.mesh.vertices.resize(3, kAround * kRings);
    for (int r = 0; r < kRings; ++r) {
        for (int a = 0; a < kAround; ++a) {
            const double latitude = std::numbers::pi * (r + 0.5) / kRings;
            const double longitude = 2.0 * std::numbers::pi * a / kAround;
            const double radius =
                110.0 + 3.0 * std::sin(9.0 * longitude) * std::sin(7.0 * latitude);
            scan.mesh.vertices.col(r * kAround + a)
                << radius * std::sin(latitude) * std::sin(longitude),
                radius * std::cos(latitude), radius * std::sin(latitude) * std::cos(longitude);
        }
    }
    scan.mesh.vertices = scan.mesh.vertices.cast<float>().cast<double>().eval();
    for (int r = 0; r + 1 < kRings; ++r) {
        for (int a = 0; a < kAround; ++a) {
            const int next = (a + 1) % kAround;
            const int v = r * kAround;
            for (const int corner : {v + a, v + kAround + a, v + kAround + next}) {
                scan.faces.vertex.push_back(corner);
            }
            for (const int corner : {v + a, v + kAround + next, v + next}) {
                scan.faces.vertex.push_back(corner);
            }
            scan.faces.start.push_back(static_cast<int>(scan.faces.vertex.size()) - 3);
            scan.faces.start.push_back(static_cast<int>(scan.faces.vertex.size()));
        }
    }
    scan.file_vertices = scan.mesh.vertices;
    scan.float_coordinates = true;
    triangulate(scan);
    return scan;
}

/// Files that are made once and removed at the end.
class Files {
public:
    Files() : folder_(fs::temp_directory_path() / ("myoface-bench-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
        Scan scan = ball();
        write_mesh(path(FileFormat::Obj), scan, scan.mesh.vertices);
        for (const FileFormat format : {FileFormat::PlyAscii, FileFormat::PlyBinaryLittle}) {
            scan.format = format;
            write_mesh(path(format), scan, scan.mesh.vertices);
        }
        scan.format = FileFormat::StlBinary;
        write_mesh(path(FileFormat::StlBinary), scan, scan.mesh.vertices);
    }
    ~Files() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;

    fs::path path(FileFormat format) const {
        return folder_ / (format == FileFormat::Obj         ? "ball.obj"
                          : format == FileFormat::PlyAscii  ? "text.ply"
                          : format == FileFormat::StlBinary ? "ball.stl"
                                                            : "binary.ply");
    }

private:
    fs::path folder_;
};

const Files& files() {
    static const Files kFiles;
    return kFiles;
}

/// What the peers do, too: from the file to vertices and triangles.
void BM_Ours(benchmark::State& state, FileFormat format) {
    const fs::path file = files().path(format);
    ReadOptions options;
    options.examine = false;
    for (auto _ : state) {
        benchmark::DoNotOptimize(read_mesh(file, options));
    }
}

/// The same with what no peer does: seams, winding, holes, parts.
void BM_OursExamined(benchmark::State& state, FileFormat format) {
    const fs::path file = files().path(format);
    for (auto _ : state) {
        benchmark::DoNotOptimize(read_mesh(file));
    }
}

void BM_Assimp(benchmark::State& state, FileFormat format) {
    const fs::path file = files().path(format);
    for (auto _ : state) {
        Assimp::Importer importer;
        if (importer.ReadFile(file.string(), 0) == nullptr) {
            state.SkipWithError(importer.GetErrorString());
        }
    }
}

void BM_TinyObj(benchmark::State& state) {
    const fs::path file = files().path(FileFormat::Obj);
    for (auto _ : state) {
        tinyobj::ObjReaderConfig config;
        config.triangulate = false;
        config.vertex_color = false;
        tinyobj::ObjReader reader;
        if (!reader.ParseFromFile(file.string(), config)) {
            state.SkipWithError("tinyobjloader failed");
        }
        benchmark::DoNotOptimize(reader.GetAttrib().vertices.data());
    }
}

/// A case of that scan, reshaped: packed, written and made safe against a loss of power.
void BM_SaveCase(benchmark::State& state) {
    const fs::path file = files().path(FileFormat::PlyBinaryLittle);
    OpenedFace opened;
    opened.scan_bytes = read_file(file);
    opened.scan_name = "scan.ply";
    opened.scan = std::make_shared<const Scan>(read_mesh(file));
    CaseState edits;
    edits.shape = opened.scan->mesh.vertices;
    const Eigen::Index some = edits.shape.cols() / 10;  // as far as a gesture's reach
    edits.shape.leftCols(some).row(2).array() +=
        0.5 + 0.5 * edits.shape.leftCols(some).row(0).array().sin();
    const fs::path target = file.parent_path() / "ball.myoface";
    for (auto _ : state) {
        write_case(target, opened, edits);
    }
    state.counters["MiB"] = static_cast<double>(fs::file_size(target)) / 1048576.0;
}

constexpr auto kObj = FileFormat::Obj;
constexpr auto kText = FileFormat::PlyAscii;
constexpr auto kBinary = FileFormat::PlyBinaryLittle;
constexpr auto kStl = FileFormat::StlBinary;
BENCHMARK_CAPTURE(BM_Ours, obj, kObj)
    ->Name("read_obj_1m_ms")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_Assimp, obj, kObj)
    ->Name("read_obj_1m_assimp_ms")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_OursExamined, obj, kObj)
    ->Name("open_obj_1m_ms")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_OursExamined, ply, kBinary)
    ->Name("open_ply_binary_1m_ms")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(BM_TinyObj)->Name("read_obj_1m_tinyobj_ms")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_Ours, ply, kBinary)
    ->Name("read_ply_binary_1m_ms")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_Assimp, ply, kBinary)
    ->Name("read_ply_binary_1m_assimp_ms")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_Ours, ply_text, kText)
    ->Name("read_ply_ascii_1m_ms")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_Assimp, ply_text, kText)
    ->Name("read_ply_ascii_1m_assimp_ms")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_Ours, stl, kStl)
    ->Name("read_stl_1m_ms")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_Assimp, stl, kStl)
    ->Name("read_stl_1m_assimp_ms")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(BM_SaveCase)->Name("save_case_1m_ms")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace myoface
