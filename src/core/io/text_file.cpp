// SPDX-License-Identifier: Apache-2.0
#include "myoface/io/text_file.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <fstream>
#include <system_error>
#include <unistd.h>

#include "myoface/base/error.h"

namespace myoface {

std::string read_file(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        throw IoError(file.string() + ": there is no such file.");
    }
    if (!std::filesystem::is_regular_file(file, error)) {
        throw IoError(file.string() + ": is not a regular file.");
    }
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    if (!stream) {
        throw IoError(file.string() + ": cannot be opened for reading.");
    }
    std::string content(static_cast<std::size_t>(stream.tellg()), '\0');
    stream.seekg(0);
    stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    if (!stream) {
        throw IoError(file.string() + ": cannot be read to its end.");
    }
    return content;
}

void write_file(const std::filesystem::path& file, std::string_view content,
                Durability durability) {
    std::filesystem::path part = file;
    part += ".part" + std::to_string(::getpid());
    const auto give_up = [&](int reason) {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        throw IoError(file.string() + ": cannot be written (" +
                      std::generic_category().message(reason) +
                      "); is the folder there, writable and not full?");
    };
    const int out = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (out < 0) {
        give_up(errno);
    }
    int problem = 0;
    while (!content.empty() && problem == 0) {
        const ssize_t written = ::write(out, content.data(), content.size());
        if (written < 0) {
            problem = errno == EINTR ? 0 : errno;
        } else {
            content.remove_prefix(static_cast<std::size_t>(written));
        }
    }
    const bool durable = durability == Durability::SurvivesPowerLoss;
    if (problem == 0 && durable && ::fsync(out) != 0) {
        problem = errno;
    }
    if (::close(out) != 0 && problem == 0) {
        problem = errno;
    }
    if (problem == 0 && ::rename(part.c_str(), file.c_str()) != 0) {
        problem = errno;
    }
    if (problem != 0) {
        give_up(problem);
    }
    if (durable) {  // the new name too
        const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
        const int directory = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (directory >= 0) {
            ::fsync(directory);
            ::close(directory);
        }
    }
}

void append_number(std::string& text, double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(buffer.data(), end.ptr);
}

}  // namespace myoface
