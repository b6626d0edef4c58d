#include "engine/deflection/feed_adjustment.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/last_pass.h"

namespace lathelier::deflection {
namespace {

constexpr int triedFeeds = 24;

}  // namespace

const std::vector<Field<FeedParameters>>& fieldsOf(const FeedParameters*)
{
    using P = FeedParameters;
    static const auto all = described<P>(
        field("tolerance_um", &P::tolerance_um, {0.01, 1e5},
              Label{LT_TEXT("Engine", "Tolerance"), LT_TEXT("Engine", "Of the diameter error, to both sides."),
                    unit::um}),
        field("least_feed_mm_rev", &P::least_feed_mm_rev, {1e-3, 10},
              Label{LT_TEXT("Engine", "Least feed"), LT_TEXT("Engine", "The edge rubs below."), unit::mm_rev}),
        field("largest_feed_mm_rev", &P::largest_feed_mm_rev, {1e-3, 10},
              Label{LT_TEXT("Engine", "Largest feed"), LT_TEXT("Engine", "Roughness and insert allow no more."),
                    unit::mm_rev}));
    return all;
}

FeedResult feedForTolerance(const WorkPlan& plan, const TurningSetup& setup, const FeedParameters& parameters)
{
    FeedResult result;
    result.parameters = parameters;
    const LastPass last = lastPassOf(plan, setup);
    CutPlan cut = plan.cuts[last.cut];
    const double largest =
        std::min(parameters.largest_feed_mm_rev, largestFeedShare * setup.tool.corner_radius_mm.value_or(0));
    const double least = std::min(parameters.least_feed_mm_rev, largest);
    std::vector<double> feeds(cut.pieces.size(), 0);
    std::vector<Station> stations;
    const auto errors_um = [&] {
        TurningWork work = last.work;
        work.take(cut, CutTask::Predict, stations);
        std::vector<double> largest_um(cut.pieces.size(), 0);
        for (const Station& s : stations)
            largest_um[s.piece] = std::max(largest_um[s.piece], um_per_mm_of_diameter * std::abs(s.radius_mm - s.x_mm));
        return largest_um;
    };
    for (int i = 0; i < triedFeeds; ++i) {
        const double feed = least * std::pow(largest / least, static_cast<double>(i) / (triedFeeds - 1));
        for (CutPiece& piece : cut.pieces) piece.feed_mm_rev = feed;
        const std::vector<double> found_um = errors_um();
        for (std::size_t k = 0; k < feeds.size(); ++k)
            if (found_um[k] <= parameters.tolerance_um) feeds[k] = feed;
    }
    double time = 0, programmed_time = 0;
    for (std::size_t k = 0; k < feeds.size(); ++k) {
        const double z_mm = plan.z_mm[cut.first + k], width_mm = plan.z_mm[cut.first + k + 1] - z_mm;
        if (feeds[k] == 0) {
            if (result.notes.empty())
                result.notes.push_back(
                    {notes::feedCannotHold,
                     {{"z_mm", z_mm}, {"tolerance_um", parameters.tolerance_um}, {"feed_mm_rev", least}}});
            feeds[k] = least;
        }
        cut.pieces[k].feed_mm_rev = feeds[k];
        time += width_mm / feeds[k];
        programmed_time += width_mm / plan.cuts[last.cut].pieces[k].feed_mm_rev;
        result.z_mm.push_back(z_mm + width_mm);
        result.feed_mm_rev.push_back(feeds[k]);
    }
    result.diameter_error_um = errors_um();
    result.max_um = *std::max_element(result.diameter_error_um.begin(), result.diameter_error_um.end());
    result.time_ratio = time / programmed_time;
    return result;
}

}  // namespace lathelier::deflection
