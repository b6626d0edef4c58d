// The time of today in the one form that archives and logs keep.
#pragma once

#include <string>

namespace lathelier {

/// UTC with milliseconds, ISO 8601: "2026-11-29T08:15:30.250Z".
std::string utcNow();

}  // namespace lathelier
