// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "myoface/face/landmarks.h"
#include "myoface/face/norms.h"

namespace myoface {

/// Wanted values of measures, by their id.
using WantedMeasures = std::map<std::string, double>;

/// The norms' means, or with a seed an individual drawn from their spread. Measures that are parts
/// of one another (n-gn of its stretches, ex-ex of en-en and en-ex) are drawn so that all keep
/// their own spread. @param old 0 … 1: lips grow thinner and longer beyond the norms' ages
WantedMeasures wanted_measures(std::optional<Sex> sex, double age, double old,
                               std::optional<std::uint32_t> seed);

/// Moves landmarks as little and as evenly as can be so that they measure what is wanted. Symmetric
/// landmarks stay symmetric.
Landmarks with_measures(const Landmarks& from, const WantedMeasures& wanted);

}  // namespace myoface
