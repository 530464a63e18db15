// SPDX-License-Identifier: Apache-2.0
#include "myoface/scene/face_scene.h"

#include <algorithm>
#include <cmath>

#include "myoface/base/parallel.h"
#include "myoface/mesh/normals.h"
#include "myoface/scene/colour_map.h"
#include "myoface/scene/mouth_light.h"
#include "myoface/scene/muscle_drawing.h"
#include "myoface/scene/visibility.h"

namespace myoface {
namespace {

const Eigen::Vector3f kTooth(0.93F, 0.91F, 0.86F);
constexpr double kAtIncisors = 1.6;  // they are lit in full, a little behind the lips

}  // namespace

FaceScene::FaceScene(std::shared_ptr<const Scan> scan, std::shared_ptr<const SkinTexture> texture)
    : scan_(std::move(scan)), texture_(std::move(texture)), drawing_(*scan_) {
    drawing_.fill(scene_.skin, *scan_, texture_.get());
    scene_.skin.texture = picture();
    scene_.skin.rest = scene_.skin.positions;
    rest_normals_ = scene_.skin.normals.leftCols(scan_->mesh.vertex_count());
    const Points& v = scan_->mesh.vertices;
    scene_.centre = 0.5 * (v.rowwise().maxCoeff() + v.rowwise().minCoeff());
    scene_.radius = 0.5 * (v.rowwise().maxCoeff() - v.rowwise().minCoeff()).norm();
    scene_.bone.plain_colour = {0.87F, 0.84F, 0.76F};
    scene_.bone.softness = 0.15F;
    scene_.bone.gloss = 0.12F;
    scene_.mouth.softness = 0.3F;
    scene_.mouth.gloss = 0.12F;
    scene_.eyes.softness = 0.2F;
    scene_.eyes.gloss = 0.6F;
    scene_.muscles.softness = 0.5F;
    scene_.muscles.gloss = 0.6F;
    set_layers({});
    scene_.topology = scene_.motion = 1;
}

std::shared_ptr<const Image> FaceScene::picture() const {
    return texture_ ? std::shared_ptr<const Image>(texture_, &texture_->image) : nullptr;
}

void FaceScene::set_face(std::shared_ptr<const FaceModel> face, const std::vector<Spring>& springs,
                         const std::vector<MuscleChain>& chains) {
    face_ = std::move(face);
    springs_ = springs;
    chains_ = chains;
    following_ = std::make_unique<FollowingScan>(face_->skin, *face_->adjacency,
                                                 face_->scan->mesh.vertices, rest_normals_);
    const TriangleMesh& bone = face_->bone;
    SurfaceLayer& layer = scene_.bone;
    layer.indices.clear();
    for (int t = 0; t < bone.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) {
            layer.indices.push_back(static_cast<std::uint32_t>(bone.triangles(c, t)));
        }
    }
    layer.colours.resize(3, bone.vertex_count());
    for (int v = 0; v < bone.vertex_count(); ++v) {
        const BonePart part = face_->bone_part[static_cast<std::size_t>(v)];
        layer.colours.col(v) = part == BonePart::Cranium    ? Eigen::Vector3f(0.87F, 0.83F, 0.73F)
                               : part == BonePart::Mandible ? Eigen::Vector3f(0.83F, 0.77F, 0.64F)
                                                            : kTooth;
    }
    bone_adjacency_ = std::make_unique<Adjacency>(bone);
    make_mouth();
    make_eyes();
    show_bone();
    show_visibility();
    ++scene_.topology;
}

void FaceScene::make_eyes() {
    SurfaceLayer& layer = scene_.eyes;
    const Eyeballs& eyes = face_->eyeballs;
    layer.positions = eyes.mesh.vertices.cast<float>();
    layer.colours = eyes.colours;
    layer.indices.clear();
    for (int t = 0; t < eyes.mesh.triangle_count(); ++t) {
        for (const int v : eyes.mesh.triangles.col(t)) {
            layer.indices.push_back(static_cast<std::uint32_t>(v));
        }
    }
    if (!layer.indices.empty()) {
        layer.normals = vertex_normals(eyes.mesh, Adjacency(eyes.mesh)).cast<float>();
    }
}

