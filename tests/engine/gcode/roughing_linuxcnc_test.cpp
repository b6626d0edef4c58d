// G70 and G71 of LinuxCNC over contours whose moves are worked out by hand.
#include "engine/gcode/roughing_linuxcnc.h"

#include <gtest/gtest.h>

#include <vector>

namespace lathelier::gcode {
namespace {

/// Radii 10 to Z-10, then a cone 4 in X and 3 in Z: its normal is (0.6, 0.8).
std::vector<Piece> cylinderAndCone()
{
    const Point start{16, 5}, first{10, 1}, corner{10, -10}, last{14, -13};
    return {{start, first, {}, false}, {first, corner, {}, false}, {corner, last, {}, false}};
}

struct Expected {
    MoveKind kind;
    double x;
    double z;
};

void expectMoves(const CycleMoves& moves, const std::vector<Expected>& expected)
{
    ASSERT_EQ(moves.size(), expected.size());
    for (std::size_t i = 0; i < moves.size(); ++i) {
        EXPECT_EQ(moves[i].kind, expected[i].kind) << i;
        EXPECT_NEAR(moves[i].to.x_mm, expected[i].x, 1e-9) << i;
        EXPECT_NEAR(moves[i].to.z_mm, expected[i].z, 1e-9) << i;
    }
}

constexpr MoveKind rapid = MoveKind::Rapid, feed = MoveKind::Feed;

TEST(RoughingLinuxCnc, TurnsInPassesDownToTheContour)
{
    SubroutineCycle cycle;
    cycle.start = {16, 5};
    cycle.distance = 0.5;
    cycle.depth = 3;
    cycle.retreat = 1;
    const SubroutineCycleMoves made = subroutineCycle(cycle, cylinderAndCone());
    ASSERT_TRUE(made.is_modelled);
    // The cone at 0.5 runs from (10.3, -9.6) to (14.3, -12.6) and meets the cylinder at radius 10.5 at Z-9.75. Passes
    // begin on the line from the start to (10.5, 1).
    const double entry = 5 - 4 * 3 / 5.5;
    expectMoves(made.moves, {{rapid, 16, 5},
                             {rapid, 16, 5},
                             {rapid, 16, 5},
                             {feed, 16, -12.6},
                             {rapid, 17, -11.6},
                             {rapid, 17, 4},
                             {rapid, 16, 5},
                             {rapid, 13, entry},
                             {feed, 13, -11.625},
                             {rapid, 14, -10.625},
                             {rapid, 14, entry - 1},
                             {rapid, 13, entry},
                             {rapid, 10.5, 1},
                             {feed, 10.5, -9.75},
                             {feed, 14.3, -12.6},
                             {feed, 16, -12.6}});
}

TEST(RoughingLinuxCnc, FinishesFromTheFirstDistanceToTheLast)
{
    SubroutineCycle cycle;
    cycle.kind = SubroutineCycle::Kind::Finish;
    cycle.start = {16, 5};
    cycle.distance = 0.5;
    cycle.passes = 2;
    const SubroutineCycleMoves made = subroutineCycle(cycle, cylinderAndCone());
    ASSERT_TRUE(made.is_modelled);
    expectMoves(made.moves, {{rapid, 16, 5},
                             {rapid, 16, 5},
                             {rapid, 10.25, 1},
                             {feed, 10.25, -9.875},
                             {feed, 14.15, -12.8},
                             {rapid, 16, 5},
                             {rapid, 10, 1},
                             {feed, 10, -10},
                             {feed, 14, -13}});
}

TEST(RoughingLinuxCnc, PocketsAreLeftOpen)
{
    std::vector<Piece> contour = cylinderAndCone();
    contour.push_back({{14, -13}, {12, -15}, {}, false});
    SubroutineCycle cycle;
    cycle.start = {16, 5};
    const SubroutineCycleMoves made = subroutineCycle(cycle, contour);
    EXPECT_FALSE(made.is_modelled);
    EXPECT_FALSE(made.refused);
    EXPECT_TRUE(made.moves.empty());
}

TEST(RoughingLinuxCnc, RefusesAContourThatReturns)
{
    std::vector<Piece> contour = cylinderAndCone();
    contour.push_back({{14, -13}, {15, -11}, {}, false});
    SubroutineCycle cycle;
    cycle.start = {16, 5};
    const SubroutineCycleMoves made = subroutineCycle(cycle, contour);
    EXPECT_TRUE(made.refused);
    EXPECT_TRUE(made.moves.empty());
}

}  // namespace
}  // namespace lathelier::gcode
