// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/drag/stress_kernel.h"

namespace myoface {

/// How a stress prefers the fibres of the muscles under a grip: a way along them counts less than
/// one across, so that it spreads along a linear muscle and around a sphincter. Taken on the face
/// at rest, from the place of the grip on the nearest fibre; independent of the triangles.
class FibreWay {
public:
    /// @param elongation how many times further along than across (≥ 1); across it stays as it is.
    ///        Around a ring, whose fibres bend away from the pull, a third of what is beyond 1
    FibreWay(const FaceModel& face, const Grip& grip, double elongation);

    /// What a way from the grip to a skin node counts, of its length.
    double factor(int node) const;
    /// The smallest factor() there is.
    double least() const { return along_; }

private:
    struct Line {
        Points points;
        bool closed = false;
        double share = 0.0;  ///< of the grip's muscles
        double start = 0.0;  ///< of the grip along it [mm]
        double along = 1.0;  ///< what a way along it counts
    };
    const FaceModel& face_;
    Vec3 centre_;
    std::vector<Line> lines_;
    double along_ = 1.0;
};

/// Where a place lies along a line of points: length from its first point to the nearest one of the
/// line, going on straight beyond its ends where it is open [mm].
double along_line(const Points& line, bool closed, const Vec3& place);
double line_length(const Points& line, bool closed);

}  // namespace myoface
