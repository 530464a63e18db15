// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "myoface/base/parallel.h"
#include "myoface/io/scan.h"

namespace myoface {
namespace {

/// Newell's normal: right for concave and slightly bent faces.
Vec3 face_normal(const Points& vertices, const std::vector<int>& corners) {
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 a = vertices.col(corners[i]);
        const Vec3 b = vertices.col(corners[(i + 1) % corners.size()]);
        normal += a.cross(b);
    }
    return normal;
}

/// Tests of a point against a triangle that one file may ask for before the rest of its large faces
/// is cut into fans: a made-up face of a million corners must not take hours.
constexpr long long kMostTests = 100'000'000;
/// Up to this size the roundest ear is looked for, beyond it the next one serves.
constexpr std::size_t kSmallFace = 16;

/// Corner positions, as numbers 0 … n-1, of the triangles of one face.
std::vector<std::array<int, 3>> clip_ears(const Points& vertices, const std::vector<int>& corners,
                                          long long& tests) {
    // In the face's own plane, seen against its normal.
    const Vec3 normal = face_normal(vertices, corners);
    const bool flat = !(normal.squaredNorm() > 0.0);
    const Vec3 up = flat ? Vec3(Vec3::UnitZ()) : Vec3(normal.stableNormalized());
    const Vec3 across = up.unitOrthogonal();
    const Vec3 along = up.cross(across);
    std::vector<Eigen::Vector2d> plane;
    plane.reserve(corners.size());
    for (const int v : corners) {
        const Vec3 p = vertices.col(v);
        plane.emplace_back(p.dot(across), p.dot(along));
    }
    const auto at = [&](int k) -> const Eigen::Vector2d& {
        return plane[static_cast<std::size_t>(k)];
    };
    const auto turn = [&](int a, int b, int c) {
        const Eigen::Vector2d& p = at(a);
        const Eigen::Vector2d& q = at(b);
        const Eigen::Vector2d& r = at(c);
        return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
    };
    std::vector<int> left(corners.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        left[i] = static_cast<int>(i);
    }
    std::vector<std::array<int, 3>> triangles;
    std::size_t resume = 0;
    while (left.size() > 3) {
        const std::size_t n = left.size();
        std::size_t best = n;
        double best_shape = -1.0;
        for (std::size_t k = 0; k < n && tests < kMostTests; ++k) {
            const std::size_t i = (resume + k) % n;
            const int a = left[(i + n - 1) % n];
            const int b = left[i];
            const int c = left[(i + 1) % n];
            ++tests;
            if (turn(a, b, c) <= 0.0) {
                continue;
            }
            tests += static_cast<long long>(n);
            const bool holds_another = std::any_of(left.begin(), left.end(), [&](int other) {
                return other != a && other != b && other != c && turn(a, b, other) > 0.0 &&
                       turn(b, c, other) > 0.0 && turn(c, a, other) > 0.0;
            });
            const double longest =
                std::max({(at(a) - at(b)).squaredNorm(), (at(b) - at(c)).squaredNorm(),
                          (at(c) - at(a)).squaredNorm()});
            const double shape = longest > 0.0 ? 1.0 / longest : 0.0;
            if (!holds_another && shape > best_shape) {
                best = i;
                best_shape = shape;
                if (n > kSmallFace) {
                    break;
                }
            }
        }
        if (best == n) {
            if (tests >= kMostTests) {  // a fan, all at once
                for (std::size_t i = 1; i + 1 < n; ++i) {
                    triangles.push_back({left[0], left[i], left[i + 1]});
                }
                return triangles;
            }
            best = 1;  // crossed or flat: any ear is as good as another
        }
        triangles.push_back({left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
        resume = n > kSmallFace ? best : 0;
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

}  // namespace

void triangulate(Scan& scan) {
    const Polygons& faces = scan.faces;
    const std::size_t triangles = faces.vertex.size() - 2 * static_cast<std::size_t>(faces.count());
    scan.mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles));
    scan.triangle_face.clear();
    scan.triangle_corner.clear();
    if (triangles == static_cast<std::size_t>(faces.count())) {
        parallel_for(faces.count(), 65536, [&](int begin, int end) {
            std::copy(faces.vertex.begin() + 3 * begin, faces.vertex.begin() + 3 * end,
                      scan.mesh.triangles.data() + 3 * begin);
        });
        return;
    }
    scan.triangle_face.resize(triangles);
    scan.triangle_corner.resize(triangles);
    std::vector<int> corners;
    std::size_t next = 0;
    long long tests = 0;
    for (int f = 0; f < faces.count(); ++f) {
        const int begin = faces.start[f];
        const auto add = [&](int a, int b, int c) {
            scan.mesh.triangles.col(static_cast<Eigen::Index>(next)) << faces.vertex[begin + a],
                faces.vertex[begin + b], faces.vertex[begin + c];
            scan.triangle_face[next] = f;
            scan.triangle_corner[next] = {begin + a, begin + b, begin + c};
            ++next;
        };
        if (faces.size(f) == 3) {
            add(0, 1, 2);
            continue;
        }
        corners.assign(faces.vertex.begin() + begin, faces.vertex.begin() + faces.start[f + 1]);
        for (const auto& t : clip_ears(scan.mesh.vertices, corners, tests)) {
            add(t[0], t[1], t[2]);
        }
    }
}

void set_frame(Scan& scan, const FileFrame& frame) {
    const Mat3 change =
        frame.mm_per_unit / scan.frame.mm_per_unit * frame.axes * scan.frame.axes.transpose();
    scan.frame = frame;
    if (change == Mat3::Identity()) {
        return;
    }
    parallel_for(scan.mesh.vertex_count(), 65536, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            scan.mesh.vertices.col(v) = change * Vec3(scan.mesh.vertices.col(v));
        }
    });
}

}  // namespace myoface
