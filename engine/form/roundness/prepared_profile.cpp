#include "engine/form/roundness/prepared_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/signal/closed_filter.h"
#include "engine/signal/hampel.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;

constexpr std::size_t profilePointsPerTask = 1 << 15;
constexpr int mostCentreRounds = 4;  ///< excluding points moves the centre and thereby the angles

std::vector<Vector2d> usedPoints(const Profile& profile, const std::vector<std::uint8_t>& used)
{
    std::vector<Vector2d> result;
    result.reserve(used.size());
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) result.push_back(profile.points_mm[i]);
    return result;
}

double angleAbout(const Vector2d& centre, const Vector2d& point)
{
    const Vector2d ray = point - centre;
    return std::atan2(ray.y(), ray.x());
}

/// Derives the other members from `used`.
void arrange(const Profile& profile, PreparedProfile& prepared, const Progress& progress)
{
    const bool all = std::find(prepared.used.begin(), prepared.used.end(), 0) == prepared.used.end();
    const std::vector<Vector2d> some = all ? std::vector<Vector2d>{} : usedPoints(profile, prepared.used);
    const std::vector<Vector2d>& points = all ? profile.points_mm : some;
    const FittedCircle circle = fitLeastSquaresCircle(points);
    prepared.centre_mm = circle.centre_mm;
    prepared.radius_mm = circle.radius_mm;
    prepared.angle_rad = anglesAbout(circle.centre_mm, profile.points_mm, progress);
    std::vector<std::size_t> given;
    std::vector<double> angle_rad;
    if (!all) {
        given.reserve(points.size());
        angle_rad.reserve(points.size());
        for (std::size_t i = 0; i < prepared.used.size(); ++i)
            if (prepared.used[i]) {
                given.push_back(i);
                angle_rad.push_back(prepared.angle_rad[i]);
            }
    }
    prepared.sampling = signal::sampleAngles(all ? prepared.angle_rad : angle_rad);
    prepared.index.resize(points.size());
    prepared.points_mm.resize(points.size());
    prepared.distance_mm.resize(points.size());
    parallelFor(points.size(), profilePointsPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            std::size_t& i = prepared.sampling.order[k];
            prepared.index[k] = all ? i : given[i];
            prepared.points_mm[k] = points[i];
            prepared.distance_mm[k] = (points[i] - circle.centre_mm).norm();
            i = k;
        }
    });
}

/// Redetermines the points in the excluded sectors; true when any changed.
bool exclude(const Profile& profile, const std::vector<Interval>& sectors, PreparedProfile& prepared)
{
    bool changed = false;
    prepared.excluded = 0;
    for (std::size_t i = 0; i < prepared.used.size(); ++i) {
        const Vector2d& point = profile.points_mm[i];
        if (!point.allFinite()) continue;
        const double angle = angleAbout(prepared.centre_mm, point) * 180 / std::numbers::pi;
        const std::uint8_t counts = !isExcluded(angle, sectors);
        prepared.excluded += !counts;
        changed |= counts != prepared.used[i];
        prepared.used[i] = counts;
    }
    return changed;
}

/// Excludes outliers; true when there were any.
bool removeOutliers(PreparedProfile& prepared, const Progress& progress)
{
    const std::vector<std::uint8_t> found = signal::hampelOutliers(prepared.distance_mm, {}, progress);
    const auto count = static_cast<std::size_t>(std::count(found.begin(), found.end(), 1));
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i]) prepared.used[prepared.index[i]] = 0;
    prepared.outliers += count;
    return count > 0;
}

}  // namespace

std::vector<double> anglesAbout(const Vector2d& centre_mm, const std::vector<Vector2d>& points_mm,
                                const Progress& progress)
{
    std::vector<double> angle(points_mm.size());
    parallelFor(points_mm.size(), profilePointsPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) angle[i] = angleAbout(centre_mm, points_mm[i]);
    });
    return angle;
}

bool isExcluded(double angle_deg, const std::vector<Interval>& sectors_deg)
{
    return std::any_of(sectors_deg.begin(), sectors_deg.end(), [&](const Interval& sector) {
        double width = sector.to - sector.from;
        if (width < 0) width += 360;
        const double into = angle_deg - sector.from;
        return into - 360 * std::floor(into / 360) <= width;
    });
}

PreparedProfile prepareProfile(const Profile& profile, const std::vector<Interval>& exclude_deg, OutlierRule rule,
                               const Progress& progress)
{
    PreparedProfile prepared;
    prepared.used.resize(profile.points_mm.size());
    for (std::size_t i = 0; i < prepared.used.size(); ++i) {
        prepared.used[i] = profile.points_mm[i].allFinite();
        prepared.not_finite += !prepared.used[i];
    }
    arrange(profile, prepared, progress);
    if (!exclude_deg.empty())
        for (int round = 0; round < mostCentreRounds && exclude(profile, exclude_deg, prepared); ++round)
            arrange(profile, prepared, progress);
    return rule == OutlierRule::Hampel ? withoutOutliers(profile, std::move(prepared), progress) : prepared;
}

PreparedProfile withoutOutliers(const Profile& profile, PreparedProfile prepared, const Progress& progress)
{
    for (int round = 0; round < mostCentreRounds && removeOutliers(prepared, progress); ++round)
        arrange(profile, prepared, progress);
    return prepared;
}

EvaluatedProfile evaluateProfile(const PreparedProfile& prepared, const signal::TransmissionBand& band,
                                 const Progress& progress)
{
    const double cutoff_upr = std::max(band.high_upr.value_or(0), band.low_upr.value_or(0));
    signal::ClosedFilter filter(prepared.sampling, prepared.distance_mm, cutoff_upr);
    return evaluateProfile(prepared, band, filter, progress);
}

EvaluatedProfile evaluateProfile(const PreparedProfile& prepared, const signal::TransmissionBand& band,
                                 signal::ClosedFilter& filter, const Progress& progress)
{
    EvaluatedProfile result{prepared.points_mm, signal::FilterMethod::Uniform};
    if (band.isAll()) return result;
    const signal::FilteredValues filtered = filter(band, progress);
    result.method = filtered.method;
    for (std::size_t i = 0; i < result.points_mm.size(); ++i) {
        const double angle = prepared.sampling.angle_rad[i];
        result.points_mm[i] = prepared.centre_mm + filtered.values[i] * Vector2d(std::cos(angle), std::sin(angle));
    }
    return result;
}

}  // namespace lathelier::form
