// SPDX-License-Identifier: Apache-2.0
#include "muscle_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "myoface/base/parallel.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/cut.h"
#include "myoface/mesh/normals.h"

namespace myoface {
namespace {

constexpr int kParts = 8;                // of a linear muscle's chain
constexpr double kInsertionDepth = 0.3;  // of the tissue's depth
constexpr double kRingDepth = 0.35;

bool inner(const FaceModel& face, int node) {
    const TissueProperties& tissue = face.tissue[static_cast<std::size_t>(node)];
    return tissue.tissue != Tissue::Skin && tissue.region != Region::Ear;
}

/// The scan without mouth bag and nostrils.
TriangleMesh outer_skin(const FaceModel& face) {
    const TriangleMesh& skin = face.skin.mesh;
    TriangleMesh outer{skin.vertices, Triangles(3, skin.triangle_count())};
    Eigen::Index count = 0;
    for (int t = 0; t < skin.triangle_count(); ++t) {
        const auto v = skin.triangles.col(t);
        if (!inner(face, v[0]) && !inner(face, v[1]) && !inner(face, v[2])) {
            outer.triangles.col(count++) = v;
        }
    }
    outer.triangles.conservativeResize(3, count);
    return outer;
}

struct SkinSurface {
    const FaceModel& face;
    const TriangleMesh& outer;
    const Bvh& bvh;
    const Points& normals;
};

/// Point under the skin nearest to `wanted`, at a share of the tissue's depth.
struct UnderSkin {
    Vec3 point, outward;
};
UnderSkin under_skin(const SkinSurface& skin, const Vec3& wanted, double depth_share) {
    const ClosestPoint hit = skin.bvh.closest_point(skin.outer, wanted);
    Vec3 normal = Vec3::Zero();
    double depth = 0.0;
    for (int c = 0; c < 3; ++c) {
        const int v = skin.outer.triangles(c, hit.where.triangle);
        normal += hit.where.weights[c] * skin.normals.col(v);
        depth += hit.where.weights[c] * skin.face.tissue[static_cast<std::size_t>(v)].depth;
    }
    normal.normalize();
    return {hit.point - depth_share * depth * normal, normal};
}

Points resampled(const Points& path, int parts) {
    std::vector<double> along{0.0};
    for (Eigen::Index i = 1; i < path.cols(); ++i) {
        along.push_back(along.back() + (path.col(i) - path.col(i - 1)).norm());
    }
    Points result(3, parts + 1);
    for (int k = 0; k <= parts; ++k) {
        const double at = along.back() * k / parts;
        std::size_t i = 1;
        while (i + 1 < along.size() && along[i] < at) {
            ++i;
        }
        const double span = along[i] - along[i - 1];
        const double share = span > 0.0 ? std::clamp((at - along[i - 1]) / span, 0.0, 1.0) : 0.0;
        const auto column = static_cast<Eigen::Index>(i);
        result.col(k) = path.col(column - 1) + share * (path.col(column) - path.col(column - 1));
    }
    return result;
}

/// Muscles run straight: irons out what the skin over them has of its own.
void even_out(Points& path) {
    for (int pass = 0; pass < 2; ++pass) {
        const Points before = path;
        for (Eigen::Index k = 1; k + 1 < path.cols(); ++k) {
            path.col(k) = 0.5 * before.col(k) + 0.25 * (before.col(k - 1) + before.col(k + 1));
        }
    }
}

double path_length(const Points& path, bool closed) {
    double length = 0.0;
    for (Eigen::Index i = 1; i < path.cols(); ++i) {
        length += (path.col(i) - path.col(i - 1)).norm();
    }
    if (closed) {
        length += (path.col(0) - path.col(path.cols() - 1)).norm();
    }
    return length;
}

/// Plane, centre and semi-axes of a ring. The ellipse is that of the whole muscle: orbicularis oris
/// upper and lower share theirs.
void measure_ring(const FaceModel& face, Muscle& muscle, const Points& outline) {
    muscle.centre = outline.rowwise().mean();
    const Points centred = outline.colwise() - muscle.centre;
    const Eigen::JacobiSVD<Points> svd(centred, Eigen::ComputeThinU);
    const Vec3 front = face.axes.col(2);
    muscle.axis = svd.matrixU().col(2);
    if (muscle.axis.dot(front) < 0.0) {
        muscle.axis = -muscle.axis;
    }
    const Vec3 left = face.axes.col(0);
    muscle.wide = (left - left.dot(muscle.axis) * muscle.axis).normalized();
    const Vec3 high = muscle.axis.cross(muscle.wide);
    muscle.half_width = (muscle.wide.transpose() * centred).cwiseAbs().maxCoeff();
    muscle.half_height = (high.transpose() * centred).cwiseAbs().maxCoeff();
}

}  // namespace

void place_muscles(FaceModel& face, const Points& smooth_normals,
                   const std::function<Vec3(const Vec3&)>& from_generic) {
    const auto warped = [&](const Points& path) {
        Points result(3, path.cols());
        for (Eigen::Index i = 0; i < path.cols(); ++i) {
            result.col(i) = from_generic(path.col(i));
        }
        return result;
    };
    const TriangleMesh outer = outer_skin(face);
    const Bvh bvh(outer);
    const SkinSurface skin{face, outer, bvh, smooth_normals};
    for (const AtlasMuscle& entry : muscle_atlas()) {
        Muscle muscle;
        muscle.traits = entry.traits;
        const Points path = warped(entry.path);
        if (entry.traits.kind == MuscleKind::Linear) {
            const Points even = resampled(path, kParts);
            muscle.path.resize(3, kParts + 1);
            muscle.outward.resize(3, kParts + 1);
            for (int k = 0; k <= kParts; ++k) {
                const double share = static_cast<double>(k) / kParts;
                // Leaves the bone quickly, then runs under the skin.
                const double depth =
                    kInsertionDepth + (1.0 - kInsertionDepth) * std::pow(1.0 - share, 2.0);
                const UnderSkin place = under_skin(skin, even.col(k), depth);
                muscle.path.col(k) = place.point;
                muscle.outward.col(k) = place.outward;
            }
            even_out(muscle.path);
            muscle.length = path_length(muscle.path, false);
        } else {
            muscle.path.resize(3, path.cols());
            muscle.outward.resize(3, path.cols());
            for (Eigen::Index i = 0; i < path.cols(); ++i) {
                const UnderSkin place = under_skin(skin, path.col(i), kRingDepth);
                muscle.path.col(i) = place.point;
                muscle.outward.col(i) = place.outward;
            }
            muscle.length = path_length(muscle.path, true);
            Points outline = muscle.path;
            if (entry.traits.zone != MuscleZone::All) {  // the other half of the ring
                Points other = entry.path;
                const double line = -52.0;
                other.row(1) = (2.0 * line - other.row(1).array()).matrix();
                const Points mirrored = warped(other);
                outline.conservativeResize(3, 2 * path.cols());
                for (Eigen::Index i = 0; i < mirrored.cols(); ++i) {
                    outline.col(path.cols() + i) =
                        under_skin(skin, mirrored.col(i), kRingDepth).point;
                }
            }
            measure_ring(face, muscle, outline);
        }
        face.muscles.push_back(std::move(muscle));
    }
}

void label_skin(FaceModel& face) {
    constexpr double kMargin = 2.5;  // a muscle also acts on the skin beside it [mm]
    const Points& vertices = face.skin.mesh.vertices;
    face.label.resize(static_cast<std::size_t>(face.node_count()));
    parallel_for(face.node_count(), 256, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const TissueProperties& tissue = face.tissue[v];
            TissueLabel label{tissue.tissue, -1};
            double nearest = std::numeric_limits<double>::infinity();
            const Vec3 p = vertices.col(v);
            for (std::size_t m = 0; m < face.muscles.size(); ++m) {
                const Muscle& muscle = face.muscles[m];
                const double reach = 0.5 * muscle.traits.breadth + kMargin;
                const Eigen::Index points = muscle.path.cols();
                const bool closed = muscle.traits.kind == MuscleKind::Sphincter;
                for (Eigen::Index i = closed ? 0 : 1; i < points; ++i) {
                    const Vec3 a = muscle.path.col((i + points - 1) % points);
                    const Vec3 b = muscle.path.col(i);
                    const Vec3 ab = b - a;
                    const double t =
                        std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
                    // Sideways only: depth under the skin does not count.
                    Vec3 off = p - a - t * ab;
                    off -= off.dot(face.sliding[v].normal) * face.sliding[v].normal;
                    const double distance = off.norm();
                    const bool above = (p - a - t * ab).norm() < reach + tissue.depth;
                    if (above && distance < reach && distance < nearest - 1e-9) {
                        nearest = distance;
                        label.muscle = static_cast<int>(m);
                    }
                }
            }
            face.label[v] = label;
        }
    });
}

