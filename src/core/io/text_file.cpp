// SPDX-License-Identifier: Apache-2.0
#include "myoface/io/text_file.h"

#include <array>
#include <charconv>
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

void write_file(const std::filesystem::path& file, std::string_view content) {
    std::filesystem::path part = file;
    part += ".part" + std::to_string(::getpid());
    {
        std::ofstream stream(part, std::ios::binary | std::ios::trunc);
        stream.write(content.data(), static_cast<std::streamsize>(content.size()));
        stream.flush();
        if (!stream) {
            std::error_code ignored;
            std::filesystem::remove(part, ignored);
            throw IoError(file.string() +
                          ": cannot be written (is the folder there, writable and not full?).");
        }
    }
    std::error_code error;
    std::filesystem::rename(part, file, error);
    if (error) {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        throw IoError(file.string() + ": cannot be written: " + error.message() + ".");
    }
}

void append_number(std::string& text, double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(buffer.data(), end.ptr);
}

}  // namespace myoface
