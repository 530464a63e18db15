// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/contraction.h"

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/sim/simulator.h"

#include "test_meshes.h"

namespace myoface {
namespace {

using test::muscle;
using test::small_model;

/// Displacement of the skin nearest to a landmark.
Vec3 moved_at(const Simulator& sim, const std::string& landmark) {
    const FaceModel& face = sim.face();
    const Vec3 place = face.landmarks.at(landmark).position;
    Eigen::Index nearest = 0;
    (face.skin.mesh.vertices.colwise() - place).colwise().squaredNorm().minCoeff(&nearest);
    return sim.state().positions.col(nearest) - face.skin.mesh.vertices.col(nearest);
}

TEST(Contraction, OfZygomaticusRaisesTheMouthCornersUpBackAndOutwards) {
    Simulator sim(small_model());
    sim.set_contraction(muscle(sim.face(), "zygomaticus_major.L"), 1.0);
    sim.set_contraction(muscle(sim.face(), "zygomaticus_major.R"), 1.0);
    ASSERT_TRUE(sim.settle().converged);
    const Vec3 left = moved_at(sim, "ch_l");
    const Vec3 right = moved_at(sim, "ch_r");
    EXPECT_GT(left.norm(), 8.0);
    EXPECT_LT(left.norm(), 15.0);
    EXPECT_GT(left.x(), 2.0);
    EXPECT_LT(right.x(), -2.0);
    EXPECT_GT(left.y(), 2.0);
    EXPECT_LT(left.z(), -2.0);
    EXPECT_NEAR(left.y(), right.y(), 0.2);
    EXPECT_LT(moved_at(sim, "g").norm(), 0.5);
}

TEST(Contraction, OfOneSideStaysThere) {
    Simulator sim(small_model());
    sim.set_contraction(muscle(sim.face(), "zygomaticus_major.L"), 1.0);
    sim.settle();
    EXPECT_GT(moved_at(sim, "ch_l").norm(), 8.0);
    EXPECT_LT(moved_at(sim, "ch_r").norm(), 2.0);
}

TEST(Contraction, ReleasedReturnsToRest) {
    Simulator sim(small_model());
    const int m = muscle(sim.face(), "frontalis_medial.R");
    sim.set_contraction(m, 1.0);
    sim.settle();
    EXPECT_GT((sim.state().positions - sim.system().model.rest).cwiseAbs().maxCoeff(), 3.0);
    sim.set_contraction(m, 0.0);
    sim.settle();
    const Points left = sim.state().positions - sim.system().model.rest;
    EXPECT_LT(left.leftCols(sim.face().node_count()).cwiseAbs().maxCoeff(), 2e-3);
}

TEST(Contraction, DoesNotDependOnTheOrderOfSetting) {
    Simulator a(small_model());
    Simulator b(small_model());
    const int first = muscle(a.face(), "zygomaticus_major.L");
    const int second = muscle(a.face(), "orbicularis_oris_upper");
    a.set_contraction(first, 0.8);
    a.set_contraction(second, 0.5);
    b.set_contraction(second, 0.5);
    b.set_contraction(first, 0.2);
    b.set_contraction(first, 0.8);
    a.settle();
    b.settle();
    EXPECT_EQ(a.state_hash(), b.state_hash());
}

TEST(Contraction, OfAWeakenedMuscleIsWeaker) {
    Simulator whole(small_model());
    Simulator half(small_model());
    Simulator none(small_model());
    const int m = muscle(whole.face(), "depressor_anguli_oris.R");
    for (Simulator* sim : {&whole, &half, &none}) {
        sim->set_contraction(m, 1.0);
    }
    half.set_strength(m, 0.5);
    none.set_strength(m, 0.0);
    whole.settle();
    half.settle();
    EXPECT_EQ(none.settle().max_displacement_mm, 0.0);
    EXPECT_LT(moved_at(half, "ch_r").norm(), 0.75 * moved_at(whole, "ch_r").norm());
    EXPECT_GT(moved_at(half, "ch_r").norm(), 0.25 * moved_at(whole, "ch_r").norm());
}

TEST(Contraction, TellsUpperAndLowerLipApart) {
    Simulator sim(small_model());
    sim.set_contraction(muscle(sim.face(), "levator_labii_superioris.L"), 1.0);
    sim.set_contraction(muscle(sim.face(), "levator_labii_superioris.R"), 1.0);
    sim.settle();
    EXPECT_GT(moved_at(sim, "ls").y(), 2.0);
    EXPECT_LT(moved_at(sim, "li").norm(), 0.4 * moved_at(sim, "ls").norm());
}

TEST(Contraction, LetsTheLipsNotCross) {
    Simulator sim(small_model());
    ASSERT_FALSE(sim.face().lip_contacts.empty());
    sim.set_contraction(muscle(sim.face(), "orbicularis_oris_upper"), 1.0);
    sim.set_contraction(muscle(sim.face(), "orbicularis_oris_lower"), 1.0);
    sim.settle();
    const Vec3 up = sim.face().axes.col(1);
    for (const auto& [upper, lower] : sim.face().lip_contacts) {
        const double before =
            up.dot(sim.system().model.rest.col(upper) - sim.system().model.rest.col(lower));
        const double gap =
            up.dot(sim.state().positions.col(upper) - sim.state().positions.col(lower));
        EXPECT_GT(gap, std::min(before, 0.0) - 0.6);
    }
}

TEST(Contraction, OutOfRangeIsRefused) {
    Simulator sim(small_model());
    EXPECT_THROW(sim.set_contraction(0, 1.01), InvalidInput);
    EXPECT_THROW(sim.set_contraction(0, -0.6), InvalidInput);
    EXPECT_THROW(sim.set_contraction(0, std::nan("")), InvalidInput);
    EXPECT_THROW(sim.set_strength(0, 1.5), InvalidInput);
}

TEST(Contraction, OfEveryMuscleIsFiniteAndTurnsNothingOver) {
    for (std::size_t m = 0; m < small_model()->muscles.size(); ++m) {
        if (small_model()->muscles[m].traits.side == Side::Right) {
            continue;
        }
        Simulator sim(small_model());
        sim.set_contraction(static_cast<int>(m), 1.0);
        const StepReport report = sim.settle();
        const std::string name = sim.face().muscles[m].traits.name;
        EXPECT_TRUE(report.converged) << name;
        ASSERT_TRUE(sim.state().positions.allFinite()) << name;
        EXPECT_GT(report.max_displacement_mm, 0.5) << name;
        const bool jaw = sim.face().muscles[m].traits.action == MuscleAction::OpenJaw;
        EXPECT_LT(report.max_displacement_mm, jaw ? 55.0 : 20.0) << name;
        const TriangleMesh& rest = sim.face().skin.mesh;
        const TriangleMesh now{sim.state().positions.leftCols(rest.vertex_count()), rest.triangles};
        int turned = 0;
        for (int t = 0; t < rest.triangle_count(); ++t) {
            const bool inner =
                sim.face().tissue[static_cast<std::size_t>(rest.triangles(0, t))].tissue !=
                Tissue::Skin;
            turned += !inner && double_area_vector(rest, t).dot(double_area_vector(now, t)) < 0.0;
        }
        // With the jaw wide open the skin under the chin folds, in one of several ways.
        EXPECT_LE(turned, jaw ? 24 : 2) << name;
    }
}

TEST(ContractionDrive, ShortensTheChainPartByPart) {
    const auto face = small_model();
    const FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    Contractions c = resting(*face);
    const int m = muscle(*face, "risorius.L");
    c.rate[static_cast<std::size_t>(m)] = 0.5;
    const auto responses = muscle_responses(*face, system.model, ResponseForm::Smooth);
    const Drive drive = contraction_drive(system, responses, c);
    const MuscleChain& chain = system.chains[static_cast<std::size_t>(m)];
    for (std::size_t s = 0; s < drive.length_factor.size(); ++s) {
        const bool own = static_cast<int>(s) >= chain.first_spring &&
                         static_cast<int>(s) < chain.first_spring + chain.spring_count;
        EXPECT_DOUBLE_EQ(drive.length_factor[s], own ? 1.0 - 0.5 * chain.shortening : 1.0);
    }
}

}  // namespace
}  // namespace myoface