TriangleMesh bone_surface(const FaceModel& face, const SmoothFace& smooth) {
    const TriangleMesh& skin = face.skin.mesh;
    TriangleMesh bone;
    bone.vertices.resize(3, skin.vertex_count());
    for (int v = 0; v < skin.vertex_count(); ++v) {
        bone.vertices.col(v) =
            smooth.vertices.col(v) -
            face.tissue[static_cast<std::size_t>(v)].depth * smooth.normals.col(v);
    }
    // Above 0 where there is bone to show: cut along smooth lines, not along triangles.
    std::vector<double> solid(static_cast<std::size_t>(skin.vertex_count()));
    for (int v = 0; v < skin.vertex_count(); ++v) {
        const Vec3 p = face.generic.col(v);
        const double x = std::abs(p.x());
        const double ear = (Vec3(x, p.y(), p.z()) - Vec3(76.0, 3.0, -18.0)).norm() / 27.0 - 1.0;
        const double neck = (p.y() + 74.0 + 0.42 * (p.z() - 10.0)) / 20.0;
        double value = std::min(ear, neck);
        if (p.z() > 40.0) {
            const double orbit = std::hypot((x - 31.0) / 19.0, (p.y() - 17.0) / 15.5);
            const double narrow = std::max(13.0 - 0.30 * (p.y() + 18.0), 2.0);
            const double nose = std::hypot(x / narrow, (p.y() + 16.0) / 19.0);
            const double mouth = std::hypot(x / 25.0, (p.y() + 52.0) / 6.0);
            value = std::min({value, orbit - 1.0, nose - 1.0, mouth - 1.0});
        }
        solid[v] = value;
    }
    bone.triangles = skin.triangles;
    SplitMesh cut = split_along_zero(
        bone, solid, std::vector<bool>(static_cast<std::size_t>(skin.vertex_count()), true));
    bone.vertices = cut.mesh.vertices;
    std::vector<Eigen::Vector3i> kept;
    for (int t = 0; t < cut.mesh.triangle_count(); ++t) {
        bool gone = false;
        for (const int v : cut.mesh.triangles.col(t)) {
            gone = gone || cut.values[v] < 0.0 || (v < skin.vertex_count() && inner(face, v));
        }
        if (!gone) {
            kept.emplace_back(cut.mesh.triangles.col(t));
        }
    }
    bone.triangles.resize(3, static_cast<Eigen::Index>(kept.size()));
    for (std::size_t t = 0; t < kept.size(); ++t) {
        bone.triangles.col(static_cast<Eigen::Index>(t)) = kept[t];
    }
    return bone;
}

}  // namespace myoface
