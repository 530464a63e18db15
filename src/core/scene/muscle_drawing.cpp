// SPDX-License-Identifier: Apache-2.0
#include "myoface/scene/muscle_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "myoface/scene/colour_map.h"

namespace myoface {
namespace {

constexpr int kSides = 6;               // of a strand
constexpr int kPerPart = 3;             // rings per part of a chain
constexpr double kStrand = 2.1;         // [mm] wanted breadth of one strand
constexpr double kHalfThickness = 1.0;  // of a flat muscle [mm]

/// Catmull-Rom through points.
std::vector<Vec3> smooth_line(const std::vector<Vec3>& through, bool closed) {
    const auto n = static_cast<int>(through.size());
    const auto at = [&](int i) -> const Vec3& {
        return through[static_cast<std::size_t>(closed ? (i % n + n) % n
                                                       : std::clamp(i, 0, n - 1))];
    };
    std::vector<Vec3> line;
    const int spans = closed ? n : n - 1;
    for (int span = 0; span < spans; ++span) {
        for (int k = 0; k < kPerPart; ++k) {
            const double t = static_cast<double>(k) / kPerPart;
            line.push_back(
                0.5 *
                (2.0 * at(span) + t * (at(span + 1) - at(span - 1)) +
                 t * t * (2.0 * at(span - 1) - 5.0 * at(span) + 4.0 * at(span + 1) - at(span + 2)) +
                 t * t * t * (3.0 * at(span) - at(span - 1) - 3.0 * at(span + 1) + at(span + 2))));
        }
    }
    if (!closed) {
        line.push_back(through.back());
    }
    return line;
}

Vec3 tangent(const std::vector<Vec3>& line, int i, bool closed) {
    const auto n = static_cast<int>(line.size());
    const auto before = static_cast<std::size_t>(closed ? (i + n - 1) % n : std::max(i - 1, 0));
    const auto after = static_cast<std::size_t>(closed ? (i + 1) % n : std::min(i + 1, n - 1));
    return (line[after] - line[before]).normalized();
}

/// One strand as a tube of changing width.
struct Strand {
    std::vector<Vec3> line, outward;
    std::vector<double> breadth, thickness;  ///< half of them, per point [mm]
    bool closed = false;
};

class Drawing {
public:
    explicit Drawing(bool with_indices) : with_indices_(with_indices) {}

    void add(const Strand& strand, const Vec3& colour) {
        const auto n = static_cast<int>(strand.line.size());
        const auto first = static_cast<std::uint32_t>(positions_.size());
        for (int i = 0; i < n; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const Vec3 along = tangent(strand.line, i, strand.closed);
            Vec3 broad = along.cross(strand.outward[at]);
            broad = broad.norm() > 1e-9 ? broad.normalized() : Vec3(Vec3::UnitX());
            const Vec3 thin = broad.cross(along);
            for (int k = 0; k < kSides; ++k) {
                const double angle = 2.0 * std::numbers::pi * (k + 0.5) / kSides;
                positions_.push_back(strand.line[at] +
                                     strand.breadth[at] * std::cos(angle) * broad +
                                     strand.thickness[at] * std::sin(angle) * thin);
                normals_.push_back((std::cos(angle) / std::max(strand.breadth[at], 0.05) * broad +
                                    std::sin(angle) / std::max(strand.thickness[at], 0.05) * thin)
                                       .normalized());
                if (with_indices_) {
                    const double t = static_cast<double>(i) / (n - 1);
                    const double tendon =
                        strand.closed ? 0.0 : std::max(0.0, 1.0 - 9.0 * std::min(t, 1.0 - t));
                    colours_.push_back(colour + 0.75 * tendon * (Vec3(0.86, 0.80, 0.72) - colour));
                }
            }
        }
        if (!with_indices_) {
            return;
        }
        const int rings = strand.closed ? n : n - 1;
        for (int i = 0; i < rings; ++i) {
            for (int k = 0; k < kSides; ++k) {
                const auto a = first + static_cast<std::uint32_t>(i * kSides + k);
                const auto b = first + static_cast<std::uint32_t>(i * kSides + (k + 1) % kSides);
                const auto c = first + static_cast<std::uint32_t>((i + 1) % n * kSides + k);
                const auto d =
                    first + static_cast<std::uint32_t>((i + 1) % n * kSides + (k + 1) % kSides);
                indices_.insert(indices_.end(), {a, c, b, b, c, d});
            }
        }
    }

