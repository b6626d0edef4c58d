#include "engine/stability/lobes.h"

#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/random.h"
#include "engine/core/statistics.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::stability {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int stepsOfMeasured = 8;          ///< between lines
constexpr std::size_t denseEnough = 20000;  ///< lines that need no steps between them
constexpr std::uint64_t draws = 1000;       ///< of the uncertainty
constexpr double widest = 1.5;              ///< a drawn natural frequency differs by less than this factor

int leastLobe(SpeedRelation relation)
{
    return relation == SpeedRelation::Published ? 1 : 0;
}

double speedOf(const BoundaryPoint& point, int k, SpeedRelation relation)
{
    return 60 * point.frequency_hz / (relation == SpeedRelation::Published ? k : k + point.phase_turns);
}

/// The lobes of a stretch that may reach the speeds.
struct LobeRange {
    int first = 0;
    int last = -1;
};

LobeRange lobesWithin(const std::vector<BoundaryPoint>& stretch, SpeedRelation relation, const Interval& speed_rpm)
{
    const double low = 60 * stretch.front().frequency_hz / speed_rpm.to;
    const double high = 60 * stretch.back().frequency_hz / speed_rpm.from;
    return {std::max(leastLobe(relation), static_cast<int>(std::floor(low)) - 1), static_cast<int>(std::floor(high))};
}

Interval speedsOf(const LobeParameters& parameters, double frequency_hz)
{
    if (parameters.speed_rpm.size() > 1)
        throw Error(errors::valueNotUnderstood, {{"parameter", "speed_rpm"},
                                                 {"found", Value(parameters.speed_rpm)},
                                                 {"expected", LT_TEXT("Engine", "one range of speeds")}});
    if (!parameters.speed_rpm.empty()) return parameters.speed_rpm.front();
    return {60 * frequency_hz / 8, 60 * frequency_hz * 1.2};  // lobes 1 to 7 and the pocket above
}

Lobe lobeOf(const Boundary& boundary, int k, SpeedRelation relation, const Interval& speed_rpm, double per_compliance)
{
    Lobe lobe;
    lobe.k = k;
    for (const auto& stretch : boundary) {
        bool apart = !lobe.speed_rpm.empty();
        for (const BoundaryPoint& point : stretch) {
            const double speed = speedOf(point, k, relation);
            if (speed < speed_rpm.from || speed > speed_rpm.to) continue;
            if (apart) {
                for (auto* list : {&lobe.speed_rpm, &lobe.depth_mm, &lobe.frequency_hz}) list->push_back(none);
                apart = false;
            }
            lobe.speed_rpm.push_back(speed);
            lobe.depth_mm.push_back(per_compliance / point.compliance_mm_N);
            lobe.frequency_hz.push_back(point.frequency_hz);
        }
    }
    return lobe;
}

/// Linear between the evenly spaced speeds of the limit; NaN where one of the neighbours is.
double depthAt(const LobeLimit& limit, double speed_rpm)
{
    const std::size_t count = limit.speed_rpm.size();
    if (count < 2 || speed_rpm < limit.speed_rpm.front() || speed_rpm > limit.speed_rpm.back()) return none;
    const double step = (limit.speed_rpm.back() - limit.speed_rpm.front()) / static_cast<double>(count - 1);
    const double place = (speed_rpm - limit.speed_rpm.front()) / step;
    const auto i = std::min(static_cast<std::size_t>(place), count - 2);
    const double share = place - static_cast<double>(i);
    return (1 - share) * limit.depth_mm[i] + share * limit.depth_mm[i + 1];
}

bool isUncertain(const LobeParameters& p)
{
    return p.uncertainty_frequency_percent > 0 || p.uncertainty_compliance_percent > 0 ||
           (p.cutting_coefficient_N_mm2 && p.uncertainty_coefficient_percent > 0);
}

/// A drawn machine: its frequencies are those of the boundary times `frequency`, its limits times `depth`.
struct Draw {
    double frequency = 1;
    double depth = 1;
};

std::vector<Draw> drawn(const LobeParameters& p)
{
    std::vector<Draw> result;
    for (std::uint64_t number = 0; number < draws; ++number) {
        const auto factor = [&](std::uint64_t stream, double percent) {
            return std::clamp(1 + percent / 100 * randomNormal(1, stream, number), 1 / widest, widest);
        };
        const double coefficient = p.cutting_coefficient_N_mm2 ? factor(3, p.uncertainty_coefficient_percent) : 1;
        result.push_back({factor(1, p.uncertainty_frequency_percent),
                          1 / (factor(2, p.uncertainty_compliance_percent) * coefficient)});
    }
    return result;
}

