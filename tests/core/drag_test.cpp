// SPDX-License-Identifier: Apache-2.0
#include "myoface/drag/drag.h"

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/mesh/bvh.h"
#include "myoface/physics/forces.h"
#include "myoface/sim/simulator.h"

#include "test_meshes.h"
#include "thorough.h"

namespace myoface {
namespace {

using test::small_model;

SurfacePoint at_landmark(const FaceModel& face, const std::string& name) {
    return Bvh(face.skin.mesh)
        .closest_point(face.skin.mesh, face.landmarks.at(name).position)
        .where;
}

SurfacePoint at_point(const FaceModel& face, const Vec3& place) {
    return Bvh(face.skin.mesh).closest_point(face.skin.mesh, place).where;
}

/// A whole gesture seen along `view`, in `events` equal mouse moves.
DragReport drag(Simulator& sim, const SurfacePoint& where, DragMode mode, const Vec3& view,
                const Vec3& move, int events = 1, bool mirrored = false) {
    DragRequest request;
    request.where = where;
    request.mode = mode;
    request.mirrored = mirrored;
    const Vec3 start = position(sim.face().skin.mesh, where);
    sim.begin_drag(request, {start, view});
    for (int k = 1; k <= events; ++k) {
        sim.move_drag({start + move * k / events, view});
        if (k < events) {
            sim.step(15);
        }
    }
    return *sim.settle().drag;
}

TEST(DepthPart, MovesThePointOnlyAlongTheViewRay) {
    const auto face = small_model();
    const FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    Points x = system.model.rest;
    const int node = 100;
    x.col(node) += Vec3(0.4, -0.7, 0.2);
    const Vec3 view = Vec3(0.3, -0.2, -1.0).normalized();
    const Vec3 move = depth_correction(system.model, x, node, view);
    EXPECT_GT(move.norm(), 1e-4);
    EXPECT_LT(move.cross(view).norm(), 1e-12);
}

TEST(DepthPart, AppliedInTurnMakesTheSpringForceAlongTheViewVanish) {
    MassSpringModel model = test::spring_row(3, 50.0, 10.0, 1.0);
    model.rest(2, 0) = model.rest(2, 2) = 4.0;
    Points x = model.rest;
    x.col(1) << 10.0, 2.0, 9.0;
    const Vec3 view = -Vec3::UnitZ();
    for (int k = 0; k < 20000; ++k) {  // soft along the view: slow alone
        x.col(1) += depth_correction(model, x, 1, view);
    }
    MassSpringState state = rest_state(model);
    state.positions = x;
    const Points forces = spring_forces(model, state, Vec3::Zero());
    EXPECT_NEAR(forces(2, 1), 0.0, 1e-6);
    EXPECT_DOUBLE_EQ(x(0, 1), 10.0);
    EXPECT_DOUBLE_EQ(x(1, 1), 2.0);
}

TEST(DepthPart, DoesNotDivergeForStiffSprings) {
    MassSpringModel model = test::spring_row(3, 1e9, 10.0, 1e-6);
    Points x = model.rest;
    x(2, 1) = 3.0;
    for (int k = 0; k < 100; ++k) {
        x.col(1) += depth_correction(model, x, 1, Vec3::UnitZ());
    }
    EXPECT_LT(std::abs(x(2, 1)), 3.0);
}

TEST(StressKernel, SumsToOneAndFadesWithTheDistanceAlongTheSurface) {
    const auto face = small_model();
    const Grip grip = grip_at(*face, at_landmark(*face, "prn"));
    const StressKernel kernel = stress_kernel(*face, face->skin.mesh.vertices, grip, 15.0, 1.0);
    double sum = 0.0;
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        sum += kernel.weights[k];
        EXPECT_GE(kernel.weights[k], 0.0);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_GT(kernel.nodes.size(), 10U);
}

TEST(StressKernel, GoesFurtherAlongTheSameLabel) {
    // A strip: the left half carries one label, the right half another.
    FaceModel face;
    face.skin.mesh = test::grid(21, 1.0);
    face.adjacency = std::make_shared<Adjacency>(face.skin.mesh);
    face.area = Eigen::VectorXd::Ones(441);
    face.tissue.resize(441);
    for (int v = 0; v < 441; ++v) {
        face.muscles_under.push_back({{face.skin.mesh.vertices(0, v) <= 10.0 ? 0 : 1, 1.0}});
    }
    face.muscles.resize(2);
    Grip grip;
    grip.nodes = {10 * 21 + 10};
    grip.weights = {1.0};
    const StressKernel kernel = stress_kernel(face, face.skin.mesh.vertices, grip, 6.0, 4.0);
    double left = 0.0;
    double right = 0.0;
    for (const int node : kernel.nodes) {
        const double x = face.skin.mesh.vertices(0, node) - 10.0;
        left = std::max(left, -x);
        right = std::max(right, x);
    }
    EXPECT_NEAR(left, 5.0, 1.01);
    EXPECT_LE(right, 3.0);
    EXPECT_GT(left, right);
}

TEST(MousePriority, EndsOnTheRayWithoutForceAlongIt) {
    Simulator sim(small_model());
    const DragReport report = drag(sim, at_landmark(sim.face(), "prn"), DragMode::MousePriority,
                                   -Vec3::UnitX(), Vec3(0.0, 4.0, 3.0));
    EXPECT_LT(report.off_ray_mm, 0.05);
    EXPECT_LT(report.view_force_residual, 0.01);
    EXPECT_GT(report.force_mN, 100.0);
}

TEST(MousePriority, KeepsThePointUnderTheCursorInEveryFrame) {
    // Also when the hand is quick, and whether the gesture comes in 3 or 30 events.
    const auto face = small_model();
    Points first;
    for (const int events : {3, 30}) {
        for (const char* at : {"ch_l", "prn", "pg", "g"}) {
            Simulator sim(face);
            DragRequest request;
            request.where = at_landmark(*face, at);
            const Vec3 start = position(face->skin.mesh, request.where);
            const Vec3 view = Vec3(-0.3, 0.1, -1.0).normalized();
            const auto plane = view_plane(view);
            const auto ray = [&](double share) {
                return ViewRay{
                    start + share * (5.0 * plane.col(0) + 4.0 * plane.col(1)) - 300.0 * view, view};
            };
            sim.begin_drag(request, ray(0.0));
            for (int e = 1; e <= events; ++e) {
                sim.move_drag(ray(static_cast<double>(e) / events));
                EXPECT_LT(sim.step(20).drag->off_ray_mm, 0.02) << at;
            }
            const StepReport report = sim.settle(RelaxOptions{}.still_mm, false);
            EXPECT_LT(report.drag->off_ray_mm, 0.005) << at;
            EXPECT_LT(report.drag->view_force_residual, 0.01) << at;
            const Points on_from_there = sim.state().positions;
            sim.settle();
            const Points settled = sim.state().positions;
            EXPECT_LT((on_from_there - settled).colwise().norm().maxCoeff(), 0.05) << at;
            if (std::string(at) == "ch_l") {
                if (first.cols() == 0) {
                    first = settled;
                }
                EXPECT_EQ(settled, first);  // to the bit, however it came
            }
            // There and back before release: as if nothing had been.
            for (int e = events; e >= 0; --e) {
                sim.move_drag(ray(static_cast<double>(e) / events));
                sim.step(20);
            }
            sim.settle();
            EXPECT_LT((sim.state().positions - sim.system().model.rest).colwise().norm().maxCoeff(),
                      0.05)
                << at;
        }
    }
}

TEST(MousePriority, FindsItsDepthWithoutJumps) {
    // Sideways by 10 mm in small steps: the depth is a smooth curve.
    const auto face = small_model();
    const int steps = test::thorough() ? 20 : 10;
    const double width = 10.0 / steps;  // [mm]
    // A bend grows with the square of the steps; what jumps does not shrink with them.
    const double most = 1.0 * width * width;
    for (const char* at : {"g", "prn", "ls", "pg", "zy_l"}) {
        Simulator sim(face);
        DragRequest request;
        request.where = at_landmark(*face, at);
        const Vec3 start = position(face->skin.mesh, request.where);
        const Vec3 view = -Vec3::UnitZ();
        sim.begin_drag(request, {start - 300.0 * view, view});
        std::vector<double> depth{start.z()};
        for (int step = 1; step <= steps; ++step) {
            sim.move_drag({start + Vec3(width * step, 0.0, 0.0) - 300.0 * view, view});
            depth.push_back(sim.settle().drag->reached.z());
        }
        for (std::size_t k = 2; k < depth.size(); ++k) {
            EXPECT_LT(std::abs(depth[k] - 2.0 * depth[k - 1] + depth[k - 2]), most)
                << at << ' ' << k;
        }
    }
}

TEST(MousePriority, TakesAMouthCornerBackAlongTheFace) {
    Simulator sim(small_model());
    const SurfacePoint corner = at_landmark(sim.face(), "ch_l");
    const Vec3 start = position(sim.face().skin.mesh, corner);
    DragRequest request;
    request.where = corner;
    const Vec3 view = -Vec3::UnitZ();
    sim.begin_drag(request, {start - 300.0 * view, view});
    double before = start.z();
    for (const double way : {2.0, 4.0, 6.0, 8.0}) {
        sim.move_drag({start + Vec3(way, 0.0, 0.0) - 300.0 * view, view});
        const double depth = sim.settle().drag->reached.z();
        EXPECT_LT(depth, before) << way;
        before = depth;
    }
}

TEST(ConstraintPriority, IsKeptOnRequest) {
    Simulator sim(small_model());
    DragRequest request;
    request.where = at_landmark(sim.face(), "pg");
    request.mode = DragMode::ConstraintPriority;
    const Vec3 start = position(sim.face().skin.mesh, request.where);
    const Vec3 view = -Vec3::UnitX();
    sim.begin_drag(request, {start - 300.0 * view, view});
    sim.move_drag({start + Vec3(0.0, 0.0, 6.0) - 300.0 * view, view});
    sim.settle();
    sim.end_drag(true);
    const Points kept = sim.skin_rest() - sim.face().skin.mesh.vertices;
    EXPECT_GT(kept.colwise().norm().maxCoeff(), 0.5);
}

TEST(MousePriority, GoesOnlyWhereItsPathAllows) {
    const auto face = small_model();
    const SurfacePoint where = at_point(*face, {30.0, -28.0, 85.0});
    const Vec3 start = position(face->skin.mesh, where);
    for (const DragPath path : {DragPath::Normal, DragPath::Midplane}) {
        Simulator sim(face);
        DragRequest request;
        request.where = where;
        request.path = path;
        const Vec3 view = path == DragPath::Normal ? Vec3(-Vec3::UnitX()) : Vec3(-Vec3::UnitZ());
        sim.begin_drag(request, {start - 300.0 * view, view});
        sim.move_drag({start + Vec3(3.0, 3.0, 3.0) - 300.0 * view, view});
        const Vec3 moved = sim.settle().drag->reached - start;
        EXPECT_GT(moved.norm(), 1.0);
        if (path == DragPath::Normal) {
            Vec3 normal = Vec3::Zero();
            for (int c = 0; c < 3; ++c) {
                normal += where.weights[c] *
                          face->sliding[face->skin.mesh.triangles(c, where.triangle)].normal;
            }
            // The plane across its ray is held; along it the tissue says where.
            EXPECT_LT((moved - moved.dot(normal.normalized()) * normal.normalized()).norm(),
                      0.5 * moved.norm());
        } else {
            EXPECT_NEAR(moved.dot(face->axes.col(0)), 0.0, 0.01);
            EXPECT_NEAR(moved.dot(face->axes.col(1)), 3.0, 0.1);
        }
    }
}

TEST(MousePriority, FindsItsOwnDepth) {
    // A cheek dragged sideways goes back along the face, not through the air.
    Simulator sim(small_model());
    const SurfacePoint cheek = at_point(sim.face(), {38.0, -25.0, 80.0});
    const Vec3 start = position(sim.face().skin.mesh, cheek);
    const DragReport report =
        drag(sim, cheek, DragMode::MousePriority, -Vec3::UnitZ(), Vec3(8.0, 0.0, 0.0));
    EXPECT_LT(report.off_ray_mm, 0.05);
    EXPECT_LT(report.reached.z() - start.z(), -1.0);
    EXPECT_GT(report.reached.z() - start.z(), -10.0);
}

TEST(MousePriority, DoesNotDependOnTheNumberOfMouseEvents) {
    Simulator once(small_model());
    Simulator often(small_model());
    const SurfacePoint chin = at_landmark(once.face(), "pg");
    const Vec3 move(2.0, -3.0, 0.0);
    const DragReport a = drag(once, chin, DragMode::MousePriority, -Vec3::UnitZ(), move, 1);
    const DragReport b = drag(often, chin, DragMode::MousePriority, -Vec3::UnitZ(), move, 30);
    EXPECT_LT((a.reached - b.reached).norm(), 0.05);
    EXPECT_LT((once.state().positions - often.state().positions).cwiseAbs().maxCoeff(), 0.1);
}

TEST(MousePriority, KeepsTheShapeOnRelease) {
    Simulator sim(small_model());
    drag(sim, at_landmark(sim.face(), "prn"), DragMode::MousePriority, -Vec3::UnitX(),
         Vec3(0.0, 3.0, 2.0));
    const Points shown = sim.state().positions.leftCols(sim.face().node_count());
    sim.end_drag(true);
    sim.settle();
    const Points after = sim.state().positions.leftCols(sim.face().node_count());
    EXPECT_LT((after - shown).cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_GT((sim.skin_rest() - sim.face().skin.mesh.vertices).cwiseAbs().maxCoeff(), 2.5);
}

TEST(MousePriority, GivenUpSpringsBack) {
    Simulator sim(small_model());
    drag(sim, at_landmark(sim.face(), "ch_l"), DragMode::MousePriority, -Vec3::UnitZ(),
         Vec3(4.0, 0.0, 0.0));
    sim.end_drag(false);
    sim.settle();
    const Points left = sim.state().positions - sim.system().model.rest;
    EXPECT_LT(left.leftCols(sim.face().node_count()).cwiseAbs().maxCoeff(), 2e-3);
}

TEST(MousePriority, MirroredMovesBothSidesAlike) {
    Simulator sim(small_model());
    const SurfacePoint corner = at_landmark(sim.face(), "ch_l");
    drag(sim, corner, DragMode::MousePriority, -Vec3::UnitZ(), Vec3(3.0, 2.0, 0.0), 1, true);
    const FaceModel& face = sim.face();
    const auto moved = [&](const std::string& name) -> Vec3 {
        const SurfacePoint where = at_landmark(face, name);
        const TriangleMesh now{sim.state().positions.leftCols(face.node_count()),
                               face.skin.mesh.triangles};
        return position(now, where) - position(face.skin.mesh, where);
    };
    const Vec3 left = moved("ch_l");
    const Vec3 right = moved("ch_r");
    EXPECT_NEAR(left.x(), 3.0, 0.1);
    EXPECT_NEAR(left.x(), -right.x(), 0.15);
    EXPECT_NEAR(left.y(), right.y(), 0.15);
    EXPECT_NEAR(left.z(), right.z(), 0.15);
}

TEST(ConstraintPriority, StaysBehindTheHandLessOnTheCheekThanOnTheForehead) {
    Simulator forehead(small_model());
    Simulator cheek(small_model());
    const Vec3 move(5.0, 0.0, 0.0);
    const DragReport f = drag(forehead, at_point(forehead.face(), {0.0, 60.0, 100.0}),
                              DragMode::ConstraintPriority, -Vec3::UnitZ(), move);
    const DragReport c = drag(cheek, at_point(cheek.face(), {38.0, -25.0, 80.0}),
                              DragMode::ConstraintPriority, -Vec3::UnitZ(), move);
    EXPECT_GT(f.off_ray_mm, 0.3);
    EXPECT_GT(c.off_ray_mm, 0.3);
    EXPECT_LT(5.0 - f.off_ray_mm, 5.0 - c.off_ray_mm);
    EXPECT_GT(f.stage_skin_mN, 0.0);
    EXPECT_GT(c.stage_skin_mN, 0.0);
}

TEST(ConstraintPriority, PassesOnToTheMuscleWhatTheSkinCannotTake) {
    Simulator sim(small_model());
    const DragReport report =
        drag(sim, at_landmark(sim.face(), "prn"), DragMode::ConstraintPriority, -Vec3::UnitZ(),
             Vec3(8.0, 0.0, 0.0));
    EXPECT_GT(report.stage_skin_mN, 0.0);
    EXPECT_GT(report.stage_muscle_mN, 0.0);
    EXPECT_LE(report.strain_share, 1.31);
}

TEST(ConstraintPriority, ReachesFurtherForALongerPullAndNeverPastTheMouse) {
    double last = 0.0;
    for (const double way : {1.0, 3.0, 6.0, 12.0}) {
        Simulator sim(small_model());
        const SurfacePoint lip = at_landmark(sim.face(), "li");
        const Vec3 start = position(sim.face().skin.mesh, lip);
        const DragReport report =
            drag(sim, lip, DragMode::ConstraintPriority, -Vec3::UnitZ(), Vec3(0.0, -way, 0.0));
        const double reach = start.y() - report.reached.y();
        EXPECT_GT(reach, last);
        EXPECT_LT(reach, way);
        last = reach;
    }
}

TEST(ConstraintPriority, SpringsBackOnRelease) {
    Simulator sim(small_model());
    drag(sim, at_landmark(sim.face(), "pg"), DragMode::ConstraintPriority, -Vec3::UnitZ(),
         Vec3(6.0, 0.0, 0.0));
    sim.end_drag(false);
    sim.settle();
    const Points left = sim.state().positions - sim.system().model.rest;
    EXPECT_LT(left.leftCols(sim.face().node_count()).cwiseAbs().maxCoeff(), 2e-3);
    EXPECT_EQ(sim.skin_rest(), sim.face().skin.mesh.vertices);
}

TEST(MousePriority, PullsNoSkinIntoBoneButLeavesAGap) {
    // At the forehead's top, seen from the side, the hand goes straight into the skull.
    Simulator sim(small_model());
    const SurfacePoint where = at_point(sim.face(), Vec3(0, 75, 110));
    const DragReport report =
        drag(sim, where, DragMode::MousePriority, -Vec3::UnitX(), Vec3(0, -8, -14), 6);
    EXPECT_GT(report.off_ray_mm, 2.0);
    EXPECT_LT(report.force_mN, 1.1e5);
    const Bvh bone(sim.face().bone);
    const ClosestPoint found = bone.closest_point(sim.face().bone, report.reached);
    const Vec3 start = position(sim.face().skin.mesh, where);
    const Vec3 off = report.reached - position(sim.face().bone, found.where);
    EXPECT_GT(off.dot(start -
                      position(sim.face().bone, bone.closest_point(sim.face().bone, start).where)),
              0.0);
}

TEST(MousePriority, KeepsNoShapeThatFoldsTheSkin) {
    Simulator sim(small_model());
    const SurfacePoint where = at_landmark(sim.face(), "ch_l");
    DragRequest request;
    request.where = where;
    request.radius = 6.0;
    const Vec3 start = position(sim.face().skin.mesh, where);
    sim.begin_drag(request, {start, -Vec3::UnitZ()});
    for (int k = 1; k <= 10; ++k) {
        sim.move_drag({start + Vec3(-4.5 * k, 0, 0), -Vec3::UnitZ()});
        sim.step(12);
    }
    const Points before = sim.face().skin.mesh.vertices;
    ASSERT_GT(turned_over(sim.face(), before, sim.state().positions), 0);
    const DragReport report = sim.end_drag(true);
    EXPECT_LT(report.kept_share, 1.0);
    EXPECT_GT(report.kept_share, 0.0);
    EXPECT_EQ(turned_over(sim.face(), before, sim.skin_rest()), 0);
}

TEST(Drag, OfWhatDoesNotMoveIsRefused) {
    Simulator sim(small_model());
    DragRequest request;
    request.where = at_point(sim.face(), {0.0, 20.0, -100.0});  // back of the head
    EXPECT_THROW(sim.begin_drag(request, {}), InvalidInput);
}

TEST(Drag, NeverExplodes) {
    Simulator sim(small_model());
    std::srand(11);
    for (const char* name : {"prn", "ch_r", "ex_l", "pg", "ls"}) {
        DragRequest request;
        request.where = at_landmark(sim.face(), name);
        const Vec3 start = position(sim.face().skin.mesh, request.where);
        sim.begin_drag(request, {start, -Vec3::UnitZ()});
        for (int k = 0; k < 12; ++k) {  // a wild hand
            sim.move_drag({start + 40.0 * Vec3::Random(), -Vec3::UnitZ()});
            sim.step(10);
            ASSERT_TRUE(sim.state().positions.allFinite());
            ASSERT_LT((sim.state().positions - sim.system().model.rest).cwiseAbs().maxCoeff(),
                      150.0);
        }
        sim.end_drag(false);
        sim.settle();
    }
    const Points left = sim.state().positions - sim.system().model.rest;
    EXPECT_LT(left.leftCols(sim.face().node_count()).cwiseAbs().maxCoeff(), 5e-3);
}

}  // namespace
}  // namespace myoface
