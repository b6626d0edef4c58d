#include "engine/registration/verdict/zone_limits.h"

#include <algorithm>

#include "engine/core/core_codes.h"
#include "engine/io/json/json_fields.h"

namespace lathelier::registration {
namespace {

constexpr std::size_t mostZones = 1000;  // as the field `zones` says (compare_parameters.cpp)

/// The fault of a zone and the key concerned; empty key: no fault.
struct Fault {
    const char* key = nullptr;
    Text expected;
};

Fault faultOf(const ZoneLimits& zone)
{
    if (!(zone.z_end_mm > zone.z_start_mm)) return {"z_end_mm", LT_TEXT("Engine", "an end beyond the zone's start")};
    if (zone.lower_mm.has_value() != zone.upper_mm.has_value())
        return {zone.lower_mm ? "upper_mm" : "lower_mm",
                LT_TEXT("Engine", "both limits, or null for both (the zone is left out)")};
    if (zone.lower_mm && *zone.lower_mm > *zone.upper_mm)
        return {"lower_mm", LT_TEXT("Engine", "a lower limit not above the upper one")};
    return {};
}

Fault faultOf(const ZoneLimits& zone, const std::vector<ZoneLimits>& others)
{
    const Fault alone = faultOf(zone);
    if (alone.key) return alone;
    const bool overlaps = std::any_of(others.begin(), others.end(), [&](const ZoneLimits& other) {
        return zone.z_start_mm < other.z_end_mm && other.z_start_mm < zone.z_end_mm;
    });
    if (overlaps) return {"z_start_mm", LT_TEXT("Engine", "a zone that overlaps no other")};
    return {};
}

void sortZones(std::vector<ZoneLimits>& zones)
{
    std::sort(zones.begin(), zones.end(),
              [](const ZoneLimits& a, const ZoneLimits& b) { return a.z_start_mm < b.z_start_mm; });
}

}  // namespace

std::vector<ZoneLimits> readZones(std::string json_text, Notes& notes)
{
    const io::JsonDocument document(std::move(json_text));
    std::vector<ZoneLimits> zones;
    document.root().items(mostZones, [&](const io::JsonCursor& item) {
        if (!item.isObject())
            item.reject(LT_TEXT("Engine", "an object with name, z_start_mm, z_end_mm, lower_mm, upper_mm"));
        const auto zone = io::readFields<ZoneLimits>(item, notes);
        const Fault fault = faultOf(zone, zones);
        if (fault.key) {
            const auto member = item.member(fault.key);
            (member ? *member : item).reject(fault.expected);
        }
        zones.push_back(zone);
    });
    sortZones(zones);
    return zones;
}

void checkZones(const std::vector<ZoneLimits>& zones)
{
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const Fault fault = faultOf(zones[i], {zones.begin(), zones.begin() + static_cast<std::ptrdiff_t>(i)});
        if (!fault.key) continue;
        const Value found = *find(toValues(zones[i]), fault.key);
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", std::string("zones.") + fault.key}, {"found", found}, {"expected", fault.expected}});
    }
}

}  // namespace lathelier::registration
