// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/expression.h"

#include <set>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/sim/plan_file.h"

#include "test_meshes.h"

namespace myoface {
namespace {

double rate_of(const Expression& expression, const char* muscle) {
    const int wanted = muscles_named(muscle).front();
    for (const auto& [m, rate] : expression.rates) {
        if (m == wanted) {
            return rate;
        }
    }
    return 0.0;
}

TEST(Expression, HoldsPresetsAndActionUnits) {
    for (const char* name : {"joy", "sadness", "surprise", "fear", "anger", "disgust", "contempt",
                             "gentle_smile", "full_smile", "brow_raise", "frown", "eyes_closed",
                             "eyes_tight", "snarl", "pucker", "show_teeth", "jaw_open"}) {
        EXPECT_FALSE(expression_named(name).rates.empty()) << name;
    }
    for (const int unit : {1,  2,  4,  5,  6,  7,  9,  10, 11, 12, 13, 14, 15,
                           16, 17, 18, 20, 22, 23, 24, 26, 27, 28, 43, 45}) {
        const std::string name = "AU" + std::to_string(unit);
        EXPECT_FALSE(expression_named(name).rates.empty()) << name;
    }
    std::set<std::string> names;
    for (const Expression& preset : expression_presets()) {
        EXPECT_TRUE(names.insert(preset.name).second);
        EXPECT_FALSE(preset.title.empty());
        EXPECT_FALSE(preset.title_ja.empty());
        for (const auto& [muscle, rate] : preset.rates) {
            EXPECT_GT(rate, 0.0) << preset.name;
            EXPECT_LE(rate, 1.0) << preset.name;
        }
    }
    EXPECT_THROW(expression_named("AU99"), InvalidInput);
    EXPECT_THROW(expression_named("happiness"), InvalidInput);
}

TEST(Expression, TakesOneSideOfAnActionUnit) {
    const Expression left = expression_named("AU12.L");
    EXPECT_GT(rate_of(left, "zygomaticus_major.L"), 0.8);
    EXPECT_EQ(rate_of(left, "zygomaticus_major.R"), 0.0);
    EXPECT_GT(rate_of(expression_named("contempt"), "buccinator.R"), 0.5);
    EXPECT_EQ(rate_of(expression_named("contempt"), "buccinator.L"), 0.0);
}

TEST(Expression, AddsUpAndIsHeldWithinLimits) {
    std::vector<double> rates(muscle_atlas().size(), 0.0);
    const auto zygomatic = static_cast<std::size_t>(muscles_named("zygomaticus_major.L").front());
    add_expression(rates, expression_named("AU12"), 0.4);
    add_expression(rates, expression_named("AU12"), 0.3);
    const double full = rate_of(expression_named("AU12"), "zygomaticus_major.L");
    EXPECT_NEAR(rates[zygomatic], 0.7 * full, 1e-12);
    add_expression(rates, expression_named("AU12"), 1.0);
    EXPECT_EQ(rates[zygomatic], 1.0);
}

TEST(Expression, IsAnEditOfAPlan) {
    const Plan plan = plan_from_json(
        R"({"plan": [{"expression": "joy", "intensity": 0.5}, {"muscle": "risorius", "rate": 0.2}]})",
        "plan");
    ASSERT_EQ(plan.size(), 2U);
    EXPECT_EQ(plan_to_json(plan_from_json(plan_to_json(plan), "again")), plan_to_json(plan));
    Simulator sim(test::small_model());
    const PlanReport report = run_plan(sim, plan);
    EXPECT_TRUE(report.last.converged);
    const auto zygomatic = static_cast<std::size_t>(muscles_named("zygomaticus_major.R").front());
    EXPECT_NEAR(sim.contractions().rate[zygomatic],
                0.5 * rate_of(expression_named("joy"), "zygomaticus_major.R"), 1e-12);
    EXPECT_GT(report.last.max_displacement_mm, 2.0);
    EXPECT_THROW(run_plan(sim, {ExpressionEdit{"joy", 1.5}}), InvalidInput);
}

TEST(Expression, OfEveryPresetComesToRest) {
    for (const Expression& preset : expression_presets()) {
        Simulator sim(test::small_model());
        const PlanReport report = run_plan(sim, {ExpressionEdit{preset.name, 1.0}});
        EXPECT_TRUE(report.last.converged) << preset.name;
        EXPECT_GT(report.last.max_displacement_mm, 2.0) << preset.name;
        EXPECT_TRUE(sim.state().positions.allFinite()) << preset.name;
    }
}

}  // namespace
}  // namespace myoface
