// SPDX-License-Identifier: Apache-2.0
#include "myoface/sim/simulator.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

#include "myoface/base/error.h"
#include "myoface/io/mesh_file.h"
#include "myoface/physics/euler.h"
#include "myoface/physics/forces.h"
#include "myoface/sim/snapshot.h"

namespace myoface {
namespace {

constexpr double kStillOnScreen = 2e-5;  // a step below this is seen as rest [mm]
constexpr int kMostSettleSteps = 12000;
constexpr int kMostTimeSteps = 400000;
constexpr double kCloseEnough = 0.02;   // [mm]
constexpr int kLiveSteps = 2;           // of a frame in time
constexpr double kCalm = 1.0;           // [mm/s] from here on live tissue goes straight to rest
constexpr double kProtection = 2000.0;  // of skin that is to stay [mN/mm per mm²]
constexpr double kStillSpeed = 0.02;    // a tissue slower than this is at rest [mm/s]

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

}  // namespace

std::string solver_name(SolverKind kind) {
    switch (kind) {
        case SolverKind::SymplecticEuler:
            return "symplectic";
        case SolverKind::ExplicitEuler:
            return "explicit";
        default:
            return "equilibrium";
    }
}

int turned_over(const FaceModel& face, const Points& before, const Points& after) {
    const Triangles& triangles = face.skin.mesh.triangles;
    const auto area = [&](const Points& at, Eigen::Index t) {
        const Vec3 a = at.col(triangles(0, t));
        return Vec3((at.col(triangles(1, t)) - a).cross(at.col(triangles(2, t)) - a));
    };
    int count = 0;
    for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
        const bool visible = face.tissue[triangles(0, t)].tissue == Tissue::Skin &&
                             face.tissue[triangles(1, t)].tissue == Tissue::Skin &&
                             face.tissue[triangles(2, t)].tissue == Tissue::Skin;
        count += visible && area(before, t).dot(area(after, t)) < 0.0;
    }
    return count;
}

Simulator::Simulator(std::shared_ptr<const FaceModel> face, const SimulatorOptions& options)
    : face_(std::move(face)),
      options_(options),
      skin_rest_(face_->skin.mesh.vertices),
      coarser_face_(options.levels ? coarser_levels(*face_) : nullptr),
      contractions_(resting(*face_)) {
    rebuild();
    responses_ = muscle_responses(*face_, system_->model, options_.response);
    state_ = rest_state(system_->model);
    refresh_drive();
}

Simulator::~Simulator() = default;

/// A new model on the present rest; the state is left alone.
void Simulator::rebuild() {
    drag_.reset();
    solver_.reset();
    system_ =
        std::make_unique<FaceMassSpring>(build_mass_spring(*face_, skin_rest_, options_.tissue));
    system_->model.rest_gravity = kUprightGravity;
    validate(system_->model);
    if (coarser_face_) {
        coarser_ =
            std::make_unique<CoarseLevel>(coarser_face_, *system_, skin_rest_, options_.tissue);
    }
    solver_ = std::make_unique<EquilibriumSolver>(system_->model, coarser_.get());
    time_step_ = 0.0;
    if (motion_) {
        motion_ = std::make_unique<ImplicitMotion>(system_->model);
    }
}

void Simulator::set_response(ResponseForm form) {
    if (form != options_.response) {
        options_.response = form;
        responses_ = muscle_responses(*face_, system_->model, form);
        refresh_drive();
    }
}

