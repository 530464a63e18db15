// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "myoface/base/points.h"
#include "myoface/io/image.h"

namespace myoface {

using FloatPoints = Eigen::Matrix3Xf;

/// A shaded surface. Colours are sRGB in 0 … 1.
struct SurfaceLayer {
    FloatPoints positions;        ///< 3×N [mm]
    FloatPoints normals;          ///< 3×N unit
    FloatPoints colours;          ///< 3×N, or 3×0 for `plain_colour`
    Eigen::Matrix4Xf tint;        ///< 4×N: colour times cover, and cover 0 … 1; or 4×0
    FloatPoints rest;             ///< 3×N [mm], where patterns of the skin are fixed; or 3×0
    Eigen::Matrix4Xf visibility;  ///< 4×N of light_visibility(); or 4×0: open everywhere
    Eigen::VectorXf cavity;       ///< N, 0 open … 1 deep in a fold; or empty
    Eigen::Matrix2Xf uv;          ///< 2×N with `texture`, else 2×0
    std::shared_ptr<const Image> texture;
    Eigen::Vector3f plain_colour{0.80F, 0.62F, 0.53F};
    std::vector<std::uint32_t> indices;
    float opacity = 1.0F;   ///< 0 hides the layer
    float lit = 1.0F;       ///< share of all light that gets there
    float gloss = 0.35F;    ///< strength of the highlight
    float softness = 1.0F;  ///< light under the skin: 1 skin, 0 plaster
};

/// Coloured line segments.
struct LineLayer {
    FloatPoints positions;
    FloatPoints colours;
    std::vector<std::uint32_t> indices;  ///< pairs
    float opacity = 0.0F;
};

/// A small disc that always faces the viewer.
struct Marker {
    Eigen::Vector3f position;
    Eigen::Vector3f colour;
    float radius_px = 5.0F;
};

/// How the skin is shown, whatever the scene.
struct ViewStyle {
    bool clinical_light = false;  ///< even, from the front
    bool textured = true;
    bool wireframe = false;  ///< triangles over the skin
};

/// Everything that is to be seen, without a GPU. A renderer uploads a layer's fixed part again only
/// when `topology` changes, its positions and normals when `motion` changes.
struct SceneData {
    SurfaceLayer skin, muscles, bone;
    SurfaceLayer mouth;  ///< teeth and lining of a scan that has none
    SurfaceLayer eyes;   ///< the same for eyeballs
    LineLayer springs;
    LineLayer strokes;  ///< drawn over everything: drag arrows, grip ring
    LineLayer net;      ///< close to the skin and drawn before it; uploaded with `net_version`
    std::vector<Marker> markers;
    Eigen::Vector3f background_top{0.215F, 0.235F, 0.265F};
    Eigen::Vector3f background_bottom{0.085F, 0.095F, 0.11F};
    bool cut = false;  ///< skin with normal · p > offset is not drawn
    Eigen::Vector3f cut_normal{1.0F, 0.0F, 0.0F};
    float cut_offset = 0.0F;  ///< [mm]
    Vec3 centre = Vec3::Zero();
    double radius = 200.0;  ///< of everything visible around the centre [mm]
    std::uint64_t net_version = 0;
    std::uint64_t tint_version = 0;   ///< of the skin's tint
    std::uint64_t shade_version = 0;  ///< of the skin's visibility
    std::uint64_t topology = 0;
    std::uint64_t motion = 0;
};

}  // namespace myoface
