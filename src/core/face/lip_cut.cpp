// SPDX-License-Identifier: Apache-2.0
#include "lip_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "head/head_mesh.h"

namespace myoface {
namespace {

constexpr double kShort = 1.2;       // [mm] the cut ends before the corner of the mouth
constexpr double kBehind = 6.0;      // [mm] what lies further behind the lips' front is no lip
constexpr double kLeast = 0.18;      // share of an edge that the cut keeps from its ends
constexpr double kApart = 1e-4;      // [mm] between the margins, so that they are not welded
constexpr double kWholeMouth = 0.7;  // of the line's length must be grown together

/// How far in front the lips lie along the line between them, per millimetre from the middle.
double lip_front(double x) {
    static const std::vector<double> kFronts = [] {
        std::vector<double> fronts;
        for (int k = 0; k <= static_cast<int>(HeadField::kMouthCorner) + 1; ++k) {
            const double at = std::min<double>(k, HeadField::kMouthCorner);
            fronts.push_back(average_head().front_point(at, average_head().lip_line(at)).z());
        }
        return fronts;
    }();
    const auto k = std::min(static_cast<std::size_t>(x), kFronts.size() - 2);
    const double share = std::clamp(x - static_cast<double>(k), 0.0, 1.0);
    return (1.0 - share) * kFronts[k] + share * kFronts[k + 1];
}

/// Height over the line between the lips of a place on the average head [mm]; nothing off the lips.
std::optional<double> over_line(const Vec3& p) {
    const HeadField& head = average_head();
    const double x = std::abs(p.x());
    if (!p.allFinite() || x > HeadField::kMouthCorner + 8.0) {
        return std::nullopt;
    }
    const double line = head.lip_line(std::min(x, HeadField::kMouthCorner));
    if (std::abs(p.y() - line) > 15.0) {
        return std::nullopt;
    }
    if (p.z() < lip_front(x) - kBehind) {
        return std::nullopt;
    }
    const double height = p.y() - line;
    return height == 0.0 ? 1e-9 : height;
}

/// A vertex that the cut puts on an edge.
struct LineVertex {
    int upper_end = 0, lower_end = 0;  ///< vertices of the scan
    double share = 0.5;                ///< from the upper end
    int triangles = 0, passed = 0;     ///< those at the edge, and those the line goes all through
    int upper = -1, lower = -1;        ///< numbers in the new scan
};

class Parter {
public:
    Parter(const Scan& scan, const Points& generic) : scan_(scan), generic_(generic) {}

    std::optional<PartedLips> run() {
        find_heights();
        find_crossings();
        if (!whole_mouth()) {
            return std::nullopt;
        }
        auto scan = std::make_shared<Scan>(scan_);
        add_vertices(*scan);
        rebuild_faces(*scan);
        scan->triangle_face.clear();
        scan->triangle_corner.clear();
        triangulate(*scan);
        const ScanFindings findings = scan->findings;
        examine(*scan);
        std::vector<ScanPart> parts = std::move(scan->findings.parts);
        scan->findings = findings;
        scan->findings.parts = std::move(parts);
        std::vector<signed char> side = sides();
        return PartedLips{std::move(scan), std::move(new_generic_), std::move(side)};
    }

private:
    using Edge = std::pair<int, int>;

    /// Known for sure: the margins, and the skin beside the line before the corners.
    std::vector<signed char> sides() const {
        std::vector<signed char> side(static_cast<std::size_t>(new_generic_.cols()), 0);
        for (std::size_t v = 0; v < height_.size(); ++v) {
            const double x = std::abs(generic_(0, static_cast<Eigen::Index>(v)));
            if (height_[v] != 0.0 && x < HeadField::kMouthCorner - 2.0 * kShort) {
                side[v] = height_[v] > 0.0 ? 1 : -1;
            }
        }
        for (const auto& [edge, vertex] : line_) {
            if (vertex.upper != vertex.lower) {
                side[static_cast<std::size_t>(vertex.upper)] = 1;
                side[static_cast<std::size_t>(vertex.lower)] = -1;
            }
        }
        return side;
    }

    void find_heights() {
        const int n = scan_.mesh.vertex_count();
        height_.assign(static_cast<std::size_t>(n), 0.0);
        for (int v = 0; v < n; ++v) {
            height_[static_cast<std::size_t>(v)] = over_line(generic_.col(v)).value_or(0.0);
        }
    }