void Simulator::refresh_drive() {
    const Points before = std::move(drive_.carry);
    const int n = system_->model.node_count();
    drive_ = contraction_drive(*system_, responses_, contractions_);
    drive_.gravity = kUprightGravity;
    drive_.obstacle_pose = obstacle_poses(*face_, jaw_pose(*face_, contractions_));
    solver_->drive_changed();
    timed_ = false;
    // What is carried starts from where it is carried to: relaxation has the rest to do only.
    constexpr double kJump = 0.5;  // [mm] that momentum does not survive
    const double way = drive_.carry.cols() == 0 ? (before.cols() > 0 ? 1.0 : 0.0)
                       : before.cols() == 0     ? drive_.carry.cwiseAbs().maxCoeff()
                                                : (drive_.carry - before).cwiseAbs().maxCoeff();
    if (way > kJump) {
        solver_->restart();
    }
    Points jump = Points::Zero(3, before.cols() + drive_.carry.cols() > 0 ? n : 0);
    if (before.cols() > 0) {
        jump -= before;
    }
    if (drive_.carry.cols() > 0) {
        jump += drive_.carry;
    }
    if (jump.cols() > 0) {
        state_.positions += jump;
        if (motion_) {
            motion_->shift(jump);
        }
    }
    swings_ = live();
    if (load_.cols() > 0) {
        drive_.load = Points::Zero(3, n);
        drive_.load.leftCols(load_.cols()) = load_;
    }
    hold_protected();
    for (int i = 0; i < n; ++i) {
        if (system_->model.fixed[i] != 0) {  // back to the same bits
            state_.positions.col(i) = system_->model.rest.col(i);
            if (drive_.carry.cols() > 0) {
                state_.positions.col(i) += drive_.carry.col(i);
            }
        }
    }
}

void Simulator::set_contraction(int muscle, double rate) {
    std::vector<double> rates = contractions_.rate;
    rates[static_cast<std::size_t>(muscle)] = rate;
    set_contractions(rates);
}

void Simulator::set_contractions(const std::vector<double>& rates) {
    if (rates.size() != face_->muscles.size()) {
        throw InvalidInput("The contractions to set belong to another atlas of muscles.");
    }
    for (std::size_t m = 0; m < rates.size(); ++m) {
        if (!std::isfinite(rates[m]) || rates[m] < kLeastContraction ||
            rates[m] > kMostContraction) {
            throw InvalidInput("The contraction of " + face_->muscles[m].traits.name +
                               " must lie between -0.5 and 1.");
        }
    }
    contractions_.rate = rates;
    refresh_drive();
}

void Simulator::set_strength(int muscle, double strength) {
    if (!std::isfinite(strength) || strength < 0.0 || strength > 1.0) {
        throw InvalidInput("The strength of " + face_->muscles[muscle].traits.name +
                           " must lie between 0 and 1.");
    }
    contractions_.strength[muscle] = strength;
    refresh_drive();
}

void Simulator::set_skin_age(double years) {
    if (!std::isfinite(years) || years < kYoungestSkin || years > kOldestSkin) {
        throw InvalidInput("The skin's age must lie between 18 and 80 years.");
    }
    skin_age_ = years;
}

Wrinkles Simulator::wrinkles() const {
    const Eigen::VectorXd drive = furrow_drive(*face_, contractions_);
    if (drive.isZero(0.0)) {
        return {wrinkle_map_, {}};
    }
    if (!wrinkle_map_) {
        wrinkle_map_ = map_wrinkles(*face_);
    }
    return {wrinkle_map_,
            furrow_depths(*wrinkle_map_, shortening(*wrinkle_map_, skin_rest_, state_.positions),
                          drive, skin_age_)};
}

void Simulator::set_skin_rest(const Points& skin_rest) {
    if (skin_rest.cols() != face_->node_count() || !skin_rest.allFinite()) {
        throw InvalidInput("The shape to set does not belong to this face.");
    }
    // Muscles in action stay in action: carry the present displacement over.
    const Points displacement = state_.positions - system_->model.rest;
    skin_rest_ = skin_rest;
    rebuild();
    state_.positions = system_->model.rest + displacement;
    state_.velocities.setZero();
    state_.layer.resize(3, 0);
    refresh_drive();
}

void Simulator::begin_drag(const DragRequest& request, const ViewRay& ray) {
    const Grip grip = grip_at(*face_, request.where);
    const bool moves = std::any_of(grip.nodes.begin(), grip.nodes.end(),
                                   [&](int i) { return system_->model.fixed[i] == 0; });
    if (!moves) {
        throw InvalidInput("This part of the scan does not move: grip the face itself.");
    }
    before_drag_ = state_.positions;
    Eigen::VectorXd yielding;
    if (protection_.size() > 0) {
        double held = 0.0;
        for (std::size_t k = 0; k < grip.nodes.size(); ++k) {
            held += grip.weights[k] * protection_[grip.nodes[k]];
        }
        if (held > 0.9) {
            throw InvalidInput("This part of the face is protected: grip beside it.");
        }
        yielding = 1.0 - protection_.array();
    }
    drag_ = std::make_unique<SkinDrag>(*face_, *system_, request, ray, state_.positions, yielding);
    swings_ = live();
    hold_protected();
    solver_->drive_changed();
}

