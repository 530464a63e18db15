// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "myoface/base/progress.h"
#include "myoface/face/landmarks.h"
#include "myoface/face/midplane.h"
#include "myoface/face/muscle_atlas.h"
#include "myoface/face/obstacle.h"
#include "myoface/face/simulated_skin.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/face/tissue.h"
#include "myoface/io/scan.h"
#include "myoface/mesh/adjacency.h"

namespace myoface {

/// A muscle on one face. Points in our frame [mm].
struct Muscle {
    MuscleTraits traits;
    Points path;     ///< 3×P: bone end … skin end; sphincter: closed ring; sheet: middle fibre
    Points outward;  ///< 3×P: normal of the face over each point
    std::vector<Points> fibres;  ///< of sheets and volumes: 3×P each, from one edge to the other
    double length = 0.0;         ///< of a linear muscle's path, or around a ring
    Vec3 axis = Vec3::UnitZ();   ///< sphincter: normal of the ring, out of the face
    Vec3 wide = Vec3::UnitX();   ///< sphincter: direction of the longer semi-axis
    double half_width = 0.0, half_height = 0.0;
    Vec3 centre = Vec3::Zero();
};

/// A muscle under a skin node.
struct MuscleWeight {
    int muscle = -1;
    double weight = 0.0;
};

/// How the smoothed face curves around a node, for sliding on the bone:
/// height(δ) = n·δ + ½ δᵀ Q δ.
struct SlidingSurface {
    Vec3 normal = Vec3::UnitZ();
    Mat3 curvature = Mat3::Zero();  ///< Q, symmetric, tangential [1/mm]
};

enum class BonePart : std::uint8_t { Cranium, Mandible, UpperTeeth, LowerTeeth };

/// How the jaw opens: a turn about the axis through both condyles, which slide forward and down
/// along the slope of the joint meanwhile. @cite posselt_1957
struct JawHinge {
    Vec3 centre = Vec3::Zero();  ///< midway between the condyles [mm]
    Vec3 axis = Vec3::UnitX();   ///< unit, to the patient's left
    Vec3 slide = Vec3::Zero();   ///< of the condyles at full opening [mm]
    double full_opening = 0.0;   ///< turn at full opening [rad]
    Vec3 front = Vec3::UnitZ();  ///< unit, out of the face
    double full_thrust = 6.0;    ///< [mm]
    double full_turn = 0.09;     ///< about a condyle: some 8 mm at the chin [rad]
    double to_condyle = 45.0;    ///< from the midline [mm]
};

/// Where the mandible is: shares of its full ways, 0 at rest.
struct JawPose {
    double open = 0.0;
    double thrust = 0.0;  ///< forward, 0 … 1
    double left = 0.0;    ///< the chin to the patient's left, −1 … 1

