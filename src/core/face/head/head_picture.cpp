// SPDX-License-Identifier: Apache-2.0
#include "head_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "myoface/base/parallel.h"
#include "myoface/io/image.h"

#include "head_parts.h"

namespace myoface {
namespace {

const Vec3 kMiddle(0.0, -8.0, 0.0);  // of the head: what the disc is seen from
constexpr double kDisc = 0.48;       // radius of the disc, of the square's side
constexpr double kSpread = 0.8;      // < 1: more room for the face, less for the back
constexpr double kEyeDisc = 0.062;
constexpr double kEyeReach = 2.3;  // [rad] of the eyeball that the picture shows
constexpr double kPatch = 0.02;

Eigen::Vector2d on_disc(const Vec3& p) {
    const Vec3 d = (p - kMiddle).normalized();
    const double angle = std::acos(std::clamp(d.z(), -1.0, 1.0));
    const double radius = kDisc * std::pow(angle / std::numbers::pi, kSpread);
    const double flat = std::hypot(d.x(), d.y());
    if (flat < 1e-9) {
        return {0.5, 0.5};
    }
    return {0.5 + radius * d.x() / flat, 0.5 + radius * d.y() / flat};
}

Eigen::Vector2d eye_disc_centre(bool left) {
    return {left ? 0.93 : 0.07, 0.93};
}

Vec3 eye_centre(bool left) {
    const Vec3 centre = average_head().eye_centre();
    return {left ? centre.x() : -centre.x(), centre.y(), centre.z()};
}

Eigen::Vector2d on_eye_disc(const Vec3& p) {
    const bool left = p.x() > 0.0;
    const Vec3 d = (p - eye_centre(left)).normalized();
    const double angle = std::acos(std::clamp(d.z(), -1.0, 1.0));
    const double flat = std::max(std::hypot(d.x(), d.y()), 1e-9);
    const double radius = kEyeDisc * std::min(angle / kEyeReach, 1.0);
    return eye_disc_centre(left) + radius * Eigen::Vector2d(d.x(), d.y()) / flat;
}

/// Pieces that have one colour, as small squares along the lower edge.
enum Patch { kPictureMargin, kLining, kGum, kTooth, kMound, kPatches };

Eigen::Vector2d patch_centre(int patch) {
    return {0.03 + 0.045 * (patch % 3), 0.03 + 0.045 * (patch / 3)};
}

/// The nostrils lie behind their rims on the disc. They have a strip of their own, on which the
/// colour goes from the skin's to the dark.
constexpr double kStripLeft = 0.86, kStripRight = 0.99, kStripHeight = 0.03;

int patch_of(HeadPart part) {
    switch (part) {
        case HeadPart::LidMargin:
            return kPictureMargin;
        case HeadPart::Mouth:
            return kLining;
        case HeadPart::Gum:
            return kGum;
        case HeadPart::Tooth:
            return kTooth;
        case HeadPart::Caruncle:
            return kMound;
        default:
            return -1;
    }
}

constexpr std::array<HeadPart, 5> kPatchPart{HeadPart::LidMargin, HeadPart::Mouth, HeadPart::Gum,
                                             HeadPart::Tooth, HeadPart::Caruncle};
/// Place on the strip, or less than 0 outside a nostril.
double in_nostril(const Vec3& p) {
    const Vec3 q = average_head().in_primitives(p);
    return q.z() > 86.0 && std::abs(q.x()) < 14.0 && q.y() < -6.0 && q.y() > -33.0 &&
                   average_head().nostril(q) < 1.3
               ? nostril_share(q)
               : -1.0;
}

/// Which triangle a texel shows: where several lie behind each other, the outermost.
struct Texel {
    int triangle = -1;
    float outward = 0.0F;
    float weight_a = 0.0F, weight_b = 0.0F;
};

void draw_triangle(std::vector<Texel>& texels, int size, int t,
                   const std::array<Eigen::Vector2d, 3>& uv, const std::array<double, 3>& outward) {
    const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() * b.y() - a.y() * b.x();
    };
    const double area = cross(uv[1] - uv[0], uv[2] - uv[0]);
    if (std::abs(area) < 1e-14) {
        return;
    }
    const auto bound = [&](double v) { return std::clamp(static_cast<int>(v), 0, size - 1); };
    constexpr double kPictureMargin = 0.6;  // texels beyond the edge: no gaps between triangles
    const double low_u = std::min({uv[0].x(), uv[1].x(), uv[2].x()}) * size - kPictureMargin;
    const double high_u = std::max({uv[0].x(), uv[1].x(), uv[2].x()}) * size + kPictureMargin;
    const double low_v = std::min({uv[0].y(), uv[1].y(), uv[2].y()}) * size - kPictureMargin;
    const double high_v = std::max({uv[0].y(), uv[1].y(), uv[2].y()}) * size + kPictureMargin;
    for (int row = bound(low_v); row <= bound(high_v); ++row) {
        for (int column = bound(low_u); column <= bound(high_u); ++column) {
            const Eigen::Vector2d at((column + 0.5) / size, (row + 0.5) / size);
            const double a = cross(uv[1] - at, uv[2] - at) / area;
            const double b = cross(uv[2] - at, uv[0] - at) / area;
            const double tolerance = 0.02;
            if (a < -tolerance || b < -tolerance || a + b > 1.0 + tolerance) {
                continue;
            }
            const auto out =
                static_cast<float>(a * outward[0] + b * outward[1] + (1.0 - a - b) * outward[2]);
            Texel& texel = texels[static_cast<std::size_t>(row) * size + column];
            if (texel.triangle < 0 || out > texel.outward) {
                texel = {t, out, static_cast<float>(a), static_cast<float>(b)};
            }
        }
    }
}

void set_pixel(Image& image, int column, int row_from_below, const Vec3& colour) {
    const int row = image.height - 1 - row_from_below;
    const std::size_t at = 4 * (static_cast<std::size_t>(row) * image.width + column);
    for (int c = 0; c < 3; ++c) {
        image.rgba[at + c] =
            static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(colour[c], 0.0, 1.0)));
    }
    image.rgba[at + 3] = 255;
}