void Simulator::move_drag(const ViewRay& ray) {
    if (drag_) {
        drag_->move_to(ray);
        swings_ = live();
    }
}

const StressKernel* Simulator::drag_kernel() const {
    return drag_ ? &drag_->kernel() : nullptr;
}

DragReport Simulator::end_drag(bool keep) {
    if (!drag_) {
        return {};
    }
    DragReport report = drag_->report(state_, drive_, true);
    if (keep) {
        report.kept_share = keep_shape(before_drag_);
        return report;
    }
    drag_.reset();
    solver_->restart();
    state_.layer.resize(3, 0);
    refresh_drive();
    return report;
}

double Simulator::keep_shape(const Points& before) {
    constexpr double kLess = 0.1;
    const Points moved = state_.positions - before;
    const Points& scan = face_->skin.mesh.vertices;
    const int already = turned_over(*face_, scan, skin_rest_);
    double share = 1.0;
    while (share > 0.0 &&
           turned_over(*face_, scan, skin_rest_ + share * moved.leftCols(face_->node_count())) >
               already) {
        share = std::max(0.0, share - kLess);
    }
    skin_rest_ += share * moved.leftCols(face_->node_count());
    const Points shown = before + share * moved;
    rebuild();
    state_.positions = shown;
    // The chains follow the reshaped skin; what is left of their motion is contraction.
    const Eigen::Index chains = shown.cols() - face_->node_count();
    state_.positions.rightCols(chains) = before.rightCols(chains);
    state_.layer.resize(3, 0);
    refresh_drive();
    return share;
}

void Simulator::set_load(const Points& load) {
    load_ = load;
    refresh_drive();
}

void Simulator::set_protection(const Eigen::VectorXd& share) {
    if (share.size() != 0 && share.size() != face_->node_count()) {
        throw InvalidInput("What is to be protected does not belong to this face.");
    }
    if (drag_) {
        end_drag(false);
    }
    const bool any = share.size() > 0 && share.maxCoeff() > 0.0;
    protection_ = any ? Eigen::VectorXd(share.cwiseMax(0.0).cwiseMin(1.0)) : Eigen::VectorXd();
    refresh_drive();
}

/// While a hand is at the face, protected skin stays where it was when the hand came.
void Simulator::hold_protected() {
    if (!drag_ || protection_.size() == 0) {
        return;
    }
    if (drive_.inertia.size() == 0) {
        drive_.inertia = Eigen::VectorXd::Zero(system_->model.node_count());
        drive_.ahead = Points::Zero(3, system_->model.node_count());
    }
    for (int i = 0; i < face_->node_count(); ++i) {
        if (protection_[i] > 0.0) {
            const double hold = kProtection * protection_[i] * face_->area[i];
            const double sum = drive_.inertia[i] + hold;
            drive_.ahead.col(i) = (drive_.inertia[i] * drive_.ahead.col(i) +
                                   hold * (before_drag_.col(i) - system_->model.rest.col(i))) /
                                  std::max(sum, 1e-12);
            drive_.inertia[i] = sum;
        }
    }
}

StepReport Simulator::step(int iterations) {
    const auto start = std::chrono::steady_clock::now();
    StepReport report;
    if (options_.solver != SolverKind::Equilibrium && !drag_) {
        report = integrate(false, iterations);
    } else {
        const RelaxReport relaxed = swings_ ? relax_in_time(iterations) : relax(iterations);
        if (drag_) {
            report.drag = drag_->report(state_, drive_, false);
        }
        report.iterations = relaxed.iterations;
        report.residual = relaxed.residual;
        report.converged = relaxed.converged;
        report.finite = relaxed.finite;
        report.converged = snap_to_rest() || report.converged;
    }
    report.solver = solver_name(options_.solver);
    fill_motion(report);
    report.milliseconds = milliseconds_since(start);
    return report;
}

