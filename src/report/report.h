// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "myoface/io/image.h"

namespace myoface {

struct ReportView {
    std::string caption;
    Image before, after;
};

/// A measure before and after beside its norm.
struct ReportMeasure {
    std::string title;
    bool degrees = false;
    double before = 0.0, after = 0.0;
    std::optional<std::pair<double, double>> norm;  ///< mean and standard deviation
};

/// What a printed report says. Texts are UTF-8.
struct Report {
    std::string language = "en";  ///< of the words that are not given
    std::string title;            ///< "Facial simulation" where there is none
    std::string patient;          ///< a pseudonym
    std::string face;             ///< the scan's name
    std::string date;
    std::string notes;
    std::optional<Image> logo;
    std::vector<ReportView> views;
    std::optional<Image> heat_map;  ///< how far the skin moved …
    double heat_map_mm = 0.0;       ///< … and the distance of its last colour
    std::vector<ReportMeasure> measures;
    std::string population;                               ///< of the norms
    std::vector<std::pair<std::string, double>> volumes;  ///< region, mL
    std::vector<std::pair<std::string, double>> muscles;  ///< name, share
    double largest_move_mm = 0.0;
};

/// Writes A4 pages as PDF, whole or not at all. Fonts are embedded, text stays text.
/// @throws IoError
void write_report(const std::filesystem::path& file, const Report& report);

}  // namespace myoface
