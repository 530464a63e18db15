// SPDX-License-Identifier: Apache-2.0
#include "skull.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <sstream>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/base/resources.h"
#include "myoface/base/smooth_step.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/io/text_file.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/isosurface.h"
#include "myoface/mesh/remesh.h"

#include "head_colour.h"
#include "head_mesh.h"
#include "head_parts.h"
#include "mesh_builder.h"
#include "primitives.h"

namespace myoface {
namespace {

/// Skull and mandible as fields [mm], negative inside. The outer surface is the smooth face less
/// the tissue's depth; what the face does not show is cut out of it or added.
class SkullField {
public:
    SkullField() {
        const DepthSites& sites = depth_sites();
        const Eigen::Index n = std::count(sites.bony.begin(), sites.bony.end(), 1);
        Points bone(3, n);
        Points offset = Points::Zero(3, n);
        Eigen::Index k = 0;
        for (Eigen::Index i = 0; i < sites.depths.size(); ++i) {
            if (sites.bony[static_cast<std::size_t>(i)] != 0) {
                bone.col(k) = sites.places.col(i) - sites.depths[i] * sites.normals.col(i);
                // Whatever the smooth face lacks here (lips, nose), bone lies where the table says.
                offset(0, k) = -average_head().smooth_face(bone.col(k));
                ++k;
            }
        }
        depth_ = SmoothWarp(bone, offset, Eigen::VectorXd::Zero(n), 0.0);
    }

    double cranium(const Vec3& q) const {
        const Vec3 p(std::abs(q.x()), q.y(), q.z());
        const double face = average_head().smooth_face(q);
        if (std::abs(face) > 45.0) {
            return face;
        }
        const double outer = face + depth_(q).x();
        double d = outer;
        // Temporal fossa, with the cheek arch across it.
        d = subtract(d, ellipsoid(p, {63, 6, 25}, {20, 24, 20}), 7.0);
        // Below the arch the skull is narrow: pterygoid region.
        d = subtract(d, ellipsoid(p, {57, -34, 22}, {23, 32, 23}), 8.0);
        d = subtract(d, ellipsoid(q, {0, -62, 14}, {40, 38, 36}), 8.0);
        // Base: under the upper jaw, behind it, and the occiput.
        const double base = q.z() > 40.0 ? -46.0
                                         : -46.0 + 24.5 * smooth_step(40.0, 20.0, q.z()) -
                                               14.0 * smooth_step(2.0, -22.0, q.z()) +
                                               6.0 * smooth_step(-30.0, -60.0, q.z());
        d = smooth_max(d, base - q.y(), 5.0);
        d = smooth_min(d, ellipsoid(p, {53, -22, -14}, {8, 18, 11}), 8.0);  // mastoid
        const double arch = std::min({capsule(p, {47, -6, 56}, {55, -5.5, 40}, 5.0, 3.6),
                                      capsule(p, {55, -5.5, 40}, {57.5, -3.5, 18}, 3.6, 3.2),
                                      capsule(p, {57.5, -3.5, 18}, {55, 1, -6}, 3.2, 4.0)});
        d = smooth_min(d, arch, 2.5);
        // Orbits: cones that open outwards and forward.
        const Vec3 in_orbit = turned(p - Vec3(32.5, 17.0, 68.0), -20.0);
        const double narrow = 1.0 - 0.45 * smooth_step(12.0, -30.0, in_orbit.z());
        d = subtract(d, (rounded_box(in_orbit, Vec3(19.5 * narrow, 17.0 * narrow, 34.0), 13.5)),
                     3.0);
        // Piriform aperture, narrow above; the nasal bones roof it.
        const double wide = 12.0 - 7.5 * smooth_step(-22.0, 4.0, q.y());
        const double aperture =
            rounded_box(q - Vec3(0.0, -13.0, 88.0), Vec3(wide, 17.0, 34.0), 0.9 * wide);
        d = subtract(d, aperture, 1.5);
        const double septum = std::max(
            {std::abs(q.x()) - 0.9, outer + 6.0, 52.0 - q.z(), q.y() - 6.0, -32.0 - q.y()});
        d = smooth_min(d, septum, 1.5);
        return d;
    }