StepReport Simulator::settle(double still_mm, bool anew) {
    const auto start = std::chrono::steady_clock::now();
    stop_motion();
    StepReport report;
    if (options_.solver != SolverKind::Equilibrium && !drag_) {
        report = integrate(true, kMostTimeSteps);
    } else {
        RelaxReport relaxed;
        if (drag_) {
            relaxed = drag_->settle(*solver_, state_, drive_, still_mm, anew);
            report.drag = drag_->report(state_, drive_, true);
        } else {
            RelaxOptions options;
            options.iterations = kMostSettleSteps;
            options.still_mm = still_mm;
            relaxed = solver_->relax(state_, drive_, options);
        }
        report.iterations = relaxed.iterations;
        report.residual = relaxed.residual;
        report.converged = relaxed.converged;
        report.finite = relaxed.finite;
        report.converged = snap_to_rest() || report.converged;
    }
    report.solver = solver_name(options_.solver);
    fill_motion(report);
    report.milliseconds = milliseconds_since(start);
    return report;
}

void Simulator::set_live(double pace) {
    pace_ = pace;
    if (live() != (pace > 0.0)) {
        stop_motion();
        motion_ = pace > 0.0 ? std::make_unique<ImplicitMotion>(system_->model) : nullptr;
        swings_ = live();
    }
}

/// One call of the solver, in the hand or without.
RelaxReport Simulator::relax(int iterations) {
    if (drag_) {
        return drag_->update(*solver_, state_, drive_, iterations);
    }
    RelaxOptions options;
    options.iterations = iterations;
    options.still_mm = kStillOnScreen;
    return solver_->relax(state_, drive_, options);
}

RelaxReport Simulator::relax_in_time(int iterations) {
    RelaxReport report;
    for (int k = 0; k < kLiveSteps; ++k) {
        motion_->begin(state_, pace_ * kLiveFrame / kLiveSteps, drive_);
        hold_protected();
        timed_ ? solver_->loads_changed() : solver_->drive_changed();
        timed_ = true;
        const RelaxReport step = relax(std::max(1, iterations / kLiveSteps));
        motion_->end(state_);
        report.iterations += step.iterations;
        report.residual = step.residual;
        report.finite = step.finite;
        if (!step.finite) {
            state_.velocities.setZero();
            motion_->restart();
            break;
        }
    }
    if (state_.velocities.colwise().squaredNorm().maxCoeff() < kCalm * kCalm) {
        stop_motion();
    }
    return report;
}

/// From here on it goes to rest without regard to time.
void Simulator::stop_motion() {
    swings_ = false;
    state_.velocities.setZero();
    if (motion_) {
        motion_->restart();
    }
    if (timed_) {
        timed_ = false;
        drive_.inertia.resize(0);
        drive_.ahead.resize(3, 0);
        hold_protected();
        solver_->drive_changed();
    }
}

StepReport Simulator::live_on(double seconds) {
    constexpr int kSweeps = 60;
    const double before = pace_;
    set_live(1.0);
    StepReport report;
    int iterations = 0;
    for (int frame = 0; frame < std::max(1L, std::lround(seconds / kLiveFrame)); ++frame) {
        report = step(kSweeps);
        iterations += report.iterations;
    }
    report.iterations = iterations;
    set_live(before);
    return report;
}

/// Where nothing acts, the rest is an equilibrium, known exactly: what has come close to it has
/// arrived. @return whether it has
bool Simulator::snap_to_rest() {
    const auto nothing = [](double rate) { return rate == 0.0; };
    if (drag_ || swings_ ||
        !std::all_of(contractions_.rate.begin(), contractions_.rate.end(), nothing)) {
        return false;
    }
    const Points left = state_.positions - system_->model.rest;
    if (left.colwise().squaredNorm().maxCoeff() < kCloseEnough * kCloseEnough) {
        state_.positions = system_->model.rest;
        solver_->restart();
        return true;
    }
    return false;
}

