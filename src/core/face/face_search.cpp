// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/face_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "myoface/base/parallel.h"
#include "myoface/io/mesh_file.h"

#include "face_template.h"
#include "point_tree.h"
#include "registration.h"
#include "surface_samples.h"

namespace myoface {
namespace {

constexpr int kSamples = 40000;
constexpr int kFewestVertices = 60;  // of anything that can have eyes, nose and mouth
constexpr double kSmallest = 120.0;  // [mm] assumed size of the whole mesh: a tight crop …
constexpr double kLargest = 2300.0;  // … to a standing person
constexpr double kSizeStep = 1.22;
constexpr double kGoodEnough = 0.7;  // quality that ends the search
constexpr double kWorthATry = 0.5;   // quality of a pose that is looked at more closely
constexpr double kCell = 6.0;        // [mm]
constexpr int kCellReach = 4;        // cells
constexpr std::size_t kCandidates = 60;
constexpr std::size_t kKeptPerSize = 25;
constexpr std::size_t kRefined = 20;
constexpr std::size_t kFinalists = 6;
constexpr Eigen::Index kFew = 150;   // template points to search with,
constexpr Eigen::Index kSome = 500;  // to refine with

/// Average head -> mesh, with what it is worth.
struct Hypothesis {
    Similarity place;
    double score = 0.0;
};

/// The samples under one assumed size of the mesh, in mm of the average head.
struct SizedSamples {
    double scale = 1.0;  ///< mm per unit of the mesh
    Points points;
    const Points& normals;
    NearestTable table;

    SizedSamples(const SurfaceSamples& samples, double mm_per_unit)
        : scale(mm_per_unit),
          points(mm_per_unit * samples.points),
          normals(samples.normals),
          table(points, kCell, kCellReach) {}
};

double reach_bump(double d2, double reach) {
    return std::exp(-d2 / (reach * reach));
}

/// How well the first template points lie on the samples, 0 … 1.
double score(const SizedSamples& samples, const Similarity& place, Eigen::Index count) {
    const FaceTemplate& face = face_template();
    double sum = 0.0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const Vec3 p = place(Vec3(face.points.col(i)));
        const int near = samples.table.near(p);
        if (near < 0) {
            continue;
        }
        const double facing = samples.normals.col(near).dot(place.rotation * face.normals.col(i));
        if (facing > 0.0) {
            const double d2 = (samples.points.col(near) - p).squaredNorm();
            sum += face.weights[i] * facing * reach_bump(d2, 11.3);
        }
    }
    return sum / face.weights.head(count).sum();
}

/// One thinned-out sample per cell, gathered in coarse cells for neighbourhoods.
class Neighbourhoods {
public:
    explicit Neighbourhoods(const SizedSamples& samples) : samples_(samples) {
        const Vec3 low = samples.points.rowwise().minCoeff();
        std::vector<std::pair<std::uint64_t, int>> keys;
        for (Eigen::Index i = 0; i < samples.points.cols(); ++i) {
            keys.emplace_back(key((samples.points.col(i) - low) / kCell), static_cast<int>(i));
        }
        std::sort(keys.begin(), keys.end());
        for (std::size_t k = 0; k < keys.size(); ++k) {
            if (k == 0 || keys[k].first != keys[k - 1].first) {
                chosen_.push_back(keys[k].second);
            }
        }
        low_ = low - Vec3::Constant(kNoseReach);
        for (const int i : chosen_) {
            const Vec3 p = samples.points.col(i);
            cells_.emplace_back(key((p - low_) / kNoseReach), i);
        }
        std::sort(cells_.begin(), cells_.end());
    }

    const std::vector<int>& chosen() const { return chosen_; }

    template <typename Visit>
    void around(const Vec3& p, double reach, const Visit& visit) const {
        const Eigen::Array3d at = ((p - low_) / kNoseReach).array().floor();
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dy = -1; dy <= 1; ++dy) {
                // Three cells along x are one run of keys.
                const std::uint64_t first = key((at + Eigen::Array3d(-1, dy, dz)).matrix());
                auto entry = std::lower_bound(cells_.begin(), cells_.end(), std::pair(first, -1));
                for (; entry != cells_.end() && entry->first <= first + 2; ++entry) {
                    const double distance = (samples_.points.col(entry->second) - p).norm();
                    if (distance < reach) {
                        visit(entry->second, distance);
                    }
                }
            }
        }
    }

