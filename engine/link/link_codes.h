// Errors and notes of the link to a control: codes with their English patterns.
#pragma once

#include "engine/core/error.h"

namespace lathelier::errors {

inline constexpr ErrorCode linkNotFound{"link_not_found", ErrorKind::NoAnswer,
                                        LT_TEXT("Engine", "No control answers at {peer}: {reason}.")};

inline constexpr ErrorCode linkTaken{
    "link_taken", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "Another assistant is linked to the control at {peer}; two on one control are refused.")};

inline constexpr ErrorCode linkLost{"link_lost", ErrorKind::NoAnswer,
                                    LT_TEXT("Engine", "The link to the control at {peer} is lost: {reason}.")};

inline constexpr ErrorCode linkProtocol{
    "link_protocol", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The control at {peer} answers {found}, expected {expected}.")};

inline constexpr ErrorCode linkPortNotFree{"link_port_not_free", ErrorKind::NoAnswer,
                                           LT_TEXT("Engine", "The port {port} cannot be listened to: {reason}.")};

inline constexpr ErrorCode linkValueNotHeld{
    "link_value_not_held", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The register of {name} at {peer} cannot hold {found}: from {minimum} to {maximum}.")};

inline constexpr ErrorCode linkMemberUnknown{
    "link_member_unknown", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The configuration does not know {key}; expected {expected}.")};

inline constexpr ErrorCode linkNotConfigured{
    "link_not_configured", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The configuration says nothing about the link {kind}.")};

inline constexpr ErrorCode linkProgramNotWhole{
    "link_program_not_whole", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Line {line} of the program states {word}, which was not understood and could move the tool.")};

inline constexpr ErrorCode linkProgramEmpty{"link_program_empty", ErrorKind::NoAnswer,
                                            LT_TEXT("Engine", "The program turns nothing: no feed move was found.")};

inline constexpr ErrorCode linkNoProgram{
    "link_no_program", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "D or L is to come from the program, and the control names none that is loaded.")};

inline constexpr ErrorCode linkRequestNotUnderstood{
    "link_request_not_understood", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The control asks with {found}, expected a whole number from 1 to {most}.")};

inline constexpr ErrorCode linkRefused{"link_refused", ErrorKind::NoAnswer,
                                       LT_TEXT("Engine", "The request was refused: {state}.")};

inline constexpr ErrorCode linkLogDiffers{
    "link_log_differs", ErrorKind::NoAnswer,
    LT_TEXT(
        "Engine",
        "Exchanges of the log that are answered otherwise today: {count} of {exchanges}, the first in line {line}.")};

}  // namespace lathelier::errors

namespace lathelier::notes {

inline constexpr NoteCode linkNotVerified{
    "link_not_verified", Severity::Warning,
    LT_TEXT("Engine", "This kind of link was not verified on a real control: {kind}.")};

}  // namespace lathelier::notes
