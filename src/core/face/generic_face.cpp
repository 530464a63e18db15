// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/generic_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "myoface/base/error.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/cut.h"
#include "myoface/mesh/isosurface.h"
#include "myoface/mesh/remesh.h"

#include "head_field.h"
#include "norms.h"

namespace myoface {
namespace {

const HeadField& head() {
    static const HeadField kHead;
    return kHead;
}

double bump(double x) {
    return std::exp(-x * x);
}

/// Share of the general edge length wanted at a place: fine where a face has detail.
double relative_edge_length(const Vec3& p) {
    const double x = std::abs(p.x());
    const auto near = [&](double cx, double cy, double cz, double reach) {
        return bump((Vec3(x, p.y(), p.z()) - Vec3(cx, cy, cz)).norm() / reach);
    };
    double size = 1.9;
    const double face = std::clamp((p.z() - 20.0) / 50.0, 0.0, 1.0) *
                        std::clamp((p.y() + 125.0) / 40.0, 0.0, 1.0) *
                        std::clamp((80.0 - p.y()) / 40.0, 0.0, 1.0);
    size -= 0.9 * face;
    size -= 0.5 * near(30, 17, 80, 17);
    size -= 0.52 * near(10, -51, 98, 19);
    size -= 0.35 * near(7, -20, 102, 16);
    size -= 0.75 * near(77, 3, -18, 24);
    return std::max(size, 0.42);
}

/// Edge length that gives about the wanted number of vertices, from a mesh of any density.
double base_edge_length(const TriangleMesh& mesh, double vertices) {
    double density = 0.0;  // vertices times squared base length
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 centre = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
        const double size = relative_edge_length(centre);
        density += 0.5 * double_area_vector(mesh, t).norm() * 1.1547 / (size * size);
    }
    return std::sqrt(density / vertices);
}

/// Every triangle into four, new points on the surface.
TriangleMesh subdivided(const TriangleMesh& mesh) {
    TriangleMesh fine;
    std::map<std::pair<int, int>, int> middle;
    std::vector<Vec3> added;
    const Adjacency adjacency(mesh);
    for (const MeshEdge& edge : adjacency.edges()) {
        const auto [a, b] = edge.vertices;
        middle[{a, b}] = mesh.vertex_count() + static_cast<int>(added.size());
        added.push_back(head().onto_surface(0.5 * (mesh.vertices.col(a) + mesh.vertices.col(b)),
                                            edge.triangle_count == 1));
    }
    fine.vertices.resize(3, mesh.vertex_count() + static_cast<Eigen::Index>(added.size()));
    fine.vertices.leftCols(mesh.vertex_count()) = mesh.vertices;
    for (std::size_t i = 0; i < added.size(); ++i) {
        fine.vertices.col(mesh.vertex_count() + static_cast<Eigen::Index>(i)) = added[i];
    }
    fine.triangles.resize(3, 4 * mesh.triangle_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::Vector3i v = mesh.triangles.col(t);
        Eigen::Vector3i m;
        for (int c = 0; c < 3; ++c) {
            m[c] = middle[std::minmax(v[c], v[(c + 1) % 3])];
        }
        fine.triangles.col(4 * t) << v[0], m[0], m[2];
        fine.triangles.col(4 * t + 1) << v[1], m[1], m[0];
        fine.triangles.col(4 * t + 2) << v[2], m[2], m[1];
        fine.triangles.col(4 * t + 3) << m[0], m[1], m[2];
    }
    return fine;
}

/// The closed left half, its border on x = 0.
TriangleMesh half_head(int vertices, const Progress* progress) {
    const auto report = [&](double share) {
        if (progress != nullptr) {
            progress->report("Building the face", share);
        }
    };
    report(0.0);
    const Eigen::AlignedBox3d box(Vec3(0, HeadField::kNeckCut - 6.0, -105), Vec3(96, 140, 128));
    const TriangleMesh raw = isosurface([](const Vec3& p) { return head()(p); }, box, 2.6);
    report(0.3);
    int levels = 0;
    double wanted = vertices / 2.0;
    while (wanted > 30000.0) {
        wanted /= 4.0;
        ++levels;
    }
    const double edge = base_edge_length(raw, wanted);
    RemeshOptions options;
    options.edge_length = [edge](const Vec3& p) { return edge * relative_edge_length(p); };
    options.project = [](const Vec3& p, bool on_border) {
        Vec3 at = head().onto_surface(p, on_border);
        if (on_border) {
            at.x() = 0.0;
        } else {
            at.x() = std::max(at.x(), 0.0);
        }
        return at;
    };
    TriangleMesh mesh = remesh(raw, options);
    report(0.8);
    for (int level = 0; level < levels; ++level) {
        mesh = subdivided(mesh);
    }
    return mesh;
}

/// Values of a line function at the vertices; vertices close to the line are moved onto it first,
/// along y and back onto the surface, so that splitting leaves no slivers.
template <typename Line>
SplitMesh split_on_line(TriangleMesh mesh, const Line& line, const std::vector<bool>& part_of) {
    std::vector<double> values(static_cast<std::size_t>(mesh.vertex_count()), 1.0);
    const Adjacency adjacency(mesh);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (!part_of[v]) {
            continue;
        }
        double shortest = 1e9;
        for (const int w : adjacency.neighbours(v)) {
            shortest = std::min(shortest, (mesh.vertices.col(v) - mesh.vertices.col(w)).norm());
        }
        const Vec3 p = mesh.vertices.col(v);
        values[v] = line(p.x(), p.y());
        if (std::abs(values[v]) < 0.3 * shortest) {
            // One step along the line function's slope in the frontal plane.
            constexpr double kStep = 1e-4;
            const double dx = (line(p.x() + kStep, p.y()) - values[v]) / kStep;
            const double dy = (line(p.x(), p.y() + kStep) - values[v]) / kStep;
            const double square = dx * dx + dy * dy;
            const double x = p.x() == 0.0 ? 0.0 : p.x() - values[v] * dx / square;
            const double y = p.y() - values[v] * dy / square;
            mesh.vertices.col(v) = head().front_point(x, y);
            values[v] = 0.0;
        }
    }
    return split_along_zero(mesh, values, part_of);
}