private:
    static std::uint64_t key(const Vec3& cell) {
        const auto part = [](double x) {
            return static_cast<std::uint64_t>(std::clamp(x + 1.0, 0.0, 1e6));
        };
        return part(cell.x()) | part(cell.y()) << 20 | part(cell.z()) << 40;
    }

    const SizedSamples& samples_;
    std::vector<int> chosen_;
    Vec3 low_ = Vec3::Zero();
    std::vector<std::pair<std::uint64_t, int>> cells_;
};

struct NoseLike {
    Vec3 tip, normal;
    double height;
};

/// Places that stand out from what is around them about as much as a nose does.
std::vector<NoseLike> noses(const SizedSamples& samples) {
    const Neighbourhoods around(samples);
    std::vector<NoseLike> all;
    const double usual = face_template().tip_height;
    for (const int i : around.chosen()) {
        const Vec3 p = samples.points.col(i);
        Vec3 normal = Vec3::Zero();
        around.around(p, kNormalReach, [&](int k, double) { normal += samples.normals.col(k); });
        if (normal.norm() < 1e-9) {
            continue;
        }
        normal.normalize();
        double height = 0.0;
        int count = 0;
        around.around(p, kNoseReach, [&](int k, double) {
            height += normal.dot(p - samples.points.col(k)) / kNoseReach;
            ++count;
        });
        height /= count;
        if (count >= 8 && height > 0.45 * usual && height < 2.0 * usual) {
            all.push_back({p, normal, height});
        }
    }
    // Those nearest to the usual height first, none close to a better one.
    std::stable_sort(all.begin(), all.end(), [&](const NoseLike& a, const NoseLike& b) {
        return std::min(a.height, usual) > std::min(b.height, usual);
    });
    std::vector<NoseLike> kept;
    for (const NoseLike& nose : all) {
        const bool close = std::any_of(kept.begin(), kept.end(), [&](const NoseLike& other) {
            return (nose.tip - other.tip).norm() < 14.0;
        });
        if (!close) {
            kept.push_back(nose);
        }
        if (kept.size() == kCandidates) {
            break;
        }
    }
    return kept;
}

Mat3 turn(const Vec3& axis, double degrees) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis).toRotationMatrix();
}

/// Gauss-Newton step of a similarity towards point-plane pairs. The little of point-to-point in it
/// keeps the scale from running away.
class SimilarityStep {
public:
    explicit SimilarityStep(const Vec3& centre) : centre_(centre) {}

    void add(const Vec3& from, const Vec3& to, const Vec3& normal, double weight) {
        constexpr double kPointShare = 0.15;
        const Vec3 arm = from - centre_;
        Eigen::Matrix<double, 3, 7> motion;
        motion << 0, arm.z(), -arm.y(), 1, 0, 0, arm.x(),  //
            -arm.z(), 0, arm.x(), 0, 1, 0, arm.y(),        //
            arm.y(), -arm.x(), 0, 0, 0, 1, arm.z();
        const Mat3 metric = weight * (normal * normal.transpose() + kPointShare * Mat3::Identity());
        matrix_ += motion.transpose() * metric * motion;
        vector_ += motion.transpose() * metric * (to - from);
    }

    /// @return the step as a map of space; scale changes by at most 8 %
    Similarity solve() const {
        Eigen::Matrix<double, 7, 7> matrix = matrix_;
        matrix.diagonal().array() += 1e-9 * matrix.diagonal().maxCoeff() + 1e-12;
        const Eigen::Matrix<double, 7, 1> x = matrix.ldlt().solve(vector_);
        const Vec3 axis = x.head<3>();
        const double angle = std::min(axis.norm(), 0.5);
        Similarity step;
        step.scale = std::clamp(1.0 + x[6], 0.92, 1.08);
        step.rotation = angle > 0.0 ? Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix()
                                    : Mat3(Mat3::Identity());
        step.shift = centre_ + x.segment<3>(3) - step.scale * (step.rotation * centre_);
        return step;
    }

private:
    Vec3 centre_;
    Eigen::Matrix<double, 7, 7> matrix_ = Eigen::Matrix<double, 7, 7>::Zero();
    Eigen::Matrix<double, 7, 1> vector_ = Eigen::Matrix<double, 7, 1>::Zero();
};

Similarity after(const Similarity& first, const Similarity& second) {
    return {second.scale * first.scale, second.rotation * first.rotation, second(first.shift)};
}

