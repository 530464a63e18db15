// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <limits>
#include <numbers>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/face/face_model.h"
#include "myoface/face/generic_face.h"
#include "myoface/io/mesh_file.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/normals.h"

#include "bone_placement.h"
#include "face_template.h"
#include "head/head_mesh.h"
#include "head/skull.h"
#include "lip_cut.h"
#include "muscle_placement.h"
#include "registration.h"
#include "sliding_surface.h"

namespace myoface {
namespace {

/// How much an error of 1 mm may unbend the warp [mm]; about the spacing of landmarks.
constexpr double kWarpSoftness = 1.5;
/// A landmark further off the scan than this is a mistake, not an imprecision.
constexpr double kFarOff = 25.0;

struct Pairs {
    std::vector<std::string> names;
    Points scan, generic;
    Eigen::VectorXd errors;
};

Pairs common_landmarks(const Landmarks& landmarks) {
    Pairs pairs;
    const Landmarks& generic = generic_landmarks();
    for (const auto& [name, landmark] : landmarks) {
        if (generic.count(name) != 0) {
            pairs.names.push_back(name);
        }
    }
    const auto n = static_cast<Eigen::Index>(pairs.names.size());
    pairs.scan.resize(3, n);
    pairs.generic.resize(3, n);
    pairs.errors.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const std::string& name = pairs.names[static_cast<std::size_t>(i)];
        pairs.scan.col(i) = landmarks.at(name).position;
        pairs.generic.col(i) = generic.at(name).position;
        pairs.errors[i] = landmarks.at(name).error_mm;
    }
    return pairs;
}

/// Those that need not be anatomically exact to tell how a head is turned.
void check_enough(const Landmarks& landmarks) {
    const auto has = [&](const char* name) { return landmarks.count(name) != 0; };
    const bool eyes = (has("en_l") || has("ex_l")) && (has("en_r") || has("ex_r"));
    const bool mouth = has("ch_l") && has("ch_r");
    const bool profile = has("prn") || has("sn");
    if (!eyes || !mouth || !profile) {
        throw InvalidInput(
            "The landmarks do not suffice: a corner of each eye (en or ex), both mouth corners "
            "(ch_l, ch_r) and the nose (prn or sn) are needed.");
    }
}

Eigen::VectorXd weights_of(const Pairs& pairs) {
    return (pairs.errors.array().square() + 4.0).inverse().matrix();
}

double rms(const Pairs& pairs, const Similarity& to_generic, const Eigen::VectorXd& weights) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < pairs.scan.cols(); ++i) {
        const Vec3 at = pairs.scan.col(i);
        sum += weights[i] * (to_generic(at) - Vec3(pairs.generic.col(i))).squaredNorm();
    }
    return std::sqrt(sum / weights.sum());
}

/// Many label sets call the deepest point of the nasal root "nasion"; the true one lies higher.
/// Which one was meant shows in its height over the inner canthi.
void settle_nasion(Landmarks& landmarks, const Similarity& to_generic) {
    if (landmarks.count("n") == 0 || landmarks.count("se") != 0 || landmarks.count("en_l") == 0 ||
        landmarks.count("en_r") == 0) {
        return;
    }
    const double canthi = 0.5 * (to_generic(landmarks["en_l"].position).y() +
                                 to_generic(landmarks["en_r"].position).y());
    const Landmarks& generic = generic_landmarks();
    const double middle = 0.5 * (generic.at("n").position.y() + generic.at("se").position.y());
    if (to_generic(landmarks["n"].position).y() - canthi <
        middle - generic.at("en_l").position.y()) {
        landmarks["se"] = landmarks["n"];
        landmarks.erase("n");
    }
}

