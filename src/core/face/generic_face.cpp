// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/generic_face.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/normals.h"

#include "head/head_colour.h"
#include "head/head_landmarks.h"
#include "head/head_mesh.h"
#include "head/head_picture.h"
#include "head/head_variation.h"
#include "head/individual.h"

namespace myoface {
namespace {

void check(const GenericFaceOptions& options) {
    if (options.vertices < 3000 || options.vertices > 1000000) {
        throw InvalidInput("The number of vertices must lie between 3000 and 1000000.");
    }
    if (!(options.age >= 3.0 && options.age <= 100.0)) {
        throw InvalidInput("The age must lie between 3 and 100 years.");
    }
    if (!(options.asymmetry >= 0.0 && options.asymmetry <= 3.0)) {
        throw InvalidInput("The asymmetry must lie between 0 and 3 mm.");
    }
    if (options.picture != 0 && (options.picture < 64 || options.picture > 8192)) {
        throw InvalidInput("The picture's side must lie between 64 and 8192 pixels.");
    }
    if (!(options.stubble >= 0.0 && options.stubble <= 1.0)) {
        throw InvalidInput("The stubble must lie between 0 and 1.");
    }
}

double masculine(const GenericFaceOptions& options) {
    return !options.sex ? 0.0 : *options.sex == Sex::Male ? 1.0 : -1.0;
}

/// 0 up to 35 years, 1 from 75 on.
double old(const GenericFaceOptions& options) {
    return std::clamp((options.age - 35.0) / 40.0, 0.0, 1.0);
}

/// How much bigger than the average adult a head is, from its widths and height.
double size_of(const WantedMeasures& wanted) {
    const WantedMeasures average = wanted_measures(std::nullopt, 20.0, 0.0, std::nullopt);
    double sum = 0.0;
    for (const char* id : {"zy-zy", "ex-ex", "n-gn"}) {
        sum += wanted.at(id) / average.at(id) / 3.0;
    }
    return sum;
}

/// Moves landmarks sideways, up and forward by a seeded amount that differs from side to side.
void make_asymmetric(Landmarks& landmarks, double sigma, std::uint32_t seed) {
    std::mt19937 random(seed + 0x9e3779b9U);
    const auto draw = [&] {  // sum of four uniforms: near enough to normal, the same everywhere
        double sum = -2.0;
        for (int i = 0; i < 4; ++i) {
            sum += static_cast<double>(random()) / 4294967296.0;
        }
        return sigma * sum * std::sqrt(3.0);
    };
    // Nose and chin lean to a side together with what hangs on them.
    const double nose = draw();
    const double chin = draw();
    for (auto& [name, landmark] : landmarks) {
        const bool sided = name.ends_with("_l") || name.ends_with("_r");
        if (sided) {
            const Vec3 way(0.6 * draw(), 0.6 * draw(), 0.6 * draw());
            landmark.position += way;
        }
        const double y = landmark.position.y();
        const double z = landmark.position.z();
        if (z > 60.0 && y < 20.0) {
            const double at_tip = std::exp(-std::pow((y + 18.0) / 14.0, 2.0));
            const double at_chin = std::clamp((-45.0 - y) / 40.0, 0.0, 1.0);
            landmark.position.x() += 0.8 * nose * at_tip + chin * at_chin;
        }
    }
}

/// The way from the average head to a person's.
class PersonalWarp {
public:
    PersonalWarp(const Landmarks& from, const Landmarks& to, double size) : size_(size) {
        // The back of the head and the neck hold the warp where there are no landmarks.
        const std::array<Vec3, 10> anchors{{{0, 130, -10},
                                            {0, 40, -98},
                                            {62, 60, -45},
                                            {-62, 60, -45},
                                            {0, -150, 20},
                                            {0, -150, -78},
                                            {50, -150, -30},
                                            {-50, -150, -30},
                                            {76, 5, -22},
                                            {-76, 5, -22}}};
        const auto n = static_cast<Eigen::Index>(from.size() + anchors.size());
        Points a(3, n);
        Points b(3, n);
        Eigen::Index i = 0;
        for (const auto& [name, landmark] : from) {
            a.col(i) = landmark.position;
            b.col(i++) = to.at(name).position;
        }
        for (const Vec3& anchor : anchors) {
            a.col(i) = b.col(i) = size * anchor;
            ++i;
        }
        warp_ = SmoothWarp(a, b, Eigen::VectorXd::Zero(n), 0.0);
    }
    Vec3 operator()(const Vec3& p) const { return warp_(Vec3(size_ * p)); }
    double size() const { return size_; }

private:
    double size_;
    SmoothWarp warp_;
};

/// Moves the average head to a person. Eyeballs stay balls, and lids stay outside them.
void apply(const PersonalWarp& warp, const HeadMesh& head, const Points& varied, Points& out) {
    const Vec3 eye = average_head().eye_centre();
    const double radius = HeadField::kEyeRadius * warp.size();
    const auto centre = [&](const Vec3& p) {
        return Vec3(p.x() > 0.0 ? eye.x() : -eye.x(), eye.y(), eye.z());
    };
    const std::array<Vec3, 2> moved{warp(eye), warp(Vec3(-eye.x(), eye.y(), eye.z()))};
    parallel_for(head.mesh.vertex_count(), 512, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const Vec3 before = head.mesh.vertices.col(v);
            const Vec3& ball = moved[before.x() > 0.0 ? 0 : 1];
            const HeadPart part = head.part[static_cast<std::size_t>(v)];
            if (part == HeadPart::Eye) {
                out.col(v) = ball + warp.size() * (before - centre(before));
                continue;
            }
            Vec3 p = warp(varied.col(v));
            // Linings touch the ball, skin keeps a lid's thickness from it.
            const double at_least = std::min(radius + (part == HeadPart::Skin ? 1.1 : 0.12),
                                             (before - centre(before)).norm() * warp.size());
            const Vec3 away = p - ball;
            if ((part == HeadPart::Skin || part == HeadPart::LidMargin) &&
                (before - centre(before)).norm() < HeadField::kEyeRadius + 6.0 &&
                away.norm() < at_least) {
                p = ball + at_least * away.normalized();
            }
            out.col(v) = p;
        }
    });
}

}  // namespace