/// Teeth of the bone, then the lining.
void FaceScene::make_mouth() {
    SurfaceLayer& layer = scene_.mouth;
    const MouthLining& lining = face_->mouth;
    teeth_.clear();
    layer.indices.clear();
    if (lining.mesh.triangle_count() == 0) {
        return;
    }
    const auto is_tooth = [&](int v) {
        const BonePart part = face_->bone_part[static_cast<std::size_t>(v)];
        return part == BonePart::UpperTeeth || part == BonePart::LowerTeeth;
    };
    std::vector<int> number(static_cast<std::size_t>(face_->bone.vertex_count()), -1);
    for (int v = 0; v < face_->bone.vertex_count(); ++v) {
        if (is_tooth(v)) {
            number[static_cast<std::size_t>(v)] = static_cast<int>(teeth_.size());
            teeth_.push_back(v);
        }
    }
    const auto add = [&](const Eigen::Vector3i& corners) {
        for (const int corner : corners) {
            layer.indices.push_back(static_cast<std::uint32_t>(corner));
        }
    };
    for (int t = 0; t < face_->bone.triangle_count(); ++t) {
        const Eigen::Vector3i v = face_->bone.triangles.col(t);
        if (is_tooth(v[0]) && is_tooth(v[1]) && is_tooth(v[2])) {
            add({number[static_cast<std::size_t>(v[0])], number[static_cast<std::size_t>(v[1])],
                 number[static_cast<std::size_t>(v[2])]});
        }
    }
    const auto teeth = static_cast<int>(teeth_.size());
    for (int t = 0; t < lining.mesh.triangle_count(); ++t) {
        add(lining.mesh.triangles.col(t).array() + teeth);
    }
    layer.colours.resize(3, teeth + lining.mesh.vertex_count());
    const Eigen::VectorXd lit = light_behind_lips(*face_, face_->bone.vertices(Eigen::all, teeth_));
    for (int k = 0; k < teeth; ++k) {
        const double light = std::min(1.0, kAtIncisors * lit[k]);
        layer.colours.col(k) = static_cast<float>(std::pow(light, 1.0 / 2.2)) * kTooth;
    }
    for (int v = 0; v < lining.mesh.vertex_count(); ++v) {
        const auto light = static_cast<float>(std::exp(-2.2 * lining.depth[v]));
        layer.colours.col(teeth + v) = light * Eigen::Vector3f(0.62F, 0.27F, 0.25F);
    }
    lining_adjacency_ = std::make_unique<Adjacency>(lining.mesh);
}

void FaceScene::show_mouth(const TriangleMesh& bone) {
    if (scene_.mouth.indices.empty()) {
        return;
    }
    TriangleMesh lining = face_->mouth.mesh;
    for (int v = 0; v < lining.vertex_count(); ++v) {
        lining.vertices.col(v) =
            opened(face_->jaw, between({}, jaw_, face_->mouth.with_jaw[v]), lining.vertices.col(v));
    }
    const Points normals = vertex_normals(bone, *bone_adjacency_)(Eigen::all, teeth_);
    const Eigen::Index n = normals.cols() + lining.vertices.cols();
    scene_.mouth.positions.resize(3, n);
    scene_.mouth.normals.resize(3, n);
    scene_.mouth.positions << bone.vertices(Eigen::all, teeth_).cast<float>(),
        lining.vertices.cast<float>();
    scene_.mouth.normals << normals.cast<float>(),
        vertex_normals(lining, *lining_adjacency_).cast<float>();
}

void FaceScene::show_bone() {
    TriangleMesh bone = face_->bone;
    for (int v = 0; v < bone.vertex_count(); ++v) {
        const BonePart part = face_->bone_part[static_cast<std::size_t>(v)];
        if (!jaw_.rests() && (part == BonePart::Mandible || part == BonePart::LowerTeeth)) {
            bone.vertices.col(v) = opened(face_->jaw, jaw_, bone.vertices.col(v));
        }
    }
    scene_.bone.positions = bone.vertices.cast<float>();
    scene_.bone.normals = vertex_normals(bone, *bone_adjacency_).cast<float>();
    show_mouth(bone);
}

