// Errors and notes of the archive.
#pragma once

#include "engine/core/error.h"

namespace lathelier {

namespace errors {

inline constexpr ErrorCode evaluationAltered{
    "evaluation_altered", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The evaluation says that its key is {found}; its content gives {expected}. It was altered.")};

inline constexpr ErrorCode passwordInLocation{
    "password_in_location", ErrorKind::WrongUsage,
    LT_TEXT("Engine",
            "The location {location} holds a password, which others could see. Put it into ~/.pgpass or into the "
            "service file.")};

inline constexpr ErrorCode locationUnclear{
    "location_unclear", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "The location {location} is not understood; expected {expected}.")};

inline constexpr ErrorCode tlsRequired{
    "tls_required", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "{location}: sslmode is {found}. Over the network expected require, verify-ca or verify-full.")};

inline constexpr ErrorCode archiveNotOpened{"archive_not_opened", ErrorKind::InputRejected,
                                            LT_TEXT("Engine", "The archive {location} cannot be opened: {reason}.")};

inline constexpr ErrorCode archiveNotRead{"archive_not_read", ErrorKind::InputRejected,
                                          LT_TEXT("Engine", "The archive {location} cannot be read: {reason}.")};

inline constexpr ErrorCode archiveNotWritten{"archive_not_written", ErrorKind::OutputFailed,
                                             LT_TEXT("Engine", "The archive {location} cannot be written: {reason}.")};

inline constexpr ErrorCode noArchive{"no_archive", ErrorKind::InputRejected,
                                     LT_TEXT("Engine", "{location} is no archive: found {found}.")};

inline constexpr ErrorCode archiveExists{"archive_exists", ErrorKind::InputRejected,
                                         LT_TEXT("Engine", "The archive {location} is there already.")};

inline constexpr ErrorCode archiveNewer{
    "archive_newer", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The archive {location} has the version {found}; this program knows versions up to {expected}.")};

inline constexpr ErrorCode archiveOlder{
    "archive_older", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The archive {location} has the version {found} and could not be brought to version {expected}: {reason}. "
            "Who made it has to open it once.")};

inline constexpr ErrorCode archiveOnNetwork{
    "archive_on_network", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "{location} lies on {file_system}, where a file that several programs write is not safe. Use a local disk, "
            "or PostgreSQL.")};

inline constexpr ErrorCode chainBroken{
    "chain_broken", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The archive {location} was altered: the row {sequence} of the writer {writer} is broken ({fault}).")};

inline constexpr ErrorCode chainForked{
    "chain_forked", ErrorKind::InputRejected,
    LT_TEXT("Engine",
            "The rows of the writer {writer} differ from row {sequence} on: a copy of the archive was continued in two "
            "places. {location} was left as it is.")};

inline constexpr ErrorCode recipeContradicts{
    "recipe_contradicts", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The recipe {sha256} is in the archive with another content.")};

inline constexpr ErrorCode textNotStorable{
    "text_not_storable", ErrorKind::InputRejected,
    LT_TEXT("Engine", "{name} cannot be kept: expected UTF-8 without the character 0, of a result JSON.")};

inline constexpr ErrorCode evaluationNotFound{"evaluation_not_found", ErrorKind::NoAnswer,
                                              LT_TEXT("Engine", "The archive holds no evaluation {uuid}.")};

inline constexpr ErrorCode evaluationAmbiguous{
    "evaluation_ambiguous", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "Several evaluations begin with {uuid}; expected {expected}.")};

inline constexpr ErrorCode alreadySuperseded{
    "already_superseded", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "The evaluation {uuid} is superseded by {superseded_by} already.")};

inline constexpr ErrorCode reasonMissing{
    "reason_missing", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "Who replaces an evaluation states why: the reason is missing.")};

inline constexpr ErrorCode characteristicNotFound{"characteristic_not_found", ErrorKind::NoAnswer,
                                                  LT_TEXT("Engine", "The archive holds no value of {characteristic}.")};

inline constexpr ErrorCode characteristicAmbiguous{
    "characteristic_ambiguous", ErrorKind::WrongUsage,
    LT_TEXT("Engine", "{characteristic} is a characteristic of several tasks or units: {found}. State one.")};

inline constexpr ErrorCode lineTorn{
    "line_torn", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The last line has no end: the file was cut. Its first characters are “{found}”.")};

inline constexpr ErrorCode countOfEvaluations{
    "count_of_evaluations", ErrorKind::InputRejected,
    LT_TEXT("Engine", "One evaluation takes the place of another; found {found}.")};

}  // namespace errors

namespace notes {

inline constexpr NoteCode chainBroken{
    "chain_broken", Severity::Warning,
    LT_TEXT("Engine",
            "The archive {location} was altered: the row {sequence} of the writer {writer} is broken ({fault}).")};

inline constexpr NoteCode archiveRolesMissing{
    "archive_roles_missing", Severity::Warning,
    LT_TEXT("Engine",
            "{location}: this role may not make the group roles {roles}. An administrator makes them and grants them "
            "what they may do.")};

}  // namespace notes

}  // namespace lathelier
