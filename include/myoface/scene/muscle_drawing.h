// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "myoface/base/view_ray.h"
#include "myoface/face/face_model.h"
#include "myoface/physics/build_mass_spring.h"
#include "myoface/scene/scene.h"

namespace myoface {

/// Muscles as bundles of fibres: strands beside each other that thin out into tendons, thicker
/// while the muscle is short so that it keeps its volume. Coloured by muscle, both sides of a pair
/// alike. Fills positions and normals; indices and colours too where `layer` has none yet.
void draw_muscles(SurfaceLayer& layer, const FaceModel& face,
                  const std::vector<MuscleChain>& chains, const Points& nodes);

/// The muscle that a line of sight meets first, by its fibres; nothing where there is none.
std::optional<int> muscle_on_ray(const FaceModel& face, const ViewRay& ray);

/// What lies at a place of the skin, in words: region, and the muscles under it with their shares.
std::string tissue_in_words(const FaceModel& face, int node, bool japanese);

/// Name, action unit and nerve of a muscle, in words.
std::string muscle_in_words(const MuscleTraits& traits, bool japanese);

}  // namespace myoface
