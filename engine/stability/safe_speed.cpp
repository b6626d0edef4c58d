#include "engine/stability/safe_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/stability/refusal.h"

namespace lathelier::stability {
namespace {

constexpr std::size_t mostPeaks = 5;
constexpr int speedsOfRange = 6001;

/// A limit at evenly spaced speeds; infinite where no lobe limits.
class KnownLimit {
public:
    explicit KnownLimit(const LobeLimit& limit) : speed_rpm_(limit.speed_rpm), depth_(limit.depth_mm)
    {
        for (double& depth : depth_)
            if (std::isnan(depth)) depth = std::numeric_limits<double>::infinity();
    }

    const std::vector<double>& speeds() const { return speed_rpm_; }

    double at(double speed_rpm) const
    {
        const auto above = std::lower_bound(speed_rpm_.begin(), speed_rpm_.end(), speed_rpm);
        if (above == speed_rpm_.end()) return depth_.back();
        const auto i = static_cast<std::size_t>(above - speed_rpm_.begin());
        if (i == 0 || *above == speed_rpm) return depth_[i];
        const double share = (speed_rpm - speed_rpm_[i - 1]) / (speed_rpm_[i] - speed_rpm_[i - 1]);
        if (std::isinf(depth_[i - 1]) || std::isinf(depth_[i])) return std::min(depth_[i - 1], depth_[i]);
        return depth_[i - 1] + share * (depth_[i] - depth_[i - 1]);
    }

    std::vector<double> leastNearby() const { return stability::leastNearby(speed_rpm_, depth_); }

private:
    const std::vector<double>& speed_rpm_;
    std::vector<double> depth_;
};

DepthAtSpeed depthAt(const KnownLimit& limit, double speed_rpm, double depth)
{
    DepthAtSpeed found;
    found.speed_rpm = speed_rpm;
    const double most = limit.at(speed_rpm);
    if (std::isinf(most)) return found;
    found.limit = most;
    found.margin = most - depth;
    found.is_stable = depth < most;
    return found;
}

/// Places of the greatest values in the range, each the greatest within twice the robust share; the greatest first.
std::vector<std::size_t> peaksOf(const std::vector<double>& speed_rpm, const std::vector<double>& least,
                                 const SafeSpeedQuestion& question)
{
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < speed_rpm.size(); ++i)
        if (speed_rpm[i] >= question.range_rpm.from && speed_rpm[i] <= question.range_rpm.to) inside.push_back(i);
    const auto distance = [&](std::size_t i) { return std::abs(speed_rpm[i] - question.selected_rpm); };
    std::sort(inside.begin(), inside.end(), [&](std::size_t a, std::size_t b) {
        if (least[a] != least[b]) return least[a] > least[b];
        return distance(a) != distance(b) ? distance(a) < distance(b) : a < b;
    });
    std::vector<std::size_t> peaks;
    for (const std::size_t i : inside) {
        if (peaks.size() == mostPeaks) break;
        const auto isNear = [&](std::size_t peak) {
            return std::abs(speed_rpm[i] - speed_rpm[peak]) <= 2 * robustShare * speed_rpm[peak];
        };
        if (std::any_of(peaks.begin(), peaks.end(), isNear)) continue;
        const bool rises =
            (i > 0 && least[i - 1] > least[i] && speed_rpm[i - 1] >= question.range_rpm.from) ||
            (i + 1 < least.size() && least[i + 1] > least[i] && speed_rpm[i + 1] <= question.range_rpm.to);
        if (!rises) peaks.push_back(i);
    }
    return peaks;
}

Json numberOf(const std::optional<double>& value)
{
    return value ? Json(*value) : Json();
}

Value valueOf(const std::optional<double>& value)
{
    return value ? Value(*value) : Value();
}

}  // namespace

std::optional<double> SafeSpeed::recommendedRpm() const
{
    return best.is_stable ? std::optional(best.speed_rpm) : std::nullopt;
}

Interval usualRange(double selected_rpm)
{
    return {0.5 * selected_rpm, 1.5 * selected_rpm};
}

Interval withMargins(const Interval& range_rpm)
{
    return {range_rpm.from * (1 - robustShare), range_rpm.to * (1 + robustShare)};
}

