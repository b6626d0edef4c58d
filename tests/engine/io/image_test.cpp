// Pictures: read exactly, upright, with their bits; and refused with a place when they are damaged, foreign or too
// large.
#include "engine/io/image/image.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "engine/core/random.h"
#include "engine/io/image/image_canvas.h"
#include "engine/io/image/image_codes.h"
#include "engine/io/image/image_kind.h"
#include "engine/io/io_codes.h"
#include "engine/report/png.h"
#include "tests/engine/io/picture_files.h"

namespace lathelier::io {
namespace {

using test::Ramp;

std::string pngFile(const Ramp& ramp)
{
    report::GreyImage image{ramp.width, ramp.height, ramp.bits, {}, {}};
    for (int y = 0; y < ramp.height; ++y)
        for (int x = 0; x < ramp.width; ++x) image.samples.push_back(static_cast<std::uint16_t>(ramp.value(x, y)));
    return report::encodePng(image);
}

void expectRamp(const Image& image, const Ramp& ramp)
{
    ASSERT_EQ(image.width, ramp.width);
    ASSERT_EQ(image.height, ramp.height);
    EXPECT_EQ(image.bits, ramp.bits);
    const double scale = (1 << ramp.bits) - 1;
    for (int y = 0; y < ramp.height; y += 3)
        for (int x = 0; x < ramp.width; ++x)
            ASSERT_NEAR(double(image.at(x, y)) * scale, ramp.value(x, y), 2e-7 * scale) << x << "," << y;
}

template <class Read>
Error imageRefusal(Read read)
{
    try {
        read();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "was read";
    return {errors::malformed, {}};
}

std::int64_t numberOf(const Error& error, const char* name)
{
    const Value* value = find(error.values(), name);
    return value && std::holds_alternative<std::int64_t>(*value) ? std::get<std::int64_t>(*value) : -1;
}

TEST(Image, ReadsGreyOfEightAndSixteenBits)
{
    for (const int bits : {8, 16}) {
        const Ramp ramp{160, 140, bits};
        expectRamp(readImage("a.png", pngFile(ramp)), ramp);
        for (const bool lzw : {false, true})
            for (const bool tiled : {false, true}) {
                SCOPED_TRACE(::testing::Message() << bits << (lzw ? " lzw" : "") << (tiled ? " tiled" : ""));
                expectRamp(readImage("a.tif", test::tiffFile(ramp, {lzw, tiled})), ramp);
            }
    }
}

TEST(Image, ReadsJpegAndColour)
{
    const Image jpeg = readImage("a.jpg", test::jpegFile({}));
    EXPECT_EQ(jpeg.format, "jpeg");
    EXPECT_NEAR(double(jpeg.at(100, 80)) * 255, 40 + 50 + 40, 2.0);
    const Image colour = readImage("a.tif", test::tiffFile({}, {true, false, false, 3}));
    EXPECT_EQ(colour.channels, 3);
    expectRamp(colour, {});  // the three are equal, and the weights add up to one
}

TEST(Image, OrientationBringsTheFirstRowWhereItBelongs)
{
    // A picture of 3 × 2 whose pixels are 0 1 2 / 3 4 5.
    const auto turned = [](int orientation) {
        Image image = emptyImage("png", {3, 2, 8, 1});
        for (std::size_t i = 0; i < 6; ++i) image.grey[i] = static_cast<float>(i);
        applyOrientation(image, orientation, "x");
        return image;
    };
    const Image six = turned(6);  // the camera was held on its side: row 0 of the file is the right edge
    EXPECT_EQ(six.width, 2);
    EXPECT_EQ(six.grey, (std::vector<float>{3, 0, 4, 1, 5, 2}));
    EXPECT_EQ(turned(8).grey, (std::vector<float>{2, 5, 1, 4, 0, 3}));
    EXPECT_EQ(turned(3).grey, (std::vector<float>{5, 4, 3, 2, 1, 0}));
    EXPECT_EQ(turned(2).grey, (std::vector<float>{2, 1, 0, 5, 4, 3}));
    EXPECT_EQ(turned(4).grey, (std::vector<float>{3, 4, 5, 0, 1, 2}));
    EXPECT_EQ(turned(5).grey, (std::vector<float>{0, 3, 1, 4, 2, 5}));
    EXPECT_EQ(turned(7).grey, (std::vector<float>{5, 2, 4, 1, 3, 0}));
    EXPECT_TRUE(contains(six.notes, notes::imageTurned));
    EXPECT_TRUE(turned(1).notes.empty());
}

TEST(Image, ExifOrientationIsFoundInBothByteOrders)
{
    using namespace std::string_view_literals;
    EXPECT_EQ(exifOrientation("MM\0*\0\0\0\10\0\1\1\22\0\3\0\0\0\1\0\6\0\0\0\0\0\0"sv), 6);
    EXPECT_EQ(exifOrientation("II*\0\10\0\0\0\1\0\22\1\3\0\1\0\0\0\10\0\0\0\0\0\0\0"sv), 8);
    EXPECT_EQ(exifOrientation("II*\0\xFF\xFF\xFF\xFF\1\0"sv), 1);
    EXPECT_EQ(exifOrientation(""), 1);
}

TEST(Image, TruncatedFilesTellTheRowReached)
{
    for (const std::string& whole :
         {pngFile({}), test::jpegFile({}), test::tiffFile({}, {false}), test::tiffFile({}, {true})}) {
        for (const double share : {0.3, 0.6, 0.9}) {
            const std::string half =
                whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size())));
            const Error error = imageRefusal([&] { readImage("half", half); });
            EXPECT_TRUE(error.code() == errors::imageEndsEarly || error.code() == errors::imageDamaged) << error.what();
            EXPECT_GE(numberOf(error, "row"), 0) << error.what();
            EXPECT_GE(numberOf(error, "byte"), 0) << error.what();
        }
    }
}

