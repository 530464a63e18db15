// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "myoface/face/face_model.h"
#include "myoface/face/norms.h"

namespace myoface {

/// The landmarks of a face as skin under them moves. Those that were not given stand where the fit
/// puts the average head's.
class LandmarksOnSkin {
public:
    explicit LandmarksOnSkin(std::shared_ptr<const FaceModel> face);

    /// @param nodes 3×nodes, the skin's first [mm]
    Landmarks at(const Points& nodes) const;
    /// A measure at that moment; projections are taken along the face's own axes, which do not turn
    /// with the chin. Nothing where a landmark is unknown.
    std::optional<double> measure(const Measure& measure, const Points& nodes) const;

private:
    std::shared_ptr<const FaceModel> face_;
    Landmarks landmarks_;  ///< at rest
    std::map<std::string, SurfacePoint> on_skin_;
};

}  // namespace myoface
