// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/base/progress.h"
#include "myoface/face/face_search.h"
#include "myoface/face/landmarks.h"

namespace myoface {

/// Landmarks found on a scan by its shape alone.
struct DetectedLandmarks {
    Landmarks landmarks;       ///< scan's model frame [mm]; error_mm says how sure each is
    double confidence = 0.0;   ///< 0 … 1 that this is a face and it lies as found
    double residual_mm = 0.0;  ///< median distance of the fitted front of the average head
};

/// Finds landmarks: the face by find_face(), then the most likely person and a free bend brought
/// onto the scan; the landmarks go along and are put onto the surface. Those of the midline are
/// sharpened on the profile, the corners of the mouth where the crease between the lips ends.
/// Landmarks that would lie off the scan are left out.
/// @param pose where the face is, if that is known already (in the scan's model frame)
/// @throws InvalidInput when there is no face on the scan
DetectedLandmarks detect_landmarks(const TriangleMesh& mesh, const FacePose* pose = nullptr,
                                   const Progress* progress = nullptr);

}  // namespace myoface
