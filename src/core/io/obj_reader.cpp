// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
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

/// The file is read in pieces of this size, many at a time: large enough to hand out, small enough
/// that what comes of them stays in the cache until it is put in its place.
constexpr std::size_t kPieceBytes = std::size_t{1} << 18;
constexpr std::size_t kTogether = 32;

const char* skip_blanks(const char* at, const char* end) {
    while (at != end && is_blank(*at)) {
        ++at;
    }
    return at;
}

/// What one stretch of the file holds. Indices that count backwards are relative to its beginning
/// until the stretches before it are known. Two threads never write to one line of the cache.
struct alignas(128) Piece {
    std::vector<double> positions;
    std::vector<float> colours;  ///< 4 a vertex, missing ones -1; shorter where the tail has none
    std::vector<float> uv;
    std::vector<int> face_sizes;
    std::vector<int> corner_vertex;
    std::vector<int> corner_uv;  ///< one per corner once a face has had any, until then empty
    std::vector<std::size_t> backward_vertex, backward_uv;  ///< corners to be shifted
    std::vector<ObjStatement> statements;
    std::vector<std::string> libraries;
    int highest_vertex = -1, highest_uv = -1;  ///< of those that count forwards
    int others = 0;
    int lines = 0;  ///< read so far
    std::string problem;

    /// Empty, its memory kept.
    void clear() {
        positions.clear();
        colours.clear();
        uv.clear();
        face_sizes.clear();
        corner_vertex.clear();
        corner_uv.clear();
        backward_vertex.clear();
        backward_uv.clear();
        statements.clear();
        libraries.clear();
        highest_vertex = highest_uv = -1;
        others = lines = 0;
    }
};

struct Problem {
    std::string what;
};

class PieceParser {
public:
    explicit PieceParser(Piece& piece) : piece_(piece) {}

