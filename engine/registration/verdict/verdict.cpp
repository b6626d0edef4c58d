#include "engine/registration/verdict/verdict.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/verdict/findings.h"
#include "engine/registration/verdict/surface_verdict.h"
#include "engine/registration/verdict/zone_limits.h"

namespace lathelier::registration {
namespace {

constexpr std::size_t judgedPerTask = 65536;
constexpr double clearlyAbove = 1.1;      // of the scanner's accuracy, which is known to about 10 %
constexpr double zoneCoverage = 2;        // factor of an expanded uncertainty, 95 %
constexpr double discPerSquare = 1.1284;  // 2/√π: diameter of the disc of a square's area, over its side
constexpr double shownSizesPerMm = 10;    // the size of a defect is rounded up to 0.1 mm
constexpr double leastLimit_mm = 1e-9;    // that a needed uncertainty is compared with

/// Points that have limits, and those within them.
struct Share {
    std::int64_t within = 0;
    std::int64_t all = 0;
};

Share countWithin(const CompareResult& result, const LimitsAlong& limits, const Progress& progress)
{
    const bool along = !result.parameters.zones.empty() && result.windows && !result.windows->z_mm.empty();
    const auto everywhere = along ? std::nullopt : limits.at(0);
    const auto count = [&](std::size_t begin, std::size_t end) {
        Share share;
        for (std::size_t i = begin; i < end; ++i) {
            if (!result.used[i]) continue;
            const auto here = along ? limits.at(static_cast<double>(result.windows->z_mm[i])) : everywhere;
            if (!here) continue;
            const auto deviation = static_cast<double>(result.deviation_mm[i]);
            share.within += deviation >= here->lower_mm && deviation <= here->upper_mm;
            share.all += 1;
        }
        return share;
    };
    return parallelReduce(result.used.size(), judgedPerTask, progress, Share{}, count,
                          [](Share all, const Share& part) {
                              return Share{all.within + part.within, all.all + part.all};
                          });
}

/// Number, sum and sum of squares of the deviations of each zone.
struct ZoneSums {
    std::vector<std::array<double, 3>> of;
};

/// The zones that are given, in order of z, else the automatic ones; without their means.
std::vector<Zone> emptyZones(std::vector<ZoneLimits> given, const std::vector<Interval>& automatic)
{
    std::sort(given.begin(), given.end(),
              [](const ZoneLimits& a, const ZoneLimits& b) { return a.z_start_mm < b.z_start_mm; });
    std::vector<Zone> zones;
    for (const ZoneLimits& zone : given) {
        zones.emplace_back();
        zones.back().z_start_mm = zone.z_start_mm;
        zones.back().z_end_mm = zone.z_end_mm;
        zones.back().name = zone.name;
        zones.back().lower_mm = zone.lower_mm;
        zones.back().upper_mm = zone.upper_mm;
    }
    if (given.empty())
        for (const Interval& zone : automatic) {
            zones.emplace_back();
            zones.back().z_start_mm = zone.from;
            zones.back().z_end_mm = zone.to;
        }
    return zones;
}

ZoneSums zoneSumsOf(const CompareResult& result, const std::vector<Zone>& zones, const Progress& progress)
{
    const SurfaceWindows& all = *result.windows;
    const ZoneSums empty{std::vector<std::array<double, 3>>(zones.size())};
    const auto sumsOf = [&](std::size_t begin, std::size_t end) {
        ZoneSums sums = empty;
        for (std::size_t i = begin; i < end; ++i) {
            if (all.counted[i] != 1) continue;  // faces lie across the axis and are no part of a zone's mean
            const auto z = static_cast<double>(all.z_mm[i]);
            const auto after = std::upper_bound(zones.begin(), zones.end(), z,
                                                [](double value, const Zone& zone) { return value < zone.z_start_mm; });
            if (after == zones.begin() || !(z <= (after - 1)->z_end_mm)) continue;
            auto& [count, sum, squares] = sums.of[static_cast<std::size_t>(after - 1 - zones.begin())];
            const auto deviation = static_cast<double>(result.deviation_mm[i]);
            count += 1;
            sum += deviation;
            squares += deviation * deviation;
        }
        return sums;
    };
    return parallelReduce(all.counted.size(), judgedPerTask, progress, empty, sumsOf,
                          [](ZoneSums to, const ZoneSums& from) {
                              for (std::size_t k = 0; k < to.of.size(); ++k)
                                  for (std::size_t j = 0; j < 3; ++j) to.of[k][j] += from.of[k][j];
                              return to;
                          });
}

/// The zones with their means; automatic ones only where there are points.
std::vector<Zone> zonesOf(const CompareResult& result, const Progress& progress)
{
    if (!result.windows || result.windows->z_mm.empty()) return {};
    const SurfaceWindows& all = *result.windows;
    std::vector<Zone> zones = emptyZones(result.parameters.zones, all.automatic_zones_mm);
    if (zones.empty()) return zones;
    const ZoneSums sums = zoneSumsOf(result, zones, progress);
    for (std::size_t k = 0; k < zones.size(); ++k) {
        const auto& [count, sum, squares] = sums.of[k];
        Zone& zone = zones[k];
        zone.points = static_cast<std::int64_t>(count);
        zone.mean_mm = count > 0 ? sum / count : notANumber;
        zone.std_mm = count > 1 ? std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1))) : notANumber;
        if (count > 0)
            zone.uncertainty_mm = zoneCoverage * meanSigma_mm(all, zone.z_start_mm, zone.z_end_mm, count,
                                                              meanNormal(all, zone.z_start_mm, zone.z_end_mm));
    }
    if (result.parameters.zones.empty()) std::erase_if(zones, [](const Zone& zone) { return zone.points == 0; });
    return zones;
}

