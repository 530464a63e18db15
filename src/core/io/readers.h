// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "myoface/base/progress.h"
#include "myoface/io/scan.h"

namespace myoface {

/// Both fill vertices (file's own unit and axes), faces, colours, UV and texture name; triangles
/// follow later. `name` is the file's name for messages. @throws IoError
void read_obj(std::string_view text, const std::string& name, Scan& scan, const Progress* progress);
void read_ply(std::string_view bytes, const std::string& name, Scan& scan,
              const Progress* progress);

std::string obj_text(const Scan& scan, const Points& in_file);
std::string ply_bytes(const Scan& scan, const Points& in_file);

}  // namespace myoface
