// SPDX-License-Identifier: Apache-2.0
// Where furrows form on one face. The lines of the atlas lie on the average head; every skin node
// knows its place there, so a point of a line is a place between three nodes. Distances across a
// furrow are taken on the face itself.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "myoface/base/parallel.h"
#include "myoface/base/smooth_step.h"
#include "myoface/mesh/bvh.h"
#include "myoface/muscle/wrinkle.h"

namespace myoface {
namespace {

constexpr double kStep = 2.0;            // between gauges [mm]
constexpr double kTaper = 0.28;          // of a furrow's length, at either end
constexpr double kFurrowReach = 3.6;     // of a profile, in widths
constexpr double kFarthestFurrow = 8.0;  // of a line from the face on the average head [mm]
constexpr double kFacing = 0.35;         // cosine between a vertex' normal and the furrow's
const Vec3 kBack(1e-7, 1e-7, -1.0);      // into the face, along no axis exactly
constexpr double kSampling = 0.7;        // blur by the triangles, of the distance between vertices

/// The skin on which furrows lie, in the average head's coordinates.
TriangleMesh facing_skin(const FaceModel& face) {
    const Triangles& all = face.skin.mesh.triangles;
    TriangleMesh mesh{face.generic, Triangles(3, all.cols())};
    const auto counts = [&](int node) {
        const TissueProperties& tissue = face.tissue[static_cast<std::size_t>(node)];
        return tissue.tissue == Tissue::Skin && !tissue.fixed && tissue.region != Region::Ear &&
               face.generic(2, node) > 20.0;
    };
    Eigen::Index count = 0;
    for (Eigen::Index t = 0; t < all.cols(); ++t) {
        if (counts(all(0, t)) && counts(all(1, t)) && counts(all(2, t))) {
            mesh.triangles.col(count++) = all.col(t);
        }
    }
    mesh.triangles.conservativeResize(3, count);
    return mesh;
}

/// A point of a Catmull-Rom curve through the columns of `line`.
Vec3 on_curve(const Points& line, double at) {
    const Eigen::Index last = line.cols() - 1;
    const auto i = std::min(static_cast<Eigen::Index>(at), last - 1);
    const double t = at - static_cast<double>(i);
    const Vec3 b = line.col(i);
    const Vec3 c = line.col(i + 1);
    const Vec3 a = i > 0 ? Vec3(line.col(i - 1)) : Vec3(2.0 * b - c);
    const Vec3 d = i + 2 <= last ? Vec3(line.col(i + 2)) : Vec3(2.0 * c - b);
    return 0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                  t * t * t * (3.0 * b - a - 3.0 * c + d));
}

/// Points along a curve, about `step` apart.
Points evenly(const Points& line, double step) {
    constexpr int kFine = 24;  // per piece
    const int fine = kFine * static_cast<int>(line.cols() - 1);
    Points dense(3, fine + 1);
    std::vector<double> length(static_cast<std::size_t>(fine) + 1, 0.0);
    for (int k = 0; k <= fine; ++k) {
        dense.col(k) = on_curve(line, static_cast<double>(k) / kFine);
        if (k > 0) {
            length[k] = length[k - 1] + (dense.col(k) - dense.col(k - 1)).norm();
        }
    }
    const int count = std::max(3, static_cast<int>(std::lround(length.back() / step)) + 1);
    Points result(3, count);
    int k = 0;
    for (int i = 0; i < count; ++i) {
        const double wanted = length.back() * i / (count - 1);
        while (k + 2 < fine + 1 && length[k + 1] < wanted) {
            ++k;
        }
        const double part = (wanted - length[k]) / std::max(length[k + 1] - length[k], 1e-12);
        result.col(i) =
            dense.col(k) + std::clamp(part, 0.0, 1.0) * (dense.col(k + 1) - dense.col(k));
    }
    return result;
}

class Placing {
public:
    explicit Placing(const FaceModel& face) : mesh_(facing_skin(face)), bvh_(mesh_) {}

