// Measured profiles: what the columns mean, in which unit, and what is refused.
#include "engine/io/profile/profile_reader.h"
#include "engine/core/core_codes.h"
#include "engine/io/io_codes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>

#include "engine/core/units.h"
#include "engine/io/text/header_lines.h"
#include "tests/engine/io/reading.h"

namespace lathelier {
namespace {

const std::string practiceData = LATHELIER_SOURCE_DIR "/tests/data/";

io::ProfileFile readProfile(const std::string& text, const io::ProfileOptions& profile = {},
                            const io::ImportOptions& import = {})
{
    return io::readProfile("test", text, import, profile);
}

Error profileRefusal(const std::string& text, const io::ProfileOptions& profile = {},
                     const io::ImportOptions& import = {})
{
    try {
        readProfile(text, profile, import);
    } catch (const Error& error) {
        EXPECT_TRUE(find(error.values(), "path"));
        return error;
    }
    ADD_FAILURE() << "no error for " << text.substr(0, 200);
    return Error(errors::unknownOption, {});
}

constexpr int anglesPerTurn = 72;

/// Three lobes of 3 µm on a radius of 25 mm.
double radius_mm(int i)
{
    return 25 + 0.003 * std::cos(3 * turn_rad * i / anglesPerTurn);
}

/// One row for each of 72 even angles.
std::string rows(const std::function<std::string(int i, double angle_deg, double r_mm)>& row)
{
    std::string text;
    for (int i = 0; i < anglesPerTurn; ++i) text += row(i, 360.0 * i / anglesPerTurn, radius_mm(i)) + "\n";
    return text;
}

std::string xyRows(const std::string& delimiter = ",", double scale = 1)
{
    return rows([&](int, double angle_deg, double r) {
        const double a = angle_deg * turn_rad / 360;
        return fmt::format("{:.9f}{}{:.9f}", scale * r * std::cos(a), delimiter, scale * r * std::sin(a));
    });
}

std::string commas(std::string text)
{
    for (char& c : text) c = c == '.' ? ',' : c;
    return text;
}

/// The points are those of the three lobes.
void expectLobes(const io::ProfileFile& file, double tolerance_mm = 1e-8)
{
    ASSERT_EQ(file.profile.points_mm.size(), static_cast<std::size_t>(anglesPerTurn));
    for (int i = 0; i < anglesPerTurn; ++i) {
        const double a = turn_rad * i / anglesPerTurn;
        const Eigen::Vector2d expected = radius_mm(i) * Eigen::Vector2d(std::cos(a), std::sin(a));
        ASSERT_LT((file.profile.points_mm[static_cast<std::size_t>(i)] - expected).norm(), tolerance_mm) << i;
    }
}

TEST(ProfileReader, practiceProfiles)
{
    const std::map<std::string, std::size_t> expected = {{"p05_lobe5_n200.csv", 200},  {"p07_ellipse_n200.csv", 200},
                                                         {"p10_turned_n200.csv", 200}, {"p13_outliers_n200.csv", 200},
                                                         {"p17_8pts.csv", 8},          {"p19_keyway_n3600.csv", 3520}};
    for (const auto& [name, points] : expected) {
        const io::ProfileFile file = io::readProfile(practiceData + "form/" + name);
        EXPECT_EQ(file.facts.format, "profile_xy");
        EXPECT_EQ(file.facts.unit_source, "stated");
        EXPECT_EQ(testing::furtherNotes(file.notes), 0U);
        EXPECT_NEAR(static_cast<double>(file.profile.points_mm.size()), static_cast<double>(points), 2) << name;
        EXPECT_EQ(file.profile.name, name);
    }
}

TEST(ProfileReader, circlesInCoordinatePlanes)
{
    const io::ProfileFile yz = io::readProfile(practiceData + "nist_like/circle1.ds");
    ASSERT_EQ(yz.profile.points_mm.size(), 40U);
    EXPECT_EQ(yz.profile.points_mm[0], Eigen::Vector2d(-102.341986132733, 58.189094410737));
    EXPECT_TRUE(contains(yz.notes, notes::profilePlane));
    const io::ProfileFile zx = io::readProfile(practiceData + "nist_like/circle2.ds");
    EXPECT_EQ(zx.profile.points_mm[0], Eigen::Vector2d(264.914159361227, 99.749827707211));
    const io::ProfileFile xy = io::readProfile(practiceData + "nist_like/circle3.ds");
    EXPECT_EQ(xy.profile.points_mm[0], Eigen::Vector2d(9.805224989030, -1.964381885613));
    for (int i = 1; i <= 10; ++i)
        EXPECT_GE(io::readProfile(practiceData + fmt::format("nist_like/circle{}.ds", i)).profile.points_mm.size(), 3U);
}

TEST(ProfileReader, coordinatesInManyDisguises)
{
    const std::string plain = xyRows();
    const std::string quoted = rows([](int, double a, double r) {
        return fmt::format("\"{:.9f}\",\"{:.9f}\"", r * std::cos(a * turn_rad / 360), r * std::sin(a * turn_rad / 360));
    });
    const std::string fortran = rows([](int, double a, double r) {
        std::string row =
            fmt::format("{:.12E} {:.12E}", r * std::cos(a * turn_rad / 360), r * std::sin(a * turn_rad / 360));
        for (char& c : row) c = c == 'E' ? 'D' : c;
        return row;
    });
    std::string utf16 = "\xFF\xFE";
    for (const char c : "# unit=mm\nx,y\n" + plain) utf16 += std::string{c, '\0'};
    std::string carriage = "x,y\n" + plain;
    for (char& c : carriage) c = c == '\n' ? '\r' : c;
    for (const std::string& text :
         {"# unit=mm\nx,y\n" + plain, "x_mm;y_mm\n" + commas(xyRows(";")), "X [mm]\tY [mm]\r\n" + xyRows("\t"), quoted,
          fortran, plain, utf16, carriage, "\xEF\xBB\xBFx|y\n" + xyRows("|"), xyRows(" "), commas(xyRows(" ")),
          "sep=;\nx;y\n" + xyRows(";"), "# measured 2015\n\n" + plain + "\n# end\n"})
        expectLobes(readProfile(text));
}

TEST(ProfileReader, otherColumnsAreLeftOutByName)
{
    const auto point = [](double a, double r) {
        return fmt::format("{:.9f},{:.9f}", r * std::cos(a * turn_rad / 360), r * std::sin(a * turn_rad / 360));
    };
    expectLobes(readProfile("index,x,y\n" +
                            rows([&](int i, double a, double r) { return std::to_string(i) + "," + point(a, r); })));
    expectLobes(
        readProfile(rows([&](int i, double a, double r) { return std::to_string(i + 1) + "," + point(a, r); })));
    const io::ProfileFile file =
        readProfile("x,y,z\n" + rows([&](int, double a, double r) { return point(a, r) + ",12.5"; }));
    expectLobes(file);
    EXPECT_FALSE(contains(file.notes, notes::coordinateIgnored));
    const io::ProfileFile stack =
        readProfile("x,y,z\n" + rows([&](int i, double a, double r) { return point(a, r) + "," + std::to_string(i); }));
    expectLobes(stack);
    EXPECT_TRUE(contains(stack.notes, notes::coordinateIgnored));
    expectLobes(readProfile("y,x\n" + rows([](int, double a, double r) {
                                return fmt::format("{:.9f},{:.9f}", r * std::sin(a * turn_rad / 360),
                                                   r * std::cos(a * turn_rad / 360));
                            })));
}

TEST(ProfileReader, anglesAndRadii)
{
    const auto polar = [](double scale) {
        return rows([=](int, double a, double r) { return fmt::format("{},{:.9f}", a * scale, r); });
    };
    for (const std::string& text :
         {"angle_deg,r_mm\n" + polar(1), "theta [rad],radius [mm]\n" + polar(turn_rad / 360), "phi,r\n" + polar(1),
          "Winkel (°),Radius\n" + polar(1), polar(1), "angle_mrad,r\n" + polar(turn_rad / 360 * 1000)}) {
        const io::ProfileFile file = readProfile(text);
        EXPECT_EQ(file.facts.format, "profile_polar");
        expectLobes(file);
    }
    // A whole turn of 6.28 can only be radians.
    const io::ProfileFile guessed = readProfile("angle,r\n" + polar(turn_rad / 360));
    expectLobes(guessed);
    EXPECT_TRUE(contains(guessed.notes, notes::angleUnitGuessed));
    // Half a turn without names: angles or coordinates?
    const std::string half = rows([](int, double a, double r) { return fmt::format("{},{:.9f}", a / 2, r); });
    EXPECT_EQ(profileRefusal(half).code(), errors::columnsUnknown);
    io::ProfileOptions options;
    options.columns = io::ProfileColumns::AngleRadius;
    EXPECT_EQ(readProfile(half, options).facts.format, "profile_polar");
    options.columns = io::ProfileColumns::Xy;
    EXPECT_EQ(readProfile(half, options).facts.format, "profile_xy");
}

TEST(ProfileReader, units)
{
    expectLobes(readProfile("# unit=um\nx,y\n" + xyRows(",", 1000)), 1e-6);
    expectLobes(readProfile("x_um,y_um\n" + xyRows(",", 1000)), 1e-6);
    expectLobes(readProfile("x (inch),y (inch)\n" + xyRows(",", 1 / 25.4)), 1e-6);
    // 25 000 fits no guess.
    EXPECT_EQ(profileRefusal(xyRows(",", 1000)).code(), errors::unitUnknown);
    io::ImportOptions um;
    um.unit = io::LengthUnit::Micrometre;
    expectLobes(readProfile(xyRows(",", 1000), {}, um), 1e-6);
    const io::ProfileFile guessed = readProfile(xyRows());
    EXPECT_EQ(guessed.facts.unit_source, "guessed");
    EXPECT_TRUE(contains(guessed.notes, notes::unitGuessed));
    const io::ProfileFile stated = readProfile("# unit=mm\nx,y\n" + xyRows(), {}, um);
    EXPECT_TRUE(contains(stated.notes, notes::unitNotUsed));
    expectLobes(stated);
    EXPECT_EQ(profileRefusal("x_mm,y_um\n" + xyRows()).code(), errors::malformed);
}

TEST(ProfileReader, deviationsNeedARadius)
{
    const std::string table = "# unit=um\nangle_deg,r\n" + rows([](int, double a, double r) {
                                  return fmt::format("{},{:.6f}", a, (r - 25) * 1000);
                              });
    const std::string named = "angle_deg,deviation_um\n" + rows([](int, double a, double r) {
                                  return fmt::format("{},{:.6f}", a, (r - 25) * 1000 + 20);
                              });
    EXPECT_EQ(profileRefusal(table).code(), errors::nominalRadiusMissing);
    EXPECT_EQ(profileRefusal(named).code(), errors::nominalRadiusMissing);
    io::ProfileOptions options;
    options.nominal_radius_mm = 25;
    const io::ProfileFile file = readProfile(table, options);
    expectLobes(file);
    EXPECT_TRUE(file.profile.size_is_nominal);
    EXPECT_TRUE(contains(file.notes, notes::sizeFromNominal));
    options.nominal_radius_mm = 24.98;
    expectLobes(readProfile(named, options));
    // The file itself may state the radius.
    expectLobes(readProfile("# D_mm=50\n" + table));
    // Without a unit neither µm nor mm is likelier.
    const std::string bare = table.substr(table.find('\n') + 1);
    options.nominal_radius_mm = 25;
    EXPECT_EQ(profileRefusal(bare, options).code(), errors::unitUnknown);
    // Radii need no nominal, and do not become deviations by one.
    const io::ProfileFile radii = readProfile(
        "angle_deg,r_mm\n" + rows([](int, double a, double r) { return fmt::format("{},{}", a, r); }), options);
    expectLobes(radii);
    EXPECT_FALSE(radii.profile.size_is_nominal);
    EXPECT_TRUE(contains(radii.notes, notes::nominalNotUsed));
}

TEST(ProfileReader, tracesOfRoundnessInstruments)
{
    const auto values = [](double offset_um) {
        return rows([=](int, double, double r) { return fmt::format("{:.6f}", (r - 25) * 1000 + offset_um); });
    };
    const std::string head = "Instrument: roundness tester\nUnits: µm\nFilter: 1-50 UPR\nNominal\t25\n";
    io::ProfileOptions options;
    options.nominal_radius_mm = 25;
    const io::ProfileFile file = readProfile(head + values(0), options);
    EXPECT_EQ(file.facts.format, "roundness_trace");
    EXPECT_EQ(file.facts.delimiter, "");
    expectLobes(file);
    EXPECT_TRUE(contains(file.notes, notes::anglesUniform));
    EXPECT_EQ(*io::headerWord(file.header, "filter"), "1-50 UPR");
    EXPECT_EQ(profileRefusal(head + values(0)).code(), errors::nominalRadiusMissing);
    expectLobes(readProfile(head + commas(values(0)), options));
    EXPECT_EQ(profileRefusal(values(10)).code(), errors::nominalRadiusMissing);
    options.nominal_radius_mm = 24.99;
    expectLobes(readProfile(head + values(10), options));
}

TEST(ProfileReader, oneColumnOrTwo)
{
    io::ProfileOptions options;
    options.nominal_radius_mm = 25;
    io::ImportOptions um;
    um.unit = io::LengthUnit::Micrometre;
    // "0,250" may be a quarter, or a point; leading zeros behind the comma tell.
    EXPECT_EQ(readProfile("0,250\n0,025\n-0,125\n0,250\n", options, um).profile.points_mm.size(), 4U);
    EXPECT_EQ(readProfile("0,250\n0,025\n-0,125\n0,250\n", options, um).facts.format, "roundness_trace");
    EXPECT_EQ(profileRefusal("1,250\n2,251\n3,250\n4,249\n").code(), errors::numberAmbiguous);
    EXPECT_EQ(profileRefusal("10,25\n20,251\n30,5\n40,249\n").code(), errors::numberAmbiguous);
    EXPECT_EQ(readProfile("x,y\n10,25\n20,25\n30,5\n10,2\n").profile.points_mm[0], Eigen::Vector2d(10, 25));
    um.delimiter = io::Delimiter::Comma;
    EXPECT_EQ(readProfile("10,25\n20,25\n30,5\n10,2\n", {}, um).profile.points_mm.size(), 4U);
    um.delimiter = io::Delimiter::Auto;
    um.decimal = io::Decimal::Comma;
    EXPECT_EQ(readProfile("10,25\n20,25\n30,5\n10,2\n", options, um).facts.format, "roundness_trace");
    EXPECT_EQ(readProfile("1 250\n2 251\n1 250\n4 249\n").facts.format, "profile_xy");
}

TEST(ProfileReader, whatIsNoProfile)
{
    EXPECT_EQ(profileRefusal("").code(), errors::fileEmpty);
    EXPECT_EQ(profileRefusal("# nothing\n").code(), errors::formatUnknown);
    EXPECT_EQ(profileRefusal("nan,nan\nnan,nan\nnan,nan\n").code(), errors::noPoints);
    EXPECT_EQ(profileRefusal("x,y\n1,2\n3,four\n5,6\n").code(), errors::malformed);
    EXPECT_EQ(testing::integerOf(profileRefusal("x,y\n1,2\n3,four\n5,6\n"), "line"), 3);
    EXPECT_EQ(profileRefusal("t_s,X3_um,Y3_um\n0,1,2\n1,2,3\n2,3,4\n").code(), errors::formatUnknown);
    EXPECT_EQ(profileRefusal("a,b,c,d\n1.5,2,3,4\n5,6,7,8\n").code(), errors::columnsUnknown);
    EXPECT_EQ(profileRefusal("x,w\n1.5,2\n5,6\n").code(), errors::columnsUnknown);
    EXPECT_EQ(profileRefusal("1.5 2 3\n5 6.5 7\n5 1 9.5\n").code(), errors::columnsUnknown);
    EXPECT_EQ(profileRefusal("x_mm,y_mm\n1e30,0\n0,1e30\n-1e30,0\n").code(), errors::coordinateTooLarge);
    EXPECT_EQ(profileRefusal("5\n1,2,3\n4,5,3\n7,8,3\n").code(), errors::truncated);
    EXPECT_EQ(profileRefusal(std::string("\x89PNG\r\n\x1a\n\0\0", 10)).code(), errors::formatUnknown);
    const io::ProfileFile holes = readProfile("x_mm,y_mm\n1,2\nnan,3\n3,4\n");
    EXPECT_EQ(holes.profile.points_mm.size(), 2U);
    EXPECT_TRUE(contains(holes.notes, notes::pointsNotFinite));
}

TEST(ProfileReader, cloudsAreNotTakenForProfiles)
{
    EXPECT_FALSE(io::isProfileTable("1 2 3\n4 5 6\n7 8 9\n"));
    EXPECT_FALSE(io::isProfileTable("x,y,z\n1,2,3\n4,5,6\n"));
    EXPECT_FALSE(io::isProfileTable("1 2 3 4 5 6\n4 5 6 7 8 9\n"));
    EXPECT_FALSE(io::isProfileTable(""));
    EXPECT_TRUE(io::isProfileTable("x,y\n1,2\n4,5\n"));
    EXPECT_TRUE(io::isProfileTable("angle,r\n1,2\n4,5\n"));
}

}  // namespace
}  // namespace lathelier
