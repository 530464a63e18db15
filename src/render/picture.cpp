// SPDX-License-Identifier: Apache-2.0
#include "picture.h"

#include <epoxy/gl.h>
// epoxy's EGL must come after its GL
#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>

#include <epoxy/egl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "myoface/base/error.h"

#include "renderer.h"

namespace myoface {
namespace {

class Context {
public:
    Context() = default;
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

class HiddenWindow final : public Context {
public:
    HiddenWindow() {
        if (glfwInit() == GLFW_FALSE) {
            throw Error("No window system answers.");
        }
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        window_ = glfwCreateWindow(64, 64, "Myoface", nullptr, nullptr);
        if (window_ == nullptr) {
            glfwTerminate();
            throw Error("The display offers no OpenGL 3.3.");
        }
        glfwMakeContextCurrent(window_);
    }
    ~HiddenWindow() override {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }
    HiddenWindow(const HiddenWindow&) = delete;
    HiddenWindow& operator=(const HiddenWindow&) = delete;

private:
    GLFWwindow* window_ = nullptr;
};

class Surfaceless final : public Context {
public:
    Surfaceless() {
        display_ =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) {
            throw Error("No OpenGL: neither a display nor surfaceless EGL is there.");
        }
        eglBindAPI(EGL_OPENGL_API);
        constexpr std::array<EGLint, 7> kWanted{EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                3,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
        constexpr std::array<EGLint, 3> kConfig{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint found = 0;
        eglChooseConfig(display_, kConfig.data(), &config, 1, &found);
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, kWanted.data());
        if (context_ == EGL_NO_CONTEXT ||
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
            eglTerminate(display_);
            throw Error("EGL offers no OpenGL 3.3.");
        }
    }
    ~Surfaceless() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglTerminate(display_);
    }
    Surfaceless(const Surfaceless&) = delete;
    Surfaceless& operator=(const Surfaceless&) = delete;

private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

bool has_display() {
    const char* x11 = std::getenv("DISPLAY");
    return x11 != nullptr && *x11 != '\0';
}

std::unique_ptr<Context> make_context() {
    if (has_display()) {
        try {
            return std::make_unique<HiddenWindow>();
        } catch (const Error&) {
            // A display that does not answer is as good as none.
        }
    }
    return std::make_unique<Surfaceless>();
}

/// One context for all pictures of the process: opening a display costs more than a picture, and a
/// virtual display starts anew whenever its last client leaves.
void need_context() {
    static const std::unique_ptr<Context> kContext = make_context();
}

/// Box-filters to half the size; rows come from GL bottom up.
Image halved(const std::vector<std::uint8_t>& big, int width, int height) {
    Image image{width, height, {}};
    image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const auto at = [&](int x, int y, int channel) {
        return static_cast<int>(
            big[4 * (static_cast<std::size_t>(2 * height - 1 - y) * 2 * width + x) + channel]);
    };
    std::size_t out = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int channel = 0; channel < 4; ++channel) {
                const int sum = at(2 * x, 2 * y, channel) + at(2 * x + 1, 2 * y, channel) +
                                at(2 * x, 2 * y + 1, channel) + at(2 * x + 1, 2 * y + 1, channel);
                image.rgba[out++] = static_cast<std::uint8_t>((sum + 2) / 4);
            }
        }
    }
    return image;
}

}  // namespace

Image draw_picture(const SceneData& scene, const Camera& camera, int width, int height) {
    need_context();
    const int big_width = 2 * width;
    const int big_height = 2 * height;
    std::array<unsigned, 2> buffers{};
    unsigned target = 0;
    glGenFramebuffers(1, &target);
    glGenRenderbuffers(2, buffers.data());
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, big_width, big_height);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, big_width, big_height);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw Error("A picture of this size cannot be drawn here.");
    }
    Renderer renderer;
    renderer.initialise();
    renderer.draw(scene, camera, {0, 0, big_width, big_height}, 2.0F);
    std::vector<std::uint8_t> pixels(4 * static_cast<std::size_t>(big_width) *
                                     static_cast<std::size_t>(big_height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, big_width, big_height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    renderer.release();
    glDeleteFramebuffers(1, &target);
    glDeleteRenderbuffers(2, buffers.data());
    return halved(pixels, width, height);
}

}  // namespace myoface
