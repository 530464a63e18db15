// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "myoface/face/obstacle.h"
#include "myoface/face/tissue.h"

namespace myoface {

/// Spring and damper in parallel between two mass points.
struct Spring {
    int a = 0, b = 0;
    double stiffness = 0.0;  ///< k [kg/s² = N/m = mN/mm]
    double length = 0.0;     ///< natural length L [mm]
    double damping = 0.0;    ///< D [kg/s]
    TissueLabel label;
};

/// How a tissue resists being stretched far. A spring has the smaller values of its two ends.
struct Stretch {
    double stiffening = 0.0;  ///< J: adds k L² J max(|ε| − 0.2, 0)³/3 to the energy
    double limit =
        1e3;  ///< ε_l: adds ½ k L² 15 max(ε − ε_l, 0)²; skin pressed together folds instead
};

/// A spring as one of its ends sees it, packed for gathering.
struct SpringEnd {
    int other = 0;
    int spring = 0;
    double stiffness = 0.0, length = 0.0;
};

/// A point's tie to what lies under it. With δ = x − rest:
/// thickness ½ k_n (n·δ + ½ δᵀQδ − height)² and tether ½ k_t |(I − nnᵀ)(δ − shift − layer)|²,
/// plus an isotropic anchor ½ k_i |δ|². It slides along the bone: no depth force sideways. Where
/// the tissue is used up the bone stops it: ½ · 20 k_n min(0, n·δ + ½ δᵀQδ + stop)².
struct Tie {
    Vec3 normal = Vec3::UnitZ();
    Mat3 curvature = Mat3::Zero();  ///< [1/mm]
    double thickness = 0.0;         ///< k_n [mN/mm]
    double tether = 0.0;            ///< k_t [mN/mm]
    double anchor = 0.0;            ///< k_i [mN/mm]
    double damping = 0.0;           ///< towards the bone [kg/s]
    double stop = 1e3;              ///< how far the skin may go in before the bone stops it [mm]
};

/// Two points that must not pass each other: ½ k min(0, n·(x_a − x_b) − gap)².
struct Contact {
    int a = 0, b = 0;
    Vec3 normal = Vec3::UnitY();  ///< from b to a
    double stiffness = 0.0;       ///< [mN/mm]
    double gap = 0.0;             ///< at most 0: how far they overlap at rest [mm]
};

/// How a node keeps out of the obstacles: ½ k Σ_o min(0, φ_o(x) − margin_o)², φ_o the signed
/// distance from obstacle o.
struct Barriers {
    std::vector<double> stiffness;  ///< k per node [mN/mm]; 0: nothing stops it
    std::vector<double> clear;      ///< per node: a way from rest on which it meets none [mm]
    Eigen::MatrixXd margin;  ///< obstacles × nodes [mm]; no larger than the distance at rest
};

/// Symmetric scalar matrix in compressed rows that acts alike on the three components of the
/// displacement: hinge bending and muscle attachments. Zero at rest, linear.
struct LinearStiffness {
    std::vector<int> start{0}, column;
    std::vector<double> value;  ///< [mN/mm]
};

/// The muscle layer under the skin, of which constraint priority makes use: one displacement y per
/// skin node, ½ k_t |y|² to the bone and ½ k |y_i − y_j|² along the skin's edges.
struct MuscleLayer {
    LinearStiffness links;
};

/// Masses and springs of one face. Built once; never changes while it runs. Nodes: the skin's, then
/// those of the muscles' chains. Units: mm, kg, s; force is then mN.
struct MassSpringModel {
    Points rest;                     ///< 3×N, where no force acts
    Eigen::VectorXd mass;            ///< [kg]: density × volume × tie to the bone
    std::vector<char> fixed;         ///< bone ends and what lies far from the face
    std::vector<TissueLabel> label;  ///< per node
    std::vector<Spring> springs;
    std::vector<Stretch> stretch;  ///< per node
    std::vector<Tie> ties;         ///< per node
    std::vector<Contact> contacts;
    std::vector<Obstacle> obstacles;
    Barriers barriers;  ///< empty where there are no obstacles
    LinearStiffness linear;
    MuscleLayer layer;
    Vec3 rest_gravity = Vec3::Zero();  ///< gravity under which `rest` was scanned [mm/s²]
    int skin_nodes = 0;

    // Rows for gathering, filled by index_rows().
    std::vector<int> spring_start;
    std::vector<SpringEnd> spring_ends;
    std::vector<int> contact_of;  ///< per node, -1 none

    int node_count() const { return static_cast<int>(rest.cols()); }
};

/// Fills the rows that gathering needs. Call after nodes or springs were set.
void index_rows(MassSpringModel& model);

/// Checks sizes, ranges, signs and finiteness. @throws InvalidInput naming the first fault
void validate(const MassSpringModel& model);

/// What changes while the model runs.
struct MassSpringState {
    Points positions;   ///< 3×N [mm]
    Points velocities;  ///< 3×N [mm/s]
    Points layer;       ///< 3×skin nodes displacement of the muscle layer [mm], or 3×0: at rest
};
MassSpringState rest_state(const MassSpringModel& model);

/// Inputs of a step: contraction and gravity act through these, the model stays.
struct Drive {
    Points shift;  ///< 3×N tether target [mm], or 3×0
    /// 3×N way of the bone or eyeball under a node [mm], or 3×0: its ties go along.
    Points carry;
    Eigen::VectorXd height;                ///< N thickness target [mm], or 0
    Eigen::VectorXd tether_boost;          ///< N factor on k_t, or 0
    std::vector<double> length_factor;     ///< per spring factor on L, or empty
    std::vector<double> stiffness_factor;  ///< per spring factor on k, or empty
    Points load;                           ///< 3×N outer force [mN], or 3×0
    /// Of a step in time: ½ inertia |x − rest − ahead|², less what no motion changes.
    Eigen::VectorXd inertia;      ///< N [mN/mm], or 0
    Points ahead;                 ///< 3×N [mm], goes with inertia
    Points layer_load;            ///< 3×skin outer force on the muscle layer, or 3×0
    Vec3 gravity = Vec3::Zero();  ///< [mm/s²]
    std::vector<Eigen::Isometry3d> obstacle_pose;  ///< per obstacle, or empty: where they rest
};

}  // namespace myoface