/// Fits the pose and refuses what cannot be a face. @return scan -> average head
Similarity pose(const Landmarks& landmarks) {
    check_enough(landmarks);
    const Pairs pairs = common_landmarks(landmarks);
    const Eigen::VectorXd weights = weights_of(pairs);
    const Similarity found = fit_similarity(pairs.scan, pairs.generic, weights);
    if (!std::isfinite(found.scale) || found.scale <= 0.0) {
        throw InvalidInput("The landmarks all lie in one place or on one line.");
    }
    Landmarks swapped;
    for (const auto& [name, landmark] : landmarks) {
        swapped[mirrored_name(name)] = landmark;
    }
    const Pairs other = common_landmarks(swapped);
    const Similarity mirrored = fit_similarity(other.scan, other.generic, weights_of(other));
    const double error = rms(pairs, found, weights);
    if (rms(other, mirrored, weights_of(other)) < 0.6 * error) {
        throw InvalidInput(
            "Left and right of the landmarks are swapped: _l must be the patient's own left.");
    }
    if (error > 16.0) {
        throw InvalidInput("The landmarks do not lie as on a face: they differ by " +
                           std::to_string(static_cast<int>(std::lround(error))) +
                           " mm from an average face of the same size and pose.");
    }
    return found;
}

void check_near(const Landmarks& landmarks, const TriangleMesh& mesh, const Bvh& bvh) {
    for (const auto& [name, landmark] : landmarks) {
        const double distance = bvh.closest_point(mesh, landmark.position).distance;
        if (distance > kFarOff) {
            throw InvalidInput("The landmark " + name + " lies " +
                               std::to_string(static_cast<int>(std::lround(distance))) +
                               " mm away from the scan: do the landmarks belong to this file, in "
                               "its own unit?");
        }
    }
}

/// The part that holds the face, as a mesh of its own; other parts (eyeballs, lashes, scraps) ride
/// along unmoved.
WeldedMesh main_part(const Scan& scan, const Vec3& nose) {
    WeldedMesh welded = weld(scan.mesh);
    const Components parts = connected_components(welded.mesh);
    if (parts.count <= 1 || welded.mesh.triangle_count() == 0) {
        return welded;
    }
    const Bvh bvh(welded.mesh);
    std::vector<double> area(static_cast<std::size_t>(parts.count), 0.0);
    for (int t = 0; t < welded.mesh.triangle_count(); ++t) {
        area[parts.of_vertex[welded.mesh.triangles(0, t)]] +=
            double_area_vector(welded.mesh, t).norm();
    }
    int keep = parts.of_vertex[welded.mesh.triangles(
        0, bvh.closest_point(welded.mesh, nose).where.triangle)];
    const auto largest = std::max_element(area.begin(), area.end());
    if (area[keep] < 0.2 * *largest) {
        keep = static_cast<int>(largest - area.begin());  // a scrap in front of the nose
    }
    std::vector<int> number(static_cast<std::size_t>(welded.mesh.vertex_count()), -1);
    WeldedMesh part;
    int count = 0;
    for (int v = 0; v < welded.mesh.vertex_count(); ++v) {
        if (parts.of_vertex[v] == keep) {
            number[v] = count++;
        }
    }
    part.mesh.vertices.resize(3, count);
    for (int v = 0; v < welded.mesh.vertex_count(); ++v) {
        if (number[v] >= 0) {
            part.mesh.vertices.col(number[v]) = welded.mesh.vertices.col(v);
        }
    }
    std::vector<Eigen::Vector3i> triangles;
    for (int t = 0; t < welded.mesh.triangle_count(); ++t) {
        const Eigen::Vector3i v = welded.mesh.triangles.col(t);
        if (number[v[0]] >= 0) {
            triangles.emplace_back(number[v[0]], number[v[1]], number[v[2]]);
            part.of_triangle.push_back(welded.of_triangle[t]);
        }
    }
    part.mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        part.mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
    }
    for (const int v : welded.of_vertex) {
        part.of_vertex.push_back(v < 0 ? -1 : number[v]);
    }
    return part;
}

/// Maps between the average head and a scan in its pose. Not quite inverse to each other.
struct HeadWarps {
    SmoothWarp to_average, from_average;
};

