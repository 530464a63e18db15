// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "myoface/drag/drag.h"
#include "myoface/muscle/contraction.h"
#include "myoface/muscle/wrinkle.h"
#include "myoface/physics/implicit_motion.h"

namespace myoface {

enum class SolverKind { Equilibrium, SymplecticEuler, ExplicitEuler };
std::string solver_name(SolverKind kind);

struct SimulatorOptions {
    SolverKind solver = SolverKind::Equilibrium;
    ResponseForm response = ResponseForm::Smooth;
    TissueConstants tissue;
    bool levels = true;  ///< coarser levels help the equilibrium solver
};

/// What a step did. Unwelcome outcomes are fields, not exceptions.
struct StepReport {
    std::string solver;
    int iterations = 0;
    double residual = 0.0;  ///< rms out-of-balance force per node [mN]
    bool converged = false;
    bool finite = true;  ///< false: the step was undone
    double milliseconds = 0.0;
    double max_displacement_mm = 0.0;
    double max_strain = 0.0;  ///< of the skin's links, where a limit is known
    std::optional<DragReport> drag;
};

/// Triangles of the visible skin that face the other way than before: skin folded over itself.
/// @param before, after 3×nodes, the skin's first [mm]
int turned_over(const FaceModel& face, const Points& before, const Points& after);

/// One face in motion, headless. Not thread-safe: one thread owns it.
class Simulator {
public:
    explicit Simulator(std::shared_ptr<const FaceModel> face, const SimulatorOptions& options = {});
    ~Simulator();
    Simulator(const Simulator&) = delete;
    Simulator& operator=(const Simulator&) = delete;

    std::shared_ptr<const FaceModel> shared_face() const { return face_; }
    const FaceModel& face() const { return *face_; }
    const FaceMassSpring& system() const { return *system_; }
    const MassSpringState& state() const { return state_; }

    /// @param rate −0.5 … 1. @throws InvalidInput when out of range or not finite
    void set_contraction(int muscle, double rate);
    /// All of them at once, in the atlas' order. @throws InvalidInput
    void set_contractions(const std::vector<double>& rates);
    /// @param strength 0 … 1. @throws InvalidInput
    void set_strength(int muscle, double strength);
    const Contractions& contractions() const { return contractions_; }
    /// Another form of the linear muscles' response.
    void set_response(ResponseForm form);
    ResponseForm response() const { return options_.response; }

    /// How old the skin is that wrinkles, in years. @throws InvalidInput when out of range
    void set_skin_age(double years);
    double skin_age() const { return skin_age_; }
    /// The wrinkles of this moment; none while every muscle rests.
    Wrinkles wrinkles() const;

    /// The skin as it rests: the scan plus what was shaped, 3×skin nodes [mm].
    const Points& skin_rest() const { return skin_rest_; }
    /// Reshapes the resting skin (undo, redo, a case). Ends a drag. @throws InvalidInput
    void set_skin_rest(const Points& skin_rest);

    /// Outer forces on the skin, 3×skin nodes [mN], or 3×0: none.
    void set_load(const Points& load);
    /// Takes what moved since `before` over as the shape that rests, as far as it folds no skin
    /// over itself. @param before 3×nodes [mm] @return the share that stays
    double keep_shape(const Points& before);

    /// What gestures leave alone: 0 … 1 per skin node, or nothing. Ends a drag.
    /// @throws InvalidInput when it belongs to another face
    void set_protection(const Eigen::VectorXd& share);
    const Eigen::VectorXd& protection() const { return protection_; }

    /// Starts a gesture. @throws InvalidInput when the point does not move
    void begin_drag(const DragRequest& request, const ViewRay& ray);
    void move_drag(const ViewRay& ray);
    /// Ends it: the shape stays when `keep` is set, as far as it folds no skin over itself, else
    /// the face springs back. Shaping keeps, judging springs back unless somebody wants it.
    /// @return the report of the gesture
    DragReport end_drag(bool keep);
    bool dragging() const { return drag_ != nullptr; }
    /// The stress kernel of the hand, while dragging.
    const StressKernel* drag_kernel() const;

    /// Live: step() goes on by one frame in time, in which tissue swings and settles, instead of
    /// going to rest as quickly as it can. Needs the equilibrium solver.
    /// @param pace of time: 1 as it is, 0.1 ten times slower; 0, as at first: not live
    void set_live(double pace);
    bool live() const { return motion_ != nullptr; }

    /// A bounded piece of work towards rest, for one frame.
    StepReport step(int iterations);
    /// Until at rest. @param still_mm a step below this counts as rest [mm]
    /// @param anew a hand's way from its grip again. @see SkinDrag::settle()
    StepReport settle(double still_mm = RelaxOptions{}.still_mm, bool anew = true);
    /// Lets so much time go by, as live motion. @param seconds > 0
    StepReport live_on(double seconds);

    /// 3×N of the scan with its wrinkles [mm]: exactly the scan where nothing moved.
    Points scan_vertices() const;
    /// FNV-1a over the bits of all node positions.
    std::uint64_t state_hash() const;

private:
    void rebuild();
    void hold_protected();
    void refresh_drive();
    RelaxReport relax(int iterations);
    RelaxReport relax_in_time(int iterations);
    void stop_motion();
    StepReport integrate(bool to_rest, int steps);
    bool snap_to_rest();
    void fill_motion(StepReport& report) const;

    std::shared_ptr<const FaceModel> face_;
    SimulatorOptions options_;
    Points skin_rest_;
    std::unique_ptr<FaceMassSpring> system_;
    std::shared_ptr<const CoarseFace> coarser_face_;
    std::unique_ptr<CoarseLevel> coarser_;
    std::unique_ptr<EquilibriumSolver> solver_;
    std::vector<MuscleResponse> responses_;
    double skin_age_ = kUsualSkin;
    mutable std::shared_ptr<const WrinkleMap> wrinkle_map_;  ///< made when it is first needed
    Contractions contractions_;
    Drive drive_;
    MassSpringState state_;
    std::unique_ptr<SkinDrag> drag_;
    Points before_drag_;
    Points load_;
    Eigen::VectorXd protection_;
    double time_step_ = 0.0;
    std::unique_ptr<ImplicitMotion> motion_;  ///< null: not live
    double pace_ = 0.0;
    bool timed_ = false;   ///< the solver knows of inertia
    bool swings_ = false;  ///< else live tissue has calmed down
};

/// Time that one step() of live motion takes at pace 1 [s].
inline constexpr double kLiveFrame = 1.0 / 60.0;

/// Gravity on a patient who sits upright [mm/s²]; scans are taken so.
inline const Vec3 kUprightGravity{0.0, -9810.0, 0.0};

}  // namespace myoface
