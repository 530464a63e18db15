// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "myoface/face/landmarks.h"

namespace myoface {

enum class Sex { Female, Male };

enum class MeasureKind {
    Distance,   ///< straight, between two landmarks; of paired ones the mean of both sides [mm]
    Angle,      ///< at the middle one of three midline landmarks [deg]
    Tilt,       ///< of the line en-ex against the line of the inner canthi, up positive [deg]
    Depth,      ///< of the sellion in front of the inner canthi [mm]
    Projection  ///< of one landmark in front of the nasion, at right angles to the line n-pg [mm]
};

/// One measure of a face. Points are landmark names without side.
struct Measure {
    std::string id;     ///< "n-gn"
    std::string title;  ///< "facial height"
    MeasureKind kind = MeasureKind::Distance;
    std::vector<std::string> points;

    bool in_degrees() const { return kind == MeasureKind::Angle || kind == MeasureKind::Tilt; }
};

/// What a measure is in a population.
struct Norm {
    Measure measure;
    double mean = 0.0, sd = 0.0;
    std::string source;
};

/// Published norms: young adults of European descent. Ages from 20 to 25 are blended; beyond that
/// they are held, since the growth curves they come from are not meant for older people.
/// @param sex both sexes' average when absent
/// @throws IoError when the program's own table is damaged
/// @cite weinberg_2016 and others, named per row
std::vector<Norm> norms(std::optional<Sex> sex, double age);

/// The measure on a face; nothing where a landmark is missing.
std::optional<double> measured(const Measure& measure, const Landmarks& landmarks);

}  // namespace myoface
