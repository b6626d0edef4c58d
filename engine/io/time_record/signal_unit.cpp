#include "engine/io/time_record/signal_unit.h"

#include <algorithm>
#include <cmath>

#include "engine/io/frf/frf_unit.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

constexpr double millivolt_V = 1e-3;
constexpr double microvolt_V = 1e-6;

std::optional<SignalUnit> voltage(std::string_view text)
{
    const std::string word = lowerCase(trimmed(text));
    using Of = SignalUnit::Kind;
    if (word == "v" || word == "volt" || word == "volts") return SignalUnit{Of::Voltage, 1};
    if (word == "mv") return SignalUnit{Of::Voltage, millivolt_V};
    if (word == "uv" || word == "µv" || word == "μv") return SignalUnit{Of::Voltage, microvolt_V};
    return std::nullopt;
}

/// A force or a motion.
std::optional<SignalUnit> mechanical(std::string_view text)
{
    const auto unit = physicalUnit(text);
    if (!unit) return std::nullopt;
    using Of = SignalUnit::Kind;
    if (unit->force == 1 && unit->length == 0 && unit->time == 0) return SignalUnit{Of::Force, unit->scale};
    if (unit->force != 0 || unit->length != 1) return std::nullopt;
    if (unit->time == 0) return SignalUnit{Of::Displacement, unit->scale};
    if (unit->time == -1) return SignalUnit{Of::Velocity, unit->scale};
    if (unit->time == -2) return SignalUnit{Of::Acceleration, unit->scale};
    return std::nullopt;
}

bool isSplit(char c)
{
    return std::string_view("_ ,:").find(c) != std::string_view::npos;
}

}  // namespace

std::optional<SignalUnit> signalUnit(std::string_view text)
{
    if (const auto volts = voltage(text)) return volts;
    return mechanical(text);
}

SignalHeading parseSignalHeading(std::string_view heading)
{
    heading = trimmed(heading);
    const std::size_t open = heading.find_first_of("([");
    if (open != std::string_view::npos && open > 0 && (heading.back() == ')' || heading.back() == ']')) {
        const std::string_view inside = heading.substr(open + 1, heading.size() - open - 2);
        return {std::string(trimmed(heading.substr(0, open))), signalUnit(inside), std::string(trimmed(inside))};
    }
    // From the left, so that the longest unit is found: "acc_m_s2" ends with m/s², not with s².
    for (std::size_t at = 1; at + 1 < heading.size(); ++at) {
        if (!isSplit(heading[at])) continue;
        std::string unit(trimmed(heading.substr(at + 1)));
        std::replace(unit.begin(), unit.end(), '_', '/');
        if (auto known = signalUnit(unit)) return {std::string(trimmed(heading.substr(0, at))), known, std::move(unit)};
    }
    return {std::string(heading), std::nullopt, {}};
}

std::optional<Sensitivity> sensitivityOf(std::string_view text)
{
    text = trimmed(text);
    double value = 0;
    const char* const end = text.data() + text.size();
    const char* const after = text.empty() ? nullptr : parseNumber(text.data(), end, '.', value);
    if (!after || !std::isfinite(value) || value == 0) return std::nullopt;
    const std::string_view unit = trimmed(text.substr(static_cast<std::size_t>(after - text.data())));
    if (const auto plain = mechanical(unit)) return Sensitivity{{plain->kind, value * plain->scale}, false};
    const std::size_t first = unit.find('/');
    const std::size_t last = unit.rfind('/');
    if (first == std::string_view::npos) return std::nullopt;
    const auto volts_per = voltage(unit.substr(0, first));
    if (const auto quantity = mechanical(unit.substr(first + 1)); volts_per && quantity)
        return Sensitivity{{quantity->kind, quantity->scale / (value * volts_per->scale)}, true};
    const auto per_volt = voltage(unit.substr(last + 1));
    if (const auto quantity = mechanical(unit.substr(0, last)); per_volt && quantity)
        return Sensitivity{{quantity->kind, value * quantity->scale / per_volt->scale}, true};
    return std::nullopt;
}

}  // namespace lathelier::io
