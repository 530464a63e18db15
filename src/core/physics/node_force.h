// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "myoface/physics/mass_spring_model.h"

namespace myoface {

constexpr double kStiffeningStart = 0.2;  // strain
constexpr double kLimitStiffness = 15.0;  // beyond the limit, of k
constexpr double kStopStiffness = 20.0;   // of the bone, of k_n

inline Stretch weaker(const Stretch& a, const Stretch& b) {
    return {std::min(a.stiffening, b.stiffening), std::min(a.limit, b.limit)};
}

/// Tension of a stretched spring per unit of length, so that the force on a is −ratio · (x_a −
/// x_b).
/// @param stiffness k as the drive has it
inline double tension_ratio(double stiffness, const Stretch& stretch, double distance,
                            double natural) {
    if (!(distance > 0.0)) {
        return 0.0;
    }
    double tension = stiffness * (distance - natural);
    if (natural > 0.0) {
        const double strain = distance / natural - 1.0;
        const double over = std::max(std::abs(strain) - kStiffeningStart, 0.0);
        const double beyond = std::max(strain - stretch.limit, 0.0);
        tension +=
            stiffness * natural *
            (std::copysign(stretch.stiffening * over * over, strain) + kLimitStiffness * beyond);
    }
    return tension / distance;
}

inline double active_stiffness(double stiffness, const Drive& drive, int spring) {
    return drive.stiffness_factor.empty() ? stiffness : stiffness * drive.stiffness_factor[spring];
}

inline double natural_length(double length, const Drive& drive, int spring) {
    return drive.length_factor.empty() ? length : length * drive.length_factor[spring];
}

/// How far a node has gone from the place that its ties hold it to.
inline Vec3 tied_way(const MassSpringModel& model, const Points& x, const Drive& drive, int i) {
    const Vec3 way = x.col(i) - model.rest.col(i);
    return drive.carry.cols() > 0 ? Vec3(way - drive.carry.col(i)) : way;
}

/// What keeps a node out of an obstacle: how far it is in the way, and the slope there.
inline DistanceField::Sample barrier_at(const MassSpringModel& model, const Drive& drive,
                                        const Vec3& at, int i, int o) {
    const auto obstacle = static_cast<std::size_t>(o);
    const bool posed = !drive.obstacle_pose.empty() && model.obstacles[obstacle].with_jaw;
    const Vec3 p = posed ? Vec3(drive.obstacle_pose[obstacle].inverse() * at) : at;
    DistanceField::Sample sample = distance_to(model.obstacles[obstacle], p);
    sample.distance -= model.barriers.margin(o, i);
    if (posed) {
        sample.slope = drive.obstacle_pose[obstacle].linear() * sample.slope;
    }
    return sample;
}
inline int barriers_of(const MassSpringModel& model, int i) {
    return !model.barriers.stiffness.empty() && model.barriers.stiffness[i] > 0.0
               ? static_cast<int>(model.obstacles.size())
               : 0;
}

/// Elastic force on one node: everything but dampers. `x` are positions, `layer` may be 3×0.
inline Vec3 node_force(const MassSpringModel& model, const Points& x, const Points& layer,
                       const Drive& drive, int i) {
    const Vec3 at = x.col(i);
    Vec3 force = Vec3::Zero();
    for (int e = model.spring_start[i]; e < model.spring_start[i + 1]; ++e) {
        const SpringEnd& end = model.spring_ends[e];
        const Vec3 r = at - x.col(end.other);
        force -= tension_ratio(active_stiffness(end.stiffness, drive, end.spring),
                               weaker(model.stretch[i], model.stretch[end.other]), r.norm(),
                               natural_length(end.length, drive, end.spring)) *
                 r;
    }
    for (int e = model.linear.start[i]; e < model.linear.start[i + 1]; ++e) {
        const int j = model.linear.column[e];
        force -= model.linear.value[e] * (x.col(j) - model.rest.col(j));
    }
    const Tie& tie = model.ties[i];
    const Vec3 delta = tied_way(model, x, drive, i);
    if (tie.thickness > 0.0) {
        const Vec3 bent = tie.curvature * delta;
        const double wanted = drive.height.size() > 0 ? drive.height[i] : 0.0;
        const double height = tie.normal.dot(delta) + 0.5 * delta.dot(bent) - wanted;
        const double stopped = std::min(0.0, height + wanted + tie.stop);
        force -= tie.thickness * (height + kStopStiffness * stopped) * (tie.normal + bent);
    }
    if (tie.tether > 0.0) {
        Vec3 side = delta;
        if (drive.shift.cols() > 0) {
            side -= drive.shift.col(i);
        }
        if (layer.cols() > 0 && i < model.skin_nodes) {
            side -= layer.col(i);
        }
        side -= side.dot(tie.normal) * tie.normal;
        const double boost = drive.tether_boost.size() > 0 ? drive.tether_boost[i] : 1.0;
        force -= tie.tether * boost * side;
    }
    force -= tie.anchor * delta;
    const int c = model.contact_of[i];
    if (c >= 0) {
        const Contact& contact = model.contacts[c];
        const double gap = contact.normal.dot(x.col(contact.a) - x.col(contact.b)) - contact.gap;
        if (gap < 0.0) {
            force += (i == contact.a ? -1.0 : 1.0) * contact.stiffness * gap * contact.normal;
        }
    }
    for (int o = 0; o < barriers_of(model, i); ++o) {
        const DistanceField::Sample sample = barrier_at(model, drive, at, i, o);
        if (sample.distance < 0.0) {
            force -= model.barriers.stiffness[i] * sample.distance * sample.slope;
        }
    }
    force += model.mass[i] * (drive.gravity - model.rest_gravity);
    if (drive.load.cols() > 0) {
        force += drive.load.col(i);
    }
    if (drive.inertia.size() > 0) {
        force -= drive.inertia[i] * (at - model.rest.col(i) - drive.ahead.col(i));
    }
    return force;
}

/// Force on the muscle layer under one skin node.
inline Vec3 layer_node_force(const MassSpringModel& model, const Points& x, const Points& layer,
                             const Drive& drive, int i) {
    const Tie& tie = model.ties[i];
    const double boost = drive.tether_boost.size() > 0 ? drive.tether_boost[i] : 1.0;
    Vec3 side = tied_way(model, x, drive, i) - layer.col(i);
    if (drive.shift.cols() > 0) {
        side -= drive.shift.col(i);
    }
    side -= side.dot(tie.normal) * tie.normal;
    Vec3 force = tie.tether * boost * side - tie.tether * layer.col(i);
    const LinearStiffness& links = model.layer.links;
    for (int e = links.start[i]; e < links.start[i + 1]; ++e) {
        force -= links.value[e] * layer.col(links.column[e]);
    }
    if (drive.layer_load.cols() > 0) {
        force += drive.layer_load.col(i);
    }
    return force;
}

}  // namespace myoface
