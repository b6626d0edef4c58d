// Errors and notes of the recognition: codes with their English patterns. {name} is replaced by the named value.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode lengthAgainstData{
    "length_against_data", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The stated length of {length_mm:3} mm contradicts the data, which show {data_mm:3} ± {uncertainty_mm:3} "
            "mm.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode sceneCut{
    "scene_cut", Severity::Warning,
    LT_TEXT("Engine",
            "{cut_points} of {points} points were taken for something else than the part and cut off: turntable "
            "{turntable_points}, clamps {clamp_points}, loose things {clutter_points}.")};

inline constexpr NoteCode endOnSupport{
    "end_on_support", Severity::Info,
    LT_TEXT(
        "Engine",
        "The {end} stands on the plane that was cut off: it was put onto that plane, {moved_mm} mm beyond the data.")};

inline constexpr NoteCode facetsRounded{
    "facets_rounded", Severity::Info,
    LT_TEXT(
        "Engine",
        "The facets of the mesh lie up to {sagitta_mm} mm inside the round surface: their corners were taken for it, "
        "and what lies between was put onto it.")};

inline constexpr NoteCode gapInData{
    "gap", Severity::Warning,
    LT_TEXT("Engine", "There are no data from z {z_start_mm} to {z_end_mm} mm: the rows beside end there.")};

inline constexpr NoteCode boreNotSeen{
    "bore_not_seen", Severity::Warning,
    LT_TEXT("Engine", "The bore is not seen from z {z_start_mm} to {z_end_mm} mm: its rows beside end there.")};

inline constexpr NoteCode endNotSeen{
    "end_not_seen", Severity::Warning,
    LT_TEXT("Engine", "The {end} of the part is not seen: the data end at z {z_mm} mm. The length is not known.")};

inline constexpr NoteCode endIsBall{
    "end_is_ball", Severity::Info,
    LT_TEXT("Engine",
            "The {end} is a ball of {diameter_mm} mm with its centre on the axis: it was closed at the ball's pole. "
            "Within {unseen_diameter_mm} mm about the axis no points of it are seen: a small flat there would not be "
            "either.")};

inline constexpr NoteCode endUndecided{
    "end_undecided", Severity::Warning,
    LT_TEXT(
        "Engine",
        "Whether the part ends where the data do is not decided at the {end}: if so, from z {from_mm:3} to {to_mm:3} "
        "mm. The length is not known; state it to confirm the end.")};

inline constexpr NoteCode endConfirmed{
    "end_confirmed", Severity::Info,
    LT_TEXT("Engine", "The length of {length_mm} mm was stated; the data alone do not show the {end}."),
    NoteRole::Assumed};

inline constexpr NoteCode segmentNotCoaxial{
    "segment_not_coaxial", Severity::Warning,
    LT_TEXT("Engine", "Row {row} (z {z_start_mm} to {z_end_mm} mm) lies {offset_mm} mm off the common axis.")};

inline constexpr NoteCode coveragePartial{
    "coverage_partial", Severity::Warning,
    LT_TEXT("Engine",
            "Only {coverage_deg}° of the circle are seen: ovality of the part is taken for size; the uncertainties are "
            "wider by {added_um} µm.")};

inline constexpr NoteCode marksFound{
    "marks_found", Severity::Info,
    LT_TEXT("Engine", "Marks that are no body of revolution, named beside the rows: {count}.")};

inline constexpr NoteCode uncertaintyNoiseOnly{
    "uncertainty_noise_only", Severity::Info,
    LT_TEXT("Engine", "The uncertainties hold the noise of the scan only; the scanner's own accuracy was not stated.")};

inline constexpr NoteCode roughZone{
    "rough_zone", Severity::Warning,
    LT_TEXT("Engine",
            "From z {z_start_mm} to {z_end_mm} mm the surface is rough (a thread, a knurl): one row over its crests.")};

inline constexpr NoteCode rowsMerged{
    "rows_merged", Severity::Info,
    LT_TEXT("Engine", "Junctions within the form tolerance that were taken away: {count}.")};

