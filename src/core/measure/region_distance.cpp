// SPDX-License-Identifier: Apache-2.0
#include "myoface/measure/region_distance.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace myoface {
namespace {

RegionDistance summary(const std::string& region, std::vector<double> values) {
    RegionDistance row;
    row.region = region;
    row.nodes = static_cast<int>(values.size());
    int close = 0;
    for (const double d : values) {
        row.mean_mm += std::abs(d) / row.nodes;
        row.mean_signed_mm += d / row.nodes;
        close += std::abs(d) < 2.0 ? 1 : 0;
    }
    row.share_below_2mm = static_cast<double>(close) / row.nodes;
    for (double& d : values) {
        d = std::abs(d);
    }
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.9 * (row.nodes - 1));
    std::nth_element(values.begin(), at, values.end());
    row.p90_mm = *at;
    return row;
}

}  // namespace

std::vector<RegionDistance> distances_by_region(const FaceModel& face,
                                                const Eigen::VectorXd& distance) {
    std::vector<double> all;
    std::map<Region, std::vector<double>> by_region;
    for (Eigen::Index i = 0; i < distance.size(); ++i) {
        const Region region = face.tissue[static_cast<std::size_t>(i)].region;
        const bool counts = region != Region::Scalp && region != Region::Ear &&
                            region != Region::Neck &&
                            face.label[static_cast<std::size_t>(i)].tissue == Tissue::Skin;
        if (counts && std::isfinite(distance[i])) {
            all.push_back(distance[i]);
            by_region[region].push_back(distance[i]);
        }
    }
    std::vector<RegionDistance> rows;
    if (all.empty()) {
        return rows;
    }
    rows.push_back(summary("whole face", all));
    for (auto& [region, values] : by_region) {
        rows.push_back(summary(region_name(region), values));
    }
    return rows;
}

}  // namespace myoface
