// Several responses of one structure fitted with common poles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/random.h"
#include "engine/receptance/modal/modal_codes.h"
#include "engine/receptance/modal/modal_fit.h"
#include "engine/receptance/modal/uncertain_model.h"

namespace lathelier::receptance {
namespace {

using testing::SizeIs;

/// A beam with two modes tapped at the tip and at three places along it: shapes 1, .7, -.2, -.6 and 1, -.4, -.8, .5.
constexpr double barShapes[2][4] = {{1, .7, -.2, -.6}, {1, -.4, -.8, .5}};
constexpr double barFrequencies_hz[2] = {240, 610}, barDampings[2] = {.02, .015}, barStiffnesses_N_mm[2] = {1e4, 4e4};

ModalModel barResponse(int place)
{
    ModalModel model;
    for (int k = 0; k < 2; ++k)
        model.modes.push_back({barFrequencies_hz[k], barDampings[k], barStiffnesses_N_mm[k] / barShapes[k][place]});
    model.residuals.upper_mm_N = 1e-6 * place;
    return model;
}

Frf tapped(int place, std::uint64_t seed, double noise)
{
    std::vector<double> lines;
    for (int f = 50; f <= 1000; ++f) lines.push_back(f);
    Frf frf = synthesised(barResponse(place), lines);
    const double sigma = noise * 2e-3;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto stream = static_cast<std::uint64_t>(2 * place);
        frf.value[i] += std::complex(sigma * randomNormal(seed, stream, i), sigma * randomNormal(seed, stream + 1, i));
        frf.noise.push_back(sigma);
    }
    return frf;
}

std::vector<ModalFit> fitTogether(std::uint64_t seed, double noise, const ModalParameters& parameters = {})
{
    std::vector<Frf> responses;
    for (int place = 0; place < 4; ++place) responses.push_back(tapped(place, seed, noise));
    std::vector<ResponseToFit> asked;
    for (const Frf& frf : responses) asked.push_back({&frf, &frf == responses.data()});
    return fitResponses(asked, parameters);
}

}  // namespace

TEST(CommonFit, PolesAreCommonAndStiffnessesTheShapes)
{
    const std::vector<ModalFit> fits = fitTogether(1, .01);
    ASSERT_THAT(fits, SizeIs(4));
    for (int place = 0; place < 4; ++place) {
        const ModalFit& fit = fits[static_cast<std::size_t>(place)];
        ASSERT_THAT(fit.modes, SizeIs(2)) << place;
        for (std::size_t k = 0; k < 2; ++k) {
            const FittedMode& one = fit.modes[k];
            EXPECT_EQ(one.mode.frequency_hz, fits[0].modes[k].mode.frequency_hz);
            EXPECT_EQ(one.mode.damping_ratio, fits[0].modes[k].mode.damping_ratio);
            EXPECT_NEAR(one.mode.frequency_hz, barFrequencies_hz[k], 4 * one.frequency_uncertainty_hz);
            const double truth = barStiffnesses_N_mm[k] / barShapes[k][place];
            EXPECT_NEAR(one.mode.stiffness_N_mm, truth, 4 * one.stiffness_uncertainty_N_mm) << place << " " << k;
            EXPECT_EQ(std::signbit(one.mode.stiffness_N_mm), std::signbit(truth));
        }
    }
}

TEST(CommonFit, OneResponseIsThatResponse)
{
    const Frf frf = tapped(0, 3, .01);
    const ResponseToFit one{&frf};
    EXPECT_EQ(fitResponses({&one, 1}).front().model, fitModes(frf).model);
}

