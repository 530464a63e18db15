// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/landmark_detection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/face/generic_face.h"
#include "myoface/mesh/bvh.h"

#include "face_template.h"
#include "point_tree.h"
#include "surface_samples.h"

namespace myoface {
namespace {

constexpr double kSureOfAFace = 0.12;  // confidence below which a scan is refused
constexpr double kFaceReach = 135.0;   // [mm] around the middle of the face that is looked at
constexpr int kSamples = 40000;
constexpr double kMostOff = 6.0;  // [mm] a landmark may lie off the scan before it is put onto it

/// The scan around the face in size and pose of the average head.
TriangleMesh around_face(const TriangleMesh& mesh, const Similarity& to_generic) {
    const Vec3 centre = face_template().centre;
    TriangleMesh part;
    part.vertices =
        (to_generic.scale * to_generic.rotation * mesh.vertices).colwise() + to_generic.shift;
    std::vector<Eigen::Vector3i> kept;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Eigen::Vector3i v = mesh.triangles.col(t);
        if ((part.vertices.col(v[0]) - centre).norm() < kFaceReach) {
            kept.push_back(v);
        }
    }
    part.triangles.resize(3, static_cast<Eigen::Index>(kept.size()));
    for (std::size_t t = 0; t < kept.size(); ++t) {
        part.triangles.col(static_cast<Eigen::Index>(t)) = kept[t];
    }
    return part;
}

/// Place and direction in one: a normal at right angles counts as much as this far apart.
constexpr double kTurnCost = 25.0;  // [mm]
using Features = Eigen::Matrix<double, 6, Eigen::Dynamic>;

Features features_of(const Points& points, const Points& normals) {
    Features features(6, points.cols());
    features << points, kTurnCost * normals;
    return features;
}

/// A smooth displacement through the first points of the template, which are approached the more
/// closely the smaller `smoothing` [mm]. The centres stay, so one factorization serves many
/// targets. @cite wahba_1990
class Bend {
public:
    Bend(const Points& centres, double smoothing) : centres_(centres) {
        const Eigen::Index n = centres.cols();
        Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 4, n + 4);
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = 0; j < n; ++j) {
                system(i, j) = -(centres.col(i) - centres.col(j)).norm();
            }
            system(i, i) += smoothing;
            system(i, n) = system(n, i) = 1.0;
            system.block<1, 3>(i, n + 1) = centres.col(i).transpose();
            system.block<3, 1>(n + 1, i) = centres.col(i);
        }
        lu_.compute(system);
    }

    void fit(const Points& displacement) {
        const Eigen::Index n = centres_.cols();
        Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n + 4, 3);
        right.topRows(n) = displacement.transpose();
        coefficients_ = lu_.solve(right);
    }

    Vec3 operator()(const Vec3& x) const {
        const Eigen::Index n = centres_.cols();
        Eigen::RowVector3d sum =
            coefficients_.row(n) + x.transpose() * coefficients_.bottomRows<3>();
        for (Eigen::Index i = 0; i < n; ++i) {
            sum -= (x - centres_.col(i)).norm() * coefficients_.row(i);
        }
        return x + sum.transpose();
    }

private:
    Points centres_;
    Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
    Eigen::MatrixX3d coefficients_;
};

constexpr double kAlong = 0.4;  ///< share of a pair's way along the skin that is gone

/// Relief that the lip crease keeps up to the corner, as a share of that in its middle.
constexpr double kCreaseShare = 0.25;

struct Level {
    Eigen::Index nodes;
    double smoothing;  // [mm]
    double reach;      // [mm] at which a pair counts a quarter
    int steps;
};
constexpr std::array<Level, 5> kLevels{{{100, 1000.0, 15.0, 15},
                                        {100, 200.0, 10.0, 15},
                                        {200, 60.0, 6.0, 15},
                                        {400, 20.0, 4.0, 15},
                                        {600, 8.0, 3.0, 10}}};

/// The template bent onto the scan.
struct Fitted {
    std::unique_ptr<Bend> bend;
    Eigen::VectorXd distance;  ///< of each point of the template from the scan [mm], large for none
};

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

/// Bends the template onto samples, coarse to fine.
class Bender {
public:
    explicit Bender(const SurfaceSamples& samples)
        : samples_(samples),
          features_(features_of(samples.points, samples.normals)),
          tree_(features_) {}

