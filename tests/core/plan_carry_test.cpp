// SPDX-License-Identifier: Apache-2.0
// Recorded plans on the same face, on the same scan fitted otherwise, and on other faces.
#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"
#include "myoface/face/generic_face.h"
#include "myoface/mesh/bvh.h"
#include "myoface/sim/plan_file.h"

#include "test_meshes.h"

namespace myoface {
namespace {

SurfacePoint at_landmark(const FaceModel& face, const std::string& name, const Vec3& off) {
    const Vec3 at = face.landmarks.at(name).position + face.axes * off;
    return Bvh(face.skin.mesh).closest_point(face.skin.mesh, at).where;
}

/// What a consultation might leave: nose tip up, more chin, softer lips, one-sided smile.
RecordedPlan consultation(const FaceModel& face) {
    DragEdit tip;
    tip.view = "0.9,-0.1,-0.4";
    tip.move = {1.0, 2.5};
    tip.place = plan_place(face, at_landmark(face, "prn", {2.0, 1.0, 0.0}));
    VolumeEdit chin{"", 0.6, 14.0, false, std::nullopt};
    chin.place = plan_place(face, at_landmark(face, "pg", {0.0, 0.0, 0.0}));
    ProtectEdit lip;
    lip.radius = 8.0;
    lip.place = plan_place(face, at_landmark(face, "ls", {0.0, 1.0, 0.0}));
    DragEdit cheek;
    cheek.view = "0,0,-1";
    cheek.move = {0.5, 1.5};
    cheek.mirrored = true;
    cheek.place = plan_place(face, at_landmark(face, "zy_l", {-12.0, -14.0, 0.0}));
    return {plan_origin(face),
            {tip, chin, lip, cheek, ContractionEdit{"zygomaticus_major.L", 0.3}}};
}

std::shared_ptr<const FaceModel> head(int vertices, std::optional<std::uint32_t> seed = {}) {
    GenericFaceOptions options;
    options.vertices = vertices;
    options.seed = seed;
    GenericFace made = make_generic_face(options);
    return fit_face(std::make_shared<const Scan>(std::move(made.scan)), made.landmarks);
}

TEST(RecordedPlan, ComesBackFromItsText) {
    const RecordedPlan plan = consultation(*test::small_model());
    const std::string text = recorded_plan_to_json(plan);
    const RecordedPlan back = recorded_plan_from_json(text, "p");
    EXPECT_EQ(recorded_plan_to_json(back), text);
    ASSERT_TRUE(back.origin);
    EXPECT_EQ(back.origin->skin, plan.origin->skin);
    const PlanPlace& place = *std::get<DragEdit>(back.edits[0]).place;
    EXPECT_EQ(place.where.weights, std::get<DragEdit>(plan.edits[0]).place->where.weights);
    EXPECT_EQ(place.near, "prn");
}

TEST(RecordedPlan, GivesTheSameBitsOnTheSameFaceWithAnyThreads) {
    const std::string text = recorded_plan_to_json(consultation(*test::small_model()));
    const int threads = thread_count();
    std::uint64_t hash[3];
    for (int k = 0; k < 3; ++k) {
        set_thread_count(k == 1 ? 2 : 1);
        Simulator simulator(test::small_model());
        const RecordedPlan plan =
            k == 2 ? consultation(*test::small_model()) : recorded_plan_from_json(text, "p");
        const Replay done = replay(simulator, plan);
        EXPECT_EQ(done.face, CarriedPlan::Face::Same);
        EXPECT_EQ(done.done, 5) << replay_in_words(done);
        hash[k] = simulator.state_hash();
    }
    set_thread_count(threads);
    EXPECT_EQ(hash[0], hash[1]);
    EXPECT_EQ(hash[0], hash[2]);  // through the text and back nothing is lost
}

TEST(RecordedPlan, IsFoundAgainOnTheSameScanFittedOtherwise) {
    const RecordedPlan plan = consultation(*test::small_model());
    Landmarks moved = test::small_face().landmarks;
    moved.at("pg").position.x() += 0.5;
    const auto again = fit_face(test::small_model()->scan, moved);
    const CarriedPlan here = carried(plan, *again);
    EXPECT_EQ(here.face, CarriedPlan::Face::SameScan);
    EXPECT_TRUE(here.refused.empty());
    const PlanPlace& tip = *std::get<DragEdit>(here.edits[0]).place;
    EXPECT_LT((position(again->skin.mesh, tip.where) - std::get<DragEdit>(plan.edits[0]).place->xyz)
                  .norm(),
              1e-6);
}

/// Displacement of the landmarks' places by a plan.
std::map<std::string, Vec3> moves(const FaceModel& face, const Simulator& simulator) {
    std::map<std::string, Vec3> result;
    const Bvh bvh(face.skin.mesh);
    const TriangleMesh now{simulator.state().positions.leftCols(face.node_count()),
                           face.skin.mesh.triangles};
    for (const auto& [name, landmark] : face.landmarks) {
        const ClosestPoint hit = bvh.closest_point(face.skin.mesh, landmark.position);
        result[name] = position(now, hit.where) - hit.point;
    }
    return result;
}

TEST(RecordedPlan, GivesTheSameMillimetresOnAnotherResolution) {
    const auto coarse = head(8000);
    const auto fine = head(16000);
    const RecordedPlan plan = consultation(*coarse);
    Simulator on_coarse(coarse);
    Simulator on_fine(fine);
    replay(on_coarse, plan);
    const Replay done = replay(on_fine, plan);
    EXPECT_EQ(done.face, CarriedPlan::Face::Other);
    EXPECT_TRUE(done.refused.empty()) << replay_in_words(done);
    const auto here = moves(*coarse, on_coarse);
    double largest = 0.0;
    for (const auto& [name, way] : moves(*fine, on_fine)) {
        EXPECT_LT((way - here.at(name)).norm(), 0.2)
            << name << " " << way.transpose() << " and " << here.at(name).transpose();
        largest = std::max(largest, way.norm());
    }
    EXPECT_GT(largest, 2.0);  // else nothing was compared
}

TEST(RecordedPlan, FindsItsPlacesOnAnotherPerson) {
    const RecordedPlan plan = consultation(*test::small_model());
    const auto other = head(4000, 7);
    const CarriedPlan here = carried(plan, *other);
    EXPECT_EQ(here.face, CarriedPlan::Face::Other);
    EXPECT_TRUE(here.refused.empty());
    EXPECT_LT(here.largest_doubt_mm, kDoubtfulPlace);
    for (const Edit& edit : here.edits) {
        if (const auto* drag = std::get_if<DragEdit>(&edit)) {
            const PlanPlace& place = *drag->place;
            const Vec3 by_landmark =
                other->landmarks.at(place.near).position + other->axes * place.off;
            EXPECT_LT((position(other->skin.mesh, place.where) - by_landmark).norm(), 6.0);
        }
    }
}

TEST(RecordedPlan, TellsWhatCannotBeCarriedOver) {
    RecordedPlan plan = consultation(*test::small_model());
    std::get<DragEdit>(plan.edits[0]).place->head += Vec3(0.0, 0.0, 60.0);
    plan.edits.emplace_back(
        shape_edit(Points::Constant(3, test::small_model()->own_vertices, 1.0)));
    plan.edits.emplace_back(TargetEdit{"nasolabial angle", 170.0, false, 0.0});
    const auto other = head(4000, 7);
    Simulator simulator(other);
    const Replay done = replay(simulator, plan);
    ASSERT_EQ(done.refused.size(), 3U);
    EXPECT_EQ(done.refused[0].edit, 1);
    EXPECT_NE(done.refused[0].why.find("beside the skin"), std::string::npos);
    EXPECT_EQ(done.refused[1].edit, 6);
    EXPECT_NE(done.refused[1].why.find("variant"), std::string::npos);
    EXPECT_EQ(done.refused[2].edit, 7);
    EXPECT_EQ(done.done, 4);
    EXPECT_EQ(done.made.size(), 4U);
    EXPECT_NE(replay_to_json(done).find("beside the skin"), std::string::npos);
    EXPECT_THROW(plan_on(*other, plan), InvalidInput);
}

TEST(RecordedPlan, PutsBackTheShapeOfAVariant) {
    const auto face = test::small_model();
    Points shape = Points::Zero(3, face->own_vertices);
    shape.col(face->skin.vertex[100]) << 0.0, 0.0, 0.5;
    Simulator simulator(face);
    replay(simulator, {plan_origin(*face), {shape_edit(shape)}});
    EXPECT_NEAR(simulator.skin_rest()(2, 100) - face->skin.mesh.vertices(2, 100), 0.5, 1e-9);
    replay(simulator, {plan_origin(*face), {ShapeEdit{}}});
    EXPECT_EQ(simulator.skin_rest(), face->skin.mesh.vertices);
}

}  // namespace
}  // namespace myoface
