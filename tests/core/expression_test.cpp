// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/expression.h"

#include <cstdlib>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/muscle/user_expressions.h"
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
    for (const char* name :
         {"joy",        "sadness",      "surprise",   "fear",       "anger",    "disgust",
          "contempt",   "gentle_smile", "full_smile", "brow_raise", "frown",    "eyes_closed",
          "eyes_tight", "snarl",        "pucker",     "show_teeth", "jaw_open", "vowel_a",
          "vowel_e",    "vowel_i",      "vowel_o",    "vowel_u"}) {
        EXPECT_FALSE(expression_named(name).rates.empty()) << name;
    }
    for (const int unit : {1,  2,  4,  5,  6,  7,  9,  10, 11, 12, 13, 14, 15, 16,
                           17, 18, 20, 22, 23, 24, 26, 27, 28, 29, 30, 43, 45}) {
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

TEST(Expression, HasIntensitiesByLetter) {
    EXPECT_EQ(intensity_letter(0.0), ' ');
    for (const char letter : {'A', 'B', 'C', 'D', 'E'}) {
        EXPECT_EQ(intensity_letter(intensity_of(letter)), letter);
    }
    EXPECT_EQ(intensity_letter(1.0), 'E');
}

TEST(Expression, OfTheUsersOwnIsKeptFoundAndRemoved) {
    const test::TemporaryFolder folder;
    setenv("MYOFACE_EXPRESSIONS", (folder / "own").string().c_str(), 1);
    EXPECT_TRUE(user_expressions().empty());
    std::vector<double> rates(muscle_atlas().size(), 0.0);
    rates[static_cast<std::size_t>(muscles_named("risorius.L").front())] = 0.4;
    rates[static_cast<std::size_t>(muscles_named("mentalis.R").front())] = -0.2;
    save_user_expression("half a smile", rates);
    const Expression kept = expression_named("half a smile");
    EXPECT_EQ(rate_of(kept, "risorius.L"), 0.4);
    EXPECT_EQ(rate_of(kept, "mentalis.R"), -0.2);
    EXPECT_EQ(rate_of(kept, "risorius.R"), 0.0);
    rates.assign(rates.size(), 0.1);
    save_user_expression("half a smile", rates);
    EXPECT_EQ(user_expressions().size(), 1U);
    EXPECT_EQ(rate_of(expression_named("half a smile"), "risorius.R"), 0.1);
    std::ofstream(folder / "own/odd.json") << "{\"name\": 3";
    EXPECT_EQ(user_expressions().size(), 1U);
    remove_user_expression("half a smile");
    EXPECT_THROW(expression_named("half a smile"), InvalidInput);
    EXPECT_THROW(remove_user_expression("half a smile"), InvalidInput);
    for (const char* name : {"joy", "AU12", "AU12.L", "", "a=b"}) {
        EXPECT_THROW(save_user_expression(name, rates), InvalidInput) << name;
    }
    unsetenv("MYOFACE_EXPRESSIONS");
}

TEST(Expression, MovesTheJawForwardAndSideways) {
    const auto chin = [](const char* name) {
        Simulator sim(test::small_model());
        run_plan(sim, {ExpressionEdit{name, 1.0}});
        const Vec3 place = sim.face().landmarks.at("pg").position;
        Eigen::Index nearest = 0;
        (sim.face().skin.mesh.vertices.colwise() - place)
            .colwise()
            .squaredNorm()
            .minCoeff(&nearest);
        return Vec3(sim.state().positions.col(nearest) -
                    sim.face().skin.mesh.vertices.col(nearest));
    };
    const Vec3 thrust = chin("AU29");
    EXPECT_GT(thrust.z(), 3.0);
    EXPECT_LT(std::abs(thrust.x()), 0.3);
    const Vec3 left = chin("AU30.L");
    const Vec3 right = chin("AU30.R");
    EXPECT_GT(left.x(), 4.0);
    EXPECT_LT(right.x(), -4.0);
    EXPECT_NEAR(left.x(), -right.x(), 0.3);
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
