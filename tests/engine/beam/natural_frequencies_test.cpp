// Natural frequencies against reference values, limits and properties.
#include "engine/beam/natural_frequencies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shafts.h"

namespace lathelier::beam {
namespace {

std::vector<double> frequencies(const Shaft& shaft, const BeamParameters& parameters, double most_hz = 20000)
{
    return naturalFrequencies(beamModel(shaft, {}, parameters, {}), most_hz);
}

TEST(NaturalFrequencies, RodWithCowpersCoefficient)
{
    const auto f = frequencies(rod40(), with(ShearModel::Cowper));
    ASSERT_GE(f.size(), 3U);
    EXPECT_NEAR(f[0], 2768.36, 0.005);
    EXPECT_NEAR(f[1], 6937.89, 0.005);
    EXPECT_NEAR(f[2], 12207.47, 0.005);
}

TEST(NaturalFrequencies, RodWithHutchinsonsCoefficientAgreesWithFiniteElementsInThreeDimensions)
{
    const auto f = frequencies(rod40(), with(ShearModel::Hutchinson));
    ASSERT_GE(f.size(), 3U);
    EXPECT_NEAR(f[0] / 2771.15, 1, 4e-4);
    EXPECT_NEAR(f[1] / 6960.08, 1, 4e-4);
    EXPECT_NEAR(f[2] / 12274.57, 1, 4e-4);
}

TEST(NaturalFrequencies, ShaftOfPaperB)
{
    auto parameters = with(ShearModel::Cowper);
    const auto f = frequencies(shaftOfPaperB(), parameters);
    ASSERT_GE(f.size(), 3U);
    EXPECT_NEAR(f[0], 3998.26, 0.006);
    EXPECT_NEAR(f[1], 10105.76, 0.006);
    EXPECT_NEAR(f[2], 17399.64, 0.006);
    parameters.step_correction = true;
    EXPECT_NEAR(frequencies(shaftOfPaperB(), parameters).at(0), 3969.7, 1.5);  // by how finely the cone is cut
}

TEST(NaturalFrequencies, StepCorrectionAgreesWithFiniteElementsInThreeDimensions)
{
    auto parameters = with(ShearModel::Hutchinson);
    const auto errorOf = [&](double found, double truth) { return std::abs(found / truth - 1); };
    EXPECT_LT(errorOf(frequencies(shaftOfPaperB(), parameters).at(0), 3939.4), 0.02);
    parameters.step_correction = true;
    const auto corrected = frequencies(shaftOfPaperB(), parameters);
    EXPECT_LT(errorOf(corrected.at(0), 3939.4), 0.01);
    EXPECT_LT(errorOf(corrected.at(1), 10088.6), 0.01);
    EXPECT_LT(errorOf(corrected.at(2), 17344.5), 0.01);
}

TEST(NaturalFrequencies, SlenderRodIsEulersBeam)
{
    // Rotary inertia and shear vanish with (D/L)²: extrapolated from two slender rods.
    const auto scaled = [](double slenderness) {
        const auto f = frequencies(cylinder(40 * slenderness, 40), with(ShearModel::Hutchinson), 4000);
        return f.at(0) * std::pow(slenderness / 6.25, 2);
    };
    EXPECT_NEAR(scaled(400), 2946.76, 0.2);
    EXPECT_NEAR((4 * scaled(400) - scaled(200)) / 3, 2946.76, 0.005);
}

TEST(NaturalFrequencies, FiniteElementsConvergeWithTheSquareOfTheirLength)
{
    const double exact = frequencies(rod40(), with(ShearModel::Hutchinson)).at(1);
    const auto errorOf = [&](double element_length_mm) {
        auto parameters = with(ShearModel::Hutchinson, BeamMethod::FiniteElements);
        parameters.element_length_mm = element_length_mm;
        return frequencies(rod40(), parameters).at(1) / exact - 1;
    };
    EXPECT_NEAR(errorOf(2.5) / errorOf(1.25), 4, 0.05);
    EXPECT_NEAR(errorOf(1.25) / errorOf(0.625), 4, 0.05);
    EXPECT_LT(std::abs(errorOf(2.5)), 5e-4);
}

TEST(NaturalFrequencies, CutsDoNotMatter)
{
    const auto whole = frequencies(shaftOfPaperB(), with(ShearModel::Hutchinson), 60000);
    std::vector<std::pair<double, double>> cut;
    for (const auto& [length_mm, diameter_mm] : {std::pair{98.0, 30.0}, {10.0, 37.0}, {75.0, 33.8}})
        for (int i = 0; i < 40; ++i) cut.emplace_back(length_mm / 40, diameter_mm);
    const auto parts = frequencies(stepped(cut), with(ShearModel::Hutchinson), 60000);
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(parts[i] / whole[i], 1, 1e-9);
}

TEST(NaturalFrequencies, DoubledOnesAreCountedTwice)
{
    auto parameters = with(ShearModel::Hutchinson);
    parameters.supports = {{125, rigid, rigid, 0}};
    const auto halves = frequencies(rod40(), parameters);
    parameters.supports = {{125, rigid, rigid, 0}};
    const auto half = frequencies(cylinder(125, 40), parameters);
    ASSERT_EQ(halves.size(), 2 * half.size());
    for (std::size_t i = 0; i < half.size(); ++i) {
        EXPECT_NEAR(halves[2 * i] / half[i], 1, 1e-11);
        EXPECT_NEAR(halves[2 * i + 1] / half[i], 1, 1e-11);
    }
}

TEST(NaturalFrequencies, MotionsOfARigidBodyAreLeftOut)
{
    auto parameters = with(ShearModel::Hutchinson);
    const double elastic = frequencies(rod40(), parameters).at(0);
    EXPECT_GT(elastic, 2000);
    parameters.supports = {
        {0, 1e-3, 0, 0}};  // one soft spring: one mode on it, near the free ones, and a free rotation
    const auto held = frequencies(rod40(), parameters);
    EXPECT_EQ(held.size(), frequencies(rod40(), with(ShearModel::Hutchinson)).size() + 1);
    EXPECT_LT(held.at(0), 1);
    EXPECT_NEAR(held.at(1) / elastic, 1, 1e-6);
}

TEST(NaturalFrequencies, ThickRodAboveItsCutOff)
{
    // D 300: above 6 kHz both waves travel. Cuts must not change the count.
    const auto whole = frequencies(cylinder(700, 300), with(ShearModel::Cowper), 20000);
    const auto cut =
        frequencies(stepped({{1.5, 300}, {350, 300}, {0, 300}, {348.5, 300}}), with(ShearModel::Cowper), 20000);
    ASSERT_EQ(whole.size(), cut.size());
    for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(cut[i] / whole[i], 1, 1e-9);
}

TEST(NaturalFrequencies, TaperByFiftyPiecesIsFineEnough)
{
    Shaft taper;
    taper.segments = {{120, 20, 40, 0, {}, {}}, {130, 40, 40, 0, {}, {}}};
    auto parameters = with(ShearModel::Hutchinson);
    const auto fifty = frequencies(taper, parameters);
    parameters.taper_pieces = 400;
    const auto many = frequencies(taper, parameters);
    ASSERT_EQ(fifty.size(), many.size());
    for (std::size_t i = 0; i < many.size(); ++i) EXPECT_NEAR(fifty[i] / many[i], 1, 2e-4);
}

TEST(ModeShapes, FreeRod)
{
    const std::vector<double> places{0, 125, 250};
    for (const BeamMethod method : {BeamMethod::Exact, BeamMethod::FiniteElements}) {
        const auto model = beamModel(rod40(), {}, with(ShearModel::Hutchinson, method), places);
        const auto shapes = modeShapes(model, 13000);
        ASSERT_EQ(shapes.size(), 3U);
        EXPECT_NEAR(std::abs(shapes[0].deflection[0]), 1, 1e-9);
        EXPECT_NEAR(shapes[0].deflection[0], shapes[0].deflection[2], 1e-6);
        EXPECT_NEAR(shapes[0].rotation_mm[1], 0, 1e-6);
        EXPECT_NEAR(shapes[1].deflection[0], -shapes[1].deflection[2], 1e-6);
        EXPECT_NEAR(shapes[1].deflection[1], 0, 1e-6);
        EXPECT_NEAR(shapes[0].deflection[1], -0.6, 0.02);                  // Euler: -0.608
        EXPECT_GT(shapes[0].rotation_mm[0] * shapes[0].deflection[0], 0);  // x points to the free end
    }
}

TEST(ModeShapes, DoubledOnesAreOrthogonal)
{
    auto parameters = with(ShearModel::Hutchinson);
    parameters.supports = {{125, rigid, rigid, 0}};
    const auto shapes = modeShapes(beamModel(rod40(), {}, parameters, std::vector<double>{0, 125, 250}), 5000);
    ASSERT_GE(shapes.size(), 2U);
    EXPECT_NEAR(shapes[0].deflection[0] * shapes[1].deflection[0] + shapes[0].deflection[2] * shapes[1].deflection[2],
                0, 1e-6);
    EXPECT_EQ(shapes[0].deflection[1], 0);
}

}  // namespace
}  // namespace lathelier::beam
