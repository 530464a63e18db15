// SPDX-License-Identifier: Apache-2.0
#include "muscle_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "myoface/base/parallel.h"
#include "myoface/face/generic_face.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/normals.h"

namespace myoface {
namespace {

constexpr int kParts = 8;  // of a linear muscle's chain
constexpr double kRingDepth = 0.35;

bool inner(const FaceModel& face, int node) {
    const TissueProperties& tissue = face.tissue[static_cast<std::size_t>(node)];
    return tissue.tissue != Tissue::Skin && tissue.region != Region::Ear;
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
    for (int pass = 0; pass < 4; ++pass) {
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

namespace {

/// Ironed out across a crease a fibre could come out of the skin. It goes in again as a whole, a
/// bit deeper than it was out: the nearest place under the skin may be on the crease's other side,
/// which would make a kink.
void sink(Points& path, Points outward, const SkinSurface& skin) {
    constexpr int kTimes = 4;
    constexpr double kUnder = 0.25;  // of the tissue's depth
    even_out(outward);
    for (int time = 0; time < kTimes; ++time) {
        Eigen::VectorXd down = Eigen::VectorXd::Zero(path.cols());
        for (Eigen::Index k = 1; k + 2 < path.cols(); ++k) {
            const UnderSkin place = under_skin(skin, path.col(k), kUnder);
            down[k] = std::max(0.0, (Vec3(path.col(k)) - place.point).dot(place.outward));
        }
        if (down.isZero(0.0)) {
            return;
        }
        for (Eigen::Index k = 1; k + 2 < path.cols(); ++k) {
            const double beside = 0.25 * std::max(down[k - 1], down[k + 1]);
            path.col(k) -= std::max(down[k], beside) * outward.col(k).normalized();
        }
    }
}

/// Puts a fibre under the skin: its depth goes from the bone end's to the skin end's share.
struct PlacedFibre {
    Points path, outward;
};
PlacedFibre place_fibre(const SkinSurface& skin, const Points& warped, const AtlasMuscle& entry) {
    const Points even = resampled(warped, kParts);
    PlacedFibre fibre{Points(3, kParts + 1), Points(3, kParts + 1)};
    for (int k = 0; k <= kParts; ++k) {
        const double share = static_cast<double>(k) / kParts;
        // Leaves the bone quickly, then runs under the skin.
        const double depth = entry.insertion_depth + (entry.origin_depth - entry.insertion_depth) *
                                                         std::pow(1.0 - share, 2.0);
        const UnderSkin place = under_skin(skin, even.col(k), depth);
        fibre.path.col(k) = entry.deep && k + 1 < kParts ? Vec3(even.col(k)) : place.point;
        fibre.outward.col(k) = place.outward;
    }
    even_out(fibre.path);
    if (!entry.deep) {
        sink(fibre.path, fibre.outward, skin);
    }
    return fibre;
}

/// Fibres of a sheet: from one edge over the middle to the other.
void place_fibres(Muscle& muscle, const AtlasMuscle& entry, const SkinSurface& skin,
                  const std::function<Points(const Points&)>& warped) {
    constexpr int kFibres = 9;
    if (entry.edges.size() != 2) {
        return;
    }
    const std::array<Points, 3> guide{resampled(entry.edges[0], kParts),
                                      resampled(entry.path, kParts),
                                      resampled(entry.edges[1], kParts)};
    for (int f = 0; f < kFibres; ++f) {
        const double t = 2.0 * f / (kFibres - 1);
        const int side = t < 1.0 ? 0 : 1;
        const Points between = (1.0 - (t - side)) * guide[static_cast<std::size_t>(side)] +
                               (t - side) * guide[static_cast<std::size_t>(side) + 1];
        muscle.fibres.push_back(place_fibre(skin, warped(between), entry).path);
    }
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
        if (entry.traits.kind != MuscleKind::Sphincter) {
            PlacedFibre fibre = place_fibre(skin, warped(entry.path), entry);
            muscle.path = std::move(fibre.path);
            muscle.outward = std::move(fibre.outward);
            muscle.length = path_length(muscle.path, false);
            place_fibres(muscle, entry, skin, warped);
        } else {
            const Points path = warped(entry.path);
            muscle.path.resize(3, path.cols());
            muscle.outward.resize(3, path.cols());
            for (Eigen::Index i = 0; i < path.cols(); ++i) {
                const UnderSkin place = under_skin(skin, path.col(i), kRingDepth);
                muscle.path.col(i) = place.point;
                muscle.outward.col(i) = place.outward;
            }
            muscle.length = path_length(muscle.path, true);
            Points outline = muscle.path;
            if (entry.traits.zone != MuscleZone::All || entry.traits.shares_mouth) {
                // The other half of the ring.
                Points other = entry.path;
                if (entry.traits.shares_mouth) {
                    other.row(0) *= -1.0;
                } else {
                    const double line = generic_landmarks().at("sto").position.y();
                    other.row(1) = (2.0 * line - other.row(1).array()).matrix();
                }
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

namespace {

/// Distance of a skin node from a muscle's line, along the skin only: depth does not count. Beyond
/// `reach` or too deep below: infinite.
double distance_along_skin(const FaceModel& face, int node, const Points& path, bool closed,
                           double reach) {
    const Vec3 p = face.skin.mesh.vertices.col(node);
    const Vec3& normal = face.sliding[static_cast<std::size_t>(node)].normal;
    const double depth = face.tissue[static_cast<std::size_t>(node)].depth;
    double nearest = std::numeric_limits<double>::infinity();
    const Eigen::Index points = path.cols();
    for (Eigen::Index i = closed ? 0 : 1; i < points; ++i) {
        const Vec3 a = path.col((i + points - 1) % points);
        const Vec3 b = path.col(i);
        const Vec3 ab = b - a;
        const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
        const Vec3 off = p - a - t * ab;
        if (off.norm() >= reach + depth) {
            continue;
        }
        nearest = std::min(nearest, (off - off.dot(normal) * normal).norm());
    }
    return nearest < reach ? nearest : std::numeric_limits<double>::infinity();
}

}  // namespace

void label_skin(FaceModel& face) {
    constexpr double kMargin = 2.5;  // a muscle also acts on the skin beside it [mm]
    constexpr std::size_t kMost = 4;
    face.label.resize(static_cast<std::size_t>(face.node_count()));
    face.muscles_under.resize(static_cast<std::size_t>(face.node_count()));
    parallel_for(face.node_count(), 256, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            std::vector<MuscleWeight>& under = face.muscles_under[v];
            for (std::size_t m = 0; m < face.muscles.size(); ++m) {
                const Muscle& muscle = face.muscles[m];
                const bool ring = muscle.traits.kind == MuscleKind::Sphincter;
                double share = 0.0;  // 1 over the muscle's line, 0 at its edge
                if (muscle.fibres.empty()) {
                    const double reach = 0.5 * muscle.traits.breadth + kMargin;
                    share = 1.0 - distance_along_skin(face, v, muscle.path, ring, reach) / reach;
                } else {
                    const double reach = 0.5 * muscle.traits.breadth /
                                             static_cast<double>(muscle.fibres.size() - 1) * 2.0 +
                                         kMargin;
                    for (const Points& fibre : muscle.fibres) {
                        share = std::max(
                            share, 1.0 - distance_along_skin(face, v, fibre, false, reach) / reach);
                    }
                    // A sheet lies under everything else.
                    share *= muscle.traits.kind == MuscleKind::Volume ? 0.3 : 0.6;
                }
                if (muscle.traits.action == MuscleAction::RaiseLid ||
                    muscle.traits.action == MuscleAction::OpenJaw ||
                    muscle.traits.action == MuscleAction::ShiftJaw) {
                    share *= 0.3;  // behind the lid, in the floor of the mouth
                }
                if (share > 0.0) {
                    under.push_back({static_cast<int>(m), share});
                }
            }
            std::stable_sort(under.begin(), under.end(),
                             [](const auto& a, const auto& b) { return a.weight > b.weight; });
            under.resize(std::min(under.size(), kMost));
            double sum = 0.0;
            for (const MuscleWeight& entry : under) {
                sum += entry.weight;
            }
            for (MuscleWeight& entry : under) {
                entry.weight /= sum;
            }
            face.label[v] = {face.tissue[v].tissue, under.empty() ? -1 : under[0].muscle};
        }
    });
}

}  // namespace myoface
