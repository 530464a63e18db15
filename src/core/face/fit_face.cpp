// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/face/face_model.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/normals.h"

#include "bone_placement.h"
#include "eyeballs.h"
#include "head/skull.h"
#include "head_warps.h"
#include "landmark_pose.h"
#include "lip_cut.h"
#include "lip_sides.h"
#include "mouth_lining.h"
#include "muscle_placement.h"
#include "skin_part.h"
#include "skin_resolution.h"
#include "sliding_surface.h"

namespace myoface {
namespace {

Points on_average(const Points& scan, const Similarity& to_generic, const HeadWarps& warps) {
    const Mat3 turn = to_generic.scale * to_generic.rotation;
    return warps.to_average(Points((turn * scan).colwise() + to_generic.shift));
}

/// The surroundings of the mouth, cut out of a part of the scan.
struct Mouth {
    TriangleMesh mesh;
    Points generic;           ///< 3×vertices, on the average head
    std::vector<int> vertex;  ///< of the part
};

Mouth mouth_of(const TriangleMesh& part, const Similarity& to_generic, const HeadWarps& warps) {
    const Vec3 low(-50.0, -90.0, 30.0);
    const Vec3 high(50.0, -16.0, 130.0);
    Mouth mouth;
    std::vector<int> number(static_cast<std::size_t>(part.vertex_count()), -1);
    for (int v = 0; v < part.vertex_count(); ++v) {
        const Vec3 p = to_generic(Vec3(part.vertices.col(v)));
        if ((p.array() > low.array()).all() && (p.array() < high.array()).all()) {
            number[static_cast<std::size_t>(v)] = static_cast<int>(mouth.vertex.size());
            mouth.vertex.push_back(v);
        }
    }
    mouth.mesh.vertices = part.vertices(Eigen::all, mouth.vertex);
    std::vector<Eigen::Vector3i> triangles;
    for (int t = 0; t < part.triangle_count(); ++t) {
        const Eigen::Vector3i v = part.triangles.col(t).unaryExpr(
            [&](int corner) { return number[static_cast<std::size_t>(corner)]; });
        if (v.minCoeff() >= 0) {
            triangles.push_back(v);
        }
    }
    mouth.mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        mouth.mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
    }
    mouth.generic = on_average(mouth.mesh.vertices, to_generic, warps);
    return mouth;
}

/// Parts lips that the scanner closed, so that the mouth can open.
/// @return per vertex of the new scan the lip it belongs to, as in PartedLips; empty where the lips
/// are not grown together
std::vector<signed char> cut_open(FaceModel& face, WeldedMesh& part, Mouth& mouth,
                                  const HeadWarps& warps, const Vec3& nose) {
    const Scan& scan = *face.scan;
    Points generic =
        Points::Constant(3, scan.mesh.vertex_count(), std::numeric_limits<double>::quiet_NaN());
    std::vector<int> in_mouth(static_cast<std::size_t>(part.mesh.vertex_count()), -1);
    for (std::size_t k = 0; k < mouth.vertex.size(); ++k) {
        in_mouth[static_cast<std::size_t>(mouth.vertex[k])] = static_cast<int>(k);
    }
    for (int v = 0; v < scan.mesh.vertex_count(); ++v) {
        const int welded = part.of_vertex[static_cast<std::size_t>(v)];
        if (welded >= 0 && in_mouth[static_cast<std::size_t>(welded)] >= 0) {
            generic.col(v) = mouth.generic.col(in_mouth[static_cast<std::size_t>(welded)]);
        }
    }
    std::optional<PartedLips> parted = part_lips(scan, generic);
    if (!parted) {
        return {};
    }
    face.scan = std::move(parted->scan);
    part = main_part(*face.scan, nose);
    mouth = mouth_of(part.mesh, face.to_generic, warps);
    return std::move(parted->side);
}

/// Mesh, nodes and labels of the lips: all that is known of the skin before the anatomy.
void set_skin(FaceModel& face, const HeadWarps& warps, const Vec3& nose, int finest,
              WeldedMesh part) {
    const int own_vertices = face.scan->mesh.vertex_count();
    Mouth mouth = mouth_of(part.mesh, face.to_generic, warps);
    const std::vector<signed char> side = cut_open(face, part, mouth, warps, nose);
    face.lip_contacts = find_lip_contacts(mouth.mesh, mouth.generic);
    for (auto& [upper, lower] : face.lip_contacts) {
        upper = mouth.vertex[static_cast<std::size_t>(upper)];
        lower = mouth.vertex[static_cast<std::size_t>(lower)];
    }
    face.skin = simulated_skin(part, face.to_generic, finest, face.lip_contacts);
    if (!face.scan->triangle_part.empty()) {
        face.skin.part =
            face.scan->triangle_part[static_cast<std::size_t>(part.of_triangle.front())];
    }
    const TriangleMesh& mesh = face.skin.mesh;
    face.adjacency = std::make_shared<Adjacency>(mesh);
    face.skin.normals = vertex_normals(mesh, *face.adjacency);
    if (face.skin.coarse()) {
        prepare_following(face.skin, *face.adjacency);
    }
    face.area = vertex_areas(mesh);
    face.own_vertices = own_vertices;
    face.own_nodes =
        static_cast<int>(std::count_if(face.skin.vertex.begin(), face.skin.vertex.end(),
                                       [&](int vertex) { return vertex < own_vertices; }));
    face.generic = on_average(mesh.vertices, face.to_generic, warps);
    face.from_generic = warps.from_average;
    face.lip_side.assign(static_cast<std::size_t>(face.node_count()), 0);
    for (std::size_t node = 0; node < face.lip_side.size() && !side.empty(); ++node) {
        face.lip_side[node] = side[static_cast<std::size_t>(face.skin.vertex[node])];
    }
    face.lip_side = find_lip_sides(face);
}

/// From landmarks, then from the front of the face and its mirror image.
Midplane find_midplane(const FaceModel& face, const Bvh& bvh) {
    constexpr int kPoints = 2500;
    std::vector<int> front;
    for (int v = 0; v < face.node_count(); ++v) {
        const Vec3 p = face.generic.col(v);
        const bool mask = p.z() > 40.0 && std::abs(p.x()) < 62.0 && p.y() > -85.0 && p.y() < 60.0;
        if (mask && face.tissue[static_cast<std::size_t>(v)].tissue == Tissue::Skin) {
            front.push_back(v);
        }
    }
    const auto stride = std::max<std::size_t>(1, front.size() / kPoints);
    Points points(3, static_cast<Eigen::Index>((front.size() + stride - 1) / stride));
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        points.col(i) = face.skin.mesh.vertices.col(front[static_cast<std::size_t>(i) * stride]);
    }
    return refined(midplane_of(face.landmarks), face.skin.mesh, bvh, points);
}

}  // namespace