/// Whether a warp turns nothing inside out around the front of the head.
bool keeps_sense(const SmoothWarp& warp) {
    constexpr double kStep = 1.5;    // [mm]
    constexpr double kLeast = 0.15;  // of the volume
    const Points& points = face_template().points;
    Points ahead(3, 4 * points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        ahead.col(4 * i) = points.col(i);
        for (int axis = 0; axis < 3; ++axis) {
            ahead.col(4 * i + 1 + axis) = points.col(i) + kStep * Vec3::Unit(axis);
        }
    }
    const Points moved = warp(ahead);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Mat3 jacobian = (moved.middleCols<3>(4 * i + 1).colwise() - moved.col(4 * i)) / kStep;
        if (jacobian.determinant() < kLeast) {
            return false;
        }
    }
    return true;
}

/// Landmarks first, then the front of the head bent onto the scan between them. A bend that would
/// fold is made stiffer.
HeadWarps fit_head(const FaceModel& face) {
    constexpr int kSamples = 30000;
    constexpr double kOnScan = 2.0;  // [mm] a point further off carries nothing
    constexpr Eigen::Index kCentres = 700;
    const Pairs pairs = common_landmarks(face.landmarks);
    Points in_pose(3, pairs.scan.cols());
    for (Eigen::Index i = 0; i < in_pose.cols(); ++i) {
        in_pose.col(i) = face.to_generic(Vec3(pairs.scan.col(i)));
    }
    HeadWarps warps;
    warps.from_average = SmoothWarp(pairs.generic, in_pose, pairs.errors, kWarpSoftness);
    warps.to_average = SmoothWarp(in_pose, pairs.generic, pairs.errors, kWarpSoftness);
    const SurfaceSamples samples =
        sample_surface(around_face(face.skin.mesh, face.to_generic), kSamples);
    if (samples.points.cols() < 500) {
        return warps;
    }
    Pins pins;
    pins.from = warps.from_average(pairs.generic);
    pins.to = in_pose;
    pins.softness = (kWarpSoftness * pairs.errors.cwiseAbs2()).cwiseMax(0.05);
    const DenseFit dense = bend_onto(samples, warps.from_average, pins);
    std::vector<Eigen::Index> kept;
    for (Eigen::Index i = 0;
         i < dense.points.cols() && static_cast<Eigen::Index>(kept.size()) < kCentres; ++i) {
        if (dense.distance[i] < kOnScan) {
            kept.push_back(i);
        }
    }
    const auto n = static_cast<Eigen::Index>(kept.size());
    const Eigen::Index held = in_pose.cols();
    Points generic(3, n + held);
    Points scan(3, n + held);
    for (Eigen::Index k = 0; k < n; ++k) {
        generic.col(k) = face_template().points.col(kept[static_cast<std::size_t>(k)]);
        scan.col(k) = dense.points.col(kept[static_cast<std::size_t>(k)]);
    }
    generic.rightCols(held) = pairs.generic;
    scan.rightCols(held) = in_pose;
    for (const double stiffness : {0.3, 3.0, 30.0}) {
        Eigen::VectorXd softness(n + held);
        softness << Eigen::VectorXd::Constant(n, stiffness), pins.softness;
        HeadWarps bent{WarpCentres(scan, softness).towards(generic),
                       WarpCentres(generic, softness).towards(scan)};
        if (keeps_sense(bent.from_average)) {
            return bent;
        }
    }
    return warps;
}

