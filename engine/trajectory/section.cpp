#include "engine/trajectory/section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/core/statistics.h"
#include "engine/trajectory/error_motion.h"
#include "engine/trajectory/surface_image.h"
#include "engine/trajectory/trajectory_codes.h"

namespace lathelier::trajectory {
namespace {

constexpr std::array<Probe, 4> allProbes{Probe::X3, Probe::Y3, Probe::Xp, Probe::Yp};

std::size_t index(Probe probe)
{
    return static_cast<std::size_t>(probe);
}

/// Mean square scatter of one probe at an angle, over the revolutions. The mean of each revolution is size, which
/// drifts, and not form: it is removed where the single revolutions are known.
std::optional<double> scatterSquared_um2(const TrajectorySection& section, Probe probe)
{
    double sum = 0;
    std::size_t count = 0;
    const auto& revolutions = section.revolutions_um[index(probe)];
    if (revolutions.size() >= 2) {
        std::vector<double> level;
        for (const std::vector<float>& revolution : revolutions) {
            double mean = 0, known = 0;
            for (const float value : revolution)
                if (std::isfinite(value)) {
                    mean += value;
                    ++known;
                }
            level.push_back(known > 0 ? mean / known : 0);
        }
        for (std::size_t i = 0; i < revolutions.front().size(); ++i) {
            double mean = 0, squares = 0, known = 0;
            for (std::size_t k = 0; k < revolutions.size(); ++k) {
                const double value = revolutions[k][i] - level[k];
                if (!std::isfinite(value)) continue;
                mean += value;
                squares += value * value;
                ++known;
            }
            if (known < 2) continue;
            sum += (squares - mean * mean / known) / (known - 1);
            ++count;
        }
    } else {
        for (const double deviation : section.probes[index(probe)].std_um) {
            if (!std::isfinite(deviation)) continue;
            sum += deviation * deviation;
            ++count;
        }
    }
    if (count == 0) return std::nullopt;
    return std::max(0.0, sum) / static_cast<double>(count);
}

/// Standard deviation of an image point: from the means of X3 and Xp, which determine the radius; none without standard
/// deviations.
std::optional<double> pointUncertainty_um(const TrajectorySection& section)
{
    if (section.revolutions_used < 2) return std::nullopt;
    double squares = 0;
    for (const Probe probe : {Probe::X3, Probe::Xp}) {
        const std::optional<double> scatter = scatterSquared_um2(section, probe);
        if (!scatter) return std::nullopt;
        squares += *scatter;
    }
    return std::sqrt(squares / section.revolutions_used);
}

/// Noise, drift and mains hum also have a mean curve: it is accepted as form only when it is significant against them.
void judgeForm(TrajectorySection& section, Drift removed)
{
    constexpr double byFar = 10;
    constexpr double mostDrift = 0.5;  ///< of RONt, from the start of a revolution to its end
    const double deviation_um = headlineDeviation_um(section.roundness);
    const ErrorMotion& motion = section.spindle;
    const bool drowned = std::isfinite(motion.asynchronous_um) &&
                         motion.asynchronous_um > byFar * std::max(motion.synchronous_um, deviation_um);
    double drift_um = 0;
    for (const Probe probe : {Probe::X3, Probe::Xp})
        drift_um = std::max(drift_um, std::abs(section.drift_um_per_rev[index(probe)]));
    const bool drifts = removed == Drift::None && drift_um > mostDrift * deviation_um;
    section.form_measured = !drowned && !drifts && !(section.roundness.RONt_expanded_uncertainty_um >= deviation_um);
    if (!section.form_measured && section.roundness.verdict) section.roundness.verdict = Verdict::Undecided;
}

/// Image, run-out and roundness from the mean trajectories.
void addImage(TrajectorySection& section, const TrajectoryParameters& parameters, double workpiece_diameter_mm,
              const Progress& progress)
{
    SurfaceImage image = imageOf({section.mean_um(Probe::X3), section.mean_um(Probe::Y3), section.mean_um(Probe::Xp),
                                  section.mean_um(Probe::Yp)},
                                 section.angle_deg, workpiece_diameter_mm, parameters.rotation);
    section.image.points_mm = image.points_mm();
    section.image.size_is_nominal = true;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const double radius_mm : image.radius_mm) {
        least = std::fmin(least, radius_mm);
        most = std::fmax(most, radius_mm);
    }
    section.run_out_um = 1e3 * (most - least);
    section.radius_mm = std::move(image.radius_mm);
    section.body_angle_deg = std::move(image.body_angle_deg);
    form::RoundnessParameters form = parameters.form;
    if (!form.probe_uncertainty_um) form.probe_uncertainty_um = pointUncertainty_um(section);
    section.roundness = roundness(section.image, form, progress);
    judgeForm(section, parameters.drift);
}

void storeRevolutions(TrajectorySection& section, const SectionSignals& signals)
{
    for (std::size_t probe = 0; probe < signals.um.size(); ++probe)
        for (std::size_t k = 0; k < signals.revolutions(); ++k) {
            const auto from = signals.um[probe].begin() + static_cast<std::ptrdiff_t>(k * signals.points);
            section.revolutions_um[probe].emplace_back(from, from + static_cast<std::ptrdiff_t>(signals.points));
        }
}

}  // namespace

