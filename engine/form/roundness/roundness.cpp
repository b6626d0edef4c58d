#include "engine/form/roundness/roundness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/form/circle/two_point.h"
#include "engine/form/form_codes.h"
#include "engine/form/roundness/prepared_profile.h"
#include "engine/form/roundness/roundness_hints.h"
#include "engine/form/roundness/roundness_methods.h"
#include "engine/form/roundness/roundness_uncertainty.h"
#include "engine/io/io_codes.h"
#include "engine/signal/harmonics.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;
constexpr int mostHarmonics = 500;

/// Contacts are indices of input points, independent of exclusion and sorting.
void pointContactsToGiven(FittedCircle& circle, const std::vector<std::size_t>& index)
{
    for (CircleContact& contact : circle.contacts) contact.index = index[contact.index];
}

std::vector<signal::Harmonic> harmonicsOf(const PreparedProfile& prepared, std::size_t given, const Progress& progress)
{
    const int limit = std::min(mostHarmonics, static_cast<int>(given / 2));
    std::vector<double> deviation_um;
    deviation_um.reserve(prepared.distance_mm.size());
    for (const double distance : prepared.distance_mm) deviation_um.push_back(1000 * (distance - prepared.radius_mm));
    return harmonicsAt(prepared.sampling, std::move(deviation_um), limit, progress);
}

PaperValues paperValues(const PreparedProfile& prepared)
{
    PaperValues paper{notANumber, Vector2d(notANumber, notANumber)};
    if (prepared.centre_mm.norm() >= prepared.radius_mm) return paper;
    double mean = 0, nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const Vector2d& point : prepared.points_mm) {
        mean += point.norm() / static_cast<double>(prepared.points_mm.size());
        nearest = std::min(nearest, point.norm());
        farthest = std::max(farthest, point.norm());
    }
    paper.run_out_um = 1000 * (farthest - nearest);
    paper.limacon_centre_um.setZero();
    for (const Vector2d& point : prepared.points_mm)
        if (point.norm() > 0)
            paper.limacon_centre_um +=
                2000 / static_cast<double>(prepared.points_mm.size()) * (point.norm() - mean) * point.normalized();
    return paper;
}

/// Number of revolutions of the points in input order; 0 when that order is not angular.
double turnsOf(const RoundnessResult& result)
{
    double sum = 0;
    std::size_t forward = 0, backward = 0;
    const std::size_t n = result.angle_rad.size();
    for (std::size_t i = 1; i < n; ++i) {
        double step = result.angle_rad[i] - result.angle_rad[i - 1];
        if (std::abs(step) > std::numbers::pi) step -= std::copysign(2 * std::numbers::pi, step);
        if (std::abs(step) > std::numbers::pi / 4) continue;  // gap or unordered points
        sum += step;
        forward += step > 0;
        backward += step < 0;
    }
    const bool ordered = static_cast<double>(std::max(forward, backward)) > 0.95 * static_cast<double>(n);
    return ordered ? std::abs(sum) / (2 * std::numbers::pi) : 0;
}

/// Notes on the sampling.
void noteSampling(const Profile& profile, const PreparedProfile& prepared, const signal::TransmissionBand& band,
                  Notes& notes)
{
    const auto count = [](std::size_t value) { return static_cast<std::int64_t>(value); };
    const signal::AngularSampling& sampling = prepared.sampling;
    if (profile.size_is_nominal) notes.push_back({notes::sizeNominal, {}});
    if (prepared.not_finite > 0)
        notes.push_back({notes::pointsNotFinite, {{"path", profile.name}, {"count", count(prepared.not_finite)}}});
    if (prepared.excluded > 0) notes.push_back({notes::sectorsExcluded, {{"count", count(prepared.excluded)}}});
    if (prepared.outliers > 0) notes.push_back({notes::outliersRemoved, {{"count", count(prepared.outliers)}}});
    if (sampling.different < prepared.index.size())
        notes.push_back({notes::duplicatePoints, {{"count", count(prepared.index.size() - sampling.different)}}});
    const double largest_deg = std::round(sampling.largest_gap_rad / rad_per_deg * 100) / 100;
    if (sampling.largest_gap_rad > std::numbers::pi / 2)
        notes.push_back({notes::partialArc, {{"missing_deg", largest_deg}}});
    else if (sampling.gaps > 0)
        notes.push_back({notes::gapsInProfile, {{"count", count(sampling.gaps)}, {"largest_deg", largest_deg}}});
    else if (sampling.largest_gap_rad > 1.5 * sampling.median_spacing_rad)
        notes.push_back({notes::anglesUneven, {}});
    const double cutoff = band.high_upr.value_or(band.low_upr.value_or(0));
    if (cutoff > carriedCutoff(sampling))
        notes.push_back(
            {notes::undersampled,
             {{"points", static_cast<std::int64_t>(std::llround(2 * std::numbers::pi / sampling.median_spacing_rad))},
              {"cutoff_upr", cutoff},
              {"supported_upr", carriedStandardCutoff(sampling)}}});
}

