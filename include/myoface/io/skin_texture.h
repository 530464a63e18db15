// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "myoface/io/image.h"
#include "myoface/io/scan.h"

namespace myoface {

/// The picture that a scan is drawn with. Several pictures, and materials that have a colour only,
/// stand as tiles in one.
struct SkinTexture {
    Image image;
    /// Material -> left, top, width and height of its tile as shares of the image; empty where one
    /// picture serves all.
    std::vector<Eigen::Vector4f> tiles;
};

/// Decodes a scan's textures; null where none can be read, and perhaps a sentence in `note`.
std::shared_ptr<const SkinTexture> load_texture(const Scan& scan, std::string* note = nullptr);

/// A texture coordinate (from the bottom left) as a place in the image (from the top left).
Eigen::Vector2f place_in_texture(const SkinTexture* texture, int material,
                                 const Eigen::Vector2f& uv);

}  // namespace myoface