void FaceScene::show(const SimSnapshot& snapshot) {
    last_nodes_ = snapshot.positions;
    scene_.mouth.lit = static_cast<float>(light_between_lips(*face_, snapshot.positions));
    show_skin(snapshot);
    if (!(snapshot.jaw == jaw_)) {
        jaw_ = snapshot.jaw;
        show_bone();
    }
    if (scene_.muscles.opacity > 0.0F) {
        show_muscles(snapshot.positions);
    }
    if (scene_.springs.opacity > 0.0F) {
        show_springs(snapshot.positions);
    }
    ++scene_.motion;
}

void FaceScene::show_skin(const SimSnapshot& snapshot) {
    const Points& followed = following_->follow(snapshot.positions);
    if (snapshot.wrinkles.map) {
        wrinkle_map_ = snapshot.wrinkles.map;
    }
    if (wrinkle_map_) {
        show_wrinkles(snapshot, followed);
    } else {
        drawing_.move(scene_.skin, followed, following_->touched(), following_->normals());
    }
    if (!(snapshot.jaw == jaw_) && !face_->jaw_vertices.empty()) {
        // Loose parts that hang on the mandible follow no node.
        if (turned_.cols() == 0) {
            turned_ = scan_->mesh.vertices;
            turns_.assign(static_cast<std::size_t>(turned_.cols()), 0);
            for (const int v : face_->jaw_vertices) {
                turns_[static_cast<std::size_t>(v)] = 1;
            }
        }
        for (const int v : face_->jaw_vertices) {
            turned_.col(v) = opened(face_->jaw, snapshot.jaw, scan_->mesh.vertices.col(v));
        }
        drawing_.move(scene_.skin, turned_, turns_);
    }
}

/// Less light reaches the bottom of a furrow.
void FaceScene::shade_wrinkles(const Wrinkles& wrinkles) {
    constexpr float kDeep = 0.9F;  // [mm]
    constexpr float kDark = 0.6F;
    if (rest_folds_.size() != scene_.skin.cavity.size()) {
        rest_folds_ = scene_.skin.cavity;
        shade_ = Eigen::VectorXf::Zero(scan_->mesh.vertices.cols());
    }
    const std::vector<int>& near = wrinkle_map_->vertices;
    const Eigen::VectorXd heights =
        wrinkles.none() ? Eigen::VectorXd::Zero(static_cast<Eigen::Index>(near.size()))
                        : wrinkle_heights(wrinkles);
    for (std::size_t k = 0; k < near.size(); ++k) {
        const auto depth = -static_cast<float>(heights[static_cast<Eigen::Index>(k)]);
        shade_[near[k]] = kDark * std::clamp(depth / kDeep, 0.0F, 1.0F);
    }
    parallel_for(drawing_.drawn_count(), 8192, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const int v = drawing_.scan_vertex(i);
            if (wrinkles_[static_cast<std::size_t>(v)] != 0) {
                scene_.skin.cavity[i] = 1.0F - (1.0F - rest_folds_[i]) * (1.0F - shade_[v]);
            }
        }
    });
}

