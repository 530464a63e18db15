// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "myoface/mesh/adjacency.h"

namespace myoface {

/// Smoothing of per-vertex vectors by heat flow on the surface, (M + t L) y = M x with the
/// cotangent Laplacian: its reach is in millimetres and does not depend on how fine the mesh is.
/// @cite desbrun_1999
class Diffusion {
public:
    /// @param time t [mm²] of one application; features smaller than about √(2t) go.
    Diffusion(const TriangleMesh& mesh, const Adjacency& adjacency, double time);
    ~Diffusion();
    Diffusion(Diffusion&&) noexcept;
    Diffusion& operator=(Diffusion&&) noexcept;

    Points apply(const Points& values, int times) const;

private:
    struct Solver;
    std::unique_ptr<Solver> solver_;
};

}  // namespace myoface
