// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "myoface/scene/camera.h"
#include "myoface/scene/scene.h"

namespace myoface {

/// Where in the framebuffer a picture goes [px], from the lower left corner.
struct Pane {
    int x = 0, y = 0, width = 0, height = 0;
    int clip_from = 0, clip_to = 1 << 20;  ///< columns of the framebuffer that are touched
    bool over = false;                     ///< drawn over what is there instead of clearing it
};

/// Draws a SceneData with OpenGL 3.3 core into the framebuffer that is bound. All members need the
/// same current context; release() must be called before it goes.
class Renderer {
public:
    Renderer() = default;
    ~Renderer() = default;
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    ViewStyle style;

    /// Compiles the shaders. @throws Error with the compiler's words
    void initialise();
    void release();
    void draw(const SceneData& scene, const Camera& camera, const Pane& pane, float pixel_ratio);

private:
    struct Surface {
        unsigned array = 0, positions = 0, normals = 0, colours = 0, cavity = 0, uv = 0,
                 indices = 0, texture = 0, tint = 0, visibility = 0, rest = 0;
        int count = 0;
        bool has_colours = false;
    };
    struct Lines {
        unsigned array = 0, positions = 0, colours = 0, indices = 0;
        int count = 0;
    };

    static void upload_fixed(Surface& surface, const SurfaceLayer& layer);
    static void upload_motion(const Surface& surface, const SurfaceLayer& layer);
    static void upload(Lines& lines, const LineLayer& layer);
    void draw_background(const SceneData& scene) const;
    void set_cut(const SceneData& scene, bool is_skin) const;
    void draw_surface(const Surface& surface, const SurfaceLayer& layer, bool is_skin) const;
    void draw_lines(const Lines& lines, const LineLayer& layer) const;
    void draw_markers(const SceneData& scene, float pixel_ratio);

    unsigned skin_program_ = 0, line_program_ = 0, background_program_ = 0, marker_program_ = 0;
    unsigned empty_array_ = 0;
    unsigned marker_array_ = 0, marker_buffer_ = 0;
    std::array<Surface, 5> surfaces_;  ///< bone, mouth, eyes, muscles, skin
    std::array<Lines, 3> lines_;
    std::uint64_t net_version_ = 0;
    std::uint64_t tint_version_ = 0;
    std::uint64_t shade_version_ = 0;
    std::uint64_t topology_ = ~std::uint64_t{0};
    std::uint64_t motion_ = ~std::uint64_t{0};
    Eigen::Matrix4f view_, projection_;
};

}  // namespace myoface
