// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/bvh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <numeric>

namespace myoface {
namespace {

constexpr int kLeafSize = 4;
constexpr int kDeepest = 64;  // halving 2³¹ triangles again and again ends earlier

Eigen::AlignedBox3d triangle_box(const TriangleMesh& mesh, int triangle) {
    Eigen::AlignedBox3d box(mesh.corner(triangle, 0));
    box.extend(mesh.corner(triangle, 1));
    box.extend(mesh.corner(triangle, 2));
    return box;
}

/// Distance along the ray to a box, or infinity.
double box_entry(const Eigen::AlignedBox3d& box, const ViewRay& ray, const Vec3& inverse) {
    const Vec3 to_low = (box.min() - ray.origin).cwiseProduct(inverse);
    const Vec3 to_high = (box.max() - ray.origin).cwiseProduct(inverse);
    double enter = 0.0;
    double leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0) {
            if (ray.origin[axis] < box.min()[axis] || ray.origin[axis] > box.max()[axis]) {
                return std::numeric_limits<double>::infinity();
            }
            continue;
        }
        enter = std::max(enter, std::min(to_low[axis], to_high[axis]));
        leave = std::min(leave, std::max(to_low[axis], to_high[axis]));
    }
    return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

/// Möller-Trumbore, both sides.
std::optional<RayHit> triangle_hit(const TriangleMesh& mesh, int triangle, const ViewRay& ray) {
    const Vec3 a = mesh.corner(triangle, 0);
    const Vec3 ab = mesh.corner(triangle, 1) - a;
    const Vec3 ac = mesh.corner(triangle, 2) - a;
    const Vec3 p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (std::abs(determinant) < 1e-14) {
        return std::nullopt;
    }
    const Vec3 s = ray.origin - a;
    const Vec3 q = s.cross(ab);
    const double u = s.dot(p) / determinant;
    const double v = ray.direction.dot(q) / determinant;
    const double distance = ac.dot(q) / determinant;
    constexpr double kEdge = 1e-12;  // a ray through an edge must not slip between two triangles
    if (u < -kEdge || v < -kEdge || u + v > 1.0 + kEdge || distance < 0.0) {
        return std::nullopt;
    }
    return RayHit{{triangle, Vec3(1.0 - u - v, u, v)}, distance};
}

}  // namespace

Vec3 closest_barycentric(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& query) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ap = query - a;
    const double d1 = ab.dot(ap);
    const double d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0) {
        return {1.0, 0.0, 0.0};
    }
    const Vec3 bp = query - b;
    const double d3 = ab.dot(bp);
    const double d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3) {
        return {0.0, 1.0, 0.0};
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        const double v = d1 / (d1 - d3);
        return {1.0 - v, v, 0.0};
    }
    const Vec3 cp = query - c;
    const double d5 = ab.dot(cp);
    const double d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6) {
        return {0.0, 0.0, 1.0};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        const double w = d2 / (d2 - d6);
        return {1.0 - w, 0.0, w};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - w, w};
    }
    const double sum = va + vb + vc;
    if (!(sum > 0.0)) {
        return {1.0, 0.0, 0.0};  // a triangle without area: any corner will do
    }
    const double v = vb / sum;
    const double w = vc / sum;
    return {1.0 - v - w, v, w};
}

Bvh::Bvh(const TriangleMesh& mesh) {
    const int count = mesh.triangle_count();
    if (count == 0) {
        return;
    }
    order_.resize(static_cast<std::size_t>(count));
    std::iota(order_.begin(), order_.end(), 0);
    Points centres(3, count);
    for (int t = 0; t < count; ++t) {
        centres.col(t) = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    }
    nodes_.reserve(static_cast<std::size_t>(count));
    nodes_.emplace_back();
    build(mesh, centres, 0, 0, count);
    refit(mesh);
}

