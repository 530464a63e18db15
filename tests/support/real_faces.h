// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

namespace myoface::test {

/// The folder of real faces that may stand beside the project, or in MYOFACE_FACES. Tests that need
/// it are skipped where it is absent.
std::optional<std::filesystem::path> real_faces();

}  // namespace myoface::test
