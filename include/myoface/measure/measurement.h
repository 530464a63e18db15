// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "myoface/face/midplane.h"
#include "myoface/face/norms.h"
#include "myoface/measure/landmarks_on_skin.h"

namespace myoface {

/// Whose norms stand beside the measures.
struct Population {
    std::optional<Sex> sex;  ///< both sexes' average when absent
    double age = 25.0;       ///< years

    /// "adults of European descent, 20 to 25 years"
    static const char* name();
};

/// A measure of a face, of the same face later or of another one, and its norm where there is one.
/// In mm or degrees.
struct Measurement {
    Measure measure;
    double value = 0.0;
    std::optional<double> other;
    std::optional<Norm> norm;

    double difference() const { return other ? *other - value : 0.0; }
};

/// Every measure the program knows: those with norms first, then how far nose, lips and chin stand
/// out.
std::vector<Measure> all_measures();

/// Those with norms. Measures whose landmarks are missing are left out.
std::vector<Measurement> measure_all(const Landmarks& here, const Landmarks* other,
                                     const Population& population);
/// All, of a face at two moments. @param before, now 3×nodes, the skin's first [mm]
std::vector<Measurement> measure_all(const LandmarksOnSkin& places, const Points& before,
                                     const Points& now, const Population& population);

/// How far each left landmark is from the mirror image of the right one [mm], by the name without
/// side.
std::vector<std::pair<std::string, double>> asymmetries(const Landmarks& landmarks,
                                                        const Midplane& plane);

std::string measurements_json(const std::vector<Measurement>& rows,
                              const std::vector<std::pair<std::string, double>>& asymmetry,
                              const Population& population);
std::string measurements_csv(const std::vector<Measurement>& rows);

}  // namespace myoface
