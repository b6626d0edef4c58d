// Cycles that Sinumerik calls by their names: what is left of the stock, counted from the moves.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "tests/engine/gcode/run_program.h"

namespace lathelier::gcode {
namespace {

const std::string turningHead = "G90 G18 G95 G71 DIAMON G40\nT1 D1\nG97 S1200 M3 F0.3\nG0 X90 Z10\n";

/// CYCLE95 with these arguments behind the name of its contour, and the contour between two labels.
std::string removalOf(const std::string& arguments, const std::string& contour)
{
    return turningHead + "CYCLE95(\"AA:BB\"," + arguments + ")\nM30\nAA:\n" + contour + "BB:\n";
}

/// What feed moves leave of a bar: its radius by Z, in columns; and whether a rapid move enters it. `sign`: -1 for a
/// bore, which grows.
class LeftOfBar {
public:
    LeftOfBar(double bar_mm, double from_mm, double to_mm, double sign = 1)
        : from_(from_mm), to_(to_mm), sign_(sign), radius_(columns + 1, sign * bar_mm)
    {
    }

    void cut(const Toolpath& path)
    {
        Point at;
        for (const Move& move : path.moves) {
            const Point to{move.x_mm, move.z_mm};
            if (isKnown(at) && isKnown(to) && move.kind != MoveKind::Dwell) along(move, at, to);
            if (isKnown(to)) at = to;
        }
    }
    double at(double z) const
    {
        return sign_ * radius_[static_cast<std::size_t>(std::lround((z - from_) / (to_ - from_) * columns))];
    }
    double zOf(int column) const { return from_ + (to_ - from_) * column / columns; }

    double deepest_rapid_mm = 0;
    double deepest_cut_mm = 0;
    static constexpr int columns = 4000;

private:
    void along(const Move& move, const Point& from, const Point& to)
    {
        const int steps = 20000;
        const bool isArc = move.kind == MoveKind::Arc;
        const Point centre{move.centre_x_mm, move.centre_z_mm};
        const double radius = isArc ? std::hypot(from.x_mm - centre.x_mm, from.z_mm - centre.z_mm) : 0;
        double first = 0, last = 0;
        if (isArc) {
            first = std::atan2(from.x_mm - centre.x_mm, from.z_mm - centre.z_mm);
            last = std::atan2(to.x_mm - centre.x_mm, to.z_mm - centre.z_mm);
            const double turn = 2 * std::acos(-1.0);
            if (move.clockwise && last > first) last -= turn;
            if (!move.clockwise && last < first) last += turn;
        }
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            const double angle = first + (last - first) * t;
            const double x = isArc ? centre.x_mm + radius * std::sin(angle) : from.x_mm + (to.x_mm - from.x_mm) * t;
            const double z = isArc ? centre.z_mm + radius * std::cos(angle) : from.z_mm + (to.z_mm - from.z_mm) * t;
            touch(move.kind, sign_ * x, z);
        }
    }
    void touch(MoveKind kind, double x, double z)
    {
        const double column = (z - from_) / (to_ - from_) * columns;
        if (column < -1e-6 || column > columns + 1e-6 || std::abs(column - std::round(column)) > 0.25) return;
        double& here = radius_[static_cast<std::size_t>(std::lround(column))];
        double& deepest = kind == MoveKind::Rapid ? deepest_rapid_mm : deepest_cut_mm;
        deepest = std::max(deepest, here - x);
        if (kind != MoveKind::Rapid) here = std::min(here, x);
    }

