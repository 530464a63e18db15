// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/base/points.h"

namespace myoface {

/// How the fronts of people's heads differ: displacements of the face template's points that stand
/// for one standard deviation each. Learnt from seeded individuals of the built-in head by their
/// landmarks (assets/people.json), and one mode in which the jaw opens.
/// @cite blanz_1999
struct People {
    Points mean;  ///< 3×N: mean person less the average head, on the template's points [mm]
    Eigen::MatrixXd modes;  ///< 3N×K [mm]
    Eigen::Index jaw = 0;   ///< column in which the jaw opens
};

/// Read once. @throws IoError when the program's own table is damaged
const People& people();

}  // namespace myoface
