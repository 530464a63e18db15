// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/drag/counter_bulge.h"
#include "myoface/drag/fibre_way.h"
#include "myoface/measure/volume.h"
#include "myoface/mesh/bvh.h"
#include "myoface/sim/plan.h"
#include "myoface/sim/simulator.h"

#include "test_meshes.h"

namespace myoface {
namespace {

using test::small_model;

/// A flat face of n × n vertices, 40 mm wide, over one muscle with the given path.
FaceModel flat_face(int n, const Points& path, MuscleKind kind) {
    FaceModel face;
    face.skin.mesh = test::grid(n, 40.0 / (n - 1));
    face.skin.mesh.vertices.topRows(2).array() -= 20.0;
    face.adjacency = std::make_shared<Adjacency>(face.skin.mesh);
    const auto count = static_cast<std::size_t>(face.node_count());
    face.area = Eigen::VectorXd::Constant(face.node_count(), 1600.0 / static_cast<double>(count));
    face.tissue.resize(count);
    for (TissueProperties& tissue : face.tissue) {
        tissue.depth = 8.0;
    }
    face.sliding.resize(count);
    Muscle muscle;
    muscle.traits.kind = kind;
    muscle.path = path;
    face.muscles.push_back(muscle);
    face.muscles_under.assign(count, {{0, 1.0}});
    return face;
}

Points line_along_x() {
    Points path(3, 5);
    for (int i = 0; i < 5; ++i) {
        path.col(i) = Vec3(-30.0 + 15.0 * i, 0.0, -4.0);
    }
    return path;
}

Points ring(double radius) {
    Points path(3, 48);
    for (int i = 0; i < 48; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / 48;
        path.col(i) = Vec3(radius * std::cos(turn), radius * std::sin(turn), 0.0);
    }
    return path;
}

Grip grip_near(const FaceModel& face, const Vec3& place) {
    return grip_at(face, Bvh(face.skin.mesh).closest_point(face.skin.mesh, place).where);
}

TEST(LinePosition, CountsFromTheFirstPointAndGoesOnBeyondTheEnds) {
    const Points line = line_along_x();
    EXPECT_NEAR(along_line(line, false, Vec3(0.0, 5.0, 0.0)), 30.0, 1e-12);
    EXPECT_NEAR(along_line(line, false, Vec3(40.0, 1.0, 2.0)), 70.0, 1e-12);
    EXPECT_NEAR(along_line(line, false, Vec3(-35.0, 0.0, 0.0)), -5.0, 1e-12);
    EXPECT_NEAR(line_length(ring(10.0), true), 2.0 * std::numbers::pi * 10.0, 0.06);
}

TEST(StressKernel, ReachesTwiceAsFarAlongALinearMuscleAsAcross) {
    const FaceModel face = flat_face(81, line_along_x(), MuscleKind::Linear);
    const Grip grip = grip_near(face, Vec3::Zero());
    const StressKernel kernel = stress_kernel(face, face.skin.mesh.vertices, grip, 10.0, 1.8, 2.0);
    double along = 0.0;
    double across = 0.0;
    for (const int node : kernel.nodes) {
        const Vec3 p = face.skin.mesh.vertices.col(node);
        along = std::max(along, std::abs(p.x()));
        across = std::max(across, std::abs(p.y()));
    }
    EXPECT_NEAR(along, 20.0, 0.7);
    EXPECT_NEAR(across, 10.0, 0.7);
}

TEST(StressKernel, SpreadsAroundASphincter) {
    const FaceModel face = flat_face(81, ring(12.0), MuscleKind::Sphincter);
    const Vec3 start(12.0, 0.0, 0.0);
    const FibreWay way(face, grip_near(face, start), 2.0);
    // A quarter around counts less than the same way straight outwards.
    const auto node_at = [&](const Vec3& place) { return grip_near(face, place).nodes.front(); };
    EXPECT_LT(way.factor(node_at({9.0, 8.0, 0.0})), 0.8);
    EXPECT_GT(way.factor(node_at({19.0, 0.0, 0.0})), 0.95);
    EXPECT_GT(way.factor(node_at({5.0, 0.0, 0.0})), 0.95);
}

TEST(StressKernel, WithoutMusclesIsRound) {
    FaceModel face = flat_face(41, line_along_x(), MuscleKind::Linear);
    face.muscles_under.assign(face.muscles_under.size(), {});
    const FibreWay way(face, grip_near(face, Vec3::Zero()), 2.0);
    for (int v = 0; v < face.node_count(); v += 37) {
        EXPECT_DOUBLE_EQ(way.factor(v), 1.0);
    }
}

/// Ties and springs as a sheet of skin over 8 mm of fat has them.
MassSpringModel sheet(const FaceModel& face) {
    MassSpringModel model;
    model.rest = face.skin.mesh.vertices;
    model.skin_nodes = face.node_count();
    model.mass = Eigen::VectorXd::Ones(face.node_count());
    model.fixed.assign(static_cast<std::size_t>(face.node_count()), 0);
    model.label.resize(static_cast<std::size_t>(face.node_count()));
    model.stretch.resize(static_cast<std::size_t>(face.node_count()));
    for (int i = 0; i < face.node_count(); ++i) {
        Tie tie;
        tie.thickness = 120.0 * face.area[i] / 8.0;
        tie.tether = 3.4 * face.area[i] / 8.0;
        model.ties.push_back(tie);
    }
    index_rows(model);
    return model;
}

TEST(CounterBulge, ComesOutAheadOfThePullSinksBehindAndBalancesItself) {
    const FaceModel face = flat_face(61, line_along_x(), MuscleKind::Linear);
    const MassSpringModel model = sheet(face);
    const StressKernel kernel =
        stress_kernel(face, model.rest, grip_near(face, Vec3::Zero()), 12.0, 1.0);
    const Points bulge = counter_bulge(face, model, model.rest, kernel);
    const Vec3 pull(1000.0, 0.0, 0.0);
    double ahead = 0.0;
    double behind = 0.0;
    double sum = 0.0;
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        const double push = bulge.col(static_cast<Eigen::Index>(k)).dot(pull);
        const double x = model.rest(0, kernel.nodes[k]);
        (x > 0.0 ? ahead : behind) += push;
        sum += push;
    }
    EXPECT_GT(ahead, 100.0);
    EXPECT_LT(behind, -100.0);
    EXPECT_NEAR(sum, 0.0, 1e-3 * ahead);
}

TEST(CounterBulge, IsWhatKeepsTheVolumeWhateverTheTriangles) {
    // With ties alone the give is known: u = φ F Σwφ / (k_t/A Σ A φ²); ahead of the pull the push
    // is M_d c F ∫ −∂φ/∂x over the half disc = M_d c F ∫ φ(0, y) dy = M_d c F R 16/15.
    std::vector<double> ahead;
    for (const int n : {41, 81}) {
        const FaceModel face = flat_face(n, line_along_x(), MuscleKind::Linear);
        const MassSpringModel model = sheet(face);
        const StressKernel kernel =
            stress_kernel(face, model.rest, grip_near(face, Vec3::Zero()), 12.0, 1.0);
        const Points bulge = counter_bulge(face, model, model.rest, kernel);
        double push = 0.0;
        for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
            const double x = model.rest(0, kernel.nodes[k]);
            push += x > 1e-9 ? bulge(0, static_cast<Eigen::Index>(k)) * 1000.0 : 0.0;
        }
        ahead.push_back(push);
    }
    const double disc = std::numbers::pi * 144.0;
    // ∫φ = πR²/3, ∫φ² = πR²/5 for φ = (1 − r²/R²)², and w = φA/∫φ.
    const double give = (disc / 5.0) / (disc / 3.0) / (3.4 / 8.0 * disc / 5.0);
    const double expected = 120.0 * give * 1000.0 * 12.0 * 16.0 / 15.0;
    EXPECT_NEAR(ahead[0], expected, 0.06 * expected);
    EXPECT_NEAR(ahead[1], expected, 0.03 * expected);
}