/// Growing mesh used while openings are cut.
struct Builder {
    std::vector<Vec3> vertices;
    std::vector<Eigen::Vector3i> triangles;

    explicit Builder(const TriangleMesh& mesh) {
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            vertices.emplace_back(mesh.vertices.col(v));
        }
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            triangles.emplace_back(mesh.triangles.col(t));
        }
    }
    int add(const Vec3& p) {
        vertices.push_back(p);
        return static_cast<int>(vertices.size()) - 1;
    }
    TriangleMesh mesh() const {
        TriangleMesh result;
        std::vector<int> number(vertices.size(), -1);
        int count = 0;
        for (const Eigen::Vector3i& t : triangles) {
            for (const int v : t) {
                if (number[v] < 0) {
                    number[v] = count++;
                }
            }
        }
        result.vertices.resize(3, count);
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            if (number[v] >= 0) {
                result.vertices.col(number[v]) = vertices[v];
            }
        }
        result.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (int c = 0; c < 3; ++c) {
                result.triangles(c, static_cast<Eigen::Index>(t)) = number[triangles[t][c]];
            }
        }
        return result;
    }
};

/// Cuts the lids apart and turns their margins inwards to the eyeball.
TriangleMesh with_eye_opening(const TriangleMesh& closed) {
    const auto line = [](double x, double y) {
        return std::max(y - head().upper_lid(x), head().lower_lid(x) - y);
    };
    std::vector<bool> front(static_cast<std::size_t>(closed.vertex_count()));
    for (int v = 0; v < closed.vertex_count(); ++v) {
        const Vec3 p = closed.vertices.col(v);
        front[v] = p.z() > 60.0 && p.x() > HeadField::kInnerCanthus - 1.5 &&
                   p.x() < HeadField::kOuterCanthus + 1.5 && std::abs(p.y() - 17.0) < 14.0;
    }
    const SplitMesh split = split_on_line(closed, line, front);
    Builder builder(split.mesh);
    std::erase_if(builder.triangles, [&](const Eigen::Vector3i& t) {
        Vec3 centre = Vec3::Zero();
        bool inside = true;
        for (const int v : t) {
            centre += builder.vertices[v] / 3.0;
            inside = inside && split.values[v] <= 0.0;
        }
        return inside && centre.z() > 60.0 && line(centre.x(), centre.y()) < 0.0;
    });
    const TriangleMesh open = builder.mesh();
    Builder result(open);
    const Adjacency adjacency(open);
    for (const auto& loop : boundary_loops(open, adjacency)) {
        if (open.vertices(0, loop[0]) == 0.0 || open.vertices(2, loop[0]) < 55.0) {
            continue;  // the midline
        }
        std::vector<int> inner;
        for (const int v : loop) {
            const Vec3 out = Vec3(open.vertices.col(v)) - HeadField::eye_centre();
            inner.push_back(result.add(HeadField::eye_centre() +
                                       (HeadField::kEyeRadius + 0.15) * out.normalized()));
        }
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::size_t j = (i + 1) % loop.size();
            result.triangles.emplace_back(loop[i], loop[j], inner[j]);
            result.triangles.emplace_back(loop[i], inner[j], inner[i]);
        }
    }
    return result.mesh();
}

