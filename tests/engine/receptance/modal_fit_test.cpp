// Modes found in responses whose modes are known.
#include "engine/receptance/modal/modal_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/receptance/modal/modal_codes.h"
#include "engine/receptance/modal/response_study.h"

namespace lathelier::receptance {
namespace {

using testing::SizeIs;

struct Measurement {
    double from_hz = 50, to_hz = 1000, step_hz = 1;
    double noise = 0;  ///< rms of the complex error over |G|
    std::uint64_t seed = 1;
};

Frf noisyFrf(const ModalModel& truth, const Measurement& how)
{
    std::vector<double> lines;
    for (int i = 0; how.from_hz + i * how.step_hz <= how.to_hz; ++i) lines.push_back(how.from_hz + i * how.step_hz);
    Frf frf = synthesised(truth, lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double sigma = how.noise * std::abs(frf.value[i]) * std::sqrt(0.5);
        frf.value[i] +=
            std::complex<double>(sigma * randomNormal(how.seed, 0, i), sigma * randomNormal(how.seed, 1, i));
    }
    return frf;
}

ModalModel of(std::vector<ModalMode> modes)
{
    return {std::move(modes), {}, {}};
}

const ModalModel& sixModes()
{
    static const ModalModel model{
        {{120, .02, 2e4}, {260, .015, 3e4}, {410, .03, 1e4}, {640, .01, 8e4}, {900, .02, 5e4}, {1200, .012, 9e4}},
        {},
        {300, 2e-6}};
    return model;
}

/// Largest relative distance of frequency, damping and stiffness.
double distance(const ModalMode& a, const ModalMode& b)
{
    return std::max({std::abs(a.frequency_hz / b.frequency_hz - 1), std::abs(a.damping_ratio / b.damping_ratio - 1),
                     std::abs(a.stiffness_N_mm / b.stiffness_N_mm - 1)});
}

void expectExact(const ModalModel& truth, const Measurement& how, const ModalParameters& parameters = {})
{
    const ModalFit fit = fitModes(noisyFrf(truth, how), parameters);
    ASSERT_THAT(fit.modes, SizeIs(truth.modes.size()));
    for (std::size_t k = 0; k < truth.modes.size(); ++k) {
        EXPECT_LT(distance(fit.model.modes[k], truth.modes[k]), 1e-8) << k;
        EXPECT_NEAR(fit.model.modes[k].phase_deg, truth.modes[k].phase_deg, 1e-6);
    }
    EXPECT_LT(fit.error_rms_percent, 1e-7);
}

}  // namespace

TEST(ModalFit, RecoversWhatHasNoNoise)
{
    expectExact(of({{223, .03, 1e4}}), {});
    expectExact(of({{400, .02, 2e4}, {420, .02, 3e4}}), {200, 700, .5});
    expectExact(of({{223, .03, 1e4}, {600, .02, -2e4}}), {});
    expectExact({{{223, .03, 1e4}}, {}, {2000, 5e-6}}, {});
    expectExact(sixModes(), {40, 1500, 1});
}

TEST(ModalFit, RecoversComplexResidues)
{
    ModalParameters parameters;
    parameters.complex_residues = true;
    expectExact(of({{223, .03, 1e4, 20}, {600, .02, -2e4, -35}}), {}, parameters);
}

TEST(ModalFit, NoiseOfOnePercentMovesLittle)
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const ModalFit fit = fitModes(noisyFrf(sixModes(), {40, 1500, 1, .01, seed}));
        ASSERT_THAT(fit.modes, SizeIs(6)) << seed;
        for (std::size_t k = 0; k < 6; ++k) {
            const ModalMode &found = fit.model.modes[k], &truth = sixModes().modes[k];
            EXPECT_NEAR(found.frequency_hz / truth.frequency_hz, 1, 2e-4) << seed << " " << k;
            EXPECT_NEAR(found.damping_ratio / truth.damping_ratio, 1, .02) << seed << " " << k;
            EXPECT_NEAR(found.stiffness_N_mm / truth.stiffness_N_mm, 1, .02) << seed << " " << k;
        }
    }
}

TEST(ModalFit, TwoModesFivePercentApartAreTold)
{
    const ModalModel truth = of({{400, .02, 2e4}, {420, .02, 3e4}});
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const ModalFit fit = fitModes(noisyFrf(truth, {200, 700, .5, .01, seed}));
        ASSERT_THAT(fit.modes, SizeIs(2)) << seed;
        for (std::size_t k = 0; k < 2; ++k) EXPECT_LT(distance(fit.model.modes[k], truth.modes[k]), .02) << seed;
    }
}

