// Text in UTF-32 and UTF-16, with characters beyond the basic plane and with halves of them.
#include "engine/io/text/encoding.h"

#include <cstdint>

#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

void putUnit(std::string& out, std::uint32_t unit, int bytes, bool bigEndian)
{
    for (int i = 0; i < bytes; ++i) out += static_cast<char>(unit >> (8 * (bigEndian ? bytes - 1 - i : i)));
}

std::string wide(const std::u32string& text, int bytes, bool bigEndian)
{
    std::string result;
    putUnit(result, 0xFEFF, bytes, bigEndian);
    for (const char32_t c : text) {
        if (bytes == 4 || c < 0x10000) {
            putUnit(result, c, bytes, bigEndian);
        } else {
            putUnit(result, 0xD800 + ((c - 0x10000) >> 10), 2, bigEndian);
            putUnit(result, 0xDC00 + ((c - 0x10000) & 0x3FF), 2, bigEndian);
        }
    }
    return result;
}

TEST(WideEncodings, CharactersOfAllPlanesBecomeUtf8)
{
    const std::u32string text = U"# wał Ø50 漢 😀\n1 2 3\n";
    for (const int bytes : {2, 4})
        for (const bool bigEndian : {false, true}) {
            const std::string encoded = wide(text, bytes, bigEndian);
            const io::DecodedText decoded = io::decodeText(encoded, io::Encoding::Auto);
            EXPECT_EQ(decoded.view(), "# wał Ø50 漢 😀\n1 2 3\n");
            EXPECT_EQ(decoded.encoding(), std::string("utf-") + (bytes == 2 ? "16" : "32") + (bigEndian ? "be" : "le"));
        }
}

TEST(WideEncodings, ACloudInUtf32IsRead)
{
    std::u32string text;
    for (int i = 0; i < 30; ++i) text += U"1.5 2.25 3\n4 5 6\n7 8 10\n";
    for (const bool bigEndian : {false, true}) {
        const io::ScanFile file = testing::readText(wide(text, 4, bigEndian));
        EXPECT_EQ(file.scan.points_mm.size(), 90u);
        EXPECT_EQ(file.scan.points_mm[0], Eigen::Vector3d(1.5, 2.25, 3));
        EXPECT_EQ(file.facts.encoding, bigEndian ? "utf-32be" : "utf-32le");
    }
}

TEST(WideEncodings, HalvesAndNumbersThatAreNoCharactersAreReplaced)
{
    const std::string replacement = "\xEF\xBF\xBD";
    std::string halves;
    putUnit(halves, 0xFEFF, 2, false);
    for (const std::uint32_t unit : {0x61U, 0xD800U, 0x62U, 0xDC00U, 0x63U, 0xD83DU}) putUnit(halves, unit, 2, false);
    EXPECT_EQ(io::decodeText(halves, io::Encoding::Auto).view(),
              "a" + replacement + "b" + replacement + "c" + replacement);
    std::string beyond;
    putUnit(beyond, 0xFEFF, 4, false);
    for (const std::uint32_t unit : {0x61U, 0xD800U, 0x110000U, 0x62U}) putUnit(beyond, unit, 4, false);
    EXPECT_EQ(io::decodeText(beyond, io::Encoding::Auto).view(), "a" + replacement + replacement + "b");
}

}  // namespace
}  // namespace lathelier
