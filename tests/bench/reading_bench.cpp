// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <unistd.h>

#include <benchmark/benchmark.h>

#include "myoface/face/generic_face.h"
#include "myoface/io/mesh_file.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

/// The bytes of a head of 200,000 vertices in a format.
const std::string& bytes(FileFormat format) {
    static std::map<FileFormat, std::string> cache;
    std::string& text = cache[format];
    if (text.empty()) {
        GenericFaceOptions options;
        options.vertices = 200000;
        GenericFace face = make_generic_face(options);
        face.scan.format = format;
        const auto part = std::filesystem::temp_directory_path() /
                          ("myoface-bench-" + std::to_string(::getpid()) +
                           (format == FileFormat::Obj ? ".obj" : ".ply"));
        write_mesh(part, face.scan, face.scan.mesh.vertices);
        text = read_file(part);
        std::filesystem::remove(part);
    }
    return text;
}

void BM_Read(benchmark::State& state, FileFormat format) {
    const std::string& text = bytes(format);
    const std::string name = format == FileFormat::Obj ? "bench.obj" : "bench.ply";
    for (auto _ : state) {
        benchmark::DoNotOptimize(read_mesh_bytes(text, name));
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}
BENCHMARK_CAPTURE(BM_Read, obj, FileFormat::Obj)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Read, ply_binary, FileFormat::PlyBinaryLittle)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Read, ply_ascii, FileFormat::PlyAscii)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace myoface
