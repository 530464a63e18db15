// SPDX-License-Identifier: Apache-2.0
#include "landmark_pose.h"

#include <algorithm>
#include <cmath>

#include "myoface/base/error.h"
#include "myoface/face/face_model.h"
#include "myoface/face/generic_face.h"
#include "myoface/io/mesh_file.h"

namespace myoface {
namespace {

/// A landmark further off the scan than this is a mistake, not an imprecision.
constexpr double kFarOff = 25.0;

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

Eigen::VectorXd weights_of(const LandmarkPairs& pairs) {
    return (pairs.errors.array().square() + 4.0).inverse().matrix();
}

double rms(const LandmarkPairs& pairs, const Similarity& to_generic,
           const Eigen::VectorXd& weights) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < pairs.scan.cols(); ++i) {
        const Vec3 at = pairs.scan.col(i);
        sum += weights[i] * (to_generic(at) - Vec3(pairs.generic.col(i))).squaredNorm();
    }
    return std::sqrt(sum / weights.sum());
}

}  // namespace

LandmarkPairs common_landmarks(const Landmarks& landmarks) {
    LandmarkPairs pairs;
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

Similarity pose_of(const Landmarks& landmarks) {
    check_enough(landmarks);
    const LandmarkPairs pairs = common_landmarks(landmarks);
    const Eigen::VectorXd weights = weights_of(pairs);
    const Similarity found = fit_similarity(pairs.scan, pairs.generic, weights);
    if (!std::isfinite(found.scale) || found.scale <= 0.0) {
        throw InvalidInput("The landmarks all lie in one place or on one line.");
    }
    Landmarks swapped;
    for (const auto& [name, landmark] : landmarks) {
        swapped[mirrored_name(name)] = landmark;
    }
    const LandmarkPairs other = common_landmarks(swapped);
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

void check_near(const Landmarks& landmarks, const TriangleMesh& skin) {
    const double edge =
        (skin.corner(0, 1) - skin.corner(0, 0)).norm();  // vertices stand so far off
    for (const auto& [name, landmark] : landmarks) {
        const double distance = std::sqrt(
            (skin.vertices.colwise() - landmark.position).colwise().squaredNorm().minCoeff());
        if (distance > kFarOff + edge) {
            throw InvalidInput("The landmark " + name + " lies " +
                               std::to_string(static_cast<int>(std::lround(distance))) +
                               " mm away from the scan: do the landmarks belong to this file, in "
                               "its own unit?");
        }
    }
}

FileFrame frame_from_landmarks(const LandmarkFile& file, std::optional<double> mm_per_unit,
                               std::optional<Mat3> axes) {
    Landmarks landmarks = file.landmarks;
    for (auto& [name, landmark] : landmarks) {
        landmark.error_mm = std::min(landmark.error_mm, 10.0);
    }
    const Similarity to_generic = pose_of(landmarks);
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

}  // namespace myoface
