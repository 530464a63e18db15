// SPDX-License-Identifier: Apache-2.0
// The body of a journal's record; the target puts the sum before it.
#include <filesystem>
#include <unistd.h>

#include "myoface/cases/journal.h"
#include "myoface/io/text_file.h"

#include "bad_files.h"
#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace myoface;
    static const std::filesystem::path folder = [] {
        const std::filesystem::path place =
            std::filesystem::temp_directory_path() / ("myoface-fuzz-" + std::to_string(::getpid()));
        std::filesystem::create_directories(place);
        write_file(place / "face.myoface", test::good_case());
        return place;
    }();
    fuzz::guarded([&] {
        write_file(folder / "state",
                   test::journal_record({reinterpret_cast<const char*>(data), size}));
        const OpenedFace face = recover({folder, "f", 1, "", false});
        fuzz::require(face.state.shape.allFinite());
    });
    return 0;
}
