// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>

#include "myoface/base/error.h"
#include "myoface/mesh/bvh.h"
#include "myoface/scene/colour_map.h"
#include "myoface/scene/face_scene.h"

#include "commands.h"
#include "face_arguments.h"
#include "picture.h"

namespace myoface::cli {
namespace {

struct RenderArguments {
    FaceArguments face;
    EditArguments edits;
    std::string view = "front", layers = "skin", heatmap, size = "1200x1200", output;
    double heatmap_max = 0.0;
    std::string focus;
    double span = 90.0;
    double cut_away = 0.0;
    double skin_opacity = -1.0;  // as the other layers ask for
    bool whole = false;
    bool no_loose_parts = false;
};

LayerOpacity parse_layers(const std::string& text) {
    LayerOpacity layers{0.0F, 0.0F, 0.0F, 0.0F};
    std::istringstream words(text);
    int count = 0;
    for (std::string word; std::getline(words, word, ','); ++count) {
        if (word == "skin") {
            layers.skin = 1.0F;
        } else if (word == "muscle" || word == "muscles") {
            layers.muscles = 1.0F;
        } else if (word == "bone") {
            layers.bone = 1.0F;
        } else if (word == "springs") {
            layers.springs = 0.8F;
        } else {
            throw InvalidInput("There is no layer '" + word +
                               "': use skin, muscle, bone, springs, with commas between.");
        }
    }
    if (layers.skin > 0.0F && (layers.muscles > 0.0F || layers.bone > 0.0F)) {
        layers.skin = 0.4F;
    }
    return layers;
}

/// Distance of every vertex from the other face [mm]: vertex by vertex when they have the same
/// number, else to the nearest point of its surface.
/// @param count of the vertices that came with the face, without those of parted lips
std::vector<double> distances(const Points& here, const std::string& other_file,
                              const FileFrame& frame, Eigen::Index count) {
    ReadOptions options{frame.mm_per_unit, frame.axes};
    const Scan other = read_mesh(other_file, options);
    std::vector<double> result(static_cast<std::size_t>(here.cols()));
    const Eigen::Index own = other.mesh.vertices.cols();
    const bool same = own == count;
    const Bvh bvh(other.mesh);
    for (Eigen::Index v = 0; v < here.cols(); ++v) {
        result[static_cast<std::size_t>(v)] =
            same && v < own ? (here.col(v) - other.mesh.vertices.col(v)).norm()
                            : bvh.closest_point(other.mesh, here.col(v)).distance;
    }
    return result;
}

/// Close-up: a landmark in the middle, `span` mm from top to bottom.
void frame_landmark(Camera& camera, const OpenedFace& opened, const std::string& name,
                    double span) {
    if (!(span >= 5.0 && span <= 1000.0)) {
        throw InvalidInput("The span must lie between 5 and 1000 mm.");
    }
    if (!opened.landmarks || opened.landmarks->count(name) == 0) {
        throw InvalidInput("There is no landmark '" + name + "' on this face to look at.");
    }
    camera.target = opened.landmarks->at(name).position;
    camera.distance = 0.5 * span / std::tan(0.5 * camera.field_of_view);
}

void frame_face(Camera& camera, const OpenedFace& opened, bool whole, double aspect) {
    const Points& v = opened.scan->mesh.vertices;
    const Vec3 centre = 0.5 * (v.rowwise().maxCoeff() + v.rowwise().minCoeff());
    const double radius = 0.5 * (v.rowwise().maxCoeff() - v.rowwise().minCoeff()).norm();
    if (whole || !opened.landmarks) {
        frame(camera, centre, 0.85 * radius, aspect);
        return;
    }
    // The head: from the hairline to under the chin, ears in.
    const Landmarks& l = *opened.landmarks;
    const auto nose = l.count("prn") != 0 ? l.at("prn").position : l.at("sn").position;
    frame(camera, nose + Vec3(0.0, 8.0, -75.0), 128.0, aspect);
}

void render(const RenderArguments& a) {
    int width = 0;
    int height = 0;
    char extra = 0;
    if (std::sscanf(a.size.c_str(), "%dx%d%c", &width, &height, &extra) != 2 || width < 16 ||
        height < 16 || width > 8192 || height > 8192) {
        throw InvalidInput("The size '" + a.size + "' is not WIDTHxHEIGHT of 16 to 8192 pixels.");
    }
    LayerOpacity layers = parse_layers(a.layers);
    if (a.skin_opacity >= 0.0 && layers.skin > 0.0F) {
        layers.skin = static_cast<float>(std::min(a.skin_opacity, 1.0));
    }
    const RecordedPlan plan = a.edits.edits();
    Camera camera;
    camera.orientation = standard_view(a.view);
    OpenedFace opened = a.face.open();
    const bool needs_face = layers.muscles > 0.0F || layers.bone > 0.0F || layers.springs > 0.0F ||
                            !plan.edits.empty() || !opened.state.rates.empty() ||
                            opened.state.shape.cols() > 0;
    std::unique_ptr<Simulator> simulator;
    try {
        find_missing_landmarks(opened);
        simulator = make_simulator(opened);
    } catch (const InvalidInput&) {
        if (needs_face) {
            throw;
        }
    }  // what is no face is drawn as it came
    if (simulator) {
        run_plan(*simulator, plan_on(simulator->face(), plan));
    }
    const std::shared_ptr<const Scan> drawn = simulator ? simulator->face().scan : opened.scan;
    FaceScene scene(drawn, opened.texture);
    Points shown = drawn->mesh.vertices;
    if (simulator) {
        scene.set_face(simulator->shared_face(), simulator->system().model.springs,
                       simulator->system().chains);
        scene.set_layers(layers);
        scene.show(snapshot_of(*simulator));
        shown = simulator->scan_vertices();
    }
    scene.shade();
    scene.show_loose_parts(!a.no_loose_parts);
    if (!(a.cut_away >= 0.0 && a.cut_away <= 1.0)) {
        throw InvalidInput("The cut-away must lie between 0 and 1.");
    }
    scene.cut_away(a.cut_away);
    if (!a.heatmap.empty()) {
        std::vector<double> values =
            distances(shown, a.heatmap, opened.scan->frame, opened.scan->mesh.vertices.cols());
        const double largest = *std::max_element(values.begin(), values.end());
        const double most = a.heatmap_max > 0.0 ? a.heatmap_max : std::max(largest, 1e-9);
        Eigen::Matrix4Xf tint(4, static_cast<Eigen::Index>(values.size()));
        for (std::size_t v = 0; v < values.size(); ++v) {
            tint.col(static_cast<Eigen::Index>(v)) << colour_map(values[v] / most), 1.0F;
        }
        scene.tint(tint);
        std::fprintf(stderr, "Heat map: dark blue 0 mm to yellow %.2f mm.\n", most);
    }
    if (a.focus.empty()) {
        frame_face(camera, opened, a.whole, static_cast<double>(width) / height);
    } else {
        find_missing_landmarks(opened);
        frame_landmark(camera, opened, a.focus, a.span);
    }
    write_png(a.output, draw_picture(scene.scene(), camera, width, height));
}

}  // namespace

void add_render(CLI::App& app) {
    auto* command = app.add_subcommand("render", "Draw a picture of a face");
    auto a = std::make_shared<RenderArguments>();
    a->face.add_to(*command);
    a->edits.add_to(*command);
    command->add_option("--view", a->view,
                        "front left right three-quarter-left three-quarter-right below above back");
    command->add_option("--layers", a->layers, "of skin,muscle,bone,springs");
    command->add_option("--heatmap", a->heatmap, "colour by distance from this other face");
    command->add_option("--heatmap-max", a->heatmap_max, "distance of the last colour [mm]");
    command->add_option("--size", a->size, "WIDTHxHEIGHT");
    command->add_flag("--no-loose-parts", a->no_loose_parts,
                      "leave out what does not hang together with the face");
    command
        ->add_option("--skin-opacity", a->skin_opacity,
                     "0 to 1; 0.4 where muscles or bone are shown too")
        ->check(CLI::Range(0.0, 1.0));
    command->add_option("--cut-away", a->cut_away,
                        "take the skin away from the patient's left side on, 0 to 1");
    command->add_option("--focus", a->focus, "landmark in the middle: a close-up");
    command->add_option("--span", a->span, "height of a close-up [mm]");
    command->add_flag("--whole", a->whole, "show the whole scan, not the head only");
    command->add_option("-o", a->output, "PNG file")->required();
    command->callback([a] { render(*a); });
}

}  // namespace myoface::cli
