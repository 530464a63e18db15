// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/contraction.h"

#include <algorithm>
#include <cmath>

#include "myoface/base/parallel.h"

namespace myoface {
namespace {

constexpr double kHold = 5.0;            // hold on the target, in usual tethers
constexpr double kSphincterReach = 1.3;  // of the ring's own size
constexpr double kLipSoftness = 1.5;     // of the border between the lips' zones [mm]
constexpr double kMidlineFade = 9.0;     // a paired muscle ends this far across the midline [mm]

double smooth_step(double edge0, double edge1, double x) {
    const double t = std::clamp((x - edge0) / (edge1 - edge0), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// How much of a muscle's response a node takes, by anatomy: 0 … 1.
double zone_share(const MuscleTraits& traits, const Vec3& generic, const TissueProperties& tissue) {
    if (tissue.fixed || tissue.region == Region::Ear) {
        return 0.0;
    }
    double share = smooth_step(-30.0, 0.0, generic.z());
    if (traits.side != Side::Middle) {
        const double own = traits.side == Side::Left ? generic.x() : -generic.x();
        share *= smooth_step(-kMidlineFade, 0.3 * kMidlineFade, own);
    }
    switch (traits.zone) {
        case MuscleZone::UpperLip:
            return share * upper_lip_share(generic, kLipSoftness);
        case MuscleZone::LowerLip:
            return share * (1.0 - upper_lip_share(generic, kLipSoftness));
        case MuscleZone::Brow:
            return share * smooth_step(20.0, 32.0, generic.y());
        case MuscleZone::Nose:
            return share * (1.0 - smooth_step(20.0, 30.0, std::abs(generic.x()))) *
                   smooth_step(-42.0, -32.0, generic.y());
        default:
            return share;
    }
}

ResponseZone linear_zone(const Muscle& muscle) {
    ResponseZone zone;
    zone.bone_end = muscle.path.col(0);
    zone.skin_end = muscle.path.col(muscle.path.cols() - 1);
    const double chord = (zone.skin_end - zone.bone_end).norm();
    zone.half_angle = muscle.traits.half_angle;
    zone.falloff_start = muscle.traits.falloff_start * chord;
    zone.falloff_end = muscle.traits.falloff_end * chord;
    return zone;
}

SphincterZone sphincter_zone(const Muscle& muscle) {
    SphincterZone zone;
    zone.centre = muscle.centre;
    zone.wide = muscle.wide;
    zone.axis = muscle.axis;
    zone.half_width = kSphincterReach * muscle.half_width;
    zone.half_height = kSphincterReach * muscle.half_height;
    zone.depth = 1.4 * muscle.half_width;
    zone.forward = muscle.traits.forward;
    return zone;
}

}  // namespace

Contractions resting(const FaceModel& face) {
    Contractions contractions;
    contractions.rate.assign(face.muscles.size(), 0.0);
    contractions.strength.assign(face.muscles.size(), 1.0);
    return contractions;
}

std::vector<MuscleResponse> muscle_responses(const FaceModel& face, const MassSpringModel& model,
                                             ResponseForm form) {
    std::vector<MuscleResponse> responses(face.muscles.size());
    parallel_for(static_cast<int>(face.muscles.size()), 1, [&](int begin, int end) {
        for (int m = begin; m < end; ++m) {
            const Muscle& muscle = face.muscles[m];
            const MuscleTraits& traits = muscle.traits;
            const bool linear = traits.kind == MuscleKind::Linear;
            const ResponseZone line = linear ? linear_zone(muscle) : ResponseZone{};
            const SphincterZone ring = linear ? SphincterZone{} : sphincter_zone(muscle);
            MuscleResponse& response = responses[m];
            std::vector<Vec3> shifts;
            std::vector<double> heights;
            std::vector<double> holds;
            for (int i = 0; i < model.skin_nodes; ++i) {
                if (model.fixed[i] != 0) {
                    continue;
                }
                const Vec3 p = face.skin.mesh.vertices.col(i);
                const Vec3 unit =
                    linear ? linear_response(line, p, form) : sphincter_response(ring, p);
                const double share = zone_share(traits, face.generic.col(i), face.tissue[i]);
                const Vec3 shift = traits.gain * traits.pull * share * unit;
                if (shift.squaredNorm() < 1e-10) {
                    continue;
                }
                const Vec3 n = model.ties[i].normal;
                response.nodes.push_back(i);
                shifts.push_back(shift);
                // Linear muscles slide the skin over the bone; a ring also pushes it forward.
                heights.push_back(linear ? 0.0
                                         : traits.gain * traits.pull * share *
                                               std::max(0.0, unit.dot(ring.axis)) *
                                               std::max(0.0, n.dot(ring.axis)));
                holds.push_back(std::min(1.0, share * unit.norm()));
            }
            const auto count = static_cast<Eigen::Index>(shifts.size());
            response.shift.resize(3, count);
            response.height.resize(count);
            response.hold.resize(count);
            for (Eigen::Index k = 0; k < count; ++k) {
                response.shift.col(k) = shifts[static_cast<std::size_t>(k)];
                response.height[k] = heights[static_cast<std::size_t>(k)];
                response.hold[k] = holds[static_cast<std::size_t>(k)];
            }
        }
    });
    return responses;
}

Drive contraction_drive(const FaceMassSpring& system, const std::vector<MuscleResponse>& responses,
                        const Contractions& contractions) {
    Drive drive;
    const int n = system.model.node_count();
    for (std::size_t m = 0; m < responses.size(); ++m) {
        const double c = contractions.rate[m] * contractions.strength[m];
        if (c == 0.0) {
            continue;
        }
        if (drive.shift.cols() == 0) {
            drive.shift = Points::Zero(3, n);
            drive.height = Eigen::VectorXd::Zero(n);
            drive.tether_boost = Eigen::VectorXd::Ones(n);
            drive.length_factor.assign(system.model.springs.size(), 1.0);
            drive.stiffness_factor.assign(system.model.springs.size(), 1.0);
        }
        const MuscleResponse& response = responses[m];
        for (std::size_t k = 0; k < response.nodes.size(); ++k) {
            const auto column = static_cast<Eigen::Index>(k);
            const int i = response.nodes[k];
            drive.shift.col(i) += c * response.shift.col(column);
            drive.height[i] += c * response.height[column];
            // As much hold on loose skin as on tight: the lips must follow, not only the cheek.
            const double most = 1.0 + kHold / system.bone_tie[i];
            drive.tether_boost[i] = std::min(
                most, drive.tether_boost[i] + std::abs(c) * response.hold[column] * (most - 1.0));
        }
        const MuscleChain& chain = system.chains[m];
        for (int s = chain.first_spring; s < chain.first_spring + chain.spring_count; ++s) {
            drive.length_factor[s] = 1.0 - c * chain.shortening;
            drive.stiffness_factor[s] = 1.0 + std::max(c, 0.0) * (chain.activation - 1.0);
        }
    }
    return drive;
}

}  // namespace myoface
