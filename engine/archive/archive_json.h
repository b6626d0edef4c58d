// Values and characteristics of an archive as the command line gives them: what is not stated is null.
#pragma once

#include "engine/archive/archive.h"

namespace lathelier::archive {

Json toJson(const SeriesPoint& point);
Json toJson(const ArchivedCharacteristic& characteristic);

/// Null for an empty text.
Json textOrNothing(const std::string& text);

}  // namespace lathelier::archive
