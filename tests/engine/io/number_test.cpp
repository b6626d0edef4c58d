// Numbers: every double comes back from its text, bit for bit, and agrees with the C library's reading.
#include "engine/io/text/number.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace lathelier {
namespace {

RC_GTEST_PROP(Number, everyDoubleSurvives, (std::uint64_t bits))
{
    const auto value = std::bit_cast<double>(bits);
    RC_PRE(std::isfinite(value));
    RC_ASSERT(io::wholeNumber(fmt::format("{}", value), '.') == value);
    RC_ASSERT(io::wholeNumber(fmt::format("{:.20e}", value), '.') == value);
}

RC_GTEST_PROP(Number, roundsLikeTheCLibrary, (std::uint64_t digits, int shift))
{
    const std::string all = std::to_string(digits);
    const std::size_t point = std::min(all.size(), static_cast<std::size_t>(std::abs(shift % 25)));
    const std::string text = fmt::format("{}.{}e{}", all.substr(0, point), all.substr(point), shift % 40);
    RC_ASSERT(io::wholeNumber(text, '.') == std::strtod(text.c_str(), nullptr));
}

TEST(Number, spellings)
{
    EXPECT_EQ(io::wholeNumber("1.5D+02", '.'), 150);
    EXPECT_EQ(io::wholeNumber("1,5d-1", ','), 0.15);
    EXPECT_EQ(io::wholeNumber("+.5", '.'), 0.5);
    EXPECT_EQ(io::wholeNumber("5.", '.'), 5);
    EXPECT_EQ(io::wholeNumber("-0", '.'), 0);
    EXPECT_EQ(io::wholeNumber("1e999", '.'), std::numeric_limits<double>::infinity());
    EXPECT_EQ(io::wholeNumber("-1e99999999999999999999", '.'), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(io::wholeNumber("1e-99999999999999999999", '.'), 0);
    EXPECT_EQ(io::wholeNumber("0.000000000000000000000000000000000000001e39", '.'), 1);
    EXPECT_EQ(io::wholeNumber(std::string(400, '9'), '.'), std::numeric_limits<double>::infinity());
    for (const char* text : {"", "-", ".", "1.2.3", "1e", "1,5", "0x10", "1 2", "--1", "e5", "nan"})
        EXPECT_FALSE(io::wholeNumber(text, '.')) << text;
    EXPECT_FALSE(io::wholeNumber("5,", ','));
}

}  // namespace
}  // namespace lathelier
