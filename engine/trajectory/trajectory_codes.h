// Error and note codes of the evaluation of probe records, with their English patterns. {name} is replaced by the named
// value; text() prefixes path, line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode diameterMissing{
    "diameter_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The record does not say the workpiece's diameter. State it.")};

inline constexpr ErrorCode channelsUnknown{
    "channels_unknown", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "{signal} cannot be channel {found}: {reason}. The record has {channels} channels, counted from 0.")};

inline constexpr ErrorCode channelUnitMissing{
    "channel_unit_missing", ErrorKind::InputRejected,
    LT_TEXT(
        "Engine",
        "{signal}: channel {found} ({channel}) states no unit; expected µm, mm or V in its heading, such as X3_um.")};

inline constexpr ErrorCode markerNotFound{
    "marker_not_found", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Channel {place} ({channel}) is no marker of revolutions: {reason}.")};

inline constexpr ErrorCode markerElsewhere{"marker_elsewhere", ErrorKind::InputRejected,
                                           LT_TEXT("Engine",
                                                   "Channel {place} ({channel}) is no marker of revolutions: {reason}. "
                                                   "Channel {candidate} ({candidate_channel}) looks like one.")};

inline constexpr ErrorCode angleNotTurning{
    "angle_not_turning", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Channel {place} ({channel}) is no angle of revolution: {reason}.")};

inline constexpr ErrorCode timeNotIncreasing{"time_not_increasing", ErrorKind::InputRejected,
                                             LT_TEXT("Engine", "The time does not go forward at row {row}.")};

inline constexpr ErrorCode tooFewRevolutions{
    "too_few_revolutions", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "{found} whole revolutions are too few; at least {minimum} are needed.")};

inline constexpr ErrorCode recordTooShort{
    "record_too_short", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "{found} revolutions are too few for {sections} sections; at least {minimum} are needed.")};

inline constexpr ErrorCode recordsDiffer{
    "records_differ", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The records are not of one workpiece: {parameter} is {first} in the first and {found} here.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode valueAssumed{"value_assumed", Severity::Info,
                                       LT_TEXT("Engine", "{label} {value} {unit}: taken from {source}."),
                                       NoteRole::Assumed};

inline constexpr NoteCode channelStandsStill{
    "channel_stands_still", Severity::Warning,
    LT_TEXT("Engine", "{path}: {signal} ({channel}) stands still; is the probe connected?")};

inline constexpr NoteCode channelCutOff{"channel_cut_off", Severity::Warning,
                                        LT_TEXT("Engine",
                                                "{path}: {signal} ({channel}) rests at the end of its range for "
                                                "{share_percent} % of the time; the probe was out of range.")};

inline constexpr NoteCode displacementsLarge{"displacements_large", Severity::Warning,
                                             LT_TEXT("Engine",
                                                     "{path}: {signal} reaches {largest_um} µm, more than a probe "
                                                     "measures; check the sensitivity and the channels.")};

inline constexpr NoteCode sensitivityAssumed{
    "sensitivity_assumed", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: the sensitivity of the probes is not given; assumed {sensitivity_um_per_V} µm/V. Every length in "
            "the result follows from it."),
    NoteRole::Assumed};

inline constexpr NoteCode skewUnknown{
    "skew_unknown", Severity::Warning,
    LT_TEXT("Engine", "{path}: the delay from channel to channel is not known; taken as none.")};

inline constexpr NoteCode revolutionsRejected{
    "revolutions_rejected", Severity::Warning,
    LT_TEXT("Engine", "{path}: revolutions of irregular length, left out: {count}.")};

inline constexpr NoteCode revolutionsIncomplete{
    "revolutions_incomplete", Severity::Warning,
    LT_TEXT("Engine", "{path}: revolutions with missing samples, left out: {count}.")};

inline constexpr NoteCode revolutionsUnused{
    "revolutions_unused", Severity::Info,
    LT_TEXT("Engine", "{path}: {used} of {found} revolutions were used, as the parameters ask.")};

inline constexpr NoteCode fewerRevolutions{
    "fewer_revolutions", Severity::Warning,
    LT_TEXT("Engine", "{path}: {found} revolutions in a section instead of {asked}.")};

inline constexpr NoteCode speedDiffers{
    "speed_differs", Severity::Warning,
    LT_TEXT("Engine", "{path}: the marks come {found_rpm} times a minute, the record says {stated_rpm} rpm.")};

inline constexpr NoteCode motionOutliers{
    "motion_outliers", Severity::Info,
    LT_TEXT("Engine", "Left out because they stand out: revolutions {revolutions}, samples {samples}.")};

inline constexpr NoteCode zUnknown{
    "z_unknown", Severity::Info,
    LT_TEXT("Engine", "Sections without a known place along the workpiece: {count}. No longitudinal section.")};

inline constexpr NoteCode tooFewSections{
    "too_few_sections", Severity::Info,
    LT_TEXT("Engine", "A longitudinal section needs sections at {minimum} different places; there are {found}.")};

inline constexpr NoteCode noCylindricity{"no_cylindricity", Severity::Warning,
                                         LT_TEXT("Engine",
                                                 "The sections span {length_mm} mm of a workpiece of {diameter_mm} mm: "
                                                 "too short for an axis, so there is no cylindricity.")};

inline constexpr NoteCode sizeReferenced{
    "size_referenced", Severity::Info,
    LT_TEXT("Engine", "The diameter of {diameter_mm} mm is nominal: form is measured, size is referenced to it.")};

inline constexpr NoteCode formNotMeasured{
    "form_not_measured", Severity::Warning,
    LT_TEXT("Engine",
            "Sections whose form is not measured: {count}. In section {section} RONt is {RONt_um} µm with an "
            "uncertainty of {expanded_uncertainty_um} µm: noise, drift or hum, not form. They are not judged.")};

inline constexpr NoteCode mandrelFloor{"mandrel_floor", Severity::Info,
                                       LT_TEXT("Engine",
                                               "Two probes cannot tell the mandrel's own form (up to {form_um} µm) "
                                               "from its motion: nothing smaller is resolved.")};

inline constexpr NoteCode averagesOnly{
    "averages_only", Severity::Info,
    LT_TEXT("Engine", "{path}: averages over revolutions; asynchronous motion and single revolutions are not known.")};

inline constexpr NoteCode sectionNotThere{
    "section_not_there", Severity::Warning,
    LT_TEXT("Engine", "The record has no section {section}: section {used}, which deviates most, is judged.")};

}  // namespace notes

}  // namespace lathelier
