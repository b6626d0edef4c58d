// Inverse coupling on made measurements: three rods on a known spindle, with noise.
#include <gtest/gtest.h>

#include <cmath>

#include "../core/code_of_error.h"
#include "engine/core/random.h"
#include "engine/receptance/eirc/identify_spindle.h"
#include "engine/receptance/eirc/spindle_check.h"
#include "engine/receptance/eirc/spindle_line.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/spindle/spindle_plots.h"
#include "made_spindle.h"

namespace lathelier::receptance {
namespace {

constexpr double firstLine_hz = 50, lastLine_hz = 1500, lineStep_hz = 5;

SpindleReceptance truth()
{
    return {livelySpindle(firstLine_hz, lastLine_hz, lineStep_hz)};
}

/// All pairs a ≤ b of the points, as receptances with complex noise of `noise` times |G|.
SpindleMeasurements measuredRods(const std::vector<std::pair<double, std::vector<double>>>& rods, double noise,
                                 bool with_coherence = false)
{
    SpindleMeasurements result;
    std::uint64_t stream = 0;
    for (const auto& [length_mm, distances_mm] : rods) {
        result.rods.push_back({cylinder(length_mm, 40), distances_mm});
        for (std::size_t a = 0; a < distances_mm.size(); ++a)
            for (std::size_t b = a; b < distances_mm.size(); ++b) {
                ReceptanceParameters parameters;
                parameters.respond_z_mm = length_mm - distances_mm[a];
                parameters.excite_z_mm = length_mm - distances_mm[b];
                parameters.from_hz = firstLine_hz;
                parameters.to_hz = lastLine_hz;
                parameters.step_hz = lineStep_hz;
                Frf frf = shaftReceptance(cylinder(length_mm, 40), parameters, truth()).frf;
                ++stream;
                for (std::size_t i = 0; i < frf.value.size(); ++i) {
                    const Complex deviate(randomNormal(11, stream, 2 * i), randomNormal(11, stream, 2 * i + 1));
                    frf.value[i] *= 1.0 + noise / std::sqrt(2.0) * deviate;
                    if (with_coherence) frf.coherence.push_back(1 / (1 + noise * noise));
                }
                result.frfs.push_back({result.rods.size() - 1, a, b, std::move(frf)});
            }
    }
    return result;
}

const std::vector<std::pair<double, std::vector<double>>> threeRods{
    {150, {50, 100, 150}}, {200, {60, 130, 200}}, {260, {80, 170, 260}}};

/// 100·rms of the relative difference between the new part's response on the found and on the true spindle.
double newPartRmsPercent(const SpindleReceptance& found)
{
    ReceptanceParameters parameters;
    parameters.from_hz = firstLine_hz;
    parameters.to_hz = lastLine_hz;
    parameters.step_hz = lineStep_hz;
    const Frf expected = shaftReceptance(newPart(), parameters, truth()).frf;
    const Frf got = shaftReceptance(newPart(), parameters, found).frf;
    double sum = 0;
    for (std::size_t i = 0; i < got.value.size(); ++i) sum += std::norm(got.value[i] / expected.value[i] - 1.0);
    return 100 * std::sqrt(sum / static_cast<double>(got.value.size()));
}

TEST(SpindleLine, ScaledUnknownsAreTheMatrix)
{
    const ReceptanceMatrix g = truth().at(600);
    EXPECT_LT((matrixOf(scaledOf(g)) - g).norm(), 1e-18);
}

TEST(IdentifySpindle, WithoutNoiseFindsTheSpindle)
{
    const auto result = identifySpindle(measuredRods({threeRods[0], threeRods[2]}, 0));
    EXPECT_LT(result.residual_rms_percent, 1e-6);
    EXPECT_LT(newPartRmsPercent(result.spindle), 1e-5);
    const auto& table = std::get<SpindleTable>(result.spindle.source);
    const SpindleReceptance known = truth();
    for (std::size_t i = 0; i < table.frequency_hz.size(); ++i) {
        const ReceptanceMatrix g = known.at(table.frequency_hz[i]);
        EXPECT_LT(std::abs(table.H_mm_N[i] / g(0, 0) - 1.0), 1e-6);
        EXPECT_LT(std::abs(table.L_mm_Nmm[i] / g(0, 1) - 1.0), 1e-5);  // with its sign
        EXPECT_LT(std::abs(table.P_rad_Nmm[i] / g(1, 1) - 1.0), 1e-6);
    }
}

TEST(IdentifySpindle, OnePercentOfNoiseAndThreeRods)
{
    auto measurements = measuredRods(threeRods, 0.01);
    const auto plain = identifySpindle(measurements);
    EXPECT_LT(newPartRmsPercent(plain.spindle), 2);
    EXPECT_NEAR(plain.residual_rms_percent, 1, 0.3);
    IdentificationParameters parameters;
    parameters.smooth = true;
    const auto smooth = identifySpindle(measurements, parameters);
    EXPECT_LT(newPartRmsPercent(smooth.spindle), 0.9 * newPartRmsPercent(plain.spindle));
    EXPECT_EQ(plain.condition.size(), plain.frequency_hz.size());
    EXPECT_EQ(plain.frfs, 18U);
    EXPECT_FALSE(plain.hold_out_rms_percent);
}

TEST(IdentifySpindle, PredictsARodHeldOut)
{
    const auto measurements = measuredRods(threeRods, 0.01, true);
    IdentificationParameters parameters;
    parameters.hold_out = 2;
    const auto result = identifySpindle(measurements, parameters);
    ASSERT_TRUE(result.hold_out_rms_percent);
    EXPECT_EQ(result.frfs, 12U);
    EXPECT_LT(*result.hold_out_rms_percent, 3);
    parameters.hold_out = 4;
    EXPECT_EQ(codeOfError([&] { identifySpindle(measurements, parameters); }), errors::holdOutUnknown);
}

TEST(IdentifySpindle, AccelerancesAreTheSame)
{
    auto measurements = measuredRods({threeRods[0], threeRods[2]}, 0);
    for (RodFrf& one : measurements.frfs) {
        one.frf.quantity = FrfQuantity::Accelerance;
        for (std::size_t i = 0; i < one.frf.value.size(); ++i)
            one.frf.value[i] *= -std::pow(2 * std::numbers::pi * one.frf.frequency_hz[i], 2);
    }
    EXPECT_LT(newPartRmsPercent(identifySpindle(measurements).spindle), 1e-4);
}

TEST(IdentifySpindle, Refusals)
{
    EXPECT_EQ(codeOfError([] { identifySpindle({}); }), errors::tooFewMeasuredPoints);
    EXPECT_EQ(codeOfError([] { identifySpindle(measuredRods({{150, {50}}}, 0)); }), errors::tooFewMeasuredPoints);
    auto beyond = measuredRods({threeRods[0]}, 0);
    beyond.rods[0].distance_from_chuck_mm[1] = 151;
    EXPECT_EQ(codeOfError([&] { identifySpindle(beyond); }), errors::measuredPointBeyondRod);
    auto uneven = measuredRods({threeRods[0]}, 0);
    uneven.frfs[1].frf.frequency_hz[3] += 0.1;
    EXPECT_EQ(codeOfError([&] { identifySpindle(uneven); }), errors::frfLinesDiffer);
    auto unknown = measuredRods({threeRods[0]}, 0);
    unknown.frfs[1].point_a = 9;
    EXPECT_EQ(codeOfError([&] { identifySpindle(unknown); }), errors::measuredPairUnknown);
}

TEST(SpindleCheck, SaysWhatEachLineAndResponseLeave)
{
    const SpindleMeasurements measurements = measuredRods(threeRods, 0.01);
    IdentificationParameters parameters;
    parameters.hold_out = 2;
    const auto found = identifySpindle(measurements, parameters);
    const SpindleCheck check = checkSpindle(measurements, found);
    ASSERT_EQ(check.responses.size(), measurements.frfs.size());
    ASSERT_EQ(check.residual_percent.size(), found.frequency_hz.size());
    // The parts make the whole, of the rods used and of the one held out.
    double used = 0, held = 0, lines = 0;
    for (const CheckedResponse& response : check.responses) {
        EXPECT_EQ(response.used, response.rod != 1);
        (response.used ? used : held) += response.rms_percent * response.rms_percent;
        EXPECT_EQ(response.predicted.value.size(), found.frequency_hz.size());
    }
    EXPECT_NEAR(std::sqrt(used / 12), found.residual_rms_percent, 1e-9);
    EXPECT_NEAR(std::sqrt(held / 6), *found.hold_out_rms_percent, 1e-9);
    for (const double residual : check.residual_percent) lines += residual * residual;
    EXPECT_NEAR(std::sqrt(lines / static_cast<double>(check.residual_percent.size())), found.residual_rms_percent,
                1e-9);
    EXPECT_EQ(heldOutPlot(check).curves.size(), 12U);
    EXPECT_EQ(responsesTable(check).rows.size(), 18U);
    EXPECT_EQ(spindleMagnitudePlot(found.spindle).curves.size(), 3U);
    EXPECT_EQ(spindlePhasePlot(springs()).curves.size(), 2U);  // springs have no cross receptance
}

}  // namespace
}  // namespace lathelier::receptance
