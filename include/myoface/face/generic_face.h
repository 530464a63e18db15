// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "myoface/base/progress.h"
#include "myoface/face/landmarks.h"
#include "myoface/io/scan.h"

namespace myoface {

enum class Sex { Female, Male };

struct GenericFaceOptions {
    int vertices = 12000;               ///< wanted, met within about 15 %; 3,000 … 400,000
    std::optional<Sex> sex;             ///< the average of both when absent
    double age = 25.0;                  ///< years; the norms cover 20-25 and are held beyond
    std::optional<std::uint32_t> seed;  ///< an individual drawn from the norms' spread
};

/// The built-in head with its landmarks, in mm and our axes: origin midway between the tragia.
struct GenericFace {
    Scan scan;
    Landmarks landmarks;
};

/// Builds the head. Lids and lips are open along their margins; neck and crown are closed; the
/// eyeballs are parts of their own. The same options give the same bits.
/// @throws InvalidInput for a count or age out of range
GenericFace make_generic_face(const GenericFaceOptions& options = {},
                              const Progress* progress = nullptr);

/// Landmarks of the average head, which the muscle atlas and tissue depths refer to.
const Landmarks& generic_landmarks();

}  // namespace myoface
