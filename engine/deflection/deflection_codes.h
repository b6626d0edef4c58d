// Errors and notes of deflection: codes with their English patterns. {name} is replaced by the named value; text() puts
// path, line, column and byte in front, so patterns do not repeat them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode stockTooShort{
    "stock_too_short", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The cut runs to z = {z_mm} mm; the stock ends at the chuck face, z = {length_mm} mm.")};

inline constexpr ErrorCode nothingLeft{
    "nothing_left", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "At z = {z_mm} mm a radius of {radius_mm} mm would be left; expected more than {least_mm} mm.")};

inline constexpr ErrorCode noCut{"no_cut", ErrorKind::NoAnswer,
                                 LT_TEXT("Engine",
                                         "No feed move toward the chuck leaves a diameter: none meets the stock, or "
                                         "cuts toward the free end took it off again.")};

inline constexpr ErrorCode notHeld{
    "not_held", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "Nothing holds the work: chuck, tailstock and rests together leave it free to move.")};

inline constexpr ErrorCode tooManySteps{
    "too_many_steps", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "{found} steps along z would be needed; at most {maximum} are taken. Choose a longer step.")};

inline constexpr ErrorCode workGivesWay{
    "work_gives_way", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "At z = {z_mm} mm the work is pushed away by {deflection_mm} mm: more than its radius, or beyond what a "
            "linear beam means.")};

inline constexpr ErrorCode correctionTooLarge{
    "correction_too_large", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "At z = {z_mm} mm the correction would be {correction_um} µm on diameter; at most {maximum_um} µm are "
            "allowed.")};

inline constexpr ErrorCode cannotBeWritten{
    "cannot_be_written", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "Blocks on a grid of {grid_um} µm leave {residual_um} µm on diameter; asked are {tolerance_um} µm.")};

inline constexpr ErrorCode writtenRunsDiffer{
    "written_runs_differ", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The corrected program makes {found} cuts through the stock, the original {expected}.")};

inline constexpr ErrorCode passInOtherFile{
    "pass_in_other_file", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "This block is in a file of its own, and a correction changes the program alone. Put it into the program "
            "that calls it.")};

inline constexpr ErrorCode stockMissing{"stock_missing", ErrorKind::InputRejected,
                                        LT_TEXT("Engine", "The set-up names no stock. State a stock file.")};

inline constexpr ErrorCode tooFewMeasured{
    "too_few_measured", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "{found} measured diameters do not determine {parameters} unknowns.")};

inline constexpr ErrorCode measuredOutsideCut{
    "measured_outside_cut", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "The diameter measured at z = {z_mm} mm lies where nothing is cut; expected {from_mm} to {to_mm} mm.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode belowScallop{
    "below_scallop", Severity::Warning,
    LT_TEXT(
        "Engine",
        "Line {line}, from z = {z_mm} mm: the depth of cut is no more than the scallop of {scallop_um} µm; no force "
        "is taken there, though the edge rubs.")};

inline constexpr NoteCode towardFreeEnd{
    "cut_toward_free_end", Severity::Warning,
    LT_TEXT(
        "Engine",
        "Line {line}: a cut toward the free end is not predicted; its material is removed, and what it leaves is not "
        "judged.")};

inline constexpr NoteCode plungeNotModelled{
    "plunge_not_modelled", Severity::Warning,
    LT_TEXT("Engine", "Line {line}: the tool plunges at z = {z_mm} mm; neither force nor groove of that is modelled.")};

inline constexpr NoteCode slopeInRadialModel{
    "slope_in_radial_model", Severity::Warning,
    LT_TEXT("Engine",
            "Line {line}: the contour slopes by {slope_deg}°; depths are radial and the entering angle is that to the "
            "axis. Choose depths normal to the contour for slopes.")};

inline constexpr NoteCode slopeTooSteep{
    "slope_too_steep", Severity::Warning,
    LT_TEXT("Engine",
            "Line {line}: a slope of {slope_deg}° is steeper than the edge can follow; taken as {used_deg}°.")};

inline constexpr NoteCode springsBesideDiameter{
    "springs_beside_diameter", Severity::Info,
    LT_TEXT("Engine", "Axial and torsional stiffness are read; they never change a diameter.")};

inline constexpr NoteCode largeDeflection{
    "large_deflection", Severity::Warning,
    LT_TEXT(
        "Engine",
        "The work is pushed away by up to {deflection_mm} mm, at z = {z_mm} mm: chatter or lifting will come first.")};

