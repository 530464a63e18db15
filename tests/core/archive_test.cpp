// SPDX-License-Identifier: Apache-2.0
// What a case's zip holds comes back as it was, whoever packed it with how many threads.
#include "cases/archive.h"

#include <random>
#include <zlib.h>

#include <gtest/gtest.h>

#include "myoface/base/parallel.h"
#include "myoface/cases/case_file.h"

#include "cases/deflate.h"

namespace myoface {
namespace {

/// Bytes that shrink to about a half.
std::string half_random(std::size_t size) {
    std::mt19937 random(7);
    std::string bytes(size, '\0');
    for (char& byte : bytes) {
        byte = static_cast<char>('a' + random() % 16);
    }
    return bytes;
}

std::string inflated(const std::string& bytes, std::size_t size) {
    z_stream stream{};
    EXPECT_EQ(inflateInit2(&stream, -15), Z_OK);
    std::string result(size + 1, '\0');
    std::string from = bytes;
    stream.next_in = reinterpret_cast<Bytef*>(from.data());
    stream.avail_in = static_cast<uInt>(from.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(result.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
    result.resize(stream.total_out);
    inflateEnd(&stream);
    return result;
}

TEST(Deflate, GivesOneStreamThatAnyInflaterReads) {
    constexpr std::size_t kPiece = 1 << 20;
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{1}, kPiece - 1, kPiece, kPiece + 1, 3 * kPiece + 12345}) {
        const std::string bytes = half_random(size);
        const Deflated packed = deflate(bytes, 1);
        EXPECT_EQ(inflated(packed.bytes, size), bytes) << size;
        EXPECT_EQ(packed.sum,
                  crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(size)))
            << size;
    }
}

TEST(Deflate, IsTheSameForAnyNumberOfThreads) {
    const std::string bytes = half_random(5'000'000);
    const int before = thread_count();
    set_thread_count(1);
    const Deflated one = deflate(bytes, 1);
    set_thread_count(4);
    const Deflated four = deflate(bytes, 1);
    set_thread_count(before);
    EXPECT_EQ(one.bytes, four.bytes);
    EXPECT_EQ(one.sum, four.sum);
    EXPECT_LT(one.bytes.size(), 6 * bytes.size() / 10);
}

TEST(Deflate, EndsWhenItIsNotWantedAnyMore) {
    Progress progress;
    progress.cancel();
    EXPECT_THROW(deflate(half_random(3'000'000), 1, &progress), Cancelled);
}

TEST(Archive, GivesBackWhatWasPutIn) {
    const std::string large = half_random(2'500'000);
    const std::string small = "more letters than chance writes into a cipher";
    for (const std::string passphrase : {"", "open sesame"}) {
        const std::string bytes =
            zip_bytes({{"large", large}, {"small", small}, {"empty", ""}}, passphrase, "x.myoface");
        const ZipReader reader(ZipReader::Memory{bytes}, "x.myoface", passphrase);
        EXPECT_EQ(reader.part("large", true), large);
        EXPECT_EQ(reader.part("small", true), small);
        EXPECT_EQ(reader.part("empty", true), "");
        EXPECT_EQ(reader.encrypted("large"), !passphrase.empty());
        EXPECT_TRUE(passphrase.empty() || bytes.find(small.substr(0, 12)) == std::string::npos);
    }
}

TEST(Archive, NoticesOneWrongByte) {
    const std::string large = half_random(200'000);
    std::string bytes = zip_bytes({{"large", large}}, "", "x.myoface");
    bytes[60'000] = static_cast<char>(bytes[60'000] ^ 4);
    const ZipReader reader(ZipReader::Memory{bytes}, "x.myoface", "");
    EXPECT_THROW(reader.part("large", true), IoError);
}

}  // namespace
}  // namespace myoface