/// Parts the lips along their contact line and gives each an inner side.
TriangleMesh with_mouth_opening(const TriangleMesh& closed) {
    const auto line = [](double x, double y) { return y - head().lip_line(x); };
    const auto is_mouth = [](const Vec3& p) {
        return p.z() > 70.0 && p.x() < HeadField::kMouthCorner && std::abs(p.y() + 52.0) < 8.0;
    };
    std::vector<bool> part(static_cast<std::size_t>(closed.vertex_count()));
    for (int v = 0; v < closed.vertex_count(); ++v) {
        part[v] = is_mouth(closed.vertices.col(v));
    }
    const SplitMesh split = split_on_line(closed, line, part);
    // Chain of split edges from the midline to the corner.
    std::map<int, std::vector<int>> along;
    const auto on_line = [&](int v) {
        return split.values[v] == 0.0 && is_mouth(split.mesh.vertices.col(v));
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
        if (split.mesh.vertices(0, v) == 0.0) {
            chain.push_back(v);
        }
    }
    if (chain.empty()) {
        return closed;
    }
    chain.resize(1);
    for (;;) {
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
    Builder builder(split.mesh);
    // All but the corner get a twin that the lower lip uses, a hair below: coincident vertices
    // would be taken for a seam and joined again.
    constexpr double kLipGap = 0.02;
    std::map<int, int> twin;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        twin[chain[i]] = builder.add(builder.vertices[chain[i]] - Vec3(0.0, kLipGap, 0.0));
    }
    for (Eigen::Vector3i& t : builder.triangles) {
        double side = 0.0;
        for (const int v : t) {
            side += line(builder.vertices[v].x(), builder.vertices[v].y());
        }
        for (int& v : t) {
            const auto found = twin.find(v);
            if (side < 0.0 && found != twin.end()) {
                v = found->second;
            }
        }
    }
    // Inner sides: two strips into the mouth, upper and lower, that share the corner.
    constexpr int kStrips = 3;
    constexpr double kStripDepth = 2.4;
    std::vector<int> upper = chain;
    std::vector<int> lower;
    for (const int v : chain) {
        lower.push_back(twin.count(v) != 0 ? twin[v] : v);
    }
    for (int strip = 1; strip <= kStrips; ++strip) {
        std::vector<int> next_upper;
        std::vector<int> next_lower;
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const Vec3 rim = builder.vertices[chain[i]];
            const double opening = 1.0 - std::pow(rim.x() / (HeadField::kMouthCorner + 0.5), 2.0);
            const Vec3 in(0.0, 0.0, -kStripDepth * strip * (0.35 + 0.65 * opening));
            const Vec3 part_way(0.0, 0.10 * strip * opening, 0.0);
            if (i + 1 == chain.size()) {
                const int shared = builder.add(rim + in);
                next_upper.push_back(shared);
                next_lower.push_back(shared);
            } else {
                next_upper.push_back(builder.add(rim + in + part_way));
                next_lower.push_back(builder.add(rim + in - part_way));
            }
        }
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            builder.triangles.emplace_back(upper[i], next_upper[i], next_upper[i + 1]);
            builder.triangles.emplace_back(upper[i], next_upper[i + 1], upper[i + 1]);
            builder.triangles.emplace_back(lower[i], next_lower[i + 1], next_lower[i]);
            builder.triangles.emplace_back(lower[i], lower[i + 1], next_lower[i + 1]);
        }
        upper.swap(next_upper);
        lower.swap(next_lower);
    }
    return builder.mesh();
}

