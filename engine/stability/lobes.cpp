#include "engine/stability/lobes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/stability/envelope.h"
#include "engine/stability/lobe_uncertainty.h"
#include "engine/stability/process_damping.h"
#include "engine/stability/slow_lobes.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::stability {
namespace {

constexpr int stepsOfMeasured = 8;          ///< interpolated points per line interval
constexpr double doubtfulNoise = 0.25;      ///< of the least real part, above which it may be that of noise
constexpr std::size_t fewestInWidth = 3;    ///< lines in the half-power band of the resonance that limits
constexpr double looserInPart = 250;        ///< tolerance of the lobes where they are listed in part
constexpr std::size_t mostLobes = 200;      ///< that are listed
constexpr std::size_t denseEnough = 20000;  ///< number of lines above which no points are interpolated

Interval speedsOf(const LobeParameters& parameters, double frequency_hz)
{
    if (parameters.speed_rpm.size() > 1)
        throw Error(errors::valueNotUnderstood, {{"parameter", "speed_rpm"},
                                                 {"found", Value(parameters.speed_rpm)},
                                                 {"expected", LT_TEXT("Engine", "one range of speeds")}});
    if (!parameters.speed_rpm.empty()) return parameters.speed_rpm.front();
    return {60 * frequency_hz / 8, 60 * frequency_hz * 1.2};  // lobes 1 to 7 and the pocket above
}

/// The part of a lobe within the speed range.
Lobe shownPart(const LobeCurve& curve, const Interval& speed_rpm, double per_N_mm)
{
    Lobe lobe;
    lobe.k = curve.k;
    for (const auto& stretch : curve.stretches) {
        bool apart = !lobe.speed_rpm.empty();
        for (const CurvePoint& point : stretch) {
            if (point.speed_rpm < speed_rpm.from || point.speed_rpm > speed_rpm.to) continue;
            if (apart) {
                for (auto* list : {&lobe.speed_rpm, &lobe.depth_mm, &lobe.frequency_hz}) list->push_back(notANumber);
                apart = false;
            }
            lobe.speed_rpm.push_back(point.speed_rpm);
            lobe.depth_mm.push_back(per_N_mm * point.depth_N_mm);
            lobe.frequency_hz.push_back(point.frequency_hz);
        }
    }
    return lobe;
}

/// β of the requested process damping; 0: none.
double dampingOf(const LobeParameters& p)
{
    if (!p.process_damping_N_mm) return 0;
    const auto refuse = [&](const char* parameter, Text expected) {
        throw Error(errors::valueNotUnderstood, {{"parameter", parameter}, {"found", Value()}, {"expected", expected}});
    };
    if (p.relation != SpeedRelation::Exact)
        refuse("relation", LT_TEXT("Engine", "the exact relation: the published one has no process damping"));
    if (!p.cutting_coefficient_N_mm2)
        refuse("cutting_coefficient_N_mm2", LT_TEXT("Engine", "the cutting coefficient for the process damping"));
    if (!p.diameter_mm) refuse("diameter_mm", LT_TEXT("Engine", "the diameter for the process damping"));
    return dampingRatioOf(*p.process_damping_N_mm, *p.diameter_mm, *p.cutting_coefficient_N_mm2);
}

std::vector<int> numbersOf(const LobeRange& range)
{
    std::vector<int> numbers(static_cast<std::size_t>(std::max(0, range.last - range.first + 1)));
    std::iota(numbers.begin(), numbers.end(), range.first);
    return numbers;
}

/// Calls use(curve) for these lobes in their order. A few hundred are kept at a time: at slow speeds there may be many
/// thousands.
template <class Use>
void forEachCurve(const Boundary& boundary, const std::vector<int>& lobes, SpeedRelation relation,
                  const Interval& speed_rpm, double beta, const Progress& progress, Use use)
{
    constexpr std::size_t atOnce = 256;
    std::vector<LobeCurve> curves;
    for (std::size_t start = 0; start < lobes.size(); start += atOnce) {
        curves.assign(std::min(atOnce, lobes.size() - start), {});
        parallelFor(curves.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const int k = lobes[start + i];
                curves[i] = beta > 0 ? dampedLobeCurve(boundary, k, beta) : lobeCurve(boundary, k, relation, speed_rpm);
            }
        });
        for (const LobeCurve& curve : curves) {
            progress.check();
            use(curve);
        }
    }
}

