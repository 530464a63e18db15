// SPDX-License-Identifier: Apache-2.0
#include "registration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "myoface/base/parallel.h"

#include "face_template.h"
#include "people.h"
#include "point_tree.h"

namespace myoface {
namespace {

// What else a pair differs by counts as being this far apart.
constexpr double kTurnCost = 25.0;   // [mm] normals at right angles
constexpr double kFineCost = 6.0;    // [mm/mm] relief over kFineReach
constexpr double kCoarseCost = 4.0;  // [mm/mm] relief over kCoarseReach
using Features = Eigen::Matrix<double, 8, Eigen::Dynamic>;

/// A stage of finding the most likely person.
struct PersonLevel {
    Eigen::Index nodes;
    double reach;  ///< [mm] at which a pair counts a quarter
    double noise;  ///< one sigma of a pair [mm]
    int steps;
};
constexpr std::array<PersonLevel, 2> kBeginning{{{250, 14.0, 3.0, 7}, {250, 9.0, 2.5, 7}}};
constexpr std::array<PersonLevel, 3> kPerson{
    {{600, 8.0, 2.0, 6}, {1200, 6.0, 1.6, 6}, {1200, 4.5, 1.2, 8}}};
constexpr double kCorrelated = 0.02;  // nodes that err together count as fewer
constexpr double kAlong = 0.25;       // weight of a pair's way along the skin

/// A stage of the free bend.
struct BendLevel {
    Eigen::Index nodes;
    double smoothing;  ///< [mm]
    double reach;      ///< [mm]
    double slide;      ///< share of a pair's way along the skin that is gone
    int steps;
};
constexpr std::array<BendLevel, 3> kBends{
    {{200, 60.0, 6.0, 0.4, 8}, {400, 20.0, 4.0, 0.4, 8}, {600, 8.0, 3.0, 0.4, 8}}};
// Between landmarks that are known: closer to the skin, and hardly along it.
constexpr std::array<BendLevel, 4> kClose{{{200, 60.0, 6.0, 0.1, 8},
                                           {400, 20.0, 4.0, 0.1, 6},
                                           {600, 6.0, 3.0, 0.1, 6},
                                           {900, 0.8, 2.5, 0.1, 5}}};
constexpr double kWidestOpen = 5.0;   // [SD] of the jaw
constexpr double kFaceReach = 135.0;  // [mm] around the middle of the face that is looked at

using Person = LikelyPerson;

class Registrar {
public:
    explicit Registrar(const SurfaceSamples& samples)
        : samples_(samples), features_(features_of(samples)), tree_(features_) {}

    Registration run(const Progress* progress) const {
        const auto report = [&](double share) {
            if (progress != nullptr) {
                progress->report("Finding landmarks", share);
            }
        };
        report(0.1);
        const Person person = most_likely();
        const Points base = placed(person, face_.points.cols());
        Registration result;
        report(0.7);
        const Points points = bent(base, person.place.rotation, {}, kBends);
        result.distance = distances(points, person.place.rotation);
        report(1.0);
        const Eigen::Index kept = kBends.back().nodes;
        result.warp = WarpCentres(face_.points.leftCols(kept), Eigen::VectorXd::Ones(kept))
                          .towards(points.leftCols(kept));
        return result;
    }

    /// The template's points bent from `base` onto the samples, pins being held.
    Points bent(const Points& base, const Mat3& turn, const Pins& pins,
                std::span<const BendLevel> levels) const {
        Points now = base;
        for (const BendLevel& level : levels) {
            bend(level, base, turn, pins, now);
        }
        return now;
    }

    /// How far the surface is from each of the template's points.
    Eigen::VectorXd distances(const Points& now, const Mat3& turn) const {
        Eigen::VectorXd distance(now.cols());
        for (Eigen::Index i = 0; i < now.cols(); ++i) {
            const int near = match(i, now.col(i), turn * face_.normals.col(i));
            distance[i] = near < 0 ? 50.0
                                   : std::abs(samples_.normals.col(near).dot(
                                         Vec3(now.col(i)) - Vec3(samples_.points.col(near))));
        }
        return distance;
    }

    /// The best of several beginnings: a long or short face, or one that looks up, draws the fit
    /// into another fold of the lips.
    Person most_likely() const {
        Person person = best_beginning();
        for (const PersonLevel& level : kPerson) {
            for (int step = 0; step < level.steps; ++step) {
                improve(person, level);
            }
        }
        person.agreement = agreement(placed(person, face_.points.cols()), person);
        return person;
    }

private:
    static Features features_of(const SurfaceSamples& samples) {
        Features features(8, samples.points.cols());
        features << samples.points, kTurnCost * samples.normals,
            kFineCost * relief(samples, kFineReach).transpose(),
            kCoarseCost * relief(samples, kCoarseReach).transpose();
        return features;
    }