LobeBand bandOf(const Boundary& boundary, const LobeParameters& p, const LobeLimit& limit, double per_compliance,
                const Progress& progress)
{
    const Interval wide{limit.speed_rpm.front() / widest, limit.speed_rpm.back() * widest};
    LobeLimit whole = envelope(boundary, p.relation, wide, 2 * p.points);
    for (double& depth : whole.depth_mm) depth *= per_compliance;
    const std::vector<Draw> machines = drawn(p);
    LobeBand band;
    std::vector<double> depths;
    for (std::size_t i = 0; i < limit.speed_rpm.size(); ++i) {
        if (i % 64 == 0) progress.report(static_cast<double>(i) / static_cast<double>(limit.speed_rpm.size()));
        depths.clear();
        for (const Draw& draw : machines) {
            const double depth = draw.depth * depthAt(whole, limit.speed_rpm[i] / draw.frequency);
            depths.push_back(std::isnan(depth) ? HUGE_VAL : depth);
        }
        const auto finite = [](double depth) { return std::isfinite(depth) ? depth : none; };
        band.low_mm.push_back(finite(quantileInPlace(depths, 0.025)));
        band.high_mm.push_back(finite(quantileInPlace(depths, 0.975)));
    }
    return band;
}

}  // namespace

const std::vector<Field<LobeParameters>>& fieldsOf(const LobeParameters*)
{
    using P = LobeParameters;
    static const std::vector<Field<P>> all = [] {
        const Text percent = LT_TEXT("Engine", "%");
        const auto uncertainty = [&](const char* key, double P::*member, Text label) {
            return field(key, member, Range{0, 15},
                         Label{label, LT_TEXT("Engine", "One standard deviation; gives the 95 % band of the limit."),
                               percent, true});
        };
        return std::vector<Field<P>>{
            field("cutting_coefficient_N_mm2", &P::cutting_coefficient_N_mm2, Range{1e-3, 1e6},
                  Label{LT_TEXT("Engine", "Cutting coefficient K_r"),
                        LT_TEXT("Engine",
                                "Force along the chip thickness over its area; without it depths are multiples of the "
                                "least."),
                        LT_TEXT("Engine", "N/mm²")}),
            field(
                "relation", &P::relation,
                {{"exact", LT_TEXT("Engine", "Exact")}, {"published", LT_TEXT("Engine", "As published (N = 60 f/k)")}},
                Label{LT_TEXT("Engine", "Speed relation"),
                      LT_TEXT("Engine", "Exact keeps the phase of the regeneration; the papers set it to zero.")}),
            field("speed_rpm", &P::speed_rpm, Range{1, 1e6},
                  Label{LT_TEXT("Engine", "Speeds"),
                        LT_TEXT("Engine", "Range that is shown, 1000:4000. Default: the first lobes."),
                        LT_TEXT("Engine", "1/min")}),
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
            uncertainty("uncertainty_frequency_percent", &P::uncertainty_frequency_percent,
                        LT_TEXT("Engine", "Uncertainty of the frequencies")),
            uncertainty("uncertainty_compliance_percent", &P::uncertainty_compliance_percent,
                        LT_TEXT("Engine", "Uncertainty of the compliance")),
            uncertainty("uncertainty_coefficient_percent", &P::uncertainty_coefficient_percent,
                        LT_TEXT("Engine", "Uncertainty of the cutting coefficient"))};
    }();
    return all;
}

LobeLimit envelope(const Boundary& boundary, SpeedRelation relation, const Interval& speed_rpm, int points)
{
    const auto count = static_cast<std::size_t>(points);
    const double step = (speed_rpm.to - speed_rpm.from) / static_cast<double>(points - 1);
    LobeLimit limit{
        {}, std::vector<double>(count, none), std::vector<double>(count, none), std::vector<int>(count, -1)};
    for (int i = 0; i < points; ++i)
        limit.speed_rpm.push_back(i + 1 == points ? speed_rpm.to : speed_rpm.from + i * step);
    if (!(step > 0)) return limit;
    for (const auto& stretch : boundary) {
        const LobeRange range = lobesWithin(stretch, relation, speed_rpm);
        for (int k = range.first; k <= range.last; ++k) {
            double speed1 = speedOf(stretch.front(), k, relation);
            for (std::size_t p = 1; p < stretch.size(); ++p) {
                const double speed0 = speed1;
                speed1 = speedOf(stretch[p], k, relation);
                const double low = std::min(speed0, speed1), high = std::max(speed0, speed1);
                if (high < speed_rpm.from || low > speed_rpm.to) continue;
                const double depth0 = 1 / stretch[p - 1].compliance_mm_N, depth1 = 1 / stretch[p].compliance_mm_N;
                const double f0 = stretch[p - 1].frequency_hz, f1 = stretch[p].frequency_hz;
                const double first = std::max(0.0, std::ceil((low - speed_rpm.from) / step));
                const double last =
                    std::min(static_cast<double>(points - 1), std::floor((high - speed_rpm.from) / step));
                for (double place = first; place <= last; ++place) {
                    const auto i = static_cast<std::size_t>(place);
                    const double share =
                        high > low ? std::clamp((limit.speed_rpm[i] - speed0) / (speed1 - speed0), 0.0, 1.0) : 0;
                    const double depth = depth0 + share * (depth1 - depth0);
                    if (limit.k[i] >= 0 && depth >= limit.depth_mm[i]) continue;
                    limit.depth_mm[i] = depth;
                    limit.frequency_hz[i] = f0 + share * (f1 - f0);
                    limit.k[i] = k;
                }
            }
        }
    }
    return limit;
}

