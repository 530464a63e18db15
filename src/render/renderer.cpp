// SPDX-License-Identifier: Apache-2.0
#include "renderer.h"

#include <algorithm>
#include <vector>

#include <epoxy/gl.h>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/io/text_file.h"

namespace myoface {
namespace {

enum Attribute : unsigned { kPosition, kNormal, kColour, kUv, kCavity, kTint, kVisibility, kRest };

unsigned compile(unsigned kind, const std::string& file) {
    const std::string text = read_file(resource_path(file));
    const char* source = text.c_str();
    const unsigned shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    int good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == 0) {
        std::array<char, 2048> log{};
        glGetShaderInfoLog(shader, static_cast<int>(log.size()), nullptr, log.data());
        glDeleteShader(shader);
        throw Error("The shader " + file + " does not compile: " + log.data());
    }
    return shader;
}

unsigned link(const std::string& name) {
    const unsigned vertex = compile(GL_VERTEX_SHADER, "shaders/" + name + ".vert");
    const unsigned fragment = compile(GL_FRAGMENT_SHADER, "shaders/" + name + ".frag");
    const unsigned program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    int good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (good == 0) {
        std::array<char, 2048> log{};
        glGetProgramInfoLog(program, static_cast<int>(log.size()), nullptr, log.data());
        throw Error("The shaders " + name + " do not link: " + log.data());
    }
    return program;
}

int uniform(unsigned program, const char* name) {
    return glGetUniformLocation(program, name);
}

void set(unsigned program, const char* name, const Eigen::Matrix4f& value) {
    glUniformMatrix4fv(uniform(program, name), 1, GL_FALSE, value.data());
}
void set(unsigned program, const char* name, const Eigen::Vector3f& value) {
    glUniform3fv(uniform(program, name), 1, value.data());
}
void set(unsigned program, const char* name, float value) {
    glUniform1f(uniform(program, name), value);
}
void set(unsigned program, const char* name, bool value) {
    glUniform1i(uniform(program, name), value ? 1 : 0);
}

template <typename Matrix>
void fill(unsigned& buffer, unsigned attribute, int components, const Matrix& data, GLenum use) {
    if (data.size() == 0) {
        glDisableVertexAttribArray(attribute);
        return;
    }
    if (buffer == 0) {
        glGenBuffers(1, &buffer);
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)), data.data(),
                 use);
    glEnableVertexAttribArray(attribute);
    glVertexAttribPointer(attribute, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void fill_indices(unsigned& buffer, const std::vector<std::uint32_t>& indices) {
    if (buffer == 0) {
        glGenBuffers(1, &buffer);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
}

void need_array(unsigned& array) {
    if (array == 0) {
        glGenVertexArrays(1, &array);
    }
    glBindVertexArray(array);
}

}  // namespace

void Renderer::initialise() {
    skin_program_ = link("skin");
    line_program_ = link("line");
    background_program_ = link("background");
    marker_program_ = link("marker");
    glGenVertexArrays(1, &empty_array_);
    topology_ = motion_ = net_version_ = tint_version_ = shade_version_ = ~std::uint64_t{0};
}

void Renderer::release() {
    for (unsigned* program :
         {&skin_program_, &line_program_, &background_program_, &marker_program_}) {
        glDeleteProgram(*program);
        *program = 0;
    }
    for (Surface& s : surfaces_) {
        for (unsigned* buffer : {&s.positions, &s.normals, &s.colours, &s.cavity, &s.uv, &s.indices,
                                 &s.tint, &s.visibility, &s.rest}) {
            glDeleteBuffers(1, buffer);
        }
        glDeleteTextures(1, &s.texture);
        glDeleteVertexArrays(1, &s.array);
        s = {};
    }
    for (Lines& l : lines_) {
        for (unsigned* buffer : {&l.positions, &l.colours, &l.indices}) {
            glDeleteBuffers(1, buffer);
        }
        glDeleteVertexArrays(1, &l.array);
        l = {};
    }
    glDeleteBuffers(1, &marker_buffer_);
    glDeleteVertexArrays(1, &marker_array_);
    glDeleteVertexArrays(1, &empty_array_);
    marker_buffer_ = marker_array_ = empty_array_ = 0;
}

void Renderer::upload_fixed(Surface& surface, const SurfaceLayer& layer) {
    need_array(surface.array);
    fill(surface.positions, kPosition, 3, layer.positions, GL_DYNAMIC_DRAW);
    fill(surface.normals, kNormal, 3, layer.normals, GL_DYNAMIC_DRAW);
    fill(surface.colours, kColour, 3, layer.colours, GL_STATIC_DRAW);
    fill(surface.cavity, kCavity, 1, layer.cavity, GL_DYNAMIC_DRAW);
    fill(surface.rest, kRest, 3, layer.rest, GL_STATIC_DRAW);
    fill(surface.uv, kUv, 2, layer.uv, GL_STATIC_DRAW);
    fill_indices(surface.indices, layer.indices);
    surface.count = static_cast<int>(layer.indices.size());
    surface.has_colours = layer.colours.cols() > 0;
    glDeleteTextures(1, &surface.texture);
    surface.texture = 0;
    if (layer.texture && layer.uv.cols() > 0) {
        glGenTextures(1, &surface.texture);
        glBindTexture(GL_TEXTURE_2D, surface.texture);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, layer.texture->width, layer.texture->height,
                     0, GL_RGBA, GL_UNSIGNED_BYTE, layer.texture->rgba.data());
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);  // as whoever draws after us expects it
        glGenerateMipmap(GL_TEXTURE_2D);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }
}

