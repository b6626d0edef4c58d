// Universal files: what breaks readers, and what becomes of functions.
#include <gtest/gtest.h>

#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/uff.h"
#include "engine/io/frf/uff_frf.h"
#include "tests/engine/io/frf_files.h"
#include "tests/engine/io/reading.h"
#include "tests/engine/io/uff_reading.h"

namespace lathelier {
namespace {

using testing::has;
using testing::integerOf;
using testing::rawBytes;
using testing::readUffFrf;
using testing::twoPoints;
using testing::twoValues;
using testing::uffBinarySet;
using testing::uffRefusal;
using testing::uffSet;
using testing::UffText;
using testing::wordOf;

io::UffFunction functionOf(const std::string& bytes)
{
    const io::UffFile file = io::readUff(bytes);
    EXPECT_TRUE(file.sets.at(0).function);
    return *file.sets.at(0).function;
}

TEST(Uff, readsEvenComplexDouble)
{
    const io::UffFunction function = functionOf(uffSet(twoPoints(), twoValues));
    EXPECT_EQ(function.function, 4);
    EXPECT_EQ(function.id[0], "made by a test");
    EXPECT_EQ(function.id[3], "");
    EXPECT_EQ(function.ordinate.unit, "m/s^2");
    EXPECT_EQ(function.denominator.type, 13);
    EXPECT_EQ(function.x, (std::vector<double>{50, 52}));
    EXPECT_EQ(function.y[1], std::complex<double>(3, -4));
}

TEST(Uff, linesMayEndWithCarriageReturn)
{
    UffText set = twoPoints();
    set.end = "\r\n";
    std::string values = twoValues;
    values.insert(values.size() - 1, "\r");
    const io::UffFunction function = functionOf(uffSet(set, values));
    EXPECT_EQ(function.y[1], std::complex<double>(3, -4));
}

TEST(Uff, columnsMayTouchAndHaveThreeDigitExponents)
{
    UffText set = twoPoints();
    set.points = 4;
    set.data_type = 2;
    const io::UffFunction touching =
        functionOf(uffSet(set, "-3.09944E-004-2.74181D-004  -0.001156330.100000E-0041.0\n"));
    ASSERT_EQ(touching.y.size(), 4U);
    EXPECT_DOUBLE_EQ(touching.y[0].real(), -3.09944e-4);
    EXPECT_DOUBLE_EQ(touching.y[1].real(), -2.74181e-4);
    EXPECT_DOUBLE_EQ(touching.y[2].real(), -0.00115633);
    EXPECT_DOUBLE_EQ(touching.y[3].real(), 0.1e-4);
}

TEST(Uff, linesOutOfTheColumnsAreSplitAtBlanks)
{
    UffText set = twoPoints();
    const io::UffFunction function = functionOf(uffSet(set, "1.25 -2.5 3.125\n-4.0625\n"));
    EXPECT_EQ(function.y[0], std::complex<double>(1.25, -2.5));
    EXPECT_EQ(function.y[1], std::complex<double>(3.125, -4.0625));
}

TEST(Uff, unevenDoubleHasColumnsOfTwoWidths)
{
    UffText set = twoPoints();
    set.even = false;
    const io::UffFunction function = functionOf(uffSet(set,
                                                       "  5.00000E+01  1.000000000000E+00  2.000000000000E+00\n"
                                                       "  7.50000E+01 -1.000000000000E+00 -2.000000000000E+00\n"));
    EXPECT_EQ(function.x, (std::vector<double>{50, 75}));
    EXPECT_EQ(function.y[1], std::complex<double>(-1, -2));
}

TEST(Uff, declaredPointsRuleOverPadding)
{
    UffText set = twoPoints();
    set.points = 1;
    const io::UffFile padded = io::readUff(uffSet(set, twoValues));
    EXPECT_EQ(padded.sets[0].function->y.size(), 1U);
    EXPECT_TRUE(padded.notes.empty());
    const io::UffFile beyond = io::readUff(uffSet(set, twoValues + twoValues));
    EXPECT_EQ(beyond.sets[0].function->y.size(), 1U);
    EXPECT_TRUE(has(beyond.notes, notes::uffDataBeyond));
}

TEST(Uff, morePointsDeclaredThanThereAreIsRefused)
{
    UffText set = twoPoints();
    set.points = 2508876;
    const Error error = uffRefusal(uffSet(set, twoValues));
    EXPECT_EQ(error.code(), errors::uffPointsMissing);
    EXPECT_EQ(integerOf(error, "line"), 14);
    EXPECT_EQ(integerOf(error, "declared_line"), 9);
    EXPECT_EQ(integerOf(error, "found"), 2);
    EXPECT_EQ(integerOf(error, "expected"), 2508876);
}

TEST(Uff, brokenNumberNamesItsPlace)
{
    const Error error = uffRefusal(uffSet(twoPoints(), "  1.000000000000E+00 -2.0000000x0000E+00\n"));
    EXPECT_EQ(error.code(), errors::malformed);
    EXPECT_EQ(integerOf(error, "line"), 14);
    EXPECT_EQ(integerOf(error, "column"), 22);
}

TEST(Uff, brokenHeaderNamesItsPlace)
{
    std::string text = uffSet(twoPoints(), twoValues);
    const std::size_t at = text.find("         6         2");
    text[at + 19] = 'x';
    const Error error = uffRefusal(text);
    EXPECT_EQ(integerOf(error, "line"), 9);
    EXPECT_EQ(integerOf(error, "column"), 20);
    EXPECT_EQ(wordOf(error, "found"), "x");
}

TEST(Uff, headersMayBeLatin1OrUtf8)
{
    UffText set = twoPoints();
    set.label = "Beschleunigung \xFC";
    set.id =
        "Pr\xFC"
        "fstand";
    EXPECT_EQ(functionOf(uffSet(set, twoValues)).ordinate.label, "Beschleunigung ü");
    set.label = "Auslenkung ü";  // fmt pads by characters
    set.unit = "µm";
    EXPECT_EQ(functionOf(uffSet(set, twoValues)).ordinate.unit, "µm");
    EXPECT_EQ(functionOf(uffSet(set, twoValues)).ordinate.label, "Auslenkung ü");
    set.label = "Auslenkung ü" + std::string(7, ' ');  // padded by bytes: 20 of them, 19 characters
    std::string text = uffSet(set, twoValues);
    const std::string byCharacters = set.label + "  µm", byBytes = set.label + " µm";
    text.replace(text.find(byCharacters), byCharacters.size(), byBytes);
    EXPECT_EQ(functionOf(text).ordinate.unit, "µm");
}

TEST(Uff, binaryPayloadMayHoldASeparator)
{
    UffText set = twoPoints();
    set.data_type = 5;
    set.points = 4;
    const std::string payload = "\n    -1\n    58\n    -1\n" + std::string(10, '\0');
    ASSERT_EQ(payload.size(), 32U);
    for (const char* end : {"\n", "\r\n"}) {
        set.end = end;
        const io::UffFile file = io::readUff(uffBinarySet(set, payload) + uffSet(twoPoints(), twoValues));
        ASSERT_EQ(file.sets.size(), 2U);
        EXPECT_EQ(file.sets[0].type, "58b");
        EXPECT_EQ(file.sets[0].function->y.size(), 4U);
        EXPECT_EQ(file.sets[1].type, "58");
    }
}

TEST(Uff, unevenBinaryHasRealFourAbscissa)
{
    for (const bool big : {false, true})
        for (const bool isComplex : {false, true}) {
            UffText set = twoPoints();
            set.even = false;
            set.data_type = isComplex ? 6 : 4;
            std::string payload;
            for (const double x : {10.0, 20.0}) {
                payload += rawBytes(static_cast<float>(x), big) + rawBytes(x / 8, big);
                if (isComplex) payload += rawBytes(-x / 4, big);
            }
            ASSERT_EQ(payload.size(), isComplex ? 40U : 24U);
            const io::UffFunction function = functionOf(uffBinarySet(set, payload, big));
            EXPECT_EQ(function.x, (std::vector<double>{10, 20}));
            EXPECT_EQ(function.y[1], std::complex<double>(2.5, isComplex ? -5 : 0));
        }
}

TEST(Uff, bytesBeyondTheFileAreRefused)
{
    UffText set = twoPoints();
    const std::string payload(32, '\0');
    const Error beyond = uffRefusal(uffBinarySet(set, payload, false, 2000000000));
    EXPECT_EQ(beyond.code(), errors::truncated);
    EXPECT_TRUE(find(beyond.values(), "byte"));
    EXPECT_EQ(integerOf(beyond, "expected"), 2000000000);
    EXPECT_EQ(uffRefusal(uffBinarySet(set, payload, false, 16)).code(), errors::truncated);
    const Error wrongCount = uffRefusal(uffBinarySet(set, payload + "12", false, 32));
    EXPECT_TRUE(find(wrongCount.values(), "byte"));
    set.points = 2000000000;
    EXPECT_EQ(uffRefusal(uffBinarySet(set, payload)).code(), errors::truncated);
}

TEST(Uff, otherSetsAreReadForUnitsAndNodesOrSkipped)
{
    const std::string units =
        "    -1\n   164\n         5mm (milli-newton)            2\n"
        "  1.00000000000000000D+03  1.00000000000000000D+00  1.00000000000000000D+00\n  2.73D+02\n    -1\n";
    const std::string nodes =
        "    -1\n  2411\n        -1         1         1        11\n"
        "   1.5000000000000000D+00   2.5000000000000000D+00   3.5000000000000000D+00\n    -1\n"
        "    -1\n    15\n       102         0         0        11  1.00000E+00  2.00000E+00  3.00000E+00\n    -1\n";
    UffText set = twoPoints();
    set.unit = "NONE";
    set.per = "NONE";
    set.ordinate = 8;
    const std::string other = "    -1\n   151\nmodel\n\n\n    -1\n";
    const io::UffFile file = io::readUff(other + units + nodes + uffSet(set, twoValues));
    ASSERT_EQ(file.sets.size(), 5U);
    EXPECT_EQ(file.sets[0].type, "151");
    ASSERT_EQ(file.nodes.size(), 2U);
    EXPECT_EQ(file.nodes[0].label, -1);
    EXPECT_EQ(file.nodes[1].place[2], 3);
    const io::FrfFile frf = readUffFrf(other + units + nodes + uffSet(set, twoValues));
    EXPECT_DOUBLE_EQ(frf.frfs.at(0).frf.value[0].real(), 1);  // 1000 units a metre are mm
    EXPECT_EQ(uffRefusal(other + nodes + uffSet(set, twoValues)).code(), errors::frfUnitMissing);
    EXPECT_DOUBLE_EQ(readUffFrf(uffSet(set, twoValues), {io::FrfUnitChoice::MPerN, {}}).frfs.at(0).frf.value[0].real(),
                     1000);
}

TEST(Uff, textOutsideTheSetsIsPassedOver)
{
    const std::string set = uffSet(twoPoints(), twoValues);
    const io::FrfFile file =
        readUffFrf("Workpiece A\n" + set + "File written 19 May 2024 09:58:46\n\n" + set + "the end\n");
    EXPECT_EQ(file.frfs.size(), 2U);
    ASSERT_TRUE(has(file.notes, notes::uffTextOutside));
    EXPECT_TRUE(io::isUff("Workpiece A\n" + set));
    EXPECT_FALSE(io::isUff("N10 G0 X1\n-1\n58\n"));
    // Numbers and heads of sets outside: a separator is missing.
    EXPECT_EQ(uffRefusal(set + twoValues + set).code(), errors::malformed);
    EXPECT_EQ(uffRefusal(set + "    58\n" + set).code(), errors::malformed);
    EXPECT_EQ(integerOf(uffRefusal("nothing but text\nand more\n"), "line"), 1);
}

TEST(UffFrf, coherenceOfTheSamePairIsAttached)
{
    UffText gamma = twoPoints();
    gamma.function = 6;
    gamma.data_type = 2;
    gamma.ordinate = 0;
    gamma.unit = "NONE";
    gamma.denominator = 0;
    gamma.per = "NONE";
    const std::string values = "  9.50000E-01  1.00001E+00\n";
    const io::FrfFile file = readUffFrf(uffSet(gamma, values) + uffSet(twoPoints(), twoValues));
    EXPECT_EQ(file.frfs.at(0).frf.coherence, (std::vector<double>{0.95, 1}));
    gamma.step = 4;
    const io::FrfFile other = readUffFrf(uffSet(gamma, values) + uffSet(twoPoints(), twoValues));
    EXPECT_TRUE(other.frfs.at(0).frf.coherence.empty());
    EXPECT_TRUE(has(other.notes, notes::frfCoherenceUnused));
}

TEST(UffFrf, otherFunctionsArePassedOver)
{
    UffText time = twoPoints();
    time.function = 1;
    EXPECT_EQ(uffRefusal(uffSet(time, twoValues)).code(), errors::frfNone);
    const io::FrfFile file = readUffFrf(uffSet(time, twoValues) + uffSet(twoPoints(), twoValues));
    EXPECT_EQ(file.frfs.size(), 1U);
    EXPECT_TRUE(has(file.notes, notes::frfSetsSkipped));
    UffText moment = twoPoints();
    moment.reference_direction = 5;
    EXPECT_EQ(uffRefusal(uffSet(moment, twoValues)).code(), errors::frfNone);
}

TEST(UffFrf, frequenciesHaveToAscend)
{
    UffText set = twoPoints();
    set.step = 0;
    const Error error = uffRefusal(uffSet(set, twoValues));
    EXPECT_EQ(error.code(), errors::frfNotAscending);
    EXPECT_EQ(integerOf(error, "line"), 2);
}

TEST(UffFrf, missingValuesAreLeftOut)
{
    UffText set = twoPoints();
    const io::FrfFile file =
        readUffFrf(uffSet(set, "                 NaN                 NaN  3.000000000000E+00 -4.000000000000E+00\n"));
    EXPECT_EQ(file.frfs.at(0).frf.frequency_hz, (std::vector<double>{52}));
    EXPECT_TRUE(has(file.notes, notes::frfLinesDropped));
}

TEST(UffFrf, factsListTheSets)
{
    Notes notes;
    const io::FileFacts facts = io::readFrfFacts("test.uff", uffSet(twoPoints(), twoValues), {}, {}, notes);
    EXPECT_EQ(facts.format, "UFF");
    const auto& sets = std::get<Rows>(*find(facts.details, "datasets"));
    ASSERT_EQ(sets.rows.size(), 1U);
    const Values& cells = sets.rows[0].cells;
    EXPECT_EQ(std::get<std::string>(*find(cells, "type")), "58");
    EXPECT_EQ(std::get<std::int64_t>(*find(cells, "function")), 4);
    EXPECT_EQ(std::get<std::string>(*find(cells, "ordinate")), "accelerance");
    EXPECT_EQ(std::get<std::vector<double>>(*find(cells, "y_last")), (std::vector<double>{3, -4}));
}

}  // namespace
}  // namespace lathelier
