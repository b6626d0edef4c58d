#include "engine/stability/speed_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/stability/nearby.h"
#include "engine/stability/refusal.h"
#include "engine/stability/slow_lobes.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::stability {
namespace {

constexpr double standardPeakShift = 0.7;
constexpr int pocketPoints = 4001;  ///< evaluated points of a pocket
constexpr int beyond = 4;           ///< number of candidates with k above that of the selected lobe
constexpr int mostLobes = 500;      ///< largest number of candidates

double selectedSpeed(const SpeedParameters& p)
{
    if (p.cutting_speed_m_min && p.speed_rpm)
        refuse("speed_rpm", *p.speed_rpm, LT_TEXT("Engine", "either a cutting speed or a spindle speed"));
    if (p.speed_rpm) return *p.speed_rpm;
    if (!p.cutting_speed_m_min)
        refuse("cutting_speed_m_min", Value(), LT_TEXT("Engine", "a cutting speed or a spindle speed"));
    if (!p.diameter_mm) refuse("diameter_mm", Value(), LT_TEXT("Engine", "the diameter for the cutting speed"));
    return spindleSpeed(*p.cutting_speed_m_min, *p.diameter_mm);
}

std::optional<Interval> rangeOf(const SpeedParameters& p)
{
    if (p.range_m_min.empty()) return std::nullopt;
    if (p.range_m_min.size() > 1)
        refuse("range_m_min", Value(p.range_m_min), LT_TEXT("Engine", "one range of cutting speeds"));
    const Interval& range = p.range_m_min.front();
    if (!(range.from <= range.to))
        refuse("range_m_min", Value(p.range_m_min), LT_TEXT("Engine", "a range such as 200:350"));
    if (!p.diameter_mm) refuse("diameter_mm", Value(), LT_TEXT("Engine", "the diameter for the range"));
    return Interval{spindleSpeed(range.from, *p.diameter_mm), spindleSpeed(range.to, *p.diameter_mm)};
}

/// ε/2π at the foot of an exact lobe of a lightly damped mode: there ψ is -3π/4, for a negative direction factor it is
/// turned by π.
double footTurns(const SpeedParameters& p)
{
    return p.direction_factor < 0 ? 0.25 : 0.75;
}

/// Speed range of lobe k: between the minima of published lobes, or the exact pocket between its feet.
Interval lobeEnds(double frequency_hz, int k, const SpeedParameters& p)
{
    if (p.relation == SpeedRelation::Published) return {60 * frequency_hz / k, 60 * frequency_hz / (k - 1)};
    const double turns = footTurns(p);
    return {60 * frequency_hz / (k + turns), 60 * frequency_hz / (k + turns - 1)};
}

/// The speed of a pocket that maximises the minimum limit within ±2 %.
double robustSpeed(const LimitsBySpeed& limits, const Interval& pocket)
{
    const Interval wide{pocket.from * (1 - robustShare), pocket.to * (1 + robustShare)};
    const double step = (wide.to - wide.from) / (pocketPoints - 1);
    std::vector<double> speeds, depths;
    for (int i = 0; i < pocketPoints; ++i) {
        speeds.push_back(wide.from + i * step);
        depths.push_back(limits.at(speeds.back()).depth_N_mm);
    }
    const std::vector<double> least = leastNearby(speeds, depths);
    double best = pocket.from, best_depth = -1;
    for (std::size_t i = 0; i < speeds.size(); ++i)
        if (speeds[i] >= pocket.from && speeds[i] <= pocket.to && least[i] > best_depth) {
            best_depth = least[i];
            best = speeds[i];
        }
    return best;
}

/// Lobe of the selected speed.
int lobeOf(double frequency_hz, double selected_rpm, const SpeedParameters& p)
{
    const double waves = 60 * frequency_hz / selected_rpm;
    const double k =
        p.relation == SpeedRelation::Published ? std::ceil(waves * (1 - 1e-12)) : std::floor(waves + 1 - footTurns(p));
    return static_cast<int>(std::min(k, 1e9));
}

std::vector<SpeedCandidate> candidatesOf(const Frf& frf, const SpeedResult& result,
                                         const std::optional<Interval>& range)
{
    const SpeedParameters& p = result.parameters;
    const bool published = p.relation == SpeedRelation::Published;
    const double lowest = std::min(range ? range->from : result.selected_rpm, result.selected_rpm);
    const int last = std::min({lobeOf(result.frequency_hz, lowest, p) + beyond, result.k + mostLobes, 2 * mostLobes});
    const double shift = p.peak_shift.value_or(standardPeakShift);
    const LimitsBySpeed limits(published ? Boundary{} : boundaryOf(frf, p.direction_factor, 4), SpeedRelation::Exact);
    std::vector<SpeedCandidate> candidates;
    for (int k = published ? 2 : 1; k <= last; ++k) {
        const Interval ends = lobeEnds(result.frequency_hz, k, p);
        const double speed = published ? ends.from + shift * (ends.to - ends.from) : robustSpeed(limits, ends);
        candidates.push_back({k, speed, !range || (speed >= range->from && speed <= range->to)});
    }
    return candidates;
}

[[noreturn]] void refuseSpeed(const SpeedResult& result, Text reason)
{
    Rows rows;
    for (const SpeedCandidate& candidate : result.candidates)
        rows.rows.push_back(
            {{{"k", std::int64_t{candidate.k}}, {"speed_rpm", candidate.speed_rpm}, {"in_range", candidate.in_range}}});
    throw Error(errors::noStableSpeed,
                {{"selected_rpm", result.selected_rpm}, {"reason", reason}, {"candidates", rows}});
}

/// The nearest candidate in range to the selected speed; nullptr: none.
const SpeedCandidate* nearest(const SpeedResult& result)
{
    const SpeedCandidate* best = nullptr;
    for (const SpeedCandidate& candidate : result.candidates)
        if (candidate.in_range && (!best || std::abs(candidate.speed_rpm - result.selected_rpm) <
                                                std::abs(best->speed_rpm - result.selected_rpm)))
            best = &candidate;
    return best;
}

}  // namespace

