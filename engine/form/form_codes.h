// Error and note codes of the form evaluation, with their English patterns. {name} is replaced by the named value;
// text() prefixes path, line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace notes {

inline constexpr NoteCode undersampled{
    "undersampled", Severity::Warning,
    LT_TEXT("Engine",
            "{points} points a turn are too few for {cutoff_upr} UPR by the rule of 7 points a wave; they carry "
            "{supported_upr} UPR. The answer is given all the same.")};

inline constexpr NoteCode gapsInProfile{"gaps_in_profile", Severity::Info,
                                        LT_TEXT("Engine",
                                                "Gaps in the profile: {count}, the largest of {largest_deg}°. Beside "
                                                "them filter and harmonics rest on the points that are there.")};

inline constexpr NoteCode partialArc{
    "partial_arc", Severity::Warning,
    LT_TEXT(
        "Engine",
        "The points leave {missing_deg}° of the turn out: this is the roundness of an arc, and harmonics say little.")};

inline constexpr NoteCode anglesUneven{
    "angles_uneven", Severity::Info,
    LT_TEXT("Engine", "The points are unevenly spread over the turn; filter and harmonics take that into account.")};

inline constexpr NoteCode duplicatePoints{"duplicate_points", Severity::Info,
                                          LT_TEXT("Engine", "Points that lie where others do: {count}.")};

inline constexpr NoteCode revolutionsOverlaid{
    "revolutions_overlaid", Severity::Warning,
    LT_TEXT("Engine",
            "The points go round {revolutions} times: the revolutions lie over each other and were evaluated as one "
            "profile, their differences as noise.")};

inline constexpr NoteCode outliersRemoved{"outliers_removed", Severity::Info,
                                          LT_TEXT("Engine", "Outliers left out (Hampel): {count}.")};

inline constexpr NoteCode sectorsExcluded{"sectors_excluded", Severity::Info,
                                          LT_TEXT("Engine", "Points in the excluded sectors, left out: {count}.")};

inline constexpr NoteCode minimumZoneNotUnique{
    "minimum_zone_not_unique", Severity::Info,
    LT_TEXT("Engine", "Another centre gives the same minimum zone: RONt is sure, the centre is not.")};

inline constexpr NoteCode inscribedNotUnique{
    "inscribed_not_unique", Severity::Info,
    LT_TEXT("Engine", "Another centre holds an equal maximum inscribed circle; RONt(MICI) depends on which is taken.")};

inline constexpr NoteCode certificateOpen{"certificate_open", Severity::Warning,
                                          LT_TEXT("Engine", "{circle} is proved to {gap_um} µm only.")};

inline constexpr NoteCode noiseNotKnown{"noise_not_known", Severity::Info,
                                        LT_TEXT("Engine",
                                                "The noise of the points cannot be told from the form and counts as "
                                                "form; state the uncertainty of a point for an uncertainty of the "
                                                "result.")};

inline constexpr NoteCode noiseEstimated{
    "noise_estimated", Severity::Info,
    LT_TEXT("Engine",
            "The noise of a point is estimated as {sigma_um} µm. Assumed: what no smooth form explains is noise; state "
            "the uncertainty of a point where it is known.")};

inline constexpr NoteCode failWithinUncertainty{
    "fail_within_uncertainty", Severity::Warning,
    LT_TEXT("Engine",
            "{value_um} µm exceeds the limit of {limit_um} µm by less than its uncertainty of {uncertainty_um} µm: "
            "simple acceptance counts as form what may be noise.")};

inline constexpr NoteCode phantomPoints{
    "phantom_points", Severity::Warning,
    LT_TEXT("Engine",
            "Points at exactly {x_mm}, {y_mm}, {z_mm} mm, left out: {count}. Programs write one place for all that "
            "was not measured.")};

inline constexpr NoteCode harmonicsLimited{
    "harmonics_limited", Severity::Info,
    LT_TEXT(
        "Engine",
        "Harmonics above {carried_upr} UPR are left out: the points, up to {spacing_deg}° apart, do not carry them.")};

inline constexpr NoteCode harmonicsEstimated{
    "harmonics_estimated", Severity::Info,
    LT_TEXT("Engine",
            "Harmonics above {determined_upr} UPR are estimates beside the gaps: up to {leakage_percent} % of one may "
            "stand in another.")};

inline constexpr NoteCode resolutionCounted{
    "resolution_counted", Severity::Info,
    LT_TEXT("Engine", "The values change in steps of {resolution_um} µm; the uncertainty counts them as step/√12.")};

inline constexpr NoteCode noiseCorrelated{
    "noise_correlated", Severity::Info,
    LT_TEXT("Engine",
            "The noise of neighbours moves together over about {points} points. Assumed: what no harmonic explains is "
            "noise; the uncertainty allows for it.")};

inline constexpr NoteCode spikesCounted{
    "spikes_counted", Severity::Warning,
    LT_TEXT("Engine",
            "Single points that stand out of the profile: {count}, by up to {largest_um} µm. They count in RONt and in "
            "its uncertainty; the outlier rule would leave them out.")};

inline constexpr NoteCode twoPointIncomplete{
    "two_point_incomplete", Severity::Info,
    LT_TEXT("Engine", "No two-point size in {share_percent} % of the directions: a gap lies opposite.")};

inline constexpr NoteCode nominalRadiusMatters{
    "nominal_radius_matters", Severity::Warning,
    LT_TEXT("Engine",
            "The trace is {eccentricity_um} µm off centre: RONt depends on the radius of {radius_mm} mm it is laid on, "
            "by up to {effect_um} µm, which the uncertainty counts. Centre the part better, or state its radius.")};

inline constexpr NoteCode axisStraightnessUnknown{
    "axis_straightness_unknown", Severity::Info,
    LT_TEXT("Engine", "No straightness of the axis: {reason}. Sections found: {sections}, needed: {minimum}.")};

inline constexpr NoteCode sizeNominal{
    "size_nominal", Severity::Info,
    LT_TEXT("Engine", "The profile holds deviations from a nominal radius: form is measured, size is not.")};

inline constexpr NoteCode rotationNotDetermined{
    "rotation_not_determined", Severity::Warning,
    LT_TEXT("Engine", "The form does not determine the angle between the profiles; several rotations fit as well.")};

}  // namespace notes

}  // namespace lathelier
