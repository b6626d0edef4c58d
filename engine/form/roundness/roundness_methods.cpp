#include "engine/form/roundness/roundness_methods.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/core/core_codes.h"
#include "engine/signal/closed_filter.h"

namespace lathelier::form {
namespace {

constexpr double samplesAtLeast = 2.5;  ///< samples per wave below which the wave is not resolved

std::array<double, 4> deviations(const ReferenceCircles& circles)
{
    return {circles.LSCI.RONt_um, circles.MZCI.RONt_um, circles.MICI.RONt_um, circles.MCCI.RONt_um};
}

double pointsPerTurn(const signal::AngularSampling& sampling)
{
    return 2 * std::numbers::pi / sampling.median_spacing_rad;
}

/// 105 points resolve 15 UPR (7 per wave); the tolerance absorbs rounding of the angles.
constexpr double cutoffRounding = 1 + 1e-6;

std::vector<signal::TransmissionBand> bandsFor(const signal::AngularSampling& sampling,
                                               const signal::TransmissionBand& asked)
{
    std::vector<signal::TransmissionBand> bands{{}};
    for (const double cutoff : standardCutoffs) {
        if (cutoff > 500 || cutoff * samplesAtLeast > pointsPerTurn(sampling) * cutoffRounding) break;
        bands.push_back({{}, cutoff});
        if (cutoff > carriedCutoff(sampling)) break;
    }
    if (std::find(bands.begin(), bands.end(), asked) == bands.end()) bands.push_back(asked);
    return bands;
}

/// The filtered points. An oversampled profile is resampled at even angles with 400 points per cut-off wave, which
/// underestimate its height by at most 3e-5.
std::vector<Eigen::Vector2d> filteredPoints(const PreparedProfile& points, const signal::TransmissionBand& band,
                                            signal::ClosedFilter& filter, const Progress& progress)
{
    constexpr double pointsPerWave = 400;
    constexpr std::size_t worthIt = 4;
    const auto count = static_cast<std::size_t>(pointsPerWave * band.high_upr.value_or(0));
    if (band.high_upr && points.points_mm.size() > worthIt * count)
        if (const auto radii = filter.even(band, count, progress)) {
            std::vector<Eigen::Vector2d> even;
            even.reserve(radii->size());
            for (std::size_t i = 0; i < radii->size(); ++i) {
                const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(radii->size());
                even.push_back(points.centre_mm + (*radii)[i] * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
            }
            return even;
        }
    return evaluateProfile(points, band, filter, progress).points_mm;
}

/// True for the errors of points that define no circle.
bool isWithoutCircle(const Error& error)
{
    return error.code() == errors::tooFewPoints || error.code() == errors::pointsDegenerate ||
           error.code() == errors::notConverged;
}

/// The points by the other rule of outliers; none when they define no circle, as three of four points do not.
std::optional<PreparedProfile> otherPoints(const Profile& profile, const PreparedProfile& prepared,
                                           const RoundnessParameters& parameters, const Progress& progress)
{
    try {
        if (parameters.outliers == OutlierRule::Hampel)
            return prepareProfile(profile, parameters.exclude_deg, OutlierRule::None, progress);
        return withoutOutliers(profile, prepared, progress);
    } catch (const Error& error) {
        if (!isWithoutCircle(error)) throw;
        return std::nullopt;
    }
}

/// The first row of a band.
const MethodRow* rowOf(const std::vector<MethodRow>& rows, const signal::TransmissionBand& band)
{
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const MethodRow& row) { return row.band == band; });
    return found == rows.end() ? nullptr : &*found;
}

/// None when the points define no circle.
std::optional<std::array<double, 4>> tryDeviations(const std::vector<Eigen::Vector2d>& points, const Progress& progress)
{
    CircleOptions quick;
    quick.certify = false;
    try {
        return deviations(fitCircles(points, quick, progress.quiet()));
    } catch (const Error& error) {
        if (!isWithoutCircle(error)) throw;
        return std::nullopt;
    }
}

}  // namespace

double carriedCutoff(const signal::AngularSampling& sampling)
{
    // Where the spacing varies smoothly, the widest spacing must resolve the wave as well; for gaps there is a note.
    const bool even = sampling.displacement <= signal::AngularSampling::nearlyEven || sampling.gaps > 0;
    const double spacing_rad = even ? sampling.median_spacing_rad : sampling.largest_regular_rad;
    return 2 * std::numbers::pi / spacing_rad / signal::samplesPerCutoff * cutoffRounding;
}

double carriedStandardCutoff(const signal::AngularSampling& sampling)
{
    double carried = 0;
    for (const double cutoff : standardCutoffs)
        if (cutoff <= carriedCutoff(sampling)) carried = cutoff;
    return carried;
}

std::vector<MethodRow> methodRows(const Profile& profile, const PreparedProfile& prepared,
                                  const RoundnessParameters& parameters, const ReferenceCircles& chosen,
                                  const Progress& progress)
{
    const signal::TransmissionBand asked = bandOf(parameters);
    const bool hampel = parameters.outliers == OutlierRule::Hampel;
    const std::optional<PreparedProfile> other = otherPoints(profile, prepared, parameters, progress);
    const std::vector<signal::TransmissionBand> bands = bandsFor(prepared.sampling, asked);
    std::vector<MethodRow> rows;
    for (const OutlierRule rule : {OutlierRule::None, OutlierRule::Hampel}) {
        const bool own = rule == parameters.outliers;
        if (!own && !other) continue;
        const PreparedProfile& points = own ? prepared : *other;
        double largest_upr = 0;
        for (const signal::TransmissionBand& band : bands)
            largest_upr = std::max({largest_upr, band.high_upr.value_or(0), band.low_upr.value_or(0)});
        signal::ClosedFilter filter(points.sampling, points.distance_mm, largest_upr);
        // Where there are no outliers the rows are the same.
        const bool same = rule == OutlierRule::Hampel && points.outliers == 0;
        for (std::size_t i = 0; i < bands.size(); ++i) {
            progress.report(static_cast<double>(rows.size()) / static_cast<double>(2 * bands.size()));
            MethodRow row{bands[i], rule, {}, false};
            row.undersampled = bands[i].high_upr && *bands[i].high_upr > carriedCutoff(points.sampling);
            if (bands[i] == asked && (own || same || (!hampel && other && other->outliers == 0)))
                row.RONt_um = deviations(chosen);
            else if (const MethodRow* first = same ? rowOf(rows, bands[i]) : nullptr)
                row.RONt_um = first->RONt_um;
            else if (const auto found = tryDeviations(filteredPoints(points, bands[i], filter, progress), progress))
                row.RONt_um = *found;
            else
                continue;
            rows.push_back(row);
        }
    }
    return rows;
}

}  // namespace lathelier::form
