// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "myoface/face/face_model.h"

namespace myoface {

/// Volume that triangles sweep on straight ways, outwards positive [mm³]. Exact: the flux through a
/// moving triangle is a polynomial of second degree in time. @param before, after 3×N [mm]
double swept_volume(const Triangles& triangles, const Points& before, const Points& after);

/// The same by region of the skin, in millilitres; each triangle belongs to the region that most of
/// its corners belong to. Regions that did not change are left out. @param before, after 3×nodes
std::map<Region, double> volume_by_region(const FaceModel& face, const Points& before,
                                          const Points& after);

}  // namespace myoface
