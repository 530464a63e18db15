// SPDX-License-Identifier: Apache-2.0
#include "myoface/io/interchange.h"

#include <cmath>
#include <cstring>
#include <type_traits>

#include "myoface/base/error.h"

#include "number_text.h"

namespace myoface {
namespace {

constexpr std::string_view kMark = "myoface scan 1\n";

class Writer {
public:
    template <typename T>
    void value(const T& x) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes.append(reinterpret_cast<const char*>(&x), sizeof(T));
    }
    template <typename T>
    void block(const T* data, std::size_t count) {
        value(static_cast<std::uint64_t>(count));
        bytes.append(reinterpret_cast<const char*>(data), count * sizeof(T));
    }
    void text(const std::string& x) { block(x.data(), x.size()); }

    std::string bytes;
};

class Reader {
public:
    Reader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    [[noreturn]] void fail() const {
        throw IoError(name_ + ": the import gave back something that is not a mesh.");
    }

    template <typename T>
    T value() {
        T x{};
        take(&x, 1);
        return x;
    }
    template <typename T>
    std::vector<T> block() {
        std::vector<T> result(count(sizeof(T)));
        take(result.data(), result.size());
        return result;
    }
    std::string text() {
        std::string result(count(1), '\0');
        take(result.data(), result.size());
        return result;
    }
    std::size_t count(std::size_t size) {
        const auto n = value<std::uint64_t>();
        if (n > bytes_.size() / size) {
            fail();
        }
        return static_cast<std::size_t>(n);
    }

private:
    template <typename T>
    void take(T* to, std::size_t count) {
        if (count * sizeof(T) > bytes_.size()) {
            fail();
        }
        if (count > 0) {
            std::memcpy(to, bytes_.data(), count * sizeof(T));
        }
        bytes_.remove_prefix(count * sizeof(T));
    }

    std::string_view bytes_;
    const std::string& name_;
};

}  // namespace

std::string encode_scan(const Scan& scan) {
    Writer out;
    out.bytes = kMark;
    out.value(static_cast<std::uint8_t>(scan.format));
    out.value(static_cast<std::uint8_t>(scan.byte_colours));
    out.block(scan.mesh.vertices.data(), static_cast<std::size_t>(scan.mesh.vertices.size()));
    out.block(scan.faces.start.data(), scan.faces.start.size());
    out.block(scan.faces.vertex.data(), scan.faces.vertex.size());
    out.block(scan.faces.uv.data(), scan.faces.uv.size());
    out.block(scan.colours.data(), static_cast<std::size_t>(scan.colours.size()));
    out.block(scan.alpha.data(), static_cast<std::size_t>(scan.alpha.size()));
    out.block(scan.uv.data(), static_cast<std::size_t>(scan.uv.size()));
    out.block(scan.face_material.data(), scan.face_material.size());
    out.value(static_cast<std::uint64_t>(scan.materials.size()));
    for (const Material& material : scan.materials) {
        out.text(material.name);
        out.value(material.colour);
        out.value(material.texture);
    }
    out.value(static_cast<std::uint64_t>(scan.textures.size()));
    for (const Texture& texture : scan.textures) {
        out.text(texture.name);
        out.text(texture.bytes);
    }
    return std::move(out.bytes);
}

Scan decode_scan(std::string_view bytes, const std::string& name) {
    Reader in(bytes.substr(std::min(kMark.size(), bytes.size())), name);
    if (bytes.substr(0, kMark.size()) != kMark) {
        in.fail();
    }
    Scan scan;
    scan.format = in.value<std::uint8_t>() == static_cast<std::uint8_t>(FileFormat::Glb)
                      ? FileFormat::Glb
                      : FileFormat::Gltf;
    scan.byte_colours = in.value<std::uint8_t>() != 0;
    scan.float_coordinates = true;
    const auto check = [&](bool good) {
        if (!good) {
            in.fail();
        }
    };
    const auto vertices = in.block<double>();
    check(!vertices.empty() && vertices.size() % 3 == 0 && vertices.size() < 1'500'000'000);
    for (const double x : vertices) {
        if (!is_usable(x)) {
            throw IoError(name + ": a coordinate is not a finite number.");
        }
    }
    const auto n = static_cast<Eigen::Index>(vertices.size() / 3);
    scan.mesh.vertices = Eigen::Map<const Points>(vertices.data(), 3, n);
    scan.faces.start = in.block<int>();
    scan.faces.vertex = in.block<int>();
    scan.faces.uv = in.block<int>();
    check(scan.faces.start.size() > 1 && scan.faces.start.front() == 0 &&
          scan.faces.start.back() == static_cast<int>(scan.faces.vertex.size()));
    for (int f = 0; f < scan.faces.count(); ++f) {
        check(scan.faces.start[f + 1] >= scan.faces.start[f] + 3LL);
    }
    for (const int v : scan.faces.vertex) {
        check(v >= 0 && v < n);
    }
    const auto colours = in.block<float>();
    check(colours.empty() || colours.size() == vertices.size());
    scan.colours = Eigen::Map<const Eigen::Matrix3Xf>(
        colours.data(), 3, static_cast<Eigen::Index>(colours.size() / 3));
    const auto alpha = in.block<float>();
    check(alpha.empty() || static_cast<Eigen::Index>(alpha.size()) == n);
    scan.alpha =
        Eigen::Map<const Eigen::VectorXf>(alpha.data(), static_cast<Eigen::Index>(alpha.size()));
    const auto uv = in.block<float>();
    check(uv.size() % 2 == 0);
    scan.uv =
        Eigen::Map<const Eigen::Matrix2Xf>(uv.data(), 2, static_cast<Eigen::Index>(uv.size() / 2));
    if (!scan.colours.allFinite() || !scan.alpha.allFinite() || !scan.uv.allFinite()) {
        throw IoError(name + ": a colour or texture coordinate is not a finite number.");
    }
    scan.colours = scan.colours.cwiseMax(0.0F).cwiseMin(1.0F);
    scan.alpha = scan.alpha.cwiseMax(0.0F).cwiseMin(1.0F);
    check(scan.faces.uv.empty() || scan.faces.uv.size() == scan.faces.vertex.size());
    for (const int t : scan.faces.uv) {
        check(t >= -1 && t < scan.uv.cols());
    }
    scan.face_material = in.block<int>();
    check(scan.face_material.empty() ||
          scan.face_material.size() == static_cast<std::size_t>(scan.faces.count()));
    const std::size_t materials = in.count(sizeof(std::uint64_t));
    for (std::size_t m = 0; m < materials; ++m) {
        Material material;
        material.name = in.text();
        material.colour = in.value<std::array<float, 4>>();
        for (float& c : material.colour) {
            c = std::isfinite(c) && c >= 0.0F && c <= 1.0F ? c : 1.0F;
        }
        material.texture = in.value<int>();
        scan.materials.push_back(std::move(material));
    }
    const std::size_t textures = in.count(2 * sizeof(std::uint64_t));
    for (std::size_t t = 0; t < textures; ++t) {
        std::string texture = in.text();
        scan.textures.push_back({std::move(texture), in.text()});
    }
    for (const Material& material : scan.materials) {
        check(material.texture >= -1 && material.texture < static_cast<int>(textures));
    }
    for (const int m : scan.face_material) {
        check(m >= -1 && m < static_cast<int>(materials));
    }
    return scan;
}

}  // namespace myoface
