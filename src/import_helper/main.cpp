// SPDX-License-Identifier: Apache-2.0
// Reads one glTF file with assimp and writes it to standard output as the desktop program's
// interchange bytes. Limits itself in memory and processor time before it looks at the file.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <sys/resource.h>

#include "myoface/base/error.h"
#include "myoface/io/interchange.h"

#include "gltf_scene.h"

// GCC says by a macro that it sanitizes, Clang by a feature.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MYOFACE_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MYOFACE_SANITIZED
#endif
#endif

namespace {

namespace fs = std::filesystem;

void limit(int what, rlim_t amount) {
    const rlimit both{amount, amount};
    setrlimit(what, &both);
}

/// What honest files need: a base for the program itself and a multiple of the bytes at hand.
void limit_to(const fs::path& file) {
    std::error_code error;
    std::uintmax_t bytes = fs::file_size(file, error);
    for (fs::directory_iterator entry(file.parent_path().empty() ? "." : file.parent_path(), error),
         end;
         !error && entry != end; entry.increment(error)) {
        if (entry->path().extension() == ".bin") {
            std::error_code ignored;
            bytes += entry->file_size(ignored);
        }
    }
    constexpr std::uintmax_t kBase = 700'000'000;
    constexpr std::uintmax_t kMost = 12'000'000'000;
#if !defined(MYOFACE_SANITIZED)  // a sanitizer maps terabytes
    limit(RLIMIT_AS, static_cast<rlim_t>(std::min(kBase + 60 * bytes, kMost)));
#else
    static_cast<void>(std::min(kBase + bytes, kMost));
#endif
    limit(RLIMIT_CPU, 60);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: myoface-import FILE.gltf|FILE.glb > SCAN\n", stderr);
        return 2;
    }
    try {
        std::signal(SIGXFSZ, SIG_IGN);
        limit_to(argv[1]);
        const std::string bytes = myoface::encode_scan(myoface::read_gltf_scene(argv[1]));
        const bool whole = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
        // Without the destructors of assimp, which have nothing to add.
        std::_Exit(whole && std::fflush(stdout) == 0 ? 0 : 3);
    } catch (const myoface::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
    } catch (const std::bad_alloc&) {
        std::fputs("asks for more memory than such a file can need; it is damaged.\n", stderr);
    } catch (const std::exception&) {
        std::fputs("is damaged.\n", stderr);
    }
    std::fflush(stderr);
    std::_Exit(1);
}
