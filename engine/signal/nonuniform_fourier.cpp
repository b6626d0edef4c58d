#include "engine/signal/nonuniform_fourier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/signal/fourier.h"

namespace lathelier {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
constexpr std::size_t grain = 1 << 15;
constexpr int reach = 14;  ///< grid points on each side that a value is spread over: 1e-13

/// The oversampled grid of the paper: every value is spread over 2·reach points by a Gaussian, which the transform
/// takes back exactly.
class Grid {
public:
    explicit Grid(int limit)
        : limit_(limit),
          size_(quickTransformLength(
              std::max<std::size_t>(2 * (2 * static_cast<std::size_t>(limit) + 1), 4 * std::size_t{reach}))),
          step_(2 * pi / static_cast<double>(size_))
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
        double turns = angle / (2 * pi);
        turns -= std::floor(turns);
        const double position = turns * static_cast<double>(size_);
        const double base = std::floor(position);
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

    /// What takes the Gaussian back at order k.
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

}  // namespace

std::vector<Complex> fourierSums(std::span<const double> angle_rad, std::span<const double> values, int limit,
                                 const Progress& progress)
{
    const Grid grid(limit);
    // A grid for each chunk: no more grids than there is room for as many numbers as values.
    const std::vector<double> spread = parallelReduce(
        values.size(), std::max(grain, grid.size()), progress, std::vector<double>(grid.size(), 0.0),
        [&](std::size_t begin, std::size_t end) {
            std::vector<double> part(grid.size(), 0.0);
            for (std::size_t j = begin; j < end; ++j) {
                const double value = values[j];
                grid.around(angle_rad[j], [&](std::size_t index, double weight) { part[index] += value * weight; });
            }
            return part;
        },
        [](std::vector<double> all, const std::vector<double>& part) {
            for (std::size_t i = 0; i < all.size(); ++i) all[i] += part[i];
            return all;
        });
    std::vector<Complex> sums = FourierTransform(grid.size()).forward(spread);
    sums.resize(static_cast<std::size_t>(limit) + 1);
    for (int k = 0; k <= limit; ++k) sums[static_cast<std::size_t>(k)] *= grid.sharpen(k);
    return sums;
}

std::vector<double> fourierSeries(std::span<const Complex> coefficients, std::span<const double> angle_rad,
                                  const Progress& progress)
{
    const Grid grid(static_cast<int>(coefficients.size()) - 1);
    std::vector<Complex> half(grid.size() / 2 + 1);
    for (int k = 0; k <= grid.limit(); ++k)
        half[static_cast<std::size_t>(k)] = coefficients[static_cast<std::size_t>(k)] * grid.sharpen(k);
    const std::vector<double> smooth = FourierTransform(grid.size()).series(half);
    std::vector<double> result(angle_rad.size(), 0.0);
    parallelFor(result.size(), grain, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) {
            double sum = 0;
            grid.around(angle_rad[j], [&](std::size_t index, double weight) { sum += smooth[index] * weight; });
            result[j] = sum;
        }
    });
    return result;
}

}  // namespace lathelier
