// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/landmark_detection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "myoface/base/error.h"
#include "myoface/face/generic_face.h"
#include "myoface/mesh/bvh.h"

#include "face_template.h"
#include "landmark_sharpening.h"
#include "registration.h"
#include "surface_samples.h"

namespace myoface {
namespace {

constexpr double kSureOfAFace = 0.12;  // confidence below which a scan is refused
constexpr int kDetectionSamples = 40000;
constexpr double kMostOff = 6.0;  // [mm] a landmark may lie off the scan before it is put onto it

/// How far the proportions of a bent face leave those of people: 0 within about three standard
/// deviations of the norms, growing beyond. @cite weinberg_2016
double oddness(const std::function<Vec3(const std::string&)>& place) {
    constexpr double kUsual = 0.22;  // logarithm of a length over that of the average head
    static constexpr std::array<std::pair<const char*, const char*>, 8> kLengths{
        {{"se", "sn"},
         {"sn", "sto"},
         {"sto", "pg"},
         {"sn", "pg"},
         {"en_l", "en_r"},
         {"ex_l", "ex_r"},
         {"ch_l", "ch_r"},
         {"al_l", "al_r"}}};
    const Landmarks& average = generic_landmarks();
    std::array<double, kLengths.size()> ratio{};
    for (std::size_t k = 0; k < kLengths.size(); ++k) {
        const auto [from, to] = kLengths[k];
        ratio[k] = std::log(std::max((place(from) - place(to)).norm(), 0.1) /
                            (average.at(from).position - average.at(to).position).norm());
    }
    // The size of the whole does not matter.
    std::array<double, kLengths.size()> sorted = ratio;
    std::sort(sorted.begin(), sorted.end());
    const double middle = 0.5 * (sorted[sorted.size() / 2 - 1] + sorted[sorted.size() / 2]);
    double odd = 0.0;
    for (const double r : ratio) {
        odd += std::max(0.0, std::abs(r - middle) - kUsual);
    }
    return odd;
}

/// How far each kind of landmark is usually off [mm]; larger for those beside the fitted front.
double usual_error(const std::string& name) {
    static const std::map<std::string, double> kErrors{
        {"prn", 2.0}, {"sn", 1.5}, {"ls", 2.5}, {"li", 2.5}, {"sto", 2.0},  {"pg", 3.0},
        {"gn", 4.0},  {"n", 3.0},  {"se", 2.0}, {"g", 4.0},  {"c", 2.0},    {"sl", 2.5},
        {"en", 2.5},  {"ex", 3.0}, {"al", 2.0}, {"ac", 2.5}, {"sbal", 2.5}, {"ch", 3.0},
        {"cph", 2.5}, {"zy", 7.0}, {"go", 8.0}, {"t", 8.0},  {"ft", 7.0},   {"tr", 12.0}};
    const auto found = kErrors.find(name.substr(0, name.find('_')));
    return found == kErrors.end() ? 5.0 : found->second;
}

/// What an open mouth adds to the error of a landmark [mm]: between the lips there is no stomion,
/// and how far lips and chin went along is hardly seen.
double gap_error(const std::string& name, double gap) {
    constexpr double kClosed = 3.0;  // [mm]
    if (gap < kClosed) {
        return 0.0;
    }
    if (name == "sto") {
        return 0.5 * gap;
    }
    const bool lower = name == "li" || name == "sl" || name == "pg" || name == "gn" ||
                       name.starts_with("ch") || name.starts_with("go");
    return lower ? 0.4 * (gap - kClosed) : 0.0;
}

}  // namespace

DetectedLandmarks detect_landmarks(const TriangleMesh& mesh, const FacePose* known,
                                   const Progress* progress) {
    const std::optional<FacePose> pose =
        known != nullptr ? std::optional<FacePose>(*known) : find_face(mesh, progress);
    DetectedLandmarks result;
    const InvalidInput no_face(
        "No face was found on this scan. If it shows one, place the landmarks by hand.");
    result.confidence = pose ? confidence_of(*pose) : 0.0;
    if (result.confidence < kSureOfAFace) {
        throw no_face;
    }
    const TriangleMesh part = around_face(mesh, pose->to_generic);
    const SurfaceSamples samples = sample_surface(part, kDetectionSamples);
    if (samples.points.cols() < 500) {
        throw InvalidInput("Too little of a face is left on this scan.");
    }
    const Registration fitted = register_face(samples, progress);
    std::vector<double> distances(fitted.distance.data(),
                                  fitted.distance.data() + fitted.distance.size());
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    result.residual_mm = *middle / pose->to_generic.scale;

    // Proportions that nobody has mean that the fit went astray.
    result.confidence *= std::exp(-4.0 * oddness([&](const std::string& name) {
        return fitted.warp(generic_landmarks().at(name).position);
    }));
    if (result.confidence < kSureOfAFace) {
        throw no_face;
    }
    const FaceTemplate& face = face_template();
    const Bvh bvh(part);
    const Similarity back = pose->to_generic.inverse();
    Places places;
    for (const auto& [name, landmark] : generic_landmarks()) {
        places[name] = fitted.warp(landmark.position);
    }
    const double gap = sharpen(places, part, bvh);
    for (const auto& [name, landmark] : generic_landmarks()) {
        const Vec3 bent = places[name];
        const ClosestPoint on_scan = bvh.closest_point(part, bent);
        if (on_scan.distance > kMostOff) {
            continue;
        }
        int near = 0;
        int good = 0;
        for (Eigen::Index i = 0; i < face.points.cols(); ++i) {
            if ((face.points.col(i) - landmark.position).norm() < 15.0) {
                ++near;
                good += fitted.distance[i] < 1.5 ? 1 : 0;
            }
        }
        const double share = near > 0 ? static_cast<double>(good) / near : 0.5;
        const double doubt = 1.0 + 2.0 * (1.0 - share) + 2.0 * (1.0 - result.confidence);
        result.landmarks[name] = {
            back(on_scan.point), (usual_error(name) * std::min(doubt, 4.0) + gap_error(name, gap)) /
                                     pose->to_generic.scale};
    }
    return result;
}

}  // namespace myoface
