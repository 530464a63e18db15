// SPDX-License-Identifier: Apache-2.0
#include "myoface/mesh/orientation.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "myoface/base/parallel.h"

namespace myoface {
namespace {

/// A side of a triangle under its lower vertex. Side 3t + c runs from corner c to the next one.
struct SideSeen {
    int high = 0;
    int number = 0;
};

/// How the sides of all triangles meet.
struct SidesSeen {
    std::vector<int> across;   ///< side -> side of the only other triangle there, or -1
    std::vector<int> borders;  ///< sides without another triangle
    int non_manifold_edges = 0;
    bool all_agree = true;  ///< paired sides run against each other
};

bool runs_up(const TriangleMesh& mesh, int side) {
    return mesh.triangles(side % 3, side / 3) < mesh.triangles((side % 3 + 1) % 3, side / 3);
}

SidesSeen pair_sides(const TriangleMesh& mesh) {
    const int n = mesh.vertex_count();
    const int triangles = mesh.triangle_count();
    std::vector<int> start(static_cast<std::size_t>(n) + 1, 0);
    const int* const corner = mesh.triangles.data();
    const auto ends = [&](int side) {
        const int a = corner[side];
        const int b = corner[side % 3 == 2 ? side - 2 : side + 1];
        return std::pair(std::min(a, b), std::max(a, b));
    };
    for (int side = 0; side < 3 * triangles; ++side) {
        ++start[static_cast<std::size_t>(ends(side).first) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<SideSeen> sides(static_cast<std::size_t>(start.back()));
    {
        std::vector<int> at(start.begin(), start.end() - 1);
        for (int side = 0; side < 3 * triangles; ++side) {
            const auto [low, high] = ends(side);
            sides[static_cast<std::size_t>(at[static_cast<std::size_t>(low)]++)] = {high, side};
        }
    }
    SidesSeen result;
    result.across.assign(sides.size(), -1);
    constexpr int kGrain = 16384;
    struct Share {
        std::vector<int> borders;
        int non_manifold = 0;
        bool agree = true;
    };
    std::vector<Share> shares(static_cast<std::size_t>(n / kGrain) + 1);
    parallel_for(n, kGrain, [&](int begin, int end) {
        Share& share = shares[static_cast<std::size_t>(begin / kGrain)];
        for (int v = begin; v < end; ++v) {
            const auto first = sides.begin() + start[static_cast<std::size_t>(v)];
            const auto last = sides.begin() + start[static_cast<std::size_t>(v) + 1];
            std::sort(first, last, [](const SideSeen& p, const SideSeen& q) {
                return p.high != q.high ? p.high < q.high : p.number < q.number;
            });
            for (auto side = first; side != last;) {
                auto next = side + 1;
                while (next != last && next->high == side->high) {
                    ++next;
                }
                if (next - side == 1) {
                    share.borders.push_back(side->number);
                } else if (next - side == 2) {
                    const int other = (side + 1)->number;
                    result.across[static_cast<std::size_t>(side->number)] = other;
                    result.across[static_cast<std::size_t>(other)] = side->number;
                    share.agree =
                        share.agree && runs_up(mesh, side->number) != runs_up(mesh, other);
                } else {
                    ++share.non_manifold;
                }
                side = next;
            }
        }
    });
    for (const Share& share : shares) {
        result.borders.insert(result.borders.end(), share.borders.begin(), share.borders.end());
        result.non_manifold_edges += share.non_manifold;
        result.all_agree = result.all_agree && share.agree;
    }
    return result;
}

/// Triangles that hang together across edges with exactly two triangles.
struct Sheets {
    std::vector<int> of_triangle;
    std::vector<double> area;
};

/// Numbers the sheets and marks in `turn` what disagrees with the first triangle of each.
Sheets walk(const TriangleMesh& mesh, const SidesSeen& sides, std::vector<bool>& turn) {
    const auto count = static_cast<std::size_t>(mesh.triangle_count());
    Sheets sheets;
    sheets.of_triangle.assign(count, -1);
    std::vector<int> queue;
    for (std::size_t first = 0; first < count; ++first) {
        if (sheets.of_triangle[first] >= 0) {
            continue;
        }
        const int sheet = static_cast<int>(sheets.area.size());
        sheets.area.push_back(0.0);
        queue.assign(1, static_cast<int>(first));
        sheets.of_triangle[first] = sheet;
        while (!queue.empty()) {
            const int t = queue.back();
            queue.pop_back();
            sheets.area.back() += double_area_vector(mesh, t).norm();
            for (int side = 3 * t; side < 3 * t + 3; ++side) {
                const int other = sides.across[static_cast<std::size_t>(side)];
                if (other < 0 || sheets.of_triangle[static_cast<std::size_t>(other / 3)] >= 0) {
                    continue;
                }
                sheets.of_triangle[static_cast<std::size_t>(other / 3)] = sheet;
                if (!turn.empty()) {
                    const bool agree = runs_up(mesh, side) != runs_up(mesh, other);
                    turn[static_cast<std::size_t>(other / 3)] =
                        turn[static_cast<std::size_t>(t)] == agree;
                }
                queue.push_back(other / 3);
            }
        }
    }
    return sheets;
}

/// Turns the smaller area of every sheet. @return triangles to be turned
int side_with_most(const TriangleMesh& mesh, const Sheets& sheets, std::vector<bool>& turn) {
    std::vector<double> turned(sheets.area.size(), 0.0);
    for (std::size_t t = 0; t < turn.size(); ++t) {
        if (turn[t]) {
            turned[static_cast<std::size_t>(sheets.of_triangle[t])] +=
                double_area_vector(mesh, static_cast<int>(t)).norm();
        }
    }
    int count = 0;
    for (std::size_t t = 0; t < turn.size(); ++t) {
        const auto sheet = static_cast<std::size_t>(sheets.of_triangle[t]);
        if (2.0 * turned[sheet] > sheets.area[sheet]) {
            turn[t].flip();
        }
        count += turn[t] ? 1 : 0;
    }
    return count;
}

/// Sheets with a negative volume, seen from their own middles.
std::vector<bool> inward_sheets(const TriangleMesh& mesh, const Sheets& sheets,
                                const std::vector<bool>& turn) {
    std::vector<Vec3> middle(sheets.area.size(), Vec3::Zero());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const auto sheet =
            static_cast<std::size_t>(sheets.of_triangle[static_cast<std::size_t>(t)]);
        middle[sheet] += double_area_vector(mesh, t).norm() / 3.0 *
                         (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2));
    }
    for (std::size_t s = 0; s < middle.size(); ++s) {
        middle[s] /= sheets.area[s] > 0.0 ? sheets.area[s] : 1.0;
    }
    std::vector<double> volume(sheets.area.size(), 0.0);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const auto k = static_cast<std::size_t>(t);
        const auto sheet = static_cast<std::size_t>(sheets.of_triangle[k]);
        const double part = (mesh.corner(t, 0) - middle[sheet]).dot(double_area_vector(mesh, t));
        volume[sheet] += !turn.empty() && turn[k] ? -part : part;
    }
    std::vector<bool> result;
    for (const double v : volume) {
        result.push_back(v < 0.0);
    }
    return result;
}

/// Follows border sides around the missing faces. @return count and longest length
std::pair<int, double> border_loops(const TriangleMesh& mesh, const std::vector<int>& borders) {
    // Where several borders meet in a vertex, or sides disagree, any way on will do.
    struct Step {
        int from, to;
    };
    std::vector<Step> steps;
    for (const int side : borders) {
        steps.push_back(
            {mesh.triangles((side % 3 + 1) % 3, side / 3), mesh.triangles(side % 3, side / 3)});
    }
    std::stable_sort(steps.begin(), steps.end(),
                     [](const Step& p, const Step& q) { return p.from < q.from; });
    std::vector<bool> used(steps.size(), false);
    const auto next_from = [&](int vertex) {
        auto at = std::lower_bound(steps.begin(), steps.end(), vertex,
                                   [](const Step& s, int v) { return s.from < v; });
        while (at != steps.end() && at->from == vertex &&
               used[static_cast<std::size_t>(at - steps.begin())]) {
            ++at;
        }
        return at != steps.end() && at->from == vertex ? at - steps.begin() : std::ptrdiff_t{-1};
    };
    int count = 0;
    double longest = 0.0;
    for (std::size_t first = 0; first < steps.size(); ++first) {
        if (used[first]) {
            continue;
        }
        double length = 0.0;
        for (auto k = static_cast<std::ptrdiff_t>(first); k >= 0;) {
            const Step step = steps[static_cast<std::size_t>(k)];
            used[static_cast<std::size_t>(k)] = true;
            length += (mesh.vertices.col(step.from) - mesh.vertices.col(step.to)).norm();
            k = step.to == steps[first].from ? -1 : next_from(step.to);
        }
        ++count;
        longest = std::max(longest, length);
    }
    return {count, longest};
}

}  // namespace

