// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"

#include "lower_case.h"
#include "number_text.h"
#include "readers.h"

namespace myoface {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestLibrary = 16'000'000;
constexpr std::uintmax_t kLargestTexture = 512'000'000;

bool is_inside(const fs::path& folder, const fs::path& file) {
    std::error_code error;
    const fs::path base = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    const fs::path real = error ? fs::path() : fs::canonical(file, error);
    if (error || !fs::is_regular_file(real, error)) {
        return false;
    }
    const auto [at, rest] = std::mismatch(base.begin(), base.end(), real.begin(), real.end());
    return at == base.end() || (std::next(at) == base.end() && at->empty());
}

/// The same name in other letters, as files from Windows often are.
std::optional<fs::path> in_any_case(const fs::path& folder, const std::string& name) {
    std::error_code error;
    int seen = 0;
    for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end;
         !error && entry != end && seen < 20000; entry.increment(error), ++seen) {
        if (lower_case(entry->path().filename().string()) == lower_case(name)) {
            return entry->path();
        }
    }
    return std::nullopt;
}

/// The words of a texture statement after its options; -s, -o and -t take up to three numbers.
std::string_view after_options(std::string_view rest) {
    const auto trim = [](std::string_view& text) {
        while (!text.empty() && is_blank(text.front())) {
            text.remove_prefix(1);
        }
    };
    const auto is_number = [](std::string_view word) {
        double value = 0.0;
        const char* const end = word.data() + word.size();
        return !word.empty() && read_number(word.data(), end, value) == end;
    };
    for (trim(rest); !rest.empty() && rest.front() == '-'; trim(rest)) {
        const std::size_t stop = std::min(rest.find_first_of(" \t"), rest.size());
        const std::string option = lower_case(std::string(rest.substr(0, stop)));
        const bool triple = option == "-s" || option == "-o" || option == "-t" || option == "-mm";
        const bool single = option == "-blendu" || option == "-blendv" || option == "-clamp" ||
                            option == "-cc" || option == "-imfchan" || option == "-texres" ||
                            option == "-bm" || option == "-boost" || option == "-type" ||
                            option == "-colorspace";
        if (!triple && !single) {
            break;  // a name that begins with a dash
        }
        rest.remove_prefix(stop);
        for (int taken = 0; taken < (triple ? 3 : 1); ++taken) {
            std::string_view ahead = rest;
            trim(ahead);
            const std::size_t end = std::min(ahead.find_first_of(" \t"), ahead.size());
            if (ahead.empty() || (triple && !is_number(ahead.substr(0, end)))) {
                break;
            }
            rest = ahead.substr(end);
        }
    }
    return rest;
}

class LibraryParser {
public:
    explicit LibraryParser(Scan& scan) : scan_(scan) {
        for (std::size_t i = 0; i < scan.materials.size(); ++i) {
            number_.emplace(scan.materials[i].name, static_cast<int>(i));
        }
    }

    void parse(std::string_view text) {
        if (text.substr(0, 3) == "\xEF\xBB\xBF") {
            text.remove_prefix(3);
        }
        current_ = -1;
        while (!text.empty()) {
            const std::size_t stop = std::min(text.find_first_of("\r\n"), text.size());
            statement(text.substr(0, stop));
            text.remove_prefix(std::min(stop + 1, text.size()));
        }
    }

private:
    void statement(std::string_view line) {
        const auto trim = [&] {
            while (!line.empty() && is_blank(line.front())) {
                line.remove_prefix(1);
            }
            while (!line.empty() && is_blank(line.back())) {
                line.remove_suffix(1);
            }
        };
        trim();
        const std::size_t stop = std::min(line.find_first_of(" \t"), line.size());
        const std::string key = lower_case(std::string(line.substr(0, stop)));
        line.remove_prefix(stop);
        trim();
        if (key == "newmtl") {
            const auto found = number_.find(std::string(line));
            current_ = found == number_.end() ? -1 : found->second;  // unused ones are left out
        } else if (current_ < 0) {
            return;
        } else if (key == "kd") {
            colour(line);
        } else if (key == "d" || key == "tr") {
            double value = 1.0;
            if (read_number(line.data(), line.data() + line.size(), value) != nullptr &&
                std::isfinite(value) && value >= 0.0 && value <= 1.0) {
                material().colour[3] = static_cast<float>(key == "d" ? value : 1.0 - value);
            }
        } else if (key == "map_kd") {
            const std::string name(after_options(line));
            if (!name.empty()) {
                material().texture = texture(name);
            }
        }
    }

    Material& material() { return scan_.materials[static_cast<std::size_t>(current_)]; }

    void colour(std::string_view line) {
        const char* at = line.data();
        const char* const end = at + line.size();
        for (std::size_t c = 0; c < 3; ++c) {
            double value = 0.0;
            while (at != end && is_blank(*at)) {
                ++at;
            }
            at = read_number(at, end, value);
            if (at == nullptr || !std::isfinite(value)) {
                return;
            }
            material().colour[c] = std::clamp(static_cast<float>(value), 0.0F, 1.0F);
        }
    }

    int texture(const std::string& name) {
        for (std::size_t i = 0; i < scan_.textures.size(); ++i) {
            if (scan_.textures[i].name == name) {
                return static_cast<int>(i);
            }
        }
        scan_.textures.push_back({name, {}});
        return static_cast<int>(scan_.textures.size()) - 1;
    }

    Scan& scan_;
    std::unordered_map<std::string, int> number_;
    int current_ = -1;
};

}  // namespace

std::optional<fs::path> companion(const fs::path& folder, std::string name) {
    while (!name.empty() && (name.front() == '"' || is_blank(name.front()))) {
        name.erase(0, 1);
    }
    while (!name.empty() && (name.back() == '"' || is_blank(name.back()))) {
        name.pop_back();
    }
    if (name.empty() || name.find('\0') != std::string::npos || name.size() > 4000) {
        return std::nullopt;
    }
    std::string slashes = name;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    const std::string last = slashes.substr(slashes.find_last_of('/') + 1);
    for (const std::string& tried : {name, slashes, last}) {
        // What lies elsewhere on the disk of the one who made the file is looked for here by name.
        if (!tried.empty() && fs::path(tried).is_relative() && is_inside(folder, folder / tried)) {
            return folder / tried;
        }
    }
    const auto found = last.empty() ? std::nullopt : in_any_case(folder, last);
    return found && is_inside(folder, *found) ? found : std::nullopt;
}

void read_materials(const fs::path& folder, Scan& scan) {
    std::error_code error;
    if (!scan.material_libraries.empty()) {
        LibraryParser parser(scan);
        for (const std::string& line : scan.material_libraries) {
            // One name with spaces, or several names.
            std::vector<std::string> names{line};
            for (std::size_t at = 0; !companion(folder, line) && at < line.size();) {
                const std::size_t begin = line.find_first_not_of(" \t", at);
                at = std::min(line.find_first_of(" \t", begin), line.size());
                if (begin != std::string::npos) {
                    names.push_back(line.substr(begin, at - begin));
                }
            }
            for (const std::string& name : names) {
                const auto file = companion(folder, name);
                if (file && fs::file_size(*file, error) <= kLargestLibrary) {
                    parser.parse(read_file(*file));
                }
            }
        }
    }
    for (Texture& texture : scan.textures) {
        const auto file = texture.bytes.empty() ? companion(folder, texture.name) : std::nullopt;
        if (file && fs::file_size(*file, error) <= kLargestTexture) {
            texture.bytes = read_file(*file);
        }
    }
}

}  // namespace myoface
