#include "engine/chain/step_results.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lathelier::chain {
namespace {

const Json& memberOf(const Json& json, const char* name)
{
    static const Json none;
    return json.is_object() && json.contains(name) ? json[name] : none;
}

std::optional<double> numberOf(const Json& json, const char* name)
{
    const Json& value = memberOf(json, name);
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

}  // namespace

PlannedProgram plannedProgram(const Json& result)
{
    PlannedProgram planned;
    planned.clampings = memberOf(result, "setups").size();
    for (const Json& section : memberOf(result, "sections")) {
        const auto start = numberOf(section, "z_start_mm"), end = numberOf(section, "z_end_mm");
        const auto diameter = numberOf(section, "diameter_mm"), speed = numberOf(section, "speed_rpm");
        if (start && end && diameter && speed) planned.sections.push_back({*start, *end, *diameter, *speed});
    }
    return planned;
}

std::optional<double> chatterFrequencyAt(const Json& result, double speed_rpm)
{
    const Json& limit = memberOf(result, "limit");
    const Json &speeds = memberOf(limit, "speed_rpm"), &frequencies = memberOf(limit, "frequency_hz");
    for (std::size_t i = 0; i + 1 < std::min(speeds.size(), frequencies.size()); ++i) {
        if (!speeds[i].is_number() || !speeds[i + 1].is_number()) continue;
        const double from = speeds[i], to = speeds[i + 1];
        if (!(from <= speed_rpm && speed_rpm <= to && from < to)) continue;
        const Json& nearest = frequencies[speed_rpm - from < to - speed_rpm ? i : i + 1];
        return nearest.is_number() ? std::optional(nearest.get<double>()) : std::nullopt;
    }
    return std::nullopt;
}

bool hasCorrection(const Json& result)
{
    return numberOf(result, "residual_max_um").has_value();
}

std::optional<ChatterMarks> chatterMarks(const Json& result)
{
    const Json& images = memberOf(result, "images");
    if (!images.is_array() || images.empty()) return std::nullopt;
    const Json& marks = memberOf(images.front(), "chatter_marks");
    const auto frequency = numberOf(marks, "frequency_hz"), uncertainty = numberOf(marks, "frequency_uncertainty_hz");
    return frequency && uncertainty ? std::optional(ChatterMarks{*frequency, *uncertainty}) : std::nullopt;
}

}  // namespace lathelier::chain