    /// The gauges of a furrow, or none where the scan does not have the place.
    std::vector<WrinkleMap::Gauge> gauges(int furrow) const {
        const FurrowTraits& traits = furrow_atlas()[static_cast<std::size_t>(furrow)];
        Points line = traits.line;
        for (Eigen::Index i = 0; i < line.cols(); ++i) {
            if (std::isnan(line(2, i))) {
                const auto hit =
                    bvh_.first_hit(mesh_, {Vec3(line(0, i), line(1, i), 300.0), kBack});
                if (!hit) {
                    return {};
                }
                line.col(i) = position(mesh_, hit->where);
            }
        }
        Points samples = evenly(line, kStep);
        Points normals(3, samples.cols());
        for (Eigen::Index i = 0; i < samples.cols(); ++i) {
            const ClosestPoint found = bvh_.closest_point(mesh_, samples.col(i));
            if (found.distance > kFarthestFurrow) {
                return {};
            }
            samples.col(i) = found.point;
            normals.col(i) = double_area_vector(mesh_, found.where.triangle).normalized();
        }
        std::vector<WrinkleMap::Gauge> result;
        const Eigen::Index n = samples.cols();
        for (Eigen::Index i = 0; i < n; ++i) {
            const Eigen::Index before = std::max<Eigen::Index>(i - 1, 0);
            const Eigen::Index after = std::min<Eigen::Index>(i + 1, n - 1);
            const Vec3 normal = normals.col(before) + normals.col(i) + normals.col(after);
            const Vec3 across = normal.cross(samples.col(after) - samples.col(before)).normalized();
            WrinkleMap::Gauge gauge;
            gauge.furrow = furrow;
            gauge.here = place(samples.col(i));
            // A furrow that leans is pushed up from the side of its ridge.
            gauge.low = place(samples.col(i) - (1.0 - traits.lean) * traits.gauge * across);
            gauge.high = place(samples.col(i) + (1.0 + traits.lean) * traits.gauge * across);
            const double along = static_cast<double>(i) / static_cast<double>(n - 1);
            gauge.taper = smooth_step(0.0, kTaper, std::min(along, 1.0 - along));
            result.push_back(gauge);
        }
        return result;
    }

private:
    WrinkleMap::Place place(const Vec3& p) const {
        const SurfacePoint where = bvh_.closest_point(mesh_, p).where;
        WrinkleMap::Place result;
        for (int c = 0; c < 3; ++c) {
            result.node[static_cast<std::size_t>(c)] = mesh_.triangles(c, where.triangle);
        }
        result.weight = where.weights;
        return result;
    }