    void parse(std::string_view text) {
        try {
            const char* at = text.data();
            const char* const end = at + text.size();
            while (at != end) {
                if (end - at > 2 && at[1] == ' ' &&
                    (*at == 'v' ? plain_vertex(at, end) : *at == 'f' && plain_face(at, end))) {
                    continue;
                }
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

    /// @return whether a line ends at `at`, which is then moved behind it
    bool line_ends(const char*& at, const char* end) {
        const char* p = at;
        p += p != end && *p == '\r' ? 1 : 0;
        if (p == end || *p != '\n') {
            return false;
        }
        at = p + 1;
        ++piece_.lines;
        return true;
    }

    /// The line that nearly all vertices are: "v", three numbers, nothing else. @return false with
    /// nothing done for any other
    bool plain_vertex(const char*& at, const char* end) {
        std::array<double, 3> position{};
        const char* p = at + 1;
        for (double& x : position) {
            while (p != end && *p == ' ') {
                ++p;
            }
            p = read_number(p, end, x);
            if (p == nullptr || !std::isfinite(x)) {
                return false;
            }
        }
        while (p != end && *p == ' ') {
            ++p;
        }
        if (!line_ends(p, end)) {
            return false;
        }
        piece_.positions.insert(piece_.positions.end(), position.begin(), position.end());
        at = p;
        return true;
    }

    /// @return a number of up to 9 digits, or 0
    static int small_number(const char*& at, const char* end) {
        int value = 0;
        const char* const start = at;
        while (at != end && static_cast<unsigned char>(*at - '0') < 10 && at - start < 9) {
            value = value * 10 + (*at++ - '0');
        }
        return value;
    }

    /// The line that nearly all faces are: "f" and up to eight corners as 1, 1/2, 1/2/3 or 1//3.
    bool plain_face(const char*& at, const char* end) {
        std::array<int, 8> vertex{};
        std::array<int, 8> uv{};
        std::size_t corners = 0;
        bool any_uv = false;
        const char* p = at + 1;
        for (;;) {
            while (p != end && *p == ' ') {
                ++p;
            }
            if (p == end || corners == vertex.size()) {
                return false;
            }
            const int v = small_number(p, end);
            if (v == 0) {
                break;
            }
            vertex[corners] = v - 1;
            uv[corners] = -1;
            if (p != end && *p == '/') {
                ++p;
                uv[corners] = small_number(p, end) - 1;
                any_uv = any_uv || uv[corners] >= 0;
                if (uv[corners] < 0 && (p == end || *p != '/')) {
                    return false;
                }
                if (p != end && *p == '/') {
                    ++p;
                    small_number(p, end);
                }
            }
            if (p == end || (*p != ' ' && *p != '\n' && *p != '\r')) {
                return false;
            }
            ++corners;
        }
        if (corners < 3 || !line_ends(p, end)) {
            return false;
        }
        at = p;
        for (std::size_t c = 0; c < corners; ++c) {
            add_corner(vertex[c], uv[c]);
            piece_.highest_vertex = std::max(piece_.highest_vertex, vertex[c]);
            piece_.highest_uv = std::max(piece_.highest_uv, uv[c]);
        }
        piece_.face_sizes.push_back(static_cast<int>(corners));
        return true;
    }

    void start_uv() {
        if (!has_uv_) {
            piece_.corner_uv.assign(piece_.corner_vertex.size(), -1);
            has_uv_ = true;
        }
    }

    void add_corner(int vertex, int uv) {
        if (uv != -1) {
            start_uv();
        }
        piece_.corner_vertex.push_back(vertex);
        if (has_uv_) {
            piece_.corner_uv.push_back(uv);
        }
    }

    /// Puts lines that end in a backslash together. @return the last newline, or null at the end
    const char* join(const char* at, const char* end) {
        joined_.clear();
        for (;;) {
            const auto* newline =
                static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
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
            } else {
                piece_.highest_vertex = std::max(piece_.highest_vertex, v);
            }
            int t = -1;
            if (at != end && *at == '/') {
                ++at;
                if (at != end && *at != '/' && !is_blank(*at)) {
                    t = index(at, end, piece_.uv.size() / 2, backward, "texture coordinate");
                    if (backward) {
                        piece_.backward_uv.push_back(piece_.corner_vertex.size());
                        start_uv();
                    } else {
                        piece_.highest_uv = std::max(piece_.highest_uv, t);
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
            add_corner(v, t);
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
    bool has_uv_ = false;
};

/// Stretches of about equal size that end where a statement ends.
std::vector<std::string_view> pieces_of(std::string_view text) {
    std::vector<std::string_view> pieces;
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
std::vector<std::size_t> offsets(std::size_t begin, const std::vector<Piece>& pieces,
                                 const Get& get) {
    std::vector<std::size_t> result{begin};
    for (const Piece& piece : pieces) {
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
    void add(std::vector<Piece>& pieces, double left_to_read) {
        const auto old_uv = static_cast<std::size_t>(scan_.uv.cols());
        const auto vertex = offsets(static_cast<std::size_t>(scan_.mesh.vertices.cols()), pieces,
                                    [](const Piece& p) { return p.positions.size() / 3; });
        const auto uv = offsets(old_uv, pieces, [](const Piece& p) { return p.uv.size() / 2; });
        const auto face = offsets(static_cast<std::size_t>(scan_.faces.count()), pieces,
                                  [](const Piece& p) { return p.face_sizes.size(); });
        const auto corner = offsets(scan_.faces.vertex.size(), pieces,
                                    [](const Piece& p) { return p.corner_vertex.size(); });
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
                                         [](const Piece& p) { return !p.corner_uv.empty(); });
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
            Piece& piece = pieces[k];
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
    void place(Piece& piece, std::size_t vertex, std::size_t uv, std::size_t face,
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
    std::vector<Piece> pieces;
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
                PieceParser(pieces[k]).parse(all[first + k]);
            }
        });
        for (const Piece& piece : pieces) {
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
