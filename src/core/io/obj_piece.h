// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "myoface/io/scan.h"

#include "number_text.h"

namespace myoface {

/// What one stretch of the file holds. Indices that count backwards are relative to its beginning
/// until the stretches before it are known. Two threads never write to one line of the cache.
struct alignas(128) ObjPiece {
    std::vector<double> positions;
    std::vector<float> colours;  ///< 4 a vertex, missing ones -1; shorter where the tail has none
    std::vector<float> uv;
    std::vector<int> face_sizes;
    std::vector<int> corner_vertex;
    std::vector<int> corner_uv;  ///< one per corner once a face has had any, until then empty
    std::vector<std::size_t> backward_vertex, backward_uv;  ///< corners to be shifted
    std::vector<ObjStatement> statements;
    std::vector<std::string> libraries;
    int highest_vertex = -1, highest_uv = -1;  ///< of those that count forwards
    int others = 0;
    int lines = 0;  ///< read so far
    std::string problem;

    /// Empty, its memory kept.
    void clear() {
        positions.clear();
        colours.clear();
        uv.clear();
        face_sizes.clear();
        corner_vertex.clear();
        corner_uv.clear();
        backward_vertex.clear();
        backward_uv.clear();
        statements.clear();
        libraries.clear();
        highest_vertex = highest_uv = -1;
        others = lines = 0;
    }
};

/// Reads the statements of a stretch that begins and ends with one; what is wrong goes into
/// `problem`, at the line reached.
void parse_obj_piece(std::string_view text, ObjPiece& piece);

/// Whether a line ends in a backslash, which joins it to the next one.
bool statement_continues(const char* at, const char* stop);

inline const char* skip_blanks(const char* at, const char* end) {
    while (at != end && is_blank(*at)) {
        ++at;
    }
    return at;
}

}  // namespace myoface