    JawPose() = default;
    JawPose(double opening) : open(opening) {}  // a jaw that only opens
    bool rests() const { return open == 0.0 && thrust == 0.0 && left == 0.0; }
    bool operator==(const JawPose&) const = default;
};
/// On the way from one pose to another.
JawPose between(const JawPose& from, const JawPose& to, double share);

/// A place of the mandible: it opens, then goes forward, then turns about the condyle of the side
/// that the chin goes to.
Vec3 opened(const JawHinge& hinge, const JawPose& pose, const Vec3& p);

/// The inside of a mouth: many scans have none.
struct MouthLining {
    TriangleMesh mesh;         ///< nothing where the scan has its own
    Eigen::VectorXd with_jaw;  ///< per vertex: how far it goes with the mandible, 0 … 1
    Eigen::VectorXd depth;     ///< per vertex: 0 at the lips … 1 at the throat
};

/// What a scanner did not see between open lids.
struct Eyeballs {
    TriangleMesh mesh;         ///< nothing where the scan has its own
    Eigen::Matrix3Xf colours;  ///< per vertex, sRGB 0 … 1
};

/// Everything about one face that does not change while it is simulated: anatomy on the scan.
struct FaceModel {
    /// The scan as it came, or with its lips parted: then the file's vertices first and in order.
    std::shared_ptr<const Scan> scan;
    SimulatedSkin skin;
    std::shared_ptr<const Adjacency> adjacency;
    Landmarks landmarks;
    Similarity to_generic;                 ///< scan -> size and pose of the average head
    Points generic;                        ///< skin node -> coordinates on the average head
    SmoothWarp from_generic;               ///< average head -> this one in its pose
    Eigen::VectorXd area;                  ///< per skin node [mm²]
    std::vector<TissueProperties> tissue;  ///< per skin node
    std::vector<SlidingSurface> sliding;   ///< per skin node
    std::vector<TissueLabel> label;        ///< per skin node
    /// Per skin node: the muscles under it with weights that sum to 1, the strongest first.
    std::vector<std::vector<MuscleWeight>> muscles_under;
    Points eyes;                      ///< 3×2: centres of the left and right eyeball [mm]
    std::vector<int> jaw_vertices;    ///< of the scan: loose parts that hang on the mandible
    std::vector<Muscle> muscles;      ///< in the atlas' order
    TriangleMesh bone;                ///< skull and mandible with their teeth
    std::vector<BonePart> bone_part;  ///< per bone vertex
    JawHinge jaw;
    std::vector<Obstacle> obstacles;    ///< what skin cannot enter
    Eigen::VectorXd obstacle_distance;  ///< per skin node: of the nearest one, at rest [mm]
    MouthLining mouth;
    Eyeballs eyeballs;
    std::vector<std::pair<int, int>> lip_contacts;  ///< upper and lower node that touch
    /// Per skin node: 1 upper lip, -1 lower lip, 0 elsewhere, or everywhere where lips are fused.
    std::vector<signed char> lip_side;
    /// Vertices and skin nodes that the scan came with; those of margins that were parted follow.
    int own_vertices = 0, own_nodes = 0;
    Mat3 axes = Mat3::Identity();  ///< columns: the face's left, up and front
    Midplane midplane;

    int node_count() const { return skin.mesh.vertex_count(); }
};

struct FitOptions {
    /// Of a scan with more vertices a coarser skin is simulated, and the scan follows it.
    int finest = 40000;
    TissueThickness tissue = TissueThickness::Mean;
};

/// Puts atlas, bone, regions and labels on a scan from landmarks: similarity, a smooth warp of the
/// average head through the landmarks, then its front bent onto the scan between them; muscle ends
/// are put onto bone and skin. The scan stays as it is. @cite amberg_2007
/// @throws InvalidInput when landmarks are too few, not near the scan, mirrored, or do not look
/// like
///         a face
std::shared_ptr<const FaceModel> fit_face(std::shared_ptr<const Scan> scan,
                                          const Landmarks& landmarks,
                                          const Progress* progress = nullptr,
                                          const FitOptions& options = {});

/// Where a place of the average head lies on this one [mm].
Vec3 from_generic(const FaceModel& face, const Vec3& p);

/// How a reshaped skin moves the vertices that the scan came with: 3×own_vertices, or 3×0 where
/// nothing moved. Independent of which of them are nodes. @param skin 3×skin nodes
Points shape_of_scan(const FaceModel& face, const Points& skin);
/// The skin nodes of a face that was reshaped so. @throws InvalidInput when it is another scan's
Points shaped_skin(const FaceModel& face, const Points& shape);

/// Builds what every fit needs of the average head, once per process, beside the caller: about a
/// second of work that opening a scan need not wait for.
/// @return to be kept until the fit is made; it waits for the work where it goes out of scope, so
/// that a process never ends while the work still goes on
[[nodiscard]] std::future<void> prepare_fitting();

/// Unit and axes of a scan as its landmarks imply them: the quarter turns nearest to the pose of
/// the face and, where `mm_per_unit` is not known, the unit (snapped to a usual one within 20 %).
/// Positions in `landmarks` are in the file's unit and axes.
/// @throws InvalidInput as fit_face
FileFrame frame_from_landmarks(const LandmarkFile& landmarks, std::optional<double> mm_per_unit,
                               std::optional<Mat3> axes);

/// Muscle paths as JSON {"unit", "muscles": {name: {"kind", "points"}}} in the scan's own frame.
std::string muscles_to_json(const FaceModel& face);

}  // namespace myoface