    /// Both ends near the lips, on different sides, and crossed before the corner of the mouth.
    bool crossed(int a, int b) const {
        const double ha = height_[static_cast<std::size_t>(a)];
        const double hb = height_[static_cast<std::size_t>(b)];
        if (ha * hb >= 0.0) {
            return false;
        }
        const double share = std::clamp(ha / (ha - hb), kLeast, 1.0 - kLeast);
        const double x = (1.0 - share) * generic_(0, a) + share * generic_(0, b);
        return std::abs(x) < HeadField::kMouthCorner - kShort;
    }

    static Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

    void find_crossings() {
        for (int t = 0; t < scan_.mesh.triangle_count(); ++t) {
            const Eigen::Vector3i v = scan_.mesh.triangles.col(t);
            const auto on_lips = [&](int corner) {
                return height_[static_cast<std::size_t>(v[corner])] != 0.0;
            };
            if (!on_lips(0) || !on_lips(1) || !on_lips(2)) {
                continue;
            }
            near_.push_back(t);
            std::vector<Edge> here;
            for (int c = 0; c < 3; ++c) {
                if (crossed(v[c], v[(c + 1) % 3])) {
                    here.push_back(edge_of(v[c], v[(c + 1) % 3]));
                }
            }
            for (const Edge& edge : here) {
                LineVertex& vertex = line_[edge];
                if (vertex.triangles == 0) {
                    const bool first_upper = height_[static_cast<std::size_t>(edge.first)] > 0.0;
                    vertex.upper_end = first_upper ? edge.first : edge.second;
                    vertex.lower_end = first_upper ? edge.second : edge.first;
                    const double up = height_[static_cast<std::size_t>(vertex.upper_end)];
                    const double down = height_[static_cast<std::size_t>(vertex.lower_end)];
                    vertex.share = std::clamp(up / (up - down), kLeast, 1.0 - kLeast);
                }
                ++vertex.triangles;
                vertex.passed += here.size() == 2 ? 1 : 0;
            }
        }
    }

    /// Whether skin goes on from lip to lip nearly all the way: open lips are left alone, and those
    /// that only touch.
    bool whole_mouth() const {
        constexpr int kStrips = 9;
        constexpr double kSure = 1.5;  // [mm] over or under the line
        const double half = HeadField::kMouthCorner - 4.0 * kShort;
        const auto n = static_cast<std::size_t>(scan_.mesh.vertex_count());
        int whole = 0;
        std::vector<int> root(n);
        const auto find = [&](int v) {
            while (root[static_cast<std::size_t>(v)] != v) {
                int& up = root[static_cast<std::size_t>(v)];
                up = root[static_cast<std::size_t>(up)];  // halves the way of the next search
                v = up;
            }
            return v;
        };
        for (int strip = 0; strip < kStrips; ++strip) {
            const double at = half * (2.0 * (strip + 0.5) / kStrips - 1.0);
            std::iota(root.begin(), root.end(), 0);
            std::vector<int> seen;
            for (const int t : near_) {
                const Eigen::Vector3i v = scan_.mesh.triangles.col(t);
                const double low =
                    std::min({generic_(0, v[0]), generic_(0, v[1]), generic_(0, v[2])});
                const double high =
                    std::max({generic_(0, v[0]), generic_(0, v[1]), generic_(0, v[2])});
                if (low < at + 3.0 && high > at - 3.0) {
                    for (int c = 0; c < 3; ++c) {
                        root[static_cast<std::size_t>(find(v[c]))] = find(v[(c + 1) % 3]);
                        seen.push_back(v[c]);
                    }
                }
            }
            std::map<int, int> sides;  // of each piece: 1 upper, 2 lower, 3 both
            for (const int v : seen) {
                const double height = height_[static_cast<std::size_t>(v)];
                sides[find(v)] |= height > kSure ? 1 : height < -kSure ? 2 : 0;
            }
            whole += std::any_of(sides.begin(), sides.end(),
                                 [](const auto& piece) { return piece.second == 3; })
                         ? 1
                         : 0;
        }
        return whole >= kWholeMouth * kStrips;
    }

    /// Seams double vertices: those of one place must be parted alike.
    bool inner(const LineVertex& vertex) const {
        return vertex.triangles == vertex.passed &&
               (vertex.triangles >= 2 || !ends_at_border(vertex));
    }
    bool ends_at_border(const LineVertex& vertex) const {
        // A seam's edge has another one in the same place; a true border has none.
        const Vec3 a = scan_.mesh.vertices.col(vertex.upper_end);
        const Vec3 b = scan_.mesh.vertices.col(vertex.lower_end);
        return std::none_of(line_.begin(), line_.end(), [&](const auto& other) {
            return &other.second != &vertex &&
                   Vec3(scan_.mesh.vertices.col(other.second.upper_end)) == a &&
                   Vec3(scan_.mesh.vertices.col(other.second.lower_end)) == b;
        });
    }