    double from_, to_, sign_;
    std::vector<double> radius_;
};

std::string placesOf(const Toolpath& path)
{
    std::string text;
    for (const Move& move : path.moves)
        text += fmt::format("{}{:.6g},{:.6g} ", key(move.kind)[0], move.x_mm, move.z_mm);
    return text;
}

TEST(StockRemoval, PassesShareTheDepthOfTheirSection)
{
    // Ø34 to Ø28, 0.2 mm left: 3 mm in two passes of 1.5 mm.
    const Toolpath path = pathOf(removalOf("2,0.1,0.2,,0.25,0.1,0.15,1,,,0.5", "G1 X28 Z2\nZ-50\nX34\n"), "sinumerik");
    ASSERT_FALSE(path.has_errors);
    EXPECT_TRUE(path.understanding.isWhole());
    EXPECT_EQ(path.words, path.words_understood);
    EXPECT_EQ(placesOf(path),
              "r45,10 r17.7,2.6 r15.7,2.6 f15.7,-49.9 f17.2,-49.9 r17.7,-49.4 r17.7,2.6 r14.2,2.6 f14.2,-49.9 "
              "f15.7,-49.9 r16.2,-49.4 r16.2,2.6 r17.7,2.6 ");
    EXPECT_EQ(path.moves[3].feed_mm_rev, 0.25);
}

TEST(StockRemoval, LeavesTheContourAndItsAllowances)
{
    // Of the guide: cone, steps, two pockets; roundings.
    const std::string contour =
        "G1 X37 Z120\nX40 Z117\nZ112 RND=5\nX65 Z95 RND=5\nZ87\nX29 Z77\nZ62\nX44 Z58\nZ52\nX37 Z41\nZ35\nX76\n";
    const Toolpath rough = pathOf(removalOf("5,0,0.6,,0.2,0.1,0.2,1,,,0.5", contour), "sinumerik");
    const Toolpath both = pathOf(removalOf("5,0,0.6,,0.2,0.1,0.2,9,,,0.5", contour), "sinumerik");
    const Toolpath finish = pathOf(removalOf("5,0,0.6,,0.2,0.1,0.2,5,,,0.5", contour), "sinumerik");
    ASSERT_TRUE(rough.understanding.isWhole() && both.understanding.isWhole() && finish.understanding.isWhole());
    LeftOfBar left(38.6, 36, 119.9), after(38.6, 36, 119.9), alone(38.6, 36, 119.9);
    left.cut(rough);
    after.cut(both);
    alone.cut(finish);
    // Known places: Z 115 Ø40, 90 Ø65, 70 Ø29, 55 Ø44, 38 Ø37; half of the cones at 82 (Ø47) and 60 (Ø36.5).
    const double known[][2] = {{115, 20}, {90, 32.5}, {70, 14.5}, {55, 22}, {38, 18.5}, {82, 23.5}, {60, 18.25}};
    for (const auto& [z, radius] : known) {
        EXPECT_NEAR(left.at(z), radius + 0.6, 0.02) << z;
        EXPECT_NEAR(after.at(z), radius, 0.02) << z;
        EXPECT_NEAR(alone.at(z), radius, 0.02) << z;
    }
    for (int i = 0; i <= LeftOfBar::columns; ++i) {
        EXPECT_NEAR(after.at(after.zOf(i)), alone.at(alone.zOf(i)), 0.02);
        EXPECT_NEAR(left.at(left.zOf(i)), after.at(after.zOf(i)) + 0.6, 0.05) << left.zOf(i);
    }
    EXPECT_LT(left.deepest_rapid_mm, 0.02);
    EXPECT_LT(after.deepest_rapid_mm, 0.02);
    // 39 mm, 36 mm and 7 mm of diameter by at most 5 mm of radius: 4, 4 and 1 passes.
    EXPECT_NEAR(left.deepest_cut_mm, 4.875, 0.01);
}

TEST(StockRemoval, RoundsAndCutsPocketsOfAnyContour)
{
    std::mt19937 random(7);
    const auto within = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int run = 0; run < 40; ++run) {
        double z = 0, x = within(10, 16);
        std::string contour = fmt::format("G1 X{:.3f} Z0\n", 2 * x);
        std::vector<std::array<double, 2>> points{{0, x}};
        double most = x;
        const int count = 3 + run % 5;
        for (int i = 0; i < count; ++i) {
            z -= within(3, 9);
            if (i % 2 == 1) x = within(8, 30);
            contour += fmt::format("X{:.3f} Z{:.3f}\n", 2 * x, z);
            points.push_back({z, x});
            most = std::max(most, x);
        }
        const Toolpath path = pathOf(removalOf("1.7,0,0.4,,0.2,0.1,0.2,1", contour), "sinumerik");
        ASSERT_TRUE(path.understanding.isWhole()) << contour;
        LeftOfBar left(most + 0.4, z + 0.05, -0.05);
        left.cut(path);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double middle = (points[i][0] + points[i - 1][0]) / 2;
            EXPECT_NEAR(left.at(middle), (points[i][1] + points[i - 1][1]) / 2 + 0.4, 0.1) << contour << middle;
        }
        EXPECT_LT(left.deepest_rapid_mm, 0.1) << contour;
        EXPECT_LT(left.deepest_cut_mm, 1.7 + 0.1) << contour;
    }
}

