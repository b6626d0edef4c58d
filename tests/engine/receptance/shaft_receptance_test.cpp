// Frequency responses of shafts on machines: the papers' numbers, statics, refusals.
#include "engine/receptance/shaft/shaft_receptance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "../core/code_of_error.h"
#include "engine/beam/beam_codes.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/receptance_quantities.h"
#include "engine/shaft/shaft_codes.h"
#include "made_spindle.h"

namespace lathelier::receptance {
namespace {

constexpr double mm_N_per_m_N = 1000;

ReceptanceParameters lines(double from_hz, double to_hz, double step_hz)
{
    ReceptanceParameters parameters;
    parameters.from_hz = from_hz;
    parameters.to_hz = to_hz;
    parameters.step_hz = step_hz;
    return parameters;
}

struct Peak {
    double at_hz;
    double size_m_N;
    double least_real_at_hz;
    double least_real_m_N;
};

Peak peakOf(const Frf& frf)
{
    const auto by_size = [](const Complex& a, const Complex& b) { return std::abs(a) < std::abs(b); };
    const auto by_real = [](const Complex& a, const Complex& b) { return a.real() < b.real(); };
    const auto largest = std::max_element(frf.value.begin(), frf.value.end(), by_size);
    const auto least = std::min_element(frf.value.begin(), frf.value.end(), by_real);
    return {frf.frequency_hz[static_cast<std::size_t>(largest - frf.value.begin())], std::abs(*largest) / mm_N_per_m_N,
            frf.frequency_hz[static_cast<std::size_t>(least - frf.value.begin())], least->real() / mm_N_per_m_N};
}

TEST(ShaftReceptance, RodOfThePapers)
{
    ReceptanceParameters parameters = lines(200, 250, 0.25);
    parameters.shear = beam::ShearModel::Cowper;
    const auto cowper = shaftReceptance(cylinder(250, 40), parameters, springs());
    const Peak c = peakOf(cowper.frf);
    EXPECT_EQ(c.at_hz, 223.0);
    EXPECT_NEAR(c.size_m_N, 1.1663e-5, 1e-9);
    EXPECT_EQ(c.least_real_at_hz, 228.25);
    EXPECT_NEAR(c.least_real_m_N, -5.7532e-6, 1e-10);
    parameters.shear = beam::ShearModel::Hutchinson;
    parameters.step_hz = 0.05;
    const Peak h = peakOf(shaftReceptance(cylinder(250, 40), parameters, springs()).frf);
    EXPECT_NEAR(h.at_hz, 223.1, 0.06);
    EXPECT_NEAR(h.size_m_N, 1.1659e-5, 1e-9);
    ASSERT_TRUE(cowper.natural_frequencies_hz);
    ASSERT_EQ(cowper.natural_frequencies_hz->size(), 1U);
    EXPECT_NEAR(cowper.natural_frequencies_hz->front(), 222.8, 0.5);
}

TEST(ShaftReceptance, CouplingByReceptancesIsTheSame)
{
    const ReceptanceParameters parameters = lines(100, 3000, 100);
    const SpindleReceptance spindle{livelySpindle(100, 3000, 50)};
    const auto result = shaftReceptance(newPart(), parameters, spindle);
    const auto g = beam::beamReceptances(newPart(), {}, {}, std::vector<double>{0, 200}, result.frf.frequency_hz);
    for (std::size_t i = 0; i < result.frf.value.size(); ++i) {
        const Complex by_coupling =
            coupled({g[4 * i], g[4 * i + 1], g[4 * i + 3], g[4 * i + 2]}, spindle.at(result.frf.frequency_hz[i]))(0, 0);
        EXPECT_LT(std::abs(result.frf.value[i] / by_coupling - 1.0), 1e-9);
    }
    EXPECT_FALSE(result.natural_frequencies_hz);
    EXPECT_TRUE(contains(result.notes, notes::spindleHasNoModes));
}

TEST(ShaftReceptance, AtZeroHertz)
{
    const ReceptanceParameters parameters = lines(0, 1, 1);
    const auto open = shaftReceptance(cylinder(250, 40), parameters);
    EXPECT_TRUE(std::isnan(open.frf.value[0].real()));
    EXPECT_FALSE(std::isnan(open.frf.value[1].real()));
    const Json json = nestedJson(describedValues(open));
    EXPECT_TRUE(json["receptance"]["real_mm_N"][0].is_null());
    const Complex held = shaftReceptance(cylinder(250, 40), parameters, springs()).frf.value[0];
    Material steel;
    const double E = steel.elastic_modulus_MPa, I = std::numbers::pi * std::pow(40, 4) / 64;
    const double kappa = beam::shearCoefficient(beam::ShearModel::Hutchinson, 0, 0.3);
    const double bending = std::pow(250, 3) / (3 * E * I) + 250 / (kappa * E / 2.6 * std::numbers::pi * 400);
    const Complex expected = bending / Complex(1, 0.002) + (1.0 / 15000 + 250.0 * 250 / 1.974e8) / Complex(1, 0.06);
    EXPECT_LT(std::abs(held / expected - 1.0), 1e-11);
    // A spindle that only deflects has no inverse.
    SpindleTable table;
    table.frequency_hz = {0, 10};
    table.H_mm_N = {1e-4, 1e-4};
    table.L_mm_Nmm = {0, 0};
    table.P_rad_Nmm = {0, 0};
    const Complex partly = shaftReceptance(cylinder(250, 40), lines(5, 10, 5), SpindleReceptance{table}).frf.value[0];
    EXPECT_NEAR(partly.real(), bending + 1e-4, 1e-5 * partly.real() + 2e-7);
}

TEST(ShaftReceptance, SaysWhatWasAssumed)
{
    Shaft shaft = cylinder(250, 40);
    EXPECT_TRUE(shaftReceptance(shaft, lines(100, 200, 100)).notes.empty());
    shaft.material.reset();
    const auto result = shaftReceptance(shaft, lines(100, 200, 100));
    EXPECT_TRUE(contains(result.notes, notes::materialAssumed));
    ASSERT_FALSE(result.used.empty());
    EXPECT_EQ(result.used.front().origin, ValueOrigin::Assumed);
}

TEST(ShaftReceptance, Refusals)
{
    ReceptanceParameters parameters = lines(100, 200, 100);
    parameters.excite_z_mm = 251;
    const auto run = [&] { shaftReceptance(cylinder(250, 40), parameters); };
    EXPECT_EQ(codeOfError(run), errors::placeOutsideShaft);
    EXPECT_EQ(errors::placeOutsideShaft.kind, ErrorKind::WrongUsage);
    parameters = lines(200, 100, 1);
    EXPECT_EQ(codeOfError(run), errors::valueNotUnderstood);
    const SpindleReceptance narrow{livelySpindle(100, 200, 10)};
    EXPECT_EQ(codeOfError([&] { shaftReceptance(cylinder(250, 40), lines(100, 201, 1), narrow); }),
              errors::frequencyOutsideSpindle);
    Shaft bad = cylinder(250, 40);
    bad.segments[0].bore_diameter_mm = 40;
    EXPECT_EQ(codeOfError([&] { shaftReceptance(bad); }), errors::shaftSegmentUnusable);
    EXPECT_EQ(codeOfError([&] { shaftReceptance(Shaft{}); }), errors::shaftEmpty);
}

TEST(ShaftReceptance, LinesEndWhereAStepDoes)
{
    EXPECT_EQ(linesOf(lines(50, 5000, 1)).size(), 4951U);
    EXPECT_EQ(linesOf(lines(0, 1, 0.1)).size(), 11U);
    EXPECT_EQ(linesOf(lines(0, 1, 0.3)).back(), 0.3 * 3);
    EXPECT_EQ(linesOf(lines(7, 7, 1)), std::vector<double>{7});
}

}  // namespace
}  // namespace lathelier::receptance