Builder mirrored(const TriangleMesh& half) {
    Builder whole(half);
    std::vector<int> other(static_cast<std::size_t>(half.vertex_count()));
    for (int v = 0; v < half.vertex_count(); ++v) {
        const Vec3 p = half.vertices.col(v);
        other[v] = p.x() == 0.0 ? v : whole.add({-p.x(), p.y(), p.z()});
    }
    for (int t = 0; t < half.triangle_count(); ++t) {
        whole.triangles.emplace_back(other[half.triangles(0, t)], other[half.triangles(2, t)],
                                     other[half.triangles(1, t)]);
    }
    return whole;
}

constexpr double kIrisAngle = 0.505;  // half angle seen from the eye's centre [rad]
constexpr double kPupilAngle = 0.165;

void add_eyeball(Builder& builder, double side, int around) {
    const Vec3 centre = HeadField::eye_centre().cwiseProduct(Vec3(side, 1.0, 1.0));
    std::vector<double> angles{0.06, 0.12, kPupilAngle - 0.01, kPupilAngle + 0.01, 0.24,
                               0.33, 0.42, kIrisAngle - 0.035, kIrisAngle + 0.01,  0.58};
    for (double a = 0.72; a < 2.2; a += 0.2) {
        angles.push_back(a);
    }
    const auto radius = [](double a) {
        const double s = 5.2 * std::sin(a);
        const double cornea = a < 0.8 ? 5.2 * std::cos(a) + std::sqrt(7.9 * 7.9 - s * s) : 0.0;
        return std::max(HeadField::kEyeRadius, cornea);
    };
    const int pole = builder.add(centre + Vec3(0, 0, radius(0.0)));
    int previous = -1;
    for (const double angle : angles) {
        const int first = static_cast<int>(builder.vertices.size());
        for (int k = 0; k < around; ++k) {
            const double turn = 2.0 * std::numbers::pi * k / around;
            builder.add(centre + radius(angle) * Vec3(std::sin(angle) * std::cos(turn),
                                                      std::sin(angle) * std::sin(turn),
                                                      std::cos(angle)));
        }
        for (int k = 0; k < around; ++k) {
            const int next = (k + 1) % around;
            if (previous < 0) {
                builder.triangles.emplace_back(pole, first + k, first + next);
            } else {
                builder.triangles.emplace_back(previous + k, first + k, first + next);
                builder.triangles.emplace_back(previous + k, first + next, previous + next);
            }
        }
        previous = first;
    }
    const int back = builder.add(centre - Vec3(0, 0, HeadField::kEyeRadius));
    for (int k = 0; k < around; ++k) {
        builder.triangles.emplace_back(previous + k, back, previous + (k + 1) % around);
    }
}

