// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/mesh/triangle_mesh.h"

namespace myoface {

/// A mesh whose edges follow the zero line of a value per vertex.
struct SplitMesh {
    TriangleMesh mesh;
    std::vector<double> values;  ///< per vertex; 0 exactly on the line
};

/// Splits every triangle that the zero line of `values` crosses, by linear interpolation along the
/// edges. A vertex marked false in `part_of` is taken to be off the line: no edge that ends in it
/// is split.
SplitMesh split_along_zero(const TriangleMesh& mesh, const std::vector<double>& values,
                           const std::vector<bool>& part_of);

}  // namespace myoface
