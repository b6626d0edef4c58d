#include "engine/form/roundness/superimpose.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/units.h"
#include "engine/form/form_codes.h"
#include "engine/form/roundness/prepared_profile.h"
#include "engine/signal/closed_interpolation.h"
#include "engine/signal/fourier.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;
constexpr std::size_t mostStarts = 12;
constexpr int mostSteps = 60;
constexpr double leastForm = 1e-10;  ///< form amplitude over radius below which the form is rounding

/// One profile about its least-squares centre, filtered.
struct FilteredForm {
    PreparedProfile prepared;
    std::vector<double> deviation_mm;  ///< in the order of the sampling
};

FilteredForm filteredFormOf(const Profile& profile, const RoundnessParameters& parameters,
                            const std::vector<Interval>& exclude_deg, const Progress& progress)
{
    FilteredForm form{prepareProfile(profile, exclude_deg, parameters.outliers, progress), {}};
    const PreparedProfile& points = form.prepared;
    form.deviation_mm = filterClosedAt(points.sampling, points.distance_mm, bandOf(parameters), progress).values;
    for (double& value : form.deviation_mm) value -= form.prepared.radius_mm;
    return form;
}

/// Values at `count` uniform angles; NaN in gaps.
std::vector<double> sampled(const FilteredForm& form, std::size_t count)
{
    const signal::ClosedInterpolation at(form.prepared.sampling, form.deviation_mm);
    std::vector<double> result(count);
    for (std::size_t i = 0; i < count; ++i)
        result[i] = at(turn_rad * static_cast<double>(i) / static_cast<double>(count));
    return result;
}

/// Pose of the second profile relative to the first: first(θ) ≈ second(±(θ - rotation)) + shift · (cos θ, sin θ) +
/// radius.
struct Pose {
    double rotation = 0;
    bool mirrored = false;
    Eigen::Vector3d rest = Eigen::Vector3d::Zero();  ///< shift x, y and radius
    double rms = std::numeric_limits<double>::infinity();
};

class Fit {
public:
    Fit(const std::vector<double>& first, const FilteredForm& second)
        : first_(first),
          second_(second.prepared.sampling, second.deviation_mm),
          step_(turn_rad / static_cast<double>(first.size()))
    {
    }

    double secondAt(double angle, const Pose& pose) const
    {
        return second_((angle - pose.rotation) * (pose.mirrored ? -1 : 1));
    }

    /// Shift and radius by least squares for the pose's rotation; fills its rms.
    void settle(Pose& pose) const
    {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        double squares = 0, count = 0;
        for (std::size_t i = 0; i < first_.size(); ++i) {
            const double angle = step_ * static_cast<double>(i);
            const double difference = first_[i] - secondAt(angle, pose);
            if (std::isnan(difference)) continue;
            const Eigen::Vector3d row(std::cos(angle), std::sin(angle), 1);
            normal.noalias() += row * row.transpose();
            right += row * difference;
            squares += difference * difference;
            ++count;
        }
        if (count < 4) return;
        pose.rest = normal.ldlt().solve(right);
        pose.rms = std::sqrt(std::max(0.0, squares - right.dot(pose.rest)) / count);
    }

    /// The rotation with the smallest rms within one grid step around `start` (golden section).
    Pose refined(const Pose& start) const
    {
        const double golden = (std::sqrt(5.0) - 1) / 2;
        double low = start.rotation - step_, high = start.rotation + step_;
        const auto probe = [&](double rotation) {
            Pose pose = start;
            pose.rotation = rotation;
            settle(pose);
            return pose;
        };
        Pose left = probe(high - golden * (high - low)), right = probe(low + golden * (high - low));
        for (int i = 0; i < mostSteps && high - low > 1e-7; ++i) {
            if (left.rms <= right.rms) {
                high = right.rotation;
                right = left;
                left = probe(high - golden * (high - low));
            } else {
                low = left.rotation;
                left = right;
                right = probe(low + golden * (high - low));
            }
        }
        return left.rms <= right.rms ? left : right;
    }

private:
    const std::vector<double>& first_;
    signal::ClosedInterpolation second_;
    double step_;
};

std::vector<double> withoutGaps(std::vector<double> values)
{
    for (double& value : values)
        if (std::isnan(value)) value = 0;
    return values;
}

/// Σ_i first_i second_{±(i - s)} for every shift s, by transform.
std::vector<double> crossCorrelation(const std::vector<double>& first, const std::vector<double>& second, bool mirrored)
{
    const signal::FourierTransform transform(first.size());
    std::vector<std::complex<double>> product = transform.forward(withoutGaps(first));
    const std::vector<std::complex<double>> other = transform.forward(withoutGaps(second));
    for (std::size_t k = 0; k < product.size(); ++k) product[k] *= mirrored ? other[k] : std::conj(other[k]);
    product[0] = 0;
    if (product.size() > 1) product[1] = 0;  // order 1 is the shift of the centre
    return transform.series(product);
}

