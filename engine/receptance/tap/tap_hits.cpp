#include "engine/receptance/tap/tap_hits.h"

#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/receptance/tap/tap_codes.h"
#include "engine/signal/fourier.h"

namespace lathelier::receptance {
namespace {

constexpr double oneHit_s = 0.25;         ///< pulses nearer than this belong to one hit, where no block is stated
constexpr double longestBlock_s = 2;      ///< where none is stated
constexpr double blockOfGap = 0.95;       ///< share of the shortest distance of hits
constexpr double preTriggerShare = 0.02;  ///< of the block
constexpr std::size_t leastBlock = 64;    ///< samples
constexpr double overNoise = 6;           ///< standard deviations: the least level and pulse
constexpr double leastEnergy = 0.04;      ///< of that of the strongest hit: a fifth of its force
constexpr std::size_t samplesPerCheck = 1 << 16;

struct Pulse {
    std::size_t record, sample;
};

/// Samples at which the force passes the level, once for each pulse.
std::vector<Pulse> pulsesOf(const std::vector<TapSignals>& records, const std::vector<ForceFacts>& facts,
                            const Progress& progress)
{
    std::vector<Pulse> pulses;
    for (std::size_t r = 0; r < records.size(); ++r) {
        bool is_above = false;
        for (std::size_t i = 0; i < records[r].force_N.size(); ++i) {
            if (i % samplesPerCheck == 0) progress.check();
            const double force = std::abs(records[r].force_N[i] - facts[r].rest_N);
            if (!is_above && force >= facts[r].level_N) pulses.push_back({r, i});
            is_above = force >= (is_above ? 0.5 : 1.0) * facts[r].level_N;
        }
    }
    return pulses;
}

/// The longest block in samples that leaves hits apart: at most the shortest distance of those of one record, and what
/// is behind the last one where that is at least half of it.
double usualBlock(const std::vector<TapSignals>& records, const std::vector<Pulse>& pulses)
{
    const double apart = oneHit_s * records.front().rate_hz;
    double least_gap = longestBlock_s * records.front().rate_hz;
    bool has_gap = false;
    std::vector<double> tails;
    for (std::size_t k = 0; k < pulses.size();) {
        const std::size_t record = pulses[k].record;
        std::size_t last = k++;
        for (; k < pulses.size() && pulses[k].record == record; ++k) {
            const auto gap = static_cast<double>(pulses[k].sample - pulses[last].sample);
            if (gap < apart) continue;
            least_gap = std::min(least_gap, blockOfGap * gap);
            has_gap = true;
            last = k;
        }
        tails.push_back(static_cast<double>(records[record].force_N.size() - pulses[last].sample));
    }
    if (!has_gap) return std::min(least_gap, *std::min_element(tails.begin(), tails.end()));
    double block = least_gap;
    for (const double tail : tails)
        if (tail >= 0.5 * least_gap) block = std::min(block, tail);
    return block;
}

/// The largest even number up to `most` without a prime factor above 5.
std::size_t quickLength(std::size_t most)
{
    std::size_t length = most - most % 2;
    while (length > leastBlock && signal::quickTransformLength(length) != length) length -= 2;
    return length;
}

TapBlock blockOf(const std::vector<TapSignals>& records, const std::vector<Pulse>& pulses,
                 const TapParameters& parameters)
{
    const double rate = records.front().rate_hz;
    TapBlock block;
    const double wanted = parameters.block_s ? *parameters.block_s * rate : usualBlock(records, pulses);
    std::size_t longest = 0;
    for (const TapSignals& record : records) longest = std::max(longest, record.force_N.size());
    const auto samples = static_cast<std::size_t>(std::clamp(wanted + 1e-6, 0.0, static_cast<double>(longest)));
    if (samples < leastBlock)
        throw Error(errors::tapBlockTooShort, {{"samples", static_cast<std::int64_t>(samples)},
                                               {"minimum", static_cast<std::int64_t>(leastBlock)}});
    block.samples = parameters.block_s ? samples - samples % 2 : quickLength(samples);
    const auto length = static_cast<double>(block.samples);
    const double before = parameters.pre_trigger_s ? *parameters.pre_trigger_s * rate : preTriggerShare * length;
    block.before = static_cast<std::size_t>(std::min(std::round(before), length / 2));
    return block;
}

/// The pulse of a hit within its block, and a second one: the force rises again by more than `least`, from a valley no
/// lower than rest.
void judgePulse(const TapSignals& record, const ForceFacts& facts, std::size_t end, double least_percent, TapHit& hit)
{
    const auto magnitude = [&](std::size_t i, double sign) { return sign * (record.force_N[i] - facts.rest_N); };
    std::size_t top = hit.trigger;
    for (std::size_t i = hit.first; i < end; ++i)
        if (std::abs(magnitude(i, 1)) > std::abs(magnitude(top, 1))) top = i;
    hit.peak_N = magnitude(top, 1);
    const double sign = hit.peak_N < 0 ? -1 : 1;
    const double peak = std::abs(hit.peak_N);
    const double least = std::max(least_percent / 100 * peak, overNoise * facts.noise_N);
    hit.pulse_end = top;
    while (hit.pulse_end < end && magnitude(hit.pulse_end, sign) > least) ++hit.pulse_end;
    double largest_rise = least;
    std::size_t second = top;
    const auto look = [&](std::size_t i, double& valley) {
        valley = std::max(0.0, std::min(valley, magnitude(i, sign)));
        if (const double rise = magnitude(i, sign) - valley; rise > largest_rise) {
            largest_rise = rise;
            second = i;
        }
    };
    double valley = peak;
    for (std::size_t i = top; i < end; ++i) look(i, valley);
    valley = peak;
    for (std::size_t i = top; i-- > hit.first;) look(i, valley);
    if (second == top) return;
    hit.second_percent = 100 * largest_rise / peak;
    hit.second_s = record.start_s + static_cast<double>(second) / record.rate_hz;
    hit.fault = HitFault::DoubleHit;
    for (std::size_t i = hit.pulse_end; i < end; ++i)
        if (magnitude(i, sign) > least) hit.pulse_end = i + 1;
}

void judgeOverload(const TapSignals& record, std::size_t end, TapHit& hit)
{
    const auto inBlock = [&](const std::vector<double>& values) {
        return std::span<const double>(values).subspan(hit.first, end - hit.first);
    };
    char at_limit = 0;
    if (!record.at_limit.empty())
        for (std::size_t i = hit.first; i < end; ++i) at_limit = static_cast<char>(at_limit | record.at_limit[i]);
    if ((at_limit & 1) != 0 || hasFlatTop(inBlock(record.force_N)))
        hit.fault = HitFault::OverloadForce;
    else if ((at_limit & 2) != 0 || hasFlatTop(inBlock(record.motion)))
        hit.fault = HitFault::OverloadResponse;
}

/// Hits of much less energy than the strongest have more noise than signal to add.
void judgeEnergy(const std::vector<TapSignals>& records, FoundHits& found)
{
    std::vector<double> energies;
    for (const TapHit& hit : found.hits) {
        const std::vector<double>& force = records[hit.record].force_N;
        const double rest = found.facts[hit.record].rest_N;
        const std::size_t end = std::min(force.size(), hit.first + found.block.samples);
        double energy = 0;
        for (std::size_t i = hit.first; i < end; ++i) energy += (force[i] - rest) * (force[i] - rest);
        energies.push_back(energy);
    }
    const double largest = *std::max_element(energies.begin(), energies.end());
    for (std::size_t k = 0; k < energies.size(); ++k)
        if (energies[k] < leastEnergy * largest && found.hits[k].fault == HitFault::None)
            found.hits[k].fault = HitFault::Weak;
}

[[noreturn]] void throwNoHit(const std::vector<ForceFacts>& facts)
{
    const auto largest = std::max_element(
        facts.begin(), facts.end(), [](const ForceFacts& a, const ForceFacts& b) { return a.largest_N < b.largest_N; });
    throw Error(errors::tapNoHit, {{"largest_N", largest->largest_N}, {"level_N", largest->level_N}});
}

}  // namespace

ForceFacts factsOfForce(std::span<const double> force_N, double trigger_percent)
{
    ForceFacts facts;
    std::vector<double> sorted(force_N.begin(), force_N.end());
    facts.rest_N = upperMedianInPlace(sorted);
    for (double& force : sorted) force = std::abs(force - facts.rest_N);
    facts.largest_N = sorted.empty() ? 0 : *std::max_element(sorted.begin(), sorted.end());
    facts.noise_N = sorted.empty() ? 0 : madToSigma * upperMedianInPlace(sorted);
    facts.level_N = std::max(trigger_percent / 100 * facts.largest_N, overNoise * facts.noise_N);
    return facts;
}

FoundHits findHits(const std::vector<TapSignals>& records, const TapParameters& parameters, const Progress& progress)
{
    FoundHits found;
    for (const TapSignals& record : records) {
        progress.check();
        found.facts.push_back(factsOfForce(record.force_N, parameters.trigger_percent));
    }
    std::vector<Pulse> pulses = pulsesOf(records, found.facts, progress);
    std::erase_if(pulses, [&](const Pulse& pulse) { return !(found.facts[pulse.record].largest_N > 0); });
    if (pulses.empty()) throwNoHit(found.facts);
    found.block = blockOf(records, pulses, parameters);
    for (const Pulse& pulse : pulses) {
        progress.check();
        const TapSignals& record = records[pulse.record];
        if (!found.hits.empty() && found.hits.back().record == pulse.record &&
            pulse.sample < found.hits.back().first + found.block.samples)
            continue;
        TapHit& hit = found.hits.emplace_back();
        hit.record = pulse.record;
        hit.trigger = pulse.sample;
        hit.first = pulse.sample - std::min(pulse.sample, found.block.before);
        hit.time_s = record.start_s + static_cast<double>(pulse.sample) / record.rate_hz;
        const std::size_t end = std::min(record.force_N.size(), hit.first + found.block.samples);
        judgePulse(record, found.facts[pulse.record], end, parameters.double_hit_percent, hit);
        judgeOverload(record, end, hit);
        if (hit.first + found.block.samples > record.force_N.size()) hit.fault = HitFault::Incomplete;
    }
    judgeEnergy(records, found);
    for (TapHit& hit : found.hits)
        hit.used = hit.fault == HitFault::None || (parameters.keep_rejected && hit.fault != HitFault::Incomplete);
    return found;
}

}  // namespace lathelier::receptance