    void finish(SurfaceLayer& layer) {
        layer.positions = as_floats(positions_);
        layer.normals = as_floats(normals_);
        if (with_indices_) {
            layer.indices = std::move(indices_);
            layer.colours = as_floats(colours_);
        }
    }

private:
    static FloatPoints as_floats(const std::vector<Vec3>& points) {
        FloatPoints result(3, static_cast<Eigen::Index>(points.size()));
        for (std::size_t i = 0; i < points.size(); ++i) {
            result.col(static_cast<Eigen::Index>(i)) = points[i].cast<float>();
        }
        return result;
    }

    bool with_indices_;
    std::vector<Vec3> positions_, normals_, colours_;
    std::vector<std::uint32_t> indices_;
};

/// Width of a linear muscle along its way: tendons at the ends, belly between.
double belly(double t) {
    return 0.35 + 0.65 * std::pow(std::sin(std::numbers::pi * (0.06 + 0.88 * t)), 0.7);
}

std::vector<Vec3> columns(const Points& points) {
    std::vector<Vec3> list;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        list.emplace_back(points.col(i));
    }
    return list;
}

/// Strands beside a line; a bundle that converges towards both ends, or a ring's band.
void add_bundle(Drawing& drawing, const Muscle& muscle, const std::vector<Vec3>& chain,
                double bulge, const Vec3& base) {
    const bool closed = muscle.traits.kind == MuscleKind::Sphincter;
    const std::vector<Vec3> line = smooth_line(chain, closed);
    const std::vector<Vec3> outward = smooth_line(columns(muscle.outward), closed);
    const int strands =
        std::clamp(static_cast<int>(std::lround(muscle.traits.breadth / kStrand)), 2, 9);
    const double half = 0.5 * muscle.traits.breadth / strands;
    for (int s = 0; s < strands; ++s) {
        Strand strand;
        strand.closed = closed;
        const double off = (s + 0.5) / strands - 0.5;  // of the breadth
        for (std::size_t i = 0; i < line.size(); ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(line.size() - 1);
            const double wide = closed ? 1.0 : belly(t);
            const Vec3 along = tangent(line, static_cast<int>(i), closed);
            const Vec3 broad = along.cross(outward[i]).normalized();
            strand.line.push_back(line[i] + bulge * wide * off * muscle.traits.breadth * broad);
            strand.outward.push_back(outward[i]);
            strand.breadth.push_back(1.12 * bulge * wide * half);
            strand.thickness.push_back(bulge * kHalfThickness * (0.6 + 0.4 * wide));
        }
        drawing.add(strand, (s % 2 == 0 ? 1.06 : 0.90) * base);
    }
}

/// Strands along a sheet's fibres, which go with the muscle's chain.
void add_sheet(Drawing& drawing, const Muscle& muscle, const std::vector<Vec3>& chain, double bulge,
               const Vec3& base) {
    const bool thick = muscle.traits.kind == MuscleKind::Volume;
    const std::size_t n = muscle.fibres.size();
    const std::vector<Vec3> outward = smooth_line(columns(muscle.outward), false);
    constexpr std::size_t kBetween = 2;  // strands per fibre
    for (std::size_t s = 0; s < kBetween * (n - 1) + 1; ++s) {
        const std::size_t f = std::min(s / kBetween, n - 2);
        const double share = static_cast<double>(s - kBetween * f) / kBetween;
        std::vector<Vec3> through;
        std::vector<double> gap;
        for (std::size_t k = 0; k < chain.size(); ++k) {
            const auto column = static_cast<Eigen::Index>(k);
            const Vec3 a = muscle.fibres[f].col(column);
            const Vec3 b = muscle.fibres[f + 1].col(column);
            through.push_back(a + share * (b - a) + chain[k] - Vec3(muscle.path.col(column)));
            gap.push_back((b - a).norm() / kBetween);
        }
        Strand strand;
        strand.line = smooth_line(through, false);
        strand.outward = outward;
        for (std::size_t i = 0; i < strand.line.size(); ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(strand.line.size() - 1);
            strand.breadth.push_back(0.58 * gap[std::min(i / kPerPart, gap.size() - 1)]);
            strand.thickness.push_back(thick ? bulge * 3.2 * belly(t) : bulge * 0.8);
        }
        drawing.add(strand, (s % 2 == 0 ? 1.06 : 0.90) * base);
    }
}

}  // namespace

