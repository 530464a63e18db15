// SPDX-License-Identifier: Apache-2.0
#include "head_openings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/cut.h"
#include "myoface/mesh/remesh.h"

namespace myoface {
namespace {

/// The lower lip's border lies this far below the upper's: borders at the same place would be taken
/// for a seam and joined again.
constexpr double kLipGap = 0.02;

Vec3 nearest_on(const std::vector<Vec3>& line, const Vec3& p) {
    Vec3 best = line.front();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec3 ab = line[i + 1] - line[i];
        const double t = std::clamp((p - line[i]).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
        const Vec3 q = line[i] + t * ab;
        if ((p - q).squaredNorm() < least) {
            least = (p - q).squaredNorm();
            best = q;
        }
    }
    return best;
}

/// Drops vertices that no triangle uses.
CutHead compact(const CutHead& head) {
    CutHead result;
    std::vector<int> number(static_cast<std::size_t>(head.mesh.vertex_count()), -1);
    int count = 0;
    result.mesh.triangles = head.mesh.triangles;
    for (Eigen::Index t = 0; t < head.mesh.triangles.cols(); ++t) {
        for (int c = 0; c < 3; ++c) {
            int& n = number[static_cast<std::size_t>(head.mesh.triangles(c, t))];
            n = n < 0 ? count++ : n;
            result.mesh.triangles(c, t) = n;
        }
    }
    result.mesh.vertices.resize(3, count);
    result.lines.resize(static_cast<std::size_t>(count));
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] >= 0) {
            result.mesh.vertices.col(number[v]) =
                head.mesh.vertices.col(static_cast<Eigen::Index>(v));
            result.lines[static_cast<std::size_t>(number[v])] = head.lines[v];
        }
    }
    return result;
}

template <typename Line>
SplitMesh split_on_line(const TriangleMesh& mesh, const HeadField& head, const Line& line,
                        const std::vector<bool>& part_of) {
    std::vector<double> values(static_cast<std::size_t>(mesh.vertex_count()), 1.0);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (part_of[v]) {
            const double value = line(head.in_primitives(mesh.vertices.col(v)));
            // Never exactly on it: each side keeps whole triangles.
            values[v] = std::abs(value) < 1e-6 ? 1e-6 : value;
        }
    }
    return split_along_zero(mesh, values, part_of);
}

CutHead cut_eye(const TriangleMesh& closed, const HeadField& head, const OpeningCurves& curves) {
    const auto line = [&](const Vec3& q) {
        return std::max(q.y() - head.upper_lid(q.x()), head.lower_lid(q.x()) - q.y());
    };
    std::vector<bool> front(static_cast<std::size_t>(closed.vertex_count()));
    for (int v = 0; v < closed.vertex_count(); ++v) {
        const Vec3 q = head.in_primitives(closed.vertices.col(v));
        front[v] = q.z() > 60.0 && q.x() > HeadField::kInnerCanthus - 1.5 &&
                   q.x() < HeadField::kOuterCanthus + 1.5 && std::abs(q.y() - 17.0) < 14.0;
    }
    const SplitMesh split = split_on_line(closed, head, line, front);
    MeshBuilder builder(split.mesh);
    std::erase_if(builder.triangles, [&](const Eigen::Vector3i& t) {
        bool inside = true;
        Vec3 centre = Vec3::Zero();
        for (const int v : t) {
            inside = inside && split.values[v] <= 0.0;
            centre += builder.vertices[v] / 3.0;
        }
        return inside && line(head.in_primitives(centre)) < 0.0;
    });
    CutHead open{builder.mesh(), std::vector<int>(builder.vertices.size(), kFreeVertex)};
    const Adjacency adjacency(open.mesh);
    for (const auto& loop : boundary_loops(open.mesh, adjacency)) {
        const bool eye = std::none_of(loop.begin(), loop.end(),
                                      [&](int v) { return open.mesh.vertices(0, v) == 0.0; });
        if (!eye) {
            for (const int v : loop) {
                open.lines[v] = kMidline;
            }
            continue;
        }
        int inner = loop[0];
        int outer = loop[0];
        for (const int v : loop) {
            const Vec3 p = open.mesh.vertices.col(v);
            const Vec3 up = curves.nearest(p, kUpperLid);
            const Vec3 low = curves.nearest(p, kLowerLid);
            open.lines[v] = (p - up).norm() < (p - low).norm() ? kUpperLid : kLowerLid;
            inner = p.x() < open.mesh.vertices(0, inner) ? v : inner;
            outer = p.x() > open.mesh.vertices(0, outer) ? v : outer;
        }
        for (const int v : loop) {
            open.mesh.vertices.col(v) = curves.nearest(open.mesh.vertices.col(v), open.lines[v]);
        }
        open.mesh.vertices.col(inner) = curves.inner_canthus();
        open.mesh.vertices.col(outer) = curves.outer_canthus();
        open.lines[inner] = open.lines[outer] = kPinnedVertex;
    }
    return compact(open);
}

