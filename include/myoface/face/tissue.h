// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "myoface/base/points.h"

namespace myoface {

/// Aesthetic unit of a skin node.
enum class Region {
    Forehead,
    Glabella,
    Brow,
    UpperLid,
    LowerLid,
    Temple,
    NoseDorsum,
    NoseSidewall,
    NoseTip,
    NoseAla,
    Columella,
    Cheek,
    UpperLip,
    LowerLip,
    Chin,
    Jaw,
    Ear,
    Neck,
    Scalp
};
std::string region_name(Region region, bool japanese = false);
bool is_lid(Region region);

/// Kind of tissue of a mass point or link.
enum class Tissue { Skin, Mucosa, Cartilage, Muscle, Bone, Other };

/// What a mass point or a link is: the paper's label. For skin, `muscle` is the muscle under it.
struct TissueLabel {
    Tissue tissue = Tissue::Skin;
    int muscle = -1;  ///< index into FaceModel::muscles, -1 none

    bool operator==(const TissueLabel&) const = default;
};

/// What the tissue is like under one skin node.
struct TissueProperties {
    Region region = Region::Cheek;
    Tissue tissue = Tissue::Skin;
    double depth = 10.0;         ///< skin to bone (lids: to the eyeball) [mm]
    double thickness = 1.5;      ///< of the skin itself [mm]
    double skin_share = 1.0;     ///< of the skin's E·h: thin on lids and lips
    double bone_tie = 1.0;       ///< the paper's mass: how firmly the skin is held sideways
    double strain_limit = 0.25;  ///< stretch at which the skin's capacity is used up
    bool fixed = false;          ///< far behind or below the face: does not move
};

/// Tissue at a place of the average head. @param p generic coordinates [mm]
/// @param faces_inward an inner surface: nostril, inner lip, mouth bag
TissueProperties tissue_at(const Vec3& p, double depth, bool faces_inward);

/// How far a place moves with the mandible: 1 chin and lower lip, 0 upper lip and brow, smooth over
/// the cheek and down the neck. @param p generic coordinates [mm] @param lip_side as in
/// upper_lip_share()
double jaw_share(const Vec3& p, int lip_side = 0);

/// Where the lids are: heights of both margins at a place's distance from the midline, and how far
/// the place follows each of them, 1 at the margin.
struct LidPlace {
    double upper = 0.0, lower = 0.0;  ///< y of the margins [mm]
    double around = 0.0;              ///< 0 … 1: next to the lids, beyond where they move
    double with_upper = 0.0, with_lower = 0.0;  ///< 0 … 1
    double from_corner = 0.0;  ///< across, from the nearer corner of the eye [mm]; 0 beyond
};
LidPlace lid_place(const Vec3& p);
/// Centre of the average head's eyeball, left.
Vec3 generic_eye_centre();
/// Radius of its eyeballs [mm].
double generic_eye_radius();

/// Does a surface point look into the head: mouth bag, nostril, eye socket?
/// @param p generic coordinates [mm] @param normal outward normal in generic axes
bool looks_inward(const Vec3& p, const Vec3& normal);

/// Above the line where the lips meet? 1 upper, 0 lower, smooth over `softness` mm; 0.5 sideways of
/// the mouth corners means that both lips' muscles act.
/// @param side 1 or -1 where a slit tells the lips apart, 0 where only the height does
double upper_lip_share(const Vec3& p, double softness, int side = 0);

/// How much soft tissue lies over the bone, beside the mean of the tables.
enum class TissueThickness : std::uint8_t { Thin, Mean, Heavy };
/// "thin", "mean", "heavy". @throws InvalidInput
TissueThickness tissue_thickness(const std::string& name);
const char* thickness_name(TissueThickness thickness);

/// Depth over the mean depth where the mean is `depth` mm: fat makes the difference in the cheeks,
/// the forehead is nearly the same in everybody. The spread, 15 % over thin tissue to 35 % in the
/// cheeks, follows the size of the standard deviations in forensic tables, of which only the means
/// are at hand: assumed.
double thickness_factor(TissueThickness thickness, double depth);

/// Soft-tissue depth [mm] at places of the average head, from the table of sites in assets/.
/// @throws IoError when the program's own table is damaged
Eigen::VectorXd tissue_depths(const Points& generic,
                              TissueThickness thickness = TissueThickness::Mean);

}  // namespace myoface
