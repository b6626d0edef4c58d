// Error and note codes of readers and writers, with their English patterns. {name} is replaced by the named value;
// text() prefixes path, line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode fileNotFound{"file_not_found", ErrorKind::InputRejected,
                                        LT_TEXT("Engine", "This file does not exist.")};

inline constexpr ErrorCode fileNotReadable{"file_not_readable", ErrorKind::InputRejected,
                                           LT_TEXT("Engine", "The file cannot be read: {reason}.")};

inline constexpr ErrorCode notAFile{"not_a_file", ErrorKind::InputRejected,
                                    LT_TEXT("Engine", "Expected a file, found {found}.")};

inline constexpr ErrorCode fileTooLarge{
    "file_too_large", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The file has {found_MiB} MiB; the memory that is free allows for {maximum_MiB} MiB.")};

inline constexpr ErrorCode fileChanged{
    "changed_while_reading", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Another program changed the file while it was read. Read it again when it is complete.")};

inline constexpr ErrorCode fileEmpty{"file_empty", ErrorKind::InputRejected, LT_TEXT("Engine", "The file is empty.")};

inline constexpr ErrorCode fileNotWritable{"file_not_writable", ErrorKind::OutputFailed,
                                           LT_TEXT("Engine", "The file cannot be written: {reason}.")};

inline constexpr ErrorCode outputIsInput{
    "output_is_input", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "{parameter} would overwrite {file}, which is an input. Name another file.")};

inline constexpr ErrorCode outputsAreOne{
    "outputs_are_one", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "{parameter}: {file} is named for two outputs, also as {other}.")};

