#include "engine/signal/hampel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"

namespace lathelier::signal {
namespace {

constexpr double normalPerMedian = 1.4826;

constexpr std::size_t grain = 8192;

/// The finite values about a place that moves along, in ascending order.
class MovingWindow {
public:
    MovingWindow(std::span<const double> values, const HampelOptions& options, std::size_t place)
        : values_(values),
          closed_(options.closed),
          half_(std::min<std::ptrdiff_t>(options.half_window, (std::ssize(values) - 1) / 2)),
          place_(static_cast<std::ptrdiff_t>(place))
    {
        for (std::ptrdiff_t j = place_ - half_; j <= place_ + half_; ++j) enter(j);
    }

    void advance()
    {
        leave(place_ - half_);
        ++place_;
        enter(place_ + half_);
    }

    double median() const
    {
        const std::size_t n = sorted_.size();
        return n % 2 == 1 ? sorted_[n / 2] : (sorted_[n / 2] + sorted_[n / 2 - 1]) / 2;
    }

    /// Median of the distances from `middle`, which lies among the values: from it outwards they ascend on either side.
    double medianDistance(double middle) const
    {
        std::size_t right = sorted_.size() / 2, left = right;  // left: of the value after the next one on that side
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

    /// NaN where there is none.
    double at(std::ptrdiff_t j) const
    {
        const std::ptrdiff_t n = std::ssize(values_);
        if (!closed_ && (j < 0 || j >= n)) return std::numeric_limits<double>::quiet_NaN();
        return values_[static_cast<std::size_t>(j < 0 ? j + n : j >= n ? j - n : j)];
    }
    void enter(std::ptrdiff_t j)
    {
        const double value = at(j);
        if (std::isfinite(value)) sorted_.insert(std::upper_bound(sorted_.begin(), sorted_.end(), value), value);
    }
    void leave(std::ptrdiff_t j)
    {
        const double value = at(j);
        if (std::isfinite(value)) sorted_.erase(std::lower_bound(sorted_.begin(), sorted_.end(), value));
    }

    std::span<const double> values_;
    bool closed_;
    std::ptrdiff_t half_, place_;
    std::vector<double> sorted_;
};

}  // namespace

double robustSpread(const std::vector<double>& values)
{
    const double centre = median(values);
    std::vector<double> distances;
    distances.reserve(values.size());
    for (const double value : values) distances.push_back(std::abs(value - centre));
    return normalPerMedian * median(std::move(distances));
}

std::vector<std::uint8_t> hampelOutliers(std::span<const double> values, const HampelOptions& options,
                                         const Progress& progress)
{
    std::vector<std::uint8_t> result(values.size(), 0);
    std::vector<double> distance(values.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<double> spread(values.size(), 0.0);
    std::vector<double> finite;
    const bool moving = options.half_window > 0;
    std::vector<double> whole;
    if (!moving)
        std::copy_if(values.begin(), values.end(), std::back_inserter(whole),
                     [](double v) { return std::isfinite(v); });
    const double centre = moving ? 0 : median(whole);
    parallelFor(values.size(), grain, progress, [&](std::size_t begin, std::size_t end) {
        std::optional<MovingWindow> window;
        if (moving) window.emplace(values, options, begin);
        for (std::size_t i = begin; i < end; ++i) {
            if (moving && i > begin) window->advance();
            if (!std::isfinite(values[i])) continue;
            const double middle = moving ? window->median() : centre;
            if (moving) spread[i] = normalPerMedian * window->medianDistance(middle);
            distance[i] = std::abs(values[i] - middle);
        }
    });
    for (const double d : distance)
        if (std::isfinite(d)) finite.push_back(d);
    const double overall = std::max(normalPerMedian * median(std::move(finite)), options.least_spread);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double limit = options.threshold * std::max(spread[i], overall);
        // The last bits of equal values are no outliers.
        const double rounding = 1e-12 * std::abs(values[i]);
        result[i] = !(distance[i] <= limit + rounding);
    }
    return result;
}

}  // namespace lathelier::signal
