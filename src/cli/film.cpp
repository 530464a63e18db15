// SPDX-License-Identifier: Apache-2.0
#include "film.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

#include "myoface/base/error.h"

namespace myoface::cli {
namespace {

namespace fs = std::filesystem;

/// A program of the search path, or nothing.
std::string program(const std::string& name) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path file = fs::path(folder) / name;
        if (::access(file.c_str(), X_OK) == 0 && !fs::is_directory(file)) {
            return file.string();
        }
    }
    return {};
}

/// Runs a program silently. @return whether all went well
bool run(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int end : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        posix_spawn_file_actions_addopen(&actions, end, "/dev/null", O_RDWR, 0);
    }
    pid_t child = -1;
    const int failed =
        ::posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) {
        return false;
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

fs::path own_folder() {
    std::string name = (fs::temp_directory_path() / "myoface-film-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        throw IoError("There is no place for temporary files in " +
                      fs::temp_directory_path().string() + ".");
    }
    return name;
}

}  // namespace

Film::Film(fs::path output, int frames_per_second)
    : output_(std::move(output)), rate_(frames_per_second) {
    const std::string ending = output_.extension().string();
    if (ending == ".mp4") {
        encoder_ = program("ffmpeg");
    } else if (ending == ".gif") {
        for (const char* name : {"ffmpeg", "gifski", "magick", "convert"}) {
            if (encoder_.empty()) {
                encoder_ = program(name);
            }
        }
    } else if (ending.empty()) {
        folder_ = output_;
        std::error_code problem;
        fs::create_directories(folder_, problem);
        if (!fs::is_directory(folder_)) {
            throw IoError(output_.string() + ": the folder cannot be made.");
        }
        return;
    } else {
        throw InvalidInput(output_.string() +
                           ": a film is a .gif, an .mp4, or a folder of PNG pictures.");
    }
    if (encoder_.empty()) {
        throw InvalidInput(output_.string() + ": no program that makes " + ending +
                           " is installed (" +
                           (ending == ".mp4" ? "ffmpeg" : "ffmpeg, gifski or ImageMagick") +
                           "); give a folder instead, for PNG pictures.");
    }
    folder_ = own_folder();
}

Film::~Film() {
    if (!encoder_.empty()) {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
}

fs::path Film::frame(int number) const {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame-%03d.png", number);
    return folder_ / name.data();
}

void Film::add(const Image& picture) {
    write_png(frame(count_++), picture);
}

void Film::finish() {
    if (encoder_.empty()) {
        return;
    }
    const std::string ending = output_.extension().string();
    const std::string made = (folder_ / ("film" + ending)).string();
    const std::string all = (folder_ / "frame-%03d.png").string();
    const std::string rate = std::to_string(rate_);
    const std::string name = fs::path(encoder_).filename().string();
    std::vector<std::string> words{encoder_};
    const auto add = [&](std::initializer_list<std::string> more) {
        words.insert(words.end(), more);
    };
    if (name == "ffmpeg") {
        add({"-y", "-framerate", rate, "-i", all});
        if (ending == ".gif") {
            add({"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse"});
        } else {  // even sides, and colours that every player knows
            add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-crf", "18"});
        }
        add({made});
    } else if (name == "gifski") {
        add({"--fps", rate, "-o", made});
        for (int k = 0; k < count_; ++k) {
            words.push_back(frame(k).string());
        }
    } else {
        add({"-delay", std::to_string((100 + rate_ / 2) / rate_), "-loop", "0"});
        for (int k = 0; k < count_; ++k) {
            words.push_back(frame(k).string());
        }
        add({"-layers", "optimize", made});
    }
    if (!run(std::move(words)) || !fs::exists(made)) {
        throw IoError(output_.string() + ": " + name + " could not make it.");
    }
    // Beside its place first: the folder of temporary files may be on another disk.
    const fs::path beside = output_.string() + ".part";
    std::error_code problem;
    fs::copy_file(made, beside, fs::copy_options::overwrite_existing, problem);
    if (!problem) {
        fs::rename(beside, output_, problem);
    }
    if (problem) {
        std::error_code ignored;
        fs::remove(beside, ignored);
        throw IoError(output_.string() + ": cannot be written.");
    }
}

}  // namespace myoface::cli
