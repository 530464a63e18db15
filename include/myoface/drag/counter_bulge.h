// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/drag/stress_kernel.h"
#include "myoface/physics/mass_spring_model.h"

namespace myoface {

/// Tissue cannot be pressed together: where a pull along the skin gathers it, it comes out, and
/// where the pull thins it, it sinks in. A pull F through a kernel with profile φ moves the skin by
/// about φ c F, c being the give of the tissue under the kernel,
///   c = Σ w φ / (Σ k_t φ² + ½ Σ k_e (φ_a − φ_b)²);
/// to keep its volume the layer of depth d between skin and bone has to grow thicker by
/// −d ∇φ·cF, and its thickness spring k_n asks −k_n d ∇φ·cF for that. These pushes balance each
/// other over the kernel. @cite matsuda_muscle_spring (5.2: the kernel imitates volume
/// preservation)
/// @return 3×kernel nodes b: node j is pushed outwards along its normal by b_j·F
Points counter_bulge(const FaceModel& face, const MassSpringModel& model, const Points& skin,
                     const StressKernel& kernel);

}  // namespace myoface
