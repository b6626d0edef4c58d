#include "engine/signal/nonuniform_fourier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/signal/fourier.h"

namespace lathelier::signal {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;
constexpr std::size_t anglesPerTask = 1 << 15;

/// Inline floor for values within the range of an integer.
double wholeBelow(double x)
{
    const auto whole = static_cast<double>(static_cast<std::int64_t>(x));
    return whole > x ? whole - 1 : whole;
}

constexpr int reach = 14;  ///< grid points on each side that a value is spread over: 1e-13

/// The oversampled grid of the paper: every value is spread over 2·reach points by a Gaussian, which is inverted
/// exactly after the transform.
class Grid {
public:
    explicit Grid(int limit)
        : limit_(limit),
          size_(quickTransformLength(
              std::max<std::size_t>(2 * (2 * static_cast<std::size_t>(limit) + 1), 4 * std::size_t{reach}))),
          step_(turn_rad / static_cast<double>(size_))
    {
        const double modes = 2.0 * limit + 1;
        const double ratio = static_cast<double>(size_) / modes;
        tau_ = pi * reach / (modes * modes * ratio * (ratio - 0.5));
        for (int l = 0; l < 2 * reach; ++l) {
            const double x = (l - reach + 1) * step_;
            fixed_[static_cast<std::size_t>(l)] = std::exp(-x * x / (4 * tau_));
        }
    }

    std::size_t size() const { return size_; }

    /// Calls visit(grid index, weight) for the points about `angle`.
    template <class Visit>
    void around(double angle, Visit visit) const
    {
        double turns = angle / turn_rad;
        turns -= wholeBelow(turns);
        const double position = turns * static_cast<double>(size_);
        const double base = wholeBelow(position);
        const double x = (position - base) * step_;  // from the grid point below
        // exp(-(x - lh)²/4τ) = exp(-x²/4τ) exp(xh/2τ)^l exp(-(lh)²/4τ): two exponentials for all points, from l = 1 -
        // reach
        const double rise = x * step_ / (2 * tau_);
        const double ratio = std::exp(rise);
        double power = std::exp(-x * x / (4 * tau_) - (reach - 1) * rise);
        std::size_t index = (static_cast<std::size_t>(base) + size_ - (reach - 1)) % size_;
        for (std::size_t l = 0; l < 2 * std::size_t{reach}; ++l) {
            visit(index, power * fixed_[l]);
            power *= ratio;
            if (++index == size_) index = 0;
        }
    }

    /// Deconvolution factor of the Gaussian at order k.
    double sharpen(int k) const
    {
        return std::sqrt(pi / tau_) * std::exp(static_cast<double>(k) * k * tau_) / static_cast<double>(size_);
    }

    int limit() const { return limit_; }

private:
    int limit_;
    std::size_t size_;
    double step_;
    double tau_ = 0;
    std::array<double, 2 * std::size_t{reach}> fixed_{};
};

/// For many more values than orders: each value is expanded about the nearest of evenly spaced nodes, in powers of its
/// distance. One transform of each power: (kx)^p/p! of the largest order k and distance x falls to 2e-14 at the last.
class Expansion {
public:
    static constexpr std::size_t powers = 10;  // number of powers, even

    explicit Expansion(int limit)
        : limit_(limit), size_(quickTransformLength(16 * static_cast<std::size_t>(limit))), transform_(size_)
    {
    }

    /// Whether this method is cheaper.
    static bool pays(std::size_t values, int limit)
    {
        return limit > 0 && values > 100 * static_cast<std::size_t>(limit);
    }

    std::size_t size() const { return size_; }

    struct Place {
        std::size_t node;
        double off;  ///< in spacings of the nodes, -0.5…0.5
    };
    Place placeOf(double angle) const
    {
        double turns = angle / turn_rad;
        turns -= wholeBelow(turns);
        const double position = turns * static_cast<double>(size_), nearest = wholeBelow(position + 0.5);
        const auto node = static_cast<std::size_t>(nearest);
        return {node < size_ ? node : node - size_, position - nearest};
    }

    /// `moments[node * powers + p]`: sum of the values about the node times off^p.
    std::vector<Complex> sums(const std::vector<double>& moments) const
    {
        std::vector<Complex> result(static_cast<std::size_t>(limit_) + 1);
        std::vector<double> moment(size_);
        for (std::size_t p = 0; p < powers; ++p) {
            for (std::size_t node = 0; node < size_; ++node) moment[node] = moments[node * powers + p];
            const std::vector<Complex> spectrum = transform_.forward(moment);
            for (std::size_t k = 0; k < result.size(); ++k) result[k] += term(k, p, -1) * spectrum[k];
        }
        return result;
    }

