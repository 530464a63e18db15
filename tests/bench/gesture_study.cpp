// SPDX-License-Identifier: Apache-2.0
// How well both drags keep their promises, on generated faces and scans:
//   myoface-gesture-study GESTURES [--generated N] [SCAN...]
// Shaping: random gestures in perspective and orthographic views; how many pixels the point is off
// the cursor in every frame and at rest, what force is left along the ray, how far from the place
// that a solver finds which goes there in one move, how far 3, 30 and 300 events differ, what is
// left after there and back, how far skin glides when what the hand holds settles for good, how
// often skin folds. Judging: how far an equal stress reaches in four
// regions, how it grows, how much further it goes along a muscle than across, how much volume the
// face gains or loses. Ends with 1 where a promise is broken.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

#include "myoface/cases/case_file.h"
#include "myoface/face/generic_face.h"
#include "myoface/measure/volume.h"
#include "myoface/mesh/bvh.h"
#include "myoface/scene/camera.h"
#include "myoface/sim/simulator.h"

#include "measure.h"

namespace myoface {
namespace {

using bench::quantile;

constexpr int kWidth = 1280;
constexpr int kHeight = 900;

struct Named {
    std::string name;
    std::shared_ptr<const FaceModel> face;
};

double furthest(const Points& a, const Points& b) {
    return std::sqrt((a - b).colwise().squaredNorm().maxCoeff());
}

/// One gesture as the mouse makes it: from a pixel to another.
struct Gesture {
    DragRequest request;
    Camera camera;
    double from_x = 0.0, from_y = 0.0, to_x = 0.0, to_y = 0.0;