StepReport Simulator::integrate(bool to_rest, int steps) {
    const bool is_explicit = options_.solver == SolverKind::ExplicitEuler;
    if (time_step_ == 0.0) {
        time_step_ = stable_time_step(
            system_->model, is_explicit ? Integrator::ExplicitEuler : Integrator::SymplecticEuler);
    }
    StepReport report;
    const MassSpringState good = state_;
    for (int k = 0; k < steps; ++k) {
        if (is_explicit) {
            explicit_euler_step(system_->model, state_, drive_, time_step_);
        } else {
            symplectic_euler_step(system_->model, state_, drive_, time_step_);
        }
        ++report.iterations;
        if (k % 100 != 99) {
            continue;
        }
        const double fastest = state_.velocities.cwiseAbs().maxCoeff();
        if (!(fastest < 1e7)) {
            state_ = good;
            report.finite = false;
            break;
        }
        if (to_rest && fastest < kStillSpeed) {
            const Points forces = total_forces(system_->model, state_, drive_, false);
            report.converged = true;
            report.residual = std::sqrt(forces.squaredNorm() / forces.cols());
            break;
        }
    }
    return report;
}

void Simulator::fill_motion(StepReport& report) const {
    const int n = face_->node_count();
    const Points moved = state_.positions.leftCols(n) - face_->skin.mesh.vertices;
    report.max_displacement_mm = std::sqrt(moved.colwise().squaredNorm().maxCoeff());
    for (const Spring& spring : system_->model.springs) {
        if (spring.a >= n || spring.b >= n ||
            std::min(system_->strain_limit[spring.a], system_->strain_limit[spring.b]) > 1e6) {
            continue;
        }
        const double distance =
            (state_.positions.col(spring.a) - state_.positions.col(spring.b)).norm();
        report.max_strain = std::max(report.max_strain, std::abs(distance / spring.length - 1.0));
    }
}

SimSnapshot snapshot_of(const Simulator& simulator) {
    SimSnapshot snapshot;
    snapshot.positions = simulator.state().positions;
    snapshot.rates = simulator.contractions().rate;
    snapshot.jaw = jaw_pose(simulator.face(), simulator.contractions());
    snapshot.wrinkles = simulator.wrinkles();
    snapshot.dragging = simulator.dragging();
    return snapshot;
}

Points scan_positions(const FaceModel& face, const Points& node_positions, const JawPose& jaw,
                      const Wrinkles& wrinkles) {
    Points result = follow(face.skin, *face.adjacency, face.scan->mesh.vertices, node_positions);
    add_wrinkles(face, wrinkles, node_positions, result);
    for (const int v : !jaw.rests() ? face.jaw_vertices : std::vector<int>()) {
        result.col(v) = opened(face.jaw, jaw, result.col(v));
    }
    return result;
}

void write_face(const std::filesystem::path& file, const Scan& as_came, const FaceModel& face,
                const Points& node_positions, const JawPose& jaw, const Wrinkles& wrinkles) {
    constexpr double kOpen = 0.5;  // [mm] between the lips
    const Points vertices = scan_positions(face, node_positions, jaw, wrinkles);
    const Eigen::Index own = as_came.mesh.vertices.cols();
    double gap = 0.0;
    for (const auto& [upper, lower] : face.lip_contacts) {
        gap = std::max(gap, (node_positions.col(upper) - node_positions.col(lower)).norm());
    }
    if (vertices.cols() > own && gap < kOpen) {
        write_mesh(file, as_came, vertices.leftCols(own));
    } else {
        write_mesh(file, *face.scan, vertices);
    }
}

Points Simulator::scan_vertices() const {
    return scan_positions(*face_, state_.positions, jaw_pose(*face_, contractions_), wrinkles());
}

std::uint64_t Simulator::state_hash() const {
    std::uint64_t hash = 1469598103934665603ULL;
    for (Eigen::Index i = 0; i < state_.positions.size(); ++i) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, state_.positions.data() + i, sizeof bits);
        for (int byte = 0; byte < 8; ++byte) {
            hash = (hash ^ (bits >> (8 * byte) & 0xFF)) * 1099511628211ULL;
        }
    }
    return hash;
}

}  // namespace myoface