TrajectorySection evaluate(const PreparedRecord& prepared, const RecordSegment& segment,
                           const TrajectoryParameters& parameters, double workpiece_diameter_mm,
                           const Progress& progress)
{
    TrajectorySection section;
    section.revolutions_found = segment.found;
    if (!segment.chosen.empty() && prepared.clock.isKnown()) {
        double duration_s = 0;
        for (const Revolution& revolution : segment.chosen) duration_s += revolution.end_s - revolution.start_s;
        section.speed_rpm = 60 * static_cast<double>(segment.chosen.size()) / duration_s;
    }
    const auto points = static_cast<std::size_t>(parameters.points);
    for (std::size_t i = 0; i < points; ++i)
        section.angle_deg.push_back(360 * static_cast<double>(i) / static_cast<double>(points));

    SectionSignals signals = resample(*prepared.record, prepared.clock, prepared.map, prepared.revolutions,
                                      segment.chosen, points, prepared.channel_skew_s);
    progress.check();
    section.drift_um_per_rev = driftPerRevolution_um(signals);
    if (parameters.drift == Drift::Section) removeDrift(signals, section.drift_um_per_rev);
    if (parameters.outliers == form::OutlierRule::Hampel)
        section.samples_rejected = rejectOutliers(signals, parameters.outlier_sigmas).samples;
    progress.check();
    section.revolutions_used = static_cast<int>(signals.revolutions());
    constexpr int fewest = 2;
    if (section.revolutions_used < fewest)
        throw Error(errors::tooFewRevolutions,
                    {{"found", std::int64_t{section.revolutions_used}}, {"minimum", std::int64_t{fewest}}});

    for (const Probe probe : allProbes) {
        section.probes[index(probe)] = statisticsOf(signals, probe);
        section.error_motion[index(probe)] = errorMotion(signals.um[index(probe)], section.angle_deg,
                                                         probe == Probe::X3 || probe == Probe::Y3 ? mandrelForm_um : 0);
    }
    section.spindle = section.error_motion[index(Probe::X3)];
    section.rotating =
        errorMotion(rotatingDirection(signals.um[index(Probe::X3)], signals.um[index(Probe::Y3)], section.angle_deg),
                    section.angle_deg, mandrelForm_um);
    RevolutionImages images = revolutionImages(signals, section.angle_deg, workpiece_diameter_mm, parameters.rotation,
                                               bandOf(parameters.form));
    section.envelope_min_mm = std::move(images.envelope_min_mm);
    section.envelope_max_mm = std::move(images.envelope_max_mm);
    section.revolution_RONt_um = std::move(images.RONt_um);
    storeRevolutions(section, signals);
    addImage(section, parameters, workpiece_diameter_mm, progress);
    return section;
}

TrajectorySection evaluate(const io::AveragedSection& averages, int revolutions, const TrajectoryParameters& parameters,
                           double workpiece_diameter_mm, const Progress& progress)
{
    TrajectorySection section;
    section.revolutions_found = revolutions;
    section.revolutions_used = revolutions;
    section.angle_deg = averages.angle_deg;
    const std::array<const std::vector<double>*, 4> means{&averages.X3_um, &averages.Y3_um, &averages.Xp_um,
                                                          &averages.Yp_um};
    const std::array<const std::vector<double>*, 4> deviations{&averages.sX3_um, &averages.sY3_um, &averages.sXp_um,
                                                               &averages.sYp_um};
    for (const Probe probe : allProbes) {
        ProbeStatistics& statistics = section.probes[index(probe)];
        statistics.mean_um = *means[index(probe)];
        statistics.std_um = *deviations[index(probe)];
        if (revolutions > 1) {
            const double coverage =
                studentQuantile(0.975, revolutions - 1) / std::sqrt(static_cast<double>(revolutions));
            for (const double deviation : statistics.std_um) statistics.confidence_um.push_back(coverage * deviation);
        }
        section.error_motion[index(probe)] = errorMotionOfMean(statistics.mean_um, section.angle_deg);
    }
    section.spindle = section.error_motion[index(Probe::X3)];
    section.rotating =
        errorMotionOfMean(rotatingDirection(averages.X3_um, averages.Y3_um, section.angle_deg), section.angle_deg);
    addImage(section, parameters, workpiece_diameter_mm, progress);
    return section;
}

}  // namespace lathelier::trajectory