inline constexpr NoteCode paperMethod{
    "paper_method", Severity::Info,
    LT_TEXT("Engine", "The published method was used; its sections know no cones, arcs and undercuts.")};

inline constexpr NoteCode sizesNotRecognized{
    "sizes_not_recognized", Severity::Warning,
    LT_TEXT("Engine", "The sizes of the copy were not recognised ({reason}): the rows have no measured values.")};

inline constexpr NoteCode markNotFound{
    "mark_not_found", Severity::Warning,
    LT_TEXT("Engine",
            "The drawing has this from z {from_mm:1} to {to_mm:1} mm, and it is not found in the copy: {kind}. Neither "
            "the surface nor the sizes of the rows judge it."),
    NoteRole::NotModelled};

inline constexpr NoteCode marksNotCompared{
    "marks_not_compared", Severity::Info,
    LT_TEXT("Engine", "Marks of the drawing that the copy has too: {count}. Their sizes are not compared.")};

inline constexpr NoteCode unexplainedStructure{
    "unexplained_structure", Severity::Warning,
    LT_TEXT("Engine",
            "Unexplained structure ({structure}) from z {z_start_mm:1} to {z_end_mm:1} mm, {area_mm2:1} mm², up to "
            "{height_mm:3} mm, at {places} places around the axis: no row and no mark describes it."),
    NoteRole::NotModelled};

inline constexpr NoteCode unexplainedHole{
    "unexplained_hole", Severity::Warning,
    LT_TEXT(
        "Engine",
        "No points from z {z_start_mm:1} to {z_end_mm:1} mm, {area_mm2:1} mm², at {places} round places of a surface "
        "that is seen: no row and no mark explains it."),
    NoteRole::NotModelled};

inline constexpr NoteCode takenForDamage{
    "taken_for_damage", Severity::Warning,
    LT_TEXT("Engine", "Structure that no row explains was stated to be damage of the part: {count} stretches."),
    NoteRole::Assumed};

inline constexpr NoteCode scanNoiseCorrelated{
    "scan_noise_correlated", Severity::Info,
    LT_TEXT(
        "Engine",
        "The noise of neighbouring points is correlated: the uncertainties are {factor:1} times those of independent "
        "points.")};

inline constexpr NoteCode passesDiffer{
    "passes_differ", Severity::Warning,
    LT_TEXT("Engine",
            "Passes of the scanner differ by {difference_um:1} µm on the radius (χ² {chi2:1} per bin): every diameter "
            "may be off by twice that.")};

inline constexpr NoteCode edgeNotPlaced{
    "edge_not_placed", Severity::Warning,
    LT_TEXT("Engine",
            "At the shoulder near z {z_mm:2} mm rays hit and miss over all of half a millimetre: its place is that of "
            "the walls beside it.")};

inline constexpr NoteCode endsOfStructure{
    "ends_of_structure", Severity::Warning,
    LT_TEXT("Engine",
            "Row {row} is structure that was not understood: where it begins and ends is stated without uncertainty.")};

inline constexpr NoteCode scatterUnexplained{
    "scatter_unexplained", Severity::Warning,
    LT_TEXT(
        "Engine",
        "The bins scatter more than their noise explains (χ² {chi2:1} per bin): the uncertainties are multiplied by "
        "its root.")};

inline constexpr NoteCode sizeNotDetermined{
    "size_not_determined", Severity::Warning,
    LT_TEXT("Engine",
            "Row {row}: the data do not determine its {size} (U {uncertainty_mm:1} mm); it is given without an "
            "uncertainty.")};

inline constexpr NoteCode nominalNotApplied{
    "nominal_not_applied", Severity::Info,
    LT_TEXT("Engine",
            "Suggested sizes that the measured ones do not agree with within U stay as measured: {count} ({sizes}). A "
            "person may confirm each.")};

inline constexpr NoteCode rowsNotRound{
    "rows_not_round", Severity::Info,
    LT_TEXT("Engine", "Rows that are not round: {count}; row {row} has {lobes} lobes of {height_um:1} µm.")};

}  // namespace notes

}  // namespace lathelier
