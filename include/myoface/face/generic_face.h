// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "myoface/base/progress.h"
#include "myoface/face/landmarks.h"
#include "myoface/face/norms.h"
#include "myoface/io/scan.h"

namespace myoface {

struct GenericFaceOptions {
    int vertices = 12000;               ///< wanted, met within about 15 %; 3,000 … 1,000,000
    std::optional<Sex> sex;             ///< the average of both when absent
    double age = 25.0;                  ///< years; the norms cover 20-25 and are held beyond
    std::optional<std::uint32_t> seed;  ///< an individual drawn from the norms' spread
    double asymmetry = 0.0;             ///< how far left and right differ, one sigma [mm]
    double stubble = 0.0;  ///< 0 shaved … 1 three days' beard; shows on men and women
    int picture = 0;       ///< side of a skin texture [pixels], 0 for colours at the vertices only
};

/// The built-in head with its landmarks, in mm and our axes: origin midway between the tragia.
struct GenericFace {
    Scan scan;
    Landmarks landmarks;
};

/// Builds the head. The skin is one piece, open at the eyes only: behind the lips lies a closed
/// mouth bag. Eyeballs, teeth and gums are pieces of their own. The same options give the same
/// bits; heads of the same number of vertices share their triangles, whatever sex, age and seed.
/// @throws InvalidInput for a count, age, asymmetry or picture out of range
GenericFace make_generic_face(const GenericFaceOptions& options = {},
                              const Progress* progress = nullptr);

/// Landmarks of the average head, which the muscle atlas and tissue depths refer to.
const Landmarks& generic_landmarks();

}  // namespace myoface
