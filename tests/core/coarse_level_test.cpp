// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/coarse_level.h"

#include <gtest/gtest.h>

#include "myoface/mesh/bvh.h"
#include "myoface/physics/forces.h"
#include "myoface/sim/simulator.h"

#include "test_meshes.h"

namespace myoface {
namespace {

/// A coarser level under the small face.
struct Levels {
    std::shared_ptr<const FaceModel> face = test::small_model();
    FaceMassSpring finer = build_mass_spring(*face, face->skin.mesh.vertices);
    CoarseLevel coarse{coarser_levels(*face), finer, face->skin.mesh.vertices, {}};
};

TEST(CoarseLevel, HasFewerNodesAndTheSameMuscles) {
    const Levels l;
    EXPECT_LT(l.coarse.model().skin_nodes, 0.7 * l.finer.model.skin_nodes);
    EXPECT_EQ(l.coarse.model().node_count() - l.coarse.model().skin_nodes,
              l.finer.model.node_count() - l.finer.model.skin_nodes);
    EXPECT_EQ(coarser_levels(*coarser_levels(*l.face)->face), nullptr);
}

TEST(CoarseLevel, GathersForcesAsItSpreadsDisplacements) {
    const Levels l;
    Points forces = Points::Random(3, l.finer.model.node_count());
    for (int i = 0; i < l.finer.model.node_count(); ++i) {
        if (l.finer.model.fixed[static_cast<std::size_t>(i)] != 0) {
            forces.col(i).setZero();
        }
    }
    const Points way = Points::Random(3, l.coarse.model().node_count());
    const double fine_work = forces.cwiseProduct(l.coarse.prolonged(way)).sum();
    const double coarse_work = l.coarse.restricted_forces(forces).cwiseProduct(way).sum();
    EXPECT_NEAR(fine_work, coarse_work, 1e-9 * (1.0 + std::abs(fine_work)));
}

TEST(CoarseLevel, CarriesAUniformShiftAsItIs) {
    const Levels l;
    Points shift(3, l.coarse.model().node_count());
    shift.colwise() = Vec3(1.0, -2.0, 0.5);
    const Points carried = l.coarse.prolonged(shift);
    for (int i = 0; i < l.finer.model.node_count(); ++i) {
        const bool fixed = l.finer.model.fixed[static_cast<std::size_t>(i)] != 0;
        EXPECT_LT((carried.col(i) - (fixed ? Vec3::Zero() : Vec3(1.0, -2.0, 0.5))).norm(), 1e-9);
    }
}

TEST(CoarseLevel, IsAtRestWhereTheFinerLevelIs) {
    const Levels l;
    MassSpringState state = rest_state(l.finer.model);
    state.positions = l.coarse.restricted_positions(state.positions);
    EXPECT_EQ(state.positions, l.coarse.model().rest);
    EXPECT_LT(total_forces(l.coarse.model(), state, {}, false).cwiseAbs().maxCoeff(), 1e-9);
}

/// The small face with the corner of its mouth dragged, by so many sweeps; 0 to the end.
struct Dragged {
    Points positions;
    StepReport report;
};
Dragged dragged(bool levels, int sweeps) {
    SimulatorOptions options;
    options.levels = levels;
    Simulator sim(test::small_model(), options);
    const TriangleMesh& skin = sim.face().skin.mesh;
    DragRequest request;
    request.where = Bvh(skin).closest_point(skin, sim.face().landmarks.at("ch_l").position).where;
    ViewRay ray{position(skin, request.where) + Vec3(0, 0, 300), -Vec3::UnitZ()};
    sim.begin_drag(request, ray);
    ray.origin += Vec3(6, 3, 0);
    sim.move_drag(ray);
    StepReport report;
    if (sweeps == 0) {
        report = sim.settle();
        EXPECT_TRUE(report.converged);
    }
    for (int done = 0; done < sweeps; done += 6) {
        report = sim.step(6);
    }
    return {sim.state().positions, report};
}

TEST(EquilibriumSolver, WithLevelsEndsWhereItEndsWithout) {
    const Points rest =
        rest_state(
            build_mass_spring(*test::small_model(), test::small_model()->skin.mesh.vertices).model)
            .positions;
    const auto [plain, report] = dragged(false, 0);
    const double way = (plain - rest).norm();
    const auto [there, levels] = dragged(true, 0);
    EXPECT_LT((there - plain).norm(), 0.005 * way);
    EXPECT_NEAR(levels.drag->force_mN, report.drag->force_mN, 0.005 * report.drag->force_mN);
    EXPECT_LT(levels.residual, 0.05);
    // And is nearly there when steps alone have hardly begun.
    EXPECT_LT((dragged(true, 90).positions - plain).norm(), 0.05 * way);
    EXPECT_GT((dragged(false, 90).positions - plain).norm(), 0.2 * way);
}

}  // namespace
}  // namespace myoface