    double mandible(const Vec3& q) const {
        const Vec3 p(std::abs(q.x()), q.y(), q.z());
        const double face = average_head().smooth_face(q);
        if (std::abs(face) > 45.0) {
            return std::abs(face);
        }
        const double outer = face + depth_(q).x();
        // Body: an arch under the skin, 11 mm thick, from the teeth down.
        double body = smooth_max(outer, -(outer + 11.0), 2.0);
        const double inner =
            std::hypot(p.x() / 31.0, (q.z() - 12.0) / 63.0) - 1.0;  // the floor of the mouth
        body = smooth_max(body, -28.0 * inner, 3.0);
        body = smooth_max(body, 52.0 - q.z(), 6.0);
        const double lower = std::min(capsule(p, {20, -85, 73}, {36, -77, 48}, 6.5, 6.5),
                                      capsule(p, {36, -77, 48}, {45.5, -66, 18}, 6.5, 6.0));
        const double upper = std::min(capsule(p, {22, -70, 74}, {34, -65, 50}, 6.0, 5.5),
                                      capsule(p, {34, -65, 50}, {44, -56, 28}, 5.5, 4.5));
        body = smooth_min(body, smooth_max(smooth_min(lower, upper, 10.0), outer, 3.0), 6.0);
        body = smooth_max(body, q.y() + 60.0 - 0.16 * (80.0 - q.z()), 3.0);
        // Ramus: a thin plate up to the condyle behind and the coronoid process in front.
        const Vec3 low_back(43.5, -63, 13);
        const Vec3 low_front(41.0, -58, 32);
        const Vec3 condyle(50.5, -8, 8);
        const Vec3 coronoid(46.0, -11, 31);
        const double plate = std::min({capsule(p, low_back, condyle, 5.0, 3.6),
                                       capsule(p, low_front, coronoid, 4.6, 2.4),
                                       capsule(p, low_back, low_front, 6.0, 6.0),
                                       capsule(p, {44.5, -45, 20}, {47.0, -25, 18}, 7.5, 6.0)});
        const double across = std::abs(p.x() - (41.8 + 0.15 * (q.y() + 64.0))) - 3.3;
        double ramus = smooth_max(plate - 2.5, across, 3.0);
        ramus = subtract(ramus, capsule(p, {49, -4, 20}, {48.5, -15, 19.5}, 6.0, 4.5), 3.0);
        ramus = smooth_min(ramus, ellipsoid(p, {50.5, -6, 8}, {8.5, 4, 4.2}), 4.0);
        body = smooth_max(body, outer, 1.5);
        return smooth_min(body, ramus, 7.0);
    }

private:
    static Vec3 turned(const Vec3& d, double degrees) {
        const double angle = degrees * std::numbers::pi / 180.0;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        return {c * d.x() + s * d.z(), d.y(), c * d.z() - s * d.x()};
    }