/// Vertices of the split line from the midline to the mouth's corner.
std::vector<int> lip_chain(const SplitMesh& split, const std::vector<bool>& mouth) {
    std::map<int, std::vector<int>> along;
    const auto on_line = [&](int v) {
        return split.values[v] == 0.0 && (static_cast<std::size_t>(v) >= mouth.size() || mouth[v]);
    };
    const Adjacency adjacency(split.mesh);
    for (const MeshEdge& edge : adjacency.edges()) {
        if (on_line(edge.vertices[0]) && on_line(edge.vertices[1])) {
            along[edge.vertices[0]].push_back(edge.vertices[1]);
            along[edge.vertices[1]].push_back(edge.vertices[0]);
        }
    }
    std::vector<int> chain;
    for (const auto& [v, next] : along) {
        if (split.mesh.vertices(0, v) == 0.0 &&
            (chain.empty() || split.mesh.vertices(2, v) > split.mesh.vertices(2, chain[0]))) {
            chain.assign(1, v);
        }
    }
    while (!chain.empty()) {
        int best = -1;
        for (const int w : along[chain.back()]) {
            if (split.mesh.vertices(0, w) > split.mesh.vertices(0, chain.back()) + 1e-9 &&
                (best < 0 || split.mesh.vertices(0, w) < split.mesh.vertices(0, best))) {
                best = w;
            }
        }
        if (best < 0) {
            break;
        }
        chain.push_back(best);
    }
    return chain;
}

CutHead cut_mouth(const CutHead& closed, const HeadField& head, const OpeningCurves& curves) {
    const auto line = [&](const Vec3& q) { return q.y() - head.lip_line(q.x()); };
    std::vector<bool> mouth(static_cast<std::size_t>(closed.mesh.vertex_count()));
    for (int v = 0; v < closed.mesh.vertex_count(); ++v) {
        const Vec3 q = head.in_primitives(closed.mesh.vertices.col(v));
        mouth[v] = q.z() > 70.0 && q.x() < HeadField::kMouthCorner && std::abs(q.y() + 52.0) < 8.0;
    }
    const SplitMesh split = split_on_line(closed.mesh, head, line, mouth);
    const std::vector<int> chain = lip_chain(split, mouth);
    MeshBuilder builder(split.mesh);
    std::vector<int> lines = closed.lines;
    lines.resize(builder.vertices.size(), kFreeVertex);
    std::map<int, int> twin;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const int v = chain[i];
        Vec3& p = builder.vertices[static_cast<std::size_t>(v)];
        if (i + 1 == chain.size()) {
            p = curves.mouth_corner();
            lines[v] = kPinnedVertex;
            break;
        }
        p = i == 0 ? curves.mid_lips() : curves.nearest(p, kUpperLip);
        lines[v] = i == 0 ? kPinnedVertex : kUpperLip;
        twin[v] = builder.add(p - Vec3(0.0, kLipGap, 0.0));
        lines.push_back(i == 0 ? kPinnedVertex : kLowerLip);
    }
    for (Eigen::Vector3i& t : builder.triangles) {
        const Vec3 centre =
            (builder.vertices[t[0]] + builder.vertices[t[1]] + builder.vertices[t[2]]) / 3.0;
        const double side = line(head.in_primitives(centre));
        for (int& v : t) {
            const auto found = twin.find(v);
            if (side < 0.0 && found != twin.end()) {
                v = found->second;
            }
        }
    }
    return {builder.mesh(), lines};
}

/// Evens out the free vertices around points to which a border vertex was pulled: triangles that
/// the pull turned over come right again.
void untangle_near(CutHead& half, const HeadField& head, const std::vector<Vec3>& places) {
    constexpr double kReach = 9.0;  // [mm]
    constexpr int kRounds = 25;
    const Adjacency adjacency(half.mesh);
    std::vector<int> near;
    for (int v = 0; v < half.mesh.vertex_count(); ++v) {
        const bool close = std::any_of(places.begin(), places.end(), [&](const Vec3& place) {
            return (half.mesh.vertices.col(v) - place).norm() < kReach;
        });
        if (close && half.lines[v] == kFreeVertex) {
            near.push_back(v);
        }
    }
    for (int round = 0; round < kRounds; ++round) {
        for (const int v : near) {
            Vec3 sum = Vec3::Zero();
            for (const int w : adjacency.neighbours(v)) {
                sum += half.mesh.vertices.col(w);
            }
            half.mesh.vertices.col(v) =
                head.onto_surface(sum / static_cast<double>(adjacency.neighbours(v).size()));
        }
    }
}

