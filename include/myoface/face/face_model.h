// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "myoface/base/progress.h"
#include "myoface/face/landmarks.h"
#include "myoface/face/muscle_atlas.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/face/tissue.h"
#include "myoface/io/scan.h"
#include "myoface/mesh/adjacency.h"
#include "myoface/mesh/weld.h"

namespace myoface {

/// A muscle on one face. Points in our frame [mm].
struct Muscle {
    MuscleTraits traits;
    Points path;                ///< 3×P: linear: bone end … skin end; sphincter: closed ring
    Points outward;             ///< 3×P: normal of the face over each point
    double length = 0.0;        ///< of a linear muscle's path, or around a ring
    Vec3 axis = Vec3::UnitZ();  ///< sphincter: normal of the ring, out of the face
    Vec3 wide = Vec3::UnitX();  ///< sphincter: direction of the longer semi-axis
    double half_width = 0.0, half_height = 0.0;
    Vec3 centre = Vec3::Zero();
};

/// How the smoothed face curves around a node, for sliding on the bone:
/// height(δ) = n·δ + ½ δᵀ Q δ.
struct SlidingSurface {
    Vec3 normal = Vec3::UnitZ();
    Mat3 curvature = Mat3::Zero();  ///< Q, symmetric, tangential [1/mm]
};

/// Everything about one face that does not change while it is simulated: anatomy on the scan.
/// "Skin node" means a vertex of skin.mesh: the scan's main part with seams welded.
struct FaceModel {
    std::shared_ptr<const Scan> scan;
    WeldedMesh skin;
    std::shared_ptr<const Adjacency> adjacency;
    Landmarks landmarks;
    Similarity to_generic;                 ///< scan -> size and pose of the average head
    Points generic;                        ///< skin node -> coordinates on the average head
    Eigen::VectorXd area;                  ///< per skin node [mm²]
    std::vector<TissueProperties> tissue;  ///< per skin node
    std::vector<SlidingSurface> sliding;   ///< per skin node
    std::vector<TissueLabel> label;        ///< per skin node
    std::vector<Muscle> muscles;           ///< in the atlas' order
    TriangleMesh bone;                     ///< for show and for placing muscle ends
    std::vector<std::pair<int, int>> lip_contacts;  ///< upper and lower node that touch
    Mat3 axes = Mat3::Identity();                   ///< columns: the face's left, up and front

    int node_count() const { return skin.mesh.vertex_count(); }
};

/// Puts atlas, bone, regions and labels on a scan from landmarks: similarity, then a smooth warp of
/// the average head; muscle ends are put onto bone and skin.
/// @throws InvalidInput when landmarks are too few, not near the scan, mirrored, or do not look
/// like
///         a face
std::shared_ptr<const FaceModel> fit_face(std::shared_ptr<const Scan> scan,
                                          const Landmarks& landmarks,
                                          const Progress* progress = nullptr);

/// Unit and axes of a scan as its landmarks imply them: the quarter turns nearest to the pose of
/// the face and, where `mm_per_unit` is not known, the unit (snapped to a usual one within 20 %).
/// Positions in `landmarks` are in the file's unit and axes.
/// @throws InvalidInput as fit_face
FileFrame frame_from_landmarks(const LandmarkFile& landmarks, std::optional<double> mm_per_unit,
                               std::optional<Mat3> axes);

/// Muscle paths as JSON {"unit", "muscles": {name: {"kind", "points"}}} in the scan's own frame.
std::string muscles_to_json(const FaceModel& face);

}  // namespace myoface
