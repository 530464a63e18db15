// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "myoface/base/points.h"

namespace myoface {

std::string trimmed(const std::string& text);
/// One finite number and nothing else, a leading + allowed.
bool read_number(const std::string& text, double& value);
/// Numbers between commas; empty when one of them is not a number.
std::vector<double> numbers(const std::string& text);

/// Calls `take(key, value)` for every part of "key=value; key=value".
void each_part(const std::string& text,
               const std::function<void(const std::string& key, const std::string& value)>& take);

/// A view as an edit names it, "left" or "dx,dy,dz", in our frame.
struct ViewAxes {
    Vec3 right, up, forward;
};
/// @throws InvalidInput
ViewAxes view_axes(const std::string& name);

}  // namespace myoface
