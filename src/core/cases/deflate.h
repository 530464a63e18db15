// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "myoface/base/progress.h"

namespace myoface {

/// Bytes made smaller, as a zip holds them.
struct Deflated {
    std::string bytes;      ///< a raw DEFLATE stream
    std::uint32_t sum = 0;  ///< CRC-32 of what went in
};

/// Compresses with all threads: pieces of fixed size, each a run of whole blocks of one stream, so
/// that every inflater reads it and its bytes are the same for any number of threads. Pieces do
/// not look back into each other, which costs less than a hundredth of the size.
/// @param level 1 … 9, of zlib @throws Cancelled, std::bad_alloc
/// @cite deutsch_1996
Deflated deflate(std::string_view bytes, int level, const Progress* progress = nullptr);

}  // namespace myoface
