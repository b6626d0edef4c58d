#include "engine/receptance/frf_checks.h"

#include <algorithm>
#include <cmath>

#include "engine/io/frf/frf_choice.h"
#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_sense.h"
#include "engine/receptance/receptance_codes.h"

namespace lathelier::receptance {
namespace {

constexpr double standsOut = 2.5;       ///< least ratio of a resonance peak to the lowest lines on both sides
constexpr double belowResonance = 0.4;  ///< share of the resonance frequency below which its dynamic amplification is
                                        ///< small
constexpr std::size_t fewestSlopeLines = 6;
constexpr double leastSpan = 2;         ///< least ratio of last to first frequency
constexpr double mostUncertain = 0.15;  ///< largest standard uncertainty of the power
constexpr double nearPower = 0.35;      ///< largest distance of a slope from an integer power
constexpr double mostActive_percent = 50;
constexpr int smoothing = 2;  ///< lines averaged on either side

/// Logarithms of the magnitude above 0 Hz, smoothed.
struct LogLines {
    std::vector<double> frequency_hz, raw, smooth;
};

LogLines logLines(const Frf& frf)
{
    LogLines lines;
    for (std::size_t i = 0; i < frf.value.size(); ++i) {
        if (!(frf.frequency_hz[i] > 0) || !(std::abs(frf.value[i]) > 0)) continue;
        lines.frequency_hz.push_back(frf.frequency_hz[i]);
        lines.raw.push_back(std::log(std::abs(frf.value[i])));
    }
    const auto count = static_cast<int>(lines.raw.size());
    lines.smooth.reserve(lines.raw.size());
    for (int i = 0; i < count; ++i) {
        const int from = std::max(0, i - smoothing), to = std::min(count - 1, i + smoothing);
        double sum = 0;
        for (int j = from; j <= to; ++j) sum += lines.raw[static_cast<std::size_t>(j)];
        lines.smooth.push_back(sum / (to - from + 1));
    }
    return lines;
}

/// The first significant peak.
std::optional<std::size_t> firstResonance(const std::vector<double>& log_size)
{
    const double rise = std::log(standsOut);
    double lowest = HUGE_VAL, highest = -HUGE_VAL;
    std::size_t at = 0;
    for (std::size_t i = 0; i < log_size.size(); ++i) {
        if (log_size[i] > highest) {
            highest = log_size[i];
            at = i;
        }
        if (log_size[i] < highest - rise && highest > lowest + rise) return at;
        if (log_size[i] < lowest) {
            lowest = log_size[i];
            if (highest < lowest + rise) highest = lowest;
        }
        if (highest < lowest + rise && log_size[i] <= lowest) highest = lowest, at = i;
    }
    return std::nullopt;
}

int powerOf(FrfQuantity quantity)
{
    return quantity == FrfQuantity::Receptance ? 0 : quantity == FrfQuantity::Mobility ? 1 : 2;
}

Text nameOf(int power)
{
    return power == 0   ? LT_TEXT("Engine", "a receptance")
           : power == 1 ? LT_TEXT("Engine", "a mobility")
                        : LT_TEXT("Engine", "an accelerance");
}

/// Whether a response of this power, of a constrained or free structure, has this slope.
bool allows(int power, double slope)
{
    return std::abs(slope - power) < nearPower || std::abs(slope - (power - 2)) < nearPower;
}

}  // namespace

std::optional<LowSlope> lowSlope(const Frf& frf)
{
    const LogLines lines = logLines(frf);
    const auto resonance = firstResonance(lines.smooth);
    if (!resonance) return std::nullopt;
    const double end = belowResonance * lines.frequency_hz[*resonance];
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (std::size_t i = 0; i < lines.raw.size() && lines.frequency_hz[i] <= end; ++i) {
        const double lx = std::log(lines.frequency_hz[i]), ly = lines.raw[i];
        n += 1;
        x += lx;
        y += ly;
        xx += lx * lx;
        xy += lx * ly;
        yy += ly * ly;
    }
    if (n < static_cast<double>(fewestSlopeLines) || end < leastSpan * lines.frequency_hz.front()) return std::nullopt;
    const double sxx = xx - x * x / n, sxy = xy - x * y / n, syy = yy - y * y / n;
    const double power = sxy / sxx, variance = std::max(0.0, syy - power * sxy) / (n - 2);
    if (std::sqrt(variance / sxx) > mostUncertain) return std::nullopt;
    return LowSlope{power, {lines.frequency_hz.front(), end}};
}

Notes checkResponse(const io::MeasuredFrf& measured, const std::string& path)
{
    Notes notes;
    const Frf& frf = measured.frf;
    const int stated = powerOf(frf.quantity);
    if (const auto slope = lowSlope(frf); slope && !allows(stated, slope->power))
        for (const int other : {2, 1, 0}) {
            if (other == stated || !allows(other, slope->power)) continue;
            notes.push_back({notes::frfSlopeContradictsLabel,
                             {{"path", path},
                              {"stated", nameOf(stated)},
                              {"slope", std::round(10 * slope->power) / 10},
                              {"to_hz", std::round(10 * slope->range_hz.to) / 10},
                              {"found", nameOf(other)}}});
            break;
        }
    if (io::isDrivingPoint(measured)) return notes;
    const io::FrfSense sense = io::senseOf(frf);
    const std::string name = io::responseName(measured);
    const Values where{{"path", path},
                       {"response", name.empty() ? frf.name : name},
                       {"frequency_hz", std::round(10 * sense.frequency_hz) / 10}};
    if (sense.is_conjugated.value_or(false)) notes.push_back({notes::frfConjugated, where});
    if (!name.empty()) return notes;
    const double active_percent = io::activeLines_percent(frf);
    // A wrong kind of motion turns the sign as well.
    const bool is_kind_right = !contains(notes, notes::frfSlopeContradictsLabel);
    if (is_kind_right && sense.is_turned.value_or(false))
        notes.push_back({notes::frfTurned, where});
    else if (!sense.is_conjugated.value_or(false) && active_percent > mostActive_percent)
        notes.push_back(
            {notes::frfPowerGivenAway, {{"path", path}, {"percent", std::round(10 * active_percent) / 10}}});
    return notes;
}

}  // namespace lathelier::receptance
