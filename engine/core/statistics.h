// Order statistics and quantiles that several rooms need.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace lathelier {

/// Ratio of the standard deviation to the median absolute deviation of a normal distribution.
inline constexpr double madToSigma = 1.4826;

/// The value at rank floor(share · n) of `values`, share in 0…1, which are put into another order. NaN for no values.
template <class T>
T quantileInPlace(std::vector<T>& values, double share)
{
    if (values.empty()) return std::numeric_limits<T>::quiet_NaN();
    const auto rank = std::min(static_cast<std::size_t>(share * static_cast<double>(values.size())), values.size() - 1);
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// The value at rank floor(share · (n − 1)) of `values`, share in 0…1, which are put into another order: share 1 is the
/// largest, and an even count's 0.5 the lower of the two middle values. NaN for no values.
template <class T>
T lowerQuantileInPlace(std::vector<T>& values, double share)
{
    if (values.empty()) return std::numeric_limits<T>::quiet_NaN();
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

/// The upper of the two middle values: no mean is formed, so that a median of places is one of them.
template <class T>
T upperMedianInPlace(std::vector<T>& values)
{
    return quantileInPlace(values, 0.5);
}

/// The median of `values`, which are put into another order: the mean of the two middle values for an even count. NaN
/// for no values.
template <class T>
double medianInPlace(std::vector<T>& values)
{
    const auto upper = static_cast<double>(upperMedianInPlace(values));
    if (values.size() % 2 == 1 || values.empty()) return upper;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    return 0.5 * (upper + static_cast<double>(*std::max_element(values.begin(), middle)));
}

/// The same of values that keep their order.
double median(std::vector<double> values);

/// Tukey's biweight of a residual, `u` of the distance from which on it counts nothing: (1 − u²)² for |u| < 1, else 0.
/// Source: Beaton and Tukey, Technometrics 16 (1974) 147-185.
inline double tukeyWeight(double u)
{
    return u * u < 1 ? (1 - u * u) * (1 - u * u) : 0;
}

/// Quantile of Student's distribution at `probability` (0.975: two-sided 95 %). NaN without degrees of freedom.
double studentQuantile(double probability, std::int64_t degrees_of_freedom);

}  // namespace lathelier
