// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the lane kernels work on: plain data, for they are compiled once per instruction set and
// must share no inline function with the rest of the program. Eight nodes, one slice, are worked
// on at a time; arrays of eight hold one number per node of a slice.

#include <cstdint>

namespace myoface {

constexpr int kLanes = 8;

/// A node as its neighbours see it. A force at rest and near it: rest and way from it; in motion:
/// position and velocity.
struct alignas(32) NodeRecord {
    float place[3];
    float limit;  ///< Stretch::limit
    float moved[3];
    float stiffening;  ///< Stretch::stiffening
};

/// One neighbour of each node of a slice, joined by a spring.
struct SpringColumn {
    std::int32_t other[kLanes];
    float stiffness[kLanes], length[kLanes];
};
/// One more node that each node of a slice is joined with by linear stiffness only.
struct LinkColumn {
    std::int32_t other[kLanes];
    float value[kLanes];
};

struct TieLanes {
    float normal[3][kLanes];
    float curvature[6][kLanes];  ///< xx yy zz xy xz yz
    float thickness[kLanes], tether[kLanes], anchor[kLanes], stop[kLanes];
};
/// What a drive changes about ties.
struct TargetLanes {
    float carry[3][kLanes], shift[3][kLanes], height[kLanes];
};
/// An outer force and a spring to the place at rest, ½ ground |u|².
struct LoadLanes {
    float force[3][kLanes], ground[kLanes];
};
struct VectorLanes {
    float v[3][kLanes];
};
struct ScalarLanes {
    float s[kLanes];
};

struct ForceTask {
    const NodeRecord* records;
    const int* spring_start;  ///< per slice, in columns
    const int* link_start;
    const SpringColumn* springs;
    const LinkColumn* links;
    const ScalarLanes* linear;  ///< per column of springs: K_ij, acts on the difference of the ways
    const TieLanes* ties;
    const TargetLanes* targets;  ///< or null
    const LoadLanes* loads;      ///< or null
    const ScalarLanes* damping;  ///< per column of springs, in motion only
    const ScalarLanes* tie_damping;
    const VectorLanes* linear_rest;  ///< Σ K_ij (rest_j − rest_i), in motion only
    const VectorLanes* rest;         ///< in motion only
    bool tissue;                     ///< springs stiffen, have limits, and linear stiffness
    bool sliding;                    ///< some tie has thickness or tether
    bool prefetch;                   ///< the records do not fit into the cache
};

struct StepTask {
    const VectorLanes* force;
    VectorLanes* last_force;
    VectorLanes* velocity;
    const ScalarLanes* mass;  ///< 0 where fixed
    const NodeRecord* from;
    NodeRecord* to;
    float keep, push;  ///< v' = keep v + push F/m
    float longest;     ///< no node goes further in one step [mm]
};
struct StepSums {
    double residual, curvature, kinetic;
    double wanted;  ///< the longest step squared, had it been taken [mm²]
};

/// The kernels of one instruction set. Slices [begin, end).
struct LaneKernels {
    const char* name;
    /// Elastic forces around rest; records hold rest and way.
    void (*forces)(const ForceTask& task, int begin, int end, VectorLanes* out);
    /// The same. @return energy [µJ]
    double (*forces_and_energy)(const ForceTask& task, int begin, int end, VectorLanes* out);
    /// All forces in motion, dampers included; records hold position and velocity.
    void (*damped_forces)(const ForceTask& task, int begin, int end, VectorLanes* out);
    /// Gershgorin row sums Σ|K_ij| at the records' state, ties included.
    void (*row_sums)(const ForceTask& task, int begin, int end, ScalarLanes* out);
    /// One damped step of all free nodes.
    StepSums (*step)(const StepTask& task, int begin, int end);
};
const LaneKernels& portable_kernels();
const LaneKernels& avx2_kernels();  ///< only where the processor has AVX2

}  // namespace myoface
