// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/wrinkle.h"

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/muscle/expression.h"
#include "myoface/sim/plan.h"
#include "myoface/sim/snapshot.h"

#include "test_meshes.h"

namespace myoface {
namespace {

using test::small_model;

/// The same head with so many vertices that furrows are resolved.
std::shared_ptr<const FaceModel> fine_model() {
    static const auto kModel = [] {
        GenericFaceOptions options;
        options.vertices = 45000;
        const GenericFace head = make_generic_face(options);
        return fit_face(std::make_shared<const Scan>(head.scan), head.landmarks);
    }();
    return kModel;
}

std::unique_ptr<Simulator> posed(const std::shared_ptr<const FaceModel>& face, const char* name,
                                 double age) {
    auto simulator = std::make_unique<Simulator>(face);
    simulator->set_skin_age(age);
    run_plan(*simulator, {ExpressionEdit{name, 1.0}});
    return simulator;
}

double deepest(const Wrinkles& wrinkles, const std::string& group) {
    double result = 0.0;
    for (std::size_t g = 0; !wrinkles.none() && g < wrinkles.map->gauges.size(); ++g) {
        const int furrow = wrinkles.map->gauges[g].furrow;
        if (furrow_atlas()[static_cast<std::size_t>(furrow)].group == group) {
            result = std::max(result, wrinkles.depth[static_cast<Eigen::Index>(g)]);
        }
    }
    return result;
}

TEST(Wrinkles, AreNoneAtRest) {
    const Simulator simulator(small_model());
    EXPECT_TRUE(simulator.wrinkles().none());
    EXPECT_EQ(simulator.scan_vertices(), small_model()->scan->mesh.vertices);
}

TEST(Wrinkles, FormWhereTheExpressionShortensTheSkin) {
    const Wrinkles raised = posed(small_model(), "brow_raise", 60)->wrinkles();
    EXPECT_GT(deepest(raised, "forehead"), 0.5);
    EXPECT_EQ(deepest(raised, "glabella"), 0.0);
    EXPECT_EQ(deepest(raised, "nasolabial fold"), 0.0);
    const Wrinkles frown = posed(small_model(), "frown", 60)->wrinkles();
    EXPECT_GT(deepest(frown, "glabella"), 0.5);
    EXPECT_EQ(deepest(frown, "forehead"), 0.0);
    const Wrinkles tight = posed(small_model(), "eyes_tight", 60)->wrinkles();
    EXPECT_GT(deepest(tight, "crow's feet"), 0.3);
    const Wrinkles smile = posed(small_model(), "full_smile", 60)->wrinkles();
    EXPECT_GT(deepest(smile, "nasolabial fold"), 0.5);
    const Wrinkles pucker = posed(small_model(), "pucker", 60)->wrinkles();
    EXPECT_GT(deepest(pucker, "lip lines"), 0.1);
}

TEST(Wrinkles, DeepenWithAge) {
    double before = 0.0;
    for (const double age : {18.0, 35.0, 55.0, 80.0}) {
        const double depth =
            deepest(posed(small_model(), "brow_raise", age)->wrinkles(), "forehead");
        EXPECT_GT(depth, before) << age;
        EXPECT_LT(depth, 2.5) << age;
        before = depth;
    }
    Simulator simulator(small_model());
    EXPECT_THROW(simulator.set_skin_age(12.0), InvalidInput);
    EXPECT_THROW(simulator.set_skin_age(std::nan("")), InvalidInput);
}

TEST(Wrinkles, AreExactlyNothingWhereSkinIsNotShortened) {
    const auto map = map_wrinkles(*small_model());
    const Points& rest = small_model()->skin.mesh.vertices;
    const Eigen::VectorXd drive =
        Eigen::VectorXd::Ones(static_cast<Eigen::Index>(furrow_atlas().size()));
    const Points wider = 1.1 * rest;
    EXPECT_TRUE(furrow_depths(*map, shortening(*map, rest, rest), drive, 80.0).isZero(0.0));
    EXPECT_TRUE(furrow_depths(*map, shortening(*map, rest, wider), drive, 80.0).isZero(0.0));
    // Evenly smaller skin is shorter by as much everywhere.
    const Eigen::VectorXd shorter = shortening(*map, rest, 0.9 * rest);
    EXPECT_NEAR(shorter.minCoeff(), 0.1, 1e-9);
    EXPECT_NEAR(shorter.maxCoeff(), 0.1, 1e-9);
    EXPECT_TRUE(furrow_depths(*map, shorter, 0.0 * drive, 80.0).isZero(0.0));
}

TEST(Wrinkles, RunAcrossTheFibresThatDrawThem) {
    // Forehead lines lie, the fibres of the frontalis stand; glabellar lines stand, corrugators
    // lie.
    const FaceModel& face = *fine_model();
    const auto map = map_wrinkles(face);
    const auto direction = [&](const std::string& furrow) {
        for (std::size_t f = 0; f < furrow_atlas().size(); ++f) {
            if (furrow_atlas()[f].name == furrow) {
                const auto place = [&](int g) {
                    const auto& here = map->gauges[static_cast<std::size_t>(g)].here;
                    Vec3 p = Vec3::Zero();
                    for (int c = 0; c < 3; ++c) {
                        p += here.weight[c] *
                             face.skin.mesh.vertices.col(here.node[static_cast<std::size_t>(c)]);
                    }
                    return p;
                };
                return Vec3((place(map->first[f + 1] - 1) - place(map->first[f])).normalized());
            }
        }
        return Vec3(Vec3::Zero());
    };
    const auto fibre = [&](const std::string& name) {
        const Points& path = face.muscles[static_cast<std::size_t>(test::muscle(face, name))].path;
        return Vec3((path.col(path.cols() - 1) - path.col(0)).normalized());
    };
    for (const auto& [furrow, muscle] :
         {std::pair("forehead_2", "frontalis_medial.L"),
          std::pair("glabella_1.L", "corrugator_supercilii.L"),
          std::pair("nasal_root_1", "procerus"), std::pair("nasolabial.L", "zygomaticus_major.L"),
          std::pair("chin_crease", "mentalis.L")}) {
        ASSERT_GT(direction(furrow).norm(), 0.5) << furrow;
        EXPECT_LT(std::abs(direction(furrow).dot(fibre(muscle))), 0.6) << furrow;
    }
}

TEST(Wrinkles, TakeNoVolumeAndHaveTheSameDepthOnFinerSkin) {
    const auto coarse = posed(small_model(), "brow_raise", 70);
    const auto fine = posed(fine_model(), "brow_raise", 70);
    const double a = deepest(coarse->wrinkles(), "forehead");
    const double b = deepest(fine->wrinkles(), "forehead");
    EXPECT_NEAR(a, b, 0.12 * b);
    // On the skin that resolves them: as much ridge as furrow, and nearly the whole depth.
    const Wrinkles wrinkles = fine->wrinkles();
    const Eigen::VectorXd heights = wrinkle_heights(wrinkles);
    double up = 0.0;
    double down = 0.0;
    for (std::size_t k = 0; k < wrinkles.map->vertices.size(); ++k) {
        const int node = fine_model()->skin.between(0, wrinkles.map->vertices[k]);
        const double volume = fine_model()->area[node] * heights[static_cast<Eigen::Index>(k)];
        (volume > 0.0 ? up : down) += volume;
    }
    EXPECT_GT(up, 20.0);
    EXPECT_NEAR(up / -down, 1.0, 0.12);
    EXPECT_LT(heights.minCoeff(), -0.6 * b);
}

TEST(Wrinkles, GoIntoWhatIsWrittenAndLeaveTheRestAlone) {
    const auto sim = posed(fine_model(), "frown", 60);
    const SimSnapshot now = snapshot_of(*sim);
    const Points with = scan_positions(sim->face(), now.positions, now.jaw, now.wrinkles);
    const Points without = scan_positions(sim->face(), now.positions, now.jaw);
    EXPECT_EQ(with, sim->scan_vertices());
    std::vector<char> near(static_cast<std::size_t>(with.cols()), 0);
    for (const int v : now.wrinkles.map->vertices) {
        near[static_cast<std::size_t>(v)] = 1;
    }
    double most = 0.0;
    for (Eigen::Index v = 0; v < with.cols(); ++v) {
        const double off = (with.col(v) - without.col(v)).norm();
        most = std::max(most, off);
        if (near[static_cast<std::size_t>(v)] == 0) {
            ASSERT_EQ(off, 0.0);
        }
    }
    EXPECT_GT(most, 0.3);
    EXPECT_LT(most, 2.5);
}

TEST(Wrinkles, OfAWeakenedForeheadAreShallower) {
    Simulator whole(small_model());
    Simulator weak(small_model());
    run_plan(whole, {ExpressionEdit{"brow_raise", 1.0}});
    run_plan(weak, {StrengthEdit{"frontalis_medial", 0.3}, StrengthEdit{"frontalis_lateral", 0.3},
                    ExpressionEdit{"brow_raise", 1.0}});
    EXPECT_LT(deepest(weak.wrinkles(), "forehead"), 0.75 * deepest(whole.wrinkles(), "forehead"));
}

}  // namespace
}  // namespace myoface
