// SPDX-License-Identifier: Apache-2.0
#include "myoface/measure/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>

namespace myoface {
namespace {

constexpr double kBehindFace = 115.0;  // what lies further behind the nose is no face [mm]
constexpr double kUpright = 55.0;      // the same in upright cuts, which would show the neck
constexpr double kAbove = 95.0;        // [mm] over the nose
constexpr double kBelow = 95.0;        // [mm] under it

/// A crossing of an edge, known by the edge: the same one from both triangles.
using Crossing = std::pair<int, int>;

Vec3 nose(const FaceModel& face) {
    const auto found = face.landmarks.find("prn");
    return found != face.landmarks.end() ? found->second.position : face.midplane.point;
}

/// Chains segments that share ends.
std::vector<std::deque<Crossing>> chained(const std::vector<std::pair<Crossing, Crossing>>& parts) {
    std::map<Crossing, std::vector<std::size_t>> at;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        at[parts[i].first].push_back(i);
        at[parts[i].second].push_back(i);
    }
    std::vector<char> used(parts.size(), 0);
    std::vector<std::deque<Crossing>> chains;
    for (std::size_t start = 0; start < parts.size(); ++start) {
        if (used[start] != 0) {
            continue;
        }
        used[start] = 1;
        std::deque<Crossing> chain{parts[start].first, parts[start].second};
        const auto grow = [&](bool back) {
            for (bool found = true; found;) {
                found = false;
                const Crossing end = back ? chain.back() : chain.front();
                for (const std::size_t i : at[end]) {
                    if (used[i] == 0) {
                        used[i] = 1;
                        const Crossing next =
                            parts[i].first == end ? parts[i].second : parts[i].first;
                        back ? chain.push_back(next) : chain.push_front(next);
                        found = true;
                        break;
                    }
                }
            }
        };
        grow(true);
        grow(false);
        chains.push_back(std::move(chain));
    }
    return chains;
}

double distance_to(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d way = b - a;
    const double length = way.squaredNorm();
    const double share = length > 0.0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0.0;
    return (p - a - share * way).norm();
}

}  // namespace

SectionPlane profile_plane(const FaceModel& face) {
    SectionPlane plane = sagittal_plane(face, face.midplane.point);
    plane.normal = face.midplane.normal;
    const Vec3 tip = nose(face);
    plane.through = tip - side_of(face.midplane, tip) * face.midplane.normal;
    return plane;
}

SectionPlane horizontal_plane(const FaceModel& face, const Vec3& through) {
    return {through, face.axes.col(1), face.axes.col(0), face.axes.col(2)};
}

SectionPlane sagittal_plane(const FaceModel& face, const Vec3& through) {
    return {through, face.axes.col(0), -face.axes.col(2), face.axes.col(1)};
}

SectionPlane free_plane(const FaceModel& face, const Vec3& through, const Vec3& normal) {
    SectionPlane plane;
    plane.through = through;
    plane.normal = normal.normalized();
    // As upright as the plane allows; a level one shows the front above.
    const auto within = [&](const Vec3& axis) {
        return Vec3(axis - plane.normal.dot(axis) * plane.normal);
    };
    const Vec3 upright = within(face.axes.col(1));
    plane.up = (upright.norm() > 0.5 ? upright : within(face.axes.col(2))).normalized();
    plane.right = plane.up.cross(plane.normal);
    if (plane.right.dot(face.axes.col(0) - face.axes.col(2)) < 0.0) {
        plane.right = -plane.right;
    }
    return plane;
}

Triangles seen_skin(const FaceModel& face) {
    const Triangles& all = face.skin.mesh.triangles;
    Triangles kept(3, all.cols());
    Eigen::Index count = 0;
    for (Eigen::Index t = 0; t < all.cols(); ++t) {
        bool skin = true;
        for (int c = 0; c < 3; ++c) {
            skin = skin && face.label[static_cast<std::size_t>(all(c, t))].tissue != Tissue::Mucosa;
        }
        if (skin) {
            kept.col(count++) = all.col(t);
        }
    }
    kept.conservativeResize(3, count);
    return kept;
}

std::vector<SectionLine> section(const FaceModel& face, const Triangles& skin, const Points& nodes,
                                 const SectionPlane& plane) {
    const Vec3 tip = nose(face);
    const Vec3 front = face.axes.col(2);
    const Vec3 upwards = face.axes.col(1);
    const double behind = std::abs(plane.normal.dot(upwards)) < 0.5 ? kUpright : kBehindFace;
    std::vector<std::pair<Crossing, Crossing>> parts;
    std::map<Crossing, Eigen::Vector2d> place;
    const auto side = [&](int v) { return plane.normal.dot(nodes.col(v) - plane.through); };
    for (Eigen::Index t = 0; t < skin.cols(); ++t) {
        std::array<Crossing, 2> ends;
        int count = 0;
        for (int c = 0; c < 3; ++c) {
            const int a = std::min(skin(c, t), skin((c + 1) % 3, t));
            const int b = std::max(skin(c, t), skin((c + 1) % 3, t));
            const double at_a = side(a);
            const double at_b = side(b);
            if ((at_a > 0.0) == (at_b > 0.0)) {
                continue;
            }
            const Vec3 cut = nodes.col(a) + at_a / (at_a - at_b) * (nodes.col(b) - nodes.col(a));
            const Vec3 off = cut - tip;
            if (front.dot(off) < -behind || upwards.dot(off) > kAbove ||
                upwards.dot(off) < -kBelow) {
                count = 0;
                break;
            }
            ends[static_cast<std::size_t>(count++)] = {a, b};
            place[{a, b}] = {plane.right.dot(cut - plane.through),
                             plane.up.dot(cut - plane.through)};
        }
        if (count == 2) {
            parts.emplace_back(ends[0], ends[1]);
        }
    }
    std::vector<SectionLine> lines;
    for (const std::deque<Crossing>& chain : chained(parts)) {
        SectionLine line;
        for (const Crossing& crossing : chain) {
            line.push_back(place.at(crossing));
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

double largest_gap(const std::vector<SectionLine>& before, const std::vector<SectionLine>& now) {
    double largest = 0.0;
    for (const SectionLine& line : now) {
        for (const Eigen::Vector2d& p : line) {
            double nearest = std::numeric_limits<double>::infinity();
            double nearest_end = std::numeric_limits<double>::infinity();
            for (const SectionLine& other : before) {
                for (std::size_t i = 1; i < other.size(); ++i) {
                    nearest = std::min(nearest, distance_to(p, other[i - 1], other[i]));
                }
                if (!other.empty() && other.front() != other.back()) {
                    nearest_end = std::min(
                        {nearest_end, (p - other.front()).norm(), (p - other.back()).norm()});
                }
            }
            // Beyond the end of a line there is nothing to be apart from.
            if (std::isfinite(nearest) && nearest < nearest_end) {
                largest = std::max(largest, nearest);
            }
        }
    }
    return largest;
}

std::string section_csv(const std::vector<SectionLine>& before,
                        const std::vector<SectionLine>& now) {
    std::ostringstream text;
    text << "state,line,right_mm,up_mm\n" << std::fixed << std::setprecision(3);
    for (const auto& [state, lines] : {std::pair("before", &before), std::pair("now", &now)}) {
        for (std::size_t l = 0; l < lines->size(); ++l) {
            for (const Eigen::Vector2d& p : (*lines)[l]) {
                text << state << ',' << l + 1 << ',' << p.x() << ',' << p.y() << '\n';
            }
        }
    }
    return text.str();
}

}  // namespace myoface
