// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>

#include "myoface/base/error.h"
#include "myoface/scene/face_scene.h"

#include "commands.h"
#include "face_arguments.h"
#include "film.h"
#include "picture.h"
#include "portrait.h"

namespace myoface::cli {
namespace {

struct AnimateArguments {
    FaceArguments face;
    EditArguments edits;
    std::string motion = "turn", view = "front", size = "640x720", output;
    int frames = 48;
    int rate = 20;
    bool anonymous = false;
};

/// A face that moves, drawn frame by frame.
class Animation {
public:
    Animation(const AnimateArguments& a, const OpenedFace& opened, Simulator& simulator, int width,
              int height)
        : simulator_(simulator),
          anonymous_(a.anonymous),
          width_(width),
          height_(height),
          scene_(simulator.face().scan, a.anonymous ? nullptr : opened.texture) {
        if (anonymous_) {
            scene_.scene().skin.colours.resize(3, 0);
        }
        scene_.set_face(simulator.shared_face(), simulator.system().model.springs,
                        simulator.system().chains);
        scene_.shade();
        camera_.orientation = standard_view(a.view);
        const Landmarks& l = simulator.face().landmarks;
        const auto nose = l.count("prn") != 0 ? l.at("prn") : l.at("sn");
        frame(camera_, nose.position + Vec3(0.0, 6.0, -78.0), 122.0,
              static_cast<double>(width) / height);
    }

    Image draw(double turn) {
        scene_.show(snapshot_of(simulator_));
        Camera camera = camera_;
        orbit(camera, turn, 0.0);
        Image picture = draw_picture(scene_.scene(), camera, width_, height_);
        const Vec3 towards = camera.orientation * Vec3::UnitZ();
        if (anonymous_ && towards.dot(simulator_.face().axes.col(2)) > -0.2) {  // not from behind
            cover_eyes(picture, camera, simulator_.face().landmarks);
        }
        return picture;
    }

private:
    Simulator& simulator_;
    bool anonymous_;
    int width_, height_;
    FaceScene scene_;
    Camera camera_;
};

/// All muscles at a share of what they do in the end.
void contract(Simulator& simulator, const std::vector<double>& rates, double share) {
    for (std::size_t m = 0; m < rates.size(); ++m) {
        simulator.set_contraction(static_cast<int>(m), share * rates[m]);
    }
    simulator.settle();
}

void animate(const AnimateArguments& a) {
    int width = 0;
    int height = 0;
    char extra = 0;
    if (std::sscanf(a.size.c_str(), "%dx%d%c", &width, &height, &extra) != 2 || width < 16 ||
        height < 16 || width > 4096 || height > 4096) {
        throw InvalidInput("The size '" + a.size + "' is not WIDTHxHEIGHT of 16 to 4096 pixels.");
    }
    const RecordedPlan plan = a.edits.edits();
    Film film(a.output, a.rate);  // says at once when it cannot be made
    OpenedFace opened = a.face.open();
    find_missing_landmarks(opened);
    const auto simulator = make_simulator(opened);
    run_plan(*simulator, plan_on(simulator->face(), plan));
    simulator->settle();
    const std::vector<double> rates = simulator->contractions().rate;
    Animation animation(a, opened, *simulator, width, height);
    for (int k = 0; k < a.frames; ++k) {
        const double phase = static_cast<double>(k) / a.frames;
        if (a.motion == "turn") {
            film.add(animation.draw(2.0 * std::numbers::pi * phase));
        } else {  // from rest there and back, softly
            contract(*simulator, rates, 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * phase));
            film.add(animation.draw(0.0));
        }
        std::fprintf(stderr, "%d %%\n", 100 * (k + 1) / a.frames);
    }
    film.finish();
}

}  // namespace

void add_animate(CLI::App& app) {
    auto* command = app.add_subcommand("animate", "A film: around the head, or an expression");
    auto a = std::make_shared<AnimateArguments>();
    a->face.add_to(*command);
    a->edits.add_to(*command);
    command
        ->add_option("--motion", a->motion,
                     "turn, around the head; expression, from rest to the face as it is and back")
        ->check(CLI::IsMember({"turn", "expression"}));
    command->add_option("--view", a->view, "where it starts: front, left, three-quarter-left …");
    command->add_option("--size", a->size, "WIDTHxHEIGHT");
    command->add_option("--frames", a->frames, "how many pictures")->check(CLI::Range(2, 999));
    command->add_option("--fps", a->rate, "pictures a second")->check(CLI::Range(1, 60));
    command->add_flag("--anonymous", a->anonymous, "plain skin and a bar over the eyes");
    command->add_option("-o", a->output, "film.gif, film.mp4, or a folder for PNG pictures")
        ->required();
    command->callback([a] { animate(*a); });
}

}  // namespace myoface::cli
