// SPDX-License-Identifier: Apache-2.0
#include "obj_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace myoface {
namespace {

struct Problem {
    std::string what;
};

class PieceParser {
public:
    explicit PieceParser(ObjPiece& piece) : piece_(piece) {}

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
                if (statement_continues(at, stop)) {
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
            const bool more = statement_continues(at, stop);
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

    ObjPiece& piece_;
    std::string joined_;
    bool has_uv_ = false;
};

}  // namespace

bool statement_continues(const char* at, const char* stop) {
    while (stop != at && stop[-1] == '\r') {
        --stop;
    }
    return stop != at && stop[-1] == '\\';
}

void parse_obj_piece(std::string_view text, ObjPiece& piece) {
    PieceParser(piece).parse(text);
}

}  // namespace myoface
