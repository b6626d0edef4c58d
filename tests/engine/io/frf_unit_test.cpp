// Units of frequency responses, against their definitions.
#include "engine/io/frf/frf_unit.h"

#include <gtest/gtest.h>

#include <numbers>

namespace lathelier::io {
namespace {

constexpr double pound_N = 0.45359237 * 9.80665;  // definition of the pound-force

struct UnitCase {
    const char* text;
    double scale;  ///< in mm, s, N
    int length, time, force;
};

void expectUnit(const UnitCase& one)
{
    const auto unit = physicalUnit(one.text);
    ASSERT_TRUE(unit) << one.text;
    EXPECT_NEAR(unit->scale / one.scale, 1, 1e-12) << one.text;
    EXPECT_EQ(unit->length, one.length) << one.text;
    EXPECT_EQ(unit->time, one.time) << one.text;
    EXPECT_EQ(unit->force, one.force) << one.text;
}

}  // namespace

TEST(FrfUnit, ForcesOfAllSystems)
{
    const UnitCase cases[] = {{"N", 1, 0, 0, 1},
                              {"kN", 1e3, 0, 0, 1},
                              {"KN", 1e3, 0, 0, 1},
                              {"daN", 10, 0, 0, 1},
                              {"dN", 0.1, 0, 0, 1},
                              {"hN", 100, 0, 0, 1},
                              {"mN", 1e-3, 0, 0, 1},
                              {"µN", 1e-6, 0, 0, 1},
                              {"nN", 1e-9, 0, 0, 1},
                              {"kilonewton", 1e3, 0, 0, 1},
                              {"Meganewtons", 1e6, 0, 0, 1},
                              {"kgf", 9.80665, 0, 0, 1},
                              {"Kgf", 9.80665, 0, 0, 1},
                              {"kg-f", 9.80665, 0, 0, 1},
                              {"kilogram-force", 9.80665, 0, 0, 1},
                              {"kp", 9.80665, 0, 0, 1},
                              {"kilopond", 9.80665, 0, 0, 1},
                              {"gf", 9.80665e-3, 0, 0, 1},
                              {"tf", 9806.65, 0, 0, 1},
                              {"lbf", pound_N, 0, 0, 1},
                              {"lb-f", pound_N, 0, 0, 1},
                              {"pound-force", pound_N, 0, 0, 1},
                              {"kip", 1e3 * pound_N, 0, 0, 1},
                              {"ozf", pound_N / 16, 0, 0, 1},
                              {"pdl", 0.45359237 * 0.3048, 0, 0, 1},  // lb·ft/s²
                              {"dyn", 1e-5, 0, 0, 1},
                              {"kdyn", 1e-2, 0, 0, 1}};
    for (const UnitCase& one : cases) expectUnit(one);
    // MN may be meant as mN, Nm is no length.
    for (const char* text : {"MN", "mn", "Nm", "furlong", "", "N^", "-", "⁻", "kk", "k"})
        EXPECT_FALSE(physicalUnit(text)) << text;
}

TEST(FrfUnit, MotionsAndMassesInOddSpellings)
{
    const UnitCase cases[] = {{"m/s/s", 1e3, 1, -2, 0},
                              {"ms-2", 1e3, 1, -2, 0},
                              {"ms^-2", 1e3, 1, -2, 0},
                              {"mms-1", 1, 1, -1, 0},
                              {"m·s⁻²", 1e3, 1, -2, 0},
                              {"m s⁻¹", 1e3, 1, -1, 0},
                              {"ms", 1e-3, 0, 1, 0},
                              {"dm", 100, 1, 0, 0},
                              {"pm/N", 1e-9, 1, 0, -1},
                              {"microinch/lbf", 25.4e-6 / pound_N, 1, 0, -1},
                              {"g0", 9806.65, 1, -2, 0},
                              {"kg^-1", 1e3, 1, -2, -1},
                              {"1/kg", 1e3, 1, -2, -1},
                              {"kg⁻¹", 1e3, 1, -2, -1},
                              {"1/gram", 1e6, 1, -2, -1},
                              {"1/lbm", 1e3 / 0.45359237, 1, -2, -1},
                              {"1/slug", 304.8 / pound_N, 1, -2, -1},
                              {"(m/s^2)/(kg*m/s^2)", 1e3, 1, -2, -1},
                              {"g/lbf", 9806.65 / pound_N, 1, -2, -1}};
    for (const UnitCase& one : cases) expectUnit(one);
}

TEST(FrfUnit, FrequenciesAndLevels)
{
    constexpr double perRadian = 0.5 / std::numbers::pi;
    EXPECT_EQ(hzPerUnit("[kHz]"), 1e3);
    for (const char* text : {"rad/s", "(rad/s)", "Rad/sec", "rad·s⁻¹", "radians/s"})
        EXPECT_EQ(hzPerUnit(text), perRadian) << text;
    EXPECT_FALSE(hzPerUnit("furlong"));
    EXPECT_EQ(decibelUnit("dB")->unit, "");
    EXPECT_EQ(decibelUnit("dB re 1 m/N")->unit, "m/N");
    EXPECT_EQ(decibelUnit("db/re/1e-6/m/N")->unit, "m/N");
    EXPECT_EQ(decibelUnit("db/re/1e-6/m/N")->reference, 1e-6);
    EXPECT_EQ(decibelUnit("dB (ref. 10 (m/s^2)/N)")->unit, "(m/s^2)/N");
    EXPECT_EQ(decibelUnit("dB (ref. 10 (m/s^2)/N)")->reference, 10);
    for (const char* text : {"", "d", "dbm", "m/N", "dB re 0 m/N", "dB re -1 m/N"})
        EXPECT_FALSE(decibelUnit(text)) << text;
}

}  // namespace lathelier::io
