// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/forces.h"

#include "myoface/base/parallel.h"

#include "node_force.h"

namespace myoface {
namespace {

constexpr int kForceGrain = 512;

/// xᵀKx/2 of a symmetric scalar matrix on three components.
double quadratic(const LinearStiffness& matrix, const Points& u) {
    double sum = 0.0;
    for (int i = 0; i + 1 < static_cast<int>(matrix.start.size()); ++i) {
        Vec3 row = Vec3::Zero();
        for (int e = matrix.start[i]; e < matrix.start[i + 1]; ++e) {
            row += matrix.value[e] * u.col(matrix.column[e]);
        }
        sum += 0.5 * row.dot(u.col(i));
    }
    return sum;
}

}  // namespace

Points spring_forces(const MassSpringModel& model, const MassSpringState& state,
                     const Vec3& gravity) {
    Points forces = gravity * model.mass.transpose();
    for (const Spring& s : model.springs) {
        const Vec3 r = state.positions.col(s.a) - state.positions.col(s.b);
        const Vec3 v = state.velocities.col(s.a) - state.velocities.col(s.b);
        const double distance = r.norm();
        Vec3 pull = s.damping * v;
        if (distance > 0.0) {
            pull += s.stiffness * (1.0 - s.length / distance) * r;
        }
        forces.col(s.a) -= pull;
        forces.col(s.b) += pull;
    }
    return forces;
}

Points total_forces(const MassSpringModel& model, const MassSpringState& state, const Drive& drive,
                    bool damped) {
    Points forces(3, model.node_count());
    parallel_for(model.node_count(), kForceGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            Vec3 force = node_force(model, state.positions, state.layer, drive, i);
            if (damped) {
                const Vec3 v = state.velocities.col(i);
                force -= model.ties[i].damping * v;
                for (int e = model.spring_start[i]; e < model.spring_start[i + 1]; ++e) {
                    const SpringEnd& spring_end = model.spring_ends[e];
                    force -= model.springs[spring_end.spring].damping *
                             (v - state.velocities.col(spring_end.other));
                }
            }
            forces.col(i) = force;
        }
    });
    return forces;
}

Points layer_forces(const MassSpringModel& model, const MassSpringState& state,
                    const Drive& drive) {
    Points forces(3, model.skin_nodes);
    parallel_for(model.skin_nodes, kForceGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            forces.col(i) = layer_node_force(model, state.positions, state.layer, drive, i);
        }
    });
    return forces;
}

double potential_energy(const MassSpringModel& model, const MassSpringState& state,
                        const Drive& drive) {
    double energy = 0.0;
    const Points& x = state.positions;
    for (std::size_t s = 0; s < model.springs.size(); ++s) {
        const Spring& spring = model.springs[s];
        const double natural = natural_length(spring.length, drive, static_cast<int>(s));
        const double distance = (x.col(spring.a) - x.col(spring.b)).norm();
        const double k = active_stiffness(spring.stiffness, drive, static_cast<int>(s));
        energy += 0.5 * k * (distance - natural) * (distance - natural);
        if (natural > 0.0) {
            const Stretch stretch = weaker(model.stretch[spring.a], model.stretch[spring.b]);
            const double strain = distance / natural - 1.0;
            const double over = std::max(std::abs(strain) - kStiffeningStart, 0.0);
            const double beyond = std::max(strain - stretch.limit, 0.0);
            energy += k * natural * natural *
                      (stretch.stiffening * over * over * over / 3.0 +
                       0.5 * kLimitStiffness * beyond * beyond);
        }
    }
    const Points u = x - model.rest;
    energy += quadratic(model.linear, u);
    for (int i = 0; i < model.node_count(); ++i) {
        const Tie& tie = model.ties[i];
        const Vec3 delta = tied_way(model, x, drive, i);
        const double wanted = drive.height.size() > 0 ? drive.height[i] : 0.0;
        const double height =
            tie.normal.dot(delta) + 0.5 * delta.dot(tie.curvature * delta) - wanted;
        const double stopped = std::min(0.0, height + wanted + tie.stop);
        energy += 0.5 * tie.thickness * (height * height + kStopStiffness * stopped * stopped) +
                  0.5 * tie.anchor * delta.squaredNorm();
        Vec3 side = delta;
        if (drive.shift.cols() > 0) {
            side -= drive.shift.col(i);
        }
        if (state.layer.cols() > 0 && i < model.skin_nodes) {
            side -= state.layer.col(i);
            energy += 0.5 * tie.tether * state.layer.col(i).squaredNorm();
            if (drive.layer_load.cols() > 0) {
                energy -= drive.layer_load.col(i).dot(state.layer.col(i));
            }
        }
        side -= side.dot(tie.normal) * tie.normal;
        const double boost = drive.tether_boost.size() > 0 ? drive.tether_boost[i] : 1.0;
        energy += 0.5 * tie.tether * boost * side.squaredNorm();
        for (int o = 0; o < barriers_of(model, i); ++o) {
            const double in = std::min(0.0, barrier_at(model, drive, x.col(i), i, o).distance);
            energy += 0.5 * model.barriers.stiffness[i] * in * in;
        }
        energy -= model.mass[i] * (drive.gravity - model.rest_gravity).dot(u.col(i));
        if (drive.load.cols() > 0) {
            energy -= drive.load.col(i).dot(u.col(i));
        }
        if (drive.inertia.size() > 0) {
            energy += drive.inertia[i] *
                      (0.5 * u.col(i).squaredNorm() - drive.ahead.col(i).dot(u.col(i)));
        }
    }
    if (state.layer.cols() > 0) {
        energy += quadratic(model.layer.links, state.layer);
    }
    for (const Contact& contact : model.contacts) {
        const double gap =
            std::min(0.0, contact.normal.dot(x.col(contact.a) - x.col(contact.b)) - contact.gap);
        energy += 0.5 * contact.stiffness * gap * gap;
    }
    return energy;
}

StrainReport skin_strain(const MassSpringModel& model, const Points& positions,
                         const std::vector<int>& springs, const std::vector<double>& limit,
                         double least_limit) {
    StrainReport report;
    for (const int s : springs) {
        const Spring& spring = model.springs[s];
        const double distance = (positions.col(spring.a) - positions.col(spring.b)).norm();
        const double strain = std::abs(distance / spring.length - 1.0);
        const double most = std::max(std::min(limit[spring.a], limit[spring.b]), least_limit);
        if (most < 1e6) {
            report.largest = std::max(report.largest, strain);
            report.share_of_limit = std::max(report.share_of_limit, strain / most);
        }
    }
    return report;
}

}  // namespace myoface
