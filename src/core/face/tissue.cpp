// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/tissue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "myoface/base/error.h"
#include "myoface/base/smooth_step.h"
#include "myoface/face/smooth_warp.h"

#include "head/head_mesh.h"
#include "head/skull.h"

namespace myoface {
namespace {

double mixed(double a, double b, double share) {
    return a + share * (b - a);
}

/// 1 at the lip margins, falling to 0 about 20 mm away.
double near_lips(double x, double y, double z) {
    const double rho = std::hypot(x / 29.0, (y + 52.0) / 12.0);
    return (1.0 - smooth_step(0.75, 2.2, rho)) * smooth_step(45.0, 65.0, z);
}

/// 1 on the lids, 0 outside the orbit.
double near_lids(double x, double y, double z) {
    const double rho = std::hypot((x - 30.0) / 15.0, (y - 17.0) / 7.0);
    return (1.0 - smooth_step(1.0, 2.3, rho)) * smooth_step(45.0, 60.0, z);
}

Region region_at(double x, double y, double z) {
    if (x > 63.0 && (Vec3(x, y, z) - Vec3(76, 3, -18)).norm() < 36.0) {
        return Region::Ear;
    }
    if (y < -70.0 - 0.42 * (z - 10.0) || y < -108.0) {
        return Region::Neck;
    }
    const double hairline =
        z > 0.0 ? 90.0 - 0.45 * std::max(0.0, x - 34.0) - 0.4 * std::max(0.0, 45.0 - z) : 30.0;
    if (y > hairline || z < -20.0) {
        return Region::Scalp;
    }
    if (z > 45.0 && std::hypot((x - 30.0) / 19.0, (y - 18.0) / 10.0) < 1.0) {
        const double middle = 0.5 * (average_head().upper_lid(x) + average_head().lower_lid(x));
        return y > middle ? Region::UpperLid : Region::LowerLid;
    }
    if (z > 75.0 && y > -32.0 && y < 26.0 && x < 9.0 + 0.2 * (20.0 - y)) {
        if (y < -8.0) {
            if (x > 9.5) {
                return Region::NoseAla;
            }
            return x < 4.5 && y < -22.0 ? Region::Columella : Region::NoseTip;
        }
        return x < 6.0 ? Region::NoseDorsum : Region::NoseSidewall;
    }
    if (y >= 46.0 || (y >= 26.0 && x > 54.0)) {
        return x > 52.0 ? Region::Temple : Region::Forehead;
    }
    if (y >= 26.0) {
        return x < 10.0 ? Region::Glabella : Region::Brow;
    }
    if (x > 52.0 && y > 4.0) {
        return Region::Temple;
    }
    if (z > 55.0 && y < -28.0 && x < 29.0 + 0.1 * (y + 52.0) && y > -52.0) {
        return Region::UpperLip;
    }
    if (z > 55.0 && y <= -52.0 && y > -68.0 && x < 28.0) {
        return Region::LowerLip;
    }
    if (z > 45.0 && y <= -66.0 && x < 26.0) {
        return Region::Chin;
    }
    if (y < -55.0) {
        return Region::Jaw;
    }
    return Region::Cheek;
}

/// What a region's skin is like. Limits of stretch as a simulator of skin flaps uses them;
/// thickness (epidermis and dermis) rounded after @cite chopra_2015; both recalled, not read off
/// tables.
struct RegionSkin {
    Region region;
    const char* name;
    const char* name_ja;
    double strain_limit;
    double thickness;  ///< [mm]
};
constexpr std::array<RegionSkin, 19> kRegions{{
    {Region::Forehead, "forehead", "額", 0.12, 1.7},
    {Region::Glabella, "glabella", "眉間", 0.12, 1.8},
    {Region::Brow, "brow", "眉", 0.12, 1.9},
    {Region::UpperLid, "upper lid", "上まぶた", 0.40, 0.8},
    {Region::LowerLid, "lower lid", "下まぶた", 0.40, 0.9},
    {Region::Temple, "temple", "こめかみ", 0.15, 1.4},
    {Region::NoseDorsum, "nose dorsum", "鼻背", 0.06, 1.4},
    {Region::NoseSidewall, "nose sidewall", "鼻側壁", 0.06, 1.9},
    {Region::NoseTip, "nose tip", "鼻尖", 0.06, 2.2},
    {Region::NoseAla, "nose ala", "鼻翼", 0.06, 2.2},
    {Region::Columella, "columella", "鼻柱", 0.06, 1.5},
    {Region::Cheek, "cheek", "頬", 0.25, 1.9},
    {Region::UpperLip, "upper lip", "上唇", 0.75, 1.6},
    {Region::LowerLip, "lower lip", "下唇", 0.75, 1.6},
    {Region::Chin, "chin", "オトガイ", 0.15, 1.9},
    {Region::Jaw, "jaw line", "フェイスライン", 0.15, 1.8},
    {Region::Ear, "ear", "耳", 0.25, 1.2},
    {Region::Neck, "neck", "頸部", 0.25, 1.5},
    {Region::Scalp, "scalp", "頭皮", 0.12, 2.2},
}};

const RegionSkin& skin_of(Region region) {
    return *std::find_if(kRegions.begin(), kRegions.end(),
                         [&](const RegionSkin& r) { return r.region == region; });
}

}  // namespace

std::string region_name(Region region, bool japanese) {
    return japanese ? skin_of(region).name_ja : skin_of(region).name;
}

bool is_lid(Region region) {
    return region == Region::UpperLid || region == Region::LowerLid;
}

double jaw_share(const Vec3& p, int lip_side) {
    const double x = std::abs(p.x());
    const JawHinge hinge = generic_jaw_hinge();
    const double forward = p.z() - hinge.centre.z();
    // Angle below the hinge: the upper lip lies at 24 degrees, the chin at 45.
    const double angle =
        std::atan2(hinge.centre.y() - p.y(), std::max(forward, 1.0)) * 180.0 / std::numbers::pi;
    double share = smooth_step(16.0, 40.0, angle);
    // Lips part at once; beside them it is gradual.
    const double lips = smooth_step(34.0, 22.0, x) * smooth_step(55.0, 75.0, p.z()) *
                        smooth_step(-92.0, -74.0, p.y()) * smooth_step(-28.0, -40.0, p.y());
    // Towards the corners both lips go half the way: the open mouth is an oval.
    const double oval = smooth_step(HeadField::kMouthCorner - 14.0, HeadField::kMouthCorner, x);
    share = mixed(share, mixed(1.0 - upper_lip_share(p, 0.6, lip_side), 0.5, oval), lips);
    // Over the ramus the skin stays while the bone turns under it; below the jaw it is paid out.
    share *= smooth_step(-8.0, 46.0, forward);
    const double border = -72.0 - 0.42 * (p.z() - 10.0);
    return share * smooth_step(border - 64.0, border + 4.0, p.y());
}

LidPlace lid_place(const Vec3& p) {
    const HeadField& head = average_head();
    const double x =
        std::clamp(std::abs(p.x()), HeadField::kInnerCanthus, HeadField::kOuterCanthus);
    LidPlace place;
    place.upper = head.upper_lid(x);
    place.lower = head.lower_lid(x);
    place.from_corner = std::min(x - HeadField::kInnerCanthus, HeadField::kOuterCanthus - x);
    const double beside = std::abs(p.x()) - x;  // beyond the corners
    const double fade = smooth_step(6.0, 0.0, std::abs(beside)) * smooth_step(55.0, 66.0, p.z());
    const double middle = 0.5 * (place.upper + place.lower);
    // A lid goes with its margin as a whole over the tarsus and rolls up beyond [mm].
    constexpr double kTarsus = 4.0;
    constexpr double kUpperReach = 10.0;
    constexpr double kLowerReach = 12.0;
    constexpr double kAround = 24.0;
    const auto around = [](double reach, double off) {
        return smooth_step(0.6 * reach, reach, off) * smooth_step(kAround, 0.6 * kAround, off);
    };
    if (p.y() > middle) {
        place.with_upper = fade * smooth_step(kUpperReach, kTarsus, p.y() - place.upper);
        place.around = around(kUpperReach, p.y() - place.upper);
    } else {
        place.with_lower = fade * smooth_step(kLowerReach, 0.0, place.lower - p.y());
        place.around = around(kLowerReach, place.lower - p.y());
    }
    place.around *= smooth_step(16.0, 8.0, std::abs(beside)) * smooth_step(40.0, 55.0, p.z());
    return place;
}

Vec3 generic_eye_centre() {
    return average_head().eye_centre();
}

double generic_eye_radius() {
    return HeadField::kEyeRadius;
}

TissueProperties tissue_at(const Vec3& p, double depth, bool faces_inward) {
    const double x = std::abs(p.x());
    const double y = p.y();
    const double z = p.z();
    TissueProperties t;
    t.region = region_at(x, y, z);
    t.strain_limit = skin_of(t.region).strain_limit;
    t.thickness = skin_of(t.region).thickness;

    const double lips = near_lips(x, y, z);
    const double lids = near_lids(x, y, z);
    t.depth = mixed(depth, 2.0, lids);  // a lid slides on the eyeball, not on the orbit's bone
    t.skin_share = mixed(1.0, 0.35, std::max(lips, lids));

    // Thin tissue over the forehead is held more firmly than the cheek (tried: at 0.2, as its
    // gliding plane suggests, a pull at the forehead reaches further than one at the cheek, which
    // it does not in a patient). Lips hang free over the vestibule; the inner and outer canthi and
    // the two facial ligaments hold on.
    const double forehead = smooth_step(26.0, 40.0, y) * smooth_step(20.0, 50.0, z);
    t.bone_tie = mixed(1.0, 2.2, forehead);
    t.bone_tie = mixed(t.bone_tie, 0.15, lips);
    const auto tied = [&](const Vec3& at, double reach, double strength) {
        const double d = (Vec3(x, y, z) - at).norm() / reach;
        t.bone_tie += strength * std::exp(-d * d);
    };
    tied({16.1, 16.3, 79.0}, 4.0, 12.0);
    tied({43.6, 18.0, 74.0}, 4.0, 12.0);
    tied({52.0, -8.0, 52.0}, 9.0, 2.0);
    tied({38.0, -84.0, 50.0}, 9.0, 2.0);

    if (faces_inward) {
        const bool mouth = lips > 0.3 || lids > 0.3 || (y < -36.0 && x < 34.0);
        t.tissue = mouth ? Tissue::Mucosa : Tissue::Cartilage;
        t.strain_limit = 1e9;  // thin folds stretch further; no limit is known for them
        if (mouth) {           // deep in the mouth it lies on gums and palate
            t.bone_tie *= mixed(1.0, 15.0, smooth_step(10.0, 22.0, -average_head()(p)));
        }
    } else if (t.region == Region::Ear) {
        t.tissue = Tissue::Cartilage;
    }

    const double freedom = smooth_step(-45.0, -5.0, z) * smooth_step(-134.0, -106.0, y);
    t.fixed = freedom <= 0.0;
    t.bone_tie /= std::max(freedom * freedom, 0.01);
    return t;
}

bool looks_inward(const Vec3& p, const Vec3& normal) {
    if (p.z() < 20.0 || p.y() < -100.0 || p.y() > 60.0) {
        return false;
    }
    const Vec3 from_eye = Vec3(std::abs(p.x()), p.y(), p.z()) - average_head().eye_centre();
    const Vec3 mirrored(p.x() < 0.0 ? -normal.x() : normal.x(), normal.y(), normal.z());
    if (from_eye.norm() < HeadField::kEyeRadius + 4.0 &&
        mirrored.dot(from_eye.normalized()) < -0.3) {
        return true;  // the lids' lining
    }
    const double depth = -average_head()(p);
    if (depth > 14.0) {
        return true;  // no fit is that far off
    }
    if (depth <= 4.0) {
        return false;
    }
    constexpr double kStep = 0.5;
    Vec3 outward;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 ahead = p;
        ahead[axis] += kStep;
        outward[axis] = average_head()(ahead) + depth;
    }
    return outward.dot(normal) < 0.0;
}

