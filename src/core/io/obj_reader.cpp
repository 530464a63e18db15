// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cmath>
#include <cstring>

#include "myoface/base/error.h"

#include "readers.h"

namespace myoface {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

/// Walks over the words of one logical line.
class Words {
public:
    explicit Words(std::string_view line) : rest_(line) {}

    std::string_view next() {
        skip();
        std::size_t end = 0;
        while (end < rest_.size() && !is_space(rest_[end])) {
            ++end;
        }
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return word;
    }

    std::string_view rest() {
        skip();
        std::string_view text = rest_;
        while (!text.empty() && is_space(text.back())) {
            text.remove_suffix(1);
        }
        return text;
    }

private:
    void skip() {
        while (!rest_.empty() && is_space(rest_.front())) {
            rest_.remove_prefix(1);
        }
    }
    std::string_view rest_;
};

class ObjParser {
public:
    ObjParser(std::string_view text, const std::string& name, Scan& scan, const Progress* progress)
        : text_(text), name_(name), scan_(scan), progress_(progress) {}

    void parse() {
        std::size_t at = 0;
        if (text_.substr(0, 3) == "\xEF\xBB\xBF") {
            at = 3;  // byte order mark
        }
        while (at < text_.size()) {
            ++line_number_;
            std::string_view line = take_line(at);
            if (!line.empty() && line.back() == '\\') {
                joined_.clear();
                while (!line.empty() && line.back() == '\\' && at < text_.size()) {
                    joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
                    line = take_line(at);
                    ++line_number_;
                }
                joined_.append(line);
                statement(joined_);
            } else {
                statement(line);
            }
            if (progress_ != nullptr && line_number_ % 65536 == 0) {
                progress_->report("Reading",
                                  static_cast<double>(at) / static_cast<double>(text_.size()));
            }
        }
        finish();
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw IoError(name_ + " line " + std::to_string(line_number_) + ": " + what);
    }

    std::string_view take_line(std::size_t& at) const {
        const void* found = std::memchr(text_.data() + at, '\n', text_.size() - at);
        const std::size_t end =
            found != nullptr
                ? static_cast<std::size_t>(static_cast<const char*>(found) - text_.data())
                : text_.size();
        std::string_view line = text_.substr(at, end - at);
        at = end + 1;
        if (!line.empty() && line.back() == '\r') {
            line.remove_suffix(1);
        }
        return line;
    }

    double number(std::string_view word, const char* what) const {
        if (!word.empty() && word.front() == '+') {
            word.remove_prefix(1);
        }
        double value = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || error != std::errc() || end != word.data() + word.size()) {
            fail(std::string(what) + " '" + std::string(word.substr(0, 40)) + "' is not a number.");
        }
        if (!std::isfinite(value)) {
            fail(std::string(what) + " is not a finite number.");
        }
        return value;
    }

    void statement(std::string_view line) {
        Words words(line);
        const std::string_view key = words.next();
        if (key.empty() || key.front() == '#') {
            return;
        }
        if (key == "v") {
            vertex(words);
        } else if (key == "vt") {
            const auto u = static_cast<float>(number(words.next(), "texture coordinate"));
            const std::string_view second = words.next();
            const auto v =
                second.empty() ? 0.0F : static_cast<float>(number(second, "texture coordinate"));
            uv_.push_back({u, v});
        } else if (key == "f") {
            face(words);
        } else if (key == "mtllib") {
            scan_.material_libraries.emplace_back(words.rest());
        } else if (key == "usemtl" || key == "g" || key == "o" || key == "s") {
            scan_.statements.push_back({scan_.faces.count(), std::string(line)});
        } else if (line.find('\0') != std::string_view::npos) {
            fail("holds binary data, this is not an OBJ file.");
        }  // points, lines, curves and normals carry nothing that is simulated
    }