/// Parts lips that the scanner closed, so that the mouth can open.
void cut_open(FaceModel& face, const Vec3& nose) {
    const Scan& scan = *face.scan;
    Points generic =
        Points::Constant(3, scan.mesh.vertex_count(), std::numeric_limits<double>::quiet_NaN());
    for (int v = 0; v < scan.mesh.vertex_count(); ++v) {
        if (face.skin.of_vertex[v] >= 0) {
            generic.col(v) = face.generic.col(face.skin.of_vertex[v]);
        }
    }
    const std::optional<PartedLips> parted = part_lips(scan, generic);
    if (!parted) {
        return;
    }
    face.scan = parted->scan;
    face.skin = main_part(*face.scan, nose);
    face.generic.resize(3, face.node_count());
    face.lip_side.assign(static_cast<std::size_t>(face.node_count()), 0);
    for (int v = face.scan->mesh.vertex_count() - 1; v >= 0; --v) {  // the file's own decide
        if (face.skin.of_vertex[v] >= 0) {
            face.generic.col(face.skin.of_vertex[v]) = parted->generic.col(v);
            face.lip_side[static_cast<std::size_t>(face.skin.of_vertex[v])] =
                parted->side[static_cast<std::size_t>(v)];
        }
    }
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

/// Nodes of an open mouth that face each other across the slit.
std::vector<std::pair<int, int>> find_lip_contacts(const FaceModel& face) {
    std::vector<int> upper;
    std::vector<int> lower;
    for (int v = 0; v < face.node_count(); ++v) {
        const Vec3 p = face.generic.col(v);
        if (std::abs(p.x()) > 24.0 || std::abs(p.y() + 52.0) > 9.0 || p.z() < 70.0) {
            continue;
        }
        double height = 0.0;
        for (const int w : face.adjacency->neighbours(v)) {
            height += face.generic(1, w);
        }
        height /= static_cast<double>(face.adjacency->neighbours(v).size());
        (height > p.y() ? upper : lower).push_back(v);
    }
    constexpr double kTouching = 0.6;  // [mm]
    std::vector<std::pair<int, int>> pairs;
    for (const int u : upper) {
        int best = -1;
        double nearest = kTouching;
        for (const int l : lower) {
            const double distance =
                (face.skin.mesh.vertices.col(u) - face.skin.mesh.vertices.col(l)).norm();
            if (distance < nearest) {
                nearest = distance;
                best = l;
            }
        }
        if (best < 0) {
            continue;
        }
        // Neighbours on one sheet are not two lips.
        bool joined = false;
        for (const int w : face.adjacency->neighbours(u)) {
            joined = joined || w == best;
            for (const int x : face.adjacency->neighbours(w)) {
                joined = joined || x == best;
            }
        }
        if (!joined) {
            pairs.emplace_back(u, best);
        }
    }
    return pairs;
}

/// Which lip a node belongs to, told along the surface: both margins lie at the same place.
std::vector<signed char> find_lip_sides(const FaceModel& face) {
    std::vector<signed char> side = face.lip_side;  // what is known where lips were parted
    side.resize(static_cast<std::size_t>(face.node_count()), 0);
    if (face.lip_contacts.empty()) {
        return side;
    }
    constexpr double kSure = 3.0;  // [mm] above or below the line where the lips meet
    std::vector<char> mouth(side.size(), 0);
    std::vector<int> reached;
    for (int v = 0; v < face.node_count(); ++v) {
        const Vec3 p = face.generic.col(v);
        if (std::abs(p.x()) > 34.0 || std::abs(p.y() + 52.0) > 26.0 || p.z() < 35.0) {
            continue;
        }
        mouth[v] = 1;
        const double upper = upper_lip_share({0.0, p.y(), p.z()}, kSure);
        if (side[v] == 0 && (upper >= 1.0 || upper <= 0.0)) {
            side[v] = upper >= 1.0 ? 1 : -1;
        }
        if (side[v] != 0) {
            reached.push_back(v);
        }
    }
    // Breadth first from the sure ones.
    for (std::size_t next = 0; next < reached.size(); ++next) {
        for (const int w : face.adjacency->neighbours(reached[next])) {
            if (mouth[w] != 0 && side[w] == 0) {
                side[w] = side[reached[next]];
                reached.push_back(w);
            }
        }
    }
    return side;
}

}  // namespace

std::future<void> prepare_fitting() {
    return std::async(std::launch::async, [] { generic_skull(); });
}

Points spread_over_margins(const FaceModel& face, const Points& own) {
    if (own.cols() == face.node_count()) {
        return own;
    }
    Points all = Points::Zero(3, face.node_count());
    const Eigen::Index known = std::min<Eigen::Index>(own.cols(), face.own_nodes);
    all.leftCols(known) = own.leftCols(known);
    for (int v = face.own_nodes; v < face.node_count(); ++v) {
        Vec3 sum = Vec3::Zero();
        double count = 0.0;
        for (const int w : face.adjacency->neighbours(v)) {
            if (w < known) {
                sum += all.col(w);
                count += 1.0;
            }
        }
        all.col(v) = sum / std::max(count, 1.0);
    }
    return all;
}