TEST(StockRemoval, DirectionOfTheContourIsFree)
{
    const std::string forward = "G1 X20 Z2\nZ-20\nX30 Z-30\nZ-40\nX40\n",
                      back = "G1 X40 Z-40\nX30\nZ-30\nX20 Z-20\nZ2\n";
    for (const char* kind : {"1", "9"}) {
        const std::string arguments = std::string("2,0.1,0.2,,0.2,0.1,0.2,").append(kind);
        EXPECT_EQ(placesOf(pathOf(removalOf(arguments, forward), "sinumerik")),
                  placesOf(pathOf(removalOf(arguments, back), "sinumerik")));
    }
    // Finishing alone follows the contour as it is programmed.
    const Toolpath path = pathOf(removalOf("2,0.1,0.2,,0.2,0.1,0.2,5", back), "sinumerik");
    EXPECT_EQ(placesOf(path), "r45,10 r21.2,3.1 r21.2,-40 r20,-40 f15,-40 f15,-30 f10,-20 f10,2 r21.2,2 r21.2,3.1 ");
}

TEST(StockRemoval, InsideAndFace)
{
    // A bore: Ø40, 20 deep, then Ø30; finished.
    const Toolpath bore =
        pathOf(removalOf("1,0.1,0.2,,0.2,0.1,0.2,11", "G1 X40 Z1\nZ-20\nX30\nZ-30\nX26\n"), "sinumerik");
    ASSERT_TRUE(bore.understanding.isWhole());
    LeftOfBar hole(12.8, -29.9, -0.1, -1);
    hole.cut(bore);
    EXPECT_NEAR(hole.at(-10), 20, 1e-6);
    EXPECT_NEAR(hole.at(-25), 15, 1e-6);
    EXPECT_LT(hole.deepest_rapid_mm, 1e-6);
    // A face: from Ø50 inward, passes of 1 mm along X, 0.1 mm left.
    const Toolpath face = pathOf(removalOf("1,0.1,0.2,,0.2,0.1,0.2,2", "G1 X52 Z-2\nX20\nZ0\n"), "sinumerik");
    ASSERT_TRUE(face.understanding.isWhole());
    EXPECT_EQ(placesOf(face),
              "r45,10 r27.2,1.1 r27.2,-0.9 f10.2,-0.9 f10.2,0.1 r11.2,1.1 r27.2,1.1 r27.2,-1.9 f10.2,-1.9 f10.2,-0.9 "
              "r11.2,0.1 r27.2,0.1 r27.2,1.1 ");
}