LobeResult findLobes(const Frf& frf, const LobeParameters& parameters, const Progress& progress)
{
    LobeResult result;
    result.parameters = parameters;
    const LeastRealPart least = leastRealPart(frf, parameters.direction_factor);
    result.speed_rpm = speedsOf(parameters, least.frequency_hz);
    const bool chatters = least.real_mm_N < 0;
    const int steps = frf.frequency_hz.size() > denseEnough ? 1 : stepsOfMeasured;
    const Boundary boundary = boundaryOf(frf, parameters.direction_factor, steps);
    result.limit = envelope(boundary, parameters.relation, result.speed_rpm, parameters.points);
    if (parameters.relation == SpeedRelation::Published) result.notes.push_back({notes::publishedRelation, {}});
    if (!chatters) {
        result.notes.push_back({notes::noLimit, {}});
        return result;
    }
    if (least.at_edge) result.notes.push_back({notes::minimumAtEdge, {{"frequency_hz", least.frequency_hz}}});
    if (result.isRelative()) result.notes.push_back({notes::coefficientUnknown, {}});
    // The depth over 1/compliance: 1/K_r, or such that the least depth is 1.
    const double per_compliance =
        result.isRelative() ? -2 * least.real_mm_N : 1 / *parameters.cutting_coefficient_N_mm2;
    result.minimum_depth_mm = per_compliance / (-2 * least.real_mm_N);
    result.frequency_of_minimum_hz = least.frequency_hz;
    for (double& depth : result.limit.depth_mm) depth *= per_compliance;
    LobeRange all{1 << 30, -1};
    for (const auto& stretch : boundary) {
        const LobeRange range = lobesWithin(stretch, parameters.relation, result.speed_rpm);
        all = {std::min(all.first, range.first), std::max(all.last, range.last)};
    }
    for (int k = all.first; k <= all.last; ++k) {
        progress.check();
        Lobe lobe = lobeOf(boundary, k, parameters.relation, result.speed_rpm, per_compliance);
        if (!lobe.speed_rpm.empty()) result.lobes.push_back(std::move(lobe));
    }
    if (isUncertain(parameters)) result.band = bandOf(boundary, parameters, result.limit, per_compliance, progress);
    progress.report(1);
    return result;
}

PointOfWork pointOfWork(const LobeResult& result, double speed_rpm, double depth_mm)
{
    PointOfWork point;
    const LobeLimit& limit = result.limit;
    point.limit_mm = depthAt(limit, speed_rpm);
    point.stable = !(depth_mm >= point.limit_mm);
    point.probability_stable = point.stable ? 1 : 0;
    if (limit.speed_rpm.size() < 2 || speed_rpm < limit.speed_rpm.front() || speed_rpm > limit.speed_rpm.back())
        return point;
    const double step = limit.speed_rpm[1] - limit.speed_rpm[0];
    const auto i = std::min(static_cast<std::size_t>(std::lround((speed_rpm - limit.speed_rpm.front()) / step)),
                            limit.speed_rpm.size() - 1);
    point.frequency_hz = limit.frequency_hz[i];
    point.k = limit.k[i];
    if (!result.band) return point;
    int stable = 0;
    for (const Draw& draw : drawn(result.parameters)) {
        const double speed = std::clamp(speed_rpm / draw.frequency, limit.speed_rpm.front(), limit.speed_rpm.back());
        stable += !(depth_mm >= draw.depth * depthAt(limit, speed));
    }
    point.probability_stable = static_cast<double>(stable) / static_cast<double>(draws);
    return point;
}

}  // namespace lathelier::stability
