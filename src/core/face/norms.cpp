// SPDX-License-Identifier: Apache-2.0
#include "norms.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/io/text_file.h"

namespace myoface {

std::vector<NormRow> read_norms(double age) {
    const double share = std::clamp((age - 20.0) / 5.0, 0.0, 1.0);
    std::istringstream text(read_file(resource_path("assets/norms.csv")));
    std::vector<NormRow> rows;
    std::string line;
    std::getline(text, line);  // header
    while (std::getline(text, line)) {
        std::vector<std::string> cells;
        std::istringstream cell_text(line);
        for (std::string cell; std::getline(cell_text, cell, ',');) {
            cells.push_back(cell);
        }
        if (cells.size() < 10) {
            continue;
        }
        std::array<double, 8> v{};
        for (std::size_t i = 0; i < v.size(); ++i) {
            const std::string& cell = cells[i + 2];
            if (std::from_chars(cell.data(), cell.data() + cell.size(), v[i]).ec != std::errc()) {
                throw IoError("assets/norms.csv: '" + cell + "' is not a number.");
            }
        }
        const auto blend = [&](std::size_t i) { return v[i] + share * (v[i + 4] - v[i]); };
        rows.push_back({cells[0], cells[1], blend(0), blend(1), blend(2), blend(3)});
    }
    return rows;
}

}  // namespace myoface