TEST(Image, DamageIsAnErrorAndNoHalfPicture)
{
    std::string png = pngFile({});
    png[png.size() / 2] = static_cast<char>(png[png.size() / 2] ^ 0x55);
    EXPECT_EQ(imageRefusal([&] { readImage("a.png", png); }).code(), errors::imageDamaged);
    std::string jpeg = test::jpegFile({});
    jpeg.insert(jpeg.size() / 2, "\xFF\xD3");  // a restart marker that does not belong there
    EXPECT_EQ(imageRefusal([&] { readImage("a.jpg", jpeg); }).code(), errors::imageDamaged);
}

std::string pngHeader(std::uint32_t width, std::uint32_t height)
{
    report::GreyImage image{1, 1, 8, {0}, {}};
    std::string png = report::encodePng(image);
    for (int i = 0; i < 4; ++i) {
        png[static_cast<std::size_t>(16 + i)] = static_cast<char>(width >> (24 - 8 * i));
        png[static_cast<std::size_t>(20 + i)] = static_cast<char>(height >> (24 - 8 * i));
    }
    return png;
}

TEST(Image, LimitsAreCheckedOnTheHeader)
{
    EXPECT_EQ(imageRefusal([] { readImage("a", pngHeader(100000, 100000)); }).code(), errors::imageTooLarge);
    EXPECT_EQ(imageRefusal([] { readImage("a", pngHeader(30000, 30000)); }).code(), errors::imageTooLarge);
    EXPECT_EQ(imageRefusal([] { readImage("a", pngHeader(0, 10)); }).code(), errors::imageEmpty);
    EXPECT_EQ(imageRefusal([] { readImage("a", pngHeader(9000, 9000)); }).code(), errors::imageImplausible);
    EXPECT_EQ(numberOf(imageRefusal([] { readImage("a", pngHeader(9000, 9000)); }), "byte"), 16);
}

TEST(Image, ForeignKindsAreRefusedByName)
{
    EXPECT_EQ(imageRefusal([] {
                  readImage("a", test::tiffFile({}, {true, false, true}));
              }).code(),
              errors::imageUnsupported);
    EXPECT_EQ(imageRefusal([] {
                  readImage("a", test::tiffFile({}, {true, false, false, 4}));
              }).code(),
              errors::imageUnsupported);
    EXPECT_EQ(imageRefusal([] { readImage("a", "GIF89a"); }).code(), errors::formatUnknown);
    EXPECT_EQ(imageRefusal([] { readImage("a", ""); }).code(), errors::fileEmpty);
}

TEST(Image, OtherPagesAreNoted)
{
    EXPECT_TRUE(
        contains(readImage("a", test::tiffFile({}, {true, false, false, 1, 3})).notes, notes::imagePagesIgnored));
    EXPECT_TRUE(readImage("a", test::tiffFile({}, {})).notes.empty());
}

/// Any change of a few bytes is read or refused with a place; nothing else happens.
TEST(Image, HostileBytesAreReadOrRefused)
{
    std::uint64_t draw = 0;
    for (const std::string& whole : {pngFile({}), test::jpegFile({}), test::tiffFile({}, {true, true})})
        for (int attempt = 0; attempt < 60; ++attempt) {
            std::string bytes = whole;
            for (int i = 0; i < 3; ++i) {
                const std::size_t range = attempt % 2 == 0 ? std::min<std::size_t>(bytes.size(), 400) : bytes.size();
                const std::size_t place = 8 + randomBits(5, 1, draw) % (range - 8);
                bytes[place] = static_cast<char>(randomBits(5, 2, draw));
                ++draw;
            }
            try {
                const Image image = readImage("hostile", bytes);
                EXPECT_EQ(image.grey.size(),
                          static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
            } catch (const Error& error) {
                EXPECT_GE(numberOf(error, "byte"), 0) << error.what();
            }
        }
}

TEST(Image, KindAndFacts)
{
    EXPECT_EQ(imageFiles().sniff("x", pngFile({}), {}), Likeness::Certain);
    EXPECT_EQ(imageFiles().sniff("x.png", "x,y\n1,2\n", {}), Likeness::No);
    const FileFacts facts = imageFacts("a.png", readImage("a.png", pngFile({160, 140, 16})));
    EXPECT_EQ(facts.format, "png");
    EXPECT_EQ(*find(facts.details, "width"), Value(std::int64_t{160}));
    EXPECT_EQ(*find(facts.details, "height"), Value(std::int64_t{140}));
    EXPECT_EQ(*find(facts.details, "bits"), Value(std::int64_t{16}));
}

TEST(Image, ThePixelSizeThatAFileStatesIsShown)
{
    std::string png = pngFile({});
    const auto number = [](std::uint32_t value) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
        return bytes;
    };
    const std::string body = "pHYs" + number(400000) + number(400000) + '\x01';  // 400 000 px/m: 2.5 um
    const auto checksum = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
    png.insert(33, number(9) + body + number(checksum));  // behind the header chunk
    const Image image = readImage("a.png", png);
    EXPECT_DOUBLE_EQ(image.um_per_px, 2.5);
    EXPECT_TRUE(contains(image.notes, notes::imageScaleStated));
    EXPECT_EQ(*find(imageFacts("a.png", image).details, "um_per_px"), Value(2.5));
    EXPECT_EQ(readImage("a.png", pngFile({})).um_per_px, 0);
}

}  // namespace
}  // namespace lathelier::io
