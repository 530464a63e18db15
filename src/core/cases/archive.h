// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "myoface/base/progress.h"

struct zip;

namespace myoface {

/// Closes a zip without writing.
struct CloseZip {
    void operator()(zip* handle) const;
};

/// A zip that is read. What it holds is believed only as far as it can be checked.
class ZipReader {
public:
    /// @param name of the file, for sentences @param passphrase or nothing
    /// @throws IoError when it is no zip
    ZipReader(const std::filesystem::path& file, std::string name, std::string passphrase);
    struct Memory {
        std::string_view bytes;  ///< outlive it
    };
    ZipReader(Memory memory, std::string name, std::string passphrase);

    /// The bytes of a part; nothing where it is missing and not needed.
    /// @throws IoError, PassphraseNeeded
    std::string part(const std::string& part, bool needed) const;
    bool has(const std::string& part) const;
    bool encrypted(const std::string& part) const;

private:
    void take_passphrase();

    std::string name_, passphrase_;
    std::uintmax_t size_ = 0;  ///< of the whole [bytes]
    std::unique_ptr<zip, CloseZip> handle_;
};

/// A part of a zip; the bytes outlive the packing.
struct ZipPart {
    std::string name;
    std::string_view bytes;
};
/// A whole zip in memory, so that a file can appear whole or not at all.
/// @param passphrase where not empty, parts are encrypted by AES-256 (WinZip AE-2)
/// @throws IoError, Cancelled
std::string zip_bytes(const std::vector<ZipPart>& parts, const std::string& passphrase,
                      const std::string& name, const Progress* progress = nullptr);

}  // namespace myoface
