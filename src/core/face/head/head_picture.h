// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/io/scan.h"

#include "head_colour.h"
#include "head_mesh.h"

namespace myoface {

/// Texture coordinates of the average head: the skin as a disc seen from inside the head, nose in
/// the middle and the back of the head at the rim, so no seam crosses it; eyes and linings in the
/// corners of the square. Fills the scan's uv, its corners' indices, material and picture.
/// @param size of the picture [pixels]
void add_picture(Scan& scan, const HeadMesh& head, const HeadLook& look, int size);

}  // namespace myoface