Image paint(const HeadMesh& head, const std::vector<double>& nostril, const HeadLook& look,
            int size) {
    std::vector<Texel> texels(static_cast<std::size_t>(size) * size);
    const TriangleMesh& mesh = head.mesh;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        std::array<Eigen::Vector2d, 3> uv;
        std::array<double, 3> outward{};
        bool skin = true;
        bool back = true;  // around the point behind, the disc's rim: triangles there are cut
        for (int c = 0; c < 3; ++c) {
            const int v = mesh.triangles(c, t);
            skin = skin && head.part[v] == HeadPart::Skin && nostril[v] < 0.3;
            const Vec3 p = mesh.vertices.col(v);
            uv[c] = on_disc(p);
            outward[c] = (p - kMiddle).norm();
            back = back && (uv[c] - uv[0]).norm() < 0.2;
        }
        if (skin && back) {
            draw_triangle(texels, size, t, uv, outward);
        }
    }
    const Vec3 rim =
        head_colour(HeadPart::Skin, average_head().front_point(0.0, -24.0), look, false);
    const Vec3 dark(0.31, 0.14, 0.12);
    Image image{size, size, std::vector<std::uint8_t>(texels.size() * 4, 255)};
    parallel_for(size, 8, [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            for (int column = 0; column < size; ++column) {
                const Eigen::Vector2d at((column + 0.5) / size, (row + 0.5) / size);
                const Texel& texel = texels[static_cast<std::size_t>(row) * size + column];
                Vec3 colour(0.45, 0.36, 0.31);
                if (texel.triangle >= 0) {
                    const Vec3 p =
                        texel.weight_a * mesh.corner(texel.triangle, 0) +
                        texel.weight_b * mesh.corner(texel.triangle, 1) +
                        (1.0F - texel.weight_a - texel.weight_b) * mesh.corner(texel.triangle, 2);
                    colour = head_colour(HeadPart::Skin, p, look, true);
                }
                for (const bool left : {true, false}) {
                    const Eigen::Vector2d off = at - eye_disc_centre(left);
                    if (off.norm() < 1.1 * kEyeDisc) {
                        const double angle = kEyeReach * std::min(off.norm() / kEyeDisc, 1.0);
                        const double flat = std::max(off.norm(), 1e-9);
                        const Vec3 d(std::sin(angle) * off.x() / flat,
                                     std::sin(angle) * off.y() / flat, std::cos(angle));
                        colour =
                            head_colour(HeadPart::Eye, eye_centre(left) + HeadField::kEyeRadius * d,
                                        look, true);
                    }
                }
                for (int patch = 0; patch < kPatches; ++patch) {
                    if ((at - patch_centre(patch)).cwiseAbs().maxCoeff() < kPatch) {
                        colour = head_colour(kPatchPart[static_cast<std::size_t>(patch)],
                                             Vec3::Zero(), look, true);
                    }
                }
                if (at.x() > kStripLeft - 0.01 && at.y() < kStripHeight) {
                    const double share =
                        std::clamp((at.x() - kStripLeft) / (kStripRight - kStripLeft), 0.0, 1.0);
                    colour = rim + share * (dark - rim);
                }
                set_pixel(image, column, row, colour);
            }
        }
    });
    return image;
}

}  // namespace