LobeLimit scaled(LobeLimit limit, double factor)
{
    for (double& depth : limit.depth_mm) depth *= factor;
    return limit;
}

/// Boundary with interpolated points for coarse responses, without redundant points.
Boundary denseBoundary(const Frf& frf, double factor)
{
    Boundary boundary = boundaryOf(frf, factor, frf.frequency_hz.size() > denseEnough ? 1 : stepsOfMeasured);
    for (auto& stretch : boundary) stretch = thinned(stretch);
    return boundary;
}

LobeLimit limitIn(const Boundary& boundary, const LobeParameters& p, double beta, double per_N_mm,
                  const Interval& speed_rpm, int points, const Progress& progress)
{
    const LobeRange lobes = lobesWithin(boundary, p.relation, speed_rpm);
    if (!(beta > 0) && lobes.last - lobes.first >= static_cast<int>(mostLobes))
        return scaled(envelopeBySpeed(boundary, p.relation, speed_rpm, points, progress), per_N_mm);
    LowerEnvelope limit(speed_rpm, points);
    forEachCurve(boundary, numbersOf(lobes), p.relation, speed_rpm, beta, progress,
                 [&](const LobeCurve& curve) { limit.add(curve); });
    return scaled(limit.take(), per_N_mm);
}

/// The lobes that are listed, with the number of those that reach the speeds.
void listLobes(const Boundary& boundary, double beta, double per_N_mm, LobeResult& result, const Progress& progress)
{
    const SpeedRelation relation = result.parameters.relation;
    const LobeRange all = lobesWithin(boundary, relation, result.speed_rpm);
    std::vector<int> numbers = numbersOf(all);
    const bool is_part = numbers.size() > mostLobes;
    if (is_part) numbers = strongestLobes(boundary, relation, result.speed_rpm, all.first, all.last, mostLobes);
    Boundary drawn = boundary;
    if (is_part)
        for (auto& stretch : drawn) stretch = thinned(stretch, looserInPart);
    forEachCurve(drawn, numbers, relation, result.speed_rpm, beta, progress, [&](const LobeCurve& curve) {
        Lobe lobe = shownPart(curve, result.speed_rpm, per_N_mm);
        if (!lobe.speed_rpm.empty()) result.lobes.push_back(std::move(lobe));
    });
    result.lobes_in_range = is_part ? static_cast<std::size_t>(all.last - all.first + 1) : result.lobes.size();
    if (is_part)
        result.notes.push_back(
            {notes::lobesLeftOut, {{"count", static_cast<std::int64_t>(result.lobes_in_range - result.lobes.size())}}});
}

/// The least real part against the noise of its line, and by how many lines its resonance is seen.
void judgeMinimum(const Frf& frf, const LeastRealPart& least, LobeResult& result)
{
    if (frf.noise.size() != frf.value.size()) return;
    const auto at = static_cast<std::size_t>(
        std::lower_bound(frf.frequency_hz.begin(), frf.frequency_hz.end() - 1, least.frequency_hz) -
        frf.frequency_hz.begin());
    const double share = std::abs(result.parameters.direction_factor) * frf.noise[at] / std::abs(least.real_mm_N);
    result.minimum_noise_percent = 100 * share;
    if (share > doubtfulNoise)
        result.notes.push_back(
            {notes::minimumInNoise, {{"frequency_hz", least.frequency_hz}, {"noise_percent", 100 * share}}});
    // Around the resonance, whose least real part lies half its width above it.
    std::size_t peak = at;
    while (peak > 0 && std::abs(frf.value[peak - 1]) > std::abs(frf.value[peak])) --peak;
    while (peak + 1 < frf.value.size() && std::abs(frf.value[peak + 1]) > std::abs(frf.value[peak])) ++peak;
    const double half_power = std::abs(frf.value[peak]) / std::sqrt(2.0);
    std::size_t first = peak, last = peak;
    while (first > 0 && std::abs(frf.value[first - 1]) >= half_power) --first;
    while (last + 1 < frf.value.size() && std::abs(frf.value[last + 1]) >= half_power) ++last;
    if (last + 1 - first < fewestInWidth)
        result.notes.push_back(
            {notes::minimumNotResolved,
             {{"frequency_hz", least.frequency_hz}, {"lines", static_cast<std::int64_t>(last + 1 - first)}}});
}

