// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <string_view>
#include <unordered_map>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"

#include "obj_piece.h"
#include "readers.h"

namespace myoface {
namespace {

/// The file is read in pieces of this size, many at a time: large enough to hand out, small enough
/// that what comes of them stays in the cache until it is put in its place.
constexpr std::size_t kPieceBytes = std::size_t{1} << 18;
constexpr std::size_t kTogether = 32;

/// Stretches of about equal size that end where a statement ends.
std::vector<std::string_view> pieces_of(std::string_view text) {
    std::vector<std::string_view> pieces;
    while (!text.empty()) {
        std::size_t cut = std::min(kPieceBytes, text.size());
        while (cut < text.size()) {
            const std::size_t newline = text.find('\n', cut - 1);
            cut = newline == std::string_view::npos ? text.size() : newline + 1;
            if (newline == std::string_view::npos ||
                !statement_continues(text.data(), text.data() + newline)) {
                break;
            }
            ++cut;
        }
        cut = std::min(cut, text.size());
        pieces.push_back(text.substr(0, cut));
        text.remove_prefix(cut);
    }
    return pieces;
}

/// Line of a face, for a message; the file is walked again.
int line_of_face(std::string_view text, int wanted) {
    int line = 0;
    int faces = 0;
    while (!text.empty()) {
        const std::size_t stop = std::min(text.find('\n'), text.size());
        const char* const at = skip_blanks(text.data(), text.data() + stop);
        const int begins = ++line;
        bool more = statement_continues(text.data(), text.data() + stop);
        const bool is_face = at + 1 < text.data() + stop && *at == 'f' && is_blank(at[1]);
        text.remove_prefix(std::min(stop + 1, text.size()));
        while (more && !text.empty()) {
            const std::size_t next = std::min(text.find('\n'), text.size());
            more = statement_continues(text.data(), text.data() + next);
            text.remove_prefix(std::min(next + 1, text.size()));
            ++line;
        }
        if (is_face && faces++ == wanted) {
            return begins;
        }
    }
    return line;
}

template <typename Get>
std::vector<std::size_t> offsets(std::size_t begin, const std::vector<ObjPiece>& pieces,
                                 const Get& get) {
    std::vector<std::size_t> result{begin};
    for (const ObjPiece& piece : pieces) {
        result.push_back(result.back() + get(piece));
    }
    return result;
}

/// Puts pieces in their places one batch after another.
class ObjJoiner {
public:
    ObjJoiner(std::string_view text, const std::string& name, Scan& scan)
        : text_(text), name_(name), scan_(scan) {}