TEST(CommonFit, IsSurerThanOneAndItsUncertaintiesCover)
{
    ModalParameters two;
    two.modes = 2;
    constexpr std::uint64_t seeds = 100;
    int inside[3] = {0, 0, 0};
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const std::vector<ModalFit> fits = fitTogether(seed, .02, two);
        ASSERT_THAT(fits[2].modes, SizeIs(2));
        const FittedMode& one = fits[2].modes[0];  // where this mode hardly moves
        EXPECT_LT(one.frequency_uncertainty_hz,
                  fitModes(tapped(2, seed, .02), two).modes.front().frequency_uncertainty_hz);
        constexpr double k95 = 1.96;
        inside[0] += std::abs(one.mode.frequency_hz - 240) <= k95 * one.frequency_uncertainty_hz;
        inside[1] += std::abs(one.mode.damping_ratio - .02) <= k95 * one.damping_uncertainty;
        inside[2] += std::abs(one.mode.stiffness_N_mm + 5e4) <= k95 * one.stiffness_uncertainty_N_mm;
    }
    for (const int count : inside) EXPECT_GE(count, 87);  // 95 less 3.5 standard deviations of the count
}

TEST(CommonFit, DampingTimesStiffnessIsSurerThanEither)
{
    // The height of a peak, 1/(2 k ζ), is measured; errors of k and ζ are opposite.
    ModalParameters one;
    one.modes = 1;
    double product = 0, predicted = 0, independent = 0;
    constexpr std::uint64_t seeds = 150;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        std::vector<double> lines;
        for (int f = 100; f <= 400; ++f) lines.push_back(f);
        Frf frf = synthesised({{{240, .02, 1e4}}, {}, {}}, lines);
        const double sigma = 3e-5;
        for (std::size_t i = 0; i < lines.size(); ++i)
            frf.value[i] += std::complex(sigma * randomNormal(seed, 0, i), sigma * randomNormal(seed, 1, i));
        frf.noise.assign(lines.size(), sigma);
        const FittedMode found = fitModes(frf, one).modes.front();
        const double z = found.damping_uncertainty / .02, k = found.stiffness_uncertainty_N_mm / 1e4;
        product += std::pow(found.mode.damping_ratio * found.mode.stiffness_N_mm / 200 - 1, 2);
        predicted += z * z + k * k + 2 * found.damping_stiffness_correlation * z * k;
        independent += z * z + k * k;
    }
    EXPECT_NEAR(std::sqrt(product / predicted), 1, .2);
    EXPECT_LT(predicted, .7 * independent);
}

/// Where damping couples the modes, as two loss factors do, real modes would need a further one that is not there.
TEST(ComplexFit, IsTakenWhereRealModesLeaveMuch)
{
    ModalModel model;
    model.modes = {{360, .024, 2500, 4}, {1070, .02, 22000, -9}};
    std::vector<double> lines;
    for (double f = 50; f <= 1500; f += 1) lines.push_back(f);
    const ModalFit fit = fitModes(synthesised(model, lines));
    ASSERT_THAT(fit.modes, SizeIs(2));
    EXPECT_TRUE(fit.parameters.complex_residues);
    EXPECT_LT(fit.error_rms_percent, 0.1);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(fit.modes[k].mode.frequency_hz, model.modes[k].frequency_hz, 0.1);
        EXPECT_NEAR(fit.modes[k].mode.damping_ratio, model.modes[k].damping_ratio, 1e-4);
        EXPECT_NEAR(fit.modes[k].mode.phase_deg, model.modes[k].phase_deg, 0.2);
    }
    EXPECT_TRUE(contains(fit.notes, notes::complexModes));
    ModalModel real = model;
    for (ModalMode& mode : real.modes) mode.phase_deg = 0;
    const ModalFit of_real = fitModes(synthesised(real, lines));
    EXPECT_FALSE(of_real.parameters.complex_residues);
    EXPECT_FALSE(contains(of_real.notes, notes::complexModes));
}

TEST(CommonFit, AnItemKeepsModesWithTheirUncertainties)
{
    const UncertainModel model = uncertainModelOf(fitModes(tapped(0, 1, .01)));
    ASSERT_THAT(model.own, SizeIs(model.model.modes.size()));
    EXPECT_NE(model.own.front().correlation, 0);
    Values values{{"name", "tip"}};
    addModel(model, values);
    EXPECT_EQ(modelIn(values), model);
    EXPECT_FALSE(modelIn({{"name", "tip"}}));
    set(values, "model_modes", Rows{{{{{"frequency_hz", -1.0}}}}});
    EXPECT_FALSE(modelIn(values));
}

}  // namespace lathelier::receptance