Vec3 from_generic(const FaceModel& face, const Vec3& p) {
    return face.to_generic.inverse()(face.from_generic(p));
}

FittedNet fitted_net(const FaceModel& face, double spacing) {
    // Which points of the average head's front belong to the net: those of the template's reach.
    constexpr double kHalfWidth = 64.0;
    constexpr double kTop = 66.0;
    constexpr double kBottom = -96.0;
    constexpr double kSteepest = 4.0;  // of the spacing, from one point to the next
    const HeadField& head = average_head();
    const int columns = 2 * static_cast<int>(kHalfWidth / spacing) + 1;
    const int rows = static_cast<int>((kTop - kBottom) / spacing) + 1;
    Points front(3, static_cast<Eigen::Index>(columns) * rows);
    parallel_for(rows, 1, [&](int begin, int end) {
        for (int r = begin; r < end; ++r) {
            for (int c = 0; c < columns; ++c) {
                front.col(static_cast<Eigen::Index>(r) * columns + c) =
                    head.front_point((c - columns / 2) * spacing, kTop - r * spacing);
            }
        }
    });
    FittedNet net;
    net.points.resize(3, front.cols());
    net.distance.resize(front.cols());
    const Bvh bvh(face.skin.mesh);
    const Similarity back = face.to_generic.inverse();
    parallel_for(static_cast<int>(front.cols()), 64, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            net.points.col(i) = back(face.from_generic(Vec3(front.col(i))));
            net.distance[i] = bvh.closest_point(face.skin.mesh, net.points.col(i)).distance;
        }
    });
    const auto tie = [&](int a, int b) {
        if ((front.col(a) - front.col(b)).norm() < kSteepest * spacing &&
            std::min(front(2, a), front(2, b)) > 25.0) {
            net.threads.emplace_back(a, b);
        }
    };
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            const int i = r * columns + c;
            if (c + 1 < columns) {
                tie(i, i + 1);
            }
            if (r + 1 < rows) {
                tie(i, i + columns);
            }
        }
    }
    return net;
}

FileFrame frame_from_landmarks(const LandmarkFile& file, std::optional<double> mm_per_unit,
                               std::optional<Mat3> axes) {
    Landmarks landmarks = file.landmarks;
    for (auto& [name, landmark] : landmarks) {
        landmark.error_mm = std::min(landmark.error_mm, 10.0);
    }
    const Similarity to_generic = pose(landmarks);
    FileFrame frame;
    frame.mm_per_unit = to_generic.scale;
    for (const char* unit : {"mm", "cm", "in", "dm", "m"}) {
        const double known = millimetres_per_unit(unit);
        if (to_generic.scale > known / 1.2 && to_generic.scale < known * 1.2) {
            frame.mm_per_unit = known;
        }
    }
    if (file.mm_per_unit) {
        frame.mm_per_unit = *file.mm_per_unit;
    }
    if (mm_per_unit) {
        frame.mm_per_unit = *mm_per_unit;
    }
    if (axes) {
        frame.axes = *axes;
        return frame;
    }
    frame.axes = nearest_quarter_turn(to_generic.rotation);
    return frame;
}

