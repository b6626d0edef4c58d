#include "engine/registration/neighbours/cloud_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/core/units.h"
#include "engine/registration/drawn_places.h"
#include "engine/registration/neighbours/cloud_distance.h"
#include "engine/registration/neighbours/neighbours.h"
#include "engine/registration/neighbours/points_near.h"
#include "engine/registration/sampling.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;

constexpr std::size_t mostExhaustiveQueries = 100000;  // up to so many used points every one is queried
constexpr std::size_t drawnQueries = 12500;            // queries drawn from more points: standard error 1 to 2 %
constexpr std::size_t pointsPerQuery =
    40;  // points per query above which an index of the whole cloud costs more than it saves

struct Answers {
    std::vector<float> distances_mm;  ///< NaN: none within reach
    double sampling_floor_mm = notANumber;
};

Answers byIndex(const std::vector<Vector3d>& reference, const std::vector<Vector3d>& queries, double max_distance_mm,
                const Progress& progress)
{
    const Neighbours index(reference, progress.part(0, 0.6));
    return {nearestDistances(index, queries, max_distance_mm, progress.part(0.6, 1)),
            samplingFloor(reference, index, progress).rms_mm};
}

/// The same results for a large cloud and few queries: first from the points near the queries; queries without a
/// neighbour are repeated with a larger radius.
Answers byVicinity(const std::vector<Vector3d>& reference, const std::vector<Vector3d>& queries, double max_distance_mm,
                   const Progress& progress)
{
    constexpr double nearby = 2.5, patch = 40;  // in spacings of the points
    constexpr double further = 4;               // factor of the radius for queries without a neighbour
    const double spacing_mm = roughSpacing_mm(reference, progress);
    if (!(spacing_mm > 0)) return byIndex(reference, queries, max_distance_mm, progress);
    Answers answers;
    answers.distances_mm.resize(queries.size(), std::numeric_limits<float>::quiet_NaN());
    std::vector<std::size_t> open(queries.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    for (double radius_mm = nearby * spacing_mm; !open.empty(); radius_mm *= further) {
        progress.check();
        const bool first = open.size() == queries.size(), last = radius_mm >= max_distance_mm;
        Vicinity asked{{}, std::min(radius_mm, max_distance_mm)};
        for (const std::size_t q : open) asked.places_mm.push_back(queries[q]);
        std::vector<Vicinity> vicinities{asked};
        const double reach_mm = std::max(asked.radius_mm, patch * spacing_mm);
        if (first) vicinities.push_back({samplingPlaces(reference), reach_mm});
        const Neighbours index(pointsNear(reference, vicinities, progress), progress.quiet());
        if (first) {
            SamplingFloor floor = samplingFloor(reference, index, progress);
            if (!(floor.reach_mm <= reach_mm)) floor = samplingFloor(reference, Neighbours(reference), progress);
            answers.sampling_floor_mm = floor.rms_mm;
        }
        const std::vector<float> found = nearestDistances(index, asked.places_mm, asked.radius_mm, progress.quiet());
        std::vector<std::size_t> still;
        for (std::size_t i = 0; i < open.size(); ++i)
            if (std::isnan(found[i]))
                still.push_back(open[i]);
            else
                answers.distances_mm[open[i]] = found[i];
        if (last) break;
        open = std::move(still);
    }
    return answers;
}

}  // namespace

CloudFigure compareClouds(const std::vector<Vector3d>& reference_mm, const std::vector<Vector3d>& moved_copy_mm,
                          const std::vector<std::uint8_t>& used, double max_distance_mm, const Progress& progress)
{
    const auto asked = static_cast<std::size_t>(std::count_if(used.begin(), used.end(), [](auto u) { return u != 0; }));
    std::vector<std::size_t> places(std::min(asked, mostExhaustiveQueries));  // among the used points, ascending
    std::iota(places.begin(), places.end(), std::size_t{0});
    if (asked > mostExhaustiveQueries) places = drawnPlaces(asked, drawnQueries, 17);
    std::vector<Vector3d> queries;
    queries.reserve(places.size());
    for (std::size_t i = 0, passed = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        // A place on the border of two stretches may be drawn for both.
        while (queries.size() < places.size() && places[queries.size()] == passed) queries.push_back(moved_copy_mm[i]);
        ++passed;
    }
    const bool few = reference_mm.size() > pointsPerQuery * queries.size();
    const Answers answers = few ? byVicinity(reference_mm, queries, max_distance_mm, progress)
                                : byIndex(reference_mm, queries, max_distance_mm, progress);
    const std::vector<float>& distances = answers.distances_mm;
    CloudFigure figure;
    figure.sampling_floor_mm = answers.sampling_floor_mm;

    double squares = 0;
    double found = 0;
    for (const float distance : distances)
        if (!std::isnan(distance)) {
            squares += static_cast<double>(distance) * distance;
            found += 1;
        }
    if (found == 0) return figure;
    const double mean = squares / found;
    double scatter = 0;
    for (const float distance : distances)
        if (!std::isnan(distance)) {
            const double off = static_cast<double>(distance) * distance - mean;
            scatter += off * off;
        }
    const double left_out = 1 - static_cast<double>(queries.size()) / static_cast<double>(asked);
    figure.rmse_mm = std::sqrt(mean);
    figure.standard_error_mm = mean > 0 ? std::sqrt(scatter * left_out / mean) / (2 * found) : 0;
    return figure;
}

}  // namespace lathelier::registration