void Bvh::build(const TriangleMesh& mesh, const Points& centres, int node, int begin, int end) {
    nodes_[node].begin = begin;
    nodes_[node].end = end;
    if (end - begin <= kLeafSize) {
        return;
    }
    Eigen::AlignedBox3d box;
    for (int i = begin; i < end; ++i) {
        box.extend(centres.col(order_[i]));
    }
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](int p, int q) {
                         return std::pair(centres(axis, p), p) < std::pair(centres(axis, q), q);
                     });
    const int left = static_cast<int>(nodes_.size());
    nodes_[node].left = left;
    nodes_.emplace_back();
    nodes_.emplace_back();
    build(mesh, centres, left, begin, middle);
    build(mesh, centres, left + 1, middle, end);
}

void Bvh::refit(const TriangleMesh& mesh) {
    for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
        node->box.setEmpty();
        if (node->left >= 0) {  // children lie behind their parent: already done
            node->box.extend(nodes_[node->left].box);
            node->box.extend(nodes_[node->left + 1].box);
            continue;
        }
        for (int i = node->begin; i < node->end; ++i) {
            node->box.extend(triangle_box(mesh, order_[i]));
        }
    }
}

ClosestPoint Bvh::closest_point(const TriangleMesh& mesh, const Vec3& query, double within) const {
    assert(!nodes_.empty());
    ClosestPoint best;
    double best_squared = within * within;
    struct Waiting {
        double bound;
        int node;
    };
    std::array<Waiting, kDeepest> stack;
    stack[0] = {0.0, 0};
    std::size_t waiting = 1;
    while (waiting > 0) {
        const auto [bound, index] = stack[--waiting];
        if (bound > best_squared) {
            continue;
        }
        const Node& node = nodes_[index];
        if (node.left < 0) {
            for (int i = node.begin; i < node.end; ++i) {
                const int t = order_[i];
                const SurfacePoint where{
                    t, closest_barycentric(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2),
                                           query)};
                const Vec3 point = position(mesh, where);
                const double squared = (point - query).squaredNorm();
                if (squared < best_squared ||
                    (squared == best_squared && t < best.where.triangle)) {
                    best_squared = squared;
                    best.where = where;
                    best.point = point;
                }
            }
            continue;
        }
        const double to_left = nodes_[node.left].box.squaredExteriorDistance(query);
        const double to_right = nodes_[node.left + 1].box.squaredExteriorDistance(query);
        const bool left_first = to_left < to_right;
        const Waiting near{left_first ? to_left : to_right, node.left + (left_first ? 0 : 1)};
        const Waiting far{left_first ? to_right : to_left, node.left + (left_first ? 1 : 0)};
        for (const Waiting& next : {far, near}) {
            if (next.bound <= best_squared) {
                stack[waiting++] = next;
            }
        }
    }
    best.distance = std::sqrt(best_squared);
    return best;
}

std::optional<RayHit> Bvh::first_hit(const TriangleMesh& mesh, const ViewRay& ray) const {
    if (nodes_.empty()) {
        return std::nullopt;
    }
    Vec3 inverse;
    for (int axis = 0; axis < 3; ++axis) {
        inverse[axis] = ray.direction[axis] == 0.0 ? 0.0 : 1.0 / ray.direction[axis];
    }
    std::optional<RayHit> best;
    std::vector<int> stack{0};
    while (!stack.empty()) {
        const Node& node = nodes_[stack.back()];
        stack.pop_back();
        const double entry = box_entry(node.box, ray, inverse);
        if (!(entry < (best ? best->distance : std::numeric_limits<double>::infinity()))) {
            continue;
        }
        if (node.left >= 0) {
            stack.push_back(node.left);
            stack.push_back(node.left + 1);
            continue;
        }
        for (int i = node.begin; i < node.end; ++i) {
            const auto hit = triangle_hit(mesh, order_[i], ray);
            if (hit && (!best || hit->distance < best->distance)) {
                best = hit;
            }
        }
    }
    return best;
}

}  // namespace myoface