/// Registration on the table of cells; the scale stays near what the size assumes.
void refine(const SizedSamples& samples, Hypothesis& hypothesis, int steps, double from, double to,
            Eigen::Index count) {
    const FaceTemplate& face = face_template();
    for (int step = 0; step < steps; ++step) {
        const double reach = from + (to - from) * step / std::max(steps - 1, 1);
        SimilarityStep next(hypothesis.place(face.centre));
        double total = 0.0;
        for (Eigen::Index i = 0; i < count; ++i) {
            const Vec3 p = hypothesis.place(Vec3(face.points.col(i)));
            const int near = samples.table.near(p);
            if (near < 0) {
                continue;
            }
            const Vec3 normal = samples.normals.col(near);
            const double facing = normal.dot(hypothesis.place.rotation * face.normals.col(i));
            if (facing < 0.3) {
                continue;
            }
            const Vec3 to_sample = samples.points.col(near);
            const double far = (to_sample - p).squaredNorm() / (reach * reach);
            const double weight = face.weights[i] * facing / ((1.0 + far) * (1.0 + far));
            next.add(p, to_sample, normal, weight);
            total += weight;
        }
        if (total < 5.0) {
            break;
        }
        const Similarity moved = after(hypothesis.place, next.solve());
        if (moved.scale < 0.65 || moved.scale > 1.35) {
            break;
        }
        hypothesis.place = moved;
    }
    hypothesis.score = score(samples, hypothesis.place, count);
}

/// Share of places in front of the middle of the face where something is: nothing ever is before a
/// face, but the inside of a head passes for its outside.
double blocked(const SizedSamples& samples, const Similarity& place) {
    const FaceTemplate& face = face_template();
    int hits = 0;
    int asked = 0;
    const Vec3 front = place.rotation * face.tip_normal;
    for (Eigen::Index i = 0; i < kFew; ++i) {
        if ((face.points.col(i) - face.tip).norm() > 45.0) {
            continue;
        }
        for (const double ahead : {30.0, 55.0}) {
            const Vec3 p = place(Vec3(face.points.col(i))) + ahead * front;
            const int near = samples.table.near(p);
            hits += near >= 0 && (samples.points.col(near) - p).norm() < 8.0 ? 1 : 0;
            ++asked;
        }
    }
    return asked > 0 ? static_cast<double>(hits) / asked : 0.0;
}

void keep_best(std::vector<Hypothesis>& list, std::size_t count) {
    std::stable_sort(list.begin(), list.end(),
                     [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; });
    list.resize(std::min(list.size(), count));
}

std::vector<Hypothesis> search(const SizedSamples& samples) {
    const FaceTemplate& face = face_template();
    std::vector<Hypothesis> found;
    for (const NoseLike& nose : noses(samples)) {
        const Mat3 facing =
            Eigen::Quaterniond::FromTwoVectors(face.tip_normal, nose.normal).toRotationMatrix();
        std::vector<Hypothesis> here;
        for (int roll = 0; roll < 24; ++roll) {
            const Mat3 rolled = turn(nose.normal, 15.0 * roll) * facing;
            for (const auto& [axis, degrees] :
                 {std::pair(Vec3(Vec3::UnitX()), 0.0), std::pair(Vec3(Vec3::UnitX()), 22.0),
                  std::pair(Vec3(Vec3::UnitX()), -22.0), std::pair(Vec3(Vec3::UnitY()), 22.0),
                  std::pair(Vec3(Vec3::UnitY()), -22.0)}) {
                Hypothesis hypothesis;
                hypothesis.place.rotation = rolled * turn(axis, degrees);
                hypothesis.place.shift = nose.tip - hypothesis.place.rotation * face.tip;
                hypothesis.score = score(samples, hypothesis.place, kFew);
                here.push_back(hypothesis);
            }
        }
        keep_best(here, 3);
        found.insert(found.end(), here.begin(), here.end());
    }
    keep_best(found, kKeptPerSize);
    for (Hypothesis& hypothesis : found) {
        refine(samples, hypothesis, 6, 12.0, 8.0, kFew);
        hypothesis.score *= 1.0 - std::min(2.0 * blocked(samples, hypothesis.place), 1.0);
    }
    return found;
}

/// Registration on all samples, in the mesh's own unit.
class FineFit {
public:
    explicit FineFit(const SurfaceSamples& samples) : samples_(samples), tree_(samples.points) {}

