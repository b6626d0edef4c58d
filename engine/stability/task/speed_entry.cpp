#include "engine/stability/task/speed_entry.h"

#include <algorithm>

#include "engine/core/units.h"
#include "engine/stability/task/speed_task.h"

namespace lathelier::stability {
namespace {

constexpr const char* rangeKey = "range_m_min";
constexpr Interval anySpeed{1e-3, 1e5};  ///< an end that is not stated

Interval rangeOf(const Values& parameters)
{
    const Value* const value = find(parameters, rangeKey);
    const auto* const ranges = value ? std::get_if<std::vector<Interval>>(value) : nullptr;
    return ranges && !ranges->empty() ? ranges->front() : anySpeed;
}

FieldInfo endOf(const char* key, Text label)
{
    FieldInfo info;
    for (const FieldInfo& known : infos<SpeedQuestion>())
        if (known.key == cuttingSpeedKey) info = known;
    info.key = key;
    info.label = label;
    info.help = LT_TEXT("Engine", "That the tool allows.");
    return info;
}

}  // namespace

std::vector<FieldInfo> screenFields()
{
    std::vector<FieldInfo> asked;
    for (const char* key : {diameterKey, barLengthKey, cuttingSpeedKey})
        for (const FieldInfo& info : infos<SpeedQuestion>())
            if (info.key == key) asked.push_back(info);
    asked.push_back(endOf(lowestKey, LT_TEXT("Engine", "Least cutting speed")));
    asked.push_back(endOf(highestKey, LT_TEXT("Engine", "Greatest cutting speed")));
    return asked;
}

Values screenValues(const Values& parameters)
{
    Values shown = parameters;
    const Interval range = rangeOf(parameters);
    set(shown, lowestKey, range.from == anySpeed.from ? Value() : Value(range.from));
    set(shown, highestKey, range.to == anySpeed.to ? Value() : Value(range.to));
    return shown;
}

void enterValue(Values& parameters, const std::string& key, const Value& value)
{
    if (key != lowestKey && key != highestKey) return set(parameters, key, value);
    const bool is_lowest = key == lowestKey;
    const auto* const number = std::get_if<double>(&value);
    Interval range = rangeOf(parameters);
    (is_lowest ? range.from : range.to) = number ? *number : is_lowest ? anySpeed.from : anySpeed.to;
    set(parameters, rangeKey, range == anySpeed ? std::vector<Interval>{} : std::vector<Interval>{range});
}

}  // namespace lathelier::stability
