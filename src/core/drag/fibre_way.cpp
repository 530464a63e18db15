// SPDX-License-Identifier: Apache-2.0
#include "myoface/drag/fibre_way.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace myoface {
namespace {

/// The fibre of a muscle that is nearest to a place.
Points nearest_fibre(const Muscle& muscle, const Vec3& place) {
    Points nearest = muscle.path;
    double least = std::numeric_limits<double>::infinity();
    for (const Points& fibre : muscle.fibres) {
        const double off = (fibre.colwise() - place).colwise().squaredNorm().minCoeff();
        if (off < least) {
            least = off;
            nearest = fibre;
        }
    }
    return nearest;
}

}  // namespace

double line_length(const Points& line, bool closed) {
    double length = 0.0;
    const Eigen::Index n = line.cols();
    for (Eigen::Index i = 0; i + (closed ? 0 : 1) < n; ++i) {
        length += (line.col((i + 1) % n) - line.col(i)).norm();
    }
    return length;
}

double along_line(const Points& line, bool closed, const Vec3& place) {
    const Eigen::Index n = line.cols();
    const Eigen::Index parts = closed ? n : n - 1;
    double least = std::numeric_limits<double>::infinity();
    double result = 0.0;
    double gone = 0.0;
    for (Eigen::Index i = 0; i < parts; ++i) {
        const Vec3 a = line.col(i);
        const Vec3 part = line.col((i + 1) % n) - a;
        const double length = part.norm();
        if (!(length > 0.0)) {
            continue;
        }
        const double wanted = (place - a).dot(part) / length;
        const double on_it = std::clamp(wanted, 0.0, length);
        const double off = (place - a - on_it / length * part).squaredNorm();
        if (off < least) {
            least = off;
            const bool beyond =
                !closed && ((i == 0 && wanted < 0.0) || (i + 1 == parts && wanted > length));
            result = gone + (beyond ? wanted : on_it);
        }
        gone += length;
    }
    return result;
}

FibreWay::FibreWay(const FaceModel& face, const Grip& grip, double elongation)
    : face_(face), centre_(grip_position(grip, face.skin.mesh.vertices)), along_(1.0 / elongation) {
    std::vector<double> shares(face.muscles.size(), 0.0);
    for (std::size_t k = 0; k < grip.nodes.size(); ++k) {
        for (const MuscleWeight& entry :
             face.muscles_under[static_cast<std::size_t>(grip.nodes[k])]) {
            shares[static_cast<std::size_t>(entry.muscle)] += grip.weights[k] * entry.weight;
        }
    }
    for (std::size_t m = 0; m < shares.size(); ++m) {
        const Muscle& muscle = face.muscles[m];
        if (shares[m] > 0.0 && muscle.path.cols() > 1) {
            const bool ring = muscle.traits.kind == MuscleKind::Sphincter;
            Line line{nearest_fibre(muscle, centre_), ring, shares[m], 0.0,
                      ring ? 3.0 / (elongation + 2.0) : along_};
            line.start = along_line(line.points, line.closed, centre_);
            lines_.push_back(std::move(line));
        }
    }
}

double FibreWay::factor(int node) const {
    const Vec3 place = face_.skin.mesh.vertices.col(node);
    const double straight = (place - centre_).norm();
    double result = 1.0;
    for (const Line& line : lines_) {
        double gone = std::abs(along_line(line.points, line.closed, place) - line.start);
        if (line.closed) {
            gone = std::min(gone, line_length(line.points, true) - gone);
        }
        const double share = straight > 1e-9 ? std::min(1.0, gone / straight) : 0.0;
        const double square = share * share;
        const double counts = std::sqrt(square * line.along * line.along + (1.0 - square));
        result += line.share * (counts - 1.0);
    }
    return result;
}

}  // namespace myoface