    /// @param left_to_read what follows in the file, in sizes of this batch
    void add(std::vector<ObjPiece>& pieces, double left_to_read) {
        const auto old_uv = static_cast<std::size_t>(scan_.uv.cols());
        const auto vertex = offsets(static_cast<std::size_t>(scan_.mesh.vertices.cols()), pieces,
                                    [](const ObjPiece& p) { return p.positions.size() / 3; });
        const auto uv = offsets(old_uv, pieces, [](const ObjPiece& p) { return p.uv.size() / 2; });
        const auto face = offsets(static_cast<std::size_t>(scan_.faces.count()), pieces,
                                  [](const ObjPiece& p) { return p.face_sizes.size(); });
        const auto corner = offsets(scan_.faces.vertex.size(), pieces,
                                    [](const ObjPiece& p) { return p.corner_vertex.size(); });
        if (std::max({vertex.back(), uv.back(), corner.back()}) > 500'000'000) {
            throw IoError(name_ + ": has more vertices or corners than this program can hold.");
        }
        scan_.mesh.vertices.conservativeResize(3, static_cast<Eigen::Index>(vertex.back()));
        scan_.uv.conservativeResize(2, static_cast<Eigen::Index>(uv.back()));
        const auto enlarge = [&](std::vector<int>& values, std::size_t size, int fill) {
            if (values.capacity() < size) {
                // As if the rest of the file were like this batch. Memory that is not touched
                // costs nothing.
                const double rest = static_cast<double>(size - values.size()) * left_to_read;
                values.reserve(size + static_cast<std::size_t>(1.05 * rest));
            }
            values.resize(size, fill);
        };
        enlarge(scan_.faces.start, face.back() + 1, 0);
        enlarge(scan_.faces.vertex, corner.back(), 0);
        any_uv_ = any_uv_ || std::any_of(pieces.begin(), pieces.end(),
                                         [](const ObjPiece& p) { return !p.corner_uv.empty(); });
        if (any_uv_) {
            enlarge(scan_.faces.uv, corner.back(), -1);
        }
        parallel_for(static_cast<int>(pieces.size()), 1, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                const auto k = static_cast<std::size_t>(i);
                place(pieces[k], vertex[k], uv[k], face[k], corner[k]);
            }
        });
        scan_.faces.start.back() = static_cast<int>(corner.back());
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            ObjPiece& piece = pieces[k];
            highest_vertex_ = std::max(highest_vertex_, piece.highest_vertex);
            highest_uv_ = std::max(highest_uv_, piece.highest_uv);
            keep_colours(piece.colours, vertex[k]);
            for (ObjStatement& statement : piece.statements) {
                statement.before_face += static_cast<int>(face[k]);
                scan_.statements.push_back(std::move(statement));
            }
            std::move(piece.libraries.begin(), piece.libraries.end(),
                      std::back_inserter(scan_.material_libraries));
            scan_.findings.other_statements += piece.others;
        }
    }

    void finish() {
        if (scan_.mesh.vertices.cols() == 0) {
            throw IoError(name_ + ": holds no vertices, this is not a face scan.");
        }
        if (scan_.faces.count() == 0) {
            throw IoError(name_ + ": holds points but no faces; export the scan as a mesh.");
        }
        if (before_first_ || highest_vertex_ >= scan_.mesh.vertices.cols() ||
            highest_uv_ >= scan_.uv.cols()) {
            for (int f = 0; f < scan_.faces.count(); ++f) {
                check(f);
            }
        }
        colours();
        materials();
    }

