// The discrete Fourier transform of real values, of any length, in O(n log n).
// Lengths with large prime factors go through Bluestein's chirp (Bluestein 1970).
#pragma once

#include <complex>
#include <memory>
#include <span>
#include <vector>

namespace lathelier::signal {

/// Transforms of one length, prepared once. Not thread-safe.
class FourierTransform {
public:
    explicit FourierTransform(std::size_t length);  ///< at least 1
    ~FourierTransform();
    FourierTransform(FourierTransform&&) noexcept;
    FourierTransform& operator=(FourierTransform&&) noexcept;

    std::size_t length() const;

    /// X_k = Σ_j x_j e^{-2πi jk/n} for k = 0…n/2 (rounded down).
    std::vector<std::complex<double>> forward(std::span<const double> values) const;

    /// x_j = Σ_k X_k e^{2πi jk/n} over all n orders, of which `half` are k = 0…n/2 and the others their conjugates: n
    /// times the inverse of forward().
    std::vector<double> series(std::span<const std::complex<double>> half) const;

private:
    struct Plan;
    std::unique_ptr<Plan> plan_;
};

/// The least even length ≥ `minimum` without a prime factor above 5, which is fast to transform.
std::size_t quickTransformLength(std::size_t minimum);

}  // namespace lathelier::signal