    void refine(Hypothesis& hypothesis) const {
        const FaceTemplate& face = face_template();
        constexpr int kSteps = 12;
        for (int step = 0; step < kSteps; ++step) {
            const double reach = 8.0 - 5.0 * step / (kSteps - 1);
            SimilarityStep next(hypothesis.place(face.centre));
            double total = 0.0;
            visit(hypothesis.place, [&](Eigen::Index i, const Vec3& p, int near, double facing) {
                const Vec3 to = samples_.points.col(near);
                const double far = (to - p).norm() / hypothesis.place.scale / reach;
                if (facing < 0.5 || far > 3.0) {
                    return;
                }
                const double weight =
                    face.weights[i] * facing / ((1.0 + far * far) * (1.0 + far * far));
                next.add(p, to, samples_.normals.col(near), weight);
                total += weight;
            });
            if (total < 20.0) {
                break;
            }
            hypothesis.place = after(hypothesis.place, next.solve());
        }
        double sum = 0.0;
        visit(hypothesis.place, [&](Eigen::Index i, const Vec3& p, int near, double facing) {
            const double d = (samples_.points.col(near) - p).norm() / hypothesis.place.scale;
            sum += face.weights[i] * std::max(facing, 0.0) * std::exp(-d * d / 50.0);
        });
        hypothesis.score = sum / face.weights.sum();
    }

private:
    /// Calls back with each template point's place and the sample that agrees best in place and
    /// direction.
    template <typename Visit>
    void visit(const Similarity& place, const Visit& visit) const {
        const FaceTemplate& face = face_template();
        constexpr std::size_t kNear = 6;
        constexpr double kTurnCost = 12.0;  // [mm] that a normal at right angles is worth
        std::array<std::uint32_t, kNear> index{};
        std::array<double, kNear> distance{};
        for (Eigen::Index i = 0; i < face.points.cols(); ++i) {
            const Vec3 p = place(Vec3(face.points.col(i)));
            const Vec3 normal = place.rotation * face.normals.col(i);
            const std::size_t count = tree_.nearest(p.data(), kNear, index.data(), distance.data());
            int best = -1;
            double least = 0.0;
            for (std::size_t k = 0; k < count; ++k) {
                const double apart = (samples_.normals.col(index[k]) - normal).squaredNorm() *
                                     kTurnCost * kTurnCost * place.scale * place.scale;
                if (best < 0 || distance[k] + apart < least) {
                    best = static_cast<int>(index[k]);
                    least = distance[k] + apart;
                }
            }
            if (best >= 0) {
                visit(i, p, best, samples_.normals.col(best).dot(normal));
            }
        }
    }

    const SurfaceSamples& samples_;
    PointTree<3> tree_;
};

/// Whether two places of the head are about the same.
bool same_place(const Similarity& a, const Similarity& b) {
    const FaceTemplate& face = face_template();
    const double apart = (a(face.centre) - b(face.centre)).norm() / a.scale;
    const double angle = Eigen::AngleAxisd(Mat3(a.rotation.transpose() * b.rotation)).angle();
    return apart < 15.0 && angle < 0.3 && std::abs(std::log(a.scale / b.scale)) < 0.12;
}

double typical_size(const Points& points) {
    Vec3 median;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values(static_cast<std::size_t>(points.cols()));
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = points(axis, static_cast<Eigen::Index>(i));
        }
        std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
        median[axis] = values[values.size() / 2];
    }
    std::vector<double> distance;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        distance.push_back((points.col(i) - median).norm());
    }
    const auto at = static_cast<std::ptrdiff_t>(0.97 * static_cast<double>(distance.size()));
    std::nth_element(distance.begin(), distance.begin() + at, distance.end());
    return 2.0 * distance[static_cast<std::size_t>(at)];
}

/// The best place of a face under some assumed sizes of the mesh, in mm.
std::optional<FacePose> best_of(const SurfaceSamples& samples, double size,
                                const std::vector<double>& sizes, const FineFit& fine) {
    std::vector<std::vector<Hypothesis>> found(sizes.size());
    parallel_for(static_cast<int>(sizes.size()), 1, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const SizedSamples sized(samples, sizes[k] / size);
            found[k] = search(sized);
            keep_best(found[k], kRefined);
            for (Hypothesis& hypothesis : found[k]) {
                refine(sized, hypothesis, 15, 10.0, 5.0, kSome);
                hypothesis.score *= 1.0 - std::min(2.0 * blocked(sized, hypothesis.place), 1.0);
                // From the sized samples to the mesh's own unit.
                hypothesis.place.scale /= sized.scale;
                hypothesis.place.shift /= sized.scale;
            }
        }
    });
    std::vector<Hypothesis> all;
    for (const auto& list : found) {
        all.insert(all.end(), list.begin(), list.end());
    }
    keep_best(all, all.size());
    std::vector<Hypothesis> finalists;
    for (const Hypothesis& hypothesis : all) {
        const bool known = std::any_of(
            finalists.begin(), finalists.end(),
            [&](const Hypothesis& other) { return same_place(other.place, hypothesis.place); });
        if (!known && hypothesis.score > 0.0) {
            finalists.push_back(hypothesis);
        }
        if (finalists.size() == kFinalists) {
            break;
        }
    }
    if (finalists.empty()) {
        return std::nullopt;
    }
    parallel_for(static_cast<int>(finalists.size()), 1, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            fine.refine(finalists[static_cast<std::size_t>(i)]);
        }
    });
    keep_best(finalists, finalists.size());
    FacePose pose;
    pose.to_generic = finalists[0].place.inverse();
    pose.quality = finalists[0].score;
    // Neighbours of the best are the same face a little worse; what counts is another place or
    // turn.
    const Vec3 centre = face_template().centre;
    const Similarity& best = finalists[0].place;
    for (const Hypothesis& other : finalists) {
        const double angle =
            Eigen::AngleAxisd(Mat3(best.rotation.transpose() * other.place.rotation)).angle();
        if ((best(centre) - other.place(centre)).norm() > 40.0 * best.scale || angle > 0.6) {
            pose.runner_up = std::max(pose.runner_up, other.score);
        }
    }
    return pose;
}

