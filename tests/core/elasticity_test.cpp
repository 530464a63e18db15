// SPDX-License-Identifier: Apache-2.0
// The skin's springs against the linear elasticity that they stand for.
#include <cmath>

#include <gtest/gtest.h>

#include "myoface/physics/build_mass_spring.h"
#include "myoface/physics/equilibrium.h"
#include "myoface/physics/forces.h"

namespace myoface {
namespace {

/// A flat patch of skin of equilateral triangles over nothing that holds it sideways.
struct Patch {
    Patch(int across, double spacing) : columns(across), rows(across), edge(spacing) {
        const double height = edge * std::sqrt(0.75);
        auto& mesh = face.skin.mesh;
        mesh.vertices.resize(3, columns * rows);
        for (int r = 0; r < rows; ++r) {
            for (int c = 0; c < columns; ++c) {
                mesh.vertices.col(node(c, r)) << edge * (c + 0.5 * (r % 2)), height * r, 0.0;
            }
        }
        std::vector<Eigen::Vector3i> triangles;
        for (int r = 0; r + 1 < rows; ++r) {
            for (int c = 0; c + 1 < columns; ++c) {
                const int shift = r % 2;
                triangles.emplace_back(node(c, r), node(c + 1, r), node(c + shift, r + 1));
                triangles.emplace_back(node(c + 1 - shift, r), node(c + 1, r + 1), node(c, r + 1));
            }
        }
        mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
        }
        const auto n = static_cast<std::size_t>(columns * rows);
        face.adjacency = std::make_shared<Adjacency>(mesh);
        face.area = Eigen::VectorXd::Constant(columns * rows, edge * height);
        face.generic = mesh.vertices;
        TissueProperties loose;
        loose.bone_tie = 0.0;
        loose.depth = 10.0;
        loose.strain_limit = 1e9;
        face.tissue.assign(n, loose);
        face.sliding.resize(n);
        face.label.resize(n);
        face.lip_side.assign(n, 0);
        system = build_mass_spring(face, mesh.vertices, constants);
    }
    int node(int column, int row) const { return row * columns + column; }

    int columns, rows;
    double edge;
    FaceModel face;
    TissueConstants constants;
    FaceMassSpring system;
};

/// Pulls the patch at both ends by σh [mN/mm]; strain along and across in its middle.
Eigen::Vector2d stretched(const Patch& patch, double tension) {
    const double height = patch.edge * std::sqrt(0.75);
    Drive drive;
    drive.load = Points::Zero(3, patch.columns * patch.rows);
    for (int r = 0; r < patch.rows; ++r) {
        const double share = r == 0 || r + 1 == patch.rows ? 0.5 : 1.0;
        drive.load(0, patch.node(patch.columns - 1, r)) = share * tension * height;
        drive.load(0, patch.node(0, r)) = -share * tension * height;
    }
    MassSpringState state = rest_state(patch.system.model);
    EquilibriumSolver solver(patch.system.model);
    RelaxOptions options;
    options.iterations = 20000;
    EXPECT_TRUE(solver.relax(state, drive, options).converged);
    const Points& rest = patch.system.model.rest;
    const int quarter = patch.columns / 4;
    const auto strain = [&](int a, int b, int axis) {
        return (state.positions(axis, b) - state.positions(axis, a)) /
                   (rest(axis, b) - rest(axis, a)) -
               1.0;
    };
    const int middle = patch.rows / 2;
    return {strain(patch.node(quarter, middle), patch.node(3 * quarter, middle), 0),
            strain(patch.node(2 * quarter, quarter), patch.node(2 * quarter, 3 * quarter), 1)};
}

TEST(Elasticity, OfAStretchedPatchIsThatOfASheetWithPoissonsRatioOfAThird) {
    for (const double edge : {1.0, 2.0}) {
        const Patch patch(static_cast<int>(48 / edge), edge);
        constexpr double kTension = 3.0;  // 2 % of E h
        const double expected =
            kTension / (patch.constants.skin_modulus * patch.constants.skin_thickness);
        const Eigen::Vector2d strain = stretched(patch, kTension);
        EXPECT_NEAR(strain.x(), expected, 0.05 * expected);
        EXPECT_NEAR(-strain.y() / strain.x(), 1.0 / 3.0, 0.05 / 3.0);
    }
}

TEST(Elasticity, StopsHardAtTheLimitOfStretch) {
    Patch patch(16, 2.0);
    for (Stretch& stretch : patch.system.model.stretch) {
        stretch.stiffening = 0.0;
        stretch.limit = 0.1;
    }
    // Beyond the limit every further newton stretches sixteen times less.
    const double soft = stretched(patch, 10.0).x();
    const double at = stretched(patch, 20.0).x();
    const double beyond = stretched(patch, 30.0).x();
    EXPECT_NEAR(soft, 10.0 / 150.0, 0.01);
    EXPECT_LT(beyond - at, 0.25 * soft);
}

}  // namespace
}  // namespace myoface