std::shared_ptr<const FaceModel> fit_face(std::shared_ptr<const Scan> scan, const Landmarks& given,
                                          const Progress* progress) {
    const auto report = [&](const char* stage, double share) {
        if (progress != nullptr) {
            progress->report(stage, share);
        }
    };
    const std::future<void> prepared = prepare_fitting();
    report("Fitting the face", 0.0);
    auto face = std::make_shared<FaceModel>();
    face->landmarks = given;
    face->to_generic = pose(face->landmarks);
    if (face->to_generic.scale < 0.5 || face->to_generic.scale > 2.0) {
        throw InvalidInput(
            "The face would be " +
            std::to_string(static_cast<int>(std::lround(130.0 / face->to_generic.scale))) +
            " mm wide: give the right unit with --unit.");
    }
    settle_nasion(face->landmarks, face->to_generic);
    face->axes = face->to_generic.rotation.transpose();
    const auto prn =
        face->landmarks.count("prn") != 0 ? face->landmarks["prn"] : face->landmarks.at("sn");
    face->skin = main_part(*scan, prn.position);
    face->scan = std::move(scan);
    const TriangleMesh& mesh = face->skin.mesh;
    if (mesh.triangle_count() < 100) {
        throw InvalidInput("The scan has too few triangles to be a face.");
    }
    check_near(face->landmarks, mesh, Bvh(mesh));
    face->own_nodes = face->node_count();
    report("Fitting the face", 0.2);

    const HeadWarps warps = fit_head(*face);
    const Mat3 turn = face->to_generic.scale * face->to_generic.rotation;
    face->generic =
        warps.to_average(Points((turn * mesh.vertices).colwise() + face->to_generic.shift));
    face->from_generic = warps.from_average;
    cut_open(*face, prn.position);
    face->adjacency = std::make_shared<Adjacency>(mesh);
    face->area = vertex_areas(mesh);
    const Bvh bvh(mesh);
    report("Fitting the face", 0.5);

    const Points normals = vertex_normals(mesh, *face->adjacency);
    const SmoothFace smooth = smooth_face(mesh, *face->adjacency);
    const Points& smooth_normals = smooth.normals;
    const Eigen::VectorXd depths = tissue_depths(face->generic);
    for (int v = 0; v < face->node_count(); ++v) {
        const bool inward =
            normals.col(v).dot(smooth_normals.col(v)) < 0.0 ||
            looks_inward(face->generic.col(v), face->to_generic.rotation * normals.col(v));
        face->tissue.push_back(
            tissue_at(face->generic.col(v), depths[v] / face->to_generic.scale, inward));
    }
    face->sliding = sliding_surfaces(mesh, *face->adjacency, smooth_normals);
    report("Fitting the face", 0.7);

    const auto onto_scan = [&](const Vec3& p) { return from_generic(*face, p); };
    place_muscles(*face, smooth_normals, onto_scan);
    label_skin(*face);
    report("Fitting the face", 0.85);
    place_skull(*face, onto_scan);
    face->midplane = find_midplane(*face, bvh);
    face->lip_contacts = find_lip_contacts(*face);
    face->lip_side = find_lip_sides(*face);
    report("Fitting the face", 1.0);
    return face;
}

std::string muscles_to_json(const FaceModel& face) {
    nlohmann::json list = nlohmann::json::object();
    const FileFrame& frame = face.scan->frame;
    for (const Muscle& muscle : face.muscles) {
        nlohmann::json points = nlohmann::json::array();
        for (Eigen::Index i = 0; i < muscle.path.cols(); ++i) {
            const Vec3 p = frame.to_file(muscle.path.col(i));
            points.push_back({p.x(), p.y(), p.z()});
        }
        const bool linear = muscle.traits.kind != MuscleKind::Sphincter;
        if (!linear) {
            points.push_back(points.front());
        }
        nlohmann::json& entry = list[muscle.traits.name];
        entry = {{"kind", linear ? "linear" : "sphincter"}, {"points", points}};
        for (const Points& fibre : muscle.fibres) {
            nlohmann::json line = nlohmann::json::array();
            for (Eigen::Index i = 0; i < fibre.cols(); ++i) {
                const Vec3 p = frame.to_file(fibre.col(i));
                line.push_back({p.x(), p.y(), p.z()});
            }
            entry["fibres"].push_back(line);
        }
    }
    nlohmann::json document;
    const std::string unit = unit_name(frame.mm_per_unit);
    document["unit"] = unit == "other" ? nlohmann::json(frame.mm_per_unit) : nlohmann::json(unit);
    document["muscles"] = list;
    return document.dump(1) + "\n";
}

}  // namespace myoface
