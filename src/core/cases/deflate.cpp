// SPDX-License-Identifier: Apache-2.0
#include "deflate.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <vector>
#include <zlib.h>

#include "myoface/base/parallel.h"

namespace myoface {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;
constexpr int kRawWindow = -15;  // 32 KiB, without a header of its own
constexpr int kDeflateMemory = 8;

/// One piece; all but the last end on a whole byte, so that the next can follow.
Deflated piece_of(std::string_view bytes, int level, bool last) {
    z_stream stream{};
    if (deflateInit2(&stream, level, Z_DEFLATED, kRawWindow, kDeflateMemory, Z_DEFAULT_STRATEGY) !=
        Z_OK) {
        throw std::bad_alloc();
    }
    Deflated piece;
    const auto size = static_cast<uInt>(bytes.size());
    // NOLINTNEXTLINE: zlib's interface is older than const, and speaks of unsigned bytes
    auto* const from = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    piece.sum = static_cast<std::uint32_t>(crc32(crc32(0, nullptr, 0), from, size));
    constexpr std::size_t kMark = 16;  // what a flush adds
    piece.bytes.resize(deflateBound(&stream, size) + kMark);
    stream.next_in = from;
    stream.avail_in = size;
    stream.next_out = reinterpret_cast<Bytef*>(piece.bytes.data());  // NOLINT
    stream.avail_out = static_cast<uInt>(piece.bytes.size());
    ::deflate(&stream, last ? Z_FINISH : Z_SYNC_FLUSH);
    piece.bytes.resize(stream.total_out);
    deflateEnd(&stream);
    return piece;
}

}  // namespace

Deflated deflate(std::string_view bytes, int level, const Progress* progress) {
    const std::size_t count = std::max<std::size_t>(1, (bytes.size() + kPiece - 1) / kPiece);
    std::vector<Deflated> pieces(count);
    std::atomic<bool> cancelled{false};
    std::atomic<bool> short_of_memory{false};
    parallel_for(static_cast<int>(count), 1, [&](int begin, int end) {
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
            if (cancelled || short_of_memory) {
                return;
            }
            try {
                if (progress != nullptr) {
                    progress->report("packing", 0.5);
                }
                pieces[k] = piece_of(bytes.substr(k * kPiece, kPiece), level, k + 1 == count);
            } catch (const Cancelled&) {
                cancelled = true;
            } catch (const std::bad_alloc&) {
                short_of_memory = true;
            }
        }
    });
    if (cancelled) {
        throw Cancelled();
    }
    if (short_of_memory) {
        throw std::bad_alloc();
    }
    Deflated whole;
    std::size_t size = 0;
    for (const Deflated& piece : pieces) {
        size += piece.bytes.size();
    }
    whole.bytes.reserve(size);
    whole.sum = pieces[0].sum;
    for (std::size_t k = 0; k < count; ++k) {
        whole.bytes += pieces[k].bytes;
        if (k > 0) {
            const auto length = static_cast<z_off_t>(bytes.substr(k * kPiece, kPiece).size());
            whole.sum = static_cast<std::uint32_t>(crc32_combine(whole.sum, pieces[k].sum, length));
        }
    }
    return whole;
}

}  // namespace myoface