    ViewRay ray(double share) const {
        return view_ray(camera, from_x + share * (to_x - from_x), from_y + share * (to_y - from_y),
                        kWidth, kHeight);
    }
    double pixels_off(const Vec3& point, double share) const {
        const PixelPoint seen = project(camera, point, kWidth, kHeight);
        return std::hypot(seen.x - from_x - share * (to_x - from_x),
                          seen.y - from_y - share * (to_y - from_y));
    }
};

Gesture random_gesture(const FaceModel& face, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const TriangleMesh& mesh = face.skin.mesh;
    Gesture gesture;
    for (;;) {
        const auto t = static_cast<int>(random() % static_cast<unsigned>(mesh.triangle_count()));
        const auto corner = static_cast<std::size_t>(mesh.triangles(0, t));
        const TissueProperties& tissue = face.tissue[corner];
        const Vec3 normal = face.sliding[corner].normal;
        const bool on_face = tissue.tissue == Tissue::Skin && !tissue.fixed &&
                             tissue.region != Region::Neck && tissue.region != Region::Scalp &&
                             tissue.region != Region::Ear;
        // Seen from anywhere in front of the skin there, as a hand would turn the head.
        const Vec3 towards = (normal + Vec3(unit(random) - 0.5, 0.6 * unit(random) - 0.3, 0.0) +
                              0.3 * unit(random) * Vec3::UnitZ())
                                 .normalized();
        if (!on_face || towards.dot(normal) < 0.4) {
            continue;
        }
        double a = unit(random);
        double b = unit(random);
        if (a + b > 1.0) {
            a = 1.0 - a;
            b = 1.0 - b;
        }
        gesture.request.where = {t, Vec3(1.0 - a - b, a, b)};
        const Vec3 start = position(mesh, gesture.request.where);
        const auto plane = view_plane(-towards);
        Mat3 axes;
        axes << plane.col(0), plane.col(1), towards;
        gesture.camera.orientation = Eigen::Quaterniond(axes);
        gesture.camera.target = face.axes.col(2) * 40.0 + 0.5 * start;
        gesture.camera.distance = 250.0 + 500.0 * unit(random);
        gesture.camera.orthographic = unit(random) < 0.5;
        const PixelPoint at = project(gesture.camera, start, kWidth, kHeight);
        const double way = (2.0 + 8.0 * unit(random)) / gesture.camera.mm_per_pixel(kHeight);
        const double turn = 6.2831853 * unit(random);
        gesture.from_x = at.x;
        gesture.from_y = at.y;
        gesture.to_x = at.x + way * std::cos(turn);
        gesture.to_y = at.y + way * std::sin(turn);
        return gesture;
    }
}

struct Findings {
    std::vector<double> off_frame, off_settled, view_force, depth, events, back, glide;
    int yielding = 0, folded_held = 0, folded_kept = 0, gestures = 0;
};

/// The gesture in so many events. @return where it ends
/// @param glide how far it goes when it settles for good [mm]
Points played(Simulator& sim, const Gesture& gesture, int events, std::vector<double>* off,
              std::vector<double>* glide) {
    sim.begin_drag(gesture.request, gesture.ray(0.0));
    for (int e = 1; e <= events; ++e) {
        const double share = static_cast<double>(e) / events;
        sim.move_drag(gesture.ray(share));
        const StepReport step = sim.step(18);
        if (off != nullptr) {
            off->push_back(gesture.pixels_off(step.drag->reached, share));
        }
    }
    if (glide != nullptr) {
        sim.settle(RelaxOptions{}.still_mm, false);
    }
    const Points held = sim.state().positions;
    sim.settle();
    if (glide != nullptr) {
        glide->push_back(furthest(held, sim.state().positions));
    }
    return sim.state().positions;
}

void shape(const FaceModel& face, Simulator& sim, const Gesture& gesture, bool often,
           Findings& found, unsigned seed) {
    const Points rest = sim.state().positions;
    const auto give_up = [&] {
        sim.end_drag(false);
        sim.settle();
    };
    ++found.gestures;
    // In one move: the equilibrium that the others are compared with.
    sim.begin_drag(gesture.request, gesture.ray(0.0));
    sim.move_drag(gesture.ray(1.0));
    const StepReport whole = sim.settle();
    const Points equilibrium = sim.state().positions;
    const Vec3 there = whole.drag->reached;
    give_up();
    if (whole.drag->off_ray_mm > 0.01) {
        ++found.yielding;  // bone is in the way, and the gap is shown
        return;
    }
    std::vector<double> off;
    const Points thirty = played(sim, gesture, 30, &off, &found.glide);
    const StepReport settled = sim.settle();
    found.off_frame.push_back(quantile(off, 1.0));
    found.off_settled.push_back(gesture.pixels_off(settled.drag->reached, 1.0));
    found.view_force.push_back(settled.drag->view_force_residual);
    found.depth.push_back(
        std::abs((settled.drag->reached - there).dot(gesture.ray(1.0).direction)));
    const bool folds = turned_over(face, face.skin.mesh.vertices, thirty) > 0;
    found.folded_held += folds;
    for (int e = 29; e >= 0; --e) {
        sim.move_drag(gesture.ray(e / 30.0));
        sim.step(18);
    }
    sim.settle();
    found.back.push_back(furthest(sim.state().positions, rest));
    give_up();
    double apart = furthest(thirty, equilibrium);
    for (const int events : {3, 300}) {
        if (events == 300 && !often) {
            continue;
        }
        apart = std::max(apart, furthest(played(sim, gesture, events, nullptr, nullptr), thirty));
        give_up();
    }
    found.events.push_back(apart);
    if (apart > 0.05 || found.back.back() > 0.05) {
        std::printf("  gesture %u: %.3f mm apart, %.3f mm left after there and back%s\n", seed,
                    apart, found.back.back(), folds ? ", with folds" : "");
    }
    played(sim, gesture, 30, nullptr, nullptr);
    sim.end_drag(true);
    found.folded_kept += turned_over(face, face.skin.mesh.vertices, sim.skin_rest()) > 0;
    sim.set_skin_rest(face.skin.mesh.vertices);
    sim.settle();
}

/// What a stress does at a place. @param direction of the pull, along the skin
struct Answer {
    double reach = 0.0;      ///< of the place, along the pull [mm]
    double volume_ml = 0.0;  ///< gained by the whole face
    Points moved;            ///< 3×skin nodes [mm]
};
Answer answer(Simulator& sim, const SurfacePoint& where, const Vec3& direction, double force_mN) {
    const FaceModel& face = sim.face();
    DragRequest request;
    request.where = where;
    request.mode = DragMode::ConstraintPriority;
    request.force_mN = force_mN;
    const Vec3 start = position(face.skin.mesh, where);
    const Vec3 normal =
        face.sliding[static_cast<std::size_t>(face.skin.mesh.triangles(0, where.triangle))].normal;
    const Vec3 view = -normal;
    const Vec3 pull = (direction - direction.dot(normal) * normal).normalized();
    sim.begin_drag(request, {start - 300.0 * view, view});
    sim.move_drag({start + 20.0 * pull - 300.0 * view, view});
    const StepReport report = sim.settle();
    Answer result;
    const int n = face.node_count();
    result.moved = sim.state().positions.leftCols(n) - face.skin.mesh.vertices;
    result.reach = (report.drag->reached - start).dot(pull);
    result.volume_ml = swept_volume(face.skin.mesh.triangles, face.skin.mesh.vertices,
                                    sim.state().positions.leftCols(n)) /
                       1000.0;
    sim.end_drag(false);
    sim.settle();
    return result;
}

SurfacePoint near_generic(const FaceModel& face, const Vec3& place) {
    return Bvh(face.skin.mesh).closest_point(face.skin.mesh, from_generic(face, place)).where;
}

SurfacePoint at_landmark(const FaceModel& face, const std::string& name) {
    return Bvh(face.skin.mesh)
        .closest_point(face.skin.mesh, face.landmarks.at(name).position)
        .where;
}

/// Soft tissue of the face between skin and bone [mL].
double tissue_volume(const FaceModel& face) {
    double volume = 0.0;
    for (int i = 0; i < face.node_count(); ++i) {
        const TissueProperties& tissue = face.tissue[static_cast<std::size_t>(i)];
        if (tissue.tissue == Tissue::Skin && !tissue.fixed && tissue.region != Region::Neck &&
            tissue.region != Region::Scalp) {
            volume += face.area[i] * tissue.depth / 1000.0;
        }
    }
    return volume;
}

/// How far an answer reaches from a place along a direction, both ways: to where it has fallen to a
/// share of what it is at the place.
double reach_along(const FaceModel& face, const Points& moved, const Vec3& from, const Vec3& way,
                   double share) {
    constexpr double kNarrow = 0.35;  // sine of the angle that still counts as along
    double most = 0.0;
    double peak = std::sqrt(moved.colwise().squaredNorm().maxCoeff());
    for (int i = 0; i < face.node_count(); ++i) {
        const Vec3 off = face.skin.mesh.vertices.col(i) - from;
        const double along = std::abs(off.dot(way));
        if (off.norm() > 1e-6 && (off - off.dot(way) * way).norm() < kNarrow * off.norm() &&
            moved.col(i).norm() > share * peak) {
            most = std::max(most, along);
        }
    }
    return most;
}

bool judge(const Named& subject) {
    const FaceModel& face = *subject.face;
    Simulator sim(subject.face);
    const std::vector<std::pair<const char*, SurfacePoint>> places = {
        {"forehead", near_generic(face, {14.0, 60.0, 100.0})},
        {"temple", near_generic(face, {60.0, 34.0, 48.0})},
        {"cheek", near_generic(face, {38.0, -25.0, 80.0})},
        {"lower lip", at_landmark(face, "li")}};
    bool good = true;
    std::vector<double> last_place(3, 0.0);
    double worst_volume = 0.0;
    const double whole = tissue_volume(face);
    for (const auto& [name, where] : places) {
        std::printf("  %-9s reach", name);
        double before = 0.0;
        for (int f = 0; f < 3; ++f) {
            const double force = 1000.0 * (1 << f);
            double reach = 0.0;
            double each[4] = {};
            int e = 0;
            for (const Vec3& way : {Vec3(face.axes.col(0)), Vec3(face.axes.col(1))}) {
                const Answer there = answer(sim, where, way, force);
                const Answer back = answer(sim, where, -way, force);
                reach += 0.25 * (there.reach + back.reach);
                each[e++] = there.reach;
                each[e++] = back.reach;
                worst_volume = std::max({worst_volume, std::abs(there.volume_ml) / whole,
                                         std::abs(back.volume_ml) / whole});
            }
            std::printf(" %.2f (left %.2f, right %.2f, up %.2f, down %.2f)", reach, each[0],
                        each[1], each[2], each[3]);
            const bool grows = reach >= before - 0.01;
            const bool further = reach > last_place[static_cast<std::size_t>(f)];
            good = good && grows && further;
            std::printf("%s%s", grows ? "" : " (shrinks)", further ? "" : " (not further)");
            before = reach;
            last_place[static_cast<std::size_t>(f)] = reach;
        }
        std::printf(" mm at 1, 2, 4 N\n");
    }
    // Along the zygomaticus and across it.
    for (std::size_t m = 0; m < face.muscles.size(); ++m) {
        const Muscle& muscle = face.muscles[m];
        if (muscle.traits.name != "zygomaticus_major.L") {
            continue;
        }
        const Eigen::Index middle = muscle.path.cols() / 2;
        const Vec3 centre = muscle.path.col(middle);
        const SurfacePoint where = Bvh(face.skin.mesh).closest_point(face.skin.mesh, centre).where;
        const Vec3 from = position(face.skin.mesh, where);
        const Vec3 fibre = (muscle.path.col(middle + 1) - muscle.path.col(middle - 1)).normalized();
        const Vec3 normal =
            face.sliding[static_cast<std::size_t>(face.skin.mesh.triangles(0, where.triangle))]
                .normal;
        const Vec3 along = (fibre - fibre.dot(normal) * normal).normalized();
        const Vec3 beside = normal.cross(along);
        const Grip grip = grip_at(face, where);
        const StressKernel kernel =
            stress_kernel(face, face.skin.mesh.vertices, grip, 12.0, 1.8, 2.5);
        Points stress = Points::Zero(3, face.node_count());
        for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
            stress(0, kernel.nodes[k]) = kernel.profile[k];
        }
        const double of_stress = reach_along(face, stress, from, along, 0.1) /
                                 std::max(reach_along(face, stress, from, beside, 0.1), 1e-9);
        const Answer there = answer(sim, where, along, 2000.0);
        const Answer across = answer(sim, where, beside, 2000.0);
        std::printf(
            "  zygomaticus: stress %.2f times further along than across; answer to 50 %%: pulled "
            "along "
            "%.1f by %.1f mm, pulled across %.1f by %.1f mm\n",
            of_stress, reach_along(face, there.moved, from, along, 0.5),
            reach_along(face, there.moved, from, beside, 0.5),
            reach_along(face, across.moved, from, along, 0.5),
            reach_along(face, across.moved, from, beside, 0.5));
        good = good && of_stress >= 2.0;
    }
    std::printf("  volume of the face's %.0f mL of tissue changes by %.2f %% at most\n", whole,
                100.0 * worst_volume);
    return good && worst_volume < 0.01;
}

void line(const char* what, const std::vector<double>& values, const char* unit) {
    if (!values.empty()) {
        std::printf("  %-34s median %.4f, 95 %% %.4f, most %.4f %s\n", what, quantile(values, 0.5),
                    quantile(values, 0.95), quantile(values, 1.0), unit);
    }
}

}  // namespace
}  // namespace myoface

