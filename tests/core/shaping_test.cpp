// SPDX-License-Identifier: Apache-2.0
#include "myoface/sim/shaping.h"

#include <numbers>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/measure/landmarks_on_skin.h"
#include "myoface/measure/volume.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/normals.h"
#include "myoface/sim/plan_file.h"
#include "myoface/sim/target.h"

#include "test_meshes.h"

namespace myoface {
namespace {

using test::small_model;

SurfacePoint at_landmark(const FaceModel& face, const std::string& name) {
    return Bvh(face.skin.mesh)
        .closest_point(face.skin.mesh, face.landmarks.at(name).position)
        .where;
}

TEST(SweptVolume, OfAGrowingSphereIsTheDifferenceOfTwo) {
    const TriangleMesh ball = test::sphere(10.0);
    const Points larger = 1.2 * ball.vertices;
    const TriangleMesh after{larger, ball.triangles};
    EXPECT_NEAR(swept_volume(ball.triangles, ball.vertices, larger),
                signed_volume(after) - signed_volume(ball), 1e-9);
    EXPECT_NEAR(swept_volume(ball.triangles, larger, ball.vertices),
                signed_volume(ball) - signed_volume(after), 1e-9);
}

TEST(Volume, IsAsManyMillilitresAsWereAskedFor) {
    for (const double ml : {1.0, -0.5}) {
        Simulator simulator(small_model());
        const FaceModel& face = simulator.face();
        const VolumeReport report = add_volume(simulator, {at_landmark(face, "pg"), ml});
        EXPECT_NEAR(report.ml, ml, 0.02 * std::abs(ml));
        EXPECT_DOUBLE_EQ(report.kept_share, 1.0);
        const double chin = report.by_region.at(Region::Chin);
        EXPECT_GT(chin / ml, 0.5);
        EXPECT_EQ(turned_over(face, face.skin.mesh.vertices, simulator.skin_rest()), 0);
        // It is a shape, not a force: nothing pushes it back.
        const Points kept = simulator.skin_rest();
        simulator.settle();
        EXPECT_LT(
            (simulator.state().positions.leftCols(face.node_count()) - kept).cwiseAbs().maxCoeff(),
            0.02);
    }
}

TEST(Volume, TwiceOnBothSides) {
    Simulator simulator(small_model());
    VolumeRequest request{at_landmark(simulator.face(), "zy_l"), 0.4};
    request.mirrored = true;
    EXPECT_NEAR(add_volume(simulator, request).ml, 0.8, 0.016);
}

TEST(Volume, ThatTheTissueDoesNotTakeIsRefusedAndChangesNothing) {
    Simulator simulator(small_model());
    const Points before = simulator.skin_rest();
    VolumeRequest request{at_landmark(simulator.face(), "prn"), 20.0, 4.0};
    EXPECT_THROW(add_volume(simulator, request), InvalidInput);
    EXPECT_EQ(simulator.skin_rest(), before);
    request.ml = std::nan("");
    EXPECT_THROW(add_volume(simulator, request), InvalidInput);
    EXPECT_LT((simulator.state().positions - simulator.system().model.rest).cwiseAbs().maxCoeff(),
              1e-4);
}

TEST(Target, IsMetWithinHalfADegreeOrATenthOfAMillimetre) {
    struct Wish {
        const char* measure;
        double by;
    };
    for (const Wish& wish : {Wish{"tip projection", -2.0}, Wish{"chin projection", 4.0},
                             Wish{"upper lip projection", 1.0}, Wish{"nasal width", -3.0},
                             Wish{"nasolabial angle", 5.0}, Wish{"facial convexity", -3.0},
                             Wish{"nasal protrusion", 1.0}}) {
        Simulator simulator(small_model());
        const Measure measure = target_measure(wish.measure);
        const LandmarksOnSkin places(small_model());
        const double before = *places.measure(measure, simulator.state().positions);
        TargetRequest request{measure, wish.by, true};
        const TargetReport report = meet_target(simulator, request);
        const double now = *places.measure(measure, simulator.state().positions);
        EXPECT_NEAR(now, before + wish.by, measure.in_degrees() ? 0.5 : 0.1) << wish.measure;
        EXPECT_NEAR(report.reached, now, 1e-9);
        EXPECT_LE(report.settles, 4) << wish.measure;
    }
}

TEST(Target, OutOfReachIsRefusedWithTheLimitAndChangesNothing) {
    Simulator simulator(small_model());
    const Points before = simulator.skin_rest();
    for (const double by : {40.0, -14.0}) {
        try {
            meet_target(simulator, {target_measure("chin projection"), by, true});
            ADD_FAILURE() << "met by " << by;
        } catch (const InvalidInput& refusal) {
            EXPECT_NE(std::string(refusal.what()).find("chin projection"), std::string::npos);
        }
        EXPECT_EQ(simulator.skin_rest(), before);
        EXPECT_FALSE(simulator.dragging());
    }
    EXPECT_THROW(target_measure("beauty"), InvalidInput);
}

TEST(Protection, KeepsSkinInItsPlace) {
    const auto face = small_model();
    const SurfacePoint tip = at_landmark(*face, "prn");
    const auto pulled = [&](const Eigen::VectorXd& protection) {
        Simulator simulator(face);
        simulator.set_protection(protection);
        DragRequest request;
        request.where = at_landmark(*face, "ls");
        const Vec3 start = position(face->skin.mesh, request.where);
        const Vec3 view = -Vec3::UnitX();
        simulator.begin_drag(request, {start - 300.0 * view, view});
        simulator.move_drag({start + Vec3(0.0, 2.0, 3.0) - 300.0 * view, view});
        simulator.settle();
        simulator.end_drag(true);
        Points moved = simulator.skin_rest() - face->skin.mesh.vertices;
        return moved;
    };
    const Eigen::VectorXd nose = brushed(*face, tip, 16.0);
    const Points freely = pulled({});
    const Points held = pulled(nose);
    const TriangleMesh& mesh = face->skin.mesh;
    EXPECT_GT(position({freely, mesh.triangles}, tip).norm(), 0.1);
    EXPECT_LT(position({held, mesh.triangles}, tip).norm(), 0.02);
    EXPECT_GT(position({held, mesh.triangles}, at_landmark(*face, "ls")).norm(), 2.0);
    Simulator simulator(face);
    simulator.set_protection(nose);
    DragRequest request;
    request.where = tip;
    EXPECT_THROW(simulator.begin_drag(request, {Vec3::Zero(), -Vec3::UnitX()}), InvalidInput);
}

TEST(ShapingText, ComesBackFromItself) {
    const Plan plan{parse_volume("at=zy_l; ml=0.75; radius=15; mirror=1"),
                    parse_target("nasolabial angle=100"), parse_target("tip projection by -2"),
                    parse_protect("at=prn; radius=8"), parse_drag("at=pg; move=1,2; path=normal")};
    EXPECT_EQ(plan_to_json(plan_from_json(plan_to_json(plan), "p")), plan_to_json(plan));
    for (const char* bad : {"ml=x", "size=1", "mirror=2"}) {
        EXPECT_THROW(parse_volume(bad), InvalidInput) << bad;
    }
    for (const char* bad : {"tip projection", "tip projection=a", "beauty=3", "=3"}) {
        EXPECT_THROW(parse_target(bad), InvalidInput) << bad;
    }
}

}  // namespace
}  // namespace myoface
