#include "engine/deflection/what_if.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/last_pass.h"

namespace lathelier::deflection {
namespace {

constexpr double tornado = 0.1;
constexpr double share_per_percent = 0.01;
constexpr double outside = 0.025;  ///< share of samples beyond each side of a 95 % band
constexpr std::size_t cellsAtOnce = 4, samplesAtOnce = 4;

std::vector<double> spread(double from, double to, int count)
{
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) result.push_back(from + (to - from) * i / std::max(1, count - 1));
    return result;
}

/// Plan of the last pass alone, on the workpiece before it.
WorkPlan lastPassAlone(const WorkPlan& plan, const TurningSetup& setup)
{
    const LastPass last = lastPassOf(plan, setup);
    WorkPlan alone = plan;
    alone.outer_start_mm = last.work.outerStart_mm();
    alone.outer_end_mm = last.work.outerEnd_mm();
    alone.cuts = {plan.cuts[last.cut]};
    return alone;
}

void setDepth(WorkPlan& plan, double depth_mm)
{
    const CutPlan& cut = plan.cuts.front();
    for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
        plan.outer_start_mm[cut.first + i] = cut.pieces[i].start_mm + depth_mm;
        plan.outer_end_mm[cut.first + i] = cut.pieces[i].end_mm + depth_mm;
    }
}

/// Cutting time at constant cutting speed: ∫ πD dz/(v f).
double timeOf_s(const WorkPlan& plan, double feed_mm_rev, double speed_m_min)
{
    const CutPlan& cut = plan.cuts.front();
    double turned_mm2 = 0;
    for (std::size_t i = 0; i < cut.pieces.size(); ++i)
        turned_mm2 += std::numbers::pi * (cut.pieces[i].start_mm + cut.pieces[i].end_mm) *
                      (plan.z_mm[cut.first + i + 1] - plan.z_mm[cut.first + i]);
    return turned_mm2 / feed_mm_rev / (1000 * speed_m_min / 60);
}

WorkPlan withFeed(WorkPlan plan, double factor)
{
    for (CutPlan& cut : plan.cuts)
        for (CutPiece& piece : cut.pieces) piece.feed_mm_rev *= factor;
    return plan;
}

}  // namespace

const std::vector<Field<MapParameters>>& fieldsOf(const MapParameters*)
{
    using P = MapParameters;
    static const auto all = described<P>(
        field("least_depth_mm", &P::least_depth_mm, {1e-3, 1e3},
              Label{LT_TEXT("Engine", "Least depth"), LT_TEXT("Engine", "Of the last pass."), unit::mm}),
        field("largest_depth_mm", &P::largest_depth_mm, {1e-3, 1e3},
              Label{LT_TEXT("Engine", "Largest depth"), LT_TEXT("Engine", "Of the last pass."), unit::mm}),
        field("map_least_feed_mm_rev", &P::least_feed_mm_rev, {1e-3, 10},
              Label{LT_TEXT("Engine", "Least feed"), LT_TEXT("Engine", "Of the map."), unit::mm_rev}),
        field("map_largest_feed_mm_rev", &P::largest_feed_mm_rev, {1e-3, 10},
              Label{LT_TEXT("Engine", "Largest feed"), LT_TEXT("Engine", "Of the map."), unit::mm_rev}),
        field("depths", &P::depths, {2, 500}, Label{LT_TEXT("Engine", "Depths"), LT_TEXT("Engine", "In the map.")}),
        field("feeds", &P::feeds, {2, 500}, Label{LT_TEXT("Engine", "Feeds"), LT_TEXT("Engine", "In the map.")}),
        field("map_tolerance_um", &P::tolerance_um, {0, 1e5},
              Label{LT_TEXT("Engine", "Tolerance"), LT_TEXT("Engine", "Of the diameter error, to both sides."),
                    unit::um}),
        field("cutting_speed_m_min", &P::cutting_speed_m_min, {0.1, 1e4},
              Label{LT_TEXT("Engine", "Cutting speed"), LT_TEXT("Engine", "For the cycle time."), unit::m_min}));
    return all;
}

const std::vector<Field<BandParameters>>& fieldsOf(const BandParameters*)
{
    using P = BandParameters;
    static const auto all =
        described<P>(field("springs_percent", &P::springs_percent, {0, 100},
                           Label{LT_TEXT("Engine", "Uncertainty of springs"),
                                 LT_TEXT("Engine", "Standard, each by itself."), unit::percent}),
                     field("forces_percent", &P::forces_percent, {0, 100},
                           Label{LT_TEXT("Engine", "Uncertainty of forces"),
                                 LT_TEXT("Engine", "Standard, all together."), unit::percent}),
                     field("modulus_percent", &P::modulus_percent, {0, 100},
                           Label{LT_TEXT("Engine", "Uncertainty of the elastic modulus"),
                                 LT_TEXT("Engine", "Standard."), unit::percent}),
                     field("samples", &P::samples, {20, 100000},
                           Label{LT_TEXT("Engine", "Samples"), LT_TEXT("Engine", "Drawn for the band."), {}, true}),
                     field("seed", &P::seed, {0, 1000000000},
                           Label{LT_TEXT("Engine", "Seed"), LT_TEXT("Engine", "Of the random numbers."), {}, true}));
    return all;
}

