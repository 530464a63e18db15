// SPDX-License-Identifier: Apache-2.0
#include "myoface/io/skin_texture.h"

#include <algorithm>
#include <cmath>

#include "myoface/base/error.h"

namespace myoface {
namespace {

constexpr int kMargin = 8;  // [px] around a tile, so that smaller mip levels do not mix
constexpr int kMostHeight = 8192;
constexpr int kPlainTile = 16;  // [px]

Image halved(const Image& image) {
    Image half{std::max(image.width / 2, 1), std::max(image.height / 2, 1), {}};
    half.rgba.resize(4 * static_cast<std::size_t>(half.width) *
                     static_cast<std::size_t>(half.height));
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            for (int c = 0; c < 4; ++c) {
                int sum = 0;
                for (int k = 0; k < 4; ++k) {
                    const int from_x = std::min(2 * x + k % 2, image.width - 1);
                    const int from_y = std::min(2 * y + k / 2, image.height - 1);
                    sum += image.rgba[static_cast<std::size_t>(4 * (from_y * image.width + from_x) +
                                                               c)];
                }
                half.rgba[static_cast<std::size_t>(4 * (y * half.width + x) + c)] =
                    static_cast<std::uint8_t>((sum + 2) / 4);
            }
        }
    }
    return half;
}

Image plain(const std::array<float, 4>& colour) {
    Image image{kPlainTile, kPlainTile, {}};
    for (int i = 0; i < kPlainTile * kPlainTile; ++i) {
        for (const float c : {colour[0], colour[1], colour[2], 1.0F}) {
            image.rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0F * c)));
        }
    }
    return image;
}

/// Tiles one below the other, their edges drawn out into the margins.
SkinTexture stacked(std::vector<Image> tiles, const std::vector<int>& tile_of_material) {
    const auto height_of = [&] {
        int sum = 0;
        for (const Image& tile : tiles) {
            sum += tile.height + 2 * kMargin;
        }
        return sum;
    };
    while (height_of() > kMostHeight &&
           std::any_of(tiles.begin(), tiles.end(), [](const Image& t) { return t.height > 64; })) {
        for (Image& tile : tiles) {
            tile = tile.height > 64 ? halved(tile) : tile;
        }
    }
    SkinTexture result;
    Image& image = result.image;
    for (const Image& tile : tiles) {
        image.width = std::max(image.width, tile.width + 2 * kMargin);
    }
    image.height = height_of();
    image.rgba.assign(
        4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 255);
    std::vector<Eigen::Vector4f> places;
    int top = 0;
    for (const Image& tile : tiles) {
        for (int y = -kMargin; y < tile.height + kMargin; ++y) {
            for (int x = -kMargin; x < tile.width + kMargin; ++x) {
                const int from = std::clamp(y, 0, tile.height - 1) * tile.width +
                                 std::clamp(x, 0, tile.width - 1);
                const int to = (top + y + kMargin) * image.width + x + kMargin;
                std::copy_n(tile.rgba.begin() + 4L * from, 4, image.rgba.begin() + 4L * to);
            }
        }
        const auto width = static_cast<float>(image.width);
        const auto height = static_cast<float>(image.height);
        places.emplace_back(kMargin / width, static_cast<float>(top + kMargin) / height,
                            static_cast<float>(tile.width) / width,
                            static_cast<float>(tile.height) / height);
        top += tile.height + 2 * kMargin;
    }
    for (const int tile : tile_of_material) {
        result.tiles.push_back(places[static_cast<std::size_t>(tile)]);
    }
    return result;
}

}  // namespace

std::shared_ptr<const SkinTexture> load_texture(const Scan& scan, std::string* note) {
    if (scan.uv.cols() == 0) {
        return nullptr;
    }
    std::vector<Image> images;
    std::vector<int> image_of(scan.textures.size(), -1);
    for (std::size_t t = 0; t < scan.textures.size(); ++t) {
        if (scan.textures[t].bytes.empty()) {
            continue;
        }
        try {
            images.push_back(read_image_bytes(scan.textures[t].bytes, scan.textures[t].name));
            image_of[t] = static_cast<int>(images.size()) - 1;
        } catch (const Error& error) {
            if (note != nullptr) {
                *note = error.what();
            }
        }
    }
    if (images.empty()) {
        return nullptr;
    }
    std::vector<int> tile_of_material;
    bool one_for_all = true;
    for (const Material& material : scan.materials) {
        const int image =
            material.texture >= 0 ? image_of[static_cast<std::size_t>(material.texture)] : -1;
        tile_of_material.push_back(image);
        one_for_all = one_for_all && image == tile_of_material.front() && image >= 0;
    }
    if (one_for_all || scan.face_material.empty()) {
        SkinTexture single;
        single.image = std::move(images[static_cast<std::size_t>(
            std::max(0, tile_of_material.empty() ? 0 : tile_of_material[0]))]);
        return std::make_shared<SkinTexture>(std::move(single));
    }
    for (std::size_t m = 0; m < tile_of_material.size(); ++m) {
        if (tile_of_material[m] < 0) {
            tile_of_material[m] = static_cast<int>(images.size());
            images.push_back(plain(scan.materials[m].colour));
        }
    }
    return std::make_shared<SkinTexture>(stacked(std::move(images), tile_of_material));
}

Eigen::Vector2f place_in_texture(const SkinTexture* texture, int material,
                                 const Eigen::Vector2f& uv) {
    if (texture == nullptr || texture->tiles.empty()) {
        return {uv.x(), 1.0F - uv.y()};
    }
    if (material < 0) {
        return {0.0F, 0.0F};
    }
    const auto inside = [](float x) {  // a tile does not repeat by itself
        return x < -0.01F || x > 1.01F ? x - std::floor(x) : std::clamp(x, 0.0F, 1.0F);
    };
    const Eigen::Vector4f& tile = texture->tiles[static_cast<std::size_t>(material)];
    return {tile[0] + tile[2] * inside(uv.x()), tile[1] + tile[3] * (1.0F - inside(uv.y()))};
}

}  // namespace myoface
