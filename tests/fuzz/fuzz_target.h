// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/io/mesh_file.h"

namespace myoface::fuzz {

inline void require(bool truth) {
    if (!truth) {
        std::abort();
    }
}

/// Runs what may refuse its input with one sentence, and nothing else.
template <typename Action>
void guarded(const Action& action) {
    set_thread_count(1);
    try {
        action();
    } catch (const Error& error) {
        require(std::string_view(error.what()).find('\n') == std::string_view::npos);
    }
}

/// Reads bytes as a file of that name: a scan whose every number and index is good, or one
/// sentence.
inline void read(std::string_view bytes, const char* name) {
    guarded([&] {
        const Scan scan = read_mesh_bytes(bytes, name);
        require(scan.mesh.vertices.allFinite() && scan.uv.allFinite() && scan.colours.allFinite() &&
                scan.mesh.triangles.minCoeff() >= 0 &&
                scan.mesh.triangles.maxCoeff() < scan.mesh.vertex_count());
        describe(scan);
        const std::string extension = std::string(name).substr(1);
        mesh_bytes("f" + extension, scan, scan.mesh.vertices);
    });
}

}  // namespace myoface::fuzz