inline constexpr NoteCode threadNotPredicted{
    "thread_not_predicted", Severity::Warning,
    LT_TEXT("Engine", "Line {line}: the passes of a thread are neither predicted nor corrected.")};

inline constexpr NoteCode facingNotPredicted{
    "facing_not_predicted", Severity::Info,
    LT_TEXT("Engine",
            "Line {line}: a cut along x alone down to the axis leaves no diameter; it is neither predicted nor "
            "corrected.")};

inline constexpr NoteCode severalTools{
    "several_tools", Severity::Warning,
    LT_TEXT("Engine", "The program cuts with {count} tools; the forces are those of the one tool in the set-up.")};

inline constexpr NoteCode spindleSpeedUnknown{
    "spindle_speed_unknown", Severity::Warning,
    LT_TEXT("Engine",
            "Line {line}: a feed per minute without a spindle speed says no feed per revolution; such a cut cannot be "
            "predicted.")};

inline constexpr NoteCode toolMeets{
    "tool_meets", Severity::Warning,
    LT_TEXT("Engine", "The tool meets what it must not meet, first in line {line}. Such moves: {count}.")};

inline constexpr NoteCode correctedMeets{
    "corrected_program_meets", Severity::Warning,
    LT_TEXT("Engine", "The corrected program meets what it must not meet, first in line {line}. Such moves: {count}.")};

inline constexpr NoteCode spindleHasNoSprings{
    "spindle_has_no_springs", Severity::Warning,
    LT_TEXT("Engine", "The spindle is a table of receptances; the chuck stays that of the set-up.")};

inline constexpr NoteCode materialOfSetup{
    "material_of_setup", Severity::Warning,
    LT_TEXT(
        "Engine",
        "The stock states {stock_MPa} MPa for its elastic modulus, the set-up {setup_MPa} MPa; that of the set-up is "
        "used.")};

inline constexpr NoteCode materialOfShaft{
    "material_of_shaft", Severity::Info,
    LT_TEXT("Engine",
            "The elastic modulus is that of the project's shaft, {modulus_MPa} MPa, as in the question Machine; the "
            "cutting coefficients stay those of the set-up.")};

inline constexpr NoteCode insertOfLibrary{
    "insert_of_library", Severity::Info,
    LT_TEXT(
        "Engine",
        "The geometry of the insert {insert} is taken from the library (source: {source}); the cutting coefficients "
        "stay those of the set-up.")};

inline constexpr NoteCode tooFewForStiffness{
    "too_few_for_stiffness", Severity::Info,
    LT_TEXT("Engine", "{found} measured diameters do not determine {expected} unknown stiffnesses; none was sought.")};

inline constexpr NoteCode boreNotPredicted{
    "bore_not_predicted", Severity::Warning,
    LT_TEXT("Engine",
            "Line {line}: a pass in a bore is neither predicted nor corrected; its material stays, and nothing is said "
            "of its diameter."),
    NoteRole::NotModelled};

inline constexpr NoteCode skippedBlocksRun{
    "skipped_blocks_run", Severity::Warning,
    LT_TEXT("Engine",
            "Blocks behind “/”, first in line {line}, are taken as run. Where they are skipped, later passes are "
            "deeper than those that were corrected.")};

inline constexpr NoteCode correctionCutsDeeper{
    "correction_cuts_deeper", Severity::Info,
    LT_TEXT("Engine", "The corrected contour is up to {correction_um} µm on diameter smaller than programmed.")};

inline constexpr NoteCode residualAboveTolerance{
    "residual_above_tolerance", Severity::Warning,
    LT_TEXT("Engine", "The written program leaves {residual_um} µm on diameter; asked are {tolerance_um} µm.")};

inline constexpr NoteCode poorlyDetermined{
    "poorly_determined", Severity::Warning,
    LT_TEXT(
        "Engine",
        "The measured diameters hardly determine {parameter}: its standard uncertainty is {uncertainty_percent} %.")};

inline constexpr NoteCode atItsLimit{
    "at_its_limit", Severity::Warning,
    LT_TEXT("Engine", "{parameter} ran to the end of its range at {value} times its start: it may have no influence.")};

inline constexpr NoteCode feedCannotHold{
    "feed_cannot_hold", Severity::Warning,
    LT_TEXT("Engine",
            "From z = {z_mm} mm the tolerance of {tolerance_um} µm cannot be held by the feed alone, not even at "
            "{feed_mm_rev} mm per revolution.")};

}  // namespace notes

}  // namespace lathelier
