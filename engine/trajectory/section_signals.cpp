#include "engine/trajectory/section_signals.h"

#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/signal/hampel.h"

namespace lathelier::trajectory {
namespace {

constexpr std::size_t fewestForRule = 5;

struct Spread {
    double median = notANumber;
    double sigma = notANumber;
};

void keepFinite(std::vector<double>& values)
{
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
}

/// Values of all revolutions at one angle.
std::vector<double> column(const SectionSignals& signals, std::size_t probe, std::size_t i)
{
    std::vector<double> values(signals.revolutions());
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = signals.at(probe, k, i);
    keepFinite(values);
    return values;
}

/// Median distance of one revolution from the curve.
template <class Distance>
double medianDistance(const SectionSignals& signals, std::size_t probe, std::size_t k, Distance distance)
{
    std::vector<double> away(signals.points);
    for (std::size_t i = 0; i < signals.points; ++i) away[i] = distance(signals.at(probe, k, i), i);
    keepFinite(away);
    return median(std::move(away));
}

/// Medians and robust standard deviations at each angle. With few revolutions a single MAD may be small by chance: it
/// is bounded below by half the typical one.
std::vector<Spread> spreads(const SectionSignals& signals, std::size_t probe)
{
    std::vector<Spread> result(signals.points);
    std::vector<double> sigmas;
    for (std::size_t i = 0; i < signals.points; ++i) {
        const std::vector<double> values = column(signals, probe, i);
        result[i] = {median(values), signal::robustSpread(values)};
        if (!values.empty()) sigmas.push_back(result[i].sigma);
    }
    const double typical = median(std::move(sigmas));
    for (Spread& spread : result) spread.sigma = std::max(spread.sigma, typical / 2);
    return result;
}

void keepMarked(SectionSignals& signals, const std::vector<bool>& keep)
{
    std::size_t kept = 0;
    for (std::size_t k = 0; k < keep.size(); ++k) {
        if (!keep[k]) continue;
        if (kept != k) {
            for (std::size_t probe = 0; probe < signals.um.size(); ++probe)
                for (std::size_t i = 0; i < signals.points; ++i) signals.at(probe, kept, i) = signals.at(probe, k, i);
            signals.numbers[kept] = signals.numbers[k];
        }
        ++kept;
    }
    signals.numbers.resize(kept);
    for (auto& values : signals.um) values.resize(kept * signals.points);
}

}  // namespace

SectionSignals resample(const io::ProbeRecord& record, const FrameClock& clock, const ChannelMap& map,
                        const Revolutions& revolutions, std::span<const Revolution> chosen, std::size_t points,
                        double channel_skew_s)
{
    constexpr double missingShare = 0.1;
    SectionSignals signals;
    signals.points = points;
    for (auto& values : signals.um) values.resize(chosen.size() * points);
    std::vector<bool> keep(chosen.size(), true);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        signals.numbers.push_back(chosen[k].number);
        std::array<std::size_t, 4> missing{};
        for (std::size_t i = 0; i < points; ++i) {
            const double time_s =
                revolutions.timeAt(clock, chosen[k], static_cast<double>(i) / static_cast<double>(points));
            for (std::size_t probe = 0; probe < map.probes.size(); ++probe) {
                const ProbePlace& place = map.probes[probe];
                const double value = clock.valueAt(record.channels[place.channel].values,
                                                   time_s - static_cast<double>(place.channel) * channel_skew_s);
                signals.at(probe, k, i) = place.um_per_value * value;
                missing[probe] += !std::isfinite(value);
            }
        }
        for (const std::size_t count : missing)
            if (static_cast<double>(count) > missingShare * static_cast<double>(points)) keep[k] = false;
    }
    keepMarked(signals, keep);
    return signals;
}

std::array<double, 4> driftPerRevolution_um(const SectionSignals& signals)
{
    std::array<double, 4> drift{};
    const std::size_t count = signals.revolutions();
    if (count < 2) return drift;
    for (std::size_t probe = 0; probe < drift.size(); ++probe) {
        std::vector<double> middle(signals.points);
        for (std::size_t i = 0; i < signals.points; ++i) middle[i] = median(column(signals, probe, i));
        double sum_k = 0, sum_y = 0, sum_kk = 0, sum_ky = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const double x = static_cast<double>(signals.numbers[k] - signals.numbers.front());
            const double y =
                medianDistance(signals, probe, k, [&](double value, std::size_t i) { return value - middle[i]; });
            sum_k += x;
            sum_y += y;
            sum_kk += x * x;
            sum_ky += x * y;
        }
        const auto n = static_cast<double>(count);
        drift[probe] = (sum_ky - sum_k * sum_y / n) / (sum_kk - sum_k * sum_k / n);
    }
    return drift;
}

void removeDrift(SectionSignals& signals, const std::array<double, 4>& drift_um)
{
    const std::size_t count = signals.revolutions();
    if (count == 0) return;
    double middle = 0.5 - 0.5 / static_cast<double>(signals.points);
    for (const std::int64_t number : signals.numbers)
        middle += static_cast<double>(number) / static_cast<double>(count);
    for (std::size_t probe = 0; probe < drift_um.size(); ++probe)
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t i = 0; i < signals.points; ++i) {
                const double turn = static_cast<double>(signals.numbers[k]) +
                                    static_cast<double>(i) / static_cast<double>(signals.points);
                signals.at(probe, k, i) -= drift_um[probe] * (turn - middle);
            }
}

Rejected rejectOutliers(SectionSignals& signals, double sigmas)
{
    Rejected rejected;
    if (signals.revolutions() < fewestForRule) return rejected;

    std::vector<bool> keep(signals.revolutions(), true);
    for (std::size_t probe = 0; probe < signals.um.size(); ++probe) {
        const std::vector<Spread> spread = spreads(signals, probe);
        std::vector<double> distance(signals.revolutions());
        for (std::size_t k = 0; k < distance.size(); ++k)
            distance[k] = medianDistance(
                signals, probe, k, [&](double value, std::size_t i) { return std::abs(value - spread[i].median); });
        const Spread typical{median(distance), signal::robustSpread(distance)};
        for (std::size_t k = 0; k < distance.size(); ++k)
            if (distance[k] > typical.median + sigmas * typical.sigma && distance[k] > 2 * typical.median)
                keep[k] = false;
    }
    rejected.revolutions = std::count(keep.begin(), keep.end(), false);
    keepMarked(signals, keep);
    if (signals.revolutions() < fewestForRule) return rejected;

    for (std::size_t probe = 0; probe < signals.um.size(); ++probe) {
        const std::vector<Spread> spread = spreads(signals, probe);
        for (std::size_t k = 0; k < signals.revolutions(); ++k)
            for (std::size_t i = 0; i < signals.points; ++i) {
                double& value = signals.at(probe, k, i);
                if (!(std::abs(value - spread[i].median) > sigmas * spread[i].sigma) || spread[i].sigma == 0) continue;
                value = notANumber;
                ++rejected.samples;
            }
    }
    return rejected;
}

}  // namespace lathelier::trajectory