SafeSpeed safeSpeedOn(const LobeLimit& limit, const SafeSpeedQuestion& question)
{
    SafeSpeed safe;
    safe.question = question;
    const std::vector<double>& known = limit.speed_rpm;
    Interval& range = safe.question.range_rpm;
    range = {std::max(range.from, known.front()), std::min(range.to, known.back())};
    if (!(range.from <= range.to))
        refuse("range_m_min", Value(std::vector<Interval>{question.range_rpm}),
               LT_TEXT("Engine", "speeds that the lobes show"));
    if (question.selected_rpm < known.front() || question.selected_rpm > known.back())
        throw Error(errors::valueOutOfRange, {{"parameter", "operating_speed_rpm"},
                                              {"found", question.selected_rpm},
                                              {"expected", LT_TEXT("Engine", "a number")},
                                              {"minimum", known.front()},
                                              {"maximum", known.back()}});
    const KnownLimit depths(limit);
    safe.selected = depthAt(depths, question.selected_rpm, question.depth);
    for (const std::size_t peak : peaksOf(known, depths.leastNearby(), safe.question))
        safe.peaks.push_back(depthAt(depths, known[peak], question.depth));
    safe.best = safe.peaks.empty() ? safe.selected : safe.peaks.front();
    return safe;
}

SafeSpeed safeSpeed(const Frf& frf, const LobeParameters& lobes, const SafeSpeedQuestion& question,
                    const Progress& progress)
{
    LobeParameters asked = lobes;
    asked.relation = SpeedRelation::Exact;
    const Interval wide = withMargins({std::min(question.range_rpm.from, question.selected_rpm),
                                       std::max(question.range_rpm.to, question.selected_rpm)});
    asked.speed_rpm = {wide};
    asked.points = speedsOfRange;
    return safeSpeedOn(limitOf(frf, asked, progress), question);
}

Json toJson(const SafeSpeed& safe, bool is_relative)
{
    const std::string mm = is_relative ? "" : "_mm";
    const auto one = [&](const DepthAtSpeed& at) {
        Json json = {{"speed_rpm", at.speed_rpm}, {"is_stable", at.is_stable}};
        json["depth_limit" + mm] = numberOf(at.limit);
        json["margin" + mm] = numberOf(at.margin);
        return json;
    };
    Json json;
    json["depth" + mm] = safe.question.depth;
    json["stable_at_selected"] = safe.selected.is_stable;
    json["largest_depth_at_selected" + mm] = numberOf(safe.selected.limit);
    json["range_rpm"] = {{"from", safe.question.range_rpm.from}, {"to", safe.question.range_rpm.to}};
    json["best"] = one(safe.best);
    json["pockets"] = Json::array();
    for (const DepthAtSpeed& peak : safe.peaks) json["pockets"].push_back(one(peak));
    return json;
}

std::vector<report::Finding> findingsOf(const SafeSpeed& safe, bool is_relative, const char* speedKey)
{
    std::vector<report::Finding> findings;
    report::Finding best;
    best.values = {{"speed", std::round(safe.best.speed_rpm)},
                   {"depth", safe.question.depth},
                   {"depth_mm", safe.question.depth},
                   {"limit", valueOf(safe.best.limit)},
                   {"limit_mm", valueOf(safe.best.limit)},
                   {"from", std::round(safe.question.range_rpm.from)},
                   {"to", std::round(safe.question.range_rpm.to)}};
    if (!safe.best.limit)
        best.pattern = LT_TEXT("Engine", "Recommended: {speed:0} 1/min, where no lobe limits the depth");
    else if (safe.best.is_stable)
        best.pattern = is_relative ? LT_TEXT("Engine", "Recommended: {speed:0} 1/min, stable up to {limit:3} ×")
                                   : LT_TEXT("Engine", "Recommended: {speed:0} 1/min, stable up to {limit_mm:3+} mm");
    else
        best.pattern =
            is_relative ? LT_TEXT("Engine",
                                  "No speed from {from:0} to {to:0} 1/min is stable at {depth:3} ×; the most is "
                                  "{limit:3} × at {speed:0} 1/min")
                        : LT_TEXT("Engine",
                                  "No speed from {from:0} to {to:0} 1/min is stable at {depth_mm:3+} mm; the most is "
                                  "{limit_mm:3+} mm at {speed:0} 1/min");
    best.verdict = safe.best.is_stable ? std::nullopt : std::optional(Verdict::Fail);
    best.offer = {{speedKey, std::round(safe.best.speed_rpm)}};
    findings.push_back(std::move(best));
    if (!safe.selected.is_stable)
        findings.push_back({is_relative ? LT_TEXT("Engine", "At {speed:0} 1/min no deeper than {limit:3} ×")
                                        : LT_TEXT("Engine", "At {speed:0} 1/min no deeper than {limit_mm:3+} mm"),
                            {{"speed", std::round(safe.question.selected_rpm)},
                             {"limit", valueOf(safe.selected.limit)},
                             {"limit_mm", valueOf(safe.selected.limit)}},
                            {},
                            {}});
    return findings;
}

}  // namespace lathelier::stability
