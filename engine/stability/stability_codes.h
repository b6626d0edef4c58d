// Errors and notes of cutting stability: codes with their English patterns. {name} is replaced by the named value;
// text() puts path, line, column and byte in front, so patterns do not repeat them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode noStableSpeed{
    "no_stable_speed", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "No stable speed can be recommended for {selected_rpm} 1/min: {reason}.")};

inline constexpr ErrorCode tooFewLines{
    "too_few_lines", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The frequency response has {found} lines; at least {minimum} are needed.")};

inline constexpr ErrorCode notAReceptance{
    "not_a_receptance", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "Stability needs a receptance (displacement per force); convert the frequency response first.")};

inline constexpr ErrorCode simulationTooLong{
    "simulation_too_long", ErrorKind::WrongUsage,
    LT_TEXT("Engine",
            "The simulation would take {steps} time steps; at most {most} are allowed. Ask for fewer revolutions.")};

inline constexpr ErrorCode modesNeeded{
    "modes_needed", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "A simulation needs modes, and none could be found in the frequency response. State them with --mode.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode noLimit{
    "no_limit", Severity::Warning,
    LT_TEXT("Engine",
            "The real part of the frequency response is nowhere negative: in its range no depth of cut chatters.")};

inline constexpr NoteCode coefficientUnknown{
    "coefficient_unknown", Severity::Info,
    LT_TEXT("Engine", "The cutting coefficient is not given: depths are multiples of the least limiting depth.")};

inline constexpr NoteCode publishedRelation{
    "published_relation", Severity::Warning,
    LT_TEXT("Engine",
            "Speeds by N = 60 f/k as published, which sets the phase of the regeneration to zero. It finds the lobes "
            "of the papers; depths at a given speed are those of the exact relation only.")};

inline constexpr NoteCode fromAnotherLobe{
    "recommended_from_another_lobe", Severity::Info,
    LT_TEXT(
        "Engine",
        "The speed of the selected lobe, {lobe_rpm} 1/min, lies outside the range of cutting speeds; recommended is "
        "the nearest inside.")};

inline constexpr NoteCode minimumAtEdge{
    "minimum_at_edge", Severity::Warning,
    LT_TEXT("Engine",
            "The least real part lies at the end of the frequency response, at {frequency_hz} Hz: the mode that limits "
            "the depth may lie outside.")};

inline constexpr NoteCode minimumInNoise{
    "minimum_in_noise", Severity::Warning,
    LT_TEXT("Engine",
            "The least real part, at {frequency_hz} Hz, hardly stands out of the noise of its line ({noise_percent} % "
            "of it): the least depth may be that of the noise. State the range that was excited with --range-hz."),
    NoteRole::NotModelled};

inline constexpr NoteCode minimumNotResolved{
    "minimum_not_resolved", Severity::Warning,
    LT_TEXT("Engine",
            "The resonance that limits the depth, at {frequency_hz} Hz, is seen by {lines} lines within its half-power "
            "band: the least depth may be wrong by 15 %. Measure longer for a finer resolution, or use the fitted "
            "model.")};

inline constexpr NoteCode lobesLeftOut{
    "lobes_left_out", Severity::Info,
    LT_TEXT("Engine",
            "So many lobes reach these speeds that {count} of them are not listed: those farthest from the foot of the "
            "lobes, and the slowest. The limit is that of all.")};

inline constexpr NoteCode modesFitted{
    "modes_fitted", Severity::Info,
    LT_TEXT("Engine",
            "Modes fitted to the frequency response, which the simulation rests on: {count}; what they leave of it "
            "together with what lies outside its lines is {error_percent} %.")};

inline constexpr NoteCode modesComputed{
    "modes_computed", Severity::Info,
    LT_TEXT("Engine",
            "Modes of the computed response, which the simulation rests on: {count}; what they leave of it together "
            "with the compliance beyond its lines is {error_percent} %.")};

inline constexpr NoteCode modelLeavesMuch{
    "model_leaves_much", Severity::Warning,
    LT_TEXT("Engine",
            "At {frequency_hz} Hz, where the cut vibrates, the modes that are simulated leave {error_percent} % of the "
            "frequency response, more than {limit_percent} %: the verdict is undecided."),
    NoteRole::NotModelled};

inline constexpr NoteCode growthOutsideLines{
    "growth_outside_lines", Severity::Info,
    LT_TEXT("Engine",
            "The slowest decay, {frequency_hz} Hz, is that of what lies outside the lines of the frequency response, "
            "{from_hz} to {to_hz} Hz, and is not known; within them vibrations decay faster than the growth stated.")};

inline constexpr NoteCode vibrationOutsideLines{
    "vibration_outside_lines", Severity::Warning,
    LT_TEXT("Engine",
            "The vibration of the simulated cut, {frequency_hz} Hz, lies outside the lines of the frequency response, "
            "{from_hz} to {to_hz} Hz: the verdict is undecided."),
    NoteRole::NotModelled};

}  // namespace notes

}  // namespace lathelier
