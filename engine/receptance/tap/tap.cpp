#include "engine/receptance/tap/tap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/io/frf/frf_noise.h"
#include "engine/receptance/tap/tap_codes.h"
#include "engine/receptance/tap/tap_spectra.h"

namespace lathelier::receptance {
namespace {

constexpr double soundCoherence = 0.8;     ///< from which low lines are usable
constexpr std::size_t coherenceLines = 5;  ///< averaged for that
constexpr double mostLeft_percent = 3;     ///< rms at the end of a block, of the peak
constexpr std::size_t listedTimes = 12;

/// Times of the hits with one fault: "1.204, 3.518".
std::string timesOf(const std::vector<TapHit>& hits, HitFault fault, std::int64_t& count)
{
    std::string times;
    count = 0;
    for (const TapHit& hit : hits) {
        if (hit.fault != fault) continue;
        ++count;
        if (count <= static_cast<std::int64_t>(listedTimes))
            times += fmt::format("{}{:.4f}", count > 1 ? ", " : "", hit.time_s);
    }
    return count > static_cast<std::int64_t>(listedTimes) ? times + " …" : times;
}

void noteHits(TapResult& result)
{
    using enum HitFault;
    for (const HitFault fault : {DoubleHit, OverloadForce, OverloadResponse, Weak, Incomplete}) {
        std::int64_t count = 0;
        const std::string times = timesOf(result.hits, fault, count);
        if (count == 0) continue;
        const bool is_kept = result.parameters.keep_rejected && fault != Incomplete;
        result.notes.push_back({is_kept ? notes::tapHitsKept : notes::tapHitsRejected,
                                {{"count", count},
                                 {"of", static_cast<std::int64_t>(result.hits.size())},
                                 {"reason", words(fault)},
                                 {"times", times}}});
    }
    const bool is_negative =
        std::all_of(result.hits.begin(), result.hits.end(), [](const TapHit& hit) { return hit.peak_N < 0; });
    if (is_negative) result.notes.push_back({notes::tapForceNegative, {}});
}

/// Index behind the last line whose force is above the drop; three lines are averaged, so that noise does not end it.
std::size_t endOfForce(const TapSpectra& sums, double drop_dB)
{
    const std::size_t lines = sums.ff.size();
    double largest = 0;
    for (std::size_t k = 1; k < lines; ++k) largest = std::max(largest, sums.ff[k]);
    const double least = largest * std::pow(10.0, -drop_dB / 10);
    const std::size_t from =
        static_cast<std::size_t>(std::max_element(sums.ff.begin() + 1, sums.ff.end()) - sums.ff.begin());
    for (std::size_t k = from; k < lines; ++k) {
        const std::size_t low = k - 1, high = std::min(k + 1, lines - 1);
        if (sums.ff[low] + sums.ff[k] + sums.ff[high] < 3 * least) return k;
    }
    return lines;
}

/// The first line from which the coherence is sound; 1 where it is not known or never is.
std::size_t startOfCoherence(const std::vector<double>& coherence, std::size_t end)
{
    for (std::size_t k = 1; k + coherenceLines <= end && k + coherenceLines <= coherence.size(); ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < coherenceLines; ++i) sum += coherence[k + i];
        if (sum >= soundCoherence * coherenceLines) return k;
    }
    return 1;
}

/// The response at line k as displacement per force.
std::complex<double> estimateAt(const TapSpectra& sums, std::size_t k, double frequency_hz, const TapResult& result)
{
    const std::complex<double> ratio =
        result.parameters.estimator == TapEstimator::H1 ? sums.xf[k] / sums.ff[k] : sums.xx[k] / std::conj(sums.xf[k]);
    const std::complex<double> s(result.window_decay_1_s, turn_rad * frequency_hz);
    if (result.measured == FrfQuantity::Receptance) return ratio;
    return result.measured == FrfQuantity::Mobility ? ratio / s : ratio / (s * s);
}

void noteRange(TapResult& result, std::size_t from, std::size_t end, std::size_t lines)
{
    if (end < lines)
        result.notes.push_back({notes::tapForceRange,
                                {{"drop_dB", result.parameters.force_drop_db},
                                 {"usable_to_hz", result.usable_to_hz},
                                 {"lines", static_cast<std::int64_t>(lines - end)}}});
    if (from > 1)
        result.notes.push_back({notes::tapLowLines,
                                {{"usable_from_hz", result.usable_from_hz},
                                 {"limit", soundCoherence},
                                 {"lines", static_cast<std::int64_t>(from - 1)}}});
}

void noteWindow(TapResult& result, const TapSpectra& sums)
{
    if (result.window_decay_1_s > 0 && !result.response.value.empty()) {
        const auto largest = std::max_element(result.response.value.begin(), result.response.value.end(),
                                              [](const auto& a, const auto& b) { return std::norm(a) < std::norm(b); });
        const double at_hz =
            result.response.frequency_hz[static_cast<std::size_t>(largest - result.response.value.begin())];
        result.notes.push_back({notes::tapWindowDecay,
                                {{"window_decay_1_s", result.window_decay_1_s},
                                 {"frequency_hz", at_hz},
                                 {"added_percent", 100 * result.window_decay_1_s / (turn_rad * at_hz)}}});
    }
    if (result.window_decay_1_s == 0 && !sums.is_left_noise && sums.left_percent > mostLeft_percent)
        result.notes.push_back({notes::tapNotDecayed, {{"percent", sums.left_percent}}});
}

/// Leaves the lines of the range that was asked for. Errors valueNotUnderstood, tapNoLines.
void keepRange(TapResult& result, std::size_t& from, std::size_t& end)
{
    const std::vector<Interval>& ranges = result.parameters.range_hz;
    if (ranges.empty()) return;
    if (ranges.size() > 1)
        throw Error(errors::valueNotUnderstood, {{"parameter", "range_hz"},
                                                 {"found", ranges},
                                                 {"expected", LT_TEXT("Engine", "one range such as 100:1200")}});
    constexpr double rounding = 1e-9;
    const double first = std::ceil(ranges.front().from / result.resolution_hz - rounding);
    const double last = std::floor(ranges.front().to / result.resolution_hz + rounding);
    from = std::max(from, static_cast<std::size_t>(std::max(first, 0.0)));
    end = std::min(end, static_cast<std::size_t>(std::max(last, 0.0)) + 1);
    if (from < end) return;
    throw Error(errors::tapNoLines, {{"from_hz", ranges.front().from},
                                     {"to_hz", ranges.front().to},
                                     {"usable_from_hz", result.usable_from_hz},
                                     {"usable_to_hz", result.usable_to_hz}});
}

/// Lines, spectrum of the force, coherence and the response over the usable lines.
void takeLines(const TapSpectra& sums, TapResult& result)
{
    const std::size_t lines = sums.ff.size();
    const double largest = *std::max_element(sums.ff.begin() + 1, sums.ff.end());
    std::vector<double> coherence{0};
    for (std::size_t k = 1; k < lines; ++k) {
        result.frequency_hz.push_back(static_cast<double>(k) * result.resolution_hz);
        result.force_db.push_back(10 * std::log10(std::max(sums.ff[k] / largest, std::numeric_limits<double>::min())));
        const double both = sums.ff[k] * sums.xx[k];
        coherence.push_back(both > 0 ? std::min(1.0, std::norm(sums.xf[k]) / both) : 0);
    }
    std::size_t end = endOfForce(sums, result.parameters.force_drop_db);
    const bool is_judged = sums.count > 1;
    std::size_t from = is_judged ? startOfCoherence(coherence, end) : 1;
    const auto state = [&] {
        result.usable_from_hz = static_cast<double>(from) * result.resolution_hz;
        result.usable_to_hz = static_cast<double>(end - 1) * result.resolution_hz;
    };
    state();
    noteRange(result, from, end, lines);
    keepRange(result, from, end);
    state();
    for (std::size_t k = from; k < end; ++k) {
        const double frequency_hz = result.frequency_hz[k - 1];
        const std::complex<double> value = estimateAt(sums, k, frequency_hz, result);
        if (!std::isfinite(value.real()) || !std::isfinite(value.imag())) continue;
        result.response.frequency_hz.push_back(frequency_hz);
        result.response.value.push_back(value);
        if (is_judged) result.response.coherence.push_back(coherence[k]);
    }
    if (is_judged) result.coherence.assign(coherence.begin() + 1, coherence.end());
    result.response.noise = io::noiseOf(result.response);
}

}  // namespace

