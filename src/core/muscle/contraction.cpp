// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/contraction.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "myoface/base/parallel.h"
#include "myoface/base/smooth_step.h"

namespace myoface {
namespace {

constexpr double kZoneHold = 5.0;     // hold on the target, in usual tethers
constexpr double kLipSoftness = 1.5;  // of the border between the lips' zones [mm]
constexpr double kLidHold = 100.0;    // of lids, which lie on the eyeball and unroll
constexpr double kHeldBack = 0.45;    // of a lid's way beside its corners
constexpr double kMeeting = 0.12;     // where the lids meet, from the lower one's margin
constexpr double kToNose = 1.5;       // way of closing lids towards the nose [mm]
constexpr double kBeside = 0.6;       // where halves of a mouth's ring push forward, of its width
constexpr double kMidlineFade = 9.0;  // a paired muscle ends this far across the midline [mm]

/// How much of a muscle's response a node takes, by anatomy: 0 … 1.
double zone_share(const MuscleTraits& traits, const Vec3& generic, const TissueProperties& tissue,
                  int lip_side) {
    if (tissue.fixed || tissue.region == Region::Ear) {
        return 0.0;
    }
    double share = smooth_step(-30.0, 0.0, generic.z());
    if (traits.side != Side::Middle) {
        const double own = traits.side == Side::Left ? generic.x() : -generic.x();
        // Halves of one ring make a whole in the middle.
        share *= smooth_step(-kMidlineFade, (traits.shares_mouth ? 1.0 : 0.3) * kMidlineFade, own);
    }
    if (traits.group == "eye" && traits.action == MuscleAction::Purse) {
        // The ring lies around the lids, which go along with each other only.
        const LidPlace lid = lid_place(generic);
        share *= 1.0 - std::max(lid.with_upper, lid.with_lower);
    }
    switch (traits.zone) {
        case MuscleZone::UpperLip:
            return share * upper_lip_share(generic, kLipSoftness, lip_side);
        case MuscleZone::LowerLip:
            return share * (1.0 - upper_lip_share(generic, kLipSoftness, lip_side));
        case MuscleZone::Brow:
            return share * smooth_step(20.0, 32.0, generic.y());
        case MuscleZone::Nose:
            return share * (1.0 - smooth_step(20.0, 30.0, std::abs(generic.x()))) *
                   smooth_step(-42.0, -32.0, generic.y());
        default:
            return share;
    }
}

ResponseZone linear_zone(const Muscle& muscle, const Points& path) {
    ResponseZone zone;
    zone.bone_end = path.col(0);
    zone.skin_end = path.col(path.cols() - 1);
    const double chord = (zone.skin_end - zone.bone_end).norm();
    zone.half_angle = muscle.traits.half_angle;
    zone.falloff_start = muscle.traits.falloff_start * chord;
    zone.falloff_end = muscle.traits.falloff_end * chord;
    return zone;
}

SphincterZone sphincter_zone(const Muscle& muscle) {
    SphincterZone zone;
    Vec3 up = muscle.axis.cross(muscle.wide);
    up *= up.y() < 0.0 ? -1.0 : 1.0;
    zone.centre = muscle.centre + muscle.traits.rise * muscle.half_height * up;
    zone.wide = muscle.wide;
    zone.axis = muscle.axis;
    zone.half_width = muscle.traits.reach_wide * muscle.half_width;
    zone.half_height = muscle.traits.reach_high * muscle.half_height;
    zone.depth = 1.08 * zone.half_width;
    zone.forward = muscle.traits.forward;
    const bool turned = muscle.axis.cross(muscle.wide).y() < 0.0;  // whose shorter axis looks down
    zone.across_high = turned ? muscle.traits.across_below : muscle.traits.across_above;
    zone.across_low = turned ? muscle.traits.across_above : muscle.traits.across_below;
    return zone;
}

/// A sphincter's way of one place. Halves of a mouth's ring draw towards its middle but push
/// forward most at their own side, by the canine, where they come from the bone.
Vec3 ring_response(const Muscle& muscle, SphincterZone zone, const Vec3& p) {
    if (!muscle.traits.shares_mouth || muscle.traits.side == Side::Middle) {
        return sphincter_response(zone, p);
    }
    SphincterZone beside = zone;
    zone.forward = 0.0;
    const double to_left = zone.wide.x() < 0.0 ? -1.0 : 1.0;
    const double own = muscle.traits.side == Side::Left ? to_left : -to_left;
    beside.centre += own * kBeside * muscle.half_width * zone.wide;
    return sphincter_response(zone, p) + sphincter_response(beside, p).dot(zone.axis) * zone.axis;
}

/// What a muscle asks of one place of the skin.
struct Demand {
    Vec3 shift = Vec3::Zero();  ///< [mm]
    double height = 0.0;        ///< [mm]
    double hold = 0.0;          ///< 0 … 1
};

/// Fibres side by side: each by its own response, weighed by how strongly it reaches the place, so
/// that the strongest is at full strength and the direction goes over smoothly.
Vec3 sheet_response(const std::vector<ResponseZone>& fibres, const Vec3& p, ResponseForm form) {
    Vec3 sum = Vec3::Zero();
    double weights = 0.0;
    for (const ResponseZone& fibre : fibres) {
        const Vec3 one = linear_response(fibre, p, form);
        const double weight = one.norm();
        sum += weight * one;
        weights += weight;
    }
    return weights > 1e-12 ? Vec3(sum / weights) : Vec3(Vec3::Zero());
}

/// Distance from a polyline.
double distance_from(const Points& path, const Vec3& p) {
    double least = 1e30;
    for (Eigen::Index i = 1; i < path.cols(); ++i) {
        const Vec3 a = path.col(i - 1);
        const Vec3 ab = Vec3(path.col(i)) - a;
        const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
        least = std::min(least, (p - a - t * ab).norm());
    }
    return least;
}

/// The belly between two bones lifts the skin over it: most over its middle.
Demand bulge(const Muscle& muscle, const Vec3& p, double share) {
    const double reach = 0.62 * muscle.traits.breadth + 8.0;
    const Vec3 middle = muscle.path.col(muscle.path.cols() / 2);
    const double along = (p - middle).norm() / (0.75 * muscle.length);
    const double across = distance_from(muscle.path, p) / reach;
    const double r = std::max(along * along, across * across);
    Demand demand;
    if (r < 1.0) {
        demand.height = muscle.traits.pull * share * (1.0 - r) * (1.0 - r);
    }
    return demand;
}

/// A turn about the transverse axis of an eyeball that carries a lid's margin to another height.
Demand slide_lid(const FaceModel& face, int node, const MuscleTraits& traits) {
    const Side side = traits.side;
    const bool close = traits.action == MuscleAction::CloseLids;
    const Vec3 generic = face.generic.col(node);
    if ((side == Side::Left) != (generic.x() > 0.0)) {
        return {};
    }
    const LidPlace lid = lid_place(generic);
    const double upper = lid.with_upper;
    const double lower = lid.with_lower;
    if (upper <= 0.0 && lower <= 0.0) {
        // The skin of a lid unrolls from its fold: what lies around is not pulled along.
        Demand still;
        still.hold = lid.around;
        return still;
    }
    // The lower lid hardly rises, and both are drawn towards the nose; wide open, the upper one
    // goes up by a fifth of the fissure.
    const double fissure = lid.upper - lid.lower;
    const double meeting = lid.lower + kMeeting * fissure;
    double rise = 0.0;
    if (close) {
        // Beside its corners, where ligaments hold it back, a lid is pulled further than it gets.
        const double more = 1.0 + kHeldBack * smooth_step(5.5, 1.5, lid.from_corner);
        rise = more * upper * (meeting - lid.upper) + lower * (meeting - lid.lower);
    } else {
        rise = 0.22 * upper * fissure;
    }
    rise *= traits.gain / face.to_generic.scale;
    const Vec3 centre = face.eyes.col(side == Side::Left ? 0 : 1);
    const Vec3 p = face.skin.mesh.vertices.col(node);
    const Vec3 off = p - centre;
    const Vec3 left = face.axes.col(0);
    const Vec3 up = face.axes.col(1);
    const double radius = (off - off.dot(left) * left).norm();
    const double height = off.dot(up);
    // The angle by which the height changes by `rise` on this circle.
    const auto angle_at = [&](double h) { return std::asin(std::clamp(h / radius, -1.0, 1.0)); };
    const Eigen::AngleAxisd turn(-(angle_at(height + rise) - angle_at(height)), left);
    Demand demand;
    demand.shift = turn * off - off;
    if (close) {
        demand.shift += (side == Side::Left ? -1.0 : 1.0) * kToNose * std::max(upper, lower) /
                        face.to_generic.scale * left;
    }
    demand.hold = std::max({upper, lower, lid.around});
    return demand;
}

/// The skin's share of a motion of the mandible.
Demand move_jaw(const FaceModel& face, int node, const JawPose& pose) {
    const double share = jaw_share(face.generic.col(node), face.lip_side[node]);
    const Vec3 p = face.skin.mesh.vertices.col(node);
    Demand demand;
    demand.shift = share * (opened(face.jaw, pose, p) - p);
    demand.hold = share;
    return demand;
}

/// Where one muscle alone has the jaw at full contraction: the right lateral pterygoid draws its
/// side forward, and the chin goes to the left.
JawPose full_jaw_pose(const MuscleTraits& traits) {
    JawPose pose;
    if (traits.action == MuscleAction::OpenJaw) {
        pose.open = 1.0;
    } else if (traits.action == MuscleAction::ShiftJaw) {
        pose.thrust = 0.5;
        pose.left = traits.side == Side::Right ? 1.0 : -1.0;
    }
    return pose;
}

}  // namespace

Contractions resting(const FaceModel& face) {
    Contractions contractions;
    contractions.rate.assign(face.muscles.size(), 0.0);
    contractions.strength.assign(face.muscles.size(), 1.0);
    return contractions;
}

JawPose jaw_pose(const FaceModel& face, const Contractions& contractions) {
    JawPose pose;
    for (std::size_t m = 0; m < face.muscles.size(); ++m) {
        const JawPose full = full_jaw_pose(face.muscles[m].traits);
        const double c = std::max(0.0, contractions.rate[m] * contractions.strength[m]);
        pose.open += c * full.open;
        pose.thrust += c * full.thrust;
        pose.left += c * full.left;
    }
    pose.open = std::min(pose.open, 1.0);
    return pose;
}

double jaw_opening(const FaceModel& face, const Contractions& contractions) {
    return jaw_pose(face, contractions).open;
}

std::vector<MuscleResponse> muscle_responses(const FaceModel& face, const MassSpringModel& model,
                                             ResponseForm form) {
    std::vector<MuscleResponse> responses(face.muscles.size());
    parallel_for(static_cast<int>(face.muscles.size()), 1, [&](int begin, int end) {
        for (int m = begin; m < end; ++m) {
            const Muscle& muscle = face.muscles[m];
            const MuscleTraits& traits = muscle.traits;
            std::vector<ResponseZone> lines;
            SphincterZone ring;
            if (traits.action == MuscleAction::Purse) {
                ring = sphincter_zone(muscle);
            } else if (muscle.fibres.empty()) {
                lines.push_back(linear_zone(muscle, muscle.path));
            } else {
                for (const Points& fibre : muscle.fibres) {
                    lines.push_back(linear_zone(muscle, fibre));
                }
            }
            MuscleResponse& response = responses[m];
            response.jaw =
                traits.action == MuscleAction::OpenJaw || traits.action == MuscleAction::ShiftJaw;
            const bool lid =
                traits.action == MuscleAction::CloseLids || traits.action == MuscleAction::RaiseLid;
            response.whole = lid || response.jaw;
            response.firmness = lid ? kLidHold : kZoneHold;
            std::vector<Vec3> shifts;
            std::vector<double> heights;
            std::vector<double> holds;
            for (int i = 0; i < model.skin_nodes; ++i) {
                if (model.fixed[i] != 0) {
                    continue;
                }
                const Vec3 p = face.skin.mesh.vertices.col(i);
                Demand demand;
                if (response.whole) {
                    demand = response.jaw ? move_jaw(face, i, full_jaw_pose(traits))
                                          : slide_lid(face, i, traits);
                    if (face.tissue[i].fixed) {
                        demand = {};
                    }
                } else {
                    const double share =
                        zone_share(traits, face.generic.col(i), face.tissue[i], face.lip_side[i]);
                    if (traits.action == MuscleAction::Bulge) {
                        demand = bulge(muscle, p, share);
                    } else {
                        const Vec3 unit = !lines.empty() ? sheet_response(lines, p, form)
                                                         : ring_response(muscle, ring, p);
                        demand.shift = traits.gain * traits.pull * share * unit;
                        demand.hold = std::min(1.0, share * unit.norm());
                        if (lines.empty()) {
                            // Pulls slide the skin over the bone; a ring also pushes it forward.
                            demand.height = traits.gain * traits.pull * share *
                                            std::max(0.0, unit.dot(ring.axis)) *
                                            std::max(0.0, model.ties[i].normal.dot(ring.axis));
                        }
                    }
                }
                if (demand.shift.squaredNorm() < 1e-10 && demand.height < 1e-5 &&
                    !(response.whole && demand.hold > 1e-3)) {
                    continue;
                }
                response.nodes.push_back(i);
                shifts.push_back(demand.shift);
                heights.push_back(demand.height);
                holds.push_back(demand.hold);
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
        const MuscleResponse& response = responses[m];
        double c = contractions.rate[m] * contractions.strength[m];
        if (response.jaw) {
            c = std::max(c, 0.0);  // teeth that meet go no further
        }
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
        for (std::size_t k = 0; k < response.nodes.size(); ++k) {
            const auto column = static_cast<Eigen::Index>(k);
            const int i = response.nodes[k];
            // Lids and jaw carry the skin with what is under it; others slide it over the bone.
            if (response.whole) {
                if (drive.carry.cols() == 0) {
                    drive.carry = Points::Zero(3, n);
                }
                drive.carry.col(i) += c * response.shift.col(column);
            } else {
                drive.shift.col(i) += c * response.shift.col(column);
                drive.height[i] += c * response.height[column];
            }
            // As much hold on loose skin as on tight: the lips must follow, not only the cheek.
            const double most = 1.0 + response.firmness / system.bone_tie[i];
            drive.tether_boost[i] = std::min(
                most, drive.tether_boost[i] + std::abs(c) * response.hold[column] * (most - 1.0));
        }
        const MuscleChain& chain = system.chains[m];
        for (int s = chain.first_spring; s < chain.first_spring + chain.spring_count; ++s) {
            drive.length_factor[s] = 1.0 - c * chain.shortening;
            drive.stiffness_factor[s] = 1.0 + std::max(c, 0.0) * (chain.activation - 1.0);
        }
    }
    // Muscles go along with the skin over them, their ends on the mandible with the chin.
    const Eigen::Index skin = n - static_cast<Eigen::Index>(system.skin_over.size());
    for (Eigen::Index i = skin; i < drive.carry.cols(); ++i) {
        drive.carry.col(i) = drive.carry.col(system.skin_over[static_cast<std::size_t>(i - skin)]);
    }
    return drive;
}

}  // namespace myoface
