// Units and signs of frequency responses in universal files.
#include <gtest/gtest.h>

#include <numbers>

#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_writer.h"
#include "tests/engine/io/frf_files.h"
#include "tests/engine/io/reading.h"
#include "tests/engine/io/uff_reading.h"

namespace lathelier {
namespace {

using testing::has;
using testing::integerOf;
using testing::readUffFrf;
using testing::twoPoints;
using testing::twoValues;
using testing::uffRefusal;
using testing::uffSet;
using testing::UffText;
using testing::wordOf;

TEST(UffFrf, unitsBecomeMillimetresPerNewton)
{
    struct Case {
        int ordinate;
        const char* unit;
        const char* per;
        FrfQuantity quantity;
        double scale;
    };
    const Case cases[] = {{8, "m", "N", FrfQuantity::Receptance, 1000},
                          {8, "mm", "N", FrfQuantity::Receptance, 1},
                          {8, "µm", "kN", FrfQuantity::Receptance, 1e-6},
                          {11, "m/s", "N", FrfQuantity::Mobility, 1000},
                          {12, "m/s^2", "N", FrfQuantity::Accelerance, 1000},
                          {12, "g", "N", FrfQuantity::Accelerance, 9806.65},
                          {12, "(m/s^2)/N", "NONE", FrfQuantity::Accelerance, 1000},
                          {12, "1/kg", "", FrfQuantity::Accelerance, 1000},
                          {12, "in/s**2", "lbf", FrfQuantity::Accelerance, 25.4 / 4.4482216152605},
                          {12, "g's", "Newtons", FrfQuantity::Accelerance, 9806.65},
                          {12, "m s-2", "daN", FrfQuantity::Accelerance, 100},
                          {12, "m/s^2", "mN", FrfQuantity::Accelerance, 1e6},
                          {12, "m/s^2", "kgf", FrfQuantity::Accelerance, 1000 / 9.80665},
                          {12, "m/s^2", "pdl", FrfQuantity::Accelerance, 1000 / 0.138254954376},
                          {12, "meters/second^2", "pounds", FrfQuantity::Accelerance, 1000 / 4.4482216152605},
                          {0, "m/N", "NONE", FrfQuantity::Receptance, 1000}};
    for (const Case& one : cases) {
        UffText set = twoPoints();
        set.ordinate = one.ordinate;
        set.unit = one.unit;
        set.per = one.per;
        const io::FrfFile file = readUffFrf(uffSet(set, twoValues));
        EXPECT_EQ(file.frfs.at(0).frf.quantity, one.quantity) << one.unit;
        EXPECT_NEAR(file.frfs.at(0).frf.value[1].real() / (3 * one.scale), 1, 1e-12) << one.unit;
        EXPECT_FALSE(has(file.notes, notes::frfLabelContradictsUnit)) << one.unit;
    }
}

TEST(UffFrf, unknownUnitsAreNamedWithTheirLine)
{
    UffText set = twoPoints();
    set.per = "MN";
    const Error force = uffRefusal(uffSet(set, twoValues));
    EXPECT_EQ(force.code(), errors::frfUnitUnknown);
    EXPECT_EQ(integerOf(force, "line"), 12);
    EXPECT_EQ(wordOf(force, "found"), "MN");
    EXPECT_EQ(integerOf(force, "column"), 48);
    const std::string bytes = uffSet(set, twoValues);
    EXPECT_EQ(bytes.substr(static_cast<std::size_t>(integerOf(force, "byte")), 3), "MN ");
    set.per = "kg";  // a mass, or the force of a kilogram
    EXPECT_EQ(uffRefusal(uffSet(set, twoValues)).code(), errors::frfUnitUnknown);
    set.per = "N";
    set.unit = "furlong";
    EXPECT_EQ(integerOf(uffRefusal(uffSet(set, twoValues)), "line"), 11);
    set.unit = "m/s^2";
    set.frequency_unit = "turns";
    const Error frequency = uffRefusal(uffSet(set, twoValues));
    EXPECT_EQ(frequency.code(), errors::frfUnitUnknown);
    EXPECT_EQ(integerOf(frequency, "line"), 10);
}

TEST(UffFrf, aGivenUnitReplacesOneThatIsNotKnown)
{
    UffText set = twoPoints();
    set.per = "hand";
    const io::FrfFile file = readUffFrf(uffSet(set, twoValues), {io::FrfUnitChoice::MPerS2N, {}});
    EXPECT_EQ(file.frfs.at(0).frf.value[1], std::complex<double>(3000, -4000));
    EXPECT_EQ(file.frfs.at(0).frf.quantity, FrfQuantity::Accelerance);
    EXPECT_TRUE(has(file.notes, notes::frfUnitReplaced));
    set.per = "N";
    set.frequency_unit = "turns";
    io::FrfOptions options;
    options.frequency_unit = io::FrequencyUnitChoice::RadPerSecond;
    EXPECT_NEAR(readUffFrf(uffSet(set, twoValues), options).frfs.at(0).frf.frequency_hz[0], 50 / (2 * std::numbers::pi),
                1e-12);
    set.frequency_unit = "Hz";  // a stated unit rules
    const io::FrfFile stated = readUffFrf(uffSet(set, twoValues), options);
    EXPECT_EQ(stated.frfs.at(0).frf.frequency_hz[0], 50);
    EXPECT_TRUE(has(stated.notes, notes::frfUnitNotUsed));
    set.frequency_unit = "NONE";
    EXPECT_NEAR(readUffFrf(uffSet(set, twoValues), options).frfs.at(0).frf.frequency_hz[0], 50 / (2 * std::numbers::pi),
                1e-12);
}

TEST(UffFrf, theReasonForNoResponseIsSaidAtItsLine)
{
    UffText set = twoPoints();
    set.response_direction = 5;
    const Error error = uffRefusal(uffSet(set, twoValues));
    EXPECT_EQ(error.code(), errors::frfNone);
    EXPECT_EQ(integerOf(error, "line"), 2);
    EXPECT_EQ(std::get<Text>(*find(error.values(), "found")), LT_TEXT("Engine", "a rotation or a moment"));
}

TEST(UffFrf, aTurnedAndAConjugatedDrivingPointAreToldApart)
{
    const auto notesOf = [](const std::complex<double>& sign, bool conjugated) {
        io::MeasuredFrf measured = testing::modeFrf(FrfQuantity::Accelerance);
        for (auto& value : measured.frf.value) value = sign * (conjugated ? std::conj(value) : value);
        return readUffFrf(io::toUff(std::vector{measured})).notes;
    };
    EXPECT_FALSE(has(notesOf(1, false), notes::frfTurned) || has(notesOf(1, false), notes::frfConjugated));
    EXPECT_TRUE(has(notesOf(-1, false), notes::frfTurned));
    EXPECT_FALSE(has(notesOf(-1, false), notes::frfConjugated));
    EXPECT_TRUE(has(notesOf(1, true), notes::frfConjugated));
    EXPECT_FALSE(has(notesOf(1, true), notes::frfTurned));
    // The imaginary part alone would pass for right.
    EXPECT_TRUE(has(notesOf(-1, true), notes::frfConjugated) && has(notesOf(-1, true), notes::frfTurned));
    EXPECT_FALSE(has(notesOf(-1, false), notes::frfDrivingPointSign));
}

TEST(UffFrf, unitRulesOverLabel)
{
    UffText set = twoPoints();
    set.ordinate = 0;
    set.label = "Receptance";
    set.unit = "(m/s)/N";
    set.denominator = 0;
    set.per = "NONE";
    const io::FrfFile file = readUffFrf(uffSet(set, twoValues), {io::FrfUnitChoice::MmPerN, {}});
    EXPECT_EQ(file.frfs.at(0).frf.quantity, FrfQuantity::Mobility);
    EXPECT_TRUE(has(file.notes, notes::frfLabelContradictsUnit));
    EXPECT_TRUE(has(file.notes, notes::frfUnitNotUsed));
}

TEST(UffFrf, negativeDirectionsFlipTheSign)
{
    for (const int response : {1, -1})
        for (const int reference : {2, -2}) {
            UffText set = twoPoints();
            set.response_direction = response;
            set.reference_direction = reference;
            set.response_node = -1;
            const io::MeasuredFrf frf = readUffFrf(uffSet(set, twoValues)).frfs.at(0);
            EXPECT_EQ(frf.frf.value[0].real(), 1000 * (response * reference > 0 ? 1 : -1));
            EXPECT_EQ(frf.response_node, -1);
            EXPECT_EQ(frf.response_direction, 1);
            EXPECT_EQ(frf.reference_direction, 2);
        }
}

TEST(UffFrf, drivingPointWithTheOtherSignIsRemarked)
{
    UffText set = twoPoints();
    set.ordinate = 8;
    set.unit = "mm";
    EXPECT_FALSE(has(readUffFrf(uffSet(set, twoValues)).notes, notes::frfDrivingPointSign));
    set.response_direction = -1;
    EXPECT_TRUE(has(readUffFrf(uffSet(set, twoValues)).notes, notes::frfDrivingPointSign));
    set.reference_direction = -1;
    EXPECT_FALSE(has(readUffFrf(uffSet(set, twoValues)).notes, notes::frfDrivingPointSign));
    set.response_node = 5;
    set.response_direction = 1;
    EXPECT_FALSE(has(readUffFrf(uffSet(set, twoValues)).notes, notes::frfDrivingPointSign));
}

}  // namespace
}  // namespace lathelier
