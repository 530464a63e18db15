// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "myoface/io/scan.h"

namespace myoface {

/// A scan whose closed lips, grown together by the scanner, are parted along the line between them.
struct PartedLips {
    std::shared_ptr<const Scan> scan;  ///< the input's vertices first and in order, then those of
                                       ///< both margins; faces along the line are triangles
    Points generic;                    ///< 3×vertices of `scan`: average head coordinates
    std::vector<signed char> side;     ///< per vertex of `scan`: 1 upper, -1 lower lip, 0 neither
};

/// Cuts along the average head's line between the lips, as far as the corners of the mouth.
/// @param generic 3×vertices: coordinates of each vertex on the average head, NaN where a vertex
///        takes no part
/// @return nothing where the lips are open already, or there is no mouth
std::optional<PartedLips> part_lips(const Scan& scan, const Points& generic);

}  // namespace myoface
