// Error and note codes of impact tests, with their English patterns. {name} is replaced by the named value; text()
// prefixes path, line, column and byte, so the patterns omit them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode tapChannelUnclear{
    "tap_channel_unclear", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Which channel is {meaning} cannot be told among {found}. State --{parameter}.")};

inline constexpr ErrorCode tapUnitMissing{
    "tap_unit_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The unit of {channel} is not known: found “{found}”, expected {expected}. State it in the file, or a "
            "sensitivity by --{parameter}.")};

inline constexpr ErrorCode tapFullScaleMissing{
    "tap_full_scale_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "{channel} is stated in parts of full scale; a sensitivity in volts needs the voltage of full scale. State "
            "--full-scale-V, or the sensitivity of full scale such as {expected}.")};

inline constexpr ErrorCode tapRateMissing{"tap_rate_missing", ErrorKind::InputRejected,
                                          LT_TEXT("Engine", "Neither times nor a rate are stated. State --rate-hz.")};

inline constexpr ErrorCode tapSampleMissing{
    "tap_sample_missing", ErrorKind::InputRejected,
    LT_TEXT("Engine", "A sample of {channel} is missing; a spectrum needs all of them.")};

inline constexpr ErrorCode tapChannelsDiffer{
    "tap_channels_differ", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "{channel} has {found} in place of {expected}: {quantity}. Records are averaged only when alike.")};

inline constexpr ErrorCode tapNoHit{
    "tap_no_hit", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "No hit is in the record: the largest force is {largest_N} N, the level that triggers {level_N} N.")};

inline constexpr ErrorCode tapBlockTooShort{
    "tap_block_too_short", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "A block of {samples} samples is too short for a spectrum; at least {minimum} are needed.")};

inline constexpr ErrorCode tapNoHitUsed{
    "tap_no_hit_used", ErrorKind::NoAnswer,
    LT_TEXT(
        "Engine",
        "None of {count} hits is usable; the first at {time_s} s: {reason}. --keep-rejected takes them all the same.")};

inline constexpr ErrorCode tapNoLines{
    "tap_no_lines", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "No line is between {from_hz} and {to_hz} Hz; usable are {usable_from_hz} to {usable_to_hz} Hz.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode tapHitsRejected{
    "tap_hits_rejected", Severity::Warning,
    LT_TEXT("Engine", "Hits left out: {count} of {of} ({reason}), at {times} s.")};

inline constexpr NoteCode tapHitsKept{
    "tap_hits_kept", Severity::Warning,
    LT_TEXT("Engine", "Hits that would be left out, kept as asked: {count} of {of} ({reason}), at {times} s.")};

inline constexpr NoteCode tapSingleHit{
    "tap_single_hit", Severity::Warning,
    LT_TEXT("Engine", "One hit only: its noise cannot be judged, and the coherence is not known.")};

inline constexpr NoteCode tapWindowDecay{
    "tap_window_decay", Severity::Warning,
    LT_TEXT("Engine",
            "The exponential window adds {window_decay_1_s:3} 1/s to the decay of every mode: at {frequency_hz:1} Hz, "
            "{added_percent:3} % to the damping ratio, and the peak is lower by as much. Limits by it are too high.")};

inline constexpr NoteCode tapNotDecayed{
    "tap_not_decayed", Severity::Warning,
    LT_TEXT("Engine",
            "At the end of the block the response is still {percent:1} % of its peak: peaks are smeared. Take a longer "
            "block, or --window force_exponential.")};

inline constexpr NoteCode tapForceRange{
    "tap_force_range", Severity::Info,
    LT_TEXT("Engine",
            "The force is {drop_dB} dB below its maximum at {usable_to_hz:1} Hz; lines above are left out: {lines}.")};

inline constexpr NoteCode tapLowLines{
    "tap_low_lines", Severity::Info,
    LT_TEXT("Engine", "Below {usable_from_hz:1} Hz the coherence is under {limit:1}; lines left out: {lines}.")};

inline constexpr NoteCode tapForceNegative{
    "tap_force_negative", Severity::Warning,
    LT_TEXT("Engine",
            "The pulses of the force are negative. If the hammer pushes in the positive direction of the sensor, turn "
            "the sign by a negative sensitivity.")};

inline constexpr NoteCode tapSensitivityNotUsed{
    "tap_sensitivity_not_used", Severity::Warning,
    LT_TEXT("Engine", "{path}: {channel} is stated in {unit}; the given sensitivity {given} is not used.")};

inline constexpr NoteCode tapRateNotUsed{
    "tap_rate_not_used", Severity::Warning,
    LT_TEXT("Engine", "{path}: the file states {rate_hz} samples a second; the given rate {given_hz} is not used.")};

}  // namespace notes

}  // namespace lathelier
