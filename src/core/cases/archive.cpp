// SPDX-License-Identifier: Apache-2.0
#include "archive.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <utility>
#include <zip.h>

#include "myoface/cases/case_file.h"

#include "deflate.h"

namespace myoface {
namespace {

constexpr zip_uint64_t kLargestPart = 2'000'000'000;
constexpr zip_uint64_t kUncheckedPart = 16'000'000;
constexpr zip_uint64_t kMostShrinking = 200;
constexpr std::size_t kTaken = 16'000'000;  // at a time, however much is announced

}  // namespace

void CloseZip::operator()(zip* handle) const {
    zip_discard(handle);
}

ZipReader::ZipReader(const std::filesystem::path& file, std::string name, std::string passphrase)
    : name_(std::move(name)), passphrase_(std::move(passphrase)) {
    int code = 0;
    std::error_code none;
    size_ = std::filesystem::file_size(file, none);
    handle_.reset(zip_open(file.c_str(), ZIP_RDONLY, &code));
    take_passphrase();
}

ZipReader::ZipReader(Memory memory, std::string name, std::string passphrase)
    : name_(std::move(name)), passphrase_(std::move(passphrase)), size_(memory.bytes.size()) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source =
        zip_source_buffer_create(memory.bytes.data(), memory.bytes.size(), 0, &error);
    if (source != nullptr) {
        handle_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
        if (!handle_) {
            zip_source_free(source);
        }
    }
    zip_error_fini(&error);
    take_passphrase();
}

void ZipReader::take_passphrase() {
    if (!handle_) {
        throw IoError(name_ + ": is not a Myoface case (it is not a zip archive).");
    }
    if (!passphrase_.empty()) {
        zip_set_default_password(handle_.get(), passphrase_.c_str());
    }
}

bool ZipReader::has(const std::string& part) const {
    return zip_name_locate(handle_.get(), part.c_str(), 0) >= 0;
}

bool ZipReader::encrypted(const std::string& part) const {
    zip_stat_t stat;
    zip_stat_init(&stat);
    return zip_stat(handle_.get(), part.c_str(), 0, &stat) == 0 &&
           (stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE;
}

std::string ZipReader::part(const std::string& part, bool needed) const {
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat(handle_.get(), part.c_str(), 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0) {
        if (needed) {
            throw IoError(name_ + ": is not a Myoface case (" + part + " is missing).");
        }
        return {};
    }
    // A small archive must not unpack to more than a scan can be; no scan shrinks so far.
    const zip_uint64_t packed = (stat.valid & ZIP_STAT_COMP_SIZE) != 0 ? stat.comp_size : 0;
    if (packed > size_) {
        throw IoError(name_ + ": " + part + " cannot be unpacked, the case is damaged.");
    }
    const bool bomb = stat.size > kUncheckedPart && stat.size / kMostShrinking > packed;
    if (stat.size > kLargestPart || bomb) {
        throw IoError(name_ + ": " + part + " is larger than a case can hold.");
    }
    const bool locked = encrypted(part);
    if (locked && passphrase_.empty()) {
        throw PassphraseNeeded(name_, false);
    }
    zip_file_t* file = zip_fopen(handle_.get(), part.c_str(), 0);
    if (file == nullptr) {
        const int code = zip_error_code_zip(zip_get_error(handle_.get()));
        if (locked && (code == ZIP_ER_WRONGPASSWD || code == ZIP_ER_NOPASSWD)) {
            throw PassphraseNeeded(name_, true);
        }
        throw IoError(name_ + ": " + part + " cannot be unpacked, the case is damaged.");
    }
    // Sizes are as good as who wrote them: no more memory than bytes have come.
    std::string bytes;
    bool good = true;
    while (good && bytes.size() < stat.size) {
        const std::size_t at = bytes.size();
        const std::size_t step = std::min<std::size_t>(kTaken, stat.size - at);
        bytes.resize(at + step);
        good = zip_fread(file, bytes.data() + at, step) == static_cast<zip_int64_t>(step);
    }
    char more = 0;
    good = good && zip_fread(file, &more, 1) == 0;  // at the end, sums are checked
    zip_fclose(file);
    if (!good) {
        throw IoError(name_ + ": " + part + " cannot be unpacked, the case is damaged.");
    }
    return bytes;
}

namespace {

/// Lets a packing end that is not wanted any more.
struct Watch {
    const Progress* progress;
    bool cancelled;

    static int look(zip_t*, void* self) {
        auto* watch = static_cast<Watch*>(self);
        try {
            watch->progress->report("packing", 0.5);
        } catch (const Cancelled&) {
            watch->cancelled = true;
        }
        return watch->cancelled ? 1 : 0;
    }
};

/// A part that is compressed already, as libzip reads it: it copies such bytes as they are.
struct ReadyPart {
    std::size_t size = 0;  ///< before it was compressed
    Deflated packed;
    std::size_t at = 0;

    static zip_int64_t serve(void* self, void* data, zip_uint64_t length, zip_source_cmd_t what) {
        auto* part = static_cast<ReadyPart*>(self);
        switch (what) {
            case ZIP_SOURCE_OPEN:
                part->at = 0;
                return 0;
            case ZIP_SOURCE_READ: {
                const std::size_t taken =
                    std::min<std::size_t>(length, part->packed.bytes.size() - part->at);
                std::memcpy(data, part->packed.bytes.data() + part->at, taken);
                part->at += taken;
                return static_cast<zip_int64_t>(taken);
            }
            case ZIP_SOURCE_STAT: {
                auto* stat = static_cast<zip_stat_t*>(data);
                zip_stat_init(stat);
                stat->valid = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_CRC |
                              ZIP_STAT_COMP_METHOD | ZIP_STAT_ENCRYPTION_METHOD;
                stat->size = part->size;
                stat->comp_size = part->packed.bytes.size();
                stat->crc = part->packed.sum;
                stat->comp_method = ZIP_CM_DEFLATE;
                stat->encryption_method = ZIP_EM_NONE;
                return sizeof(zip_stat_t);
            }
            case ZIP_SOURCE_SUPPORTS:
                return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ,
                                                      ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT,
                                                      ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, -1);
            default:
                return 0;
        }
    }
};

}  // namespace

