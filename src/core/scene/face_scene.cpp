// SPDX-License-Identifier: Apache-2.0
#include "myoface/scene/face_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "myoface/mesh/normals.h"
#include "myoface/scene/colour_map.h"

namespace myoface {
namespace {

constexpr int kSides = 10;              // of a fibre bundle
constexpr int kPerPart = 4;             // rings per part of a chain
constexpr double kHalfThickness = 0.9;  // of a bundle [mm]

/// Catmull-Rom through the chain's nodes.
std::vector<Vec3> smooth_line(const std::vector<Vec3>& through, bool closed) {
    const auto n = static_cast<int>(through.size());
    const auto at = [&](int i) -> const Vec3& {
        return through[static_cast<std::size_t>(closed ? (i % n + n) % n
                                                       : std::clamp(i, 0, n - 1))];
    };
    std::vector<Vec3> line;
    const int spans = closed ? n : n - 1;
    for (int span = 0; span < spans; ++span) {
        for (int k = 0; k < kPerPart; ++k) {
            const double t = static_cast<double>(k) / kPerPart;
            line.push_back(
                0.5 *
                (2.0 * at(span) + t * (at(span + 1) - at(span - 1)) +
                 t * t * (2.0 * at(span - 1) - 5.0 * at(span) + 4.0 * at(span + 1) - at(span + 2)) +
                 t * t * t * (3.0 * at(span) - at(span - 1) - 3.0 * at(span + 1) + at(span + 2))));
        }
    }
    if (!closed) {
        line.push_back(through.back());
    }
    return line;
}

/// A flat bundle of fibres along a line: broad along the face, thin across.
void append_bundle(std::vector<Vec3>& positions, std::vector<std::uint32_t>* indices,
                   const std::vector<Vec3>& line, const std::vector<Vec3>& outward, bool closed,
                   double breadth, double thickness) {
    const auto n = static_cast<int>(line.size());
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (int i = 0; i < n; ++i) {
        const Vec3& before =
            line[static_cast<std::size_t>(closed ? (i + n - 1) % n : std::max(i - 1, 0))];
        const Vec3& after =
            line[static_cast<std::size_t>(closed ? (i + 1) % n : std::min(i + 1, n - 1))];
        const Vec3 along = (after - before).normalized();
        const Vec3 broad = along.cross(outward[static_cast<std::size_t>(i)]).normalized();
        const Vec3 thin = broad.cross(along);
        const double t = static_cast<double>(i) / (n - 1);
        const double belly =
            closed ? 1.0
                   : 0.45 + 0.55 * std::pow(std::sin(std::numbers::pi * (0.08 + 0.84 * t)), 0.7);
        for (int k = 0; k < kSides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kSides;
            positions.push_back(
                line[static_cast<std::size_t>(i)] +
                belly * (breadth * std::cos(angle) * broad + thickness * std::sin(angle) * thin));
        }
    }
    if (indices == nullptr) {
        return;
    }
    const int rings = closed ? n : n - 1;
    for (int i = 0; i < rings; ++i) {
        for (int k = 0; k < kSides; ++k) {
            const auto a = first + static_cast<std::uint32_t>(i * kSides + k);
            const auto b = first + static_cast<std::uint32_t>(i * kSides + (k + 1) % kSides);
            const auto c = first + static_cast<std::uint32_t>((i + 1) % n * kSides + k);
            const auto d =
                first + static_cast<std::uint32_t>((i + 1) % n * kSides + (k + 1) % kSides);
            indices->insert(indices->end(), {a, b, c, b, d, c});
        }
    }
}

FloatPoints as_floats(const std::vector<Vec3>& points) {
    FloatPoints result(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.col(static_cast<Eigen::Index>(i)) = points[i].cast<float>();
    }
    return result;
}

FloatPoints normals_of(const FloatPoints& positions, const std::vector<std::uint32_t>& indices) {
    FloatPoints normals = FloatPoints::Zero(3, positions.cols());
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Eigen::Vector3f a = positions.col(indices[i]);
        const Eigen::Vector3f n =
            (positions.col(indices[i + 1]) - a).cross(positions.col(indices[i + 2]) - a);
        for (std::size_t c = 0; c < 3; ++c) {
            normals.col(indices[i + c]) += n;
        }
    }
    for (Eigen::Index i = 0; i < normals.cols(); ++i) {
        normals.col(i).normalize();
    }
    return normals;
}

}  // namespace

