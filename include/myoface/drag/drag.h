// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "myoface/base/view_ray.h"
#include "myoface/drag/stress_kernel.h"
#include "myoface/physics/build_mass_spring.h"
#include "myoface/physics/equilibrium.h"

namespace myoface {

enum class DragMode { MousePriority, ConstraintPriority };

/// Where a hand may go: anywhere, in and out along the skin's normal at the grip, or up, down,
/// forward and back in the plane of the grip that is parallel to the midplane.
enum class DragPath { Free, Normal, Midplane };

/// Where a hand grips and how.
struct DragRequest {
    SurfacePoint where;  ///< on FaceModel::skin
    DragMode mode = DragMode::MousePriority;
    double radius = 0.0;    ///< of the kernel [mm]; 0: by region (mouse), 12 (constraint)
    bool mirrored = false;  ///< the same on the other side of the face
    DragPath path = DragPath::Free;
    double force_mN =
        0.0;  ///< judging: pulls so hard towards the ray, however near; 0: as the hand
};

/// What became of a drag.
struct DragReport {
    DragMode mode = DragMode::MousePriority;
    int node = -1;                     ///< skin node nearest to the grabbed point
    Vec3 target = Vec3::Zero();        ///< on the ray, at the point's depth [mm]
    Vec3 reached = Vec3::Zero();       ///< [mm]
    double off_ray_mm = 0.0;           ///< distance of the point from the ray
    double view_force_residual = 0.0;  ///< force along the ray left, as a share of before
    double force_mN = 0.0;             ///< of the hand
    double stage_skin_mN = 0.0;        ///< consumed by the skin
    double stage_muscle_mN = 0.0;      ///< consumed by the muscle layer
    double refused_mN = 0.0;           ///< held back
    double kept_share = 1.0;           ///< of a shape that was to stay; less where skin would fold
    double strain_share = 0.0;         ///< largest strain near the grip, of its region's limit
};

/// Eqs. (4)-(6) with normalised gain: how far a node goes along the view so that its springs' force
/// loses its part along the view,
///   A = Σ_j k_ij (1 − L_ij/|r_ij|) r_ij · gain / Σ_j k_ij,   A_p = (A·v)/(v·v) v,   R ← R − A_p.
/// ΔT² of the paper is replaced by gain / Σk, else the step diverges for stiff springs. One step of
/// a fixed point: only together with relaxation of the neighbours does it end at the right depth.
/// @return −A_p [mm]
/// @cite matsuda_muscle_spring, Eqs. (4)-(6)
Vec3 depth_correction(const MassSpringModel& model, const Points& positions, int node,
                      const Vec3& view, double gain = 1.0);

/// One hand on the skin, in either mode, from grip to release. In mouse priority the point follows
/// the ray as long as a hand of 100 N can hold it there; what bone or tissue refuses beyond that is
/// left as a gap, in `off_ray_mm`. Works on a state that somebody else
/// owns; update() may be called many times a second with a small budget, or once to the end.
class SkinDrag {
public:
    /// @param start positions at the grip (equilibrium)
    /// @param yielding per skin node 1 … 0: how far it may be gripped; or nothing: all of it
    SkinDrag(const FaceModel& face, const FaceMassSpring& system, const DragRequest& request,
             const ViewRay& ray, const Points& start, const Eigen::VectorXd& yielding = {});

    /// The mouse went there: the grabbed point is wanted on this ray.
    void move_to(const ViewRay& ray);

    /// Relaxes with at most `iterations` sweeps. @return whether all came to rest
    RelaxReport update(EquilibriumSolver& solver, MassSpringState& state, const Drive& drive,
                       int iterations);
    /// Until at rest: for scripts, and when a gesture ends. A face pulled far may rest in more than
    /// one shape, and which it meets depends on its way there: so it goes anew, straight from the
    /// grip to the ray, and what becomes of a gesture depends on nothing but its ends.
    /// @param anew false: on from where it is, which is quicker from a place nearby
    RelaxReport settle(EquilibriumSolver& solver, MassSpringState& state, const Drive& drive,
                       double still_mm = RelaxOptions{}.still_mm, bool anew = true);

    /// @param with_forces also the force along the view, which takes two passes over the model
    DragReport report(const MassSpringState& state, const Drive& drive, bool with_forces) const;
    const DragRequest& request() const { return request_; }
    const StressKernel& kernel() const { return hands_.front().kernel; }

private:
    /// What is known of how the grabbed point follows the target of its handle, in the view plane.
    struct TargetSearch {
        bool begun = false;
        Eigen::Vector2d error = Eigen::Vector2d::Zero(), move = Eigen::Vector2d::Zero();
        Eigen::Matrix2d gain = Eigen::Matrix2d::Identity();
    };
    /// One grip; a mirrored drag has two.
    struct Hand {
        Grip grip;
        StressKernel kernel;        ///< on the skin
        StressKernel layer_kernel;  ///< on the muscle layer: wider, keener on labels
        Points bulge;               ///< judging only: counter_bulge() of the kernel
        ViewRay ray;
        Vec3 start = Vec3::Zero();
        Vec3 normal = Vec3::UnitZ();  ///< of the skin, smoothed
        double peak = 1.0;            ///< the kernel's profile at the grabbed point
        Eigen::Vector2d target = Eigen::Vector2d::Zero();  ///< of the handle, in the view plane
        /// What a hand that would have to pull harder than its bound stays behind by, in the plane.
        Eigen::Vector2d behind = Eigen::Vector2d::Zero();
        TargetSearch search;
        Vec3 force = Vec3::Zero();       ///< of the hand, last seen
        Vec3 skin_force = Vec3::Zero();  ///< of stage 1, kept during stage 2
        std::vector<int> near_springs;   ///< within two radii: where strain is watched
    };

    Hand make_hand(const SurfacePoint& where, const ViewRay& ray) const;
    void add_mirrored_hand();
    ViewRay mirrored(const ViewRay& ray) const;
    std::vector<Handle> handles() const;
    Mat3 spread(const Hand& hand, std::size_t k) const;
    std::vector<HandPull> pulls() const;
    Drive with_first_stage(const Drive& drive) const;
    ViewRay guided(const Hand& hand, const ViewRay& ray) const;
    void back_to_grip(EquilibriumSolver& solver, MassSpringState& state);
    Vec3 kernel_centre(const Hand& hand) const;
    double step_towards_ray(MassSpringState& state);
    double put_on_ray(MassSpringState& state);
    void take_forces(const EquilibriumSolver& solver);
    void correct_targets(const Points& positions);
    static Eigen::Vector2d way_to_goal(const Hand& hand, const Vec3& at);
    bool yield_to_force(bool may_follow);
    double furthest_from_goal(const Points& positions) const;
    double strain_share(const Points& positions) const;
    RelaxReport pull(EquilibriumSolver& solver, MassSpringState& state, const Drive& drive,
                     int iterations, double still_mm);
    RelaxReport search_share(EquilibriumSolver& solver, MassSpringState& state, const Drive& drive,
                             double& share, double most, double limit);
    void enter_second_stage(EquilibriumSolver& solver, MassSpringState& state);

    const FaceModel& face_;
    const FaceMassSpring& system_;
    DragRequest request_;
    Points start_;
    Eigen::VectorXd yielding_;
    std::vector<Hand> hands_;
    double skin_share_ = 1.0;   ///< λ
    double layer_share_ = 0.0;  ///< μ
    bool second_stage_ = false;
};

}  // namespace myoface