    Fitted fit(const Progress* progress) const {
        const auto report = [&](double share) {
            if (progress != nullptr) {
                progress->report("Finding landmarks", share);
            }
        };
        const FaceTemplate& face = face_template();
        // A long or short face, or one that looks up, draws the fit into another fold of the lips:
        // several beginnings, the one that lies best goes on.
        Points best;
        double most = -1e9;
        for (const double pitch : {0.0, 14.0, -14.0}) {
            for (const double length : {1.0, 1.13, 1.27}) {
                report(best.cols() == 0 ? 0.0 : 0.2);
                const Mat3 turn =
                    Eigen::AngleAxisd(pitch / 57.2958, Vec3::UnitX()).toRotationMatrix() *
                    Vec3(1.0, length, 1.0).asDiagonal();
                Points now = (turn * (face.points.colwise() - face.tip)).colwise() + face.tip;
                std::unique_ptr<Bend> bent;
                for (std::size_t level = 0; level < kBeginnings; ++level) {
                    bent = bend(kLevels[level], now);
                }
                const double lies = agreement(now) - oddness([&](const std::string& name) {
                                        return (*bent)(generic_landmarks().at(name).position);
                                    });
                if (lies > most) {
                    most = lies;
                    best = std::move(now);
                }
            }
        }
        Fitted fitted;
        for (std::size_t level = kBeginnings; level < kLevels.size(); ++level) {
            report(0.4 + 0.2 * static_cast<double>(level - kBeginnings));
            fitted.bend = bend(kLevels[level], best);
        }
        fitted.distance.resize(face.points.cols());
        for (Eigen::Index i = 0; i < face.points.cols(); ++i) {
            const int near = match(i, best.col(i));
            fitted.distance[i] = near < 0
                                     ? 50.0
                                     : std::abs(samples_.normals.col(near).dot(
                                           Vec3(best.col(i)) - Vec3(samples_.points.col(near))));
        }
        return fitted;
    }

private:
    static constexpr std::size_t kBeginnings = 3;  ///< levels that every beginning goes through

    /// The sample that agrees best in place and direction, or -1.
    int match(Eigen::Index i, const Vec3& p, double* apart = nullptr) const {
        const Vec3 normal = face_template().normals.col(i);
        Eigen::Matrix<double, 6, 1> query;
        query << p, kTurnCost * normal;
        std::uint32_t index = 0;
        double distance = 0.0;
        const bool found = tree_.nearest(query.data(), 1, &index, &distance) == 1 &&
                           samples_.normals.col(index).dot(normal) > 0.5;
        if (apart != nullptr) {
            *apart = distance;
        }
        return found ? static_cast<int>(index) : -1;
    }

    /// How well points lie in place and direction, 0 … 1.
    double agreement(const Points& now) const {
        double sum = 0.0;
        for (Eigen::Index i = 0; i < now.cols(); ++i) {
            double apart = 0.0;
            if (match(i, now.col(i), &apart) >= 0) {
                sum += face_template().weights[i] * std::exp(-apart / 72.0);
            }
        }
        return sum / face_template().weights.sum();
    }

    std::unique_ptr<Bend> bend(const Level& level, Points& now) const {
        const FaceTemplate& face = face_template();
        const Eigen::Index n = level.nodes;
        auto bend = std::make_unique<Bend>(face.points.leftCols(n), level.smoothing);
        for (int step = 0; step < level.steps; ++step) {
            Points displacement(3, n);
            for (Eigen::Index i = 0; i < n; ++i) {
                displacement.col(i) = target(i, now.col(i), level.reach) - face.points.col(i);
            }
            bend->fit(displacement);
            const Eigen::Index moved = step + 1 < level.steps ? n : face.points.cols();
            parallel_for(static_cast<int>(moved), 64, [&](int begin, int end) {
                for (int i = begin; i < end; ++i) {
                    now.col(i) = (*bend)(Vec3(face.points.col(i)));
                }
            });
        }
        return bend;
    }

    /// Where a point of the template, now at p, is drawn.
    Vec3 target(Eigen::Index i, const Vec3& p, double reach) const {
        const int near = match(i, p);
        if (near < 0) {
            return p;
        }
        const Vec3 normal = samples_.normals.col(near);
        const Vec3 way = samples_.points.col(near) - p;
        const double far = way.norm() / reach;
        if (far > 3.0) {
            return p;
        }
        // Mostly along the normal: skin slides along skin for little.
        const double weight =
            (0.3 + 0.7 * face_template().weights[i]) / ((1.0 + far * far) * (1.0 + far * far));
        return p + weight * ((1.0 - kAlong) * normal.dot(way) * normal + kAlong * way);
    }

    const SurfaceSamples& samples_;
    Features features_;
    PointTree<6> tree_;
};

/// Depth of the face over a grid in its own front view [mm].
class FrontView {
public:
    /// @param deepest what lies behind this is seen through a gap and counts as this deep [mm]
    FrontView(const TriangleMesh& mesh, const Bvh& bvh, double deepest)
        : mesh_(mesh), bvh_(bvh), deepest_(deepest) {}

    double depth(double x, double y) const {
        const auto hit = bvh_.first_hit(mesh_, {Vec3(x, y, 250.0), -Vec3::UnitZ()});
        return hit ? std::max(250.0 - hit->distance, deepest_) : deepest_;
    }

    /// How much lower the skin lies at a height than 3 mm above and below it [mm].
    double valley(double x, double y) const {
        return 0.5 * (depth(x, y + 3.0) + depth(x, y - 3.0)) - depth(x, y);
    }

private:
    const TriangleMesh& mesh_;
    const Bvh& bvh_;
    double deepest_;
};

/// Where lips meet: heights of the crease between them from the middle to both corners.
struct LipCrease {
    Vec3 middle, left, right;
};