TEST(StockRemoval, AllowancesStandOnBothFlanksOfAPocket)
{
    const Toolpath path =
        pathOf(removalOf("2,0.3,0.2,,0.2,0.1,0.2,1", "G1 X30 Z2\nZ-10\nX20\nZ-20\nX30\nZ-30\nX34\n"), "sinumerik");
    ASSERT_TRUE(path.understanding.isWhole());
    LeftOfBar left(17.2, -29.5, 1.9);
    left.cut(path);
    EXPECT_NEAR(left.at(-5), 15.2, 1e-6);
    EXPECT_NEAR(left.at(-10.2), 15.2, 1e-6);
    EXPECT_NEAR(left.at(-10.4), 10.2, 1e-6);
    EXPECT_NEAR(left.at(-19.6), 10.2, 1e-6);
    EXPECT_NEAR(left.at(-19.8), 15.2, 1e-6);
    // A pocket that is narrower than that is not understood.
    const Toolpath narrow =
        pathOf(removalOf("2,3,0.2,,0.2,0.1,0.2,1", "G1 X30 Z2\nZ-10\nX20\nZ-15\nX30\nZ-30\nX34\n"), "sinumerik");
    EXPECT_FALSE(narrow.has_errors);
    EXPECT_FALSE(narrow.understanding.isWhole());
}

struct Compensated {
    const char* kind;
    const char* nose;
    int tip;
    const char* before;  ///< in front of the contour, on the line of its first piece
    const char* start;
    const char* contour;  ///< behind its start
};

TEST(StockRemoval, TheNoseIsCompensated)
{
    const Compensated all[] = {
        {"5", "G42", 3, "X20 Z3", "X20 Z2", "Z-20\nX40 Z-30\nZ-40\nX50\n"},
        {"5", "G41", 3, "X51 Z-40", "X50 Z-40", "X40\nZ-30\nG3 X32 Z-26 CR=4\nG1 Z2\n"},
        {"7", "G41", 2, "X60 Z3", "X60 Z2", "Z-20\nX40 Z-30\nZ-40\nX30\n"},
        {"6", "G41", 3, "X62 Z-6", "X60 Z-6", "X30\nX20 Z-2\nX10\nZ1\n"},
    };
    for (const Compensated& one : all) {
        const ToolTable tools{{1, {.number = 1, .tip = one.tip, .corner_radius_mm = 0.8}}};
        const std::string start = one.start, contour = one.contour;
        const Toolpath cycle =
            pathOf(removalOf(std::string("2,0,0,,0.2,0.1,0.2,").append(one.kind), "G1 " + start + "\n" + contour),
                   "sinumerik", {}, tools);
        const Toolpath twin = pathOf(
            turningHead + "G0 " + one.before + "\n" + one.nose + " G1 " + start + " F0.2\n" + contour + "G40\nM30\n",
            "sinumerik", {}, tools);
        ASSERT_TRUE(cycle.understanding.isWhole()) << one.kind;
        std::vector<Point> both[2];
        for (const Move& move : cycle.moves)
            if (move.kind != MoveKind::Rapid) both[0].push_back({move.x_mm, move.z_mm});
        for (const Move& move : twin.moves)
            if (move.kind != MoveKind::Rapid) both[1].push_back({move.x_mm, move.z_mm});
        ASSERT_EQ(both[1].size(), both[0].size() + 1) << one.kind;  // and the block that starts it up
        for (std::size_t i = 0; i < both[0].size(); ++i) {
            EXPECT_NEAR(both[0][i].x_mm, both[1][i + 1].x_mm, 1e-9) << one.kind << i;
            EXPECT_NEAR(both[0][i].z_mm, both[1][i + 1].z_mm, 1e-9) << one.kind << i;
        }
    }
}

TEST(StockRemoval, UnitsAndShiftsOfTheProgramCount)
{
    const auto withHead = [](const char* first, const char* cycle) {
        return pathOf(std::string(first) + "DIAMON G95 G97 S900 M3 F0.1\nT1 D1\n" + cycle, "sinumerik");
    };
    const char* const plain = "CYCLE95(\"AA:BB\",2,0.1,0.2,,0.25,,,1)\nM30\nAA:\nG1 X28 Z2\nZ-50\nX34\nBB:\n";
    const char* const lower = "CYCLE95(\"AA:BB\",2,0.1,0.2,,0.25,,,1)\nM30\nAA:\nG1 X28 Z-3\nZ-55\nX34\nBB:\n";
    const char* const inch =
        "CYCLE95(\"AA:BB\",2/25.4,0.1/25.4,0.2/25.4,,0.25,,,1,,,1/25.4)\nM30\nAA:\nG1 X=28/25.4 Z=2/25.4\n"
        "Z=-50/25.4\nX=34/25.4\nBB:\n";
    EXPECT_EQ(placesOf(withHead("TRANS Z-5\n", plain)), placesOf(withHead("", lower)));
    EXPECT_EQ(placesOf(withHead("G70\n", inch)), placesOf(withHead("", plain)));
    EXPECT_FALSE(withHead("ROT RPL=10\n", plain).understanding.isWhole());
}