std::future<void> prepare_fitting() {
    return std::async(std::launch::async, [] { generic_skull(); });
}

Points shape_of_scan(const FaceModel& face, const Points& skin) {
    const Points moved = skin - face.skin.mesh.vertices;
    if (moved.isZero(0.0)) {
        return Points(3, 0);
    }
    if (face.skin.coarse()) {
        const Points& scan = face.scan->mesh.vertices;
        Points shape = follow(face.skin, *face.adjacency, scan, skin) - scan;
        for (std::size_t node = 0; node < face.skin.vertex.size(); ++node) {
            shape.col(face.skin.vertex[node]) = moved.col(static_cast<Eigen::Index>(node));
        }
        return shape.leftCols(face.own_vertices);
    }
    Points shape = Points::Zero(3, face.own_vertices);
    for (int v = 0; v < face.own_vertices; ++v) {
        const int node = face.skin.between(0, v);
        if (node >= 0) {
            shape.col(v) = moved.col(node);
        }
    }
    return shape;
}

Points shaped_skin(const FaceModel& face, const Points& shape) {
    Points skin = face.skin.mesh.vertices;
    if (shape.cols() == 0) {
        return skin;
    }
    const bool of_vertices = shape.cols() == face.own_vertices;
    if (!of_vertices && shape.cols() != face.own_nodes) {  // the first cases kept it per node
        throw InvalidInput("The kept shape does not belong to this scan.");
    }
    const auto moved = [&](int node) {
        return shape.col(of_vertices ? face.skin.vertex[static_cast<std::size_t>(node)] : node);
    };
    for (int node = 0; node < face.own_nodes; ++node) {
        skin.col(node) += moved(node);
    }
    for (int node = face.own_nodes; node < face.node_count(); ++node) {
        Vec3 sum = Vec3::Zero();  // margins of parted lips go with the lips
        double count = 0.0;
        for (const int w : face.adjacency->neighbours(node)) {
            if (w < face.own_nodes) {
                sum += moved(w);
                count += 1.0;
            }
        }
        skin.col(node) += sum / std::max(count, 1.0);
    }
    return skin;
}

