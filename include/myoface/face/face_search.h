// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "myoface/base/progress.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/io/scan.h"

namespace myoface {

/// Where a face was found on a mesh.
struct FacePose {
    Similarity to_generic;   ///< mesh -> size and pose of the average head
    double quality = 0.0;    ///< share of the average face that lies on the mesh, 0 … 1
    double agreement = 0.0;  ///< the same of the most likely person, in place, direction and relief
    double runner_up = 0.0;  ///< quality of the best clearly different pose
};

/// Searches a face by its shape alone: any position, turn, unit and scale. Nose-like places are
/// tried in many turns under many assumed sizes, the best refined by registration of the front of
/// the average head, then of the most likely person. The same mesh gives the same bits.
/// @pre faces look outwards, see examine()
/// @return nothing when no place looks even remotely like a face
std::optional<FacePose> find_face(const TriangleMesh& mesh, const Progress* progress = nullptr);

/// How sure a pose is, 0 … 1: below 0.5 it should be looked at, 0 is none.
double confidence_of(const FacePose& pose);

/// Unit and axes of a scan from the pose of its face.
struct FrameGuess {
    FileFrame frame;
    bool usual_unit = false;  ///< the size fits one of m dm cm mm in; else it is an estimate
    double confidence = 0.0;
};

/// The quarter turns nearest to the pose, and the usual unit that makes the face 0.8 … 1.28 of the
/// average size; without one, mm per unit as the average face implies it.
/// @param scan in any frame
FrameGuess guess_frame(const Scan& scan, const FacePose& pose);

}  // namespace myoface
