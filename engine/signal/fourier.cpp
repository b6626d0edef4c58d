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

/// Complex product without the checks for infinity of operator*.
Complex times(const Complex& a, const Complex& b)
{
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// Largest prime factor for which a direct transform is cheaper than Bluestein's three transforms.
constexpr std::size_t largestDirectFactor = 60;

}  // namespace

namespace detail {

/// A complex transform of any length.
class ComplexTransform {
public:
    explicit ComplexTransform(std::size_t length) : n_(length)
    {
        if (largestPrimeFactor(length) <= largestDirectFactor) return;
        padded_ = quickTransformLength(2 * n_ - 1);
        chirp_.resize(n_);
        for (std::size_t j = 0; j < n_; ++j) {
            // j² modulo 2n keeps the angle small, and so exact, for long transforms.
            const std::size_t square = j * j % (2 * n_);
            const double angle = std::numbers::pi * static_cast<double>(square) / static_cast<double>(n_);
            chirp_[j] = {std::cos(angle), -std::sin(angle)};
        }
        std::vector<Complex> kernel(padded_);
        for (std::size_t j = 0; j < n_; ++j) {
            kernel[j] = std::conj(chirp_[j]);
            if (j > 0) kernel[padded_ - j] = kernel[j];
        }
        fft_.fwd(spectrum_, kernel);
    }

    std::vector<Complex> operator()(const std::vector<Complex>& values) const
    {
        if (n_ == 1) return values;
        if (padded_ > 0) return chirped(values);
        std::vector<Complex> result;
        fft_.fwd(result, values);
        return result;
    }

private:
    /// By Bluestein: jk = (j² + k² - (k-j)²)/2 makes the sum a convolution.
    std::vector<Complex> chirped(const std::vector<Complex>& values) const
    {
        std::vector<Complex> a(padded_), product, result(n_);
        for (std::size_t j = 0; j < n_; ++j) a[j] = values[j] * chirp_[j];
        fft_.fwd(product, a);
        for (std::size_t i = 0; i < padded_; ++i) product[i] *= spectrum_[i];
        fft_.inv(a, product);
        for (std::size_t k = 0; k < n_; ++k) result[k] = a[k] * chirp_[k];
        return result;
    }

    std::size_t n_;
    std::size_t padded_ = 0;          ///< Bluestein's length, 0 when not needed
    std::vector<Complex> chirp_;      ///< e^{-πi j²/n}
    std::vector<Complex> spectrum_;   ///< of the conjugate chirp, at the padded length
    mutable Eigen::FFT<double> fft_;  // mutable: scratch memory
};

/// e^{-2πik/n} as a product of entries of two short tables.
class Turns {
public:
    explicit Turns(std::size_t n)
    {
        const auto turn = [n](std::size_t k) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
            return Complex(std::cos(angle), -std::sin(angle));
        };
        for (std::size_t k = 0; k < fineCount; ++k) fine_.push_back(turn(k));
        for (std::size_t k = 0; k <= n / 2; k += fineCount) coarse_.push_back(turn(k));
    }

    /// k up to n/2.
    Complex operator[](std::size_t k) const { return times(coarse_[k / fineCount], fine_[k % fineCount]); }

private:
    static constexpr std::size_t fineCount = 256;
    std::vector<Complex> coarse_, fine_;
};

}  // namespace detail

/// An even number of real values is transformed as half as many complex ones, of which the even values are the real
/// parts and the odd ones the imaginary.
struct FourierTransform::Plan {
    explicit Plan(std::size_t length)
        : n(length), halved(length % 2 == 0), transform(halved ? length / 2 : length), turns(halved ? length : 1)
    {
    }

    std::size_t n;
    bool halved;
    detail::ComplexTransform transform;
    detail::Turns turns;
};

FourierTransform::FourierTransform(std::size_t length) : plan_(std::make_unique<Plan>(length)) {}

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
    if (!plan_->halved) {
        std::vector<Complex> result = plan_->transform({values.begin(), values.end()});
        result.resize(n / 2 + 1);
        return result;
    }
    const std::size_t half = n / 2;
    std::vector<Complex> pairs(half);
    for (std::size_t j = 0; j < half; ++j) pairs[j] = {values[2 * j], values[2 * j + 1]};
    std::vector<Complex> both = plan_->transform(pairs);
    both.push_back(both[0]);
    // In place from both ends inward: k and half - k depend on the same two values.
    for (std::size_t k = 0; k <= half / 2; ++k) {
        const Complex a = both[k], b = std::conj(both[half - k]);
        const Complex even = (a + b) / 2.0, difference = (a - b) / 2.0;
        const Complex odd = times(Complex(difference.imag(), -difference.real()), plan_->turns[k]);
        both[k] = even + odd;
        both[half - k] = std::conj(even - odd);
    }
    return both;
}

std::vector<double> FourierTransform::series(std::span<const Complex> half) const
{
    const std::size_t n = plan_->n;
    std::vector<double> result(n);
    // For real results the sum with e^{+…} is the conjugate of forward() on the conjugates.
    if (!plan_->halved) {
        std::vector<Complex> all(n);
        for (std::size_t k = 0; k < n; ++k) all[k] = k > n / 2 ? half[n - k] : std::conj(half[k]);
        const std::vector<Complex> sums = plan_->transform(all);
        for (std::size_t j = 0; j < n; ++j) result[j] = sums[j].real();
        return result;
    }
    const std::size_t middle = n / 2;
    std::vector<Complex> pairs(middle);
    for (std::size_t k = 0; k < middle; ++k) {
        const bool first = k == 0;  // the first and the last order have no imaginary part
        const Complex a = first ? half[0].real() : half[k];
        const Complex b = first ? half[middle].real() : std::conj(half[middle - k]);
        const Complex odd = times(a - b, std::conj(plan_->turns[k]));
        const Complex even = a + b;
        pairs[k] = {even.real() - odd.imag(), -even.imag() - odd.real()};  // the conjugate of even + i odd
    }
    const std::vector<Complex> sums = plan_->transform(pairs);
    for (std::size_t j = 0; j < middle; ++j) {
        result[2 * j] = sums[j].real();
        result[2 * j + 1] = -sums[j].imag();
    }
    return result;
}

std::size_t quickTransformLength(std::size_t minimum)
{
    for (std::size_t n = std::max<std::size_t>(2, minimum + minimum % 2);; n += 2)
        if (largestPrimeFactor(n) <= 5) return n;
}

}  // namespace lathelier::signal