int main(int argc, char** argv) {
    using namespace myoface;
    if (argc < 2) {
        std::fprintf(stderr, "usage: myoface-gesture-study GESTURES [--generated N] [SCAN...]\n");
        return 2;
    }
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    std::vector<Named> subjects;
    int generated = 3;
    std::vector<const char*> scans;
    for (int a = 2; a < argc; ++a) {
        if (a + 1 < argc && std::strcmp(argv[a], "--generated") == 0) {
            generated = std::atoi(argv[++a]);
        } else {
            scans.push_back(argv[a]);
        }
    }
    for (int k = 0; k < generated; ++k) {
        GenericFaceOptions options;
        options.vertices = 5000 + 1500 * k;
        options.seed = static_cast<unsigned>(k);
        options.sex = k % 2 == 0 ? Sex::Female : Sex::Male;
        const GenericFace head = make_generic_face(options);
        subjects.push_back({"generated " + std::to_string(k),
                            fit_face(std::make_shared<const Scan>(head.scan), head.landmarks)});
    }
    for (const char* scan : scans) {
        OpenedFace opened = open_face(scan);
        find_missing_landmarks(opened);
        subjects.push_back({scan, fit_face(opened.scan, *opened.landmarks)});
    }
    bool good = true;
    const int count = std::atoi(argv[1]);
    for (const Named& subject : subjects) {
        std::printf("%s\n", subject.name.c_str());
        good = judge(subject) && good;
        std::fflush(stdout);
        Simulator sim(subject.face);
        Findings found;
        for (int g = 0; g < count; ++g) {
            std::mt19937 random(static_cast<unsigned>(g) + 1U);
            const Gesture gesture = random_gesture(*subject.face, random);
            shape(*subject.face, sim, gesture, g % 10 == 0, found, static_cast<unsigned>(g));
        }
        if (count > 0) {
            line("off the cursor, worst frame", found.off_frame, "pixels");
            line("off the cursor, at rest", found.off_settled, "pixels");
            line("force along the ray, of the start", found.view_force, "");
            line("depth beside one move's", found.depth, "mm");
            line("1, 3, 30 (and 300) events apart", found.events, "mm");
            line("left after there and back", found.back, "mm");
            line("glides when it settles", found.glide, "mm");
            std::printf(
                "  %d gestures: %d meet bone and yield, %d fold skin while held, %d leave folds\n",
                found.gestures, found.yielding, found.folded_held, found.folded_kept);
            good = good && found.folded_kept == 0 && quantile(found.off_frame, 1.0) <= 0.25 &&
                   quantile(found.off_settled, 1.0) <= 0.05 &&
                   quantile(found.view_force, 1.0) <= 0.01 && quantile(found.depth, 1.0) <= 0.1 &&
                   quantile(found.events, 1.0) <= 0.05 && quantile(found.back, 1.0) <= 0.05;
        }
        std::fflush(stdout);
    }
    return good ? 0 : 1;
}