TEST(ModalFit, UncertaintiesCoverTheTruth)
{
    constexpr std::uint64_t seeds = 200;
    const ModalModel truth = of({{223, .03, 1e4}});
    ModalParameters parameters;
    parameters.modes = 1;
    int inside[3] = {0, 0, 0};
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const ModalFit fit = fitModes(noisyFrf(truth, {120, 420, 1, .01, seed}), parameters);
        ASSERT_THAT(fit.modes, SizeIs(1));
        const FittedMode& found = fit.modes.front();
        constexpr double k95 = 1.96;
        inside[0] += std::abs(found.mode.frequency_hz - 223) <= k95 * found.frequency_uncertainty_hz;
        inside[1] += std::abs(found.mode.damping_ratio - .03) <= k95 * found.damping_uncertainty;
        inside[2] += std::abs(found.mode.stiffness_N_mm - 1e4) <= k95 * found.stiffness_uncertainty_N_mm;
    }
    for (const int count : inside) {  // 190 ± 3 standard deviations of the count
        EXPECT_GE(count, 181);
        EXPECT_LE(count, 199);
    }
}

TEST(ModalFit, CoherenceWeighsLines)
{
    // A stretch of lines is ruined, and its coherence says so.
    const ModalModel truth = of({{223, .03, 1e4}});
    Frf frf = noisyFrf(truth, {50, 1000, 1, .005});
    frf.coherence.assign(frf.value.size(), 0.999);
    for (std::size_t i = 0; i < frf.value.size(); ++i)
        if (frf.frequency_hz[i] > 215 && frf.frequency_hz[i] < 222) {
            frf.value[i] *= 1.6;
            frf.coherence[i] = 0.01;
        }
    const ModalFit weighted = fitModes(frf);
    ASSERT_THAT(weighted.modes, SizeIs(1));
    EXPECT_LT(distance(weighted.model.modes[0], truth.modes[0]), .01);
}

TEST(ModalFit, WhatLiesOutsideTheRangeIsNoMode)
{
    const ModalModel truth = of({{100, .02, 2e4}, {500, .02, 1e4}, {2000, .02, 2e4}});
    for (const double noise : {0., .01}) {
        const ModalFit fit = fitModes(noisyFrf(truth, {300, 1000, 1, noise}));
        ASSERT_THAT(fit.modes, SizeIs(1));
        EXPECT_LT(distance(fit.model.modes[0], truth.modes[1]), noise > 0 ? .01 : 1e-8);
    }
    ModalParameters parameters;
    parameters.range_hz = {{300, 1000}};
    EXPECT_THAT(fitModes(noisyFrf(truth, {40, 3000, 1, .01}), parameters).modes, SizeIs(1));
}

TEST(ModalFit, NoiseMakesNoModes)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        EXPECT_THAT(fitModes(noisyFrf(of({{223, .03, 1e4}}), {50, 1000, 1, .03, seed})).modes, SizeIs(1)) << seed;
        const ModalFit none = fitModes(noisyFrf({{}, {}, {0, 1e-4}}, {50, 1000, 1, .01, seed}));
        EXPECT_THAT(none.modes, SizeIs(0)) << seed;
        EXPECT_TRUE(contains(none.notes, notes::noModes));
    }
}

TEST(ModalFit, MoreModesThanThereAreAreNotMadeUp)
{
    ModalParameters parameters;
    parameters.modes = 5;
    const ModalFit fit = fitModes(noisyFrf(of({{223, .03, 1e4}}), {50, 1000, 1, .01}), parameters);
    EXPECT_LE(fit.modes.size(), std::size_t{2});
    EXPECT_TRUE(contains(fit.notes, notes::fewerModes));
    parameters.modes = 1;
    EXPECT_THAT(fitModes(noisyFrf(sixModes(), {40, 1500, 1, .01}), parameters).modes, SizeIs(1));
}

TEST(ModalFit, SaysWhatItRemarks)
{
    const ModalFit coarse = fitModes(noisyFrf(of({{223, .01, 1e4}}), {50, 1000, 4, .001}));
    EXPECT_TRUE(contains(coarse.notes, notes::modeNotResolved));
    const ModalFit cross = fitModes(noisyFrf(of({{223, .03, 1e4}, {600, .02, -2e4}}), {}));
    EXPECT_TRUE(contains(cross.notes, notes::modeOutOfPhase));
    EXPECT_THROW(fitModes(noisyFrf(of({{223, .03, 1e4}}), {50, 55, 1})), Error);
    Frf mobility = noisyFrf(of({{223, .03, 1e4}}), {});
    mobility.quantity = FrfQuantity::Mobility;
    EXPECT_THROW(fitModes(mobility), Error);
}

