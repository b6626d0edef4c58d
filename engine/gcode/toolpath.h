// An NC program interpreted to canonical moves.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/core/tool.h"
#include "engine/gcode/move.h"
#include "engine/gcode/program.h"

namespace lathelier::gcode {

/// Tool::tip by the orientation of a tool as tool tables and G41.1 L of LinuxCNC count it, 0 to 9.
inline constexpr std::array tipOfOrientation{9, 4, 3, 2, 1, 5, 8, 7, 6, 9};

/// Limits of interpretation; exceeding one gives an error diagnostic at the block.
inline constexpr std::int64_t mostLoops = 500000;       ///< sum of repetitions, backward jumps and calls
inline constexpr std::int64_t mostBlocksRun = 2500000;  ///< default of ToolpathParameters
inline constexpr std::size_t mostMoves = 4000000;       ///< of a program
inline constexpr std::int64_t mostPasses = 10000;       ///< of one cycle
inline constexpr double farthest_mm = 1e5;              ///< of a coordinate
inline constexpr std::size_t mostMissing = 1000;        ///< programs that are listed as missing
inline constexpr int deepestCalls = 32;                 ///< nesting depth of subprograms and loops

enum class IntegerWords { Millimetre, Micrometre };

struct ToolpathParameters {
    std::string dialect = automaticControl;                 ///< key of the control
    std::optional<double> nose_radius_mm;                   ///< of every tool
    int tip = 3;                                            ///< of every tool, with nose_radius_mm
    IntegerWords integer_words = IntegerWords::Millimetre;  ///< meaning of X50 for Fanuc and Haas: 50 mm or 50 µm
    double arc_tolerance_um = 10;                           ///< an arc may end so far off its circle, with a note
    std::int64_t most_blocks_run = mostBlocksRun;           ///< in addition to one run per block; not a user parameter
    std::string subprograms;  ///< folder of programs that are called and not in the file; empty: none
    std::shared_ptr<const std::vector<ProgramPart>> parts;  ///< that were found there; not a user parameter
    std::string file_name;  ///< of the program: one of what tells its control; not a user parameter
    ControlPtr control;     ///< read with this one, which may be in no list, instead; not a user parameter
};

const std::vector<Field<ToolpathParameters>>& fieldsOf(const ToolpathParameters*);

/// Those of the parameters; none where there are none.
const std::vector<ProgramPart>& partsOf(const ToolpathParameters& parameters);

/// The control to read a program with; nullptr: from the text.
ControlPtr controlOf(const ToolpathParameters& parameters);

/// By tool number. Compensation reads corner_radius_mm and tip.
using ToolTable = std::map<int, Tool>;

/// Modal state when a block was executed, for changes of the program.
struct BlockState {
    bool is_diameter = true;          ///< X counts diameters
    bool is_incremental = false;      ///< X counts from the last position (G91); U always does
    bool is_inch = false;             ///< numbers are inches
    bool is_compensated = false;      ///< G41 or G42 was active
    bool is_contour = false;          ///< part of the contour of G70…G73
    bool is_cycle = false;            ///< its moves are those of a cycle
    bool is_shaped = false;           ///< a chamfer or a rounding shapes its end, as a word or modal
    bool arc_is_absolute = false;     ///< I and K are coordinates
    std::uint32_t runs = 0;           ///< number of executions
    MoveKind kind = MoveKind::Rapid;  ///< of its last move, as programmed
    Point start;                      ///< programmed position before it (radius)
    Point end;                        ///< programmed position after it
    Point shift;  ///< added to what the program states, in coordinates of the work; NaN: more than a shift
};

struct Toolpath {
    std::vector<Move> moves;              ///< in order of execution
    std::vector<BlockState> blocks;       ///< for each block of the program
    std::vector<Diagnostic> diagnostics;  ///< of parsing and interpretation, by position
    std::int64_t words = 0;
    std::int64_t words_understood = 0;
    std::vector<std::string> missing;  ///< programs that are called and not there, each once, at most mostMissing
    Understanding understanding;       ///< what is not modelled and what is assumed; paths are left to the caller
    bool has_errors = false;           ///< a diagnostic is an error: the moves are invalid
    ToolpathParameters parameters;
};

/// Interprets the program. Unsupported or impossible blocks are reported as diagnostics, not as exceptions. Clears
/// is_understood of words found to be unsupported. Throws Cancelled. Cost: about 0.5 µs a block.
Toolpath findToolpath(Program& program, const ToolpathParameters& parameters = {}, const ToolTable& tools = {},
                      const Progress& progress = {});

}  // namespace lathelier::gcode