    Vec3 shaped(const Person& person, Eigen::Index i) const {
        return face_.points.col(i) + people_.mean.col(i) +
               people_.modes.middleRows<3>(3 * i) * person.modes;
    }

    Points placed(const Person& person, Eigen::Index count) const {
        Points points(3, count);
        for (Eigen::Index i = 0; i < count; ++i) {
            points.col(i) = person.place(shaped(person, i));
        }
        return points;
    }

    Vec3 normal_of(const Person& person, Eigen::Index i) const {
        return person.place.rotation * face_.normals.col(i);
    }

    /// The sample that agrees best in place, direction and relief, or -1.
    int match(Eigen::Index i, const Vec3& p, const Vec3& normal, double* apart = nullptr) const {
        Eigen::Matrix<double, 8, 1> query;
        query << p, kTurnCost * normal, kFineCost * face_.fine_relief[i],
            kCoarseCost * face_.coarse_relief[i];
        std::uint32_t index = 0;
        double distance = 0.0;
        const bool found = tree_.nearest(query.data(), 1, &index, &distance) == 1 &&
                           samples_.normals.col(index).dot(normal) > 0.5;
        if (apart != nullptr) {
            *apart = distance;
        }
        return found ? static_cast<int>(index) : -1;
    }

    /// How well points lie in place, direction and relief, 0 … 1.
    double agreement(const Points& now, const Person& person) const {
        double sum = 0.0;
        double all = 0.0;
        for (Eigen::Index i = 0; i < now.cols(); ++i) {
            double apart = 0.0;
            all += face_.weights[i];
            if (match(i, now.col(i), normal_of(person, i), &apart) >= 0) {
                sum += face_.weights[i] * std::exp(-apart / 72.0);
            }
        }
        return sum / all;
    }

    Person best_beginning() const {
        struct Beginning {
            double pitch, open;
        };
        constexpr std::array<Beginning, 5> kStarts{
            {{0.0, 0.0}, {12.0, 0.0}, {-12.0, 0.0}, {0.0, 2.0}, {-8.0, 3.5}}};
        std::array<Person, kStarts.size()> persons;
        std::array<double, kStarts.size()> worth{};
        parallel_for(static_cast<int>(kStarts.size()), 1, [&](int begin, int end) {
            for (int k = begin; k < end; ++k) {
                const auto at = static_cast<std::size_t>(k);
                Person& person = persons[at];
                person.modes = Eigen::VectorXd::Zero(people_.modes.cols());
                person.modes[people_.jaw] = kStarts[at].open;
                person.place.rotation =
                    Eigen::AngleAxisd(kStarts[at].pitch / 57.2958, Vec3::UnitX())
                        .toRotationMatrix();
                person.place.shift = face_.tip - person.place.rotation * face_.tip;
                for (const PersonLevel& level : kBeginning) {
                    for (int step = 0; step < level.steps; ++step) {
                        improve(person, level);
                    }
                }
                worth[at] =
                    agreement(placed(person, kPerson.front().nodes), person) -
                    0.01 * person.modes.squaredNorm() / static_cast<double>(person.modes.size());
            }
        });
        return persons[static_cast<std::size_t>(std::max_element(worth.begin(), worth.end()) -
                                                worth.begin())];
    }