DeflectionMap deflectionMap(const WorkPlan& plan, const TurningSetup& setup, const MapParameters& parameters,
                            const Progress& progress)
{
    DeflectionMap map;
    map.parameters = parameters;
    map.depth_mm = spread(parameters.least_depth_mm, parameters.largest_depth_mm, parameters.depths);
    const double largest =
        std::min(parameters.largest_feed_mm_rev, largestFeedShare * setup.tool.corner_radius_mm.value_or(0));
    map.feed_mm_rev = spread(std::min(parameters.least_feed_mm_rev, largest), largest, parameters.feeds);
    const WorkPlan alone = lastPassAlone(plan, setup);
    const std::size_t columns = map.depth_mm.size();
    map.max_um.assign(columns * map.feed_mm_rev.size(), notANumber);
    parallelFor(map.max_um.size(), cellsAtOnce, progress, [&](std::size_t begin, std::size_t end) {
        WorkPlan cell = alone;
        for (std::size_t i = begin; i < end; ++i) {
            setDepth(cell, map.depth_mm[i % columns]);
            for (CutPiece& piece : cell.cuts.front().pieces) piece.feed_mm_rev = map.feed_mm_rev[i / columns];
            try {
                map.max_um[i] = summaryOf(finalContour(cell, setup)).max_um;
            } catch (const Error& error) {
                if (!(error.code() == errors::workGivesWay)) throw;
            }
        }
    });
    const CutPlan& last = alone.cuts.front();
    double depths_mm = 0, cuts = 0;
    for (std::size_t i = 0; i < last.pieces.size(); ++i) {
        const double depth_mm = alone.outer_start_mm[last.first + i] - last.pieces[i].start_mm;
        if (depth_mm <= 0) continue;
        depths_mm += depth_mm;
        ++cuts;
        map.programmed_feed_mm_rev = last.pieces[i].feed_mm_rev;
    }
    if (cuts > 0) map.programmed_depth_mm = depths_mm / cuts;
    if (parameters.cutting_speed_m_min)
        for (const double feed : map.feed_mm_rev)
            map.time_s.insert(map.time_s.end(), columns, timeOf_s(alone, feed, *parameters.cutting_speed_m_min));
    return map;
}

std::vector<Sensitivity> sensitivities(const WorkPlan& plan, const TurningSetup& setup)
{
    std::vector<Sensitivity> found;
    const auto add = [&found](const char* key, Text name, const ErrorSummary& minus, const ErrorSummary& plus) {
        found.push_back({key, name, minus.max_um, plus.max_um, minus.mean_abs_um, plus.mean_abs_um});
    };
    for (const InfluenceName& one : influences())
        if (hasInfluence(setup, one.influence))
            add(one.key, one.name, summaryOf(finalContour(plan, scaled(setup, one.influence, 1 - tornado))),
                summaryOf(finalContour(plan, scaled(setup, one.influence, 1 + tornado))));
    add("feed", LT_TEXT("Engine", "Feed"), summaryOf(finalContour(withFeed(plan, 1 - tornado), setup)),
        summaryOf(finalContour(withFeed(plan, 1 + tornado), setup)));
    const auto with_corner = [&](double factor) {
        TurningSetup other = setup;
        other.tool.corner_radius_mm = other.tool.corner_radius_mm.value_or(0) * factor;
        return summaryOf(finalContour(plan, other));
    };
    add("corner_radius", LT_TEXT("Engine", "Corner radius"), with_corner(1 - tornado), with_corner(1 + tornado));
    std::stable_sort(found.begin(), found.end(), [](const Sensitivity& a, const Sensitivity& b) {
        return std::abs(a.swing_um()) > std::abs(b.swing_um());
    });
    return found;
}

ErrorBand errorBand(const WorkPlan& plan, const TurningSetup& setup, const BandParameters& parameters,
                    const Progress& progress)
{
    ErrorBand band;
    band.parameters = parameters;
    band.z_mm = finalContour(plan, setup).z_mm;
    const auto count = static_cast<std::size_t>(parameters.samples);
    std::vector<std::vector<double>> errors_um(count);
    const auto sample = [&](std::size_t index) {
        TurningSetup drawn = setup;
        for (const InfluenceName& one : influences()) {
            const bool is_force = one.influence == Influence::Forces, is_modulus = one.influence == Influence::Modulus;
            const double share = share_per_percent * (is_force     ? parameters.forces_percent
                                                      : is_modulus ? parameters.modulus_percent
                                                                   : parameters.springs_percent);
            const double normal = randomNormal(static_cast<std::uint64_t>(parameters.seed),
                                               static_cast<std::uint64_t>(one.influence), index);
            drawn = scaled(std::move(drawn), one.influence, std::exp(std::sqrt(std::log1p(share * share)) * normal));
        }
        return drawn;
    };
    parallelFor(count, samplesAtOnce, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            try {
                errors_um[i] = finalContour(plan, sample(i)).diameter_error_um;
            } catch (const Error& error) {
                if (!(error.code() == errors::workGivesWay)) throw;
            }
        }
    });
    // Samples with a different set of cut positions than the nominal result are not comparable.
    std::erase_if(errors_um, [&](const std::vector<double>& one) { return one.size() != band.z_mm.size(); });
    band.samples_used = static_cast<int>(errors_um.size());
    std::vector<double> values, largest_um;
    values.reserve(errors_um.size());
    largest_um.reserve(errors_um.size());
    for (std::size_t k = 0; k < band.z_mm.size(); ++k) {
        values.clear();
        for (const std::vector<double>& one : errors_um) values.push_back(one[k]);
        band.low_um.push_back(quantileInPlace(values, outside));
        band.high_um.push_back(quantileInPlace(values, 1 - outside));
    }
    for (const std::vector<double>& one : errors_um) {
        double largest = 0;
        for (const double e : one) largest = std::max(largest, std::abs(e));
        largest_um.push_back(largest);
    }
    band.max_low_um = quantileInPlace(largest_um, outside);
    band.max_high_um = quantileInPlace(largest_um, 1 - outside);
    return band;
}

}  // namespace lathelier::deflection