TEST(ModalFit, ScalesWithItsUnits)
{
    const Frf frf = noisyFrf(of({{223, .03, 1e4}, {600, .02, 2e4}}), {50, 1000, 1, .01});
    Frf scaled = frf;
    for (double& f : scaled.frequency_hz) f *= 3;
    for (auto& value : scaled.value) value *= 0.5;
    const ModalFit one = fitModes(frf), other = fitModes(scaled);
    ASSERT_EQ(one.modes.size(), other.modes.size());
    for (std::size_t k = 0; k < one.modes.size(); ++k) {
        EXPECT_NEAR(other.modes[k].mode.frequency_hz / one.modes[k].mode.frequency_hz, 3, 1e-6);
        EXPECT_NEAR(other.modes[k].mode.damping_ratio / one.modes[k].mode.damping_ratio, 1, 1e-6);
        EXPECT_NEAR(other.modes[k].mode.stiffness_N_mm / one.modes[k].mode.stiffness_N_mm, 2, 1e-5);
        EXPECT_NEAR(other.modes[k].flexibility_mm_N / one.modes[k].flexibility_mm_N, .5, 1e-6);
    }
}

TEST(ModalFit, IsTheSameWithAnyNumberOfThreads)
{
    const Frf frf = noisyFrf(sixModes(), {40, 1500, 1, .01});
    const ModalFit all = fitModes(frf);
    const ThreadLimit limit(1);
    EXPECT_EQ(fitModes(frf).model, all.model);
}

TEST(ModalFit, StopsWhenAskedTo)
{
    std::stop_source stop;
    double last = 0;
    const Progress progress(stop.get_token(), [&](double fraction, Text) {
        EXPECT_GE(fraction, last);
        last = fraction;
        if (fraction > .3) stop.request_stop();
    });
    EXPECT_THROW(fitModes(noisyFrf(sixModes(), {40, 1500, 1, .01}), {}, progress), Cancelled);
    EXPECT_LT(last, .5);
}

TEST(ModalFit, ADraggedPeakStandsWhereItWasDropped)
{
    const ModalModel model{{{400, .02, 2e4}, {420, .02, 3e4, 10}}, {}, {300, 2e-6}};
    for (const std::size_t index : {0U, 1U}) {
        const double f = model.modes[index].frequency_hz;
        EXPECT_NEAR(draggedMode(model, index, f, std::abs(receptanceOf(model, f))).damping_ratio, .02, 1e-12);
        ModalModel dragged = model;
        dragged.modes[index] = draggedMode(model, index, 410, 5e-3);
        EXPECT_NEAR(std::abs(receptanceOf(dragged, 410)), 5e-3, 1e-12);
        EXPECT_EQ(dragged.modes[index].stiffness_N_mm, model.modes[index].stiffness_N_mm);
        EXPECT_GT(draggedMode(model, index, 410, 1e-9).damping_ratio, .1);  // lower than the others alone
    }
}

TEST(ModalFit, ModesChangedByHandKeepTheRest)
{
    const auto measuredFrf = std::make_shared<const Frf>(noisyFrf(sixModes(), {40, 1500, 1, .01}));
    const auto fit = std::make_shared<const ModalFit>(fitModes(*measuredFrf));
    const ResponseStudy plain = studyResponse(measuredFrf, nullptr, fit);
    EXPECT_NEAR(plain.error_rms_percent, fit->error_rms_percent, 1e-12);
    EXPECT_FALSE(plain.is_changed);
    std::vector<ModalMode> changed = fit->model.modes;
    changed[2].damping_ratio *= 2;
    const ResponseStudy study = studyResponse(measuredFrf, nullptr, fit, changed);
    EXPECT_TRUE(study.is_changed);
    EXPECT_EQ(study.model.residuals, fit->model.residuals);
    EXPECT_GT(study.error_rms_percent, 5 * plain.error_rms_percent);
    EXPECT_EQ(byFlexibility(plain.model.modes).front(), 2U);
}

TEST(ModalFit, FlexibilityIsTheLeastRealPart)
{
    EXPECT_NEAR(flexibilityOf({223, .03, 1e4}), 1 / (4 * 1e4 * .03 * 1.03), 1e-15);
    double least = 0;
    for (double f = 100; f < 400; f += .001) least = std::min(least, receptanceOf(ModalMode{223, .03, -1e4}, f).real());
    EXPECT_NEAR(flexibilityOf({223, .03, -1e4}), -least, 1e-8 * -least);
}

}  // namespace lathelier::receptance
