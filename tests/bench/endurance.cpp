// SPDX-License-Identifier: Apache-2.0
// Random drags and muscle settings, extreme ones among them, on several faces:
//   myoface-endurance GESTURES [SCAN...]
// Says what went wrong, with the number that repeats it, and how often; ends with 1 if anything
// did.
#include <cstdio>
#include <cstdlib>
#include <random>

#include "myoface/cases/case_file.h"
#include "myoface/face/generic_face.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/normals.h"
#include "myoface/sim/simulator.h"

namespace myoface {
namespace {

constexpr double kDeepest = 0.2;     // of skin in bone [mm]
constexpr double kRestAgain = 1e-4;  // [mm]

struct Findings {
    int gestures = 0, not_finite = 0, undone = 0, folded = 0, in_bone = 0, not_at_rest = 0;
    double deepest = 0.0, furthest_from_rest = 0.0;
};

/// How far skin that rests outside the bone stands inside it.
class BoneCheck {
public:
    explicit BoneCheck(const FaceModel& face)
        : face_(face), bvh_(face.bone), normals_(vertex_normals(face.bone, Adjacency(face.bone))) {
        for (int i = 0; i < face.node_count(); ++i) {
            const bool skin = face.tissue[static_cast<std::size_t>(i)].tissue == Tissue::Skin;
            rest_.push_back(skin ? height(face.skin.mesh.vertices.col(i)) : 0.0);
        }
    }
    double deepest(const Points& positions) const {
        double deepest = 0.0;
        for (int i = 0; i < face_.node_count(); i += 3) {
            if (rest_[static_cast<std::size_t>(i)] > 0.5) {
                deepest = std::max(deepest, -height(positions.col(i)));
            }
        }

        return deepest;
    }

private:
    /// Above the bone's surface; only where the point of the bone faces outwards.
    double height(const Vec3& at) const {
        const ClosestPoint found = bvh_.closest_point(face_.bone, at);
        const Vec3 off = at - position(face_.bone, found.where);
        const Vec3 normal = normals_.col(face_.bone.triangles(0, found.where.triangle)) +
                            normals_.col(face_.bone.triangles(1, found.where.triangle)) +
                            normals_.col(face_.bone.triangles(2, found.where.triangle));
        const double distance = off.norm();
        return distance < 8.0 ? (off.dot(normal) < 0.0 ? -distance : distance) : 8.0;
    }

    const FaceModel& face_;
    Bvh bvh_;
    Points normals_;
    std::vector<double> rest_;
};

class Trial {
public:
    explicit Trial(std::shared_ptr<const FaceModel> face)
        : face_(std::move(face)), simulator_(face_), bone_(*face_) {}

    void gesture(unsigned seed, Findings& found) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        const auto muscles = static_cast<unsigned>(face_->muscles.size());
        for (int k = static_cast<int>(unit(random) * 4.0); k > 0; --k) {
            simulator_.set_contraction(static_cast<int>(random() % muscles),
                                       unit(random) < 0.3 ? 1.0 : 1.5 * unit(random) - 0.5);
        }
        bool finite = true;
        const auto frames = [&](int count) {
            for (int f = 0; f < count; ++f) {
                finite = simulator_.step(12).finite && finite;
            }
        };
        if (drag(random, unit)) {
            frames(2);
            const bool judging = request_mode_ == DragMode::ConstraintPriority;
            simulator_.end_drag(unit(random) < 0.3 && !judging);
        }
        frames(2);
        ++found.gestures;
        if (!finite) {
            ++found.undone;
            std::printf("gesture %u: a step ran away and was undone\n", seed);
        }
        if (!simulator_.state().positions.allFinite()) {
            ++found.not_finite;
            std::printf("gesture %u: not finite\n", seed);
        }
        const int folds = turned_over(*face_, face_->skin.mesh.vertices, simulator_.skin_rest());
        if (folds > 0) {
            ++found.folded;
            std::printf("gesture %u: %d triangles left turned over\n", seed, folds);
        }
        if (seed % 8 == 0 && jaw_opening(*face_, simulator_.contractions()) == 0.0) {
            const double deep = bone_.deepest(simulator_.state().positions);
            found.deepest = std::max(found.deepest, deep);
            if (deep > kDeepest) {
                ++found.in_bone;
                std::printf("gesture %u: skin %.2f mm inside the bone\n", seed, deep);
            }
        }
        if (seed % 16 == 0) {
            back_to_rest(seed, found);
        }
    }

private:
    bool drag(std::mt19937& random, std::uniform_real_distribution<double>& unit) {
        const auto triangle =
            static_cast<int>(random() % static_cast<unsigned>(face_->skin.mesh.triangle_count()));
        DragRequest request;
        request.where = {triangle, Vec3(0.3, 0.3, 0.4)};
        request.mode = unit(random) < 0.6 ? DragMode::MousePriority : DragMode::ConstraintPriority;
        request.mirrored = unit(random) < 0.3;
        request_mode_ = request.mode;
        const Vec3 direction =
            -Vec3(2.0 * unit(random) - 1.0, unit(random) - 0.5, 0.3 + unit(random)).normalized();
        const Vec3 start = position(face_->skin.mesh, request.where);
        const Eigen::Matrix<double, 3, 2> plane = view_plane(direction);
        const double size = unit(random) < 0.1 ? 60.0 : 15.0 * unit(random);
        const double turn = 6.283 * unit(random);
        const Vec3 way = size * (plane * Eigen::Vector2d(std::cos(turn), std::sin(turn)));
        try {
            simulator_.begin_drag(request, {start - 300.0 * direction, direction});
        } catch (const InvalidInput&) {
            return false;  // neck or back of the head
        }
        const int events = 1 + static_cast<int>(unit(random) * 5.0);
        for (int e = 1; e <= events; ++e) {
            simulator_.move_drag({start + way * e / events - 300.0 * direction, direction});
            simulator_.step(12);
        }
        return true;
    }

