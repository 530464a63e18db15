// SPDX-License-Identifier: Apache-2.0
#include "bone_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "myoface/base/parallel.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/bvh.h"

#include "head/head_mesh.h"
#include "head/skull.h"
#include "muscle_placement.h"

namespace myoface {
namespace {

constexpr double kFarthestMiss = 14.0;   // [mm] the warp may miss the scan by in the face …
constexpr double kFarthestCrown = 40.0;  // … and over the skull, where there are no landmarks
constexpr int kSmoothingRounds = 60;     // of smoothing
constexpr double kHold = 0.25;           // on a vertex' own shift while smoothing

/// Shift of each skull vertex that its skin makes on the scan; weight 0 where there is no scan.
struct Shifts {
    Points shift;
    std::vector<double> weight;
};

Shifts follow_skin(const FaceModel& face, const Skull& skull, const Points& skin) {
    const TriangleMesh surface = outer_skin(face);
    const Bvh bvh(surface);
    Shifts shifts{Points::Zero(3, skin.cols()),
                  std::vector<double>(static_cast<std::size_t>(skin.cols()), 0.0)};
    parallel_for(static_cast<int>(skin.cols()), 128, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const ClosestPoint hit = bvh.closest_point(surface, skin.col(v));
            const double crown = std::clamp((skull.mesh.vertices(1, v) - 50.0) / 40.0, 0.0, 1.0);
            const double farthest = kFarthestMiss + crown * (kFarthestCrown - kFarthestMiss);
            if (hit.distance < farthest) {
                shifts.shift.col(v) = hit.point - Vec3(skin.col(v));
                const double r = hit.distance / farthest;
                shifts.weight[v] = (1.0 - r * r) * (1.0 - r * r);
            }
        }
    });
    return shifts;
}

/// Bone that lies near its skin goes deeper under more tissue, and comes nearer under less.
void thicken(Shifts& shifts, const Points& bone, const Points& skin, TissueThickness thickness) {
    constexpr double kDeepest = 26.0;  // [mm] what lies further in is not the outside of the bone
    for (Eigen::Index v = 0; v < bone.cols(); ++v) {
        const Vec3 inward = bone.col(v) - skin.col(v);
        const double depth = inward.norm();
        if (depth < kDeepest) {
            shifts.shift.col(v) += (thickness_factor(thickness, depth) - 1.0) * inward;
        }
    }
}

/// Spreads the shifts over the bone: where there is no scan the neighbours' is taken.
Points smoothed(const Shifts& shifts, const Adjacency& adjacency) {
    Points now = shifts.shift;
    for (Eigen::Index v = 0; v < now.cols(); ++v) {
        now.col(v) *= shifts.weight[static_cast<std::size_t>(v)];
    }
    for (int round = 0; round < kSmoothingRounds; ++round) {
        const Points before = now;
        parallel_for(static_cast<int>(now.cols()), 512, [&](int begin, int end) {
            for (int v = begin; v < end; ++v) {
                const double own = kHold * shifts.weight[v];
                Vec3 sum = own * shifts.shift.col(v);
                double weights = own;
                for (const int w : adjacency.neighbours(v)) {
                    sum += before.col(w);
                    weights += 1.0;
                }
                now.col(v) = sum / std::max(weights, 1e-9);
            }
        });
    }
    return now;
}

/// Teeth move as a row with the bone beside them.
void move_teeth(Points& shift, const Skull& skull) {
    for (const auto& [teeth, bone] : {std::pair{BonePart::UpperTeeth, BonePart::Cranium},
                                      std::pair{BonePart::LowerTeeth, BonePart::Mandible}}) {
        Vec3 mean = Vec3::Zero();
        double count = 0.0;
        for (int v = 0; v < skull.mesh.vertex_count(); ++v) {
            const Vec3 p = skull.mesh.vertices.col(v);
            if (skull.part[v] == bone && p.z() > 60.0 && std::abs(p.y() + 52.0) < 14.0) {
                mean += shift.col(v);
                count += 1.0;
            }
        }
        mean /= std::max(count, 1.0);
        for (int v = 0; v < skull.mesh.vertex_count(); ++v) {
            if (skull.part[v] == teeth) {
                shift.col(v) = mean;
            }
        }
    }
}