void Renderer::upload_motion(const Surface& surface, const SurfaceLayer& layer) {
    const auto refill = [](unsigned buffer, const auto& data) {
        if (buffer != 0 && data.size() > 0) {
            glBindBuffer(GL_ARRAY_BUFFER, buffer);
            glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)),
                         data.data(), GL_DYNAMIC_DRAW);
        }
    };
    refill(surface.positions, layer.positions);
    refill(surface.normals, layer.normals);
    refill(surface.cavity, layer.cavity);  // wrinkles come and go
}

void Renderer::upload(Lines& lines, const LineLayer& layer) {
    need_array(lines.array);
    fill(lines.positions, kPosition, 3, layer.positions, GL_DYNAMIC_DRAW);
    fill(lines.colours, kColour, 3, layer.colours, GL_DYNAMIC_DRAW);
    fill_indices(lines.indices, layer.indices);
    lines.count = static_cast<int>(layer.indices.size());
}

void Renderer::draw(const SceneData& scene, const Camera& camera, const Pane& pane,
                    float pixel_ratio) {
    constexpr std::size_t kSkin = 4;
    const std::array<const SurfaceLayer*, kSkin + 1> layers{&scene.bone, &scene.mouth, &scene.eyes,
                                                            &scene.muscles, &scene.skin};
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (scene.topology != topology_) {
            upload_fixed(surfaces_[i], *layers[i]);
        } else if (scene.motion != motion_) {
            upload_motion(surfaces_[i], *layers[i]);
        }
    }
    if (scene.topology != topology_ || scene.motion != motion_) {
        if (scene.springs.opacity > 0.0F) {
            upload(lines_[0], scene.springs);
        }
    }
    upload(lines_[1], scene.strokes);
    if (scene.topology != topology_ || scene.tint_version != tint_version_) {
        need_array(surfaces_[kSkin].array);
        fill(surfaces_[kSkin].tint, kTint, 4, scene.skin.tint, GL_DYNAMIC_DRAW);
        tint_version_ = scene.tint_version;
    }
    if (scene.topology != topology_ || scene.shade_version != shade_version_) {
        need_array(surfaces_[kSkin].array);
        fill(surfaces_[kSkin].visibility, kVisibility, 4, scene.skin.visibility, GL_STATIC_DRAW);
        shade_version_ = scene.shade_version;
    }
    if (scene.net_version != net_version_) {
        upload(lines_[2], scene.net);
        net_version_ = scene.net_version;
    }
    topology_ = scene.topology;
    motion_ = scene.motion;

    glViewport(pane.x, pane.y, pane.width, pane.height);
    const int from = std::max(pane.x, pane.clip_from);
    const int to = std::min(pane.x + pane.width, pane.clip_to);
    glScissor(from, pane.y, std::max(to - from, 0), pane.height);
    glEnable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(pane.over ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if (!pane.over) {
        draw_background(scene);
    }

    const double reach = scene.radius + (scene.centre - camera.target).norm();
    view_ = camera.view_matrix().cast<float>();
    projection_ = camera
                      .projection_matrix(static_cast<double>(pane.width) / std::max(pane.height, 1),
                                         1.2 * reach)
                      .cast<float>();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (i == kSkin && layers[kSkin]->opacity < 1.0F) {
            draw_lines(lines_[0], scene.springs);  // seen through the skin
        }
        set_cut(scene, i == kSkin);
        draw_surface(surfaces_[i], *layers[i], i == kSkin);
    }
    if (layers[kSkin]->opacity >= 1.0F) {
        draw_lines(lines_[0], scene.springs);
    }
    glDepthRange(0.0, 0.995);  // what lies under the skin by little is not lost
    draw_lines(lines_[2], scene.net);
    glDepthRange(0.0, 1.0);
    glDisable(GL_DEPTH_TEST);
    LineLayer strokes_state;
    strokes_state.opacity = 1.0F;
    draw_lines(lines_[1], strokes_state);
    draw_markers(scene, pixel_ratio);
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
}