    void vertex(Words& words) {
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = words.next();
            if (word.empty()) {
                fail("a vertex needs three coordinates.");
            }
            positions_.push_back(number(word, "coordinate"));
        }
        std::array<float, 4> extra{};
        std::size_t extras = 0;
        for (std::string_view word = words.next(); !word.empty() && word.front() != '#';
             word = words.next()) {
            const double value = number(word, "vertex value");
            if (extras < extra.size()) {
                extra[extras++] = static_cast<float>(value);
            }
        }
        if (extras >= 3) {  // x y z r g b; a single extra value is a weight
            const std::size_t skip = extras == 4 ? 1 : 0;
            colours_.resize(positions_.size() - 3, 1.0F);
            colours_.insert(colours_.end(), extra.begin() + skip, extra.begin() + skip + 3);
        }
    }

    int index(std::string_view word, std::size_t count, const char* what) const {
        int value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || error != std::errc() || end != word.data() + word.size()) {
            fail(std::string("face ") + what + " '" + std::string(word.substr(0, 40)) +
                 "' is not a whole number.");
        }
        const long long resolved = value > 0 ? value - 1LL : static_cast<long long>(count) + value;
        if (value == 0 || resolved < 0) {
            fail(std::string("face ") + what + " " + std::to_string(value) +
                 " does not exist (the first one is 1).");
        }
        return static_cast<int>(resolved);
    }

    void face(Words& words) {
        const std::size_t begin = scan_.faces.vertex.size();
        for (std::string_view word = words.next(); !word.empty() && word.front() != '#';
             word = words.next()) {
            const std::size_t slash = word.find('/');
            const int v = index(word.substr(0, slash), positions_.size() / 3, "vertex");
            int t = -1;
            if (slash != std::string_view::npos) {
                const std::string_view rest = word.substr(slash + 1);
                const std::string_view uv_word = rest.substr(0, rest.find('/'));
                if (!uv_word.empty()) {
                    t = index(uv_word, uv_.size(), "texture coordinate");
                }
            }
            scan_.faces.vertex.push_back(v);
            scan_.faces.uv.push_back(t);
        }
        if (scan_.faces.vertex.size() - begin < 3) {
            fail("a face needs at least three corners.");
        }
        scan_.faces.start.push_back(static_cast<int>(scan_.faces.vertex.size()));
        face_lines_.push_back(line_number_);
    }

    /// Positive indices may point forward, so ranges are checked once everything is read.
    void finish() {
        const auto vertices = static_cast<int>(positions_.size() / 3);
        if (vertices == 0) {
            throw IoError(name_ + ": holds no vertices, this is not a face scan.");
        }
        if (scan_.faces.count() == 0) {
            throw IoError(name_ + ": holds points but no faces; export the scan as a mesh.");
        }
        bool any_uv = false;
        for (int f = 0; f < scan_.faces.count(); ++f) {
            for (int c = scan_.faces.start[f]; c < scan_.faces.start[f + 1]; ++c) {
                line_number_ = face_lines_[f];
                if (scan_.faces.vertex[c] >= vertices) {
                    fail("face vertex " + std::to_string(scan_.faces.vertex[c] + 1) +
                         " does not exist (the file has " + std::to_string(vertices) + ").");
                }
                if (scan_.faces.uv[c] >= static_cast<int>(uv_.size())) {
                    fail("face texture coordinate " + std::to_string(scan_.faces.uv[c] + 1) +
                         " does not exist (the file has " + std::to_string(uv_.size()) + ").");
                }
                any_uv = any_uv || scan_.faces.uv[c] >= 0;
            }
        }
        if (!any_uv) {
            scan_.faces.uv.clear();
        }
        scan_.mesh.vertices = Eigen::Map<const Points>(positions_.data(), 3, vertices);
        scan_.uv.resize(2, static_cast<Eigen::Index>(uv_.size()));
        for (std::size_t i = 0; i < uv_.size(); ++i) {
            scan_.uv.col(static_cast<Eigen::Index>(i)) << uv_[i][0], uv_[i][1];
        }
        if (!colours_.empty()) {
            colours_.resize(positions_.size(), 1.0F);
            scan_.colours = Eigen::Map<const Eigen::Matrix3Xf>(colours_.data(), 3, vertices);
            if (scan_.colours.maxCoeff() > 1.001F) {
                scan_.colours /= 255.0F;  // some scanners write bytes
            }
            scan_.colours = scan_.colours.cwiseMax(0.0F).cwiseMin(1.0F);
        }
    }

    std::string_view text_;
    const std::string& name_;
    Scan& scan_;
    const Progress* progress_;
    int line_number_ = 0;
    std::string joined_;
    std::vector<double> positions_;
    std::vector<float> colours_;
    std::vector<std::array<float, 2>> uv_;
    std::vector<int> face_lines_;
};

}  // namespace

void read_obj(std::string_view text, const std::string& name, Scan& scan,
              const Progress* progress) {
    ObjParser(text, name, scan, progress).parse();
}

}  // namespace myoface
