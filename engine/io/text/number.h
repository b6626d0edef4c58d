// Reading decimal numbers from text: exact, independent of the locale, fast for the usual ones.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace lathelier::io {

namespace detail {
/// The correctly rounded value of the number in [at, end); for numbers with many digits or large exponents.
double parseNumberSlowly(const char* at, const char* end, char decimal);

/// Powers of ten that a double holds exactly.
inline constexpr double exactPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                              1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

inline bool isDigit(char c)
{
    return static_cast<unsigned char>(c - '0') < 10;
}
}  // namespace detail

/// Reads the longest number that starts at `at`: sign, digits with at most one `decimal` mark, exponent after e, E, d
/// or D (Fortran). Returns the position after it, or nullptr when there is none. Correctly rounded; too large gives
/// ±infinity. Up to 2^53 and 10^±22 both mantissa and power are exact doubles, so that one division or product rounds
/// correctly (W. D. Clinger, How to read floating point numbers accurately, 1990).
inline const char* parseNumber(const char* at, const char* end, char decimal, double& value)
{
    const char* p = at;
    bool negative = false;
    if (p != end && (*p == '-' || *p == '+')) negative = *p++ == '-';
    std::uint64_t mantissa = 0;
    const char* const first = p;
    while (p != end && detail::isDigit(*p)) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p++ - '0');
    auto digits = p - first;
    std::ptrdiff_t exponent = 0;
    if (p != end && *p == decimal) {
        const char* q = p + 1;
        while (q != end && detail::isDigit(*q)) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*q++ - '0');
        const auto fraction = q - (p + 1);
        // "5." is a number; "5," is one followed by a separator.
        if (fraction > 0 || (decimal == '.' && digits > 0)) {
            digits += fraction;
            exponent = -fraction;
            p = q;
        }
    }
    if (digits == 0) return nullptr;
    if (p != end && ((*p | 0x20) == 'e' || (*p | 0x20) == 'd')) {
        const char* q = p + 1;
        const bool down = q != end && *q == '-';
        if (q != end && (*q == '-' || *q == '+')) ++q;
        if (q != end && detail::isDigit(*q)) {
            std::ptrdiff_t written = 0;
            for (; q != end && detail::isDigit(*q); ++q)
                if (written < 100000) written = written * 10 + (*q - '0');
            exponent += down ? -written : written;
            p = q;
        }
    }
    constexpr std::uint64_t exactMantissa = std::uint64_t{1} << 53;
    if (digits <= 19 && mantissa <= exactMantissa && exponent >= -22 && exponent <= 22) {
        const auto exact = static_cast<double>(mantissa);
        const double size =
            exponent < 0 ? exact / detail::exactPowersOfTen[-exponent] : exact * detail::exactPowersOfTen[exponent];
        value = negative ? -size : size;
    } else {
        value = detail::parseNumberSlowly(at, p, decimal);
    }
    return p;
}

/// The whole of `text` as a number with this decimal mark.
std::optional<double> wholeNumber(std::string_view text, char decimal);

/// The whole of `text` as a plain whole number, "500".
std::optional<std::int64_t> wholeInteger(std::string_view text);

/// True for spellings of an invalid or missing number: nan, inf, 1.#QNAN, n/a, null, none… in any case, signed or not.
bool isNotFiniteWord(std::string_view text);

}  // namespace lathelier::io