/// What moved, with its wrinkles. Normals of wrinkled skin are taken from its triangles.
void FaceScene::show_wrinkles(const SimSnapshot& snapshot, const Points& followed) {
    const Wrinkles& wrinkles = snapshot.wrinkles;
    const bool none = wrinkles.none();
    const bool same =
        last_depths_.size() == wrinkles.depth.size() && (none || last_depths_ == wrinkles.depth);
    const bool other = none ? last_depths_.size() > 0 : !same;
    std::vector<char> moved = following_->touched();
    if (wrinkled_.cols() != followed.cols()) {
        wrinkled_ = followed;
    }
    parallel_for(static_cast<int>(followed.cols()), 8192, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            if (moved[static_cast<std::size_t>(v)] != 0) {
                wrinkled_.col(v) = followed.col(v);
            }
        }
    });
    const std::vector<int>& near = wrinkle_map_->vertices;
    wrinkles_.assign(moved.size(), 0);
    for (const int v : near) {
        const auto at = static_cast<std::size_t>(v);
        if (other || (moved[at] != 0 && !none)) {
            wrinkles_[at] = 1;
            moved[at] = 1;
        }
        wrinkled_.col(v) = followed.col(v);
    }
    add_wrinkles(*face_, wrinkles, snapshot.positions, wrinkled_);
    last_depths_ = none ? Eigen::VectorXd() : wrinkles.depth;
    if (other) {
        shade_wrinkles(wrinkles);
    }
    const FloatPoints& normals = following_->normals();
    drawing_.move(scene_.skin, wrinkled_, moved, normals);
    if (normals.cols() > 0) {
        drawing_.move(scene_.skin, wrinkled_, wrinkles_);
    }
}

void FaceScene::show_muscles(const Points& nodes) {
    const bool fresh = scene_.muscles.indices.empty();
    draw_muscles(scene_.muscles, *face_, chains_, nodes);
    if (fresh) {
        ++scene_.topology;
    }
}

void FaceScene::show_springs(const Points& nodes) {
    LineLayer& layer = scene_.springs;
    layer.positions = nodes.cast<float>();
    if (!layer.indices.empty()) {
        return;
    }
    layer.colours.resize(3, nodes.cols());
    layer.colours.colwise() = Eigen::Vector3f(0.42F, 0.50F, 0.60F);
    for (const Spring& spring : springs_) {
        layer.indices.push_back(static_cast<std::uint32_t>(spring.a));
        layer.indices.push_back(static_cast<std::uint32_t>(spring.b));
        for (const int node : {spring.a, spring.b}) {
            if (spring.label.muscle >= 0) {
                int label = spring.label.muscle;
                if (face_->muscles[static_cast<std::size_t>(label)].traits.side == Side::Right) {
                    --label;
                }
                layer.colours.col(node) = label_colour(label);
            }
        }
    }
    ++scene_.topology;
}

void FaceScene::show_loose_parts(bool shown) {
    const std::vector<std::uint32_t>& all = drawing_.indices();
    std::vector<std::uint32_t>& drawn = scene_.skin.indices;
    ++scene_.topology;
    if (shown || scan_->triangle_part.empty()) {
        drawn = all;
        return;
    }
    const int face = face_ ? std::max(face_->skin.part, 0) : 0;
    drawn.clear();
    for (std::size_t t = 0; t < scan_->triangle_part.size(); ++t) {
        if (scan_->triangle_part[t] == face) {
            drawn.insert(drawn.end(), all.begin() + static_cast<std::ptrdiff_t>(3 * t),
                         all.begin() + static_cast<std::ptrdiff_t>(3 * t + 3));
        }
    }
}

void FaceScene::cut_away(double share) {
    // From the patient's left: a sagittal plane that comes in from the side.
    const Vec3 left = face_ ? Vec3(face_->axes.col(0)) : Vec3(Vec3::UnitX());
    double low = 1e30;
    double high = -1e30;
    for (Eigen::Index v = 0; v < scan_->mesh.vertices.cols(); ++v) {
        const double at = left.dot(scan_->mesh.vertices.col(v));
        low = std::min(low, at);
        high = std::max(high, at);
    }
    scene_.cut = share > 0.0;
    scene_.cut_normal = left.cast<float>();
    scene_.cut_offset = static_cast<float>(high + share * (low - high));
}

void FaceScene::set_layers(const LayerOpacity& layers) {
    scene_.skin.opacity = layers.skin;
    scene_.muscles.opacity = face_ ? layers.muscles : 0.0F;
    scene_.bone.opacity = face_ ? layers.bone : 0.0F;
    scene_.mouth.opacity = face_ && layers.skin > 0.0F ? 1.0F : 0.0F;
    scene_.eyes.opacity = scene_.mouth.opacity;
    scene_.springs.opacity = face_ ? layers.springs : 0.0F;
    if (face_ && last_nodes_.cols() > 0) {
        if (layers.muscles > 0.0F) {
            show_muscles(last_nodes_);
        }
        if (layers.springs > 0.0F) {
            show_springs(last_nodes_);
        }
        ++scene_.motion;
    }
}