const Landmarks& generic_landmarks() {
    static const Landmarks kLandmarks = place_landmarks(average_head());
    return kLandmarks;
}

GenericFace make_generic_face(const GenericFaceOptions& options, const Progress* progress) {
    check(options);
    const HeadMesh head = average_head_mesh(options.vertices, progress);
    GenericFace face;
    face.landmarks = generic_landmarks();
    Scan& scan = face.scan;
    scan.format = FileFormat::PlyBinaryLittle;
    scan.mesh.vertices = head.mesh.vertices;
    const Eigen::Index n = scan.mesh.vertices.cols();

    const bool personal = options.sex || options.seed || old(options) > 0.0;
    if (personal || options.asymmetry > 0.0) {
        const HeadVariation variation{masculine(options), old(options)};
        const Adjacency adjacency(head.mesh);
        const Points normals = vertex_normals(head.mesh, adjacency);
        Points varied = head.mesh.vertices;
        parallel_for(static_cast<int>(n), 256, [&](int begin, int end) {
            for (int v = begin; v < end; ++v) {
                const HeadPart part = head.part[static_cast<std::size_t>(v)];
                if (part != HeadPart::Eye) {
                    varied.col(v) += variation_shift(
                        variation, varied.col(v),
                        part == HeadPart::Skin ? Vec3(normals.col(v)) : Vec3(Vec3::Zero()));
                }
            }
        });
        Landmarks from = face.landmarks;
        const WantedMeasures wanted =
            personal ? wanted_measures(options.sex, options.age, old(options), options.seed)
                     : WantedMeasures();
        const double size = personal ? size_of(wanted) : 1.0;
        for (auto& [name, landmark] : from) {
            landmark.position =
                size *
                (landmark.position + variation_shift(variation, landmark.position, Vec3::Zero()));
        }
        Landmarks to = personal ? with_measures(from, wanted) : from;
        if (options.asymmetry > 0.0) {
            make_asymmetric(to, options.asymmetry, options.seed.value_or(0));
        }
        apply(PersonalWarp(from, to, size), head, varied, scan.mesh.vertices);
        face.landmarks = to;
    }

    const HeadLook look{masculine(options), old(options), options.stubble,
                        options.seed.value_or(0)};
    scan.colours.resize(3, n);
    parallel_for(static_cast<int>(n), 1024, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            scan.colours.col(v) = head_colour(head.part[static_cast<std::size_t>(v)],
                                              head.mesh.vertices.col(v), look, false)
                                      .cast<float>();
        }
    });
    scan.faces.vertex.assign(head.mesh.triangles.data(),
                             head.mesh.triangles.data() + head.mesh.triangles.size());
    scan.faces.start.resize(static_cast<std::size_t>(head.mesh.triangle_count()) + 1);
    for (std::size_t t = 0; t < scan.faces.start.size(); ++t) {
        scan.faces.start[t] = static_cast<int>(3 * t);
    }
    triangulate(scan);
    if (options.picture > 0) {
        if (progress != nullptr) {
            progress->report("Painting the skin", 0.9);
        }
        add_picture(scan, head, look, options.picture);
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
