#include "engine/signal/fourier.h"

#include <numbers>
#include <unsupported/Eigen/FFT>

namespace lathelier::signal {
namespace {

using Complex = std::complex<double>;

std::size_t largestPrimeFactor(std::size_t n)
{
    std::size_t largest = 1;
    for (std::size_t p = 2; p * p <= n; ++p)
        while (n % p == 0) {
            largest = std::max(largest, p);
            n /= p;
        }
    return std::max(largest, n);
}

/// Above this factor a direct transform of the factor costs more than Bluestein's three.
constexpr std::size_t largestDirectFactor = 60;

}  // namespace

struct FourierTransform::Plan {
    std::size_t n;
    std::size_t padded = 0;          ///< Bluestein's length, 0 when not needed
    std::vector<Complex> chirp;      ///< e^{-πi j²/n}
    std::vector<Complex> spectrum;   ///< of the conjugate chirp, at the padded length
    mutable Eigen::FFT<double> fft;  // holds scratch space

    /// All n orders of complex values, by Bluestein: jk = (j² + k² - (k-j)²)/2 makes the sum a convolution.
    std::vector<Complex> chirped(const std::vector<Complex>& values) const
    {
        std::vector<Complex> a(padded), product, result(n);
        for (std::size_t j = 0; j < n; ++j) a[j] = values[j] * chirp[j];
        fft.fwd(product, a);
        for (std::size_t i = 0; i < padded; ++i) product[i] *= spectrum[i];
        fft.inv(a, product);
        for (std::size_t k = 0; k < n; ++k) result[k] = a[k] * chirp[k];
        return result;
    }
};

FourierTransform::FourierTransform(std::size_t length) : plan_(std::make_unique<Plan>())
{
    plan_->n = length;
    if (largestPrimeFactor(length) <= largestDirectFactor) return;
    const std::size_t n = length;
    plan_->padded = quickTransformLength(2 * n - 1);
    plan_->chirp.resize(n);
    for (std::size_t j = 0; j < n; ++j) {
        // j² modulo 2n keeps the angle small, and so exact, for long transforms.
        const std::size_t square = j * j % (2 * n);
        const double angle = std::numbers::pi * static_cast<double>(square) / static_cast<double>(n);
        plan_->chirp[j] = {std::cos(angle), -std::sin(angle)};
    }
    std::vector<Complex> kernel(plan_->padded);
    for (std::size_t j = 0; j < n; ++j) {
        kernel[j] = std::conj(plan_->chirp[j]);
        if (j > 0) kernel[plan_->padded - j] = kernel[j];
    }
    plan_->fft.fwd(plan_->spectrum, kernel);
}

FourierTransform::~FourierTransform() = default;
FourierTransform::FourierTransform(FourierTransform&&) noexcept = default;
FourierTransform& FourierTransform::operator=(FourierTransform&&) noexcept = default;

std::size_t FourierTransform::length() const
{
    return plan_->n;
}

std::vector<Complex> FourierTransform::forward(std::span<const double> values) const
{
    const std::size_t n = plan_->n;
    std::vector<Complex> result;
    std::vector<Complex> in(values.begin(), values.end());
    if (n == 1)
        result = in;
    else if (plan_->padded > 0)
        result = plan_->chirped(in);
    else
        plan_->fft.fwd(result, in);
    result.resize(n / 2 + 1);
    return result;
}

std::vector<double> FourierTransform::series(std::span<const Complex> half) const
{
    // For real results the sum with e^{+…} is the conjugate of forward() on the conjugates.
    const std::size_t n = plan_->n;
    std::vector<Complex> all(n), sums;
    for (std::size_t k = 0; k < n; ++k) {
        const bool mirrored = k > n / 2;
        const Complex value = half[mirrored ? n - k : k];
        all[k] = mirrored ? value : std::conj(value);
    }
    if (n == 1)
        sums = all;
    else if (plan_->padded > 0)
        sums = plan_->chirped(all);
    else
        plan_->fft.fwd(sums, all);
    std::vector<double> result(n);
    for (std::size_t j = 0; j < n; ++j) result[j] = sums[j].real();
    return result;
}

std::size_t quickTransformLength(std::size_t minimum)
{
    for (std::size_t n = std::max<std::size_t>(2, minimum + minimum % 2);; n += 2)
        if (largestPrimeFactor(n) <= 5) return n;
}

}  // namespace lathelier::signal
