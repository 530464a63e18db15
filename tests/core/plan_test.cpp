// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/sim/plan_file.h"

#include "test_meshes.h"

namespace myoface {
namespace {

TEST(DragText, IsReadPartByPart) {
    const DragEdit drag =
        parse_drag("at=vertex 12; view=left; move=-3.5,+4; mode=constraint; radius=9; mirror=1");
    EXPECT_EQ(drag.at, "vertex 12");
    EXPECT_EQ(drag.view, "left");
    EXPECT_DOUBLE_EQ(drag.move.x(), -3.5);
    EXPECT_DOUBLE_EQ(drag.move.y(), 4.0);
    EXPECT_EQ(drag.mode, DragMode::ConstraintPriority);
    EXPECT_DOUBLE_EQ(drag.radius, 9.0);
    EXPECT_TRUE(drag.mirrored);
    EXPECT_EQ(drag_to_text(parse_drag(drag_to_text(drag))), drag_to_text(drag));
}

TEST(DragText, SaysWhatIsWrong) {
    for (const char* bad : {"move=1", "move=a,b", "mode=soft", "radius=-3", "mirror=yes",
                            "view=inside", "view=0,0,0", "colour=red", "move=1e9,0"}) {
        EXPECT_THROW(parse_drag(bad), InvalidInput) << bad;
    }
}

TEST(Setting, IsNameAndNumber) {
    EXPECT_EQ(parse_setting("risorius.L=0.5"), (std::pair<std::string, double>("risorius.L", 0.5)));
    EXPECT_THROW(parse_setting("risorius"), InvalidInput);
    EXPECT_THROW(parse_setting("=1"), InvalidInput);
    EXPECT_THROW(parse_setting("risorius=nan"), InvalidInput);
}

TEST(Plan, ComesBackFromItsOwnText) {
    const Plan plan{StrengthEdit{"risorius.L", 0.25}, ContractionEdit{"risorius", 0.5},
                    parse_drag("at=pg; move=0,-2")};
    EXPECT_EQ(plan_to_json(plan_from_json(plan_to_json(plan), "p")), plan_to_json(plan));
    EXPECT_THROW(plan_from_json("[]", "p"), IoError);
    EXPECT_THROW(plan_from_json(R"({"plan":[{"muscle":"risorius"}]})", "p"), IoError);
}

TEST(Plan, ReplaysToTheSameBits) {
    const Plan plan{ContractionEdit{"zygomaticus_major.L", 0.4},
                    parse_drag("at=pg; view=front; move=1,-2"),
                    parse_drag("at=prn; view=left; move=-1,1; mode=constraint")};
    Simulator first(test::small_model());
    Simulator second(test::small_model());
    const PlanReport report = run_plan(first, plan);
    run_plan(second, plan);
    EXPECT_EQ(first.state_hash(), second.state_hash());
    ASSERT_EQ(report.drags.size(), 2U);
    EXPECT_EQ(report.drags[0].mode, DragMode::MousePriority);
    EXPECT_EQ(report.drags[1].mode, DragMode::ConstraintPriority);
}

TEST(Plan, RefusesPlacesThatAreNotOnTheFace) {
    Simulator sim(test::small_model());
    EXPECT_THROW(run_plan(sim, {parse_drag("at=nose")}), InvalidInput);
    EXPECT_THROW(run_plan(sim, {parse_drag("at=vertex 99999999")}), InvalidInput);
    EXPECT_THROW(run_plan(sim, {parse_drag("at=900,0,0")}), InvalidInput);
}

}  // namespace
}  // namespace myoface