struct Answer {
    double reach = 0.0, volume_ml = 0.0;
};
Answer pulled(Simulator& sim, const Vec3& place, const Vec3& direction, double force_mN) {
    const FaceModel& face = sim.face();
    DragRequest request;
    request.where = Bvh(face.skin.mesh).closest_point(face.skin.mesh, place).where;
    request.mode = DragMode::ConstraintPriority;
    request.force_mN = force_mN;
    const Vec3 start = position(face.skin.mesh, request.where);
    const Vec3 view =
        -face.sliding[static_cast<std::size_t>(face.skin.mesh.triangles(0, request.where.triangle))]
             .normal;
    const Vec3 pull = (direction - direction.dot(view) * view).normalized();  // along the skin
    sim.begin_drag(request, {start - 300.0 * view, view});
    sim.move_drag({start + 20.0 * pull - 300.0 * view, view});
    const StepReport report = sim.settle();
    Answer answer;
    answer.reach = (report.drag->reached - start).dot(pull);
    EXPECT_NEAR(report.drag->force_mN, force_mN, 1e-6 * force_mN);
    answer.volume_ml = swept_volume(face.skin.mesh.triangles, face.skin.mesh.vertices,
                                    sim.state().positions.leftCols(face.node_count())) /
                       1000.0;
    sim.end_drag(false);
    sim.settle();
    return answer;
}

TEST(ConstraintPriority, ReachesFurtherFromForeheadToCheekUnderEqualStressAndForMoreOfIt) {
    // The lower lip, which comes last, is as fine as the triangles of this face: looked at in
    // tests/bench/gesture_study.cpp.
    Simulator sim(small_model());
    const FaceModel& face = sim.face();
    double last_region = 0.0;
    for (const Vec3& generic :
         {Vec3(14.0, 60.0, 100.0), Vec3(60.0, 34.0, 48.0), Vec3(38.0, -25.0, 80.0)}) {
        const Vec3 place = from_generic(face, generic);
        const Answer little = pulled(sim, place, -Vec3::UnitY(), 1000.0);
        const Answer more = pulled(sim, place, -Vec3::UnitY(), 3000.0);
        EXPECT_GT(little.reach, last_region) << generic.transpose();
        EXPECT_GT(more.reach, little.reach) << generic.transpose();
        EXPECT_LT(std::abs(more.volume_ml), 4.0);  // of 460 mL of soft tissue
        last_region = little.reach;
    }
}

TEST(DragText, KnowsTheForceOfAJudgingHand) {
    const DragEdit drag = parse_drag("at=li; view=front; move=0,-1; mode=constraint; force=2.5");
    EXPECT_DOUBLE_EQ(drag.force_N, 2.5);
    EXPECT_DOUBLE_EQ(parse_drag(drag_to_text(drag)).force_N, 2.5);
    EXPECT_THROW(parse_drag("at=li; mode=mouse; force=2"), InvalidInput);
    EXPECT_THROW(parse_drag("at=li; mode=constraint; force=7"), InvalidInput);
    EXPECT_THROW(parse_drag("at=li; mode=constraint; force=nan"), InvalidInput);
}

}  // namespace
}  // namespace myoface
