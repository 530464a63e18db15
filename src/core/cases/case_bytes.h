// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "myoface/cases/case_file.h"

namespace myoface {

/// As read_case(), from the bytes of a case. @param name of the file, for sentences
OpenedFace read_case_bytes(std::string_view bytes, const std::string& name,
                           const OpenOptions& options = {}, const Progress* progress = nullptr);

}  // namespace myoface
