#include "engine/signal/fourier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/core/units.h"
#include "engine/signal/nonuniform_fourier.h"

namespace lathelier::signal {
namespace {

using Complex = std::complex<double>;
std::vector<double> noise(std::size_t n, std::uint64_t seed)
{
    std::vector<double> result(n);
    for (std::size_t i = 0; i < n; ++i) result[i] = randomNormal(seed, 0, i);
    return result;
}

/// The definition itself.
std::vector<Complex> sums(const std::vector<double>& angle, const std::vector<double>& values, int limit)
{
    std::vector<Complex> result;
    for (int k = 0; k <= limit; ++k) {
        Complex sum;
        for (std::size_t j = 0; j < values.size(); ++j) sum += values[j] * std::polar(1.0, -k * angle[j]);
        result.push_back(sum);
    }
    return result;
}

class FourierOfLength : public testing::TestWithParam<std::size_t> {};

TEST_P(FourierOfLength, IsTheDefinitionAndComesBack)
{
    const std::size_t n = GetParam();
    const std::vector<double> values = noise(n, n);
    std::vector<double> angle(n);
    for (std::size_t j = 0; j < n; ++j) angle[j] = turn_rad * static_cast<double>(j) / static_cast<double>(n);
    const FourierTransform transform(n);
    const std::vector<Complex> spectrum = transform.forward(values);
    ASSERT_EQ(spectrum.size(), n / 2 + 1);
    const std::vector<Complex> expected = sums(angle, values, static_cast<int>(n / 2));
    for (std::size_t k = 0; k < spectrum.size(); ++k)
        EXPECT_LT(std::abs(spectrum[k] - expected[k]), 1e-12 * static_cast<double>(n)) << k;
    const std::vector<double> back = transform.series(spectrum);
    ASSERT_EQ(back.size(), n);
    for (std::size_t j = 0; j < n; ++j) EXPECT_NEAR(back[j] / static_cast<double>(n), values[j], 1e-13);
}

// Powers, mixed factors, odd lengths, primes below and above the direct limit (Bluestein).
INSTANTIATE_TEST_SUITE_P(AnyLength, FourierOfLength,
                         testing::Values(1, 2, 3, 5, 8, 15, 59, 61, 199, 200, 202, 257, 360, 1009));

/// Many more values than orders go another way.
TEST(NonuniformFourier, SumsAndSeriesOfManyValuesAreTheDefinition)
{
    const std::vector<double> values = noise(20000, 4);
    std::vector<double> angle(values.size());
    for (std::size_t j = 0; j < angle.size(); ++j) angle[j] = turn_rad * (3 * randomUniform(6, 0, j) - 1);
    angle[2] = 0;
    angle[3] = turn_rad;
    for (const int limit : {1, 2, 50, 190}) {
        const std::vector<Complex> found = fourierSums(angle, values, limit);
        const std::vector<Complex> expected = sums(angle, values, limit);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k)
            EXPECT_LT(std::abs(found[k] - expected[k]), 1e-12 * static_cast<double>(values.size())) << k;
        std::vector<Complex> series = expected;
        for (Complex& c : series) c /= static_cast<double>(values.size());
        const std::vector<double> many = fourierSeries(series, angle);
        const std::vector<double> few = fourierSeries(series, std::vector<double>(angle.begin(), angle.begin() + 90));
        for (std::size_t j = 0; j < few.size(); ++j) EXPECT_NEAR(many[j], few[j], 1e-12) << j;
    }
}

TEST(NonuniformFourier, SumsAreTheDefinition)
{
    const std::vector<double> values = noise(300, 3);
    std::vector<double> angle(values.size());
    for (std::size_t j = 0; j < angle.size(); ++j) angle[j] = turn_rad * (3 * randomUniform(5, 0, j) - 1);
    angle[1] = angle[0];
    angle[2] = 0;
    angle[3] = turn_rad;
    for (const int limit : {0, 1, 2, 7, 150, 400}) {
        const std::vector<Complex> found = fourierSums(angle, values, limit);
        const std::vector<Complex> expected = sums(angle, values, limit);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) EXPECT_LT(std::abs(found[k] - expected[k]), 3e-10) << k;
    }
}

TEST(NonuniformFourier, SeriesIsTheDefinition)
{
    std::vector<Complex> coefficients;
    for (std::uint64_t k = 0; k <= 120; ++k)
        coefficients.emplace_back(randomNormal(7, 0, k), k ? randomNormal(7, 1, k) : 0.0);
    std::vector<double> angle;
    for (std::uint64_t j = 0; j < 500; ++j) angle.push_back(turn_rad * (2 * randomUniform(8, 0, j) - 1));
    const std::vector<double> found = fourierSeries(coefficients, angle);
    for (std::size_t j = 0; j < angle.size(); ++j) {
        double expected = coefficients[0].real();
        for (std::size_t k = 1; k < coefficients.size(); ++k)
            expected += 2 * (coefficients[k] * std::polar(1.0, static_cast<double>(k) * angle[j])).real();
        EXPECT_NEAR(found[j], expected, 1e-10);
    }
}

}  // namespace
}  // namespace lathelier::signal