/// Lets the most likely person say how large the head is, how it lies and whether it is one.
void look_closer(const TriangleMesh& mesh, FacePose& pose) {
    constexpr int kCloseSamples = 15000;
    const SurfaceSamples samples =
        sample_surface(around_face(mesh, pose.to_generic), kCloseSamples);
    if (samples.points.cols() < 500) {
        return;
    }
    const LikelyPerson person = likely_person(samples);
    pose.agreement = person.agreement;
    pose.to_generic = after(pose.to_generic, person.place.inverse());
}

}  // namespace

std::optional<FacePose> find_face(const TriangleMesh& mesh, const Progress* progress) {
    const auto report = [&](double share) {
        if (progress != nullptr) {
            progress->report("Looking for the face", share);
        }
    };
    report(0.0);
    if (mesh.vertex_count() < kFewestVertices) {
        return std::nullopt;  // a cube from a sample file: nothing to look for
    }
    const SurfaceSamples samples = sample_surface(mesh, kSamples);
    if (samples.points.cols() < 1000) {
        return std::nullopt;
    }
    const double size = typical_size(samples.points);
    if (!(size > 0.0)) {
        return std::nullopt;
    }
    face_template();  // before many ask for it at once
    report(0.1);
    // Sizes that a usual unit implies are tried first; most scans need no others.
    std::vector<double> usual;
    for (const double unit : {1.0, 10.0, 100.0, 1000.0}) {
        for (const double person : {0.93, 1.08}) {
            const double assumed = size * unit * person;
            if (assumed > kSmallest && assumed < kLargest) {
                usual.push_back(assumed);
            }
        }
    }
    const FineFit fine(samples);
    std::optional<FacePose> pose = best_of(samples, size, usual, fine);
    if (!pose || pose->quality < kGoodEnough) {
        report(0.4);
        std::vector<double> sizes;
        for (double assumed = kSmallest; assumed <= kLargest; assumed *= kSizeStep) {
            sizes.push_back(assumed);
        }
        const std::optional<FacePose> other = best_of(samples, size, sizes, fine);
        if (!pose || (other && other->quality > pose->quality)) {
            pose = other;
        }
    }
    if (pose && pose->quality > kWorthATry) {
        report(0.8);
        look_closer(mesh, *pose);
    }
    report(1.0);
    return pose;
}

double confidence_of(const FacePose& pose) {
    constexpr double kNone = 0.46;  // things that are no faces stay below
    constexpr double kSure = 0.62;  // faces reach it
    const double fit = std::clamp((pose.agreement - kNone) / (kSure - kNone), 0.0, 1.0);
    const double alone = std::clamp((pose.quality - pose.runner_up) / 0.08, 0.0, 1.0);
    return fit * (0.3 + 0.7 * alone);
}

FrameGuess guess_frame(const Scan& scan, const FacePose& pose) {
    FrameGuess guess;
    guess.confidence = confidence_of(pose);
    // From the file's own numbers to the average head.
    const double scale = pose.to_generic.scale * scan.frame.mm_per_unit;
    const Mat3 rotation = pose.to_generic.rotation * scan.frame.axes;
    guess.frame.axes = nearest_quarter_turn(rotation);
    guess.frame.mm_per_unit = scale;
    double closest = std::log(1.28);
    for (const char* unit : {"mm", "cm", "dm", "m", "in"}) {
        const double known = millimetres_per_unit(unit);
        // Faces are up to a quarter smaller than the average man's, hardly larger.
        const double off = std::abs(std::log(scale / known));
        if (off < closest) {
            closest = off;
            guess.frame.mm_per_unit = known;
            guess.usual_unit = true;
        }
    }
    return guess;
}

}  // namespace myoface
