// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "myoface/scene/scene_builder.h"
#include "myoface/sim/snapshot.h"

namespace myoface {

/// Opacity of each layer, 0 … 1.
struct LayerOpacity {
    float skin = 1.0F, muscles = 0.0F, bone = 0.0F, springs = 0.0F;
};

/// The picture of one face: skin, muscles as fibre bundles, bone, spring network. Works for a scan
/// that has not been fitted too (skin only).
class FaceScene {
public:
    FaceScene(std::shared_ptr<const Scan> scan, std::shared_ptr<const SkinTexture> texture);

    /// Adds muscles, bone and springs.
    void set_face(std::shared_ptr<const FaceModel> face, const std::vector<Spring>& springs,
                  const std::vector<MuscleChain>& chains);
    /// Moves everything to a moment of the simulation.
    void show(const SimSnapshot& snapshot);
    void set_layers(const LayerOpacity& layers);
    /// Takes the skin away from the patient's left side on. @param share 0 nothing … 1 all of it
    void cut_away(double share);
    /// Covers the skin with colours, 4×vertices of the scan: red, green, blue and how much they
    /// cover; 4×0: its own look.
    void tint(const Eigen::Matrix4Xf& of_vertices);
    /// The same from colours per skin node.
    void tint_nodes(const Eigen::Matrix4Xf& of_nodes);

    /// Soft shadows of the face on itself. @param of_vertices of light_visibility() of the scan
    void set_visibility(const Eigen::Matrix4Xf& of_vertices);
    /// The same, computed here: for pictures. Takes half a second.
    void shade();

    /// Draws the parts of the scan beside the one that holds the face, or leaves them out.
    void show_loose_parts(bool shown);

    /// Makes the skin at another moment, as a picture that stays; may run in another thread while
    /// this scene goes on or is gone. @param nodes 3×nodes [mm]
    std::function<std::unique_ptr<SceneData>()> still(const Points& nodes, const JawPose& jaw,
                                                      const Wrinkles& wrinkles = {}) const;
    /// Paints how far the skin has come out (orange) or gone in (blue) since `before`, along its
    /// normal there, up to `most` mm. @param before, now 3×nodes, the skin's first
    void tint_change(const Points& before, const Points& now, double most);

    const SceneData& scene() const { return scene_; }
    SceneData& scene() { return scene_; }

private:
    std::shared_ptr<const Image> picture() const;
    void show_skin(const SimSnapshot& snapshot);
    void show_wrinkles(const SimSnapshot& snapshot, const Points& followed);
    void shade_wrinkles(const Wrinkles& wrinkles);
    void show_bone();
    void make_mouth();
    void make_eyes();
    void show_visibility();
    void show_mouth(const TriangleMesh& bone);
    void show_muscles(const Points& nodes);
    void show_springs(const Points& nodes);

    std::shared_ptr<const Scan> scan_;
    std::shared_ptr<const SkinTexture> texture_;
    std::shared_ptr<const FaceModel> face_;
    std::vector<Spring> springs_;
    std::vector<MuscleChain> chains_;
    SkinDrawing drawing_;
    std::unique_ptr<FollowingScan> following_;
    FloatPoints rest_normals_;     ///< 3×vertices of the scan
    Eigen::Matrix4Xf visibility_;  ///< per vertex of the scan, as it was given
    Points last_nodes_;
    Points turned_;            ///< 3×vertices: loose parts where the mandible has them
    std::vector<char> turns_;  ///< per vertex: such a part
    std::unique_ptr<const Adjacency> bone_adjacency_;
    std::unique_ptr<const Adjacency> lining_adjacency_;
    std::vector<int> teeth_;  ///< bone vertices of the mouth layer; the lining's follow
    JawPose jaw_;
    std::shared_ptr<const WrinkleMap> wrinkle_map_;
    Points wrinkled_;              ///< 3×vertices with their wrinkles
    std::vector<char> wrinkles_;   ///< per vertex: moved by wrinkles
    Eigen::VectorXf rest_folds_;   ///< per drawn vertex: its cavity without wrinkles
    Eigen::VectorXf shade_;        ///< per vertex: how deep in a furrow, 0 … 1
    Eigen::VectorXd last_depths_;  ///< of the wrinkles that are shown
    SceneData scene_;
};

}  // namespace myoface
