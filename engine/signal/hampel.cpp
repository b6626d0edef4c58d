#include "engine/signal/hampel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"

namespace lathelier::signal {
namespace {

constexpr std::size_t valuesPerTask = 8192;

/// Sorted sliding window of the finite values.
class MovingWindow {
public:
    MovingWindow(std::span<const double> values, const HampelOptions& options, std::size_t place)
        : values_(values),
          closed_(options.closed),
          half_(std::min<std::ptrdiff_t>(options.half_window, (std::ssize(values) - 1) / 2)),
          place_(static_cast<std::ptrdiff_t>(place))
    {
        sorted_.reserve(2 * static_cast<std::size_t>(half_) + 1);
        for (std::ptrdiff_t j = place_ - half_; j <= place_ + half_; ++j) enter(at(j));
    }

    void advance()
    {
        const double old = at(place_ - half_);
        ++place_;
        const double fresh = at(place_ + half_);
        if (std::isfinite(old) && std::isfinite(fresh)) {
            replace(old, fresh);
        } else {
            leave(old);
            enter(fresh);
        }
    }

    double median() const
    {
        const std::size_t n = sorted_.size();
        return n % 2 == 1 ? sorted_[n / 2] : (sorted_[n / 2] + sorted_[n / 2 - 1]) / 2;
    }

    /// Median of the distances from `middle`: they ascend outwards from it on either side.
    double medianDistance(double middle) const
    {
        std::size_t right = sorted_.size() / 2, left = right;  // left: one past the next value on that side
        double before = 0, last = 0;
        for (std::size_t taken = 0; taken <= sorted_.size() / 2; ++taken) {
            before = last;
            const double below = left > 0 ? std::abs(sorted_[left - 1] - middle) : infinity;
            const double above = right < sorted_.size() ? std::abs(sorted_[right] - middle) : infinity;
            last = std::min(below, above);
            below < above ? --left : ++right;
        }
        return sorted_.size() % 2 == 1 ? last : (last + before) / 2;
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    /// Median; NaN for an empty window.
    double at(std::ptrdiff_t j) const
    {
        const std::ptrdiff_t n = std::ssize(values_);
        if (!closed_ && (j < 0 || j >= n)) return notANumber;
        return values_[static_cast<std::size_t>(j < 0 ? j + n : j >= n ? j - n : j)];
    }
    void enter(double value)
    {
        if (std::isfinite(value)) sorted_.insert(std::upper_bound(sorted_.begin(), sorted_.end(), value), value);
    }
    void leave(double value)
    {
        if (std::isfinite(value)) sorted_.erase(std::lower_bound(sorted_.begin(), sorted_.end(), value));
    }
    /// Only the values between old and new position move.
    void replace(double old, double fresh)
    {
        const std::size_t n = sorted_.size();
        double* sorted = sorted_.data();
        std::size_t i = 0;
        while (sorted[i] < old) ++i;
        for (; i + 1 < n && sorted[i + 1] < fresh; ++i) sorted[i] = sorted[i + 1];
        for (; i > 0 && sorted[i - 1] > fresh; --i) sorted[i] = sorted[i - 1];
        sorted[i] = fresh;
    }

    std::span<const double> values_;
    bool closed_;
    std::ptrdiff_t half_, place_;
    std::vector<double> sorted_;
};

}  // namespace

double robustSpread(const std::vector<double>& values)
{
    return robustSpread(values, median(values));
}

double robustSpread(const std::vector<double>& values, double centre)
{
    std::vector<double> distances;
    distances.reserve(values.size());
    for (const double value : values) distances.push_back(std::abs(value - centre));
    return madToSigma * median(std::move(distances));
}

std::vector<std::uint8_t> hampelOutliers(std::span<const double> values, const HampelOptions& options,
                                         const Progress& progress)
{
    std::vector<std::uint8_t> result(values.size(), 0);
    std::vector<double> distance(values.size(), notANumber);
    const bool moving = options.half_window > 0;
    std::vector<double> whole;
    if (!moving)
        std::copy_if(values.begin(), values.end(), std::back_inserter(whole),
                     [](double v) { return std::isfinite(v); });
    const double centre = moving ? 0 : median(std::move(whole));
    parallelFor(values.size(), valuesPerTask, progress, [&](std::size_t begin, std::size_t end) {
        std::optional<MovingWindow> window;
        if (moving) window.emplace(values, options, begin);
        for (std::size_t i = begin; i < end; ++i) {
            if (moving && i > begin) window->advance();
            if (std::isfinite(values[i])) distance[i] = std::abs(values[i] - (moving ? window->median() : centre));
        }
    });
    std::vector<double> finite;
    finite.reserve(distance.size());
    for (const double d : distance)
        if (std::isfinite(d)) finite.push_back(d);
    const double overall = std::max(madToSigma * median(std::move(finite)), options.least_spread);
    parallelFor(values.size(), valuesPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            // Differences in the last bits are not outliers.
            const double rounding = 1e-12 * std::abs(values[i]);
            if (distance[i] <= options.threshold * overall + rounding) continue;
            // Few values reach this test, so that the spread of the window is computed for these only.
            double spread = 0;
            if (moving && std::isfinite(values[i])) {
                const MovingWindow window(values, options, i);
                spread = madToSigma * window.medianDistance(window.median());
            }
            result[i] = !(distance[i] <= options.threshold * std::max(spread, overall) + rounding);
        }
    });
    return result;
}

}  // namespace lathelier::signal
