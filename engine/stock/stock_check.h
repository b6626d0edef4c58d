// What a program does to its stock, in the meridian plane: what each pass takes off, and where the tool meets what it
// must not meet.
//
// Moves are those of engine/gcode: end points of the imaginary tip in program coordinates; here z = z_zero - Z. The
// tool is its insert (turning_insert.h) and, where stated, its holder; stock is a set of columns (meridian_stock.h);
// chuck and tailstock are convex regions (machine_limits.h). Everything a convex outline covers on a straight move is
// the hull of its two placements; arcs become chords within 5 µm.
//
// - Rapid moves: insert and holder must not meet stock, chuck or tailstock. Two paths are tried: the straight line, and
//   the dog-leg of a control that moves each axis at its own rate until it arrives (G0 of Fanuc's and most others).
//   Where the move meets stock, that is taken off, so that one fault is found once.
// - Feed moves: in steps, each of which cuts first, then tests the holder, which trails. A thread is taken off down to
//   its root.
// - Moves to a reference point lead away from the work. A move from there, or from the start of a program, has no known
//   path: only its end is tested.
// Only the half plane of the tool counts: what a tool does beyond the axis changes nothing.
//
// Touching is no finding: an outline smaller by touch_mm has to meet the material. Chords, the corner's polygon and
// three decimals of a program stay below the default.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/core/shaft.h"
#include "engine/gcode/move.h"
#include "engine/stock/machine_limits.h"
#include "engine/stock/meridian_stock.h"
#include "engine/stock/stock_outline.h"
#include "engine/stock/turning_insert.h"

namespace lathelier::stock {

inline constexpr std::size_t mostOutlines = 400;  ///< kept; beyond, those of every second pass, third…

struct StockParameters {
    double z_zero_mm = 0;                    ///< z of the program's Z0: z = z_zero_mm - Z
    std::vector<TurningTool> tools;          ///< by number; a tool that is missing is one of number 0, or assumed
    std::optional<ChuckBody> chuck;          ///< none: not checked
    std::optional<TailstockBody> tailstock;  ///< none: not there
    std::size_t tailstock_from_move = 0;     ///< it stands there from this move on. No field: it follows the program
    bool dog_leg = true;                     ///< test the dog-leg of rapid moves too
    double rapid_x_m_min = 20;               ///< rate of the slide along x, on radius; only the ratio counts
    double rapid_z_m_min = 20;               ///< rate along z
    double step_mm = 0.02;                   ///< width of a column of stock
    double feed_step_mm = 1;                 ///< longest step of a feed move between two tests of the holder
    double touch_mm = 0.01;                  ///< what meets no deeper only touches
    std::size_t most_outlines =
        mostOutlines;  ///< kept after passes; 1: the last one alone. No field: nobody chooses it
    friend bool operator==(const StockParameters&, const StockParameters&) = default;
};

const std::vector<Field<StockParameters>>& fieldsOf(const StockParameters*);

enum class FindingKind : std::uint8_t { RapidThroughStock, HolderInStock, Chuck, Tailstock };

/// "rapid_through_stock", "holder_in_stock", "chuck", "tailstock".
const char* key(FindingKind kind);
Text nameOf(FindingKind kind);

/// Which path of a rapid move meets something. Feed moves have but the programmed one.
enum class MovePath : std::uint8_t { Programmed, Straight, DogLeg, Both };

/// "programmed", "straight", "dog_leg", "both".
const char* key(MovePath path);
Text nameOf(MovePath path);

/// Something that a program must not do, at its deepest place. One for each move and kind.
struct StockFinding {
    std::int64_t line = 0;                              ///< block that caused the move
    FindingKind kind = FindingKind::RapidThroughStock;  ///< what was met
    MovePath path = MovePath::Programmed;               ///< on which path
    double z_mm = 0;      ///< stock: of the column with the largest depth; else of the deepest corner of the overlap
    double x_mm = 0;      ///< radius: how near to the axis the tool comes there
    double depth_mm = 0;  ///< stock: radial; chuck and tailstock: the smaller of both extents of the overlap
    double width_mm = 0;  ///< extent of the overlap along z
    friend bool operator==(const StockFinding&, const StockFinding&) = default;
};

/// An unbroken run of feed moves of one tool that took material off.
struct StockPass {
    std::int64_t line = 0;   ///< of its first block that cut
    int tool = 0;            ///< number
    double removed_mm3 = 0;  ///< volume of revolution
    StockOutline after;      ///< the stock when it ends; empty: not kept
    bool is_kept = false;    ///< `after` is there
};

struct StockResult {
    StockParameters parameters;            ///< as asked
    double step_mm = 0;                    ///< width of a column, as used
    double length_mm = 0;                  ///< of the stock
    double volume_before_mm3 = 0;          ///< of the stock
    double removed_mm3 = 0;                ///< by all passes
    double removed_by_findings_mm3 = 0;    ///< by rapid moves and holders that met stock
    StockOutline before;                   ///< the stock at first
    std::vector<StockPass> passes;         ///< in order
    std::vector<StockFinding> findings;    ///< in order of the moves
    std::int64_t findings_not_listed = 0;  ///< beyond mostFindings
    MeridianStock left;                    ///< the stock at the end
    Notes notes;
};

inline constexpr std::size_t mostFindings = 1000;
inline constexpr double outlineTolerance_mm = 0.005;  ///< of what is kept
inline constexpr double smallClearance_mm = 0.1;      ///< a rapid move that passes nearer is noted
inline constexpr double airCut_mm = 2;                ///< a feed move above the stock that is longer is noted

/// As below, of stock that an earlier program left; its columns are as wide as they are.
StockResult simulateStock(MeridianStock stock, std::span<const gcode::Move> moves,
                          const StockParameters& parameters = {}, const Progress& progress = {});

/// Errors of MeridianStock and outlineOf(). Columns and steps are widened until the work is bounded (note
/// stockStepWidened): 1e5 moves take a few seconds. Throws Cancelled.
StockResult simulateStock(const Shaft& stock, std::span<const gcode::Move> moves,
                          const StockParameters& parameters = {}, const Progress& progress = {});

}  // namespace lathelier::stock