    /// One Gauss-Newton step of similarity and modes towards the pairs as they are now.
    void improve(Person& person, const PersonLevel& level) const {
        const Eigen::Index modes = person.modes.size();
        const Eigen::Index size = 7 + modes;
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
        Eigen::VectorXd vector = Eigen::VectorXd::Zero(size);
        Eigen::MatrixXd rows(4, size);
        const Vec3 centre = person.place(face_.centre);
        const double thinned =
            static_cast<double>(face_.points.cols()) / static_cast<double>(level.nodes);
        for (Eigen::Index i = 0; i < level.nodes; ++i) {
            const Vec3 p = person.place(shaped(person, i));
            const Vec3 facing = normal_of(person, i);
            const int near = match(i, p, facing);
            if (near < 0) {
                continue;
            }
            const Vec3 way = samples_.points.col(near) - p;
            const double far = way.norm() / level.reach;
            if (far > 3.0) {
                continue;
            }
            const Vec3 normal = samples_.normals.col(near);
            const double weight = face_.weights[i] * thinned * kCorrelated /
                                  ((1.0 + far * far) * (1.0 + far * far)) /
                                  (level.noise * level.noise);
            const Vec3 arm = p - centre;
            Eigen::MatrixXd motion(3, size);
            motion.leftCols<7>() << 0, arm.z(), -arm.y(), 1, 0, 0, arm.x(),  //
                -arm.z(), 0, arm.x(), 0, 1, 0, arm.y(),                      //
                arm.y(), -arm.x(), 0, 0, 0, 1, arm.z();
            motion.rightCols(modes) =
                person.place.scale * person.place.rotation * people_.modes.middleRows<3>(3 * i);
            rows.row(0) = normal.transpose() * motion;
            rows.bottomRows<3>() = std::sqrt(kAlong) * motion;
            Eigen::Vector4d wanted;
            wanted << normal.dot(way), std::sqrt(kAlong) * way;
            matrix.noalias() += weight * rows.transpose() * rows;
            vector.noalias() += weight * rows.transpose() * wanted;
        }
        matrix.diagonal().head<7>().array() += 1e-6 * matrix.diagonal().head<7>().maxCoeff() + 1e-9;
        for (Eigen::Index k = 0; k < modes; ++k) {
            matrix(7 + k, 7 + k) += 1.0;
            vector[7 + k] -= person.modes[k];
        }
        const Eigen::VectorXd step = matrix.ldlt().solve(vector);
        if (!step.allFinite()) {
            return;
        }
        const Vec3 axis = step.head<3>();
        const double angle = std::min(axis.norm(), 0.3);
        Similarity next;
        next.scale = std::clamp(1.0 + step[6], 0.92, 1.08);
        if (angle > 0.0) {
            next.rotation = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
        }
        next.shift = centre + step.segment<3>(3) - next.scale * (next.rotation * centre);
        person.place = {next.scale * person.place.scale, next.rotation * person.place.rotation,
                        next(person.place.shift)};
        person.modes += step.tail(modes);
        const double open = std::min(person.modes[people_.jaw], kWidestOpen);
        person.modes = person.modes.cwiseMax(-3.5).cwiseMin(3.5);
        person.modes[people_.jaw] = std::max(open, -0.3);
    }

    /// Moves the points on by a smooth displacement through the first of them and the pins.
    void bend(const BendLevel& level, const Points& base, const Mat3& turn, const Pins& pins,
              Points& now) const {
        const Eigen::Index n = level.nodes;
        const Eigen::Index held = pins.from.cols();
        Points from(3, n + held);
        from << base.leftCols(n), pins.from;
        Eigen::VectorXd softness(n + held);
        softness << Eigen::VectorXd::Constant(n, level.smoothing), pins.softness;
        const WarpCentres centres(from, softness);
        Points to(3, n + held);
        to.rightCols(held) = pins.to;
        for (int step = 0; step < level.steps; ++step) {
            parallel_for(static_cast<int>(n), 64, [&](int begin, int end) {
                for (int i = begin; i < end; ++i) {
                    to.col(i) = target(turn, i, now.col(i), level);
                }
            });
            const Eigen::Index moved = step + 1 < level.steps ? n : base.cols();
            now.leftCols(moved) = centres.towards(to)(Points(base.leftCols(moved)));
        }
    }

    /// Where a point of the template, now at p, is drawn.
    Vec3 target(const Mat3& turn, Eigen::Index i, const Vec3& p, const BendLevel& level) const {
        const int near = match(i, p, turn * face_.normals.col(i));
        if (near < 0) {
            return p;
        }
        const Vec3 normal = samples_.normals.col(near);
        const Vec3 way = samples_.points.col(near) - p;
        const double far = way.norm() / level.reach;
        if (far > 3.0) {
            return p;
        }
        // Mostly along the normal: skin slides along skin for little.
        const double weight =
            (0.3 + 0.7 * face_.weights[i]) / ((1.0 + far * far) * (1.0 + far * far));
        return p + weight * ((1.0 - level.slide) * normal.dot(way) * normal + level.slide * way);
    }

    const SurfaceSamples& samples_;
    const FaceTemplate& face_ = face_template();
    const People& people_ = people();
    Features features_;
    PointTree<8> tree_;
};

}  // namespace

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

LikelyPerson likely_person(const SurfaceSamples& samples) {
    return Registrar(samples).most_likely();
}

DenseFit bend_onto(const SurfaceSamples& samples, const SmoothWarp& start, const Pins& pins) {
    const Registrar registrar(samples);
    DenseFit fit;
    fit.points = registrar.bent(start(face_template().points), Mat3::Identity(), pins, kClose);
    fit.distance = registrar.distances(fit.points, Mat3::Identity());
    return fit;
}

Registration register_face(const SurfaceSamples& samples, const Progress* progress) {
    return Registrar(samples).run(progress);
}

}  // namespace myoface
