// SPDX-License-Identifier: Apache-2.0
// On real faces, where their folder is there; skipped elsewhere.
#include <array>
#include <functional>
#include <map>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/cases/case_file.h"
#include "myoface/mesh/bvh.h"
#include "myoface/sim/plan.h"

#include "real_faces.h"
#include "test_meshes.h"

namespace myoface {
namespace {

class RealFace : public ::testing::Test {
protected:
    void SetUp() override {
        const auto folder = test::real_faces();
        if (!folder) {
            GTEST_SKIP() << "no folder of real faces (set MYOFACE_FACES)";
        }
        folder_ = *folder;
    }
    OpenedFace open(const std::string& name) const {
        return open_face((folder_ / "faces" / (name + ".obj")).string());
    }
    static Vec3 moved_at(const Simulator& sim, const std::string& landmark) {
        const FaceModel& face = sim.face();
        const auto hit =
            Bvh(face.skin.mesh).closest_point(face.skin.mesh, face.landmarks.at(landmark).position);
        const TriangleMesh now{sim.state().positions.leftCols(face.node_count()),
                               face.skin.mesh.triangles};
        return position(now, hit.where) - hit.point;
    }
    std::filesystem::path folder_;
};

TEST_F(RealFace, SmilesWithZygomaticus) {
    const auto sim = make_simulator(open("lee_perry_smith"));
    run_plan(*sim, {ContractionEdit{"zygomaticus_major", 1.0}});
    for (const auto& [corner, outwards] : {std::pair("ch_l", 1.0), std::pair("ch_r", -1.0)}) {
        const Vec3 moved = moved_at(*sim, corner);
        EXPECT_GT(moved.norm(), 8.0);
        EXPECT_LT(moved.norm(), 15.0);
        EXPECT_GT(outwards * moved.x(), 1.0);
        EXPECT_GT(moved.y(), 1.0);
        EXPECT_LT(moved.z(), -1.0);
    }
    const FaceModel& face = sim->face();
    for (int i = 0; i < face.node_count(); ++i) {
        if (face.tissue[static_cast<std::size_t>(i)].region == Region::Forehead) {
            ASSERT_LT((sim->state().positions.col(i) - face.skin.mesh.vertices.col(i)).norm(), 0.5);
        }
    }
}

TEST_F(RealFace, KeepsTheRightCornerWhereTheLeftMuscleActs) {
    const auto sim = make_simulator(open("lee_perry_smith"));
    run_plan(*sim, {ContractionEdit{"zygomaticus_major.L", 1.0}});
    EXPECT_GT(moved_at(*sim, "ch_l").norm(), 8.0);
    EXPECT_LT(moved_at(*sim, "ch_r").norm(), 2.0);
}

TEST_F(RealFace, FollowsTheMouseAtTheNoseTip) {
    const auto sim = make_simulator(open("lee_perry_smith"));
    const PlanReport report = run_plan(*sim, {parse_drag("at=prn; view=left; move=-3,4")});
    EXPECT_LT(report.drags.at(0).off_ray_mm, 0.05);
    EXPECT_LT(report.drags.at(0).view_force_residual, 0.01);
    EXPECT_TRUE(report.last.converged);
}

TEST_F(RealFace, OfEveryKindFitsAndSmilesWithoutTurningATriangleOver) {
    for (const char* name : {"ict_neutral", "ict_id001", "meshmonk_template", "meshmonk_simpop_02",
                             "makehuman_base", "mediapipe_canonical"}) {
        const auto sim = make_simulator(open(name));
        const PlanReport report = run_plan(*sim, {ContractionEdit{"zygomaticus_major", 1.0}});
        EXPECT_TRUE(report.last.converged) << name;
        const TriangleMesh& rest = sim->face().skin.mesh;
        const TriangleMesh now{sim->state().positions.leftCols(rest.vertex_count()),
                               rest.triangles};
        int turned = 0;
        for (int t = 0; t < rest.triangle_count(); ++t) {
            turned += double_area_vector(rest, t).dot(double_area_vector(now, t)) < 0.0;
        }
        EXPECT_EQ(turned, 0) << name;
        EXPECT_GT(moved_at(*sim, "ch_l").norm(), 5.0) << name;
    }
}

/// Unit and axes of every face, turned and scaled, with no landmark file in reach.
TEST_F(RealFace, TellsUnitAndAxesByItself) {
    const std::map<std::string, double> units{
        {"ict_neutral", 10.0},       {"ict_id001", 10.0},
        {"ict_id002", 10.0},         {"meshmonk_template", 1.0},
        {"meshmonk_simpop_01", 1.0}, {"meshmonk_simpop_02", 1.0},
        {"meshmonk_simpop_03", 1.0}, {"mediapipe_canonical", 10.0},
        {"makehuman_base", 100.0},   {"makehuman_caucasian_male_young", 100.0},
        {"lee_perry_smith", 0.0},    {"ict_neutral_full_with_eyes_teeth", 10.0}};
    const test::TemporaryFolder alone;
    const std::array<std::string, 3> turns{"+x+y+z", "+x-z+y", "-z-x+y"};
    int k = 0;
    for (const auto& [name, mm] : units) {
        const Scan scan = read_mesh(folder_ / "faces" / (name + ".obj"));
        for (const double factor : {1.0, 0.1}) {
            const std::string& axes = turns[static_cast<std::size_t>(k++) % turns.size()];
            Scan other = scan;
            other.frame = {1.0, Mat3::Identity()};
            other.file_vertices = factor * (axes_from_text(axes).transpose() * scan.file_vertices);
            other.mesh.vertices = other.file_vertices;
            write_mesh(alone / (name + ".ply"), other, other.mesh.vertices);
            const OpenedFace face = open_face((alone / (name + ".ply")).string());
            EXPECT_EQ(face.report.axes, axes) << name;
            EXPECT_GT(face.report.frame_confidence, 0.4) << name;
            if (mm > 0.0) {
                EXPECT_NEAR(face.report.mm_per_unit, mm / factor, 1e-6 * mm / factor) << name;
            } else {
                EXPECT_TRUE(face.report.needs_calibration);
                EXPECT_NEAR(face.report.mm_per_unit, 53.2 / factor, 5.3 / factor) << name;
            }
        }
    }
    const OpenedFace calibrated = [&] {
        OpenOptions options;
        options.known = KnownDistance{"en_l", "en_r", 33.0};
        return open_face((folder_ / "faces/lee_perry_smith.obj").string(), options);
    }();
    const Landmarks& l = *calibrated.landmarks;
    EXPECT_NEAR((l.at("en_l").position - l.at("en_r").position).norm(), 33.0, 1e-9);
}

/// Every odd file is taken whole or refused with a sentence that names it; a hang ends in the
/// runner's time limit.
void try_all(const std::filesystem::path& folder,
             const std::function<Scan(const std::filesystem::path&)>& read) {
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (!entry.is_regular_file() || extension == ".mtl" || extension == ".csv") {
            continue;
        }
        ++files;
        try {
            EXPECT_TRUE(read(entry.path()).mesh.vertices.allFinite());
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(entry.path().filename().string()),
                      std::string::npos)
                << error.what();
        }
    }
    EXPECT_GT(files, 40);
}

TEST_F(RealFace, FilesOfAllKindsAreReadOrRefusedWithASentence) {
    try_all(folder_ / "bad_inputs", [](const auto& file) { return read_mesh(file); });
}

TEST_F(RealFace, OddFilesOpenOrAreRefusedWithASentence) {
    try_all(folder_ / "bad_inputs",
            [](const auto& file) { return Scan(*open_face(file.string()).scan); });
}

}  // namespace
}  // namespace myoface