TEST(StockRemoval, TheContourIsAProgramOrStandsBetweenLabels)
{
    const std::string call = "CYCLE95(\"KONTUR\",2,,0.2,,0.2,0.1,0.2,1)\nM30\n";
    const std::string wanted =
        placesOf(pathOf(removalOf("2,,0.2,,0.2,0.1,0.2,1", "G1 X28 Z2\nZ-50\nX34\n"), "sinumerik"));
    for (const char* program :
         {"%_N_KONTUR_SPF\nG1 X28 Z2\nZ-50\nX34\nM17\n", "%_N_KONTUR_SPF\nG1 X28 Z2\nZ-50\nX34 M17\n",
          "%_N_KONTUR_SPF\nPROC KONTUR\nG1 X28 Z2\nZ-50\nX34\nRET\n",
          "%_N_KONTUR_SPF\nG1 X28 Z2\nZ-50\nX34\n%_N_OTHER_SPF\nX99\nM17\n"}) {
        const Toolpath path = pathOf(turningHead + call + program, "sinumerik");
        EXPECT_TRUE(path.understanding.isWhole()) << program;
        EXPECT_EQ(placesOf(path), wanted) << program;
    }
    const Toolpath missing = pathOf(turningHead + call, "sinumerik");
    EXPECT_FALSE(missing.has_errors);
    ASSERT_FALSE(missing.understanding.isWhole());
    EXPECT_EQ(missing.understanding.first()->line, 5);
    EXPECT_EQ(missing.understanding.first()->code, "nc_subprogram_missing");
}

TEST(StockRemoval, PocketsNestedTooDeepAreAGap)
{
    for (const int count : {20, 90}) {
        std::string contour = "G1 X60 Z0\n";
        for (int i = 0; i < count; ++i)
            contour += fmt::format("X{:.1f} Z{}\nX{:.1f} Z{}\n", 20 + 0.2 * i, -2 * i - 1, 59 - 0.2 * i, -2 * i - 2);
        contour += fmt::format("X60 Z{}\n", -2 * count - 1);
        const Toolpath path = pathOf(removalOf("2,0,0,,0.2,0.1,0.2,1", contour), "sinumerik");
        EXPECT_FALSE(path.has_errors);
        EXPECT_EQ(path.understanding.isWhole(), count == 20);
    }
}

struct RefusedCycle {
    const char* arguments;
    const char* code;  ///< of the error; nullptr: a gap
};

