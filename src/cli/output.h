// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace myoface::cli {

/// To a file, or to standard output when the name is empty.
void write_text(const std::string& file, const std::string& text);

}  // namespace myoface::cli