/// The highest maxima of the correlation over the grid.
std::vector<Pose> starts(const std::vector<double>& correlation, bool mirrored)
{
    const std::size_t n = correlation.size();
    std::vector<std::size_t> peaks;
    for (std::size_t i = 0; i < n; ++i)
        if (correlation[i] >= correlation[(i + 1) % n] && correlation[i] > correlation[(i + n - 1) % n])
            peaks.push_back(i);
    std::stable_sort(peaks.begin(), peaks.end(),
                     [&](std::size_t a, std::size_t b) { return correlation[a] > correlation[b]; });
    peaks.resize(std::min(peaks.size(), mostStarts));
    if (peaks.empty()) peaks.push_back(0);
    std::vector<Pose> result;
    for (const std::size_t i : peaks) {
        Pose pose;
        pose.rotation = std::remainder(turn_rad * static_cast<double>(i) / static_cast<double>(n), turn_rad);
        pose.mirrored = mirrored;
        result.push_back(pose);
    }
    return result;
}

/// Fills the curves and the differences.
void compare(const std::vector<double>& first, const Fit& fit, const Pose& pose, SuperimposeResult& result)
{
    double sum = 0, squares = 0, count = 0, ab = 0, aa = 0, bb = 0;
    const double step = turn_rad / static_cast<double>(first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        const double angle = step * static_cast<double>(i);
        const double second =
            fit.secondAt(angle, pose) + pose.rest.dot(Eigen::Vector3d(std::cos(angle), std::sin(angle), 1));
        result.angle_deg.push_back(angle / rad_per_deg);
        result.first_um.push_back(1000 * first[i]);
        result.second_um.push_back(1000 * second);
        const double difference = std::abs(result.first_um.back() - result.second_um.back());
        if (std::isnan(difference)) continue;
        result.largest_difference_um = std::max(result.largest_difference_um, difference);
        sum += difference;
        squares += difference * difference;
        ab += first[i] * second;
        aa += first[i] * first[i];
        bb += second * second;
        ++count;
    }
    result.mean_difference_um = sum / count;
    result.rms_difference_um = std::sqrt(squares / count);
    result.correlation = aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

double formSpread(const std::vector<double>& values)
{
    double squares = 0, count = 0;
    for (const double value : values)
        if (!std::isnan(value)) {
            squares += value * value;
            ++count;
        }
    return std::sqrt(squares / std::max(1.0, count));
}

/// Another rotation has nearly the same residual: the gain of the best one is a small part of the form.
bool isAmbiguous(const std::vector<Pose>& poses, const Pose& best, double spread)
{
    const double margin = 0.02 * spread * spread;
    return std::any_of(poses.begin(), poses.end(), [&](const Pose& pose) {
        const bool other = pose.mirrored != best.mirrored ||
                           std::abs(std::remainder(pose.rotation - best.rotation, turn_rad)) > 2 * rad_per_deg;
        return other && pose.rms * pose.rms <= best.rms * best.rms + margin;
    });
}

}  // namespace

SuperimposeResult superimpose(const Profile& first, const Profile& second, const SuperimposeParameters& parameters,
                              const Progress& progress)
{
    progress.report(0);
    const FilteredForm a = filteredFormOf(first, parameters.form, parameters.form.exclude_deg, progress);
    const FilteredForm b = filteredFormOf(second, parameters.form, {}, progress);
    const std::size_t count =
        std::clamp<std::size_t>(std::max(a.prepared.index.size(), b.prepared.index.size()), 360, 3600);
    const std::vector<double> grid_a = sampled(a, count);
    const std::vector<double> grid_b = sampled(b, count);
    const Fit fit(grid_a, b);

    std::vector<Pose> poses = starts(crossCorrelation(grid_a, grid_b, false), false);
    if (parameters.mirrored)
        for (const Pose& pose : starts(crossCorrelation(grid_a, grid_b, true), true)) poses.push_back(pose);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        progress.report(0.1 + 0.8 * static_cast<double>(i) / static_cast<double>(poses.size()));
        poses[i] = fit.refined(poses[i]);
    }
    const double spread = formSpread(grid_a);
    Pose best = poses.front();
    for (const Pose& pose : poses) {
        // Among equally good rotations the smallest is taken.
        const bool equal = std::abs(pose.rms - best.rms) <= 1e-6 * spread + 1e-12;
        if (equal ? std::abs(pose.rotation) < std::abs(best.rotation) : pose.rms < best.rms) best = pose;
    }

    SuperimposeResult result;
    compare(grid_a, fit, best, result);
    result.rotation_deg = std::remainder(best.rotation / rad_per_deg, 360);
    result.mirrored = best.mirrored;
    Vector2d centre = b.prepared.centre_mm;
    if (best.mirrored) centre.y() = -centre.y();
    result.shift_mm =
        a.prepared.centre_mm + best.rest.head<2>() - Eigen::Rotation2Dd(best.rotation).toRotationMatrix() * centre;
    result.radius_difference_mm = b.prepared.radius_mm - a.prepared.radius_mm - best.rest[2];
    const bool round = spread < leastForm * a.prepared.radius_mm;
    if (round || isAmbiguous(poses, best, spread) || !(result.correlation > 0.3))
        result.notes.push_back({notes::rotationNotDetermined, {}});
    progress.report(1);
    return result;
}

}  // namespace lathelier::form