    SmoothWarp depth_;
};

/// One half by isosurface and remeshing, mirrored.
TriangleMesh symmetric_surface(const ScalarField& field, const Eigen::AlignedBox3d& box,
                               double edge) {
    const TriangleMesh raw = isosurface(field, box, 2.6);
    RemeshOptions options;
    options.rounds = 3;
    options.edge_length = [edge](const Vec3&) { return edge; };
    options.project = [&](const Vec3& p, int line) {
        Vec3 at = p;
        for (int step = 0; step < 2; ++step) {
            constexpr double kStep = 0.02;
            const double value = field(at);
            Vec3 slope;
            for (int axis = 0; axis < 3; ++axis) {
                Vec3 ahead = at;
                ahead[axis] += kStep;
                slope[axis] = (field(ahead) - value) / kStep;
            }
            if (line != kFreeVertex) {
                slope.x() = 0.0;
            }
            const double square = std::max(slope.squaredNorm(), 0.04);
            Vec3 move = -value / square * slope;
            if (move.norm() > 1.5) {
                move *= 1.5 / move.norm();
            }
            at += move;
        }
        at.x() = line != kFreeVertex ? 0.0 : std::max(at.x(), 0.0);
        return at;
    };
    const TriangleMesh half = remesh(raw, options).mesh;
    MeshBuilder builder(half);
    std::vector<int> other(builder.vertices.size());
    for (int v = 0; v < half.vertex_count(); ++v) {
        const Vec3 p = half.vertices.col(v);
        other[v] = p.x() == 0.0 ? v : builder.add({-p.x(), p.y(), p.z()});
    }
    for (int t = 0; t < half.triangle_count(); ++t) {
        builder.triangles.emplace_back(other[half.triangles(0, t)], other[half.triangles(2, t)],
                                       other[half.triangles(1, t)]);
    }
    return builder.mesh();
}

void append(MeshBuilder& whole, std::vector<BonePart>& part, const TriangleMesh& piece,
            BonePart kind) {
    const auto first = static_cast<int>(whole.vertices.size());
    for (int v = 0; v < piece.vertex_count(); ++v) {
        whole.add(piece.vertices.col(v));
        part.push_back(kind);
    }
    for (int t = 0; t < piece.triangle_count(); ++t) {
        whole.triangles.emplace_back(piece.triangles.col(t).array() + first);
    }
}

void append_teeth(MeshBuilder& whole, std::vector<BonePart>& part, bool upper) {
    MeshBuilder left;
    const Vec3 lips = average_head().front_point_at(0.0, average_head().lip_line(0.0));
    add_teeth(left, lips, upper, 10);
    const TriangleMesh teeth = left.mesh();
    TriangleMesh mirror = teeth;
    mirror.vertices.row(0) *= -1.0;
    mirror.triangles.row(1).swap(mirror.triangles.row(2));
    const BonePart kind = upper ? BonePart::UpperTeeth : BonePart::LowerTeeth;
    append(whole, part, teeth, kind);
    append(whole, part, mirror, kind);
}

Vec3 slope_of(const Vec3& p) {
    constexpr double kStep = 0.5;
    Vec3 slope;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 ahead = p;
        Vec3 behind = p;
        ahead[axis] += kStep;
        behind[axis] -= kStep;
        slope[axis] = average_head().smooth_face(ahead) - average_head().smooth_face(behind);
    }
    return slope;
}

/// The average head's skin without linings and nostrils.
TriangleMesh outer_head() {
    constexpr int kVertices = 10000;
    const HeadMesh head = average_head_mesh(kVertices, nullptr);
    const auto hidden = [&](int v) {
        return head.part[static_cast<std::size_t>(v)] != HeadPart::Skin ||
               nostril_share(average_head().in_primitives(head.mesh.vertices.col(v))) > 0.2;
    };
    TriangleMesh skin{head.mesh.vertices, Triangles(3, head.mesh.triangle_count())};
    Eigen::Index count = 0;
    for (int t = 0; t < head.mesh.triangle_count(); ++t) {
        const Eigen::Vector3i v = head.mesh.triangles.col(t);
        if (!hidden(v[0]) && !hidden(v[1]) && !hidden(v[2])) {
            skin.triangles.col(count++) = v;
        }
    }
    skin.triangles.conservativeResize(3, count);
    return skin;
}

Skull build_skull() {
    const SkullField field;
    Skull skull;
    MeshBuilder whole;
    append(whole, skull.part,
           symmetric_surface([&](const Vec3& p) { return field.cranium(p); },
                             Eigen::AlignedBox3d(Vec3(0, -56, -112), Vec3(82, 140, 118)), 3.2),
           BonePart::Cranium);
    append(whole, skull.part,
           symmetric_surface([&](const Vec3& p) { return field.mandible(p); },
                             Eigen::AlignedBox3d(Vec3(0, -108, -6), Vec3(66, 6, 104)), 2.6),
           BonePart::Mandible);
    append_teeth(whole, skull.part, true);
    append_teeth(whole, skull.part, false);
    skull.mesh = whole.mesh();
    const TriangleMesh skin = outer_head();
    const Bvh bvh(skin);
    skull.skin.resize(3, skull.mesh.vertex_count());
    parallel_for(skull.mesh.vertex_count(), 128, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            skull.skin.col(v) = bvh.closest_point(skin, skull.mesh.vertices.col(v)).point;
        }
    });
    return skull;
}