    TriangleMesh mesh_;
    Bvh bvh_;
};

/// A furrow's line on the face.
struct Line {
    Points at, outward, across;  ///< per gauge
};

Line line_of(const FaceModel& face, const WrinkleMap& map, int begin, int end) {
    const auto count = static_cast<Eigen::Index>(end - begin);
    Line line{Points(3, count), Points(3, count), Points(3, count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const WrinkleMap::Place& here = map.gauges[static_cast<std::size_t>(begin + i)].here;
        line.at.col(i).setZero();
        line.outward.col(i).setZero();
        for (int c = 0; c < 3; ++c) {
            const int node = here.node[static_cast<std::size_t>(c)];
            line.at.col(i) += here.weight[c] * face.skin.mesh.vertices.col(node);
            line.outward.col(i) +=
                here.weight[c] * face.sliding[static_cast<std::size_t>(node)].normal;
        }
        line.outward.col(i).normalize();
    }
    for (Eigen::Index i = 0; i < count; ++i) {
        const Vec3 along = line.at.col(std::min<Eigen::Index>(i + 1, count - 1)) -
                           line.at.col(std::max<Eigen::Index>(i - 1, 0));
        line.across.col(i) = Vec3(line.outward.col(i)).cross(along).normalized();
    }
    return line;
}

/// Height of a profile `off` from its middle, per millimetre of depth, as triangles of this spacing
/// can show it: a ridge on either side holds what the furrow lacks.
double profile(const FurrowTraits& traits, double off, double spacing) {
    const double blur = kSampling * spacing;
    const double width = std::hypot(traits.width, blur);
    const double ratio = traits.width / width;
    const double t = off / width;
    return -ratio * ratio * (ratio * (1.0 - t * t) - traits.lean * t) * std::exp(-0.5 * t * t);
}

/// Segments of furrows by place.
class Neighbourhood {
public:
    struct Segment {
        int furrow, first;  ///< gauge at its beginning
        Vec3 a, b, outward_a, outward_b, across_a, across_b;
        double reach;
    };

    explicit Neighbourhood(std::vector<Segment> segments) : segments_(std::move(segments)) {
        for (const Segment& segment : segments_) {
            box_.extend(Vec3((segment.a.cwiseMin(segment.b).array() - segment.reach).matrix()));
            box_.extend(Vec3((segment.a.cwiseMax(segment.b).array() + segment.reach).matrix()));
        }
        if (segments_.empty()) {
            return;
        }
        size_ =
            (box_.sizes() / kCell).array().ceil().cast<int>().matrix() + Eigen::Vector3i::Ones();
        cells_.resize(static_cast<std::size_t>(size_.prod()));
        for (std::size_t s = 0; s < segments_.size(); ++s) {
            const Segment& segment = segments_[s];
            const Eigen::Vector3i low =
                cell((segment.a.cwiseMin(segment.b).array() - segment.reach).matrix());
            const Eigen::Vector3i high =
                cell((segment.a.cwiseMax(segment.b).array() + segment.reach).matrix());
            for (int z = low.z(); z <= high.z(); ++z) {
                for (int y = low.y(); y <= high.y(); ++y) {
                    for (int x = low.x(); x <= high.x(); ++x) {
                        cells_[index({x, y, z})].push_back(static_cast<int>(s));
                    }
                }
            }
        }
    }

    const std::vector<int>& near(const Vec3& p) const {
        static const std::vector<int> kNoFurrow;
        return segments_.empty() || !box_.contains(p) ? kNoFurrow : cells_[index(cell(p))];
    }
    const Segment& operator[](int s) const { return segments_[static_cast<std::size_t>(s)]; }

private:
    static constexpr double kCell = 5.0;  // [mm]

    Eigen::Vector3i cell(const Vec3& p) const {
        const Eigen::Vector3i at = ((p - box_.min()) / kCell).array().floor().cast<int>().matrix();
        return at.cwiseMax(0).cwiseMin(size_ - Eigen::Vector3i::Ones());
    }
    std::size_t index(const Eigen::Vector3i& c) const {
        return static_cast<std::size_t>((c.z() * size_.y() + c.y()) * size_.x() + c.x());
    }

    std::vector<Segment> segments_;
    Eigen::AlignedBox3d box_;
    Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
    std::vector<std::vector<int>> cells_;
};

struct Entry {
    int gauge;
    float height;
};

/// What the furrows near a vertex do to it.
std::vector<Entry> entries_at(const Neighbourhood& near, const WrinkleMap& map, const Vec3& p,
                              const Vec3& normal, int lip_side, double spacing) {
    std::vector<Entry> entries;
    int furrow = -1;
    double nearest = 0.0;
    std::array<Entry, 2> best{};
    const auto finish = [&] {
        for (const Entry& entry : best) {
            if (furrow >= 0 && std::abs(entry.height) > 1e-4F) {
                entries.push_back(entry);
            }
        }
    };
    for (const int s : near.near(p)) {  // furrow by furrow
        const Neighbourhood::Segment& segment = near[s];
        const FurrowTraits& traits = furrow_atlas()[static_cast<std::size_t>(segment.furrow)];
        if (traits.lip * lip_side < 0) {
            continue;
        }
        const Vec3 along = segment.b - segment.a;
        const double t =
            std::clamp((p - segment.a).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
        const Vec3 outward = ((1.0 - t) * segment.outward_a + t * segment.outward_b).normalized();
        Vec3 off = p - segment.a - t * along;
        off -= off.dot(outward) * outward;
        const double distance = off.norm();
        if (distance > segment.reach || normal.dot(outward) < kFacing) {
            continue;
        }
        if (segment.furrow != furrow) {
            finish();
            furrow = segment.furrow;
            nearest = 1e30;
            best = {};
        }
        if (distance < nearest) {
            nearest = distance;
            const Vec3 across = (1.0 - t) * segment.across_a + t * segment.across_b;
            const double high = profile(traits, std::copysign(distance, off.dot(across)), spacing);
            const auto gauge = static_cast<std::size_t>(segment.first);
            const double taper =
                (1.0 - t) * map.gauges[gauge].taper + t * map.gauges[gauge + 1].taper;
            best = {Entry{segment.first, static_cast<float>((1.0 - t) * taper * high)},
                    Entry{segment.first + 1, static_cast<float>(t * taper * high)}};
        }
    }
    finish();
    return entries;
}

/// About the distance between vertices of the scan, per vertex [mm].
Eigen::VectorXf spacing_of(const TriangleMesh& scan) {
    Eigen::VectorXf area = Eigen::VectorXf::Zero(scan.vertex_count());
    for (int t = 0; t < scan.triangle_count(); ++t) {
        const auto third = static_cast<float>(double_area_vector(scan, t).norm() / 6.0);
        for (int c = 0; c < 3; ++c) {
            area[scan.triangles(c, t)] += third;
        }
    }
    return (1.15F * area.array()).sqrt();
}

void map_vertices(const FaceModel& face, const Neighbourhood& near, WrinkleMap& map) {
    const TriangleMesh& scan = face.scan->mesh;
    const Eigen::VectorXf spacing = spacing_of(scan);
    std::vector<std::vector<Entry>> found(static_cast<std::size_t>(scan.vertex_count()));
    parallel_for(scan.vertex_count(), 2048, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const int node = face.skin.between(0, v);
            if (node < 0) {
                continue;
            }
            const TissueProperties& tissue = face.tissue[static_cast<std::size_t>(node)];
            if (tissue.tissue == Tissue::Skin && !tissue.fixed && tissue.region != Region::Ear) {
                found[v] = entries_at(near, map, scan.vertices.col(v), face.skin.normals.col(node),
                                      face.lip_side[static_cast<std::size_t>(node)],
                                      static_cast<double>(spacing[v]));
            }
        }
    });
    std::vector<char> counts(static_cast<std::size_t>(face.node_count()), 0);
    map.start.push_back(0);
    for (int v = 0; v < scan.vertex_count(); ++v) {
        if (found[static_cast<std::size_t>(v)].empty()) {
            continue;
        }
        map.vertices.push_back(v);
        for (const Entry& entry : found[static_cast<std::size_t>(v)]) {
            map.gauge.push_back(entry.gauge);
            map.height.push_back(entry.height);
        }
        map.start.push_back(static_cast<int>(map.gauge.size()));
        for (int k = 0; k < 3 && face.skin.between(k, v) >= 0; ++k) {
            counts[static_cast<std::size_t>(face.skin.between(k, v))] = 1;
        }
    }
    for (int node = 0; node < face.node_count(); ++node) {
        if (counts[static_cast<std::size_t>(node)] != 0) {
            map.of_node.push_back(node);
        }
    }
}

}  // namespace