TEST(StockRemoval, WhatIsWrongIsAnErrorAndWhatIsOpenAGap)
{
    const std::string plain = "G1 X28 Z2\nZ-50\nX34\n", sloped = "G1 X28 Z2\nZ-50\nX34 Z-60\n";
    const RefusedCycle wrong[] = {{"0,,0.2,,0.2,0.1,0.2,1", "nc_cycle_incomplete"},
                                  {"2,,0.2,,0.2,0.1,0.2,13", "nc_cycle_incomplete"},
                                  {"2,,0.2,,0.2,0.1,0.2", "nc_cycle_incomplete"},
                                  {"0.0001,,0.2,,0.2,0.1,0.2,1", "nc_pass_limit"},
                                  {"2,,-0.2,,0.2,0.1,0.2,1", nullptr},
                                  {"2,,0.2,,0.2,0.1,0.2,1,,,,7", nullptr}};
    for (const RefusedCycle& one : wrong) {
        const Toolpath path = pathOf(removalOf(one.arguments, plain), "sinumerik");
        EXPECT_EQ(path.has_errors, one.code != nullptr) << one.arguments;
        EXPECT_EQ(path.understanding.isWhole(), one.code != nullptr) << one.arguments;
        if (!one.code) continue;
        const Diagnostic* const found = diagnosticOf(path, one.code);
        ASSERT_TRUE(found) << one.arguments;
        EXPECT_EQ(found->line, 5) << one.arguments;
    }
    // An allowance along the contour is clear on cylinders and faces only.
    EXPECT_TRUE(pathOf(removalOf("2,,,0.2,0.2,0.1,0.2,1", plain), "sinumerik").understanding.isWhole());
    EXPECT_FALSE(pathOf(removalOf("2,,,0.2,0.2,0.1,0.2,1", sloped), "sinumerik").understanding.isWhole());
    // The contour turns back; compensation is on; a label is missing.
    EXPECT_FALSE(
        pathOf(removalOf("2,,,,0.2,0.1,0.2,1", "G1 X28 Z2\nZ-50\nX34 Z-40\n"), "sinumerik").understanding.isWhole());
    const Toolpath label =
        pathOf(turningHead + "CYCLE95(\"AA:BB\",2,,,,0.2,0.1,0.2,1)\nM30\nAA:\nG1 X2 Z2\n", "sinumerik");
    EXPECT_TRUE(label.has_errors);
    ASSERT_TRUE(diagnosticOf(label, "nc_sequence_missing"));
}

TEST(ThreadTurning, EvenAndDegressivePasses)
{
    // M42: pitch 4.5; depth 1.23, five roughing passes, two idle ones.
    for (const auto& [kind, share] : {std::pair{"1", 0.2}, std::pair{"3", std::sqrt(0.2)}}) {
        const Toolpath path =
            pathOf(turningHead + "CYCLE97(,42,0,-35,42,42,10,3,1.23,0,0,0,5,2," + kind + ",1)\nM30\n", "sinumerik");
        ASSERT_TRUE(path.understanding.isWhole());
        std::vector<const Move*> cuts;
        for (const Move& move : path.moves)
            if (move.kind == MoveKind::Thread) cuts.push_back(&move);
        ASSERT_EQ(cuts.size(), 7u);
        EXPECT_NEAR(cuts[0]->x_mm, 21 - 1.23 * share, 1e-9);
        EXPECT_NEAR(cuts[4]->x_mm, 21 - 1.23, 1e-12);
        EXPECT_NEAR(cuts[6]->x_mm, 21 - 1.23, 1e-12);
        EXPECT_EQ(cuts[0]->z_mm, -38);
        EXPECT_EQ(cuts[0]->feed_mm_rev, 4.5);
        EXPECT_EQ(path.moves.back().x_mm, 22);
        EXPECT_EQ(path.moves.back().z_mm, 10);
    }
}

