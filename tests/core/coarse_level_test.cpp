// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/coarse_level.h"

#include <gtest/gtest.h>

#include "myoface/mesh/bvh.h"
#include "myoface/physics/forces.h"
#include "myoface/sim/simulator.h"

#include "physics/level_transfer.h"
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

/// Packed, as the solver has them.
struct PackedLevels : Levels {
    PackedModel::Data finer_rows{finer.model};
    PackedModel::Data coarse_rows{coarse.model()};
    LevelTransfer transfer{coarse, finer_rows, coarse_rows};
};

TEST(LevelTransfer, GathersForcesAsItSpreadsDisplacements) {
    const PackedLevels l;
    LargeArray<VectorLanes> forces(static_cast<std::size_t>(l.finer_rows.slices));
    for (int r = 0; r < l.finer_rows.nodes; ++r) {
        if (l.finer.model.fixed[static_cast<std::size_t>(l.finer_rows.node_of[r])] == 0) {
            set_row(forces, r, Vec3::Random());
        }
    }
    const LargeArray<NodeRecord> from = l.coarse_rows.resting_records();
    LargeArray<NodeRecord> to = l.coarse_rows.resting_records();
    Points way = Points::Random(3, l.coarse.model().node_count());
    l.coarse_rows.put(l.coarse.model().rest + way, to);
    LargeArray<VectorLanes> spread(static_cast<std::size_t>(l.finer_rows.slices));
    l.transfer.prolong(from, to, spread);
    LargeArray<VectorLanes> gathered(static_cast<std::size_t>(l.coarse_rows.slices));
    l.transfer.restrict_forces(forces, gathered);
    double fine_work = 0.0;
    for (int r = 0; r < l.finer_rows.nodes; ++r) {
        fine_work += of_row(forces, r).dot(of_row(spread, r));
    }
    double coarse_work = 0.0;
    for (int r = 0; r < l.coarse_rows.nodes; ++r) {
        coarse_work += of_row(gathered, r).dot(way.col(l.coarse_rows.node_of[r]));
    }
    EXPECT_NEAR(fine_work, coarse_work, 1e-4 * (1.0 + std::abs(fine_work)));
}

TEST(LevelTransfer, CarriesAUniformShiftAsItIs) {
    const PackedLevels l;
    const Vec3 shift(1.0, -2.0, 0.5);
    const LargeArray<NodeRecord> from = l.coarse_rows.resting_records();
    LargeArray<NodeRecord> to = l.coarse_rows.resting_records();
    l.coarse_rows.put(l.coarse.model().rest.colwise() + shift, to);
    LargeArray<VectorLanes> carried(static_cast<std::size_t>(l.finer_rows.slices));
    l.transfer.prolong(from, to, carried);
    for (int r = 0; r < l.finer_rows.nodes; ++r) {
        const bool fixed =
            l.finer.model.fixed[static_cast<std::size_t>(l.finer_rows.node_of[r])] != 0;
        EXPECT_LT((of_row(carried, r) - (fixed ? Vec3::Zero() : shift)).norm(), 1e-5);
    }
}

TEST(LevelTransfer, FindsTheCoarseNodesWhereTheFinerOnesAre) {
    const PackedLevels l;
    LargeArray<NodeRecord> finer = l.finer_rows.resting_records();
    Points moved = l.finer.model.rest;
    moved += 0.1 * moved;
    l.finer_rows.put(moved, finer);
    LargeArray<NodeRecord> coarse = l.coarse_rows.resting_records();
    l.transfer.restrict_ways(finer, coarse);
    for (int r = 0; r < l.coarse_rows.nodes; ++r) {
        const Vec3 rest = l.coarse.model().rest.col(l.coarse_rows.node_of[r]);
        const Vec3 way(coarse[r].moved[0], coarse[r].moved[1], coarse[r].moved[2]);
        EXPECT_LT((way - 0.1 * rest).norm(), 1e-4);
    }
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