    void add_vertices(Scan& scan) {
        int next = scan.mesh.vertex_count();
        std::vector<std::pair<LineVertex*, bool>> added;
        for (auto& [edge, vertex] : line_) {
            vertex.upper = next++;
            added.emplace_back(&vertex, true);
            vertex.lower = vertex.upper;
            if (inner(vertex)) {
                vertex.lower = next++;
                added.emplace_back(&vertex, false);
            }
        }
        const Eigen::Index old = scan.mesh.vertices.cols();
        const auto extend = [&](auto& matrix) {
            if (matrix.cols() != old) {
                return;
            }
            using Column = typename std::decay_t<decltype(matrix)>::Scalar;
            matrix.conservativeResize(Eigen::NoChange, next);
            for (std::size_t k = 0; k < added.size(); ++k) {
                const LineVertex& v = *added[k].first;
                const auto share = static_cast<Column>(v.share);
                matrix.col(old + static_cast<Eigen::Index>(k)) =
                    (Column(1) - share) * matrix.col(v.upper_end) + share * matrix.col(v.lower_end);
            }
        };
        extend(scan.mesh.vertices);
        extend(scan.colours);
        new_generic_ = generic_;
        extend(new_generic_);
        if (scan.alpha.size() == old) {
            scan.alpha.conservativeResize(next);
            scan.alpha.tail(next - old).setOnes();
        }
        // The margins part downwards by a hair.
        for (std::size_t k = 0; k < added.size(); ++k) {
            if (!added[k].second) {
                const LineVertex& v = *added[k].first;
                const Vec3 down =
                    (scan.mesh.vertices.col(v.lower_end) - scan.mesh.vertices.col(v.upper_end))
                        .normalized();
                scan.mesh.vertices.col(old + static_cast<Eigen::Index>(k)) += kApart * down;
            }
        }
        scan.file_vertices.conservativeResize(3, next);
        for (Eigen::Index v = old; v < next; ++v) {
            scan.file_vertices.col(v) = scan.frame.to_file(scan.mesh.vertices.col(v));
        }
    }

    /// A corner of a face that is being split: a vertex with its texture coordinate.
    struct Corner {
        int vertex = 0, uv = -1;
    };

    int uv_between(Scan& scan, int a, int b, double share) {
        if (a < 0 || b < 0) {
            return -1;
        }
        const auto key = std::make_pair(std::min(a, b), std::max(a, b));
        const auto found = uv_.find(key);
        if (found != uv_.end()) {
            return found->second;
        }
        const auto part = static_cast<float>(share);
        const Eigen::Vector2f between = (1.0F - part) * scan.uv.col(a) + part * scan.uv.col(b);
        new_uv_.push_back(between);
        return uv_[key] =
                   static_cast<int>(scan.uv.cols() + static_cast<Eigen::Index>(new_uv_.size()) - 1);
    }