void FaceScene::tint(const Eigen::Matrix4Xf& of_vertices) {
    Eigen::Matrix4Xf& tint = scene_.skin.tint;
    if (of_vertices.cols() == 0) {
        tint.resize(4, 0);
    } else {
        tint.resize(4, drawing_.drawn_count());
        for (int i = 0; i < drawing_.drawn_count(); ++i) {
            tint.col(i) = of_vertices.col(drawing_.scan_vertex(i));
            tint.col(i).head<3>() *= tint(3, i);  // so that it fades evenly between vertices
        }
    }
    ++scene_.tint_version;
}

void FaceScene::set_visibility(const Eigen::Matrix4Xf& of_vertices) {
    visibility_ = of_vertices;
    show_visibility();
}

void FaceScene::show_visibility() {
    Eigen::Matrix4Xf& drawn = scene_.skin.visibility;
    if (visibility_.cols() == 0) {
        drawn.resize(4, 0);
    } else {
        Eigen::Matrix4Xf lit = visibility_;
        if (face_) {
            light_the_mouth(*face_, lit);
        }
        drawn.resize(4, drawing_.drawn_count());
        for (int i = 0; i < drawing_.drawn_count(); ++i) {
            drawn.col(i) = lit.col(drawing_.scan_vertex(i));
        }
    }
    ++scene_.shade_version;
}

void FaceScene::shade() {
    set_visibility(light_visibility(scan_->mesh));
}

std::function<std::unique_ptr<SceneData>()> FaceScene::still(const Points& nodes,
                                                             const JawPose& jaw,
                                                             const Wrinkles& wrinkles) const {
    return [scan = scan_, texture = texture_, face = face_, nodes, jaw, wrinkles,
            shown = scene_.skin.indices,  // loose parts as they are shown
            visibility = scene_.skin.visibility] {
        FaceScene other(scan, texture);
        other.set_face(face, {}, {});
        SimSnapshot snapshot;
        snapshot.positions = nodes;
        snapshot.jaw = jaw;
        snapshot.wrinkles = wrinkles;
        other.show(snapshot);
        other.scene_.skin.indices = shown;
        other.scene_.skin.visibility = visibility;
        return std::make_unique<SceneData>(std::move(other.scene_));
    };
}

void FaceScene::tint_change(const Points& before, const Points& now, double most) {
    const TriangleMesh& skin = face_->skin.mesh;
    const Eigen::Index n = skin.vertices.cols();
    const Points normals = vertex_normals({before.leftCols(n), skin.triangles}, *face_->adjacency);
    Eigen::Matrix4Xf tint(4, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        tint.col(i) = signed_tint((now.col(i) - before.col(i)).dot(normals.col(i)) / most);
    }
    tint_nodes(tint);
}

void FaceScene::tint_nodes(const Eigen::Matrix4Xf& of_nodes) {
    if (!face_ || of_nodes.cols() == 0) {
        tint({});
        return;
    }
    const SimulatedSkin& skin = face_->skin;
    Eigen::Matrix4Xf of_vertices = Eigen::Matrix4Xf::Zero(4, skin.between.cols());
    Eigen::Matrix4Xf even = of_nodes;
    even.topRows<3>().array().rowwise() *= of_nodes.row(3).array();
    for (Eigen::Index v = 0; v < skin.between.cols(); ++v) {
        for (int k = 0; k < 3 && skin.between(k, v) >= 0; ++k) {
            const bool alone = skin.between(1, v) < 0;
            of_vertices.col(v) += (alone ? 1.0F : skin.shares(k, v)) * even.col(skin.between(k, v));
        }
        of_vertices.col(v).head<3>() /= std::max(of_vertices(3, v), 1e-6F);
    }
    tint(of_vertices);
}

}  // namespace myoface