const char* key(HitFault fault)
{
    switch (fault) {
        case HitFault::DoubleHit: return "double_hit";
        case HitFault::OverloadForce: return "overload_force";
        case HitFault::OverloadResponse: return "overload_response";
        case HitFault::Weak: return "weak";
        case HitFault::Incomplete: return "incomplete";
        case HitFault::None: break;
    }
    return "";
}

Text words(HitFault fault)
{
    switch (fault) {
        case HitFault::DoubleHit: return LT_TEXT("Engine", "double hit");
        case HitFault::OverloadForce: return LT_TEXT("Engine", "force overloaded");
        case HitFault::OverloadResponse: return LT_TEXT("Engine", "response overloaded");
        case HitFault::Weak: return LT_TEXT("Engine", "too little energy");
        case HitFault::Incomplete: return LT_TEXT("Engine", "the record ends within the block");
        case HitFault::None: break;
    }
    return {};
}

TapResult evaluateTaps(const std::vector<TapSignals>& records, FrfQuantity measured, const TapParameters& parameters,
                       const Progress& progress)
{
    TapResult result;
    result.parameters = parameters;
    result.measured = measured;
    FoundHits found = findHits(records, parameters, progress.part(0, 0.3, LT_TEXT("Engine", "Finding hits")));
    result.hits = found.hits;
    const auto used = static_cast<std::size_t>(
        std::count_if(found.hits.begin(), found.hits.end(), [](const TapHit& hit) { return hit.used; }));
    if (used == 0)
        throw Error(errors::tapNoHitUsed, {{"count", static_cast<std::int64_t>(found.hits.size())},
                                           {"time_s", found.hits.front().time_s},
                                           {"reason", words(found.hits.front().fault)}});
    const TapSpectra sums =
        spectraOf(records, found, parameters, progress.part(0.3, 1, LT_TEXT("Engine", "Averaging spectra")));
    result.averages = sums.count;
    result.samples = found.block.samples;
    result.rate_hz = records.front().rate_hz;
    result.resolution_hz = result.rate_hz / static_cast<double>(result.samples);
    result.window_decay_1_s = sums.windows.decay_1_s;
    result.force_window_s = sums.windows.force_window_s;
    noteHits(result);
    if (result.averages == 1) result.notes.push_back({notes::tapSingleHit, {}});
    takeLines(sums, result);
    noteWindow(result, sums);
    return result;
}

}  // namespace lathelier::receptance
