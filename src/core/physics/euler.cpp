// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/euler.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "myoface/physics/forces.h"

#include "node_force.h"

namespace myoface {
namespace {

constexpr double kSafety = 0.9;

/// F/m per node, zero where fixed.
Points accelerations(const MassSpringModel& model, const MassSpringState& state,
                     const Drive& drive) {
    Points a = total_forces(model, state, drive, true);
    for (int i = 0; i < model.node_count(); ++i) {
        if (model.fixed[i] != 0) {
            a.col(i).setZero();
        } else {
            a.col(i) /= model.mass[i];
        }
    }
    return a;
}

}  // namespace

void explicit_euler_step(const MassSpringModel& model, MassSpringState& state, const Drive& drive,
                         double step) {
    const Points a = accelerations(model, state, drive);
    state.positions += step * state.velocities;
    state.velocities += step * a;
}

void symplectic_euler_step(const MassSpringModel& model, MassSpringState& state, const Drive& drive,
                           double step) {
    state.velocities += step * accelerations(model, state, drive);
    state.positions += step * state.velocities;
}

Eigen::VectorXd stiffness_row_sums(const MassSpringModel& model, const Points& positions,
                                   const Drive& drive) {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(model.node_count());
    for (int i = 0; i < model.node_count(); ++i) {
        double sum = 0.0;
        for (int e = model.spring_start[i]; e < model.spring_start[i + 1]; ++e) {
            const SpringEnd& spring = model.spring_ends[e];
            double k = active_stiffness(spring.stiffness, drive, spring.spring);
            const double natural = natural_length(spring.length, drive, spring.spring);
            if (natural > 0.0) {
                const Stretch stretch = weaker(model.stretch[i], model.stretch[spring.other]);
                const double distance = (positions.col(i) - positions.col(spring.other)).norm();
                const double strain = distance / natural - 1.0;
                const double over = std::max(std::abs(strain) - kStiffeningStart, 0.0);
                const double limit = strain > stretch.limit ? kLimitStiffness : 0.0;
                // Sideways a spring far from its length is as stiff as its tension per length.
                k = std::max(k * (1.0 + 2.0 * stretch.stiffening * over + limit),
                             std::abs(tension_ratio(k, stretch, distance, natural)));
            }
            sum += 2.0 * k;
        }
        for (int e = model.linear.start[i]; e < model.linear.start[i + 1]; ++e) {
            sum += std::abs(model.linear.value[e]);
        }
        const Tie& tie = model.ties[i];
        const double boost = drive.tether_boost.size() > 0 ? drive.tether_boost[i] : 1.0;
        double thickness = tie.thickness;
        if (thickness > 0.0) {
            // Far from rest the bone's surface slopes against the normal.
            const Vec3 delta = tied_way(model, positions, drive, i);
            const Vec3 bent = tie.curvature * delta;
            const double wanted = drive.height.size() > 0 ? drive.height[i] : 0.0;
            const double height = tie.normal.dot(delta) + 0.5 * delta.dot(bent) - wanted;
            const double stopped = height + wanted + tie.stop;
            const double stop = stopped < 0.0 ? kStopStiffness : 0.0;
            thickness *= (1.0 + stop) * (tie.normal + bent).squaredNorm() +
                         (std::abs(height) + stop * std::abs(stopped)) * tie.curvature.norm();
        }
        sum += std::max(thickness, tie.tether * boost) + tie.anchor;
        if (model.contact_of[i] >= 0) {
            sum += 2.0 * model.contacts[model.contact_of[i]].stiffness;
        }
        if (drive.inertia.size() > 0) {
            sum += drive.inertia[i];
        }
        for (int o = 0; o < barriers_of(model, i); ++o) {
            if (barrier_at(model, drive, positions.col(i), i, o).distance < 0.0) {
                sum += model.barriers.stiffness[i];
            }
        }
        sums[i] = sum;
    }
    return sums;
}

double stable_time_step(const MassSpringModel& model, Integrator integrator) {
    const Eigen::VectorXd sums = stiffness_row_sums(model, model.rest, {});
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < model.node_count(); ++i) {
        if (model.fixed[i] != 0) {
            continue;
        }
        const double square = sums[i] / model.mass[i];  // ω²
        if (!(square > 0.0)) {
            continue;
        }
        const double own = model.ties[i].damping / model.mass[i];
        double damping = model.ties[i].damping;
        for (int e = model.spring_start[i]; e < model.spring_start[i + 1]; ++e) {
            damping += 2.0 * model.springs[model.spring_ends[e].spring].damping;
        }
        const double rate = damping / model.mass[i];
        if (integrator == Integrator::ExplicitEuler) {
            // Only damping that every motion of the node feels can be counted on; too much of it
            // limits the step in its own way.
            least = std::min({least, own / square, rate > 0.0 ? 1.0 / rate : 0.0});
            continue;
        }
        least = std::min(least, (std::sqrt(rate * rate + 4.0 * square) - rate) / square);
    }
    return std::isfinite(least) ? kSafety * least : 1e-3;
}

}  // namespace myoface
