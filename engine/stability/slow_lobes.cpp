#include "engine/stability/slow_lobes.h"

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"

namespace lathelier::stability {
namespace {

/// Fraction of a turn that the relation adds to the waves of lobe k.
double turnsOf(const BoundaryPoint& point, SpeedRelation relation)
{
    return relation == SpeedRelation::Exact ? point.phase_turns : 0;
}

}  // namespace

LimitsBySpeed::LimitsBySpeed(const Boundary& boundary, SpeedRelation relation)
    : first_(relation == SpeedRelation::Exact ? 0 : 1)
{
    for (const auto& stretch : boundary)
        for (std::size_t i = 1; i < stretch.size(); ++i) {
            const BoundaryPoint &a = stretch[i - 1], &b = stretch[i];
            const double depth_a = 1 / a.compliance_mm_N, depth_b = 1 / b.compliance_mm_N;
            pieces_.push_back({std::min(depth_a, depth_b),
                               {depth_a, depth_b},
                               {a.frequency_hz, b.frequency_hz},
                               {turnsOf(a, relation), turnsOf(b, relation)}});
        }
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece& a, const Piece& b) { return a.least_N_mm < b.least_N_mm; });
}

SpeedLimit LimitsBySpeed::at(double speed_rpm) const
{
    SpeedLimit least{HUGE_VAL};
    for (const Piece& piece : pieces_) {
        if (piece.least_N_mm >= least.depth_N_mm) break;
        const double before = 60 * piece.frequency_hz[0] / speed_rpm - piece.turns[0];
        const double after = 60 * piece.frequency_hz[1] / speed_rpm - piece.turns[1];
        const double lower = std::max(std::ceil(std::min(before, after)), first_);
        const double upper = std::floor(std::max(before, after));
        if (upper < lower || after == before) continue;
        // Of several whole numbers that which is nearest to the end with the lesser depth.
        const bool rises = piece.depth_N_mm[0] < piece.depth_N_mm[1];
        const double whole = rises == (before < after) ? lower : upper;
        const double share = (whole - before) / (after - before);
        const auto between = [&](const double(&ends)[2]) { return ends[0] + (ends[1] - ends[0]) * share; };
        if (const double depth = between(piece.depth_N_mm); depth < least.depth_N_mm)
            least = {depth, between(piece.frequency_hz), static_cast<int>(whole)};
    }
    return least;
}

LobeLimit envelopeBySpeed(const Boundary& boundary, SpeedRelation relation, const Interval& speed_rpm, int points,
                          const Progress& progress)
{
    const auto count = static_cast<std::size_t>(points);
    LobeLimit limit{std::vector<double>(count), std::vector<double>(count, notANumber),
                    std::vector<double>(count, notANumber), std::vector<int>(count, -1)};
    const LimitsBySpeed limits(boundary, relation);
    const double step = (speed_rpm.to - speed_rpm.from) / static_cast<double>(std::max<std::size_t>(1, count - 1));
    parallelFor(count, 8, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            limit.speed_rpm[i] = i + 1 == count ? speed_rpm.to : speed_rpm.from + static_cast<double>(i) * step;
            const SpeedLimit at = limits.at(limit.speed_rpm[i]);
            if (at.k < 0) continue;
            limit.depth_mm[i] = at.depth_N_mm;
            limit.frequency_hz[i] = at.frequency_hz;
            limit.k[i] = at.k;
        }
    });
    return limit;
}

std::vector<int> strongestLobes(const Boundary& boundary, SpeedRelation relation, const Interval& speed_rpm, int first,
                                int last, std::size_t most)
{
    BoundaryPoint foot;
    for (const auto& stretch : boundary)
        for (const BoundaryPoint& point : stretch)
            if (point.compliance_mm_N > foot.compliance_mm_N) foot = point;
    const double turns = turnsOf(foot, relation);
    const auto waves = [&](double speed) { return 60 * foot.frequency_hz / speed - turns; };
    const auto within = [&](double k) { return std::clamp(k, static_cast<double>(first), static_cast<double>(last)); };
    const int from = static_cast<int>(within(std::ceil(waves(speed_rpm.to))));
    const int to = static_cast<int>(within(std::floor(waves(speed_rpm.from))));
    std::vector<int> lobes;
    for (int k = from; k <= to && lobes.size() < most; ++k) lobes.push_back(k);
    for (int away = 1; lobes.size() < most && (from - away >= first || to + away <= last); ++away) {
        if (from - away >= first) lobes.push_back(from - away);
        if (to + away <= last && lobes.size() < most) lobes.push_back(to + away);
    }
    std::sort(lobes.begin(), lobes.end());
    return lobes;
}

}  // namespace lathelier::stability