/// The border vertices of given lines, in the order in which their loop runs.
std::vector<int> border_run(const CutHead& half, int one, int other) {
    const Adjacency adjacency(half.mesh);
    for (const auto& loop : boundary_loops(half.mesh, adjacency)) {
        const auto wanted = [&](int v) { return half.lines[v] == one || half.lines[v] == other; };
        if (std::none_of(loop.begin(), loop.end(), wanted)) {
            continue;
        }
        if (one == kUpperLid) {
            return loop;
        }
        // The lips are a stretch of the midline's loop: from pinned to pinned vertex.
        const auto n = static_cast<std::ptrdiff_t>(loop.size());
        const auto at = [&](std::ptrdiff_t i) {
            return loop[static_cast<std::size_t>((i + n) % n)];
        };
        std::ptrdiff_t first = 0;
        while (!(wanted(at(first)) && half.lines[at(first - 1)] == kPinnedVertex &&
                 half.mesh.vertices(0, at(first - 1)) == 0.0)) {
            ++first;
        }
        std::vector<int> run{at(first - 1)};
        for (std::ptrdiff_t i = first;; ++i) {
            run.push_back(at(i));
            if (half.lines[at(i)] == kPinnedVertex && half.mesh.vertices(0, at(i)) == 0.0) {
                return run;
            }
        }
    }
    return {};
}

}  // namespace

OpeningCurves::OpeningCurves(const HeadField& head) {
    constexpr int kPoints = 160;
    const auto trace = [&](std::vector<Vec3>& line, double from, double to, auto&& height) {
        for (int i = 0; i <= kPoints; ++i) {
            const double x = from + (to - from) * i / kPoints;
            line.push_back(head.front_point_at(x, height(x)));
        }
    };
    trace(upper_lid_, HeadField::kInnerCanthus, HeadField::kOuterCanthus,
          [&](double x) { return head.upper_lid(x); });
    trace(lower_lid_, HeadField::kInnerCanthus, HeadField::kOuterCanthus,
          [&](double x) { return head.lower_lid(x); });
    trace(lips_, 0.0, HeadField::kMouthCorner, [&](double x) { return head.lip_line(x); });
    lips_.front().x() = 0.0;
    lower_lid_.front() = upper_lid_.front();
    lower_lid_.back() = upper_lid_.back();
}

Vec3 OpeningCurves::nearest(const Vec3& p, int line) const {
    switch (line) {
        case kUpperLid:
            return nearest_on(upper_lid_, p);
        case kLowerLid:
            return nearest_on(lower_lid_, p);
        case kUpperLip:
            return nearest_on(lips_, p);
        default:
            return nearest_on(lips_, p + Vec3(0.0, kLipGap, 0.0)) - Vec3(0.0, kLipGap, 0.0);
    }
}

CutHead cut_openings(const TriangleMesh& closed, const HeadField& head,
                     const OpeningCurves& curves) {
    CutHead half = cut_mouth(cut_eye(closed, head, curves), head, curves);
    untangle_near(half, head,
                  {curves.inner_canthus(), curves.outer_canthus(), curves.mouth_corner()});
    return half;
}