/// Standard deviation of the limit by the noise of the line of its frequency, as a share; empty: not known.
std::vector<double> noiseOfLimit(const Frf& frf, double factor, const LobeLimit& limit)
{
    if (frf.noise.size() != frf.value.size()) return {};
    std::vector<double> shares;
    shares.reserve(limit.frequency_hz.size());
    for (const double f : limit.frequency_hz) {
        if (std::isnan(f)) {
            shares.push_back(0);
            continue;
        }
        const auto at = static_cast<std::size_t>(
            std::lower_bound(frf.frequency_hz.begin(), frf.frequency_hz.end() - 1, f) - frf.frequency_hz.begin());
        const double real = std::abs(factor * interpolated(frf, f).real());
        shares.push_back(real > 0 ? std::min(1.0, std::abs(factor) * frf.noise[at] / real) : 1.0);
    }
    return shares;
}

/// The depth over N/mm: 1/K_r, or normalised to a least depth of 1.
double depthPerForce(const LobeParameters& p, const LeastRealPart& least)
{
    return p.cutting_coefficient_N_mm2 ? 1 / *p.cutting_coefficient_N_mm2 : -2 * least.real_mm_N;
}

/// With process damping the minimum is taken over the shown speeds, as the limit rises at low speeds.
void setMinimumOverShownSpeeds(LobeResult& result)
{
    const LobeLimit& limit = result.limit;
    for (std::size_t i = 0; i < limit.depth_mm.size(); ++i)
        if (limit.k[i] >= 0 && !(result.minimum_depth_mm && *result.minimum_depth_mm <= limit.depth_mm[i])) {
            result.minimum_depth_mm = limit.depth_mm[i];
            result.frequency_of_minimum_hz = limit.frequency_hz[i];
        }
}

}  // namespace

const std::vector<Field<LobeParameters>>& fieldsOf(const LobeParameters*)
{
    using P = LobeParameters;
    static const std::vector<Field<P>> all = [] {
        const auto uncertainty = [&](const char* key, double P::*member, Text label) {
            return field(key, member, Range{0, 15},
                         Label{label, LT_TEXT("Engine", "One standard deviation; gives the 95 % band of the limit."),
                               unit::percent, true});
        };
        return std::vector<Field<P>>{
            field("cutting_coefficient_N_mm2", &P::cutting_coefficient_N_mm2, Range{1e-3, 1e6},
                  Label{LT_TEXT("Engine", "Cutting coefficient K_r"),
                        LT_TEXT("Engine",
                                "Force along the chip thickness over its area; without it depths are multiples of the "
                                "least."),
                        unit::N_mm2}),
            field(
                "relation", &P::relation,
                {{"exact", LT_TEXT("Engine", "Exact")}, {"published", LT_TEXT("Engine", "As published (N = 60 f/k)")}},
                Label{LT_TEXT("Engine", "Speed relation"),
                      LT_TEXT("Engine", "Exact keeps the phase of the regeneration; the papers set it to zero.")}),
            field("speed_rpm", &P::speed_rpm, Range{1, 1e6},
                  Label{LT_TEXT("Engine", "Speeds"),
                        LT_TEXT("Engine", "Range that is shown, 1000:4000. Default: the first lobes."), unit::rpm}),
            field(
                "points", &P::points, Range{2, 100000},
                Label{
                    LT_TEXT("Engine", "Points of the limit"), LT_TEXT("Engine", "Evenly over the speeds."), {}, true}),
            field("direction_factor", &P::direction_factor, Range{-10, 10},
                  Label{LT_TEXT("Engine", "Direction factor"),
                        LT_TEXT("Engine",
                                "By which the receptance is multiplied: how much of a vibration changes the chip "
                                "thickness."),
                        {},
                        true}),
            field("process_damping_N_mm", &P::process_damping_N_mm, Range{0, 1e9},
                  Label{LT_TEXT("Engine", "Process damping C"),
                        LT_TEXT("Engine",
                                "Of the force C (a/v) ẋ, v the cutting speed; needs coefficient, diameter and the "
                                "exact relation."),
                        unit::N_mm, true}),
            field("diameter_mm", &P::diameter_mm, Range{1e-3, 1e5},
                  Label{LT_TEXT("Engine", "Diameter"),
                        LT_TEXT("Engine", "Of the turned surface; for the process damping."), unit::mm, true}),
            uncertainty("uncertainty_frequency_percent", &P::uncertainty_frequency_percent,
                        LT_TEXT("Engine", "Uncertainty of the frequencies")),
            field("uncertainty_damping_percent", &P::uncertainty_damping_percent, Range{0, 50},
                  Label{LT_TEXT("Engine", "Uncertainty of the damping"),
                        LT_TEXT("Engine",
                                "One standard deviation of each damping ratio; of modes that are stated or fitted."),
                        unit::percent, true}),
            uncertainty("uncertainty_compliance_percent", &P::uncertainty_compliance_percent,
                        LT_TEXT("Engine", "Uncertainty of the compliance")),
            uncertainty("uncertainty_coefficient_percent", &P::uncertainty_coefficient_percent,
                        LT_TEXT("Engine", "Uncertainty of the cutting coefficient"))};
    }();
    return all;
}