void add_picture(Scan& scan, const HeadMesh& head, const HeadLook& look, int size) {
    const int n = head.mesh.vertex_count();
    std::vector<double> nostril(static_cast<std::size_t>(n));
    scan.uv.resize(2, 2 * n + kPatches);
    for (int v = 0; v < n; ++v) {
        const Vec3 p = head.mesh.vertices.col(v);
        nostril[v] = head.part[v] == HeadPart::Skin ? in_nostril(p) : -1.0;
        scan.uv.col(v) =
            (head.part[v] == HeadPart::Eye ? on_eye_disc(p) : on_disc(p)).cast<float>();
    }
    for (int patch = 0; patch < kPatches; ++patch) {
        scan.uv.col(n + patch) = patch_centre(patch).cast<float>();
    }
    Eigen::Index used = n + kPatches;
    std::vector<int> on_strip(static_cast<std::size_t>(n), -1);
    scan.faces.uv.resize(scan.faces.vertex.size());
    for (int t = 0; t < head.mesh.triangle_count(); ++t) {
        int patch = -1;
        bool inside = true;
        double deepest = 0.0;
        for (int c = 0; c < 3; ++c) {
            const int v = head.mesh.triangles(c, t);
            patch = std::max(patch, patch_of(head.part[v]));
            inside = inside && nostril[v] >= 0.0;
            deepest = std::max(deepest, nostril[v]);
        }
        for (int c = 0; c < 3; ++c) {
            const int v = head.mesh.triangles(c, t);
            int& uv = scan.faces.uv[static_cast<std::size_t>(3 * t + c)];
            uv = patch >= 0 ? n + patch : v;
            if (inside && deepest > 0.02) {
                if (on_strip[v] < 0) {
                    on_strip[v] = static_cast<int>(used);
                    const double along =
                        kStripLeft + nostril[v] / 0.95 * (kStripRight - kStripLeft);
                    scan.uv.col(used++) = Eigen::Vector2d(along, 0.5 * kStripHeight).cast<float>();
                }
                uv = on_strip[v];
            }
        }
    }
    scan.uv.conservativeResize(2, used);
    constexpr int kQuality = 92;
    scan.textures.push_back({"skin.jpg", encode_jpeg(paint(head, nostril, look, size), kQuality)});
    Material material;
    material.name = "head";
    material.texture = 0;
    scan.materials.push_back(material);
    scan.face_material.assign(static_cast<std::size_t>(scan.faces.count()), 0);
}

}  // namespace myoface
