// Q-DAS files: what is written comes back, bit for bit.
#include "engine/io/qdas/dfq.h"
#include "engine/core/core_codes.h"
#include "engine/io/qdas/dfq_reader.h"
#include "engine/io/qdas/dfq_writer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "engine/core/error.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/windows1252.h"

namespace lathelier {
namespace {

io::QdasFile example()
{
    io::QdasFile file;
    file.part_number = "shaft 7";
    file.part_description = "Gehäuse Ø50";
    file.machine = "16K20";
    const std::string noon = "21.04.2015/12:00:00", later = "21.04.2015/12:05:00";
    file.characteristics.push_back(
        {"1", "RONt(MZCI), G 1-50 UPR", "µm", 3, 0.0, 0.0, 10.0, {5.25, 6.0}, {noon, later}, true, false});
    file.characteristics.push_back(
        {"2", "Diameter", "mm", 5, 50.0, 49.99, std::nullopt, {50.0004}, {noon}, false, false});
    return file;
}

void expectSameFile(const io::QdasFile& a, const io::QdasFile& b)
{
    EXPECT_EQ(a.part_number, b.part_number);
    EXPECT_EQ(a.part_description, b.part_description);
    EXPECT_EQ(a.machine, b.machine);
    ASSERT_EQ(a.characteristics.size(), b.characteristics.size());
    for (std::size_t i = 0; i < a.characteristics.size(); ++i) {
        const io::QdasCharacteristic& p = a.characteristics[i];
        const io::QdasCharacteristic& q = b.characteristics[i];
        EXPECT_EQ(p.number, q.number);
        EXPECT_EQ(p.description, q.description);
        EXPECT_EQ(p.unit, q.unit);
        EXPECT_EQ(p.decimals, q.decimals);
        EXPECT_EQ(p.nominal, q.nominal);
        EXPECT_EQ(p.lower_limit, q.lower_limit);
        EXPECT_EQ(p.upper_limit, q.upper_limit);
        EXPECT_EQ(p.lower_is_natural, q.lower_is_natural);
        EXPECT_EQ(p.upper_is_natural, q.upper_is_natural);
        EXPECT_EQ(p.measured, q.measured);
        ASSERT_EQ(p.values.size(), q.values.size());
        for (std::size_t k = 0; k < p.values.size(); ++k)
            EXPECT_TRUE(p.values[k] == q.values[k] || (std::isnan(p.values[k]) && std::isnan(q.values[k])));
    }
}

TEST(Dfq, theFieldsOfTheTransferFormat)
{
    const std::string written = io::toDfq(example());
    EXPECT_EQ(written,
              "K0100 2\r\nK1001 shaft 7\r\nK1002 Geh\xE4use \xD8"
              "50\r\nK1082 16K20\r\n"
              "K2001/1 1\r\nK2002/1 RONt(MZCI), G 1-50 UPR\r\nK2004/1 0\r\nK2022/1 3\r\nK2101/1 0\r\nK2110/1 0\r\n"
              "K2111/1 10\r\nK2120/1 2\r\nK2121/1 1\r\nK2142/1 \xB5m\r\n"
              "K2001/2 2\r\nK2002/2 Diameter\r\nK2004/2 0\r\nK2022/2 5\r\nK2101/2 50\r\nK2110/2 49.99\r\n"
              "K2120/2 1\r\nK2121/2 0\r\nK2142/2 mm\r\n"
              "K0001/1 5.25\r\nK0002/1 0\r\nK0004/1 21.04.2015/12:00:00\r\n"
              "K0001/2 50.0004\r\nK0002/2 0\r\nK0004/2 21.04.2015/12:00:00\r\n"
              "K0001/1 6\r\nK0002/1 0\r\nK0004/1 21.04.2015/12:05:00\r\n");
    expectSameFile(io::readDfq("test", written), example());
}

TEST(Dfq, valuesThatAreNoneAreMarkedInvalid)
{
    io::QdasFile file = example();
    file.characteristics[0].values = {1.5, std::nan(""), std::numeric_limits<double>::infinity()};
    const io::QdasFile back = io::readDfq("test", io::toDfq(file));
    ASSERT_EQ(back.characteristics[0].values.size(), 3U);
    EXPECT_EQ(back.characteristics[0].values[0], 1.5);
    EXPECT_TRUE(std::isnan(back.characteristics[0].values[1]));
    EXPECT_TRUE(std::isnan(back.characteristics[0].values[2]));
    EXPECT_EQ(io::toDfq(file).find("nan"), std::string::npos);
}

TEST(Dfq, lettersOutsideWindows1252)
{
    io::QdasFile file = example();
    file.part_description = "wałek, вал";
    const std::string written = io::toDfq(file);
    EXPECT_TRUE(written.starts_with("\xEF\xBB\xBF"));
    expectSameFile(io::readDfq("test", written), file);
    // Letters whose bytes would pass for UTF-8 do not come back as another letter.
    file.part_description = "Ã¤";
    expectSameFile(io::readDfq("test", io::toDfq(file)), file);
    EXPECT_EQ(io::toWindows1252("€ …"), "\x80 \x85");
}

TEST(Dfq, descriptionsHaveEightyCharacters)
{
    io::QdasFile file = example();
    file.characteristics[0].description = std::string(79, 'a') + "µµ";
    EXPECT_EQ(io::readDfq("test", io::toDfq(file)).characteristics[0].description, std::string(79, 'a') + "µ");
}

TEST(Dfq, bytesThatAreNoUtf8DoNotSpoilTheEncoding)
{
    io::QdasFile file = example();
    file.part_number =
        "wa\xB3"
        "ek";  // a file name of another country and time
    file.part_description = "вал";
    const io::QdasFile back = io::readDfq("test", io::toDfq(file));
    EXPECT_EQ(back.part_number, "wa³ek");
    EXPECT_EQ(back.part_description, "вал");
    EXPECT_EQ(back.characteristics[0].unit, "µm");
}

TEST(Dfq, linesOfValuesInTheShortForm)
{
    const io::QdasFile file = io::readDfq("test",
                                          "K0100 2\r\nK2001/1 a\r\nK2001/2 b\r\n5.25\x14"
                                          "0\x14"
                                          "21.04.2015/12:00:00\x0F"
                                          "6,5\x14"
                                          "255\r\n5.5\x0F"
                                          "6.75\r\n");
    ASSERT_EQ(file.characteristics.size(), 2U);
    EXPECT_EQ(file.characteristics[0].values, (std::vector<double>{5.25, 5.5}));
    EXPECT_EQ(file.characteristics[0].measured, (std::vector<std::string>{"21.04.2015/12:00:00"}));
    EXPECT_TRUE(std::isnan(file.characteristics[1].values[0]));
    EXPECT_EQ(file.characteristics[1].values[1], 6.75);
}

TEST(Dfq, aLimitThatDoesNotCountIsNone)
{
    const io::QdasFile file = io::readDfq("test", "K0100 1\r\nK2110/1 0\r\nK2111/1 5\r\nK2120/1 0\r\nK2121/1 2\r\n");
    EXPECT_FALSE(file.characteristics[0].lower_limit);
    EXPECT_EQ(file.characteristics[0].upper_limit, 5.0);
    EXPECT_TRUE(file.characteristics[0].upper_is_natural);
}

TEST(Dfq, itIsKnownByItsFirstField)
{
    EXPECT_TRUE(io::isDfq("K0100 1\r\n"));
    EXPECT_TRUE(io::isDfq("\xEF\xBB\xBFK0101/0 1\r\n"));
    EXPECT_TRUE(io::isDfq("\r\nK1001/1 shaft\r\n"));
    EXPECT_FALSE(io::isDfq("K01 1\r\n"));
    EXPECT_FALSE(io::isDfq("Kraft 1 2 3\n"));
    EXPECT_FALSE(io::isDfq("1 2 3\nK0100 1\n"));
}

TEST(Dfq, lineEndsInTextsCannotForgeFields)
{
    io::QdasFile file = example();
    file.part_number = "7\r\nK0001/1 99";
    EXPECT_EQ(io::readDfq("test", io::toDfq(file)).characteristics[0].values.size(), 2U);
}

RC_GTEST_PROP(Dfq, roundTrip, ())
{
    const auto word = rc::gen::map(rc::gen::container<std::string>(rc::gen::elementOf(std::string("aZ09-_/.,;#%xµ"))),
                                   [](std::string s) {
                                       // µ is two bytes: keep them together or not at all
                                       std::erase_if(s, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
                                       return s;
                                   });
    io::QdasFile file;
    file.part_number = *word;
    file.machine = *word;
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
        io::QdasCharacteristic c;
        c.number = *word;
        c.unit = "µm";
        c.nominal = *rc::gen::arbitrary<double>();
        c.values = *rc::gen::arbitrary<std::vector<double>>();
        file.characteristics.push_back(c);
    }
    const io::QdasFile back = io::readDfq("test", io::toDfq(file));
    RC_ASSERT(back.part_number == file.part_number);
    RC_ASSERT(back.characteristics.size() == file.characteristics.size());
    for (std::size_t i = 0; i < file.characteristics.size(); ++i) {
        RC_ASSERT(back.characteristics[i].number == file.characteristics[i].number);
        RC_ASSERT(back.characteristics[i].nominal == file.characteristics[i].nominal);
        RC_ASSERT(back.characteristics[i].values == file.characteristics[i].values);
    }
}

TEST(Dfq, whatIsNoneIsRefusedAtItsLine)
{
    const auto refused = [](const std::string& text) {
        try {
            io::readDfq("test", text);
        } catch (const Error& error) {
            return error.code();
        }
        return errors::internal;
    };
    EXPECT_EQ(refused(""), errors::fileEmpty);
    EXPECT_EQ(refused("\r\n\r\n"), errors::fileEmpty);
    EXPECT_EQ(refused("K0100 1\r\nx,y\r\n"), errors::malformed);
    EXPECT_EQ(refused("K0100 1\r\nK0001/1 abc\r\n"), errors::malformed);
    EXPECT_EQ(refused("K0100 1\r\nK0001/2 5\r\n"), errors::malformed);
    EXPECT_EQ(refused("K0100 3\r\nK0001/1 5\r\n"), errors::truncated);
    EXPECT_EQ(refused("K0100 1\r\nK0002/1 255\r\n"), errors::malformed);
    EXPECT_EQ(refused("K0001/99999999999 5\r\n"), errors::malformed);
    EXPECT_EQ(refused(std::string("\x89PNG\r\n\x1a\n", 8)), errors::formatUnknown);
}

}  // namespace
}  // namespace lathelier
