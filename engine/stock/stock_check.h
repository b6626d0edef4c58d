// Simulation of stock removal in the meridian plane: material removed by each pass, and collisions of the tool.
//
// Moves are those of engine/gcode: end points of the imaginary tip in program coordinates; here z = z_zero - Z. The
// tool is its insert (tool_outline.h) and, where stated, its holder; stock is a set of columns (meridian_stock.h);
// chuck and tailstock are convex regions (machine_limits.h). Everything a convex outline covers on a straight move is
// the hull of its two placements; arcs become chords within 5 µm.
//
// - Rapid moves: insert and holder must not collide with stock, chuck or tailstock. Two paths are tested: the straight
// line, and
//   the dog-leg of a control that moves each axis at its own rate until it arrives (G0 of Fanuc's and most others).
//   Stock in collision is removed, so that one fault gives one finding.
// - Feed moves: in steps, each of which first cuts, then tests the trailing holder. A thread is removed down to its
// root.
// - Moves to a reference point lead away from the work. The path of a move from there, or from the start of a program,
// is unknown: only its end is tested. Only the half plane of the tool is simulated; the tool has no effect beyond the
// axis.
//
// Contact is no finding: outlines reduced by touch_mm must overlap the material. The errors of chords, corner polygon
// and three decimals are below the default.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/gcode/move.h"
#include "engine/shaft/shaft.h"
#include "engine/stock/machine_limits.h"
#include "engine/stock/meridian_stock.h"
#include "engine/stock/stock_outline.h"
#include "engine/stock/tool_outline.h"

namespace lathelier::stock {

inline constexpr std::size_t mostOutlines = 400;  ///< stored outlines; with more passes, every second or third…

struct StockParameters {
    double z_zero_mm = 0;     ///< z of the program's Z0: z = z_zero_mm - Z
    std::vector<Tool> tools;  ///< by number; a tool that is missing is one of number 0, or assumed
    std::optional<ChuckBody> chuck;
    std::optional<TailstockBody> tailstock;
    std::size_t tailstock_from_move =
        0;  ///< index of the first move with engaged tailstock; derived from the program, not a user parameter
    bool dog_leg = true;        ///< test the dog-leg of rapid moves too
    double rapid_x_m_min = 20;  ///< rate of the slide along x, on radius; only the ratio counts
    double rapid_z_m_min = 20;
    double step_mm = 0.02;                     ///< width of a column of stock
    double feed_step_mm = 1;                   ///< longest step of a feed move between two tests of the holder
    double touch_mm = 0.01;                    ///< smaller overlaps count as contact
    std::size_t most_outlines = mostOutlines;  ///< stored outlines; 1: only the last. Not a user parameter
    friend bool operator==(const StockParameters&, const StockParameters&) = default;
};

const std::vector<Field<StockParameters>>& fieldsOf(const StockParameters*);

enum class FindingKind : std::uint8_t { RapidThroughStock, HolderInStock, Chuck, Tailstock };

/// "rapid_through_stock", "holder_in_stock", "chuck", "tailstock".
const char* key(FindingKind kind);
Text nameOf(FindingKind kind);

/// Path of a rapid move that collides. Feed moves have only the programmed one.
enum class MovePath : std::uint8_t { Programmed, Straight, DogLeg, Both };

/// "programmed", "straight", "dog_leg", "both".
const char* key(MovePath path);
Text nameOf(MovePath path);

/// A collision at its point of largest depth. One per move and kind.
struct StockFinding {
    std::int64_t line = 0;  ///< block that caused the move
    FindingKind kind = FindingKind::RapidThroughStock;
    MovePath path = MovePath::Programmed;
    double z_mm = 0;      ///< stock: of the column with the largest depth; else of the deepest corner of the overlap
    double x_mm = 0;      ///< smallest radius of the tool there
    double depth_mm = 0;  ///< stock: radial; chuck and tailstock: the smaller of both extents of the overlap
    double width_mm = 0;  ///< extent of the overlap along z
    friend bool operator==(const StockFinding&, const StockFinding&) = default;
};

/// A connected sequence of feed moves of one tool that removed material.
struct StockPass {
    std::int64_t line = 0;  ///< its first block that cuts
    int tool = 0;
    double removed_mm3 = 0;  ///< volume of revolution
    StockOutline after;      ///< outline of the stock after it; empty: not stored
    bool is_kept = false;    ///< `after` is stored
};

struct StockResult {
    StockParameters parameters;
    double step_mm = 0;            ///< width of a column, as used
    double length_mm = 0;          ///< of the stock
    double volume_before_mm3 = 0;  ///< of the stock
    double removed_mm3 = 0;
    double removed_by_findings_mm3 = 0;  ///< by colliding rapid moves and holders
    StockOutline before;                 ///< outline of the stock before the first move
    std::vector<StockPass> passes;
    std::vector<StockFinding> findings;    ///< in order of the moves
    std::int64_t findings_not_listed = 0;  ///< beyond mostFindings
    MeridianStock left;                    ///< the stock at the end
    Notes notes;
};

inline constexpr std::size_t mostFindings = 1000;
inline constexpr double outlineTolerance_mm = 0.005;  ///< tolerance of stored outlines
inline constexpr double smallClearance_mm = 0.1;      ///< rapid moves with smaller clearance are noted
inline constexpr double airCut_mm = 2;                ///< longer feed moves without removal are noted

/// As below, for stock left by an earlier program; its column width is kept.
StockResult simulateStock(MeridianStock stock, std::span<const gcode::Move> moves,
                          const StockParameters& parameters = {}, const Progress& progress = {});

/// Errors of MeridianStock and outlineOf(). Columns and steps are widened until the work is bounded (note
/// stockStepWidened): 1e5 moves take a few seconds. Throws Cancelled.
StockResult simulateStock(const Shaft& stock, std::span<const gcode::Move> moves,
                          const StockParameters& parameters = {}, const Progress& progress = {});

}  // namespace lathelier::stock
