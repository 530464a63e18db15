// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace myoface {

/// A row of assets/norms.csv: a distance between two landmarks [mm].
struct NormRow {
    std::string from, to;  ///< landmark names without side
    double male_mean = 0, male_sd = 0, female_mean = 0, female_sd = 0;
};

/// At 20 and at 25 years. @throws IoError when the program's own table is damaged
std::vector<NormRow> read_norms(double age);

}  // namespace myoface