    void rebuild_faces(Scan& scan) {
        const Polygons& old = scan_.faces;
        const bool textured = !old.uv.empty();
        Polygons faces;
        std::vector<int> materials;
        std::vector<int> new_number(static_cast<std::size_t>(old.count()) + 1, 0);
        std::vector<std::vector<int>> triangles_of(static_cast<std::size_t>(old.count()));
        std::vector<char> split(static_cast<std::size_t>(old.count()), 0);
        for (int t = 0; t < scan_.mesh.triangle_count(); ++t) {
            const int face = face_of(scan_, t);
            triangles_of[static_cast<std::size_t>(face)].push_back(t);
            const Eigen::Vector3i v = scan_.mesh.triangles.col(t);
            for (int c = 0; c < 3; ++c) {
                if (line_.count(edge_of(v[c], v[(c + 1) % 3])) != 0) {
                    split[static_cast<std::size_t>(face)] = 1;
                }
            }
        }
        const auto emit = [&](const std::vector<Corner>& corners, int face) {
            for (const Corner& corner : corners) {
                faces.vertex.push_back(corner.vertex);
                if (textured) {
                    faces.uv.push_back(corner.uv);
                }
            }
            faces.start.push_back(static_cast<int>(faces.vertex.size()));
            if (!scan_.face_material.empty()) {
                materials.push_back(scan_.face_material[static_cast<std::size_t>(face)]);
            }
        };
        for (int face = 0; face < old.count(); ++face) {
            new_number[static_cast<std::size_t>(face)] = faces.count();
            if (split[static_cast<std::size_t>(face)] == 0) {
                std::vector<Corner> corners;
                for (int k = old.start[static_cast<std::size_t>(face)];
                     k < old.start[static_cast<std::size_t>(face) + 1]; ++k) {
                    corners.push_back({old.vertex[static_cast<std::size_t>(k)],
                                       textured ? old.uv[static_cast<std::size_t>(k)] : -1});
                }
                emit(corners, face);
                continue;
            }
            for (const int t : triangles_of[static_cast<std::size_t>(face)]) {
                // In the file's own sense of turning, which the mesh may have mended: corners of a
                // face rise in that sense.
                std::array<Corner, 3> corners;
                std::array<int, 3> at = corners_of(scan_, t);
                if ((at[0] < at[1]) + (at[1] < at[2]) + (at[2] < at[0]) == 1) {
                    std::swap(at[1], at[2]);
                }
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto k = static_cast<std::size_t>(at[c]);
                    corners[c] = {old.vertex[k], textured ? old.uv[k] : -1};
                }
                for (const auto& piece : pieces(scan, corners)) {
                    emit({piece.begin(), piece.end()}, face);
                }
            }
        }
        new_number.back() = faces.count();
        scan.faces = std::move(faces);
        scan.face_material = std::move(materials);
        for (ObjStatement& statement : scan.statements) {
            statement.before_face = new_number[static_cast<std::size_t>(
                std::clamp(statement.before_face, 0, old.count()))];
        }
        const Eigen::Index uvs = scan.uv.cols();
        scan.uv.conservativeResize(2, uvs + static_cast<Eigen::Index>(new_uv_.size()));
        for (std::size_t k = 0; k < new_uv_.size(); ++k) {
            scan.uv.col(uvs + static_cast<Eigen::Index>(k)) = new_uv_[k];
        }
    }

    /// The triangles into which the line cuts one.
    std::vector<std::array<Corner, 3>> pieces(Scan& scan, std::array<Corner, 3> corners) {
        std::array<const LineVertex*, 3> on{};  // on the edge from corner c to the next
        int count = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto found = line_.find(edge_of(corners[c].vertex, corners[(c + 1) % 3].vertex));
            on[c] = found == line_.end() ? nullptr : &found->second;
            count += on[c] != nullptr ? 1 : 0;
        }
        if (count == 0) {
            return {corners};
        }
        const auto cut = [&](std::size_t c, bool upper) {
            const LineVertex& v = *on[c];
            const Corner& a = corners[c];
            const Corner& b = corners[(c + 1) % 3];
            const bool from_upper = a.vertex == v.upper_end;
            return Corner{upper ? v.upper : v.lower, uv_between(scan, from_upper ? a.uv : b.uv,
                                                                from_upper ? b.uv : a.uv, v.share)};
        };
        if (count == 1) {  // the line's end: the vertex is one of both margins
            std::size_t c = 0;
            while (on[c] == nullptr) {
                ++c;
            }
            // Each half takes the margin of its own end of the edge.
            const Corner& apex = corners[(c + 2) % 3];
            const bool first_upper = height_[static_cast<std::size_t>(corners[c].vertex)] > 0.0;
            return {{corners[c], cut(c, first_upper), apex},
                    {cut(c, !first_upper), corners[(c + 1) % 3], apex}};
        }
        // Two edges are crossed: one corner is alone on its side.
        std::size_t alone = 0;
        while (on[alone] == nullptr || on[(alone + 2) % 3] == nullptr) {
            ++alone;
        }
        const std::size_t next = (alone + 1) % 3;
        const std::size_t last = (alone + 2) % 3;
        const bool upper = height_[static_cast<std::size_t>(corners[alone].vertex)] > 0.0;
        return {{corners[alone], cut(alone, upper), cut(last, upper)},
                {cut(alone, !upper), corners[next], corners[last]},
                {cut(alone, !upper), corners[last], cut(last, !upper)}};
    }

    const Scan& scan_;
    const Points& generic_;
    Points new_generic_;
    std::vector<double> height_;
    std::vector<int> near_;  ///< triangles of the lips
    std::map<Edge, LineVertex> line_;
    std::map<std::pair<int, int>, int> uv_;
    std::vector<Eigen::Vector2f> new_uv_;
};

}  // namespace

std::optional<PartedLips> part_lips(const Scan& scan, const Points& generic) {
    return Parter(scan, generic).run();
}

}  // namespace myoface
