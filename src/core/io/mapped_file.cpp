// SPDX-License-Identifier: Apache-2.0
#include "myoface/io/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "myoface/base/error.h"

namespace myoface {

MappedFile::MappedFile(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        throw IoError(file.string() + ": there is no such file.");
    }
    if (!std::filesystem::is_regular_file(file, error)) {
        throw IoError(file.string() + ": is not a regular file.");
    }
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
        throw IoError(file.string() + ": cannot be opened for reading.");
    }
    struct stat status {};
    if (::fstat(descriptor, &status) == 0 && status.st_size > 0) {
        const auto size = static_cast<std::size_t>(status.st_size);
        void* const at =
            ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, descriptor, 0);
        if (at != MAP_FAILED) {
            data_ = static_cast<const char*>(at);
            size_ = size;
        }
    }
    ::close(descriptor);
    if (data_ == nullptr && status.st_size != 0) {
        throw IoError(file.string() + ": cannot be read to its end.");
    }
}

MappedFile::~MappedFile() {
    if (data_ != nullptr) {
        ::munmap(const_cast<char*>(data_), size_);
    }
}

}  // namespace myoface
