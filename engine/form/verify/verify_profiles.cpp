#include <numbers>

#include "engine/form/verify/form_verification.h"
#include "engine/signal/closed_profile.h"
#include "engine/signal/harmonics.h"

namespace lathelier::form {
namespace {

constexpr double profileLimit = 1e-12;

std::vector<double> wave(std::size_t count, int upr, double phase)
{
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(
            std::cos(upr * 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count) - phase));
    return values;
}

}  // namespace

VerifyKind verifyGaussianFilter()
{
    VerifyTally tally("gaussian_filter", LT_TEXT("Engine", "Transmission of the Gaussian filter"), {}, profileLimit);
    for (const double cutoff : {15.0, 50.0, 150.0, 500.0})
        for (const int upr : {1, 5, 15, 25, 50, 100, 150}) {
            const std::vector<double> passed = signal::filterClosed(wave(3600, upr, 0.4), {{}, cutoff});
            const double expected = std::exp2(-(upr / cutoff) * (upr / cutoff));
            const std::vector<double> original = wave(3600, upr, 0.4);
            tally.nextSet();
            for (std::size_t i = 0; i < passed.size(); ++i) tally.compare(passed[i], expected * original[i]);
        }
    return tally.done();
}

VerifyKind verifyHarmonics()
{
    VerifyTally tally("harmonics", LT_TEXT("Engine", "Harmonics"), {}, profileLimit);
    for (const std::size_t count : {200U, 360U, 3600U})
        for (const int upr : {1, 2, 3, 15, 50}) {
            const std::vector<signal::Harmonic> found = signal::harmonicsUniform(wave(count, upr, 0.7), 60);
            tally.nextSet();
            for (const signal::Harmonic& harmonic : found) {
                tally.compare(harmonic.amplitude, harmonic.upr == upr ? 1 : 0);
                if (harmonic.upr == upr) tally.compare(harmonic.phase_rad, 0.7);
            }
        }
    return tally.done();
}

}  // namespace lathelier::form
