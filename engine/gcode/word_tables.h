// Words of the dialects, and which of them are modelled.
#pragma once

#include <cstdint>

#include "engine/gcode/program.h"

namespace lathelier::gcode {

/// Function of a G word, independent of its number in the dialect.
enum class G : std::uint8_t {
    Unknown,
    NotModelled,  ///< known; its block yields no moves
    NoEffect,     ///< known; no effect on the path
    Rapid,
    Line,
    ArcCw,
    ArcCcw,
    ArcThrough,  ///< CIP: through an intermediate point
    Dwell,
    Thread,  ///< one move (G32, G33)
    Inch,
    Metric,
    InchAll,  ///< Sinumerik G700: feed too
    MetricAll,
    PlaneZX,
    PlaneOther,
    Home,         ///< G28, G30 by an intermediate point
    FixedPoint,   ///< Sinumerik G74, G75: straight there
    MachineMove,  ///< G53, SUPA
    NoseOff,
    NoseLeft,
    NoseRight,
    SpeedLimit,  ///< G50 S, also coordinates: G50 X Z
    CssOn,
    CssOff,
    PerMinute,
    PerRevolution,
    InverseTime,
    Absolute,
    Incremental,
    ArcAbsolute,     ///< LinuxCNC G90.1
    ArcIncremental,  ///< LinuxCNC G91.1
    Diameter,        ///< LinuxCNC G7
    Radius,          ///< LinuxCNC G8
    CycleOff,        ///< G80
    Drill,           ///< G81…G89
    TurnCycle,       ///< G90
    FaceCycle,       ///< G94
    ThreadCycle,     ///< G92
    Finish,          ///< G70
    RoughTurn,       ///< G71
    RoughFace,       ///< G72
    Pattern,         ///< G73
    FacePeck,        ///< G74
    TurnPeck,        ///< G75
    ThreadMulti,     ///< G76
    WorkOffset,      ///< G54…
    Shift,           ///< G52, TRANS…: by words of the block
    MacroCall,       ///< G65
};

/// `code10`: ten times the number (G91.1 is 911).
G meaningOf(Dialect dialect, int code10);

/// M words known to the dialect.
bool isKnownM(Dialect dialect, int number);

/// Marks unknown and unmodelled words of a block and adds a diagnostic for each.
void classifyWords(Program& program, Block& block);

}  // namespace lathelier::gcode