double upper_lip_share(const Vec3& p, double softness, int side) {
    const double x = std::abs(p.x());
    const double height = p.y() - average_head().lip_line(x);
    const double upper =
        side != 0 ? (side > 0 ? 1.0 : 0.0) : smooth_step(-softness, softness, height);
    const double beside =
        smooth_step(HeadField::kMouthCorner - 5.0, HeadField::kMouthCorner + 1.0, x);
    return mixed(upper, 0.5, beside);
}

TissueThickness tissue_thickness(const std::string& name) {
    for (const TissueThickness thickness :
         {TissueThickness::Thin, TissueThickness::Mean, TissueThickness::Heavy}) {
        if (name == thickness_name(thickness)) {
            return thickness;
        }
    }
    throw InvalidInput("There is no tissue depth named '" + name + "': thin, mean or heavy.");
}

const char* thickness_name(TissueThickness thickness) {
    return thickness == TissueThickness::Thin    ? "thin"
           : thickness == TissueThickness::Heavy ? "heavy"
                                                 : "mean";
}

double thickness_factor(TissueThickness thickness, double depth) {
    const double spread = mixed(0.15, 0.35, smooth_step(6.0, 16.0, depth));
    return thickness == TissueThickness::Thin    ? 1.0 - 0.8 * spread
           : thickness == TissueThickness::Heavy ? 1.0 + spread
                                                 : 1.0;
}

Eigen::VectorXd tissue_depths(const Points& generic, TissueThickness thickness) {
    static const SmoothWarp kDepth = [] {
        const DepthSites& sites = depth_sites();
        Points to = Points::Zero(3, sites.places.cols());
        to.row(0) = sites.depths.transpose();
        return SmoothWarp(sites.places, to, Eigen::VectorXd::Zero(to.cols()), 0.0);
    }();
    const Eigen::VectorXd mean = kDepth(generic).row(0).transpose().cwiseMax(2.5).cwiseMin(24.0);
    return mean.unaryExpr([&](double depth) { return thickness_factor(thickness, depth) * depth; });
}

}  // namespace myoface
