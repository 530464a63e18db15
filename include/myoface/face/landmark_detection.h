// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/base/progress.h"
#include "myoface/face/face_search.h"
#include "myoface/face/landmarks.h"

namespace myoface {

/// Landmarks found on a scan by its shape alone.
struct DetectedLandmarks {
    Landmarks landmarks;       ///< scan's model frame [mm]; error_mm says how sure each is
    double confidence = 0.0;   ///< of the pose, see confidence_of()
    double residual_mm = 0.0;  ///< median distance of the fitted front of the average head
};

/// Finds landmarks: the face by find_face(), then the front of the average head bent onto the scan,
/// coarse to fine; its landmarks are put onto the surface, those of the midline sharpened on the
/// profile. Landmarks that would lie off the scan are left out.
/// @param pose where the face is, if that is known already (in the scan's model frame)
/// @throws InvalidInput when there is no face on the scan
DetectedLandmarks detect_landmarks(const TriangleMesh& mesh, const FacePose* pose = nullptr,
                                   const Progress* progress = nullptr);

}  // namespace myoface