double step(double edge0, double edge1, double x) {
    const double t = std::clamp((x - edge0) / (edge1 - edge0), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

Vec3 mixed(const Vec3& a, const Vec3& b, double share) {
    return a + share * (b - a);
}

Vec3 eye_colour(const Vec3& local) {
    const double angle = std::acos(std::clamp(local.normalized().z(), -1.0, 1.0));
    const Vec3 sclera(0.86, 0.83, 0.81);
    const Vec3 iris = mixed({0.36, 0.26, 0.17}, {0.24, 0.19, 0.14}, step(0.25, kIrisAngle, angle));
    Vec3 colour =
        mixed(iris, {0.12, 0.10, 0.09}, step(kIrisAngle - 0.09, kIrisAngle - 0.03, angle));
    colour = mixed(colour, sclera, step(kIrisAngle - 0.03, kIrisAngle + 0.01, angle));
    colour =
        mixed(Vec3(0.02, 0.02, 0.02), colour, step(kPupilAngle - 0.01, kPupilAngle + 0.01, angle));
    return mixed(colour, {0.80, 0.62, 0.58}, 0.55 * step(0.75, 1.15, angle));
}

/// Skin, lips, brows and cropped hair, in sRGB.
Vec3 skin_colour(const Vec3& p) {
    static const Spline kUpperBorder({0, 3, 6.2, 10, 14, 19, 22.5, 25},
                                     {-45.6, -45, -44.4, -45.6, -46.9, -49.3, -51.2, -52.2});
    static const Spline kLowerBorder({0, 6, 12, 17, 21, 25},
                                     {-60, -59.8, -58.4, -56.3, -54.1, -52.3});
    static const Spline kBrow({8, 14, 20, 28, 36, 44, 50},
                              {31.5, 34.5, 36.5, 38.6, 38.8, 35.5, 30.5});
    const double x = std::abs(p.x());
    Vec3 colour(0.82, 0.635, 0.545);
    // A little blood in cheeks, nose and ears; none over the forehead.
    const double blush =
        0.34 * bump((Vec3(x, p.y(), 0) - Vec3(40, -14, 0)).norm() / 24.0) +
        0.30 * bump((Vec3(x, p.y(), 0) - Vec3(4, -20, 0)).norm() / 13.0) * step(85, 100, p.z()) +
        0.30 * step(70, 78, x) + 0.15 * bump((p.y() + 84) / 14.0) * step(60, 85, p.z());
    colour = mixed(colour, {0.80, 0.50, 0.43}, std::min(blush, 0.5));
    if (p.z() > 60.0) {
        const double lids = bump(((p.y() - 17.0) / 9.0)) * bump((x - 30.0) / 16.0);
        colour = mixed(colour, {0.70, 0.48, 0.42}, 0.35 * lids);
        const double soft = 0.9;
        const double lips = step(-soft, soft, kUpperBorder(x) - p.y()) *
                            step(-soft, soft, p.y() - kLowerBorder(x)) * step(25.5, 23.0, x) *
                            step(70, 80, p.z());
        colour = mixed(colour, {0.69, 0.40, 0.37}, 0.85 * lips);
        const double thickness = 3.4 * step(4, 14, x) * (1.0 - 0.55 * step(26, 50, x));
        const double brow =
            thickness > 0.1 ? step(thickness + 0.8, thickness - 1.6, std::abs(p.y() - kBrow(x))) *
                                  step(7.0, 12.0, x) * step(52.0, 44.0, x) * step(50, 62, p.z())
                            : 0.0;
        colour = mixed(colour, {0.25, 0.185, 0.15}, 0.78 * brow);
    }
    // Hairline: high over the forehead, forward at the temple, behind the ear.
    const double hairline = p.z() > 0.0 ? 82.0 - 34.0 * step(38, 74, x) - 26.0 * step(40, -5, p.z())
                                        : 22.0 - 62.0 * step(0, -60, p.z());
    const double near_ear = step(20, 9, (Vec3(x, p.y(), p.z()) - Vec3(77, 3, -18)).norm() - 18.0);
    const double hair = step(-7.0, 9.0, p.y() - hairline) * (1.0 - near_ear * step(68, 73, x));
    return mixed(colour, {0.33, 0.26, 0.225}, 0.62 * hair);
}

/// Where the landmarks of the average head should be; put onto the surface exactly.
Landmarks place_landmarks() {
    Landmarks result;
    const auto put = [&](const std::string& name, const Vec3& at, bool paired) {
        result[paired ? name + "_l" : name] = {at, 0.1};
        if (paired) {
            result[name + "_r"] = {{-at.x(), at.y(), at.z()}, 0.1};
        }
    };
    const HeadField& f = head();
    const auto front = [&](double x, double y) { return f.front_point(x, y); };
    put("tr", front(0, 88), false);
    put("g", front(0, 38), false);
    put("n", front(0, 25), false);
    Vec3 prn = front(0, -16);
    double deepest = 1e9;
    Vec3 sellion = front(0, 20);
    for (double y = -24; y < -10; y += 0.1) {
        const Vec3 p = front(0, y);
        prn = p.z() > prn.z() ? p : prn;
    }
    for (double y = 14; y < 24; y += 0.1) {
        const Vec3 p = front(0, y);
        if (p.z() < deepest) {
            deepest = p.z();
            sellion = p;
        }
    }
    put("se", sellion, false);
    put("prn", prn, false);
    put("c", f.onto_surface({0, -27, 110}, true), false);
    put("sn", f.onto_surface({0, -31, 101}, true), false);
    put("ls", front(0, -45.6), false);
    put("sto", front(0, f.lip_line(0)), false);
    put("li", front(0, -60), false);
    put("sl", front(0, -69), false);
    put("pg", front(0, -81), false);
    put("gn", f.onto_surface({0, -97.5, 88}, true), false);
    put("en", front(HeadField::kInnerCanthus, 16.3), true);
    put("ex", front(HeadField::kOuterCanthus, 17.95), true);
    Vec3 wing(0, -21, 98);
    for (double z = 90; z < 106; z += 0.25) {
        const Vec3 p = f.onto_surface({20, -21, z});
        wing = p.x() > wing.x() && p.z() > 94.0 ? p : wing;
    }
    put("al", wing, true);
    put("ac", f.onto_surface({16.5, -22, 91}), true);
    put("sbal", f.onto_surface({9.5, -31, 96}), true);
    put("ch", front(HeadField::kMouthCorner, f.lip_line(HeadField::kMouthCorner)), true);
    put("cph", front(6.2, -44.4), true);
    put("zy", f.onto_surface({70, -4, 22}), true);
    put("go", f.onto_surface({54, -65, 13}), true);
    put("t", f.onto_surface({71, 0, 3}), true);
    put("ft", f.onto_surface({56, 46, 62}), true);
    return result;
}

/// New landmark places for a sex or an individual: each norm scales the distance it measures.
Landmarks individual(const Landmarks& average, const GenericFaceOptions& options) {
    std::mt19937 random(options.seed.value_or(0));
    // std::normal_distribution differs between libraries; the sum of twelve uniforms does not.
    const auto gauss = [&] {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i) {
            sum += static_cast<double>(random()) / 4294967296.0;
        }
        return std::clamp(sum, -2.0, 2.0);
    };
    std::map<std::string, double> factor;
    for (const NormRow& row : read_norms(options.age)) {
        const double both = 0.5 * (row.male_mean + row.female_mean);
        double mean = both;
        double sd = 0.5 * (row.male_sd + row.female_sd);
        if (options.sex) {
            const bool male = *options.sex == Sex::Male;
            mean = male ? row.male_mean : row.female_mean;
            sd = male ? row.male_sd : row.female_sd;
        }
        const double draw = options.seed ? gauss() : 0.0;
        factor[row.from + "-" + row.to] = (mean + sd * draw) / both;
    }
    const auto scale = [&](const char* key) {
        const auto found = factor.find(key);
        return found == factor.end() ? 1.0 : found->second;
    };
    Landmarks result = average;
    const auto widen = [&](const char* name, double share) {
        for (const char* side : {"_l", "_r"}) {
            result[std::string(name) + side].position.x() *= share;
        }
    };
    widen("en", scale("en-en"));
    widen("ex", scale("ex-ex"));
    widen("al", scale("al-al"));
    widen("ac", scale("al-al"));
    widen("sbal", scale("sbal-sbal"));
    widen("ch", scale("ch-ch"));
    widen("cph", scale("cph-cph"));
    widen("zy", scale("zy-zy"));
    widen("t", scale("zy-zy"));
    widen("go", scale("go-go"));
    widen("ft", scale("ft-ft"));
    // Heights hang below the nasion, one after the other.
    const auto drop = [&](const char* from, const char* to, double share) {
        return share * (average.at(from).position.y() - average.at(to).position.y());
    };
    const double n = average.at("n").position.y();
    std::map<std::string, double> height;
    height["sn"] = n - drop("n", "sn", scale("n-sn"));
    height["sto"] = height["sn"] - drop("sn", "sto", scale("sn-sto"));
    height["ls"] = height["sto"] + drop("ls", "sto", scale("ls-sto"));
    height["li"] = height["sto"] - drop("sto", "li", scale("sto-li"));
    height["sl"] = height["li"] - drop("li", "sl", scale("li-sl"));
    height["gn"] = n - drop("n", "gn", scale("n-gn"));
    const double chin = height["sl"] - drop("sl", "gn", 1.0);
    height["pg"] = height["sl"] - drop("sl", "pg", 1.0) + 0.6 * (height["gn"] - chin);
    for (const auto& [name, y] : height) {
        result[name].position.y() = y;
    }
    const double nose = height["sn"] - average.at("sn").position.y();
    for (const char* name : {"prn", "c", "al_l", "al_r", "ac_l", "ac_r", "sbal_l", "sbal_r"}) {
        result[name].position.y() += nose;
    }
    const double mouth = height["sto"] - average.at("sto").position.y();
    for (const char* name : {"ch_l", "ch_r"}) {
        result[name].position.y() += mouth;
    }
    for (const char* name : {"cph_l", "cph_r"}) {
        result[name].position.y() += height["ls"] - average.at("ls").position.y();
    }
    const double jaw = height["gn"] - average.at("gn").position.y();
    for (const char* name : {"go_l", "go_r"}) {
        result[name].position.y() += 0.5 * jaw;
    }
    result["prn"].position.z() +=
        (scale("sn-prn") - 1.0) * (average.at("prn").position.z() - average.at("sn").position.z());
    return result;
}

}  // namespace

