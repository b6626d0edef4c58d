// What registration and comparison refuse or remark: codes with their English patterns. {name} is replaced by the named
// value; text() puts path, line, column and byte in front, so patterns do not repeat them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode partsDoNotMatch{
    "parts_do_not_match", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The two parts do not match: only {overlap_percent} % of the copy lies near the reference.")};

inline constexpr ErrorCode notABodyOfRevolution{
    "not_a_body_of_revolution", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The {role} is not a body of revolution: {why} (residual {residual_mm} mm).")};

inline constexpr ErrorCode coverageTooSmall{
    "coverage_too_small", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "The {role} shows {coverage_deg}° of the circle; at least {minimum_deg}° are needed for an axis.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode rollNotDetermined{
    "roll_not_determined", Severity::Info,
    LT_TEXT("Engine", "Roll about the axis is not determined by the geometry; the smallest rotation was kept.")};

inline constexpr NoteCode motionNotDetermined{
    "motion_not_determined", Severity::Warning,
    LT_TEXT("Engine", "A {kind} is not determined by the geometry; the initial pose was kept along it.")};

inline constexpr NoteCode motionWeak{"motion_weak", Severity::Warning,
                                     LT_TEXT("Engine", "A {kind} is only weakly determined by the geometry.")};

inline constexpr NoteCode severalPosesFit{
    "several_poses_fit", Severity::Warning,
    LT_TEXT("Engine", "{count} poses fit equally well; the one with the smallest rotation was chosen.")};

inline constexpr NoteCode methodChosen{"method_chosen", Severity::Info,
                                       LT_TEXT("Engine", "Method chosen: {method} ({reason}).")};

inline constexpr NoteCode endForEnd{"end_for_end", Severity::Info,
                                    LT_TEXT("Engine", "The copy was turned end for end.")};

inline constexpr NoteCode outliersExcluded{
    "outliers_excluded", Severity::Info,
    LT_TEXT("Engine", "Points further than {distance_mm} mm from the reference, left out: {count}.")};

inline constexpr NoteCode zonesExcluded{"zones_excluded", Severity::Info,
                                        LT_TEXT("Engine", "Points in the excluded zones, left out: {count}.")};

inline constexpr NoteCode samePoints{
    "same_points", Severity::Warning,
    LT_TEXT("Engine",
            "Reference and copy are the same points in the same order: the surfaces differ nowhere, and nothing was "
            "measured.")};

inline constexpr NoteCode signUndetermined{
    "sign_undetermined", Severity::Warning,
    LT_TEXT("Engine", "Inside and outside are not known (no normals, no closed surface): the deviation has no sign.")};

inline constexpr NoteCode facetsTurned{
    "facets_turned", Severity::Info,
    LT_TEXT("Engine", "Facets of the reference that run round the other way than their neighbours, turned: {count}.")};

inline constexpr NoteCode holesFilled{
    "holes_filled", Severity::Info,
    LT_TEXT("Engine", "Small holes of the reference's mesh, filled: {count}, up to {largest_mm} mm wide.")};

inline constexpr NoteCode facetsCoarse{
    "facets_coarse", Severity::Warning,
    LT_TEXT("Engine",
            "The mesh of the {role} is coarse: its facets lie up to {sagitta_mm} mm inside the round surface.")};

inline constexpr NoteCode notDistinguishable{
    "not_distinguishable", Severity::Warning,
    LT_TEXT("Engine", "The difference cannot be told from the scanner's accuracy of {scanner_accuracy_mm} mm.")};

inline constexpr NoteCode scanTooPoor{
    "scan_too_poor", Severity::Warning,
    LT_TEXT("Engine",
            "The scan does not decide on ±{limit_mm} mm everywhere: means over {cell_mm} mm are uncertain by "
            "{uncertainty_mm} mm. {times} times as many points would, or limits of ±{uncertainty_mm} mm.")};

inline constexpr NoteCode smallDefectsHidden{
    "small_defects_hidden", Severity::Warning,
    LT_TEXT("Engine",
            "Noise and spacing of the points hide small defects: one of ±{limit_mm} mm or more that is less than "
            "{size_mm} mm across would not be seen everywhere.")};

inline constexpr NoteCode nothingToJudge{
    "nothing_to_judge", Severity::Warning,
    LT_TEXT("Engine", "No part of the surface is smooth and dense enough for local means: the verdict is open.")};

inline constexpr NoteCode coverageBelowHalf{
    "coverage_below_half", Severity::Warning,
    LT_TEXT("Engine",
            "The {role} shows {coverage_deg}° of the circle, less than half: out-of-roundness passes for a shift.")};

inline constexpr NoteCode partIsBent{
    "part_is_bent", Severity::Warning,
    LT_TEXT("Engine",
            "The {role} is bent: its centre line bows by {bow_mm} ± {bow_uncertainty_mm} mm. The axis runs "
            "straight through the section centres.")};

}  // namespace notes

}  // namespace lathelier
