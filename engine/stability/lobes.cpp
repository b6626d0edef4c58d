#include "engine/stability/lobes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/stability/envelope.h"
#include "engine/stability/lobe_uncertainty.h"
#include "engine/stability/process_damping.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::stability {
namespace {

constexpr int stepsOfMeasured = 8;          ///< interpolated points per line interval
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

/// Calls use(curve) for all lobes that may reach the speeds, in their order. A few hundred are kept at a time: at slow
/// speeds there may be many thousands.
template <class Use>
void forEachCurve(const Boundary& boundary, SpeedRelation relation, const Interval& speed_rpm, double beta,
                  const Progress& progress, Use use)
{
    constexpr std::size_t atOnce = 256;
    const LobeRange all = lobesWithin(boundary, relation, speed_rpm);
    const auto count = static_cast<std::size_t>(std::max(0, all.last - all.first + 1));
    std::vector<LobeCurve> curves;
    for (std::size_t start = 0; start < count; start += atOnce) {
        curves.assign(std::min(atOnce, count - start), {});
        parallelFor(curves.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const int k = all.first + static_cast<int>(start + i);
                curves[i] = beta > 0 ? dampedLobeCurve(boundary, k, beta) : lobeCurve(boundary, k, relation, speed_rpm);
            }
        });
        for (const LobeCurve& curve : curves) {
            progress.check();
            use(curve);
        }
    }
}

/// Lobes with their least depth, of which only the strongest are kept.
class StrongestLobes {
public:
    void add(Lobe lobe)
    {
        double least = std::numeric_limits<double>::infinity();
        for (const double depth : lobe.depth_mm) least = std::min(least, std::isnan(depth) ? least : depth);
        ++count_;
        lobes_.emplace_back(least, std::move(lobe));
        if (lobes_.size() >= 2 * mostLobes) shrink();
    }

    /// By ascending k.
    std::vector<Lobe> take()
    {
        if (lobes_.size() > mostLobes) shrink();
        std::vector<Lobe> result;
        result.reserve(lobes_.size());
        for (auto& [least, lobe] : lobes_) result.push_back(std::move(lobe));
        return result;
    }

    std::size_t count() const { return count_; }

private:
    void shrink()
    {
        std::stable_sort(lobes_.begin(), lobes_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        lobes_.resize(mostLobes);
        std::sort(lobes_.begin(), lobes_.end(), [](const auto& a, const auto& b) { return a.second.k < b.second.k; });
    }

    std::vector<std::pair<double, Lobe>> lobes_;
    std::size_t count_ = 0;
};

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
    if (!(beta > 0)) return scaled(envelope(boundary, p.relation, speed_rpm, points), per_N_mm);
    LowerEnvelope limit(speed_rpm, points);
    forEachCurve(boundary, p.relation, speed_rpm, beta, progress, [&](const LobeCurve& curve) { limit.add(curve); });
    return scaled(limit.take(), per_N_mm);
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
    if (!parameters.cutting_coefficient_N_mm2)
        throw Error(errors::valueNotUnderstood, {{"parameter", "cutting_coefficient_N_mm2"},
                                                 {"found", Value()},
                                                 {"expected", LT_TEXT("Engine", "the cutting coefficient")}});
    const Interval speeds = speedsOf(parameters, leastRealPart(frf, parameters.direction_factor).frequency_hz);
    return limitIn(denseBoundary(frf, parameters.direction_factor), parameters, beta,
                   1 / *parameters.cutting_coefficient_N_mm2, speeds, parameters.points, progress);
}

LobeResult findLobes(const Frf& frf, const LobeParameters& parameters, const Progress& progress)
{
    LobeResult result;
    result.parameters = parameters;
    const double beta = dampingOf(parameters);
    const LeastRealPart least = leastRealPart(frf, parameters.direction_factor);
    result.speed_rpm = speedsOf(parameters, least.frequency_hz);
    const bool chatters = least.real_mm_N < 0;
    const Boundary boundary = denseBoundary(frf, parameters.direction_factor);
    // The depth over N/mm: 1/K_r, or normalised to a least depth of 1.
    const double per_N_mm = result.isRelative() ? -2 * least.real_mm_N : 1 / *parameters.cutting_coefficient_N_mm2;
    LowerEnvelope limit(result.speed_rpm, parameters.points);
    StrongestLobes lobes;
    forEachCurve(boundary, parameters.relation, result.speed_rpm, beta, progress, [&](const LobeCurve& curve) {
        limit.add(curve);
        Lobe lobe = chatters ? shownPart(curve, result.speed_rpm, per_N_mm) : Lobe{};
        if (!lobe.speed_rpm.empty()) lobes.add(std::move(lobe));
    });
    result.limit = scaled(limit.take(), per_N_mm);
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
    result.lobes = lobes.take();
    result.lobes_in_range = lobes.count();
    if (result.lobes.size() < lobes.count())
        result.notes.push_back(
            {notes::lobesLeftOut, {{"count", static_cast<std::int64_t>(lobes.count() - result.lobes.size())}}});
    if (isUncertain(parameters)) {
        const LimitOver limitOver = [&](const Interval& speed_rpm, int points) {
            return limitIn(boundary, parameters, beta, per_N_mm, speed_rpm, points, progress);
        };
        result.band = bandOf(parameters, result.limit, limitOver, progress);
    }
    progress.report(1);
    return result;
}

}  // namespace lathelier::stability
