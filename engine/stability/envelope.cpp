#include "engine/stability/envelope.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::stability {
namespace {

int leastLobe(SpeedRelation relation)
{
    return relation == SpeedRelation::Published ? 1 : 0;
}

double speedOf(const BoundaryPoint& point, int k, SpeedRelation relation)
{
    return 60 * point.frequency_hz / (relation == SpeedRelation::Published ? k : k + point.phase_turns);
}

CurvePoint curvePoint(const BoundaryPoint& point, int k, SpeedRelation relation)
{
    return {speedOf(point, k, relation), 1 / point.compliance_mm_N, point.frequency_hz};
}

}  // namespace

LowerEnvelope::LowerEnvelope(const Interval& speed_rpm, int points)
    : from_(speed_rpm.from), to_(speed_rpm.to), step_((to_ - from_) / (points - 1)), last_(points - 1)
{
    const auto count = static_cast<std::size_t>(points);
    limit_ = {{},
              std::vector<double>(count, notANumber),
              std::vector<double>(count, notANumber),
              std::vector<int>(count, -1)};
    limit_.speed_rpm.reserve(count);
    for (int i = 0; i < points; ++i) limit_.speed_rpm.push_back(i + 1 == points ? to_ : from_ + i * step_);
}

void LowerEnvelope::add(const LobeCurve& curve)
{
    if (!(step_ > 0)) return;
    for (const auto& stretch : curve.stretches)
        for (std::size_t i = 1; i < stretch.size(); ++i) add(stretch[i - 1], stretch[i], curve.k);
}

void LowerEnvelope::add(const CurvePoint& a, const CurvePoint& b, int k)
{
    const double low = std::min(a.speed_rpm, b.speed_rpm), high = std::max(a.speed_rpm, b.speed_rpm);
    if (high < from_ || low > to_) return;
    const double first = std::max(0.0, std::ceil((low - from_) / step_));
    const double last = std::min(last_, std::floor((high - from_) / step_));
    for (double place = first; place <= last; ++place) {
        const auto i = static_cast<std::size_t>(place);
        const double share =
            high > low ? std::clamp((limit_.speed_rpm[i] - a.speed_rpm) / (b.speed_rpm - a.speed_rpm), 0.0, 1.0) : 0;
        const double depth = a.depth_N_mm + share * (b.depth_N_mm - a.depth_N_mm);
        if (limit_.k[i] >= 0 && depth >= limit_.depth_mm[i]) continue;
        limit_.depth_mm[i] = depth;
        limit_.frequency_hz[i] = a.frequency_hz + share * (b.frequency_hz - a.frequency_hz);
        limit_.k[i] = k;
    }
}

LobeRange lobesWithin(const std::vector<BoundaryPoint>& stretch, SpeedRelation relation, const Interval& speed_rpm)
{
    const double low = 60 * stretch.front().frequency_hz / speed_rpm.to;
    const double high = 60 * stretch.back().frequency_hz / speed_rpm.from;
    return {std::max(leastLobe(relation), static_cast<int>(std::floor(low)) - 1), static_cast<int>(std::floor(high))};
}

LobeRange lobesWithin(const Boundary& boundary, SpeedRelation relation, const Interval& speed_rpm)
{
    LobeRange all{1 << 30, -1};
    for (const auto& stretch : boundary) {
        const LobeRange range = lobesWithin(stretch, relation, speed_rpm);
        all = {std::min(all.first, range.first), std::max(all.last, range.last)};
    }
    return all;
}

LobeCurve lobeCurve(const Boundary& boundary, int k, SpeedRelation relation)
{
    LobeCurve curve{k, {}};
    curve.stretches.reserve(boundary.size());
    for (const auto& stretch : boundary) {
        std::vector<CurvePoint>& points = curve.stretches.emplace_back();
        points.reserve(stretch.size());
        for (const BoundaryPoint& point : stretch) points.push_back(curvePoint(point, k, relation));
    }
    return curve;
}

LobeCurve lobeCurve(const Boundary& boundary, int k, SpeedRelation relation, const Interval& speed_rpm)
{
    LobeCurve curve{k, {}};
    // The turns of a point are k to k + 1.
    const double low = speed_rpm.from * k / 60;
    const double high = speed_rpm.to * (relation == SpeedRelation::Published ? k : k + 1) / 60;
    for (const auto& stretch : boundary) {
        auto from = std::lower_bound(stretch.begin(), stretch.end(), low,
                                     [](const BoundaryPoint& p, double f) { return p.frequency_hz < f; });
        auto to = std::upper_bound(from, stretch.end(), high,
                                   [](double f, const BoundaryPoint& p) { return f < p.frequency_hz; });
        if (from != stretch.begin()) --from;
        if (to != stretch.end()) ++to;
        if (to - from < 2) continue;
        std::vector<CurvePoint>& points = curve.stretches.emplace_back();
        points.reserve(static_cast<std::size_t>(to - from));
        for (; from != to; ++from) points.push_back(curvePoint(*from, k, relation));
    }
    return curve;
}

LobeLimit envelope(const Boundary& boundary, SpeedRelation relation, const Interval& speed_rpm, int points)
{
    LowerEnvelope limit(speed_rpm, points);
    const LobeRange range = lobesWithin(boundary, relation, speed_rpm);
    for (int k = range.first; k <= range.last; ++k) limit.add(lobeCurve(boundary, k, relation, speed_rpm));
    return limit.take();
}

/// Linear interpolation between the speeds of the limit; NaN if a neighbour is NaN.
double depthAt(const LobeLimit& limit, double speed_rpm)
{
    const std::size_t count = limit.speed_rpm.size();
    if (count < 2 || speed_rpm < limit.speed_rpm.front() || speed_rpm > limit.speed_rpm.back()) return notANumber;
    const double step = (limit.speed_rpm.back() - limit.speed_rpm.front()) / static_cast<double>(count - 1);
    const double place = (speed_rpm - limit.speed_rpm.front()) / step;
    const auto i = std::min(static_cast<std::size_t>(place), count - 2);
    const double share = place - static_cast<double>(i);
    return (1 - share) * limit.depth_mm[i] + share * limit.depth_mm[i + 1];
}

}  // namespace lathelier::stability
