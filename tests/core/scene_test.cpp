// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/io/mesh_file.h"
#include "myoface/scene/camera.h"
#include "myoface/scene/colour_map.h"
#include "myoface/scene/face_scene.h"
#include "myoface/scene/mouth_light.h"
#include "myoface/scene/muscle_drawing.h"
#include "myoface/sim/simulator.h"

#include "test_meshes.h"

namespace myoface {
namespace {

class BothProjections : public ::testing::TestWithParam<bool> {};

TEST_P(BothProjections, ProjectAndRayAreInverse) {
    Camera camera;
    camera.orthographic = GetParam();
    camera.target = Vec3(3, -4, 60);
    camera.orientation = standard_view("three-quarter-left");
    const Vec3 point(20, 30, 80);
    const PixelPoint pixel = project(camera, point, 800, 600);
    const ViewRay ray = view_ray(camera, pixel.x, pixel.y, 800, 600);
    EXPECT_LT(distance_to_ray(ray, point), 1e-9);
    EXPECT_NEAR(ray.direction.norm(), 1.0, 1e-12);
}

TEST_P(BothProjections, MatricesAgreeWithProject) {
    Camera camera;
    camera.orthographic = GetParam();
    orbit(camera, 0.4, -0.2);
    const Vec3 point(15, -20, 30);
    const Eigen::Vector4d clip =
        camera.projection_matrix(800.0 / 600.0, 300.0) * camera.view_matrix() * point.homogeneous();
    const PixelPoint pixel = project(camera, point, 800, 600);
    EXPECT_NEAR(400.0 * (1.0 + clip.x() / clip.w()), pixel.x, 1e-9);
    EXPECT_NEAR(300.0 * (1.0 - clip.y() / clip.w()), pixel.y, 1e-9);
    EXPECT_LT(std::abs(clip.z()), clip.w());
}
INSTANTIATE_TEST_SUITE_P(Camera, BothProjections, ::testing::Bool());

TEST(StandardViews, LookFromTheSideTheyName) {
    EXPECT_TRUE((standard_view("front") * Vec3::UnitZ()).isApprox(Vec3::UnitZ()));
    EXPECT_TRUE((standard_view("left") * Vec3::UnitZ()).isApprox(Vec3::UnitX()));
    EXPECT_TRUE((standard_view("right") * Vec3::UnitZ()).isApprox(-Vec3::UnitX()));
    EXPECT_LT((standard_view("below") * Vec3::UnitZ()).y(), -0.5);
    EXPECT_THROW(standard_view("inside"), InvalidInput);
}

TEST(Camera, KeepsTheHeadUprightWhileItOrbits) {
    Camera camera;
    for (int k = 0; k < 50; ++k) {
        orbit(camera, 0.2, 0.0);
    }
    EXPECT_NEAR((camera.orientation * Vec3::UnitX()).y(), 0.0, 1e-9);
}

TEST(ColourMap, GrowsInLightness) {
    double last = -1.0;
    for (double v = 0.0; v <= 1.0; v += 0.05) {
        const Eigen::Vector3f c = colour_map(v);
        const double lightness = 0.2126 * c.x() + 0.7152 * c.y() + 0.0722 * c.z();
        EXPECT_GT(lightness, last);
        last = lightness;
    }
}

TEST(FaceScene, ShowsAllFourLayersAndMovesThem) {
    const auto face = test::small_model();
    Simulator sim(face);
    FaceScene scene(face->scan, nullptr);
    scene.set_face(face, sim.system().model.springs, sim.system().chains);
    scene.set_layers({1.0F, 1.0F, 1.0F, 1.0F});
    SimSnapshot snapshot;
    snapshot.positions = sim.state().positions;
    scene.show(snapshot);
    const FloatPoints before = scene.scene().skin.positions;
    EXPECT_GT(scene.scene().muscles.indices.size(), 1000U);
    EXPECT_GT(scene.scene().bone.indices.size(), 1000U);
    EXPECT_EQ(scene.scene().springs.indices.size(), 2 * sim.system().model.springs.size());
    sim.set_contraction(test::muscle(*face, "zygomaticus_major.L"), 1.0);
    sim.settle();
    snapshot.positions = sim.state().positions;
    scene.show(snapshot);
    EXPECT_GT((scene.scene().skin.positions - before).cwiseAbs().maxCoeff(), 5.0F);
    EXPECT_TRUE(scene.scene().muscles.normals.allFinite());
}

TEST(SkinDrawing, SplitsVerticesAtTextureSeamsOnly) {
    Scan scan = read_mesh_bytes(
        "v 0 0 0\nv 200 0 0\nv 200 200 0\nv 0 200 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt .5 .5\n"
        "f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n",
        "seam.obj");
    EXPECT_EQ(SkinDrawing(scan).drawn_count(), 5);
}

TEST(FaceScene, LeavesLoosePartsOutAndTakesThemBack) {
    FaceScene scene(std::make_shared<const Scan>(test::small_face().scan), nullptr);
    const auto all = scene.scene().skin.indices;
    scene.show_loose_parts(false);
    EXPECT_EQ(scene.scene().skin.indices.size(),
              3 * static_cast<std::size_t>(test::small_face().scan.findings.parts[0].triangles));
    EXPECT_LT(scene.scene().skin.indices.size(), all.size());  // without the eyeballs
    scene.show_loose_parts(true);
    EXPECT_EQ(scene.scene().skin.indices, all);
}

TEST(FaceScene, ShowsTeethBehindLipsThatCameClosed) {
    // The built-in face has a mouth of its own.
    FaceScene own(test::small_model()->scan, nullptr);
    own.set_face(test::small_model(), {}, {});
    EXPECT_TRUE(own.scene().mouth.indices.empty());
    // A face whose sheet of skin has nothing behind it gets one, which goes with the jaw.
    auto bare = std::make_shared<FaceModel>(*test::small_model());
    bare->mouth.mesh = test::sphere(10.0);
    bare->mouth.mesh.vertices.colwise() += Vec3(0.0, -52.0, 80.0);
    bare->mouth.with_jaw = Eigen::VectorXd::Ones(bare->mouth.mesh.vertex_count());
    bare->mouth.depth = Eigen::VectorXd::Zero(bare->mouth.mesh.vertex_count());
    FaceScene scene(bare->scan, nullptr);
    scene.set_face(bare, {}, {});
    const SurfaceLayer& mouth = scene.scene().mouth;
    ASSERT_FALSE(mouth.indices.empty());
    EXPECT_EQ(mouth.positions.cols(), mouth.colours.cols());
    EXPECT_LT(*std::max_element(mouth.indices.begin(), mouth.indices.end()),
              static_cast<std::uint32_t>(mouth.positions.cols()));
    const Eigen::Vector3f closed = mouth.positions.col(mouth.positions.cols() - 1);
    SimSnapshot snapshot;
    snapshot.positions = bare->skin.mesh.vertices;
    snapshot.jaw = 1.0;
    scene.show(snapshot);
    EXPECT_LT(mouth.positions.col(mouth.positions.cols() - 1).y(), closed.y());
}

TEST(FaceScene, ShowsEyeballsWhereSocketsAreEmpty) {
    const FaceModel& own = *test::small_model();
    EXPECT_EQ(own.eyeballs.mesh.triangle_count(), 0);  // it has some
    // The left one is taken out of the scan, the right one stays.
    const GenericFace& small = test::small_face();
    auto scan = std::make_shared<Scan>(small.scan);
    const Vec3 eye = own.eyes.col(0);
    for (int t = 0; t < scan->mesh.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) {
            auto place = scan->mesh.vertices.col(scan->mesh.triangles(c, t));
            if (scan->triangle_part[static_cast<std::size_t>(t)] != 0 &&
                (place - eye).norm() < 15.0) {
                place.z() = -100.0;
            }
        }
    }
    const auto face = fit_face(scan, small.landmarks);
    const Points& ball = face->eyeballs.mesh.vertices;
    ASSERT_GT(face->eyeballs.mesh.triangle_count(), 100);
    ASSERT_EQ(face->eyeballs.colours.cols(), ball.cols());
    const Vec3 low = ball.rowwise().minCoeff();
    const Vec3 high = ball.rowwise().maxCoeff();
    EXPECT_NEAR(0.5 * (high - low).x(), 12.0, 1.0);
    EXPECT_LT((0.5 * (low + high) - eye).norm(), 4.0);  // the left one only
    // Dark in front, where the pupil is, and white beside it.
    Eigen::Index front = 0;
    Eigen::Index out = 0;
    ball.row(2).maxCoeff(&front);
    ball.row(0).maxCoeff(&out);
    EXPECT_LT(face->eyeballs.colours.col(front).maxCoeff(), 0.2F);
    EXPECT_GT(face->eyeballs.colours.col(out).minCoeff(), 0.4F);
    FaceScene scene(face->scan, nullptr);
    scene.set_face(face, {}, {});
    EXPECT_EQ(scene.scene().eyes.indices.size(),
              3 * static_cast<std::size_t>(face->eyeballs.mesh.triangle_count()));
}

TEST(MouthLight, FallsBehindTheLipsAndComesWithTheGap) {
    const FaceModel& face = *test::small_model();
    const Vec3 lips = from_generic(face, {0.0, -52.0, 97.0});
    const Vec3 front = face.axes.col(2);
    double last = light_behind_lips(face, lips + 5.0 * front)[0];
    EXPECT_NEAR(last, 1.0, 1e-9);
    for (const double behind : {5.0, 15.0, 30.0, 50.0}) {
        const double light = light_behind_lips(face, lips - behind * front)[0];
        EXPECT_LT(light, last);
        EXPECT_GT(light, 0.0);
        last = light;
    }
    Points nodes = face.skin.mesh.vertices;
    const double shut = light_between_lips(face, nodes);
    for (const auto& [upper, lower] : face.lip_contacts) {
        nodes.col(lower).y() -= 8.0;
    }
    EXPECT_LT(shut, 0.5);
    EXPECT_NEAR(light_between_lips(face, nodes), 1.0, 1e-9);
}

TEST(MouthLight, ReachesTheMouthAndNothingElse) {
    const FaceModel& face = *test::small_model();
    const Points& vertices = face.scan->mesh.vertices;
    Eigen::Matrix4Xf dark = Eigen::Matrix4Xf::Zero(4, vertices.cols());
    light_the_mouth(face, dark);
    int lit = 0;
    for (Eigen::Index v = 0; v < vertices.cols(); ++v) {
        if (dark(3, v) > 0.0F) {
            ++lit;
            EXPECT_LT((vertices.col(v) - from_generic(face, {0.0, -52.0, 70.0})).norm(), 65.0);
        }
    }
    EXPECT_GT(lit, 50);
    Eigen::Matrix4Xf open = Eigen::Matrix4Xf::Ones(4, vertices.cols());
    light_the_mouth(face, open);
    EXPECT_EQ(open, Eigen::Matrix4Xf::Ones(4, vertices.cols()));
}

TEST(FaceScene, CutsTheSkinAwayFromTheLeft) {
    FaceScene scene(test::small_model()->scan, nullptr);
    EXPECT_FALSE(scene.scene().cut);
    scene.cut_away(0.5);
    EXPECT_TRUE(scene.scene().cut);
    EXPECT_NEAR(scene.scene().cut_offset, 0.0F, 0.5F);  // the midplane of a symmetric head
    scene.cut_away(0.0);
    EXPECT_FALSE(scene.scene().cut);
}

TEST(MuscleDrawing, FindsAndNamesWhatIsUnderTheMouse) {
    const auto face = test::small_model();
    const int zygomatic = test::muscle(*face, "zygomaticus_major.L");
    const Muscle& muscle = face->muscles[static_cast<std::size_t>(zygomatic)];
    const Vec3 middle = muscle.path.col(muscle.path.cols() / 2);
    const Vec3 outward = muscle.outward.col(muscle.outward.cols() / 2).normalized();
    const auto found = muscle_on_ray(*face, {middle + 200.0 * outward, -outward});
    ASSERT_TRUE(found);
    EXPECT_EQ(face->muscles[static_cast<std::size_t>(*found)].traits.name, "zygomaticus_major.L");
    EXPECT_FALSE(muscle_on_ray(*face, {Vec3(0, 0, 500), Vec3::UnitZ()}));
    const std::string words = muscle_in_words(muscle.traits, false);
    EXPECT_NE(words.find("Zygomaticus major, left"), std::string::npos);
    EXPECT_NE(muscle_in_words(muscle.traits, true).find("大頬骨筋（左）"), std::string::npos);
    Eigen::Index chin = 0;
    (face->skin.mesh.vertices.colwise() - face->landmarks.at("pg").position)
        .colwise()
        .squaredNorm()
        .minCoeff(&chin);
    EXPECT_EQ(tissue_in_words(*face, static_cast<int>(chin), false).rfind("chin", 0), 0U);
    EXPECT_NE(tissue_in_words(*face, static_cast<int>(chin), true).find("オトガイ"),
              std::string::npos);
}

TEST(MuscleDrawing, MovesWithItsChainsAndKeepsItsTopology) {
    const auto face = test::small_model();
    Simulator sim(face);
    SurfaceLayer layer;
    draw_muscles(layer, *face, sim.system().chains, sim.state().positions);
    ASSERT_GT(layer.indices.size(), 10000U);
    ASSERT_EQ(layer.positions.cols(), layer.normals.cols());
    EXPECT_TRUE(layer.positions.allFinite() && layer.normals.allFinite());
    const auto indices = layer.indices;
    const FloatPoints before = layer.positions;
    sim.set_contraction(muscles_named("jaw_opening")[0], 0.5);
    sim.settle();
    draw_muscles(layer, *face, sim.system().chains, sim.state().positions);
    EXPECT_EQ(layer.indices, indices);
    EXPECT_GT((layer.positions - before).cwiseAbs().maxCoeff(), 5.0F);
}

}  // namespace
}  // namespace myoface
