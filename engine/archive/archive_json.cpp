#include "engine/archive/archive_json.h"

#include <nlohmann/json.hpp>

#include "engine/core/verdict_json.h"

namespace lathelier::archive {

Json textOrNothing(const std::string& text)
{
    return text.empty() ? Json(nullptr) : Json(text);
}

Json toJson(const SeriesPoint& point)
{
    return {{"uuid", point.uuid},
            {"recorded_at", point.recorded_at},
            {"file", textOrNothing(point.file)},
            {"value", number(point.value)},
            {"expanded_uncertainty", number(point.expanded_uncertainty)},
            {"lower_limit", number(point.lower_limit)},
            {"upper_limit", number(point.upper_limit)},
            {"verdict", verdictJson(point.verdict)}};
}

Json toJson(const ArchivedCharacteristic& characteristic)
{
    return {{"task", characteristic.task},
            {"key", characteristic.key},
            {"unit", characteristic.unit},
            {"last_recorded_at", textOrNothing(characteristic.last_recorded_at)}};
}

}  // namespace lathelier::archive