std::string zip_bytes(const std::vector<ZipPart>& parts, const std::string& passphrase,
                      const std::string& name, const Progress* progress) {
    const auto fail = [&] {
        return IoError(name + ": the case cannot be packed, memory may be short.");
    };
    std::deque<ReadyPart> ready;  // libzip keeps their addresses
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
    const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> keep(target, zip_source_free);
    std::unique_ptr<zip, CloseZip> archive(
        target != nullptr ? zip_open_from_source(target, ZIP_TRUNCATE, &error) : nullptr);
    zip_error_fini(&error);
    if (!archive) {
        throw fail();
    }
    zip_source_keep(target);
    for (const ZipPart& part : parts) {
        // Time counts more than the last tenth of size.
        constexpr std::size_t kLarge = 1 << 20;
        const int level = part.bytes.size() > kLarge ? 1 : 6;
        try {
            ready.push_back({part.bytes.size(), deflate(part.bytes, level, progress), 0});
        } catch (const std::bad_alloc&) {
            throw fail();
        }
        zip_source_t* source = zip_source_function(archive.get(), &ReadyPart::serve, &ready.back());
        const zip_int64_t added = source == nullptr ? -1
                                                    : zip_file_add(archive.get(), part.name.c_str(),
                                                                   source, ZIP_FL_OVERWRITE);
        if (added < 0) {
            zip_source_free(source);
            throw fail();
        }
        const auto index = static_cast<zip_uint64_t>(added);
        zip_set_file_compression(archive.get(), index, ZIP_CM_DEFLATE, 0);
        if (!passphrase.empty() && zip_file_set_encryption(archive.get(), index, ZIP_EM_AES_256,
                                                           passphrase.c_str()) != 0) {
            throw IoError(name +
                          ": this computer's libzip cannot encrypt; save without a "
                          "passphrase.");
        }
    }
    Watch watch{progress, false};
    if (progress != nullptr) {
        zip_register_cancel_callback_with_state(archive.get(), &Watch::look, nullptr, &watch);
    }
    if (zip_close(archive.get()) != 0) {
        if (watch.cancelled) {
            throw Cancelled();
        }
        throw fail();
    }
    archive.release();  // NOLINT: zip_close() has freed it
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_source_stat(target, &stat) != 0 || zip_source_open(target) != 0) {
        throw fail();
    }
    std::string result(stat.size, '\0');
    const bool whole =
        zip_source_read(target, result.data(), stat.size) == static_cast<zip_int64_t>(stat.size);
    zip_source_close(target);
    if (!whole) {
        throw fail();
    }
    return result;
}

}  // namespace myoface
