// Stock removal along a contour in sections (CYCLE95): paraxial passes down to the contour and its allowances, pockets
// behind them, then once along the contour. Internal to the room.
//
// Source: SINUMERIK 840D/840Di/810D Programming Guide, Cycles (11.02), 4.7. The passes of a section share its depth
// evenly and are none deeper than stated: first the front, as if its pockets were filled, then each pocket, likewise.
// Each pass follows the contour up to the level of the pass before, so no corners remain. What the guide leaves open
// and does not cut (order of the axes on the way in and out) is chosen so that no rapid move enters what remains.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/gcode/level_contour.h"

namespace lathelier::gcode {

/// Lengths in mm, on radius.
struct StockRemoval {
    bool is_face = false;           ///< passes along X, depth along Z
    bool is_outward = false;        ///< the depth grows in the positive direction of its axis: a bore
    bool roughs = true;             ///< passes down to the allowances
    bool finishes = false;          ///< once along the contour; without roughs in its own direction
    double depth_mm = 0;            ///< of a pass, at most
    double allowance_depth_mm = 0;  ///< along the depth axis
    double allowance_feed_mm = 0;   ///< along the feed axis, on both flanks of a pocket
    double retreat_mm = 1;          ///< in both axes
    double chip_mm = 0;             ///< length of cut between two dwells; 0: no dwells
    double dwell_s = 0;             ///< dwell that breaks the chip
    double feed_rough = notANumber, feed_enter = notANumber, feed_finish = notANumber;  ///< NaN: as modal
    double nose_radius_mm = 0;  ///< 0: the moves are the contour itself
    int nose_tip = 3;           ///< Fanuc's number
};

/// Why there are no moves.
enum class StockRemovalProblem : std::uint8_t {
    None,
    Overhang,   ///< the contour turns back along the feed axis
    Allowance,  ///< a pocket is narrower than its allowances, or they meet nowhere
    NoseFit,    ///< the nose does not fit into a corner
    Passes,     ///< more than `most_passes`
    Nesting,    ///< pockets within pockets, deeper than deepestPockets
};

struct StockRemovalMoves {
    CycleMoves moves;
    StockRemovalProblem problem = StockRemovalProblem::None;
    double passes = 0;  ///< that it asks for
};

/// The first piece of the contour leads to its start. Ends at the start of the cycle: retreat and allowance beside the
/// largest place of the contour and in front of its deep end.
StockRemovalMoves stockRemoval(const std::vector<ContourPiece>& contour, const StockRemoval& cut,
                               std::int64_t most_passes);

/// Does a piece run along neither axis?
bool hasSlopes(const std::vector<ContourPiece>& contour);

}  // namespace lathelier::gcode