int add_lid_margins(MeshBuilder& builder, const CutHead& half, const Vec3& eye_centre) {
    const std::vector<int> loop = border_run(half, kUpperLid, kLowerLid);
    const std::size_t n = loop.size();
    const int first_new = static_cast<int>(builder.vertices.size());
    Vec3 middle = Vec3::Zero();
    for (const int v : loop) {
        middle += builder.vertices[static_cast<std::size_t>(v)] / static_cast<double>(n);
    }
    // Rounded front edge, flat margin, sharp back edge on the eyeball, then the lid's lining.
    constexpr double kOnEye = HeadField::kEyeRadius + 0.3;
    struct Ring {
        double inward;  // share of the way from the skin to the eyeball
        double along;   // towards the opening (+) or under the lid (-) [mm]
    };
    constexpr std::array<Ring, 6> kRings{
        {{0.18, 0.16}, {0.55, 0.20}, {0.96, 0.10}, {1.0, -1.4}, {1.0, -3.4}, {1.0, -6.0}}};
    double left = middle.x();
    double right = middle.x();
    for (const int v : loop) {
        left = std::min(left, builder.vertices[static_cast<std::size_t>(v)].x());
        right = std::max(right, builder.vertices[static_cast<std::size_t>(v)].x());
    }
    std::vector<int> previous = loop;
    std::vector<Vec3> away(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 p = builder.vertices[static_cast<std::size_t>(loop[i])];
        const Vec3 next = builder.vertices[static_cast<std::size_t>(loop[(i + 1) % n])];
        const Vec3 before = builder.vertices[static_cast<std::size_t>(loop[(i + n - 1) % n])];
        const Vec3 out = (p - eye_centre).normalized();
        away[i] = (next - before).cross(out).normalized();
        if (away[i].dot(p - middle) < 0.0) {
            away[i] = -away[i];
        }
    }
    for (const Ring& ring : kRings) {
        std::vector<int> current;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3 p = builder.vertices[static_cast<std::size_t>(loop[i])];
            const Vec3 out = p - eye_centre;
            // The corners are narrow: less way there, or the rings would cross.
            const double width = std::clamp(std::min(p.x() - left, right - p.x()) / 9.0, 0.02, 1.0);
            const double along = ring.along * width;
            const double deep = std::max(kOnEye, out.norm() - 0.8 - 1.6 * width);
            const double radius = out.norm() + ring.inward * (deep - out.norm());
            const Vec3 turned = (out - along * away[i]).normalized();
            current.push_back(builder.add(eye_centre + radius * turned));
        }
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t j = (i + 1) % n;
            builder.add_quad(previous[i], previous[j], current[j], current[i]);
        }
        previous = std::move(current);
    }
    return first_new;
}

int add_mouth_bag(MeshBuilder& builder, const CutHead& half) {
    const std::vector<int> run = border_run(half, kUpperLip, kLowerLip);
    const int first_new = static_cast<int>(builder.vertices.size());
    const auto corner = static_cast<std::size_t>(
        std::max_element(
            run.begin(), run.end(),
            [&](int a, int b) { return builder.vertices[a].x() < builder.vertices[b].x(); }) -
        run.begin());
    const bool upper_first = half.lines[run[1]] == kUpperLip;
    const double width = builder.vertices[run[corner]].x();
    struct Row {
        double depth, height, wider;  // [mm]
    };
    constexpr std::array<Row, 10> kRows{{{1.2, 0.05, -0.3},
                                         {2.6, 0.25, -0.5},
                                         {4.0, 1.0, -0.3},
                                         {5.4, 3.0, 0.8},
                                         {6.6, 7.0, 1.2},
                                         {7.4, 13.0, 2.2},
                                         {9.5, 17.0, 5.0},
                                         {22.0, 19.0, 9.0},
                                         {42.0, 18.0, 13.0},
                                         {58.0, 9.0, 6.0}}};
    std::vector<int> previous = run;
    for (const Row& row : kRows) {
        std::vector<int> current;
        for (std::size_t i = 0; i < run.size(); ++i) {
            const Vec3 p = builder.vertices[run[i]];
            const double u = std::min(p.x() / width, 1.0);
            // Round behind the teeth, thin towards the corner of the lips.
            const double roundness = row.height < 2.0 ? 1.0 : row.depth < 15.0 ? 0.55 : 0.28;
            const double high = row.height * std::pow(std::max(1.0 - u * u, 0.0), roundness);
            const bool upper = i == corner ? false : (i < corner) == upper_first;
            const double sign = i == corner ? 0.0 : upper ? 1.0 : -1.0;
            current.push_back(
                builder.add({u * (width + row.wider),
                             p.y() + sign * (upper || row.depth > 15.0 ? 1.0 : 0.6) * high,
                             p.z() - row.depth * (1.0 + 0.25 * u * u)}));
        }
        for (std::size_t i = 0; i + 1 < run.size(); ++i) {
            builder.add_quad(previous[i], previous[i + 1], current[i + 1], current[i]);
        }
        previous = std::move(current);
    }
    // Back wall: zipped from the corner to the midline.
    std::size_t a = corner;
    std::size_t b = corner;
    while (a > 0 || b + 1 < run.size()) {
        const std::size_t next_a = a > 0 ? a - 1 : 0;
        const std::size_t next_b = std::min(b + 1, run.size() - 1);
        if (next_b != b && (a != b || next_a == a)) {
            builder.triangles.emplace_back(previous[a], previous[b], previous[next_b]);
        }
        if (next_a != a) {
            builder.triangles.emplace_back(previous[next_a], previous[a], previous[next_b]);
        }
        a = next_a;
        b = next_b;
    }
    return first_new;
}

}  // namespace myoface