    void back_to_rest(unsigned seed, Findings& found) {
        for (std::size_t m = 0; m < face_->muscles.size(); ++m) {
            simulator_.set_contraction(static_cast<int>(m), 0.0);
        }
        simulator_.set_skin_rest(face_->skin.mesh.vertices);
        simulator_.settle();
        const Points left = simulator_.state().positions - simulator_.system().model.rest;
        const double most = std::sqrt(left.colwise().squaredNorm().maxCoeff());
        found.furthest_from_rest = std::max(found.furthest_from_rest, most);
        if (!(most < kRestAgain)) {
            ++found.not_at_rest;
            std::printf("gesture %u: %.5f mm from rest after a reset\n", seed, most);
        }
    }

    std::shared_ptr<const FaceModel> face_;
    Simulator simulator_;
    DragMode request_mode_ = DragMode::MousePriority;
    BoneCheck bone_;
};

}  // namespace
}  // namespace myoface

int main(int argc, char** argv) {
    using namespace myoface;
    if (argc < 2) {
        std::fprintf(stderr, "usage: myoface-endurance GESTURES [SCAN...]\n");
        return 2;
    }
    std::vector<std::unique_ptr<Trial>> trials;
    for (int k = 0; k < 4; ++k) {
        GenericFaceOptions options;
        options.vertices = 3000 + 500 * k;
        options.seed = static_cast<unsigned>(k);
        options.sex = k % 2 == 0 ? Sex::Female : Sex::Male;
        const GenericFace head = make_generic_face(options);
        trials.push_back(std::make_unique<Trial>(
            fit_face(std::make_shared<const Scan>(head.scan), head.landmarks)));
    }
    for (int a = 2; a < argc; ++a) {
        OpenedFace opened = open_face(argv[a]);
        find_missing_landmarks(opened);
        trials.push_back(std::make_unique<Trial>(fit_face(opened.scan, *opened.landmarks)));
    }
    Findings found;
    const auto count = static_cast<unsigned>(std::max(1, std::atoi(argv[1])));
    for (unsigned g = 0; g < count; ++g) {
        trials[g % trials.size()]->gesture(g, found);
        if ((g + 1) % 1000 == 0) {
            std::fprintf(stderr, "%u\n", g + 1);
        }
    }
    std::printf(
        "%d gestures on %zu faces: %d not finite, %d steps undone, %d left folds, "
        "%d with skin in bone (deepest %.2f mm), %d not back at rest (furthest %.6f mm)\n",
        found.gestures, trials.size(), found.not_finite, found.undone, found.folded, found.in_bone,
        found.deepest, found.not_at_rest, found.furthest_from_rest);
    return found.not_finite + found.folded + found.in_bone + found.not_at_rest > 0 ? 1 : 0;
}