const Landmarks& generic_landmarks() {
    static const Landmarks kLandmarks = place_landmarks();
    return kLandmarks;
}

GenericFace make_generic_face(const GenericFaceOptions& options, const Progress* progress) {
    if (options.vertices < 3000 || options.vertices > 400000) {
        throw InvalidInput("The number of vertices must lie between 3000 and 400000.");
    }
    if (!(options.age >= 3.0 && options.age <= 100.0)) {
        throw InvalidInput("The age must lie between 3 and 100 years.");
    }
    const int around = std::clamp(static_cast<int>(std::sqrt(options.vertices) / 4.5), 16, 64);
    const int eyes = 2 * 18 * around;
    const TriangleMesh half =
        half_head(static_cast<int>(0.94 * (options.vertices - eyes)), progress);
    Builder builder = mirrored(with_mouth_opening(with_eye_opening(half)));
    const std::size_t skin_vertices = builder.vertices.size();
    add_eyeball(builder, 1.0, around);
    add_eyeball(builder, -1.0, around);

    GenericFace face;
    Scan& scan = face.scan;
    scan.format = FileFormat::PlyBinaryLittle;
    const auto n = static_cast<Eigen::Index>(builder.vertices.size());
    scan.mesh.vertices.resize(3, n);
    scan.colours.resize(3, n);
    for (Eigen::Index v = 0; v < n; ++v) {
        const Vec3 p = builder.vertices[static_cast<std::size_t>(v)];
        scan.mesh.vertices.col(v) = p;
        Vec3 colour;
        if (static_cast<std::size_t>(v) < skin_vertices) {
            colour = skin_colour(p);
        } else {
            const Vec3 centre =
                HeadField::eye_centre().cwiseProduct(Vec3(p.x() > 0.0 ? 1.0 : -1.0, 1.0, 1.0));
            colour = eye_colour(p - centre);
        }
        scan.colours.col(v) = colour.cast<float>();
    }
    for (const Eigen::Vector3i& t : builder.triangles) {
        for (const int v : t) {
            scan.faces.vertex.push_back(v);
        }
        scan.faces.start.push_back(static_cast<int>(scan.faces.vertex.size()));
    }
    triangulate(scan);

    face.landmarks = generic_landmarks();
    if (options.sex || options.seed) {
        const Landmarks wanted = individual(face.landmarks, options);
        Points from(3, static_cast<Eigen::Index>(wanted.size()) + 6);
        Points to(3, from.cols());
        Eigen::Index i = 0;
        for (const auto& [name, landmark] : face.landmarks) {
            from.col(i) = landmark.position;
            to.col(i++) = wanted.at(name).position;
        }
        // The back of the head and the neck hold the warp down where there are no landmarks.
        for (const Vec3& anchor : {Vec3(0, 125, -10), Vec3(0, 40, -95), Vec3(60, 60, -50),
                                   Vec3(-60, 60, -50), Vec3(0, -150, 20), Vec3(0, -150, -90)}) {
            from.col(i) = to.col(i) = anchor;
            ++i;
        }
        const SmoothWarp warp(from, to, Eigen::VectorXd::Zero(from.cols()), 0.0);
        scan.mesh.vertices = warp(scan.mesh.vertices);
        face.landmarks = wanted;
    }
    scan.file_vertices = scan.mesh.vertices;
    scan.byte_colours = true;  // as files of it hold them
    examine(scan);
    if (progress != nullptr) {
        progress->report("Building the face", 1.0);
    }
    return face;
}

}  // namespace myoface
