// Errors of all rooms: codes with their English patterns. {name} is replaced by the named value; text() puts
// path, line, column and byte in front, so patterns do not repeat them.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode unknownOption{"unknown_option", ErrorKind::WrongUsage,
                                         LT_TEXT("Engine", "The option {option} is not known.")};

inline constexpr ErrorCode valueOutOfRange{
    "value_out_of_range", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "{parameter} is {found}; expected {expected} from {minimum} to {maximum}.")};

inline constexpr ErrorCode valueNotUnderstood{"value_not_understood", ErrorKind::WrongUsage,
                                              LT_TEXT("Engine", "{parameter}: found “{found}”, expected {expected}.")};

inline constexpr ErrorCode valueStatedTwice{
    "value_stated_twice", ErrorKind::InputRejected,
    LT_TEXT("Engine", "{former} is the older name of {key}, and both are stated; keep one of them.")};

inline constexpr ErrorCode coordinateTooLarge{
    "coordinate_too_large", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The coordinate {found} is out of reach; expected at most {maximum}.")};

inline constexpr ErrorCode tooFewPoints{
    "too_few_points", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "{found} points are too few; at least {minimum} are needed.")};

inline constexpr ErrorCode pointsDegenerate{
    "points_degenerate", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The points all lie {found}; no answer follows from that.")};

inline constexpr ErrorCode notConverged{"not_converged", ErrorKind::NoAnswer,
                                        LT_TEXT("Engine", "No stable solution after {iterations} iterations.")};

inline constexpr ErrorCode outOfMemory{"out_of_memory", ErrorKind::NoAnswer,
                                       LT_TEXT("Engine", "There is not enough memory for this.")};

inline constexpr ErrorCode moduleMissing{
    "module_missing", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "A part of the program cannot be loaded: {file} ({reason}). Is the installation complete?")};

inline constexpr ErrorCode internal{"internal", ErrorKind::NoAnswer,
                                    LT_TEXT("Engine", "Lathelier made a mistake here ({reason}). Please report it.")};

inline constexpr ErrorCode notModelled{
    "not_modelled", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "“{found}” is not modelled and could change the result, so nothing is written on it.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode notModelled{
    "not_modelled", Severity::Warning,
    LT_TEXT("Engine",
            "{place}: “{found}” is not modelled. It could change the result, which is undecided (such "
            "places: {count}).")};

}  // namespace notes

}  // namespace lathelier