std::shared_ptr<const WrinkleMap> map_wrinkles(const FaceModel& face) {
    auto map = std::make_shared<WrinkleMap>();
    const auto furrows = static_cast<int>(furrow_atlas().size());
    std::vector<std::vector<WrinkleMap::Gauge>> gauges(static_cast<std::size_t>(furrows));
    const Placing placing(face);
    parallel_for(furrows, 1, [&](int begin, int end) {
        for (int f = begin; f < end; ++f) {
            gauges[f] = placing.gauges(f);
        }
    });
    map->first.push_back(0);
    for (const auto& of_furrow : gauges) {
        map->gauges.insert(map->gauges.end(), of_furrow.begin(), of_furrow.end());
        map->first.push_back(static_cast<int>(map->gauges.size()));
    }
    std::vector<Neighbourhood::Segment> segments;
    for (int f = 0; f < furrows; ++f) {
        const int begin = map->first[static_cast<std::size_t>(f)];
        const Line line = line_of(face, *map, begin, map->first[static_cast<std::size_t>(f) + 1]);
        const double reach = kFurrowReach * furrow_atlas()[static_cast<std::size_t>(f)].width;
        for (Eigen::Index i = 0; i + 1 < line.at.cols(); ++i) {
            segments.push_back({f, begin + static_cast<int>(i), line.at.col(i), line.at.col(i + 1),
                                line.outward.col(i), line.outward.col(i + 1), line.across.col(i),
                                line.across.col(i + 1), reach});
        }
    }
    map_vertices(face, Neighbourhood(std::move(segments)), *map);
    return map;
}

}  // namespace myoface