void draw_muscles(SurfaceLayer& layer, const FaceModel& face,
                  const std::vector<MuscleChain>& chains, const Points& nodes) {
    Drawing drawing(layer.indices.empty());
    for (std::size_t m = 0; m < chains.size(); ++m) {
        const Muscle& muscle = face.muscles[m];
        std::vector<Vec3> chain;
        double length = 0.0;
        for (int k = 0; k < chains[m].node_count; ++k) {
            chain.emplace_back(nodes.col(chains[m].first_node + k));
            if (k > 0) {
                length += (chain.back() - chain[chain.size() - 2]).norm();
            }
        }
        // A bundle that shortens keeps its volume.
        const double bulge = std::sqrt(std::clamp(muscle.length / std::max(length, 1.0), 0.6, 2.5));
        // Left and right of a pair share their colour.
        const int label = static_cast<int>(m) - (muscle.traits.side == Side::Right ? 1 : 0);
        const Vec3 base = 0.80 * Vec3(0.64, 0.21, 0.18) + 0.20 * label_colour(label).cast<double>();
        if (muscle.fibres.empty()) {
            add_bundle(drawing, muscle, chain, bulge, base);
        } else {
            add_sheet(drawing, muscle, chain, bulge, base);
        }
    }
    drawing.finish(layer);
}

std::optional<int> muscle_on_ray(const FaceModel& face, const ViewRay& ray) {
    std::optional<int> found;
    double nearest = 1e30;
    for (std::size_t m = 0; m < face.muscles.size(); ++m) {
        const Muscle& muscle = face.muscles[m];
        const bool closed = muscle.traits.kind == MuscleKind::Sphincter;
        const auto look = [&](const Points& path, double half) {
            for (Eigen::Index i = closed ? 0 : 1; i < path.cols(); ++i) {
                // Points of the span, close enough for a breadth of millimetres.
                const Vec3 a = path.col((i + path.cols() - 1) % path.cols());
                const Vec3 b = path.col(i);
                for (const double t : {0.0, 0.25, 0.5, 0.75}) {
                    const Vec3 off = a + t * (b - a) - ray.origin;
                    const double depth = off.dot(ray.direction);
                    if ((off - depth * ray.direction).norm() < half && depth < nearest) {
                        nearest = depth;
                        found = static_cast<int>(m);
                    }
                }
            }
        };
        if (muscle.fibres.empty()) {
            look(muscle.path, std::max(0.5 * muscle.traits.breadth, 1.5));
        }
        for (const Points& fibre : muscle.fibres) {
            look(fibre,
                 std::max(0.6 * muscle.traits.breadth / static_cast<double>(muscle.fibres.size()),
                          1.5));
        }
    }
    return found;
}

std::string muscle_in_words(const MuscleTraits& traits, bool japanese) {
    const std::string side = traits.side == Side::Middle ? ""
                             : japanese ? (traits.side == Side::Left ? "（左）" : "（右）")
                                        : (traits.side == Side::Left ? ", left" : ", right");
    return (japanese ? traits.title_ja : traits.title) + side + " · " + traits.action_unit + " · " +
           (japanese ? traits.does_ja : traits.does);
}

std::string tissue_in_words(const FaceModel& face, int node, bool japanese) {
    const auto at = static_cast<std::size_t>(node);
    std::string words = region_name(face.tissue[at].region, japanese);
    for (const MuscleWeight& entry : face.muscles_under[at]) {
        const MuscleTraits& traits = face.muscles[static_cast<std::size_t>(entry.muscle)].traits;
        words += " · " + (japanese ? traits.title_ja : traits.title) + " " +
                 std::to_string(static_cast<int>(std::lround(100.0 * entry.weight))) + " %";
    }
    return words;
}

}  // namespace myoface
