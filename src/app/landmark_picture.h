// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <QImage>

namespace myoface {

/// The built-in head, from the front or from its left as the landmark shows best, with the landmark
/// marked. Drawn without a graphics card.
QImage landmarkPicture(const std::string& name, int width, int height);

}  // namespace myoface
