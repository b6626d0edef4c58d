// What a word of an NC program can do, whatever its number or name is on one control. The tables of a control
// (control.h) lead from its words to these meanings; the interpreter knows the meanings only.
#pragma once

#include <cstdint>

namespace lathelier::gcode {

/// Function of a G word.
enum class G : std::uint8_t {
    Unknown,      ///< in no table
    NotModelled,  ///< known; its block yields no moves
    NoEffect,     ///< known; no effect on the path
    Rapid,
    Line,
    ArcCw,
    ArcCcw,
    ArcThrough,  ///< through an intermediate point
    Dwell,
    Thread,   ///< one move
    Inch,     ///< lengths only: feeds and cutting speeds stay metric
    InchAll,  ///< lengths, feeds and cutting speeds
    Metric,
    PlaneZX,
    PlaneOther,
    Home,        ///< by an intermediate point to the reference point
    FixedPoint,  ///< straight to a point of the machine
    MachineMove,
    NoseOff,
    NoseLeft,
    NoseRight,
    NoseLeftByWords,  ///< D states the diameter of the nose and L the place of its tip
    NoseRightByWords,
    SpeedLimit,   ///< with S; with coordinates as SetPosition
    SetPosition,  ///< the coordinates of the block become those of the present position
    CssOn,
    CssOff,
    PerMinute,
    PerRevolution,
    InverseTime,
    Absolute,
    Incremental,
    ArcAbsolute,     ///< I and K are coordinates
    ArcIncremental,  ///< I and K count from the start of the arc
    Diameter,
    Radius,
    CycleOff,
    Drill,             ///< in one go, or in pecks with Q
    DrillChipBreak,    ///< retracts a little instead of to the R level
    DrillFeedOut,      ///< returns at the feed
    Tap,               ///< a thread in and out
    DrillAcross,       ///< along X with a driven tool: known, not modelled
    ReturnToLevel,     ///< drilling ends at the R level instead of at the start
    TurnCycle,         ///< one pass along Z and back
    FaceCycle,         ///< one pass along X and back
    ThreadCycle,       ///< one pass of a thread and back
    Finish,            ///< the contour of P and Q once
    RoughTurn,         ///< the contour in passes along Z
    RoughFace,         ///< the contour in passes along X
    Pattern,           ///< the contour several times, shifted
    SubroutineFinish,  ///< as Finish, the contour that of the subroutine Q
    SubroutineTurn,    ///< as RoughTurn, likewise; .1: without pockets, .2: they alone
    SubroutineFace,    ///< as RoughFace, likewise
    FacePeck,          ///< grooves along Z
    TurnPeck,          ///< grooves along X
    ThreadMulti,       ///< a thread in passes: one block, or two, the first with P (mmrraa), Q and R
    DriveThread,       ///< a thread in passes: one block with P, I, J, K and a drive line
    WorkOffset,        ///< another work offset: the position becomes unknown
    WorkOffsetNamed,   ///< a work offset in which the program is taken to state its coordinates: the position is kept
    LocalShift,        ///< the zero by the words of the block, from that of the work offset
    SetData,  ///< L2 P1…: the work offset P; L20 P1…: so that the present position has these coordinates; others:
              ///< of tools, not modelled
    SetPositionOff,    ///< ends SetPosition, which is kept for SetPositionBack
    SetPositionClear,  ///< ends SetPosition for good
    SetPositionBack,   ///< after SetPositionOff
    Translate,         ///< the zero by the words of the block; without them: ends all frames
    TranslateCoarse,   ///< as Translate, for the axes of the block alone
    TranslateFine,     ///< in addition to TranslateCoarse
    MillOn,            ///< moves that follow are those of a driven tool: known, not modelled
    MillOff,
    MacroCall,
};

/// Function of an M word.
enum class M : std::uint8_t {
    Unknown,      ///< in no table
    NotModelled,  ///< known; with P or coordinates it runs what is not followed
    NoEffect,     ///< known or assigned by the machine builder; no effect on the path
    Spindle,      ///< turns the work: it is no longer held at an angle
    End,          ///< of the program
    EndOrReturn,  ///< of the program; in a called one: of that one
    CallProgram,  ///< P: its number; L: repeats
    CallBlock,    ///< P: the number of a block of the same program; L: repeats
    Return,       ///< from a called program, to the block P; in the main program: starts again
};

/// Use of a letter.
enum class Letter : std::uint8_t {
    Unknown,      ///< in no table
    NotModelled,  ///< known: an axis or a function that is not modelled
    InBlock,      ///< used by other words of its block: without one of them it has no use, which is reported
    Always,       ///< has a use by itself
};

/// Function of a word of several letters. Values follow "=" or stand in (…).
enum class Name : std::uint8_t {
    Unknown,     ///< in no table
    NoEffect,    ///< known; no effect on the path. Its value is computed, to find faults
    Uncomputed,  ///< as NoEffect; its value may be a text
    Translate,   ///< the zero by the words of the block, in place of all frames; without words: none
    TranslateMore,
    Rotate,  ///< by RotateAngle, in place of all frames; without: none
    RotateMore,
    Scale,  ///< by the words of the block, in place of all frames; without: none
    ScaleMore,
    Mirror,  ///< the axes of the block, in place of all frames; without: none
    MirrorMore,
    MillOn,  ///< moves that follow are those of a driven tool: known, not modelled
    MillOff,
    CallText,       ///< the program whose name follows in quotes
    CallModal,      ///< the program called in this block is called behind every block that moves; alone: ends that
    StockRemoval,   ///< called with its arguments: a contour in passes
    ThreadTurning,  ///< likewise: a thread in passes
    Grooving,       ///< likewise: a groove by a blade
    DiameterOn,
    DiameterOff,
    DiameterAbsolute,  ///< diameters for absolute coordinates, radii for incremental ones
    MachineMove,       ///< the coordinates of the block are those of the machine
    ArcThrough,
    AxisPoint,     ///< names an axis of a FixedPoint
    SpeedLimit,    ///< 1/min
    Speed,         ///< of the main spindle
    RotateAngle,   ///< degrees, from Z toward X
    ArcRadius,     ///< negative: more than half a circle
    ArcAngle,      ///< degrees
    ArcMiddleX,    ///< of ArcThrough
    ArcMiddleZ,    ///< of ArcThrough
    ChamferChord,  ///< length across the corner
    ChamferLeg,    ///< length along each leg
    Round,         ///< radius of a rounding
    RoundModal,    ///< radius of a rounding at every corner that follows
    EndAngle,      ///< direction of the line from +Z, degrees
};

/// Do these shape the end of their move?
constexpr bool shapesCorner(Name name)
{
    return name >= Name::ChamferChord && name <= Name::EndAngle;
}

/// Do these change the coordinates that follow?
constexpr bool isFrame(Name name)
{
    return name >= Name::Translate && name <= Name::MirrorMore;
}

/// Are these cycles that are called with their arguments?
constexpr bool isCalledCycle(Name name)
{
    return name >= Name::StockRemoval && name <= Name::Grooving;
}

constexpr bool isDrilling(G meaning)
{
    return meaning >= G::Drill && meaning <= G::DrillAcross;
}

}  // namespace lathelier::gcode
