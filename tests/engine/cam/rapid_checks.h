// What a program does at rapid: touches of the stock, with less tolerance than the check of a program has, and descents
// from which it returns without a cut.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/cam/job_bodies.h"
#include "engine/cam/plan.h"

namespace lathelier::cam {

inline constexpr double rapidTouch_mm = 0.005;  ///< chords of arcs and rounding stay below it

/// Rapid moves of the first clamping's program that touch the stock.
inline std::vector<stock::StockFinding> rapidTouches(const TurningPlan& plan)
{
    const SetupPlan& setup = plan.setups.front();
    stock::StockParameters bodies = stockParameters(setup.clamping.job);
    bodies.touch_mm = rapidTouch_mm;
    bodies.tailstock.reset();
    std::vector<stock::StockFinding> found =
        stock::simulateStock(stockOf(setup.clamping.job), setup.check.path.moves, bodies).findings;
    std::erase_if(found, [](const stock::StockFinding& finding) {
        return finding.kind != stock::FindingKind::RapidThroughStock;
    });
    return found;
}

/// Line of the first rapid move down that a rapid move up follows; 0: none.
inline std::int64_t emptyDipOf(const std::vector<gcode::Move>& moves)
{
    for (std::size_t i = 1; i + 1 < moves.size(); ++i) {
        const gcode::Move &before = moves[i - 1], &down = moves[i], &up = moves[i + 1];
        const bool are_rapid = down.kind == gcode::MoveKind::Rapid && up.kind == gcode::MoveKind::Rapid;
        if (are_rapid && before.tool == down.tool && down.x_mm < before.x_mm && up.x_mm > down.x_mm) return down.line;
    }
    return 0;
}

inline void expectQuietRapids(const TurningPlan& plan, const std::string& what)
{
    for (const stock::StockFinding& found : rapidTouches(plan))
        ADD_FAILURE() << what << " line " << found.line << " z " << found.z_mm << " " << found.depth_mm << "\n"
                      << plan.setups.front().text;
    for (const SetupPlan& setup : plan.setups)
        EXPECT_EQ(emptyDipOf(setup.check.path.moves), 0) << what << "\n" << setup.text;
}

}  // namespace lathelier::cam