TEST(ThreadTurning, AllowanceInsideAndWhatIsWrong)
{
    const auto cycle = [](const char* arguments) {
        return pathOf(turningHead + "CYCLE97(" + arguments + ")\nM30\n", "sinumerik");
    };
    const Toolpath inside = cycle("1.5,,0,-20,18.4,18.4,3,2,0.8,0.05,29,0,3,0,4,1");
    ASSERT_TRUE(inside.understanding.isWhole());
    std::vector<double> depths;
    for (const Move& move : inside.moves)
        if (move.kind == MoveKind::Thread) depths.push_back(move.x_mm - 9.2);
    ASSERT_EQ(depths.size(), 4u);
    EXPECT_NEAR(depths[0], 0.75 / std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(depths[2], 0.75, 1e-9);
    EXPECT_NEAR(depths[3], 0.8, 1e-9);
    EXPECT_TRUE(diagnosticOf(cycle("1.5,,0,-20,18,18,3,2,0.8,0,0,0,3,0,5,1"), "nc_cycle_incomplete"));
    EXPECT_TRUE(diagnosticOf(cycle("1.5,42,0,-20,42,42,3,2,0.8,0,0,0,3,0,3,1"), "nc_cycle_incomplete"));
    EXPECT_TRUE(diagnosticOf(cycle("1.5,,0,-20,18,18,3,2,0,0,0,0,3,0,3,1"), "nc_cycle_incomplete"));
    EXPECT_TRUE(diagnosticOf(cycle("1.5,,0,-20,18,18,3,2,0.8,0,0,0,30000,0,3,1"), "nc_pass_limit"));
    EXPECT_FALSE(cycle("1.5,,0,-20,18,18,3,2,0.8,0,0,0,0,0,3,1").understanding.isWhole());
    EXPECT_FALSE(cycle("1.5,,0,-1,18,38,3,2,0.8,0,0,0,3,0,3,1").understanding.isWhole());
}

TEST(Grooving, ABladeLeavesAPlainGroove)
{
    const ToolTable tools{
        {1, {.number = 1, .kind = ToolKind::Blade, .tip = 3, .corner_radius_mm = 0.1, .width_mm = 3}}};
    const std::string call = "CYCLE93(40,-20,8,4,,,,,,,,0.2,0.2,1.5,0.5,";
    for (const char* kind : {"5", "1"}) {
        const Toolpath path = pathOf(turningHead + call + kind + ")\nM30\n", "sinumerik", {}, tools);
        ASSERT_TRUE(path.understanding.isWhole()) << kind;
        const double far = kind[0] == '5' ? -20 : -12, near = far - 8;
        double low = 99, high = -99, deepest = 99;
        for (const Move& move : path.moves) {
            if (move.kind != MoveKind::Feed) continue;
            deepest = std::min(deepest, move.x_mm);
            low = std::min(low, move.z_mm);
            high = std::max(high, move.z_mm);
        }
        EXPECT_NEAR(deepest, 16, 1e-12);
        EXPECT_NEAR(low, near, 1e-12);
        EXPECT_NEAR(high, far - 3, 1e-12);
    }
    const Toolpath unknown = pathOf(turningHead + call + "5)\nM30\n", "sinumerik");
    EXPECT_FALSE(unknown.understanding.isWhole());
    EXPECT_FALSE(pathOf(turningHead + "CYCLE93(40,-20,8,4,,10,10,,,,,,,1.5,,5)\nM30\n", "sinumerik", {}, tools)
                     .understanding.isWhole());
    EXPECT_TRUE(diagnosticOf(pathOf(turningHead + "CYCLE93(40,-20,2,4,,,,,,,,,,1.5,,5)\nM30\n", "sinumerik", {}, tools),
                             "nc_cycle_incomplete"));
}

TEST(Grooving, EdgesAreChamferedAndRounded)
{
    const ToolTable sharp{{1, {.number = 1, .kind = ToolKind::Blade, .tip = 3, .width_mm = 3}}};
    const Toolpath path = pathOf(turningHead + "CYCLE93(40,-20,8,4,,,,-1,0.5,,,,,,,15)\nM30\n", "sinumerik", {}, sharp);
    ASSERT_TRUE(path.understanding.isWhole());
    EXPECT_TRUE(placesOf(path).ends_with(  // 1 mm at the wall Z-20, then 0.5 mm at the wall Z-28
        "f20,-21 f20,-22 f19,-23 f16,-23 f16,-25.5 r21,-25.5 "
        "r21,-29.5 f20,-29.5 f20,-28.5 a19.5,-28 f16,-28 f16,-25.5 r21,-25.5 r21,-23 "))
        << placesOf(path);
    for (const Move& move : path.moves)
        if (move.kind == MoveKind::Arc) {
            EXPECT_EQ(move.centre_x_mm, 19.5);
            EXPECT_EQ(move.centre_z_mm, -28.5);
            EXPECT_TRUE(move.clockwise);
        }
    // A chamfer by its length: 1 mm is 0.7071 mm along each leg.
    const Toolpath chord = pathOf(turningHead + "CYCLE93(40,-20,8,4,,,,-1,,,,,,,,5)\nM30\n", "sinumerik", {}, sharp);
    EXPECT_NE(placesOf(chord).find("f19.2929,-23 "), std::string::npos);
    const ToolTable round{
        {1, {.number = 1, .kind = ToolKind::Blade, .tip = 3, .corner_radius_mm = 0.2, .width_mm = 3}}};
    const Toolpath compensated =
        pathOf(turningHead + "CYCLE93(40,-20,8,4,,,,-1,-1,,,,,,,15)\nM30\n", "sinumerik", {}, round);
    ASSERT_TRUE(compensated.understanding.isWhole());
    // The chamfer at the wall Z-28 lies on x + z = -9; the centre of the corner r beside it, the tip r below and
    // behind.
    int ends = 0;
    for (const Move& move : compensated.moves) {
        if (move.kind != MoveKind::Feed || move.x_mm < 18.5 || move.x_mm > 19.5 || move.z_mm > -27.5) continue;
        EXPECT_NEAR(move.x_mm + move.z_mm, -9 + 0.2 * (std::sqrt(2.0) - 2), 1e-9);
        ++ends;
    }
    EXPECT_EQ(ends, 1);
}

TEST(CalledCycles, ModalCallsRunBehindEveryBlockThatMoves)
{
    const std::string pocket = "%_N_NUT_SPF\nG91 G1 X-4 F0.1\nX4\nG90\nM17\n";
    const Toolpath modal =
        pathOf(turningHead + "G0 X42 Z-5\nMCALL NUT\nG0 Z-10\nZ-20\nM8\nMCALL\nZ-30\nM30\n" + pocket, "sinumerik");
    const Toolpath plain =
        pathOf(turningHead + "G0 X42 Z-5\nG0 Z-10\nNUT\nG0 Z-20\nNUT\nM8\nG0 Z-30\nM30\n" + pocket, "sinumerik");
    ASSERT_TRUE(modal.understanding.isWhole() && plain.understanding.isWhole());
    std::string with = placesOf(modal), without = placesOf(plain);
    EXPECT_EQ(std::count(with.begin(), with.end(), 'f'), 6);  // G1 stays in force behind it
    EXPECT_EQ(modal.moves.size(), plain.moves.size());
    // In a repeated part too; in a program that is called meanwhile it is a gap.
    const Toolpath repeated =
        pathOf(turningHead + "G0 X42 Z-5\nMCALL NUT\nAA: G0 Z-10\nBB: G0 Z-20\nREPEAT AA BB\nMCALL\nM30\n" + pocket,
               "sinumerik");
    ASSERT_TRUE(repeated.understanding.isWhole() && !repeated.has_errors);
    const std::string four = placesOf(repeated);
    EXPECT_EQ(std::count(four.begin(), four.end(), 'f'), 8);
    const Toolpath within =
        pathOf(turningHead + "G0 X42 Z-5\nMCALL NUT\nANDERE\nMCALL\nM30\n%_N_ANDERE_SPF\nG0 Z-10\nM17\n" + pocket,
               "sinumerik");
    EXPECT_FALSE(within.understanding.isWhole());
    EXPECT_EQ(within.understanding.first()->line, 11);
    const Toolpath missing = pathOf(turningHead + "MCALL CYCLE82(10,0,2,-5)\nZ-10\nM30\n", "sinumerik");
    EXPECT_FALSE(missing.understanding.isWhole());
}

TEST(CalledCycles, AProgramOfTheSameNameComesFirst)
{
    const Toolpath path = pathOf(turningHead + "CYCLE95(\"X\")\nM30\n%_N_CYCLE95_SPF\nG0 X77\nM17\n", "sinumerik");
    EXPECT_TRUE(path.understanding.isWhole());
    EXPECT_EQ(path.moves.back().x_mm, 38.5);
}

}  // namespace
}  // namespace lathelier::gcode