inline constexpr ErrorCode formatUnknown{
    "format_unknown", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The kind of this file is not known: found {found}, expected {expected}.")};

inline constexpr ErrorCode malformed{"malformed", ErrorKind::InputRejected,
                                     LT_TEXT("Engine", "Found “{found}”, expected {expected}.")};

inline constexpr ErrorCode keyMissing{"key_missing", ErrorKind::InputRejected,
                                      LT_TEXT("Engine", "The key {key} is missing; expected {expected}.")};

inline constexpr ErrorCode keyMisnamed{"key_misnamed", ErrorKind::InputRejected,
                                       LT_TEXT("Engine", "Found the key {found}, expected {key}.")};

inline constexpr ErrorCode keyOutOfRange{
    "key_out_of_range", ErrorKind::InputRejected,
    LT_TEXT("Engine", "{key} is {found}; expected a value from {minimum} to {maximum}.")};

inline constexpr ErrorCode truncated{
    "truncated", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The file ends early: {found} of {expected} {items} are there.")};

inline constexpr ErrorCode numberAmbiguous{
    "number_ambiguous", ErrorKind::InputRejected,
    LT_TEXT("Engine", "“{found}” can be read in two ways: {first} or {second}. State the decimal mark.")};

inline constexpr ErrorCode unitUnknown{
    "unit_unknown", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The file states no unit, and an extent of {extent} fits no guess. State the unit.")};

inline constexpr ErrorCode angleUnitUnknown{
    "angle_unit_unknown", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The unit of the angle is not known: found “{found}”, expected {expected}.")};

inline constexpr ErrorCode noPoints{"no_points", ErrorKind::InputRejected,
                                    LT_TEXT("Engine", "The file holds no usable point.")};

inline constexpr ErrorCode columnsUnknown{
    "columns_unknown", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The columns cannot be told: found “{found}”, expected {expected}.")};

inline constexpr ErrorCode columnsAmbiguous{
    "columns_ambiguous", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Several columns may be meant: found “{found}”, where {candidates} could each be {meaning}.")};

inline constexpr ErrorCode referenceDataMissing{
    "reference_data_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine", "This folder holds no reference data: found {found}, expected {expected}.")};

inline constexpr ErrorCode nominalRadiusMissing{
    "nominal_radius_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The file holds deviations only, from {minimum} to {maximum}. State the nominal radius.")};

inline constexpr ErrorCode partnerMissing{"partner_missing", ErrorKind::InputRejected,
                                          LT_TEXT("Engine", "The record is not complete: {partner} is not beside it.")};

inline constexpr ErrorCode recordContradicts{
    "record_contradicts", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The record contradicts itself ({check}): found {found}, expected {expected}.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode unknownKey{
    "unknown_key", Severity::Warning,
    LT_TEXT("Engine", "Line {line}, column {column}: the key {key} is not known; what it states is not used."),
    NoteRole::NotModelled};

inline constexpr NoteCode unitGuessed{
    "unit_guessed", Severity::Warning,
    LT_TEXT("Engine", "{path}: no unit is stated; read as {unit} because of its extent of {extent}."),
    NoteRole::Assumed};

inline constexpr NoteCode rowsSkipped{"rows_skipped", Severity::Info,
                                      LT_TEXT("Engine", "{path}: rows skipped: {count}.")};

inline constexpr NoteCode pointsNotFinite{
    "points_not_finite", Severity::Warning,
    LT_TEXT("Engine", "{path}: points without finite coordinates, left out: {count}.")};

inline constexpr NoteCode syntheticData{"synthetic_data", Severity::Warning,
                                        LT_TEXT("Engine", "{path}: synthetic data, made by a program, not measured.")};

inline constexpr NoteCode countDiffers{
    "count_differs", Severity::Warning,
    LT_TEXT("Engine", "{path}: {announced} rows are announced, {found} are there; all were read.")};

inline constexpr NoteCode facetsDegenerate{
    "facets_degenerate", Severity::Info,
    LT_TEXT("Engine", "{path}: facets with two corners in one place, left out: {count}.")};

inline constexpr NoteCode normalsUnusable{
    "normals_unusable", Severity::Warning,
    LT_TEXT("Engine", "{path}: normals without a direction: {count}; the normals are not used.")};

inline constexpr NoteCode unitNotUsed{
    "unit_not_used", Severity::Warning,
    LT_TEXT("Engine", "{path}: the file states {unit}; the given unit {given} is not used.")};

inline constexpr NoteCode unitsMayDiffer{
    "units_may_differ", Severity::Warning,
    LT_TEXT("Engine",
            "The sizes of the two parts differ by about {factor}, as if one were in another unit of length; "
            "--reference-unit and --copy-unit rule one file each.")};

inline constexpr NoteCode profilePlane{
    "profile_plane", Severity::Info,
    LT_TEXT("Engine", "{path}: the points lie in the plane {plane} at {at_mm} mm; read as a profile in it.")};

inline constexpr NoteCode coordinateIgnored{
    "coordinate_ignored", Severity::Warning,
    LT_TEXT("Engine", "{path}: {coordinate} runs from {from_mm} to {to_mm} mm; all points were read as one section.")};

inline constexpr NoteCode columnsRead{"columns_read", Severity::Info,
                                      LT_TEXT("Engine", "{path}: columns read: {columns}.")};

inline constexpr NoteCode columnsGuessed{"columns_guessed", Severity::Warning,
                                         LT_TEXT("Engine", "{path}: the columns have no names; read as {columns}.")};

inline constexpr NoteCode angleUnitGuessed{
    "angle_unit_guessed", Severity::Warning,
    LT_TEXT("Engine", "{path}: no unit of the angle is stated; read as rad because it runs over {extent}.")};

inline constexpr NoteCode angleUnitFromExtent{
    "angle_unit_from_extent", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: “{found}” is no certain unit of an angle; read as {unit} because it runs over {extent}.")};

inline constexpr NoteCode anglesUniform{
    "angles_uniform", Severity::Info,
    LT_TEXT("Engine", "{path}: no angles are stated; {count} values were spread evenly over one turn.")};

inline constexpr NoteCode sizeFromNominal{
    "size_from_nominal", Severity::Info,
    LT_TEXT("Engine", "{path}: deviations laid on the nominal radius of {radius_mm} mm; the size is not measured.")};

inline constexpr NoteCode nominalNotUsed{
    "nominal_not_used", Severity::Info,
    LT_TEXT("Engine", "{path}: the file holds radii; the nominal radius of {radius_mm} mm is not used.")};

inline constexpr NoteCode timeUnitAssumed{"time_unit_assumed", Severity::Warning,
                                          LT_TEXT("Engine", "{path}: no unit of the time is stated; read as seconds."),
                                          NoteRole::Assumed};

inline constexpr NoteCode timeIrregular{
    "time_irregular", Severity::Warning,
    LT_TEXT("Engine", "{path}: time steps that differ from {step_s} s: {count}, the first at line {line}.")};

inline constexpr NoteCode timeCoarse{
    "time_coarse", Severity::Warning,
    LT_TEXT("Engine", "{path}: the times are written too coarsely; {rate_hz} frames a second were used instead.")};

inline constexpr NoteCode rateUnknown{"rate_unknown", Severity::Warning,
                                      LT_TEXT("Engine", "{path}: neither times nor a rate are stated.")};

inline constexpr NoteCode samplesMissing{"samples_missing", Severity::Warning,
                                         LT_TEXT("Engine", "{path}: missing samples of {channel}: {count}.")};

inline constexpr NoteCode channelUnitUnknown{"channel_unit_unknown", Severity::Warning,
                                             LT_TEXT("Engine", "{path}: no unit of {channel} is stated.")};

inline constexpr NoteCode converterRateWrong{"converter_rate_wrong", Severity::Info,
                                             LT_TEXT("Engine",
                                                     "{path}: the stated converter rate of {stated_kHz} kHz does not "
                                                     "fit {channels} channels; {used_kHz} kHz was used.")};

inline constexpr NoteCode converterDelayDiffers{"converter_delay_differs", Severity::Info,
                                                LT_TEXT("Engine",
                                                        "{path}: the stated delay of {stated_ms} ms does not fit the "
                                                        "rates; {used_ms} ms from channel to channel was used.")};

inline constexpr NoteCode fullScaleAssumed{
    "full_scale_assumed", Severity::Info,
    LT_TEXT("Engine", "{path}: {full_scale_code} converter codes of {device} were read as {volts} V."),
    NoteRole::Assumed};

inline constexpr NoteCode fullScaleUnknown{
    "full_scale_unknown", Severity::Warning,
    LT_TEXT("Engine",
            "{path}: the recorder {device} is not known; the values are converter codes. State the full scale.")};

inline constexpr NoteCode recordInSegments{
    "record_in_segments", Severity::Warning,
    LT_TEXT("Engine", "{path}: the recording has {count} segments; there may be gaps between them.")};

}  // namespace notes

}  // namespace lathelier