/// Vertices of the scan's loose parts that lie in the lower half of the mouth.
std::vector<int> lower_mouth_parts(const FaceModel& face,
                                   const std::function<Vec3(const Vec3&)>& from_generic) {
    const Scan& scan = *face.scan;
    const auto parts = scan.findings.parts.size();
    if (scan.triangle_part.empty() || parts < 2 || face.skin.part < 0) {
        return {};
    }
    std::vector<Vec3> sum(parts, Vec3::Zero());
    std::vector<double> count(parts, 0.0);
    for (int t = 0; t < scan.mesh.triangle_count(); ++t) {
        const int part = scan.triangle_part[static_cast<std::size_t>(t)];
        if (part >= 0) {
            sum[static_cast<std::size_t>(part)] += scan.mesh.corner(t, 0);
            count[static_cast<std::size_t>(part)] += 1.0;
        }
    }
    // The place between the rows of teeth, in this face's axes.
    const Vec3 middle = from_generic({0.0, -51.4, 75.0});
    std::vector<char> lower(parts, 0);
    for (std::size_t part = 0; part < parts; ++part) {
        if (static_cast<int>(part) == face.skin.part || count[part] == 0.0) {
            continue;
        }
        const Vec3 off =
            face.to_generic.scale * (face.axes.transpose() * (sum[part] / count[part] - middle));
        lower[part] = std::abs(off.x()) < 36.0 && off.y() < 0.0 && off.y() > -25.0 &&
                      off.z() > -50.0 && off.z() < 28.0;
    }
    std::vector<char> taken(static_cast<std::size_t>(scan.mesh.vertex_count()), 0);
    std::vector<int> vertices;
    for (int t = 0; t < scan.mesh.triangle_count(); ++t) {
        const int part = scan.triangle_part[static_cast<std::size_t>(t)];
        if (part < 0 || lower[static_cast<std::size_t>(part)] == 0) {
            continue;
        }
        for (int c = 0; c < 3; ++c) {
            const int v = scan.mesh.triangles(c, t);
            if (taken[static_cast<std::size_t>(v)] == 0 && face.skin.between(0, v) < 0) {
                taken[static_cast<std::size_t>(v)] = 1;
                vertices.push_back(v);
            }
        }
    }
    return vertices;
}

}  // namespace

void place_skull(FaceModel& face, const std::function<Vec3(const Vec3&)>& from_generic,
                 TissueThickness thickness) {
    const Skull& skull = generic_skull();
    const int n = skull.mesh.vertex_count();
    face.bone = skull.mesh;
    face.bone_part = skull.part;
    Points skin(3, n);
    parallel_for(n, 128, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            face.bone.vertices.col(v) = from_generic(skull.mesh.vertices.col(v));
            skin.col(v) = from_generic(skull.skin.col(v));
        }
    });
    static const Adjacency kAdjacency(generic_skull().mesh);
    Shifts shifts = follow_skin(face, skull, skin);
    thicken(shifts, face.bone.vertices, skin, thickness);
    Points shift = smoothed(shifts, kAdjacency);
    move_teeth(shift, skull);
    face.bone.vertices += shift;

    const JawHinge generic = generic_jaw_hinge();
    const Vec3 left = from_generic(generic.centre + Vec3(50.5, 0, 0));
    const Vec3 right = from_generic(generic.centre - Vec3(50.5, 0, 0));
    face.jaw = generic;
    face.jaw.centre = 0.5 * (left + right);
    face.jaw.axis = (left - right).normalized();
    face.jaw.slide = face.axes * generic.slide / face.to_generic.scale;
    const Vec3 front = face.axes.col(2);
    face.jaw.front = (front - front.dot(face.jaw.axis) * face.jaw.axis).normalized();
    face.jaw.full_thrust = generic.full_thrust / face.to_generic.scale;
    face.jaw.to_condyle = 0.5 * (left - right).norm();

    const Vec3 eye = generic_eye_centre();
    face.eyes.resize(3, 2);
    face.eyes.col(0) = from_generic(eye);
    face.eyes.col(1) = from_generic({-eye.x(), eye.y(), eye.z()});
    face.jaw_vertices = lower_mouth_parts(face, from_generic);
}

}  // namespace myoface
