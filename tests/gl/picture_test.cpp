// SPDX-License-Identifier: Apache-2.0
#include "picture.h"

#include <gtest/gtest.h>

#include "myoface/scene/face_scene.h"

#include "test_meshes.h"

namespace myoface {
namespace {

/// Mean brightness of a square around the middle, 0 … 255.
double brightness(const Image& image, int half) {
    double sum = 0.0;
    int count = 0;
    for (int y = image.height / 2 - half; y < image.height / 2 + half; ++y) {
        for (int x = image.width / 2 - half; x < image.width / 2 + half; ++x) {
            const std::size_t at = 4 * (static_cast<std::size_t>(y) * image.width + x);
            sum += (image.rgba[at] + image.rgba[at + 1] + image.rgba[at + 2]) / 3.0;
            ++count;
        }
    }
    return sum / count;
}

struct Shown {
    std::shared_ptr<const FaceModel> face = test::small_model();
    Simulator sim{face};
    FaceScene scene{face->scan, nullptr};
    Camera camera;

    Shown() {
        scene.set_face(face, sim.system().model.springs, sim.system().chains);
        frame(camera, face->landmarks.at("prn").position - Vec3(0, 0, 70), 120.0, 1.0);
        show();
    }
    void show() {
        SimSnapshot snapshot;
        snapshot.positions = sim.state().positions;
        scene.show(snapshot);
    }
    Image draw() { return draw_picture(scene.scene(), camera, 200, 200); }
};

TEST(Picture, ShowsALitFaceBeforeADarkBackground) {
    Shown s;
    const Image image = s.draw();
    EXPECT_GT(brightness(image, 20), 110.0);
    const double corner = (image.rgba[0] + image.rgba[1] + image.rgba[2]) / 3.0;
    EXPECT_LT(corner, 80.0);
}

TEST(Picture, IsTheSameTwice) {
    Shown s;
    EXPECT_EQ(s.draw().rgba, s.draw().rgba);
}

TEST(Picture, ChangesWithEveryLayer) {
    Shown s;
    std::vector<std::vector<std::uint8_t>> seen;
    for (const LayerOpacity& layers :
         {LayerOpacity{1, 0, 0, 0}, LayerOpacity{0, 1, 0, 0}, LayerOpacity{0, 0, 1, 0},
          LayerOpacity{0, 0, 0, 1}, LayerOpacity{0.4F, 1, 1, 0}, LayerOpacity{0, 0, 0, 0}}) {
        s.scene.set_layers(layers);
        s.show();
        seen.push_back(s.draw().rgba);
        for (std::size_t k = 0; k + 1 < seen.size(); ++k) {
            EXPECT_NE(seen[k], seen.back()) << k;
        }
    }
}

TEST(Picture, FollowsTheSimulation) {
    Shown s;
    const Image before = s.draw();
    s.sim.set_contraction(test::muscle(*s.face, "zygomaticus_major.L"), 1.0);
    s.sim.settle();
    s.show();
    EXPECT_NE(before.rgba, s.draw().rgba);
}

}  // namespace
}  // namespace myoface