    /// The series at every node, and its derivatives: `[node * powers + p]` times off^p adds up to the value.
    std::vector<double> derivatives(std::span<const Complex> coefficients) const
    {
        std::vector<double> result(size_ * powers);
        std::vector<Complex> half(size_ / 2 + 1);
        for (std::size_t p = 0; p < powers; ++p) {
            for (std::size_t k = 0; k < coefficients.size(); ++k) half[k] = term(k, p, 1) * coefficients[k];
            const std::vector<double> values = transform_.series(half);
            for (std::size_t node = 0; node < size_; ++node) result[node * powers + p] = values[node];
        }
        return result;
    }

private:
    /// (±ikh)^p / p! with the nodes' spacing h.
    Complex term(std::size_t k, std::size_t p, int sign) const
    {
        const double kh = turn_rad * static_cast<double>(k) / static_cast<double>(size_);
        Complex result = 1;
        for (std::size_t i = 1; i <= p; ++i) result *= Complex(0, sign * kh / static_cast<double>(i));
        return result;
    }

    int limit_;
    std::size_t size_;
    FourierTransform transform_;
};

std::vector<double> added(std::vector<double> all, const std::vector<double>& part)
{
    for (std::size_t i = 0; i < all.size(); ++i) all[i] += part[i];
    return all;
}

std::vector<Complex> expandedSums(std::span<const double> angle_rad, std::span<const double> values, int limit,
                                  const Progress& progress)
{
    constexpr std::size_t powers = Expansion::powers;
    const Expansion expansion(limit);
    const std::size_t size = expansion.size() * powers;
    return expansion.sums(parallelReduce(
        values.size(), std::max(anglesPerTask, size), progress, std::vector<double>(size, 0.0),
        [&](std::size_t begin, std::size_t end) {
            std::vector<double> moments(size, 0.0);
            // Neighbours mostly belong to one node: its sums are accumulated before they are stored.
            std::array<double, powers> sum{};
            std::size_t node = 0;
            const auto lay = [&] {
                for (std::size_t p = 0; p < powers; ++p) moments[node * powers + p] += sum[p];
            };
            for (std::size_t j = begin; j < end; ++j) {
                const Expansion::Place place = expansion.placeOf(angle_rad[j]);
                if (place.node != node) {
                    lay();
                    sum = {};
                    node = place.node;
                }
                const double squared = place.off * place.off;
                double even = values[j], odd = even * place.off;
                for (std::size_t p = 0; p < powers; p += 2) {
                    sum[p] += even;
                    sum[p + 1] += odd;
                    even *= squared;
                    odd *= squared;
                }
            }
            lay();
            return moments;
        },
        added));
}

std::vector<double> expandedSeries(std::span<const Complex> coefficients, std::span<const double> angle_rad,
                                   const Progress& progress)
{
    constexpr std::size_t powers = Expansion::powers;
    const Expansion expansion(static_cast<int>(coefficients.size()) - 1);
    const std::vector<double> derivatives = expansion.derivatives(coefficients);
    std::vector<double> result(angle_rad.size());
    parallelFor(result.size(), anglesPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) {
            const Expansion::Place place = expansion.placeOf(angle_rad[j]);
            const double* factor = &derivatives[place.node * powers];
            double value = factor[powers - 1];
            for (std::size_t p = powers - 1; p-- > 0;) value = value * place.off + factor[p];
            result[j] = value;
        }
    });
    return result;
}

}  // namespace

std::vector<Complex> fourierSums(std::span<const double> angle_rad, std::span<const double> values, int limit,
                                 const Progress& progress)
{
    if (Expansion::pays(values.size(), limit)) return expandedSums(angle_rad, values, limit, progress);
    const Grid grid(limit);
    // A grid for each chunk: as many grids as fit into the memory of the values.
    const std::vector<double> spread = parallelReduce(
        values.size(), std::max(anglesPerTask, grid.size()), progress, std::vector<double>(grid.size(), 0.0),
        [&](std::size_t begin, std::size_t end) {
            std::vector<double> part(grid.size(), 0.0);
            for (std::size_t j = begin; j < end; ++j) {
                const double value = values[j];
                grid.around(angle_rad[j], [&](std::size_t index, double weight) { part[index] += value * weight; });
            }
            return part;
        },
        added);
    std::vector<Complex> sums = FourierTransform(grid.size()).forward(spread);
    sums.resize(static_cast<std::size_t>(limit) + 1);
    for (int k = 0; k <= limit; ++k) sums[static_cast<std::size_t>(k)] *= grid.sharpen(k);
    return sums;
}

std::vector<double> fourierSeries(std::span<const Complex> coefficients, std::span<const double> angle_rad,
                                  const Progress& progress)
{
    if (const int limit = static_cast<int>(coefficients.size()) - 1; Expansion::pays(angle_rad.size(), limit))
        return expandedSeries(coefficients, angle_rad, progress);
    const Grid grid(static_cast<int>(coefficients.size()) - 1);
    std::vector<Complex> half(grid.size() / 2 + 1);
    for (int k = 0; k <= grid.limit(); ++k)
        half[static_cast<std::size_t>(k)] = coefficients[static_cast<std::size_t>(k)] * grid.sharpen(k);
    const std::vector<double> smooth = FourierTransform(grid.size()).series(half);
    std::vector<double> result(angle_rad.size(), 0.0);
    parallelFor(result.size(), anglesPerTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) {
            double sum = 0;
            grid.around(angle_rad[j], [&](std::size_t index, double weight) { sum += smooth[index] * weight; });
            result[j] = sum;
        }
    });
    return result;
}

}  // namespace lathelier::signal