FaceScene::FaceScene(std::shared_ptr<const Scan> scan, std::shared_ptr<const SkinTexture> texture)
    : scan_(std::move(scan)), texture_(std::move(texture)), drawing_(*scan_) {
    drawing_.fill(scene_.skin, *scan_, texture_.get());
    scene_.skin.texture = picture();
    own_colours_ = scene_.skin.colours;
    const Points& v = scan_->mesh.vertices;
    scene_.centre = 0.5 * (v.rowwise().maxCoeff() + v.rowwise().minCoeff());
    scene_.radius = 0.5 * (v.rowwise().maxCoeff() - v.rowwise().minCoeff()).norm();
    scene_.bone.plain_colour = {0.87F, 0.84F, 0.76F};
    scene_.bone.softness = 0.15F;
    scene_.bone.gloss = 0.12F;
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
    const TriangleMesh& bone = face_->bone;
    SurfaceLayer& layer = scene_.bone;
    layer.positions = bone.vertices.cast<float>();
    layer.indices.clear();
    for (int t = 0; t < bone.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) {
            layer.indices.push_back(static_cast<std::uint32_t>(bone.triangles(c, t)));
        }
    }
    const Adjacency adjacency(bone);
    layer.normals = vertex_normals(bone, adjacency).cast<float>();
    ++scene_.topology;
}

void FaceScene::show(const SimSnapshot& snapshot) {
    last_nodes_ = snapshot.positions;
    drawing_.move(scene_.skin, scan_positions(*face_, snapshot.positions));
    if (scene_.muscles.opacity > 0.0F) {
        show_muscles(snapshot.positions);
    }
    if (scene_.springs.opacity > 0.0F) {
        show_springs(snapshot.positions);
    }
    ++scene_.motion;
}

void FaceScene::show_muscles(const Points& nodes) {
    std::vector<Vec3> positions;
    std::vector<std::uint32_t> indices;
    SurfaceLayer& layer = scene_.muscles;
    const bool fresh = layer.indices.empty();
    std::vector<Vec3> colours;
    for (std::size_t m = 0; m < chains_.size(); ++m) {
        const Muscle& muscle = face_->muscles[m];
        const MuscleChain& chain = chains_[m];
        const bool ring = muscle.traits.kind == MuscleKind::Sphincter;
        std::vector<Vec3> through;
        double length = 0.0;
        for (int k = 0; k < chain.node_count; ++k) {
            through.emplace_back(nodes.col(chain.first_node + k));
            if (k > 0) {
                length += (through.back() - through[through.size() - 2]).norm();
            }
        }
        // A bundle that shortens keeps its volume.
        const double bulge = std::sqrt(std::clamp(muscle.length / std::max(length, 1.0), 0.6, 2.5));
        std::vector<Vec3> outward;
        for (int k = 0; k < chain.node_count; ++k) {
            outward.emplace_back(muscle.outward.col(k));
        }
        const std::size_t first = positions.size();
        append_bundle(positions, fresh ? &indices : nullptr, smooth_line(through, ring),
                      smooth_line(outward, ring), ring, bulge * 0.5 * muscle.traits.breadth,
                      bulge * kHalfThickness);
        if (fresh) {
            // Left and right of a pair share their colour.
            int label = static_cast<int>(m);
            if (muscle.traits.side == Side::Right) {
                --label;
            }
            const Vec3 base =
                0.72 * Vec3(0.70, 0.22, 0.19) + 0.28 * label_colour(label).cast<double>();
            colours.resize(positions.size());
            std::fill(colours.begin() + static_cast<std::ptrdiff_t>(first), colours.end(), base);
        }
    }
    layer.positions = as_floats(positions);
    if (fresh) {
        layer.indices = std::move(indices);
        layer.colours = as_floats(colours);
        ++scene_.topology;
    }
    layer.normals = normals_of(layer.positions, layer.indices);
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
    const int face =
        face_ && !face_->skin.of_triangle.empty()
            ? scan_->triangle_part[static_cast<std::size_t>(face_->skin.of_triangle.front())]
            : 0;
    drawn.clear();
    for (std::size_t t = 0; t < scan_->triangle_part.size(); ++t) {
        if (scan_->triangle_part[t] == face) {
            drawn.insert(drawn.end(), all.begin() + static_cast<std::ptrdiff_t>(3 * t),
                         all.begin() + static_cast<std::ptrdiff_t>(3 * t + 3));
        }
    }
}

void FaceScene::set_layers(const LayerOpacity& layers) {
    scene_.skin.opacity = layers.skin;
    scene_.muscles.opacity = face_ ? layers.muscles : 0.0F;
    scene_.bone.opacity = face_ ? layers.bone : 0.0F;
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

void FaceScene::paint(const std::vector<double>& values) {
    SurfaceLayer& skin = scene_.skin;
    if (values.empty()) {
        skin.colours = own_colours_;
        skin.texture = picture();
    } else {
        skin.texture = nullptr;
        skin.colours.resize(3, drawing_.drawn_count());
        for (int i = 0; i < drawing_.drawn_count(); ++i) {
            skin.colours.col(i) =
                colour_map(values[static_cast<std::size_t>(drawing_.scan_vertex(i))]);
        }
    }
    ++scene_.topology;
}

}  // namespace myoface
