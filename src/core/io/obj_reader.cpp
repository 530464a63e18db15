// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "myoface/base/error.h"
#include "myoface/base/parallel.h"

#include "number_text.h"
#include "readers.h"

namespace myoface {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 20;

const char* skip_blanks(const char* at, const char* end) {
    while (at != end && is_blank(*at)) {
        ++at;
    }
    return at;
}

/// What one stretch of the file holds. Indices that count backwards are relative to its beginning
/// until the stretches before it are known.
struct Piece {
    std::string_view text;
    std::vector<double> positions;
    std::vector<float> colours;  ///< 4 a vertex, missing ones -1; shorter where the tail has none
    std::vector<float> uv;
    std::vector<int> face_sizes;
    std::vector<int> corner_vertex, corner_uv;
    std::vector<std::size_t> backward_vertex, backward_uv;  ///< corners to be shifted
    bool any_uv = false;
    std::vector<ObjStatement> statements;
    std::vector<std::string> libraries;
    int others = 0;
    int lines = 0;  ///< read so far
    std::string problem;
};

struct Problem {
    std::string what;
};

class PieceParser {
public:
    explicit PieceParser(Piece& piece) : piece_(piece) {}

    void parse() {
        try {
            const char* at = piece_.text.data();
            const char* const end = at + piece_.text.size();
            while (at != end) {
                const auto* newline = static_cast<const char*>(
                    std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
                const char* stop = newline != nullptr ? newline : end;
                ++piece_.lines;
                if (continues(at, stop)) {
                    newline = join(at, end);
                    statement(joined_.data(), joined_.data() + joined_.size());
                } else {
                    statement(at, stop);
                }
                at = newline != nullptr ? newline + 1 : end;
            }
        } catch (const Problem& problem) {
            piece_.problem = problem.what;
        }
    }

    static bool continues(const char* at, const char* stop) {
        while (stop != at && stop[-1] == '\r') {
            --stop;
        }
        return stop != at && stop[-1] == '\\';
    }

private:
    [[noreturn]] static void fail(const std::string& what) { throw Problem{what}; }

    /// Puts lines that end in a backslash together. @return the last newline, or null at the end
    const char* join(const char* at, const char* end) {
        joined_.clear();
        for (;;) {
            const auto* newline = static_cast<const char*>(
                std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
            const char* stop = newline != nullptr ? newline : end;
            const bool more = continues(at, stop);
            if (more) {
                while (stop[-1] == '\r') {
                    --stop;
                }
                joined_.append(at, stop - 1).push_back(' ');
            } else {
                joined_.append(at, stop);
            }
            if (!more || newline == nullptr) {
                return newline;
            }
            at = newline + 1;
            ++piece_.lines;
        }
    }

    void statement(const char* at, const char* end) {
        at = skip_blanks(at, end);
        if (at == end || *at == '#') {
            return;
        }
        const std::ptrdiff_t left = end - at;
        if (left >= 2 && is_blank(at[1])) {
            switch (*at) {
                case 'v':
                    vertex(at + 1, end);
                    return;
                case 'f':
                    face(at + 1, end);
                    return;
                case 'g':
                case 'o':
                case 's':
                    keep(at, end);
                    return;
                default:
                    break;
            }
        } else if (left >= 3 && at[0] == 'v' && is_blank(at[2])) {
            if (at[1] == 't') {
                texture_coordinate(at + 2, end);
            }
            return;  // normals are computed anew
        }
        rare(at, end);
    }

    void rare(const char* at, const char* end) {
        std::string_view line(at, static_cast<std::size_t>(end - at));
        while (!line.empty() && is_blank(line.back())) {
            line.remove_suffix(1);
        }
        const std::string_view key = line.substr(0, line.find_first_of(" \t"));
        if (key == "mtllib") {
            const std::size_t name = line.find_first_not_of(" \t", key.size());
            if (name != std::string_view::npos) {
                piece_.libraries.emplace_back(line.substr(name));
            }
        } else if (key == "usemtl") {
            keep(at, end);
        } else if (key == "f" || key == "v") {
            fail(key == "f" ? "a face needs at least three corners."
                            : "a vertex needs three coordinates.");
        } else if (line.find('\0') != std::string_view::npos) {
            fail("holds binary data, this is not an OBJ file.");
        } else if (key != "g" && key != "o" && key != "s") {
            ++piece_.others;
        }
    }

    void keep(const char* at, const char* end) {
        while (end != at && is_blank(end[-1])) {
            --end;
        }
        piece_.statements.push_back(
            {static_cast<int>(piece_.face_sizes.size()), std::string(at, end)});
    }

    static double number(const char*& at, const char* end, const char* what) {
        double value = 0.0;
        const char* const stop = read_number(at, end, value);
        if (stop == nullptr || (stop != end && !is_blank(*stop))) {
            fail(std::string(what) + " " + quoted(at, end) + " is not a number.");
        }
        if (!std::isfinite(value)) {
            fail(std::string(what) + " is not a finite number.");
        }
        at = skip_blanks(stop, end);
        return value;
    }

    void vertex(const char* at, const char* end) {
        at = skip_blanks(at, end);
        for (int axis = 0; axis < 3; ++axis) {
            if (at == end) {
                fail("a vertex needs three coordinates.");
            }
            piece_.positions.push_back(number(at, end, "coordinate"));
        }
        if (at == end || *at == '#') {
            return;
        }
        std::array<float, 4> extra{-1.0F, -1.0F, -1.0F, -1.0F};
        std::size_t extras = 0;
        while (at != end && *at != '#') {
            const auto value = static_cast<float>(number(at, end, "vertex value"));
            if (extras < extra.size()) {
                extra[extras++] = value;
            }
        }
        if (extras >= 3) {  // x y z r g b [a]; fewer are a weight
            piece_.colours.resize(piece_.positions.size() / 3 * 4 - 4, -1.0F);
            piece_.colours.insert(piece_.colours.end(), extra.begin(), extra.end());
        }
    }

    void texture_coordinate(const char* at, const char* end) {
        at = skip_blanks(at, end);
        const double u = number(at, end, "texture coordinate");
        const double v = at == end || *at == '#' ? 0.0 : number(at, end, "texture coordinate");
        if (!is_usable(u) || !is_usable(v)) {
            fail("texture coordinate is not a usable number.");
        }
        piece_.uv.push_back(static_cast<float>(u));
        piece_.uv.push_back(static_cast<float>(v));
    }

    /// @return the index from 0; one that counts backwards, relative to the piece's beginning
    static int index(const char*& at, const char* end, std::size_t count, bool& backward,
                     const char* what) {
        int value = 0;
        const char* const stop = read_whole(at, end, value);
        if (stop == nullptr || (stop != end && *stop != '/' && !is_blank(*stop))) {
            fail(std::string("face ") + what + " " + quoted(at, end) + " is not a whole number.");
        }
        if (value == 0) {
            fail(std::string("face ") + what + " 0 does not exist (the first one is 1).");
        }
        at = stop;
        backward = value < 0;
        return backward ? static_cast<int>(count) + value : value - 1;
    }

    void face(const char* at, const char* end) {
        int corners = 0;
        at = skip_blanks(at, end);
        while (at != end && *at != '#') {
            bool backward = false;
            const int v = index(at, end, piece_.positions.size() / 3, backward, "vertex");
            if (backward) {
                piece_.backward_vertex.push_back(piece_.corner_vertex.size());
            }
            int t = -1;
            if (at != end && *at == '/') {
                ++at;
                if (at != end && *at != '/' && !is_blank(*at)) {
                    t = index(at, end, piece_.uv.size() / 2, backward, "texture coordinate");
                    piece_.any_uv = true;
                    if (backward) {
                        piece_.backward_uv.push_back(piece_.corner_uv.size());
                    }
                }
                if (at != end && *at == '/') {
                    ++at;
                    int normal = 0;
                    const char* const stop = read_whole(at, end, normal);
                    if (stop == nullptr && at != end && !is_blank(*at)) {
                        fail("face normal " + quoted(at, end) + " is not a whole number.");
                    }
                    at = stop != nullptr ? stop : at;
                }
                if (at != end && !is_blank(*at)) {
                    fail("face corner ends in " + quoted(at, end) + ".");
                }
            }
            piece_.corner_vertex.push_back(v);
            piece_.corner_uv.push_back(t);
            ++corners;
            at = skip_blanks(at, end);
        }
        if (corners < 3) {
            fail("a face needs at least three corners.");
        }
        piece_.face_sizes.push_back(corners);
    }

    Piece& piece_;
    std::string joined_;
};

/// Stretches of about equal size that end where a statement ends.
std::vector<Piece> pieces_of(std::string_view text) {
    std::vector<Piece> pieces;
    while (!text.empty()) {
        std::size_t cut = std::min(kPieceBytes, text.size());
        while (cut < text.size()) {
            const std::size_t newline = text.find('\n', cut - 1);
            cut = newline == std::string_view::npos ? text.size() : newline + 1;
            if (newline == std::string_view::npos ||
                !PieceParser::continues(text.data(), text.data() + newline)) {
                break;
            }
            ++cut;
        }
        cut = std::min(cut, text.size());
        pieces.emplace_back();
        pieces.back().text = text.substr(0, cut);
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
        bool more = PieceParser::continues(text.data(), text.data() + stop);
        const bool is_face = at + 1 < text.data() + stop && *at == 'f' && is_blank(at[1]);
        text.remove_prefix(std::min(stop + 1, text.size()));
        while (more && !text.empty()) {
            const std::size_t next = std::min(text.find('\n'), text.size());
            more = PieceParser::continues(text.data(), text.data() + next);
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
std::vector<std::size_t> offsets(const std::vector<Piece>& pieces, const Get& get) {
    std::vector<std::size_t> result{0};
    for (const Piece& piece : pieces) {
        result.push_back(result.back() + get(piece));
    }
    return result;
}

class ObjJoiner {
public:
    ObjJoiner(std::string_view text, const std::string& name, std::vector<Piece>& pieces,
              Scan& scan)
        : text_(text), name_(name), pieces_(pieces), scan_(scan) {}

    void join() {
        const auto vertex = offsets(pieces_, [](const Piece& p) { return p.positions.size() / 3; });
        const auto uv = offsets(pieces_, [](const Piece& p) { return p.uv.size() / 2; });
        const auto face = offsets(pieces_, [](const Piece& p) { return p.face_sizes.size(); });
        const auto corner =
            offsets(pieces_, [](const Piece& p) { return p.corner_vertex.size(); });
        if (std::max({vertex.back(), uv.back(), corner.back()}) > 500'000'000) {
            throw IoError(name_ + ": has more vertices or corners than this program can hold.");
        }
        if (vertex.back() == 0) {
            throw IoError(name_ + ": holds no vertices, this is not a face scan.");
        }
        if (face.back() == 0) {
            throw IoError(name_ + ": holds points but no faces; export the scan as a mesh.");
        }
        scan_.mesh.vertices.resize(3, static_cast<Eigen::Index>(vertex.back()));
        scan_.uv.resize(2, static_cast<Eigen::Index>(uv.back()));
        scan_.faces.start.resize(face.back() + 1);
        scan_.faces.vertex.resize(corner.back());
        const bool any_uv = std::any_of(pieces_.begin(), pieces_.end(),
                                        [](const Piece& p) { return p.any_uv; });
        if (any_uv) {
            scan_.faces.uv.resize(corner.back());
        }
        std::vector<int> wrong(pieces_.size(), -1);  // first face with a bad index
        parallel_for(static_cast<int>(pieces_.size()), 1, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                Piece& piece = pieces_[static_cast<std::size_t>(i)];
                const auto k = static_cast<std::size_t>(i);
                std::copy(piece.positions.begin(), piece.positions.end(),
                          scan_.mesh.vertices.data() + 3 * vertex[k]);
                std::copy(piece.uv.begin(), piece.uv.end(), scan_.uv.data() + 2 * uv[k]);
                for (const std::size_t c : piece.backward_vertex) {
                    piece.corner_vertex[c] += static_cast<int>(vertex[k]);
                }
                for (const std::size_t c : piece.backward_uv) {
                    piece.corner_uv[c] += static_cast<int>(uv[k]);
                    // -1 would read as "none": one that reaches before the file stays wrong.
                    piece.corner_uv[c] = std::max(piece.corner_uv[c], -1) - (piece.corner_uv[c] < 0);
                }
                std::size_t c = 0;
                for (std::size_t f = 0; f < piece.face_sizes.size(); ++f) {
                    scan_.faces.start[face[k] + f] = static_cast<int>(corner[k] + c);
                    for (int n = 0; n < piece.face_sizes[f]; ++n, ++c) {
                        const int v = piece.corner_vertex[c];
                        const int t = piece.corner_uv[c];
                        if ((v < 0 || v >= static_cast<int>(vertex.back()) || t < -1 ||
                             t >= static_cast<int>(uv.back())) &&
                            wrong[k] < 0) {
                            wrong[k] = static_cast<int>(f);
                        }
                        scan_.faces.vertex[corner[k] + c] = v;
                        if (any_uv) {
                            scan_.faces.uv[corner[k] + c] = t;
                        }
                    }
                }
                piece.positions = {};
                piece.uv = {};
                piece.corner_uv = {};
            }
        });
        scan_.faces.start.back() = static_cast<int>(corner.back());
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            if (wrong[k] >= 0) {
                refuse(static_cast<int>(face[k]) + wrong[k]);
            }
        }
        colours(vertex);
        statements(face);
    }

private:
    [[noreturn]] void refuse(int face) const {
        std::string what = "a corner";
        for (int c = scan_.faces.start[face]; c < scan_.faces.start[face + 1]; ++c) {
            const auto say = [&](const char* kind, int index, Eigen::Index count) {
                what = std::string("face ") + kind + " " +
                       (index < 0 ? "before the first one" : std::to_string(index + 1)) +
                       " does not exist (the file has " + std::to_string(count) + ").";
            };
            if (scan_.faces.vertex[c] < 0 || scan_.faces.vertex[c] >= scan_.mesh.vertices.cols()) {
                say("vertex", scan_.faces.vertex[c], scan_.mesh.vertices.cols());
                break;
            }
            if (!scan_.faces.uv.empty() &&
                (scan_.faces.uv[c] < -1 || scan_.faces.uv[c] >= scan_.uv.cols())) {
                say("texture coordinate", scan_.faces.uv[c], scan_.uv.cols());
                break;
            }
        }
        throw IoError(name_ + " line " + std::to_string(line_of_face(text_, face)) + ": " + what);
    }

    void colours(const std::vector<std::size_t>& vertex) {
        float largest = -1.0F;
        bool any_alpha = false;
        for (const Piece& piece : pieces_) {
            for (std::size_t i = 0; i < piece.colours.size(); ++i) {
                largest = i % 4 < 3 ? std::max(largest, piece.colours[i]) : largest;
                any_alpha = any_alpha || (i % 4 == 3 && piece.colours[i] >= 0.0F);
            }
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
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            const std::vector<float>& from = pieces_[k].colours;
            for (std::size_t i = 0; i < from.size(); ++i) {
                const auto v = static_cast<Eigen::Index>(vertex[k] + i / 4);
                if (i % 4 == 3 && from[i] >= 0.0F) {
                    scan_.alpha[v] = std::min(from[i] * scale, 1.0F);
                } else if (i % 4 != 3 && from[i - i % 4] >= 0.0F) {
                    scan_.colours(static_cast<Eigen::Index>(i % 4), v) =
                        std::clamp(from[i] * scale, 0.0F, 1.0F);
                }
            }
        }
    }

    /// Groups as they came; materials in the order of their first use.
    void statements(const std::vector<std::size_t>& face) {
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
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            for (ObjStatement& statement : pieces_[k].statements) {
                statement.before_face += static_cast<int>(face[k]);
                if (statement.text.rfind("usemtl", 0) == 0) {
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
                scan_.statements.push_back(std::move(statement));
            }
            for (std::string& library : pieces_[k].libraries) {
                scan_.material_libraries.push_back(std::move(library));
            }
            scan_.findings.other_statements += pieces_[k].others;
        }
        use_until(scan_.faces.count());
    }

    std::string_view text_;
    const std::string& name_;
    std::vector<Piece>& pieces_;
    Scan& scan_;
};

}  // namespace

void read_obj(std::string_view text, const std::string& name, Scan& scan,
              const Progress* progress) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") {
        text.remove_prefix(3);  // byte order mark
    }
    std::vector<Piece> pieces = pieces_of(text);
    constexpr std::size_t kTogether = 16;  // between two looks at the cancel button
    for (std::size_t first = 0; first < pieces.size(); first += kTogether) {
        if (progress != nullptr) {
            progress->report("Reading",
                             static_cast<double>(first) / static_cast<double>(pieces.size()));
        }
        const std::size_t count = std::min(kTogether, pieces.size() - first);
        parallel_for(static_cast<int>(count), 1, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                PieceParser(pieces[first + static_cast<std::size_t>(i)]).parse();
            }
        });
        int line = 0;
        for (std::size_t k = 0; k < first + count; ++k) {
            line += pieces[k].lines;
            if (!pieces[k].problem.empty()) {
                throw IoError(name + " line " + std::to_string(line) + ": " + pieces[k].problem);
            }
        }
    }
    ObjJoiner(text, name, pieces, scan).join();
}

}  // namespace myoface
