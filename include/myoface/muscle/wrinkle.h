// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "myoface/face/face_model.h"
#include "myoface/muscle/contraction.h"

namespace myoface {

/// Years that skin can have [a]. What is never asked gets the default.
inline constexpr double kYoungestSkin = 18.0, kOldestSkin = 80.0, kUsualSkin = 40.0;

/// A furrow that expression can draw, as the atlas says; the same for every face.
struct FurrowTraits {
    std::string name;          ///< forehead_2, crows_foot_1.L
    std::string group;         ///< forehead, glabella, crows_feet, …
    std::vector<int> muscles;  ///< that draw it, in the atlas' order
    Points line;               ///< on the average head [mm]
    double width = 1.8;        ///< from the middle to where the profile crosses zero [mm]
    double share = 1.0;        ///< of the shortening around it that this furrow takes up
    double gauge = 5.0;        ///< half the length over which shortening is measured [mm]
    double lean = 0.0;         ///< more ridge on the side to which `across` points
    double first_age = 0.0;    ///< from which on it is to be seen
    int lip = 0;               ///< 1 on the upper lip alone, -1 on the lower
};

/// The furrows that come with the program: assets/wrinkles.json, both sides of paired ones.
/// @throws IoError when it is damaged
const std::vector<FurrowTraits>& furrow_atlas();

/// Where furrows can form on one face, and how they displace its scan. Constant.
struct WrinkleMap {
    /// A place between skin nodes.
    struct Place {
        std::array<int, 3> node{};
        Eigen::Vector3d weight = Eigen::Vector3d::Zero();
    };
    /// Along a furrow, every two millimetres: a length across it on the skin.
    struct Gauge {
        int furrow = -1;
        Place here, low, high;
        double taper = 1.0;  ///< 0 at the furrow's ends
    };
    std::vector<Gauge> gauges;  ///< furrow by furrow, in order along each
    std::vector<int> first;     ///< per furrow of the atlas, and the end
    /// Scan vertices near a furrow; how high they stand per millimetre of depth at gauges.
    std::vector<int> vertices;
    std::vector<int> start;  ///< per vertex, and the end: range in `gauge` and `height`
    std::vector<int> gauge;
    std::vector<float> height;
    std::vector<int> of_node;  ///< skin nodes whose normals count
};

/// Puts the furrows of the atlas on a face; some tens of milliseconds.
std::shared_ptr<const WrinkleMap> map_wrinkles(const FaceModel& face);

/// How much the skin has become shorter across each furrow, at each gauge: 0 at rest, never
/// negative. @param rest, now 3×nodes, the skin's first [mm]
Eigen::VectorXd shortening(const WrinkleMap& map, const Points& rest, const Points& now);

/// Whether each furrow's muscles act, 0 … 1: all of it from a tenth of full contraction on.
Eigen::VectorXd furrow_drive(const FaceModel& face, const Contractions& contractions);

/// Depth of each furrow at each gauge [mm]: that at which its profile is longer than the straight
/// way by the shortening which skin of this age does not take up by itself. Exactly 0 where skin
/// has not become shorter. @param drive per furrow, 0 … 1
Eigen::VectorXd furrow_depths(const WrinkleMap& map, const Eigen::VectorXd& shortening,
                              const Eigen::VectorXd& drive, double skin_age);

/// The wrinkles of one moment.
struct Wrinkles {
    std::shared_ptr<const WrinkleMap> map;
    Eigen::VectorXd depth;  ///< per gauge [mm]

    bool none() const { return !map || depth.size() == 0 || depth.isZero(0.0); }
};

/// Displaces the vertices near furrows along the skin's normal, as much outwards as inwards.
/// @param nodes 3×nodes, the skin's first [mm] @param vertices 3×N of the scan
void add_wrinkles(const FaceModel& face, const Wrinkles& wrinkles, const Points& nodes,
                  Points& vertices);

/// The height of each of the map's vertices over the skin without wrinkles [mm].
Eigen::VectorXd wrinkle_heights(const Wrinkles& wrinkles);

}  // namespace myoface
