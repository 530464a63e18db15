// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/tissue.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/io/text_file.h"

#include "head/head_mesh.h"

namespace myoface {
namespace {

double smooth_step(double edge0, double edge1, double x) {
    const double t = std::clamp((x - edge0) / (edge1 - edge0), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

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
        return Region::Lids;
    }
    if (z > 75.0 && y > -32.0 && y < 26.0 && x < 9.0 + 0.2 * (20.0 - y)) {
        return Region::Nose;
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

double strain_limit(Region region) {
    switch (region) {
        case Region::Forehead:
        case Region::Glabella:
        case Region::Brow:
        case Region::Scalp:
            return 0.12;
        case Region::Temple:
        case Region::Chin:
        case Region::Jaw:
            return 0.15;
        case Region::UpperLip:
        case Region::LowerLip:
        case Region::Lids:
            return 0.40;
        case Region::Nose:
            return 0.06;
        default:
            return 0.25;
    }
}

}  // namespace

std::string region_name(Region region) {
    switch (region) {
        case Region::Forehead:
            return "forehead";
        case Region::Glabella:
            return "glabella";
        case Region::Brow:
            return "brow";
        case Region::Lids:
            return "lids";
        case Region::Temple:
            return "temple";
        case Region::Nose:
            return "nose";
        case Region::Cheek:
            return "cheek";
        case Region::UpperLip:
            return "upper lip";
        case Region::LowerLip:
            return "lower lip";
        case Region::Chin:
            return "chin";
        case Region::Jaw:
            return "jaw";
        case Region::Ear:
            return "ear";
        case Region::Neck:
            return "neck";
        default:
            return "scalp";
    }
}

TissueProperties tissue_at(const Vec3& p, double depth, bool faces_inward) {
    const double x = std::abs(p.x());
    const double y = p.y();
    const double z = p.z();
    TissueProperties t;
    t.region = region_at(x, y, z);
    t.strain_limit = strain_limit(t.region);

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
        const bool mouth = lips > 0.3 || (y < -36.0 && x < 34.0);
        t.tissue = mouth ? Tissue::Mucosa : Tissue::Cartilage;
        t.strain_limit = 1e9;  // thin folds stretch further; no limit is known for them
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
    const double depth = -average_head()(p);
    if (depth > 14.0) {
        return true;  // no fit is that far off
    }
    constexpr double kStep = 0.5;
    Vec3 outward;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 ahead = p;
        ahead[axis] += kStep;
        outward[axis] = average_head()(ahead) + depth;
    }
    return depth > 4.0 && outward.dot(normal) < 0.0;
}

double upper_lip_share(const Vec3& p, double softness) {
    const double x = std::abs(p.x());
    const double height = p.y() - average_head().lip_line(x);
    const double upper = smooth_step(-softness, softness, height);
    const double beside =
        smooth_step(HeadField::kMouthCorner - 5.0, HeadField::kMouthCorner + 1.0, x);
    return mixed(upper, 0.5, beside);
}

Eigen::VectorXd tissue_depths(const Points& generic) {
    static const SmoothWarp kDepth = [] {
        std::istringstream text(read_file(resource_path("assets/tissue_depth.csv")));
        std::string line;
        std::getline(text, line);
        std::vector<Vec3> places;
        std::vector<double> depths;
        while (std::getline(text, line)) {
            std::vector<std::string> cells;
            std::istringstream row(line);
            for (std::string cell; std::getline(row, cell, ',');) {
                cells.push_back(cell);
            }
            if (cells.size() < 6) {
                continue;
            }
            std::array<double, 4> v{};
            for (std::size_t i = 0; i < 4; ++i) {
                const std::string& cell = cells[i + 2];
                if (std::from_chars(cell.data(), cell.data() + cell.size(), v[i]).ec !=
                    std::errc()) {
                    throw IoError("assets/tissue_depth.csv: '" + cell + "' is not a number.");
                }
            }
            places.emplace_back(v[0], v[1], v[2]);
            depths.push_back(v[3]);
            if (cells[1] == "yes") {
                places.emplace_back(-v[0], v[1], v[2]);
                depths.push_back(v[3]);
            }
        }
        Points from(3, static_cast<Eigen::Index>(places.size()));
        Points to = Points::Zero(3, from.cols());
        for (std::size_t i = 0; i < places.size(); ++i) {
            from.col(static_cast<Eigen::Index>(i)) = places[i];
            to(0, static_cast<Eigen::Index>(i)) = depths[i];
        }
        return SmoothWarp(from, to, Eigen::VectorXd::Zero(from.cols()), 0.0);
    }();
    return kDepth(generic).row(0).transpose().cwiseMax(2.5).cwiseMin(24.0);
}

}  // namespace myoface