LobeLimit limitOf(const Frf& frf, const LobeParameters& parameters, const Progress& progress)
{
    const double beta = dampingOf(parameters);
    const LeastRealPart least = leastRealPart(frf, parameters.direction_factor);
    return limitIn(denseBoundary(frf, parameters.direction_factor), parameters, beta, depthPerForce(parameters, least),
                   speedsOf(parameters, least.frequency_hz), parameters.points, progress);
}

LobeResult findLobes(const Frf& frf, const LobeParameters& parameters, const Progress& progress,
                     const receptance::UncertainModel& modes)
{
    LobeResult result;
    result.parameters = parameters;
    noteUnusual(parameters, {usualCoefficient}, result.notes);
    const double beta = dampingOf(parameters);
    const bool is_modal = modes.isKnown() && !(beta > 0);
    if (parameters.uncertainty_damping_percent > 0 && !is_modal)
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", "uncertainty_damping_percent"},
                     {"found", parameters.uncertainty_damping_percent},
                     {"expected", LT_TEXT("Engine", "a response by its modes: stated ones, or the fitted model")}});
    const LeastRealPart least = leastRealPart(frf, parameters.direction_factor);
    result.speed_rpm = speedsOf(parameters, least.frequency_hz);
    const bool chatters = least.real_mm_N < 0;
    const Boundary boundary = denseBoundary(frf, parameters.direction_factor);
    const double per_N_mm = depthPerForce(parameters, least);
    result.limit = limitIn(boundary, parameters, beta, per_N_mm, result.speed_rpm, parameters.points, progress);
    if (parameters.relation == SpeedRelation::Published) result.notes.push_back({notes::publishedRelation, {}});
    if (!chatters) {
        result.notes.push_back({notes::noLimit, {}});
        return result;
    }
    if (least.at_edge) result.notes.push_back({notes::minimumAtEdge, {{"frequency_hz", least.frequency_hz}}});
    if (result.isRelative()) result.notes.push_back({notes::coefficientUnknown, {}});
    if (beta > 0) {
        setMinimumOverShownSpeeds(result);
    } else {
        result.minimum_depth_mm = per_N_mm / (-2 * least.real_mm_N);
        result.frequency_of_minimum_hz = least.frequency_hz;
    }
    listLobes(boundary, beta, per_N_mm, result, progress);
    judgeMinimum(frf, least, result);
    const std::vector<double> noise = noiseOfLimit(frf, parameters.direction_factor, result.limit);
    if (is_modal && isUncertain(parameters, modes)) {
        result.band = bandOfModes(parameters, result.limit, modes, per_N_mm, progress);
    } else if (!is_modal && (isUncertain(parameters, {}) || !noise.empty())) {
        const LimitOver limitOver = [&](const Interval& speed_rpm, int points) {
            return limitIn(boundary, parameters, beta, per_N_mm, speed_rpm, points, progress);
        };
        result.band = bandOfWhole(parameters, result.limit, noise, limitOver, progress);
    }
    progress.report(1);
    return result;
}

}  // namespace lathelier::stability