void Renderer::draw_background(const SceneData& scene) const {
    glDisable(GL_DEPTH_TEST);
    glUseProgram(background_program_);
    set(background_program_, "top", scene.background_top);
    set(background_program_, "bottom", scene.background_bottom);
    glBindVertexArray(empty_array_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::set_cut(const SceneData& scene, bool is_skin) const {
    glUseProgram(skin_program_);
    set(skin_program_, "isCut", scene.cut && is_skin);
    set(skin_program_, "cutNormal", scene.cut_normal);
    set(skin_program_, "cutOffset", scene.cut_offset);
}

void Renderer::draw_surface(const Surface& surface, const SurfaceLayer& layer, bool is_skin) const {
    if (layer.opacity <= 0.0F || surface.count == 0) {
        return;
    }
    glUseProgram(skin_program_);
    glBindVertexArray(surface.array);
    set(skin_program_, "view", view_);
    set(skin_program_, "projection", projection_);
    set(skin_program_, "plainColour", layer.plain_colour);
    set(skin_program_, "opacity", layer.opacity);
    set(skin_program_, "gloss", layer.gloss);
    set(skin_program_, "lit", layer.lit);
    set(skin_program_, "softness", layer.softness);
    set(skin_program_, "hasColours", surface.has_colours && (style.textured || !is_skin));
    set(skin_program_, "hasTexture", surface.texture != 0 && (style.textured || !is_skin));
    set(skin_program_, "clinical", style.clinical_light);
    const bool coloured = (surface.has_colours || surface.texture != 0) && style.textured;
    const bool patterned = is_skin && layer.rest.cols() > 0;
    set(skin_program_, "detail", patterned && !coloured ? 1.0F : 0.0F);
    set(skin_program_, "relief", !patterned ? 0.0F : coloured ? 0.45F : 1.0F);
    glVertexAttrib1f(kCavity, 0.0F);
    glVertexAttrib4f(kVisibility, 0.0F, 0.0F, 0.0F, 1.0F);
    glVertexAttrib4f(kTint, 0.0F, 0.0F, 0.0F, 0.0F);
    if (surface.texture != 0) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, surface.texture);
        glUniform1i(uniform(skin_program_, "picture"), 0);
    }
    if (layer.opacity < 1.0F) {
        // Depth first: only the front-most layer of skin is blended, not what it folds over.
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDrawElements(GL_TRIANGLES, surface.count, GL_UNSIGNED_INT, nullptr);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glEnable(GL_BLEND);
    } else {
        glDisable(GL_BLEND);
    }
    glDrawElements(GL_TRIANGLES, surface.count, GL_UNSIGNED_INT, nullptr);
    if (is_skin && style.wireframe) {
        glEnable(GL_BLEND);
        glDepthRange(0.0, 0.9999);  // on the surface, not in it
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        set(skin_program_, "plainColour", Eigen::Vector3f(0.10F, 0.14F, 0.20F));
        set(skin_program_, "hasColours", false);
        set(skin_program_, "hasTexture", false);
        set(skin_program_, "opacity", 0.45F * layer.opacity);
        glDrawElements(GL_TRIANGLES, surface.count, GL_UNSIGNED_INT, nullptr);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        glDepthRange(0.0, 1.0);
    }
    glDisable(GL_BLEND);
}

void Renderer::draw_lines(const Lines& lines, const LineLayer& layer) const {
    if (layer.opacity <= 0.0F || lines.count == 0) {
        return;
    }
    glUseProgram(line_program_);
    glBindVertexArray(lines.array);
    set(line_program_, "view", view_);
    set(line_program_, "projection", projection_);
    set(line_program_, "opacity", layer.opacity);
    glEnable(GL_BLEND);
    glDrawElements(GL_LINES, lines.count, GL_UNSIGNED_INT, nullptr);
    glDisable(GL_BLEND);
}

void Renderer::draw_markers(const SceneData& scene, float pixel_ratio) {
    if (scene.markers.empty()) {
        return;
    }
    std::vector<float> data;
    for (const Marker& marker : scene.markers) {
        for (int i = 0; i < 3; ++i) {
            data.push_back(marker.position[i]);
        }
        for (int i = 0; i < 3; ++i) {
            data.push_back(marker.colour[i]);
        }
        data.push_back(2.0F * marker.radius_px * pixel_ratio);
    }
    need_array(marker_array_);
    if (marker_buffer_ == 0) {
        glGenBuffers(1, &marker_buffer_);
    }
    glBindBuffer(GL_ARRAY_BUFFER, marker_buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)), data.data(),
                 GL_STREAM_DRAW);
    constexpr int kStride = 7 * sizeof(float);
    const auto offset = [](std::size_t floats) {
        return reinterpret_cast<const void*>(floats * sizeof(float));
    };
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, offset(0));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride, offset(3));
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, kStride, offset(6));
    glUseProgram(marker_program_);
    set(marker_program_, "view", view_);
    set(marker_program_, "projection", projection_);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_BLEND);
    glDrawArrays(GL_POINTS, 0, static_cast<int>(scene.markers.size()));
    glDisable(GL_BLEND);
    glDisable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace myoface