DepthSites read_sites() {
    std::istringstream text(read_file(resource_path("assets/tissue_depth.csv")));
    std::string line;
    std::getline(text, line);
    DepthSites sites;
    std::vector<Vec3> places;
    std::vector<double> depths;
    while (std::getline(text, line)) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) {
            cells.push_back(cell);
        }
        if (cells.size() < 7) {
            continue;
        }
        std::array<double, 4> v{};
        for (std::size_t i = 0; i < 4; ++i) {
            const std::string& cell = cells[i + 2];
            if (std::from_chars(cell.data(), cell.data() + cell.size(), v[i]).ec != std::errc()) {
                throw IoError("assets/tissue_depth.csv: '" + cell + "' is not a number.");
            }
        }
        const bool paired = cells[1] == "yes";
        // The table's places are near the skin; the sites lie on it.
        Vec3 on_skin(v[0], v[1], v[2]);
        for (int step = 0; step < 4; ++step) {
            on_skin = average_head().onto_surface(on_skin, !paired);
        }
        const char bony = cells[6].rfind("cartilage", 0) == 0 ? 0 : 1;
        sites.bony.insert(sites.bony.end(), paired ? 2 : 1, bony);
        places.push_back(on_skin);
        depths.push_back(v[3]);
        if (paired) {
            places.emplace_back(-on_skin.x(), on_skin.y(), on_skin.z());
            depths.push_back(v[3]);
        }
    }
    const auto n = static_cast<Eigen::Index>(places.size());
    sites.places.resize(3, n);
    sites.normals.resize(3, n);
    sites.depths.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        sites.places.col(i) = places[k];
        sites.normals.col(i) = slope_of(places[k]).normalized();
        sites.depths[i] = depths[k];
    }
    return sites;
}

}  // namespace

const DepthSites& depth_sites() {
    static const DepthSites kSites = read_sites();
    return kSites;
}

const Skull& generic_skull() {
    static const Skull kSkull = build_skull();
    return kSkull;
}

JawHinge generic_jaw_hinge() {
    JawHinge hinge;
    hinge.centre = {0.0, -6.0, 11.0};
    hinge.slide = {0.0, -5.0, 7.0};
    hinge.full_opening = 24.0 * std::numbers::pi / 180.0;
    return hinge;
}

JawPose between(const JawPose& from, const JawPose& to, double share) {
    JawPose pose;
    pose.open = from.open + share * (to.open - from.open);
    pose.thrust = from.thrust + share * (to.thrust - from.thrust);
    pose.left = from.left + share * (to.left - from.left);
    return pose;
}

Vec3 opened(const JawHinge& hinge, const JawPose& pose, const Vec3& p) {
    // The mouth opens downwards: a positive turn about the axis to the left.
    const Eigen::AngleAxisd turn(pose.open * hinge.full_opening, hinge.axis);
    Vec3 at = hinge.centre + turn * (p - hinge.centre) + pose.open * hinge.slide;
    if (pose.thrust == 0.0 && pose.left == 0.0) {
        return at;
    }
    at += pose.thrust * hinge.full_thrust * hinge.front;
    const Vec3 condyle = hinge.centre + std::copysign(hinge.to_condyle, pose.left) * hinge.axis;
    const Eigen::AngleAxisd sideways(pose.left * hinge.full_turn, hinge.front.cross(hinge.axis));
    return condyle + sideways * (at - condyle);
}

}  // namespace myoface