double spindleSpeed(double cutting_speed_m_min, double diameter_mm)
{
    return 1000 * cutting_speed_m_min / (std::numbers::pi * diameter_mm);
}

const std::vector<Field<SpeedParameters>>& fieldsOf(const SpeedParameters*)
{
    using P = SpeedParameters;
    static const std::vector<Field<P>> all{
        field("diameter_mm", &P::diameter_mm, Range{1e-3, 1e5},
              Label{LT_TEXT("Engine", "Diameter"), LT_TEXT("Engine", "Of the turned surface."), unit::mm}),
        field("cutting_speed_m_min", &P::cutting_speed_m_min, Range{1e-3, 1e5},
              Label{LT_TEXT("Engine", "Cutting speed"), LT_TEXT("Engine", "That is selected."), unit::m_min}),
        field("speed_rpm", &P::speed_rpm, Range{1e-3, 1e6},
              Label{LT_TEXT("Engine", "Spindle speed"),
                    LT_TEXT("Engine", "That is selected, in place of a cutting speed."), unit::rpm}),
        field(
            "range_m_min", &P::range_m_min, Range{1e-3, 1e5},
            Label{LT_TEXT("Engine", "Cutting speeds of the tool"), LT_TEXT("Engine", "Range, 200:350."), unit::m_min}),
        field("peak_shift", &P::peak_shift, Range{0, 1},
              Label{LT_TEXT("Engine", "Peak shift P_sh"),
                    LT_TEXT("Engine", "Place within the lobe, published relation only. Default 0.7."),
                    {},
                    true}),
        field("rule", &P::rule,
              {{"lobe", LT_TEXT("Engine", "Lobe of the selected speed")},
               {"nearest", LT_TEXT("Engine", "Nearest in range")}},
              Label{LT_TEXT("Engine", "Rule"), LT_TEXT("Engine", "Which candidate is recommended.")}),
        field(
            "relation", &P::relation,
            {{"exact", LT_TEXT("Engine", "Exact")}, {"published", LT_TEXT("Engine", "As published (N = 60 f/k)")}},
            Label{LT_TEXT("Engine", "Speed relation"),
                  LT_TEXT("Engine", "Published reproduces the papers; exact takes the robust optimum of the pocket.")}),
        field("direction_factor", &P::direction_factor, Range{-10, 10},
              Label{LT_TEXT("Engine", "Direction factor"),
                    LT_TEXT("Engine", "By which the receptance is multiplied."),
                    {},
                    true})};
    return all;
}

SpeedResult chooseSpeed(const Frf& frf, const SpeedParameters& parameters)
{
    SpeedResult result;
    result.parameters = parameters;
    result.selected_rpm = selectedSpeed(parameters);
    const std::optional<Interval> range = rangeOf(parameters);
    if (parameters.peak_shift && parameters.relation == SpeedRelation::Exact)
        refuse("peak_shift", *parameters.peak_shift,
               LT_TEXT("Engine", "nothing: the exact relation has its own optimum"));
    const LeastRealPart least = leastRealPart(frf, parameters.direction_factor);
    result.frequency_hz = least.frequency_hz;
    if (!(least.real_mm_N < 0)) refuseSpeed(result, LT_TEXT("Engine", "nothing chatters: every speed is stable"));
    if (least.at_edge) result.notes.push_back({notes::minimumAtEdge, {{"frequency_hz", least.frequency_hz}}});
    result.k = lobeOf(least.frequency_hz, result.selected_rpm, parameters);
    result.candidates = candidatesOf(frf, result, range);
    const int first = parameters.relation == SpeedRelation::Published ? 2 : 1;
    if (result.k < first)
        refuseSpeed(result, LT_TEXT("Engine", "it lies above the last lobe, which has no upper neighbour"));
    result.lobe_rpm = lobeEnds(least.frequency_hz, result.k, parameters);
    const SpeedCandidate* best = nearest(result);
    if (!best) refuseSpeed(result, LT_TEXT("Engine", "no candidate lies in the range of cutting speeds"));
    if (parameters.rule == SpeedRule::Lobe) {
        const auto own = std::find_if(result.candidates.begin(), result.candidates.end(),
                                      [&](const SpeedCandidate& candidate) { return candidate.k == result.k; });
        if (own != result.candidates.end() && own->in_range)
            best = &*own;
        else if (own != result.candidates.end())
            result.notes.push_back({notes::fromAnotherLobe, {{"lobe_rpm", own->speed_rpm}}});
    }
    result.recommended_rpm = best->speed_rpm;
    if (parameters.diameter_mm)
        result.recommended_cutting_speed_m_min = best->speed_rpm * std::numbers::pi * *parameters.diameter_mm / 1000;
    return result;
}

}  // namespace lathelier::stability