/// Notes on the harmonics determined and those only estimated.
void noteHarmonics(const RoundnessResult& result, const signal::AngularSampling& sampling, Notes& notes)
{
    const auto asked = std::min<std::size_t>(mostHarmonics, sampling.different / 2);
    const std::size_t found = result.harmonics.size();
    const signal::CarriedOrders carried = carriedOrders(sampling);
    if (found < asked)
        notes.push_back({notes::harmonicsLimited,
                         {{"carried_upr", static_cast<std::int64_t>(found)},
                          {"spacing_deg", std::round(sampling.largest_gap_rad / rad_per_deg * 100) / 100}}});
    if (sampling.gaps > 0 && static_cast<int>(found) > carried.determined)
        notes.push_back({notes::harmonicsEstimated,
                         {{"determined_upr", static_cast<std::int64_t>(carried.determined)},
                          {"leakage_percent", std::round(1000 * carried.leakage) / 10}}});
}

/// Notes on the contributions and assumptions of the uncertainty.
void noteUncertainty(const RoundnessResult& result, const PointNoise& noise, Notes& notes)
{
    if (!std::isfinite(noise.sigma_um)) notes.push_back({notes::noiseNotKnown, {}});
    if (noise.resolution_um > 0.2 * noise.sigma_um && !result.parameters.probe_uncertainty_um)
        notes.push_back({notes::resolutionCounted, {{"resolution_um", noise.resolution_um}}});
    const bool matters = result.RONt_expanded_uncertainty_um > 0.01 * headlineDeviation_um(result);
    if (noise.correlation_points > 1.5 && matters)
        notes.push_back(
            {notes::noiseCorrelated, {{"points", static_cast<std::int64_t>(std::llround(noise.correlation_points))}}});
    if (!noise.spikes_um.empty()) {
        double largest_um = 0;
        for (const double spike : noise.spikes_um) largest_um = std::max(largest_um, std::abs(spike));
        notes.push_back({notes::spikesCounted,
                         {{"count", static_cast<std::int64_t>(noise.spikes_um.size())},
                          {"largest_um", std::round(100 * largest_um) / 100}}});
    }
    if (result.two_point.without_opposite > 0)
        notes.push_back({notes::twoPointIncomplete,
                         {{"share_percent", std::round(1000.0 * static_cast<double>(result.two_point.without_opposite) /
                                                       static_cast<double>(result.evaluated_index.size())) /
                                                10}}});
}

void noteCircles(const ReferenceCircles& circles, const CircleOptions& options, Notes& notes)
{
    if (!circles.MZCI.unique) notes.push_back({notes::minimumZoneNotUnique, {}});
    if (!circles.MICI.unique) notes.push_back({notes::inscribedNotUnique, {}});
    for (const ReferenceCircle which : {ReferenceCircle::MZCI, ReferenceCircle::MICI}) {
        const FittedCircle& circle = circles.of(which);
        // A gap below the rounding of far coordinates counts as reached.
        const double goal = std::max(
            {options.certificate_um, options.certificate_relative * circle.RONt_um, 1e-11 * circle.outer_radius_mm});
        if (circle.certified_gap_um && *circle.certified_gap_um > 2 * goal)
            notes.push_back(
                {notes::certificateOpen, {{"circle", std::string(name(which))}, {"gap_um", *circle.certified_gap_um}}});
    }
}

}  // namespace

