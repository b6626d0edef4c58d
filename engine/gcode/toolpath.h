// An NC program as canonical moves: what the control would do with it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/gcode/move.h"
#include "engine/gcode/program.h"

namespace lathelier::gcode {

/// The rounded nose of a tool, and where the imaginary tip lies that a program moves.
struct Nose {
    double radius_mm = 0;  ///< of the nose
    int tip =
        3;  ///< Fanuc's number: 3 towards -X -Z, 2 +X -Z, 1 +X +Z, 4 -X +Z, 5 +Z, 6 +X, 7 -Z, 8 -X, 9 and 0 centre
};

/// Limits of a run; beyond them the answer is an error diagnostic at the block.
inline constexpr std::int64_t mostLoops = 500000;       ///< repetitions, backward jumps and calls together
inline constexpr std::int64_t mostBlocksRun = 2500000;  ///< default of ToolpathParameters
inline constexpr std::size_t mostMoves = 4000000;       ///< of a program
inline constexpr int deepestCalls = 32;                 ///< subprograms and loops within each other

enum class IntegerWords { Millimetre, Micrometre };

struct ToolpathParameters {
    Dialect dialect = Dialect::Auto;                        ///< of the program
    std::optional<double> nose_radius_mm;                   ///< of every tool
    int tip = 3;                                            ///< of every tool, with nose_radius_mm
    IntegerWords integer_words = IntegerWords::Millimetre;  ///< what X50 means to Fanuc and Haas: 50 mm or 50 µm
    std::int64_t most_blocks_run = mostBlocksRun;           ///< besides each block once; no field: nobody chooses it
};

const std::vector<Field<ToolpathParameters>>& fieldsOf(const ToolpathParameters*);

/// By number of the tool, as a tool table has them.
using Noses = std::map<int, Nose>;

/// What a program was when one of its blocks was run, for those that change it.
struct BlockState {
    bool is_diameter = true;          ///< X counts diameters
    bool is_incremental = false;      ///< X counts from the last position (G91); U always does
    bool is_inch = false;             ///< numbers are inches
    bool is_compensated = false;      ///< G41 or G42 was active
    bool is_contour = false;          ///< belongs to the contour of G70…G73
    bool is_cycle = false;            ///< a cycle made the moves
    std::uint32_t runs = 0;           ///< how many times it was run; more than once in a subprogram or loop
    MoveKind kind = MoveKind::Rapid;  ///< of its last move, as programmed
    Point start;                      ///< where the tool stood before it, as programmed (radius)
    Point end;                        ///< where it stood afterwards
};

struct Toolpath {
    std::vector<Move> moves;              ///< in order of execution
    std::vector<BlockState> blocks;       ///< for each block of the program
    std::vector<Diagnostic> diagnostics;  ///< of reading and running, by place
    std::int64_t words = 0;               ///< of the program
    std::int64_t words_understood = 0;    ///< of them
    bool has_errors = false;              ///< a diagnostic is an error: the moves are not to be trusted
    ToolpathParameters parameters;        ///< that were used
};

/// Runs the program. Whatever it does not understand or cannot do is in the diagnostics; never throws for that.
/// Marks words of `program` that turn out not to be understood. Throws Cancelled. Cost: about 0.5 µs a block.
Toolpath findToolpath(Program& program, const ToolpathParameters& parameters = {}, const Noses& noses = {},
                      const Progress& progress = {});

}  // namespace lathelier::gcode
