// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/user_expressions.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/face/muscle_atlas.h"
#include "myoface/io/text_file.h"
#include "myoface/muscle/contraction.h"

namespace myoface {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 60;  // bytes
constexpr std::uintmax_t kLargestFile = 100'000;

/// A file name for any name: what is not a letter, digit, '-' or '_' becomes its number.
fs::path file_of(const std::string& name) {
    std::string file;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || c == '-' || c == '_') {
            file += c;
        } else {
            char code[5];
            std::snprintf(code, sizeof code, "%%%02X", byte);
            file += code;
        }
    }
    return user_expression_folder() / (file + ".json");
}

void check_name(const std::string& name) {
    const bool odd = std::any_of(name.begin(), name.end(), [](char c) {
        return c == '=' || static_cast<unsigned char>(c) < 0x20;
    });
    if (name.empty() || name.size() > kLongestName || odd) {
        throw InvalidInput("A preset needs a name of at most 60 characters without '='.");
    }
    if (is_own_expression(name)) {
        throw InvalidInput("'" + name + "' is an expression of the program: take another name.");
    }
}

}  // namespace

fs::path user_expression_folder() {
    if (const char* given = std::getenv("MYOFACE_EXPRESSIONS")) {
        return given;
    }
    if (const char* data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0') {
        return fs::path(data) / "myoface" / "expressions";
    }
    if (const char* home = std::getenv("HOME")) {
        return fs::path(home) / ".local" / "share" / "myoface" / "expressions";
    }
    const char* roaming = std::getenv("APPDATA");
    return fs::path(roaming != nullptr ? roaming : ".") / "myoface" / "expressions";
}

Expression user_expression_from_json(std::string_view text, const std::string& name) {
    const json document = json::parse(text, nullptr, false);
    try {
        Expression expression;
        expression.name = document.at("name").get<std::string>();
        expression.title = expression.title_ja = expression.name;
        for (const auto& [muscle, rate] : document.at("contractions").items()) {
            const double value = rate.get<double>();
            if (!(value >= kLeastContraction && value <= kMostContraction)) {
                throw InvalidInput("a contraction is outside -0.5 ... 1.");
            }
            for (const int m : muscles_named(muscle)) {
                expression.rates.emplace_back(m, value);
            }
        }
        return expression;
    } catch (const std::exception& error) {
        throw IoError(name + ": is no preset of an expression (" + error.what() + ").");
    }
}

std::vector<Expression> user_expressions() {
    std::vector<Expression> result;
    std::error_code error;
    for (fs::directory_iterator at(user_expression_folder(), error), end; !error && at != end;
         at.increment(error)) {
        try {
            if (at->path().extension() == ".json" && at->file_size() < kLargestFile) {
                result.push_back(
                    user_expression_from_json(read_file(at->path()), at->path().string()));
            }
        } catch (const std::exception&) {
            continue;  // somebody else's file
        }
    }
    std::sort(result.begin(), result.end(),
              [](const Expression& a, const Expression& b) { return a.name < b.name; });
    return result;
}

void save_user_expression(const std::string& name, const std::vector<double>& rates) {
    check_name(name);
    json contractions = json::object();
    for (std::size_t m = 0; m < rates.size(); ++m) {
        if (rates[m] != 0.0) {
            contractions[muscle_atlas().at(m).traits.name] = rates[m];
        }
    }
    const json document = {{"schema", "myoface-expression"},
                           {"version", 1},
                           {"name", name},
                           {"contractions", contractions}};
    std::error_code error;
    fs::create_directories(user_expression_folder(), error);
    write_file(file_of(name), document.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
}

void remove_user_expression(const std::string& name) {
    std::error_code error;
    if (!fs::remove(file_of(name), error)) {
        if (error) {
            throw IoError(file_of(name).string() + ": " + error.message() + ".");
        }
        throw InvalidInput("There is no preset '" + name + "' of your own.");
    }
}

}  // namespace myoface