SurfaceCheck check_surface(const TriangleMesh& mesh) {
    SurfaceCheck result;
    const SidesSeen sides = pair_sides(mesh);
    result.non_manifold_edges = sides.non_manifold_edges;
    std::vector<bool> turn(sides.all_agree ? 0 : static_cast<std::size_t>(mesh.triangle_count()),
                           false);
    const Sheets sheets = walk(mesh, sides, turn);
    if (!turn.empty()) {
        result.disagreeing = side_with_most(mesh, sheets, turn);
    }
    std::tie(result.border_loops, result.longest_border) = border_loops(mesh, sides.borders);
    const std::vector<bool> inward = inward_sheets(mesh, sheets, turn);
    const auto largest = std::max_element(sheets.area.begin(), sheets.area.end());
    result.inward = largest != sheets.area.end() &&
                    inward[static_cast<std::size_t>(largest - sheets.area.begin())];
    if (result.inward) {
        turn.resize(static_cast<std::size_t>(mesh.triangle_count()), false);
        for (std::size_t t = 0; t < turn.size(); ++t) {
            if (inward[static_cast<std::size_t>(sheets.of_triangle[t])]) {
                turn[t].flip();
            }
        }
    }
    result.turn = std::move(turn);
    return result;
}

}  // namespace myoface
