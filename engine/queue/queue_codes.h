// Errors of the queue of a batch: codes with their English patterns.
#pragma once

#include "engine/core/error.h"

namespace lathelier::errors {

inline constexpr ErrorCode queueRecipeChanged{
    "queue_recipe_changed", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The recipe is another one than when the part was queued: {found}, expected {expected}.")};

inline constexpr ErrorCode queuePartChanged{
    "queue_part_changed", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The files of the part have another content than when it was queued.")};

inline constexpr ErrorCode queueWorkerLost{
    "queue_worker_lost", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "{tries} workers were lost while they worked on this part; the last was {worker}.")};

inline constexpr ErrorCode queuePartsFailed{
    "queue_parts_failed", ErrorKind::InputRejected,
    LT_TEXT("Engine", "Parts without an answer: {failed}; the list of failures says why.")};

}  // namespace lathelier::errors