RoundnessResult roundness(const Profile& profile, const RoundnessParameters& parameters, const Progress& progress,
                          MethodTable table)
{
    progress.report(0);
    const signal::TransmissionBand band = bandOf(parameters);
    PreparedProfile prepared = prepareProfile(profile, parameters.exclude_deg, parameters.outliers, progress);
    progress.report(0.04);
    EvaluatedProfile evaluated = evaluateProfile(prepared, band, progress);

    RoundnessResult result;
    result.parameters = parameters;
    result.name = profile.name;
    result.points = profile.points_mm.size();
    result.used = prepared.used;
    result.angle_rad = std::move(prepared.angle_rad);
    result.evaluated_index = prepared.index;
    result.filter_method = evaluated.method;
    progress.report(0.1);

    const CircleOptions options;
    const ReferenceCircles circles = fitCircles(evaluated.points_mm, options, progress.part(0.1, 0.4));
    result.circles = circles;
    for (FittedCircle* circle :
         {&result.circles.LSCI, &result.circles.MZCI, &result.circles.MICI, &result.circles.MCCI})
        pointContactsToGiven(*circle, prepared.index);
    progress.report(0.4);
    PointNoise noise;
    double form_uncertainty_um = 0;
    // Run concurrently: each has serial sections.
    parallelFor(3, 1, progress, [&](std::size_t task, std::size_t) {
        if (task == 0) {
            if (table == MethodTable::Made)
                result.methods = methodRows(profile, prepared, parameters, circles, progress.part(0.4, 1));
        } else if (task == 1) {
            result.harmonics = harmonicsOf(prepared, result.points, progress);
            noise = estimateNoise(prepared, result.harmonics, resolutionOf(profile), parameters.probe_uncertainty_um,
                                  progress.quiet());
            form_uncertainty_um = expandedUncertainty_um(prepared, noise, band, parameters.circle,
                                                         circles.of(parameters.circle), progress.quiet());
        } else {
            result.two_point =
                twoPointSize(evaluated.points_mm, prepared.sampling, prepared.centre_mm, progress.quiet());
            result.paper = paperValues(prepared);
        }
    });
    result.point_noise_um = noise.sigma_um;
    result.resolution_um = noise.resolution_um;
    result.noise_correlation_points = noise.correlation_points;
    result.harmonic_floor_um = noise.floor_um;
    const double nominal_um = nominalRadiusEffect_um(profile, prepared);
    result.RONt_expanded_uncertainty_um = std::hypot(form_uncertainty_um, nominal_um);
    result.hints = roundnessHints(result);
    if (parameters.tolerance_um)
        result.verdict = judge(headlineDeviation_um(result), result.RONt_expanded_uncertainty_um,
                               *parameters.tolerance_um, parameters.decision);

    noteSampling(profile, prepared, band, result.notes);
    if (const double turns = turnsOf(result); turns > 1.5)
        result.notes.push_back({notes::revolutionsOverlaid, {{"revolutions", std::round(10 * turns) / 10}}});
    noteCircles(result.circles, options, result.notes);
    noteHarmonics(result, prepared.sampling, result.notes);
    noteUncertainty(result, noise, result.notes);
    if (nominal_um > std::max(0.05, 0.02 * headlineDeviation_um(result)))
        result.notes.push_back({notes::nominalRadiusMatters,
                                {{"eccentricity_um", std::round(10000 * prepared.centre_mm.norm()) / 10},
                                 {"radius_mm", prepared.radius_mm},
                                 {"effect_um", std::round(100 * nominal_um) / 100}}});
    result.evaluated_mm = std::move(evaluated.points_mm);
    progress.report(1);
    return result;
}

double headlineDeviation_um(const RoundnessResult& result)
{
    return result.circles.of(result.parameters.circle).RONt_um;
}

}  // namespace lathelier::form