private:
    void place(ObjPiece& piece, std::size_t vertex, std::size_t uv, std::size_t face,
               std::size_t corner) {
        std::copy(piece.positions.begin(), piece.positions.end(),
                  scan_.mesh.vertices.data() + 3 * vertex);
        std::copy(piece.uv.begin(), piece.uv.end(), scan_.uv.data() + 2 * uv);
        for (const std::size_t c : piece.backward_vertex) {
            piece.corner_vertex[c] += static_cast<int>(vertex);
            if (piece.corner_vertex[c] < 0) {
                before_first_ = true;
            }
        }
        for (const std::size_t c : piece.backward_uv) {
            piece.corner_uv[c] += static_cast<int>(uv);
            if (piece.corner_uv[c] < 0) {
                piece.corner_uv[c] = -2;  // -1 would read as "none"
                before_first_ = true;
            }
        }
        std::copy(piece.corner_vertex.begin(), piece.corner_vertex.end(),
                  scan_.faces.vertex.begin() + static_cast<std::ptrdiff_t>(corner));
        std::copy(piece.corner_uv.begin(), piece.corner_uv.end(),
                  scan_.faces.uv.begin() + static_cast<std::ptrdiff_t>(any_uv_ ? corner : 0));
        for (std::size_t f = 0; f < piece.face_sizes.size(); ++f) {
            scan_.faces.start[face + f] = static_cast<int>(corner);
            corner += static_cast<std::size_t>(piece.face_sizes[f]);
        }
    }

    /// Positive indices may point forward, so ranges are checked once everything is read.
    void check(int face) const {
        for (int c = scan_.faces.start[face]; c < scan_.faces.start[face + 1]; ++c) {
            const auto check = [&](const char* kind, int index, int least, Eigen::Index count) {
                if (index >= least && index < count) {
                    return;
                }
                throw IoError(name_ + " line " + std::to_string(line_of_face(text_, face)) +
                              ": face " + kind + " " +
                              (index < 0 ? "before the first one" : std::to_string(index + 1)) +
                              " does not exist (the file has " + std::to_string(count) + ").");
            };
            check("vertex", scan_.faces.vertex[c], 0, scan_.mesh.vertices.cols());
            if (!scan_.faces.uv.empty()) {
                check("texture coordinate", scan_.faces.uv[c], -1, scan_.uv.cols());
            }
        }
    }

    void keep_colours(const std::vector<float>& from, std::size_t vertex) {
        if (!from.empty()) {
            rgba_.resize(4 * vertex, -1.0F);
            rgba_.insert(rgba_.end(), from.begin(), from.end());
        }
    }

    void colours() {
        float largest = -1.0F;
        bool any_alpha = false;
        for (std::size_t i = 0; i < rgba_.size(); ++i) {
            largest = i % 4 < 3 ? std::max(largest, rgba_[i]) : largest;
            any_alpha = any_alpha || (i % 4 == 3 && rgba_[i] >= 0.0F);
        }
        if (largest < 0.0F) {
            return;
        }
        scan_.byte_colours = largest > 1.001F;  // some scanners write bytes
        const float scale = scan_.byte_colours ? 1.0F / 255.0F : 1.0F;
        const auto n = scan_.mesh.vertices.cols();
        scan_.colours.setOnes(3, n);
        if (any_alpha) {
            scan_.alpha.setOnes(n);
        }
        for (std::size_t i = 0; i < rgba_.size(); ++i) {
            const auto v = static_cast<Eigen::Index>(i / 4);
            if (i % 4 == 3 && rgba_[i] >= 0.0F) {
                scan_.alpha[v] = std::min(rgba_[i] * scale, 1.0F);
            } else if (i % 4 != 3 && rgba_[i - i % 4] >= 0.0F) {
                scan_.colours(static_cast<Eigen::Index>(i % 4), v) =
                    std::clamp(rgba_[i] * scale, 0.0F, 1.0F);
            }
        }
    }

    /// Materials in the order of their first use.
    void materials() {
        std::unordered_map<std::string, int> numbers;
        int current = -1;
        int from = 0;
        const auto use_until = [&](int to) {
            if (current >= 0 && scan_.face_material.empty()) {
                scan_.face_material.assign(static_cast<std::size_t>(scan_.faces.count()), -1);
            }
            if (current >= 0) {
                std::fill(scan_.face_material.begin() + from, scan_.face_material.begin() + to,
                          current);
            }
            from = to;
        };
        for (const ObjStatement& statement : scan_.statements) {
            if (statement.text.rfind("usemtl", 0) != 0) {
                continue;
            }
            use_until(statement.before_face);
            const std::size_t at = statement.text.find_first_not_of(" \t", 6);
            const std::string material =
                at == std::string::npos ? std::string() : statement.text.substr(at);
            const auto [found, is_new] =
                numbers.emplace(material, static_cast<int>(scan_.materials.size()));
            if (is_new) {
                scan_.materials.push_back({material, {1.0F, 1.0F, 1.0F, 1.0F}, -1});
            }
            current = found->second;
        }
        use_until(scan_.faces.count());
    }

    std::string_view text_;
    const std::string& name_;
    Scan& scan_;
    std::vector<float> rgba_;  ///< 4 a vertex, as the pieces hold them
    bool any_uv_ = false;
    std::atomic<bool> before_first_ = false;  ///< an index counts back beyond the beginning
    int highest_vertex_ = -1, highest_uv_ = -1;
};

}  // namespace

void read_obj(std::string_view text, const std::string& name, Scan& scan,
              const Progress* progress) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") {
        text.remove_prefix(3);  // byte order mark
    }
    const std::vector<std::string_view> all = pieces_of(text);
    std::vector<ObjPiece> pieces;
    ObjJoiner joiner(text, name, scan);
    int line = 0;
    for (std::size_t first = 0; first < all.size(); first += kTogether) {
        if (progress != nullptr) {
            progress->report("Reading",
                             static_cast<double>(first) / static_cast<double>(all.size()));
        }
        pieces.resize(std::min(kTogether, all.size() - first));
        parallel_for(static_cast<int>(pieces.size()), 1, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                const auto k = static_cast<std::size_t>(i);
                pieces[k].clear();
                parse_obj_piece(all[first + k], pieces[k]);
            }
        });
        for (const ObjPiece& piece : pieces) {
            line += piece.lines;
            if (!piece.problem.empty()) {
                throw IoError(name + " line " + std::to_string(line) + ": " + piece.problem);
            }
        }
        joiner.add(
            pieces,
            static_cast<double>(all.size() - first) / static_cast<double>(pieces.size()) - 1.0);
    }
    joiner.finish();
}

}  // namespace myoface