Vec3 from_generic(const FaceModel& face, const Vec3& p) {
    return face.to_generic.inverse()(face.from_generic(p));
}

std::shared_ptr<const FaceModel> fit_face(std::shared_ptr<const Scan> scan, const Landmarks& given,
                                          const Progress* progress, const FitOptions& options) {
    const auto report = [&](const char* stage, double share) {
        if (progress != nullptr) {
            progress->report(stage, share);
        }
    };
    const std::future<void> prepared = prepare_fitting();
    report("Fitting the face", 0.0);
    auto face = std::make_shared<FaceModel>();
    face->landmarks = given;
    face->to_generic = pose_of(face->landmarks);
    if (face->to_generic.scale < 0.5 || face->to_generic.scale > 2.0) {
        throw InvalidInput(
            "The face would be " +
            std::to_string(static_cast<int>(std::lround(130.0 / face->to_generic.scale))) +
            " mm wide: give the right unit with --unit.");
    }
    settle_nasion(face->landmarks, face->to_generic);
    face->axes = face->to_generic.rotation.transpose();
    const Vec3 nose = face->landmarks.at(face->landmarks.count("prn") != 0 ? "prn" : "sn").position;
    face->scan = std::move(scan);
    WeldedMesh part = main_part(*face->scan, nose);
    if (part.mesh.triangle_count() < 100) {
        throw InvalidInput("The scan has too few triangles to be a face.");
    }
    check_near(face->landmarks, part.mesh);
    report("Fitting the face", 0.2);

    const HeadWarps warps = fit_head(part.mesh, face->to_generic, face->landmarks);
    set_skin(*face, warps, nose, options.finest, std::move(part));
    report("Fitting the face", 0.5);

    const TriangleMesh& mesh = face->skin.mesh;
    const SmoothFace smooth = smooth_face(mesh, *face->adjacency);
    const Eigen::VectorXd depths = tissue_depths(face->generic, options.tissue);
    for (int v = 0; v < face->node_count(); ++v) {
        const Vec3 normal = face->skin.normals.col(v);
        const bool inward = normal.dot(smooth.normals.col(v)) < 0.0 ||
                            looks_inward(face->generic.col(v), face->to_generic.rotation * normal);
        face->tissue.push_back(
            tissue_at(face->generic.col(v), depths[v] / face->to_generic.scale, inward));
    }
    face->sliding = sliding_surfaces(mesh, *face->adjacency, smooth.normals);
    report("Fitting the face", 0.7);

    const auto onto_scan = [&](const Vec3& p) { return from_generic(*face, p); };
    place_muscles(*face, smooth.normals, onto_scan);
    label_skin(*face);
    report("Fitting the face", 0.85);
    place_skull(*face, onto_scan, options.tissue);
    face->obstacles = obstacles_of(*face);
    face->obstacle_distance = obstacle_distances(*face);
    if (!face->lip_contacts.empty() && !has_mouth_bag(face->scan->mesh, onto_scan)) {
        face->mouth = mouth_lining(onto_scan);
    }
    face->eyeballs = eyeballs_for(*face);
    face->midplane = find_midplane(*face, Bvh(mesh));
    report("Fitting the face", 1.0);
    return face;
}

}  // namespace myoface