/// Follows the crease between closed lips from near `middle` outwards as long as it is there.
std::optional<LipCrease> lip_crease(const FrontView& view, const Vec3& middle) {
    constexpr double kStep = 0.5;
    const auto deepest = [&](double x, double around, double reach) {
        std::pair<double, double> best{around, -1.0};
        for (double y = around - reach; y <= around + reach; y += kStep) {
            const double valley = view.valley(x, y);
            if (valley > best.second) {
                best = {y, valley};
            }
        }
        return best;
    };
    // Near where the fit expects it: the groove above the upper lip is a valley too.
    double start = middle.y();
    double likely = 0.0;
    for (double y = middle.y() - 8.0; y <= middle.y() + 8.0; y += kStep) {
        const double off = (y - middle.y()) / 5.0;
        const double value = view.valley(middle.x(), y) * std::exp(-off * off);
        if (value > likely) {
            likely = value;
            start = y;
        }
    }
    const double relief = view.valley(middle.x(), start);
    if (relief < 0.4) {
        return std::nullopt;
    }
    LipCrease crease;
    crease.middle = {middle.x(), start, view.depth(middle.x(), start)};
    for (const double side : {1.0, -1.0}) {
        double y = start;
        Vec3 corner = crease.middle;
        int missing = 0;
        for (double off = 1.0; off <= 38.0 && missing < 3; off += 1.0) {
            const double x = middle.x() + side * off;
            const auto [here, valley] = deepest(x, y, 1.5);
            if (valley < kCreaseShare * relief) {
                ++missing;
                continue;
            }
            missing = 0;
            y = here;
            corner = {x, y, view.depth(x, y)};
        }
        (side > 0.0 ? crease.left : crease.right) = corner;
    }
    return crease;
}

/// How far each kind of landmark is usually off [mm]; larger for those beside the fitted front.
double usual_error(const std::string& name) {
    static const std::map<std::string, double> kErrors{
        {"prn", 2.0}, {"sn", 1.5}, {"ls", 1.5}, {"li", 2.0}, {"sto", 1.5},  {"pg", 3.0},
        {"gn", 4.0},  {"n", 3.0},  {"se", 2.0}, {"g", 4.0},  {"c", 2.0},    {"sl", 2.5},
        {"en", 2.5},  {"ex", 3.0}, {"al", 2.0}, {"ac", 2.5}, {"sbal", 2.5}, {"ch", 2.5},
        {"cph", 2.0}, {"zy", 7.0}, {"go", 8.0}, {"t", 8.0},  {"ft", 7.0},   {"tr", 12.0}};
    const auto found = kErrors.find(name.substr(0, name.find('_')));
    return found == kErrors.end() ? 5.0 : found->second;
}

}  // namespace

DetectedLandmarks detect_landmarks(const TriangleMesh& mesh, const FacePose* known,
                                   const Progress* progress) {
    const std::optional<FacePose> pose =
        known != nullptr ? std::optional<FacePose>(*known) : find_face(mesh, progress);
    DetectedLandmarks result;
    result.confidence = pose ? confidence_of(*pose) : 0.0;
    if (result.confidence < kSureOfAFace) {
        throw InvalidInput(
            "No face was found on this scan. If it shows one, place the landmarks by hand.");
    }
    const TriangleMesh part = around_face(mesh, pose->to_generic);
    const SurfaceSamples samples = sample_surface(part, kSamples);
    if (samples.points.cols() < 500) {
        throw InvalidInput("Too little of a face is left on this scan.");
    }
    const Fitted fitted = Bender(samples).fit(progress);
    std::vector<double> distances(fitted.distance.data(),
                                  fitted.distance.data() + fitted.distance.size());
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    result.residual_mm = *middle / pose->to_generic.scale;

    // Proportions that nobody has mean that the fit went astray.
    result.confidence *= std::exp(-4.0 * oddness([&](const std::string& name) {
        return (*fitted.bend)(generic_landmarks().at(name).position);
    }));
    const FaceTemplate& face = face_template();
    const Bvh bvh(part);
    const Similarity back = pose->to_generic.inverse();
    const Vec3 lips = (*fitted.bend)(generic_landmarks().at("sto").position);
    const std::optional<LipCrease> crease = lip_crease(FrontView(part, bvh, lips.z() - 25.0), lips);
    for (const auto& [name, landmark] : generic_landmarks()) {
        Vec3 bent = (*fitted.bend)(landmark.position);
        if (crease && name == "sto") {
            bent.y() = crease->middle.y();
        } else if (crease && (name == "ch_l" || name == "ch_r")) {
            const Vec3& corner = name == "ch_l" ? crease->left : crease->right;
            // A crease that fades early says nothing; one that goes on is followed.
            const bool further = std::abs(corner.x() - lips.x()) > std::abs(bent.x() - lips.x());
            bent = further && (corner - bent).norm() < 14.0 ? corner : bent;
        }
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
            back(on_scan.point), usual_error(name) * std::min(doubt, 4.0) / pose->to_generic.scale};
    }
    return result;
}

}  // namespace myoface
