// SPDX-License-Identifier: Apache-2.0
#include "myoface/base/error.h"

namespace myoface {
namespace {

constexpr std::size_t kLongestSentence = 2000;  // [bytes]

/// Names in a file are written by strangers.
std::string on_one_line(std::string sentence) {
    if (sentence.size() > kLongestSentence) {
        std::size_t end = kLongestSentence;
        while (end > 0 && (static_cast<unsigned char>(sentence[end]) & 0xC0) == 0x80) {
            --end;  // not within a letter of several bytes
        }
        sentence = sentence.substr(0, end) + "…";
    }
    for (char& c : sentence) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
            c = '?';
        }
    }
    return sentence;
}

}  // namespace

Error::Error(const std::string& sentence) : std::runtime_error(on_one_line(sentence)) {}

}  // namespace myoface
