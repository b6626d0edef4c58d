#include "engine/report/png.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <zlib.h>

namespace lathelier {
namespace {

std::uint32_t number(const std::string& bytes, std::size_t at)
{
    std::uint32_t result = 0;
    for (std::size_t i = 0; i < 4; ++i) result = (result << 8) | static_cast<std::uint8_t>(bytes[at + i]);
    return result;
}

/// The data of the first chunk of this type; checks every checksum on the way.
std::string chunk(const std::string& png, const std::string& type)
{
    std::string found;
    std::size_t at = 8;
    while (at + 12 <= png.size()) {
        const std::size_t size = number(png, at);
        const std::string body = png.substr(at + 4, 4 + size);
        EXPECT_EQ(number(png, at + 8 + size),
                  crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
        if (body.substr(0, 4) == type && found.empty()) found = body.substr(4);
        at += 12 + size;
    }
    EXPECT_EQ(at, png.size());
    return found;
}

TEST(Png, PixelsComeBackOutOfTheFile)
{
    report::IndexedImage image{3, 2, {0, 1, 2, 2, 1, 0}, {{1, 2, 3}, {4, 5, 6}, {255, 255, 255}}, 2};
    const std::string png = report::encodePng(image);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const std::string header = chunk(png, "IHDR");
    EXPECT_EQ(number(header, 0), 3u);
    EXPECT_EQ(number(header, 4), 2u);
    EXPECT_EQ(header.substr(8), std::string("\x08\x03\x00\x00\x00", 5));
    EXPECT_EQ(chunk(png, "PLTE"), "\x01\x02\x03\x04\x05\x06\xFF\xFF\xFF");
    EXPECT_EQ(chunk(png, "tRNS"), std::string("\xFF\xFF\x00", 3));
    const std::string packed = chunk(png, "IDAT");
    std::string rows(100, '\0');
    uLongf size = rows.size();
    ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                         packed.size()),
              Z_OK);
    EXPECT_EQ(rows.substr(0, size), std::string("\0\0\1\2\0\2\1\0", 8));
}

TEST(Base64, KnownAnswersOfRfc4648)
{
    EXPECT_EQ(report::base64(""), "");
    EXPECT_EQ(report::base64("f"), "Zg==");
    EXPECT_EQ(report::base64("fo"), "Zm8=");
    EXPECT_EQ(report::base64("foo"), "Zm9v");
    EXPECT_EQ(report::base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(report::base64(std::string("\xFF\xFE\x00", 3)), "//4A");
}

}  // namespace
}  // namespace lathelier
