// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace myoface {

inline bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

inline bool ends_word(char c) {
    return is_blank(c) || c == '\n' || c == '\f' || c == '\v';
}

/// A word of a file for a message: at most 40 signs, unprintable ones as '?'.
inline std::string quoted(const char* at, const char* end) {
    std::string text = "'";
    for (; at != end && !ends_word(*at) && text.size() < 41; ++at) {
        text += static_cast<unsigned char>(*at) < 0x20 || *at == 0x7F ? '?' : *at;
    }
    return text + "'";
}

/// Whether a number from a file can be a coordinate: finite, and finite in single precision too.
inline bool is_usable(double x) {
    return std::isfinite(x) && std::abs(x) < 1e30;
}

/// Reads a decimal number at `at`, correctly rounded whatever the locale.
/// @return the end of the number, or null where there is none
/// @note  Numbers of up to 19 digits whose value is an integer below 2^53 times or over a power of
///        ten up to 10^22 need one exact multiplication or division; the rest goes to from_chars.
/// @cite clinger_1990
inline const char* read_number(const char* at, const char* end, double& value) {
    static constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const char* p = at;
    bool negative = false;
    if (p != end && (*p == '-' || *p == '+')) {
        negative = *p++ == '-';
    }
    const char* const unsigned_start = p;
    std::uint64_t mantissa = 0;
    const auto digits = [&] {
        const char* const start = p;
        while (p != end && static_cast<unsigned char>(*p - '0') < 10) {
            mantissa = mantissa * 10 + static_cast<unsigned char>(*p++ - '0');
        }
        return p - start;
    };
    std::ptrdiff_t count = digits();
    std::ptrdiff_t exponent = 0;
    if (p != end && *p == '.') {
        ++p;
        exponent = -digits();
        count -= exponent;
    }
    bool simple = count > 0 && count <= 19;
    if (simple && p != end && (*p == 'e' || *p == 'E')) {
        const char* q = p + 1;
        const bool down = q != end && *q == '-';
        if (q != end && (*q == '-' || *q == '+')) {
            ++q;
        }
        int power = 0;
        const char* const start = q;
        while (q != end && static_cast<unsigned char>(*q - '0') < 10 && q - start < 4) {
            power = power * 10 + (*q++ - '0');
        }
        simple = q != start && (q == end || static_cast<unsigned char>(*q - '0') >= 10);
        exponent += down ? -power : power;
        p = q;
    }
    if (simple && mantissa < (std::uint64_t{1} << 53) && exponent >= -22 && exponent <= 22) {
        const auto whole = static_cast<double>(mantissa);
        const double result = exponent < 0 ? whole / kPowers[static_cast<std::size_t>(-exponent)]
                                           : whole * kPowers[static_cast<std::size_t>(exponent)];
        value = negative ? -result : result;
        return p;
    }
    if (unsigned_start == end || *unsigned_start == '-') {
        return nullptr;  // from_chars would take a second sign
    }
    double result = 0.0;
    const auto [stop, error] = std::from_chars(unsigned_start, end, result);
    if (error == std::errc::result_out_of_range) {
        bool tiny = false;  // as 1e-400, which is nought
        for (const char* c = unsigned_start; c + 1 < stop; ++c) {
            tiny = tiny || ((*c == 'e' || *c == 'E') && c[1] == '-');
        }
        result = tiny ? 0.0 : std::numeric_limits<double>::infinity();
    } else if (error != std::errc()) {
        return nullptr;
    }
    value = negative ? -result : result;
    return stop;
}

/// Reads a whole number. @return its end, or null where there is none or it does not fit
inline const char* read_whole(const char* at, const char* end, int& value) {
    const char* p = at;
    bool negative = false;
    if (p != end && (*p == '-' || *p == '+')) {
        negative = *p++ == '-';
    }
    const char* const start = p;
    std::int64_t result = 0;
    while (p != end && static_cast<unsigned char>(*p - '0') < 10) {
        result = result * 10 + (*p++ - '0');
        if (result > 2147483647) {
            return nullptr;
        }
    }
    value = static_cast<int>(negative ? -result : result);
    return p == start ? nullptr : p;
}

}  // namespace myoface
