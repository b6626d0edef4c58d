#include "engine/registration/cloud_figure.h"

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/registration/cloud_distance.h"
#include "engine/registration/neighbours.h"
#include "engine/registration/sampling.h"

namespace lathelier {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kQueries = 100000;
constexpr std::size_t kRun = 8;

/// Runs of kRun places that follow each other among 0…size-1, one from each of equal stretches at a drawn place, so
/// that no grid of the scanner is met in step; all places when there are no more than kQueries.
std::vector<std::size_t> drawnRuns(std::size_t size)
{
    const bool all = size <= kQueries;
    const std::size_t runs = all ? (size + kRun - 1) / kRun : kQueries / kRun;
    const double stretch = static_cast<double>(size) / static_cast<double>(runs);
    std::vector<std::size_t> places;
    for (std::size_t run = 0; run < runs; ++run) {
        const double drawn = static_cast<double>(run) * stretch + randomUniform(17, 0, run) * (stretch - kRun);
        const std::size_t first = all ? run * kRun : static_cast<std::size_t>(drawn);
        for (std::size_t i = first; i < std::min(first + kRun, size); ++i) places.push_back(i);
    }
    return places;
}

}  // namespace

CloudFigure compareClouds(const std::vector<Vector3d>& reference_mm, const std::vector<Vector3d>& moved_copy_mm,
                          const std::vector<std::uint8_t>& used, double max_distance_mm, const Progress& progress)
{
    const Neighbours index(reference_mm, progress.part(0, 0.6));
    std::vector<std::uint32_t> asked;
    asked.reserve(moved_copy_mm.size());
    for (std::size_t i = 0; i < moved_copy_mm.size(); ++i)
        if (used[i]) asked.push_back(static_cast<std::uint32_t>(i));
    std::vector<Vector3d> queries;
    for (const std::size_t place : drawnRuns(asked.size())) queries.push_back(moved_copy_mm[asked[place]]);
    const std::vector<float> distances = nearestDistances(index, queries, max_distance_mm, progress.part(0.6, 0.9));
    CloudFigure figure;
    figure.sampling_floor_mm = samplingFloor_mm(reference_mm, index, progress);

    double squares = 0;
    double found = 0;
    for (const float distance : distances)
        if (!std::isnan(distance)) {
            squares += static_cast<double>(distance) * distance;
            found += 1;
        }
    if (found == 0) return figure;
    const double mean = squares / found;
    double scatter = 0;  // of the sums of runs
    for (std::size_t run = 0; run < distances.size(); run += kRun) {
        double sum = 0;
        for (std::size_t i = run; i < std::min(run + kRun, distances.size()); ++i)
            if (!std::isnan(distances[i])) sum += static_cast<double>(distances[i]) * distances[i] - mean;
        scatter += sum * sum;
    }
    const double left_out = 1 - static_cast<double>(queries.size()) / static_cast<double>(asked.size());
    figure.rmse_mm = std::sqrt(mean);
    figure.standard_error_mm = mean > 0 ? std::sqrt(scatter * left_out / mean) / (2 * found) : 0;
    return figure;
}

}  // namespace lathelier
