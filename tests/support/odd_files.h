// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace myoface::test {

/// A file as somebody may send it.
struct OddFile {
    std::string name;  ///< with the extension that tells its format
    std::string bytes;
    bool good = false;  ///< must be read; others must be refused with a sentence
};

/// Well over a hundred odd and broken files: every way a header, count, index, number, encoding or
/// path can lie. Also the seeds of the fuzz targets.
std::vector<OddFile> odd_files();

}  // namespace myoface::test
