#include "engine/trajectory/error_motion.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/signal/harmonics.h"

namespace lathelier::trajectory {
namespace {

struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double value)
    {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    double range() const { return high >= low ? high - low : notANumber; }
};

/// c0 + c1 cosθ + c2 sinθ through the finite values by least squares.
Eigen::Vector3d firstHarmonic(std::span<const double> values, std::span<const double> angle_deg)
{
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) continue;
        const Eigen::Vector3d base(1, std::cos(rad_per_deg * angle_deg[i]), std::sin(rad_per_deg * angle_deg[i]));
        normal += base * base.transpose();
        right += values[i] * base;
    }
    return normal.ldlt().solve(right);
}

double harmonicAt(const Eigen::Vector3d& c, double angle_deg)
{
    return c[0] + c[1] * std::cos(rad_per_deg * angle_deg) + c[2] * std::sin(rad_per_deg * angle_deg);
}

constexpr double coverageFactor = 2;   ///< k
constexpr double fewestForSpread = 3;  ///< revolutions

/// `variance` of the values at each angle over so many revolutions as `counts` says; NaN: not known.
void addUncertainties(ErrorMotion& motion, const std::vector<double>& variance, const std::vector<double>& counts,
                      double form_um)
{
    double sum = 0, known = 0;
    std::size_t low = variance.size(), high = low;
    for (std::size_t i = 0; i < variance.size(); ++i) {
        if (!std::isfinite(variance[i]) || counts[i] < fewestForSpread) continue;
        sum += variance[i];
        ++known;
        const std::vector<double>& curve = motion.synchronous_curve_um;
        if (low == variance.size() || curve[i] < curve[low]) low = i;
        if (high == variance.size() || curve[i] > curve[high]) high = i;
    }
    if (known == 0) return;
    const double of_means = variance[low] / counts[low] + variance[high] / counts[high];
    motion.synchronous_expanded_uncertainty_um = std::hypot(coverageFactor * std::sqrt(of_means), form_um);
    const double revolutions = *std::max_element(counts.begin(), counts.end());
    const double of_extreme = std::numbers::pi / std::sqrt(6.0) / std::sqrt(2 * std::log(revolutions));
    motion.total_expanded_uncertainty_um =
        std::hypot(coverageFactor * std::numbers::sqrt2 * of_extreme * std::sqrt(sum / known), form_um);
}

}  // namespace

ProbeStatistics statisticsOf(const SectionSignals& signals, Probe probe)
{
    const auto p = static_cast<std::size_t>(probe);
    ProbeStatistics result;
    std::int64_t asked = 0;  // number of values for which `student` was computed (cache; mostly constant)
    double student = notANumber;
    for (std::size_t i = 0; i < signals.points; ++i) {
        double sum = 0;
        std::int64_t count = 0;
        Extent extent;
        for (std::size_t k = 0; k < signals.revolutions(); ++k) {
            const double value = signals.at(p, k, i);
            if (!std::isfinite(value)) continue;
            sum += value;
            ++count;
            extent.add(value);
        }
        const double mean = count > 0 ? sum / static_cast<double>(count) : notANumber;
        double squares = 0;
        for (std::size_t k = 0; k < signals.revolutions(); ++k) {
            const double away = signals.at(p, k, i) - mean;
            if (std::isfinite(away)) squares += away * away;
        }
        const double deviation = count > 1 ? std::sqrt(squares / static_cast<double>(count - 1)) : notANumber;
        result.mean_um.push_back(mean);
        result.std_um.push_back(deviation);
        result.min_um.push_back(count > 0 ? extent.low : notANumber);
        result.max_um.push_back(count > 0 ? extent.high : notANumber);
        if (count != asked) student = studentQuantile(0.975, count - 1);
        asked = count;
        result.confidence_um.push_back(student * deviation / std::sqrt(static_cast<double>(count)));
    }
    return result;
}

ErrorMotion errorMotion(std::span<const double> values_um, std::span<const double> angle_deg, double form_um)
{
    const std::size_t points = angle_deg.size();
    const std::size_t revolutions = points > 0 ? values_um.size() / points : 0;
    std::vector<double> mean(points, notANumber), variance(points, notANumber), counts(points, 0);
    Extent asynchronous;
    asynchronous.low = 0;
    for (std::size_t i = 0; i < points; ++i) {
        double sum = 0;
        std::size_t count = 0;
        Extent extent;
        for (std::size_t k = 0; k < revolutions; ++k) {
            const double value = values_um[k * points + i];
            if (!std::isfinite(value)) continue;
            sum += value;
            ++count;
            extent.add(value);
        }
        if (count == 0) continue;
        mean[i] = sum / static_cast<double>(count);
        counts[i] = static_cast<double>(count);
        double squares = 0;
        for (std::size_t k = 0; k < revolutions; ++k) {
            const double away = values_um[k * points + i] - mean[i];
            if (std::isfinite(away)) squares += away * away;
        }
        if (count > 1) variance[i] = squares / (counts[i] - 1);
        asynchronous.add(extent.range());
    }
    ErrorMotion result = errorMotionOfMean(mean, angle_deg);
    if (revolutions < 2) return result;
    result.asynchronous_um = asynchronous.range();
    Extent total;
    for (std::size_t i = 0; i < points; ++i) {
        const double removed = mean[i] - result.synchronous_curve_um[i];
        for (std::size_t k = 0; k < revolutions; ++k) total.add(values_um[k * points + i] - removed);
    }
    result.total_um = total.range();
    addUncertainties(result, variance, counts, form_um);
    return result;
}

ErrorMotion errorMotionOfMean(std::span<const double> mean_um, std::span<const double> angle_deg)
{
    ErrorMotion result;
    result.asynchronous_um = notANumber;
    result.total_um = notANumber;
    const Eigen::Vector3d removed = firstHarmonic(mean_um, angle_deg);
    Extent extent;
    for (std::size_t i = 0; i < mean_um.size(); ++i) {
        result.synchronous_curve_um.push_back(mean_um[i] - harmonicAt(removed, angle_deg[i]));
        extent.add(result.synchronous_curve_um.back());
    }
    result.synchronous_um = extent.range();
    return result;
}

std::vector<double> rotatingDirection(std::span<const double> x_um, std::span<const double> y_um,
                                      std::span<const double> angle_deg)
{
    // The sense of the recorded angle follows from the mandrel's eccentricity: x + jy contains e^{jθ} or e^{-jθ}.
    const std::span<const double> first_x = x_um.first(std::min(x_um.size(), angle_deg.size()));
    const std::span<const double> first_y = y_um.first(first_x.size());
    const Eigen::Vector3d x = firstHarmonic(first_x, angle_deg);
    const Eigen::Vector3d y = firstHarmonic(first_y, angle_deg);
    const double forward = std::hypot(x[1] + y[2], y[1] - x[2]);
    const double backward = std::hypot(x[1] - y[2], y[1] + x[2]);
    const double sense = forward >= backward ? 1 : -1;
    std::vector<double> result(x_um.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double angle = rad_per_deg * angle_deg[i % angle_deg.size()];
        result[i] = x_um[i] * std::cos(angle) + sense * y_um[i] * std::sin(angle);
    }
    return result;
}

}  // namespace lathelier::trajectory