/// Notes that small defects may be hidden, or that the uncertainty is too large for the limits.
void noteResolution(CompareResult& result, const WindowsVerdict& whole)
{
    const double smallest_mm = whole.defect_mm();
    if (smallest_mm <= leastDefect_mm) return;
    double limit = std::numeric_limits<double>::infinity();
    if (const auto& tolerance = result.parameters.tolerance_mm) limit = *tolerance;
    for (const ZoneLimits& zone : result.parameters.zones)
        if (zone.lower_mm) limit = std::min(limit, (*zone.upper_mm - *zone.lower_mm) / 2);
    if (smallest_mm <= largestDefect_mm) {
        const double across_mm = std::ceil(shownSizesPerMm * discPerSquare * smallest_mm) / shownSizesPerMm;
        result.notes.push_back({notes::smallDefectsHidden, {{"size_mm", across_mm}, {"limit_mm", limit}}});
        return;
    }
    const double ratio = whole.needed_mm / std::max(limit, leastLimit_mm);
    result.notes.push_back({notes::scanTooPoor,
                            {{"limit_mm", limit},
                             {"cell_mm", whole.cell_mm},
                             {"uncertainty_mm", whole.needed_mm},
                             {"times", std::ceil(ratio * ratio)}}});
}

void judgeSurface(CompareResult& result, const LimitsAlong& limits)
{
    const SurfaceWindows& all = *result.windows;
    const SurfaceVerdict found = judgeWindows(all, limits, result.parameters.decision, result.zones);
    result.worst = found.worst;
    result.findings = findDifferences(all, limits, result.parameters.decision, found.factor);
    if (result.parameters.verdict_rule != VerdictRule::Surface || !limits.any()) return;
    const DecisionRule rule = result.parameters.decision;
    for (std::size_t k = 0; k < result.zones.size(); ++k) result.zones[k].verdict = found.zones[k].verdict(rule);
    std::optional<Verdict> verdict = found.all.verdict(rule);
    for (const Finding& finding : result.findings) {
        if (!verdict || !finding.verdict) continue;
        verdict = worse(*verdict, *finding.verdict);
        for (Zone& zone : result.zones)
            if (zone.verdict && *finding.z_start_mm >= zone.z_start_mm && *finding.z_end_mm <= zone.z_end_mm)
                zone.verdict = worse(*zone.verdict, *finding.verdict);
    }
    // A mesh whose corners all lie at edges has no local means; where every point is within, so is the surface.
    if (!verdict && result.within_tolerance_percent == 100.0) verdict = Verdict::Pass;
    if (!verdict) {
        result.notes.push_back({notes::nothingToJudge, {}});
        verdict = Verdict::Undecided;
    }
    result.verdict = verdict;
    noteResolution(result, found.all);
}

void judgePoints(CompareResult& result, const Share& share)
{
    if (result.parameters.verdict_rule != VerdictRule::Points || share.all == 0) return;
    result.verdict = *result.within_tolerance_percent >= result.parameters.pass_percent ? Verdict::Pass : Verdict::Fail;
}

}  // namespace

bool sameButVerdict(const CompareParameters& a, const CompareParameters& b)
{
    return a.method == b.method && a.symmetry == b.symmetry && a.initial == b.initial &&
           a.max_distance_mm == b.max_distance_mm && a.exclude_z_mm == b.exclude_z_mm;
}

CompareParameters fittedOf(const CompareParameters& parameters)
{
    CompareParameters fitted;
    fitted.method = parameters.method;
    fitted.symmetry = parameters.symmetry;
    fitted.initial = parameters.initial;
    fitted.max_distance_mm = parameters.max_distance_mm;
    fitted.exclude_z_mm = parameters.exclude_z_mm;
    return fitted;
}

void judge(CompareResult& result, const CompareParameters& parameters, const Progress& progress)
{
    checkZones(parameters.zones);
    result.parameters.tolerance_mm = parameters.tolerance_mm;
    result.parameters.verdict_rule = parameters.verdict_rule;
    result.parameters.decision = parameters.decision;
    result.parameters.zones = parameters.zones;
    result.parameters.pass_percent = parameters.pass_percent;
    result.parameters.scanner_accuracy_mm = parameters.scanner_accuracy_mm;
    result.within_tolerance_percent.reset();
    result.verdict.reset();
    result.worst.reset();
    result.findings.clear();
    result.distinguishable_from_scanner.reset();
    std::erase_if(result.notes, [](const Note& note) {
        return note.code == notes::notDistinguishable || note.code == notes::scanTooPoor ||
               note.code == notes::smallDefectsHidden || note.code == notes::nothingToJudge;
    });

    const LimitsAlong limits(parameters.tolerance_mm, parameters.zones);
    if (limits.any() && result.statistics.points_used > 0) {
        const Share share = countWithin(result, limits, progress);
        if (share.all > 0)
            result.within_tolerance_percent =
                100.0 * static_cast<double>(share.within) / static_cast<double>(share.all);
        judgePoints(result, share);
    }
    result.zones = zonesOf(result, progress);
    if (result.windows) {
        result.scatter_mm = result.windows->scatter_mm;
        judgeSurface(result, limits);
    }
    if (parameters.scanner_accuracy_mm) {
        result.distinguishable_from_scanner =
            result.statistics.rmse_mm > clearlyAbove * *parameters.scanner_accuracy_mm;
        if (!*result.distinguishable_from_scanner)
            result.notes.push_back(
                {notes::notDistinguishable, {{"scanner_accuracy_mm", *parameters.scanner_accuracy_mm}}});
    }
}

}  // namespace lathelier::registration
