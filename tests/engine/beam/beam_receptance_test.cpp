// Receptances of beams: reference values, statics, limits and properties.
#include "engine/beam/beam_receptance.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "shafts.h"

namespace lathelier::beam {
namespace {

constexpr double mm_N_per_m_N = 1000;

/// Between two places at one frequency.
ReceptanceMatrix receptance(const Shaft& shaft, const Material& material, const BeamParameters& parameters,
                            double respond_z_mm, double excite_z_mm, double frequency_hz)
{
    const std::vector<double> places{respond_z_mm, excite_z_mm};
    return beamReceptances(shaft, material, parameters, places, std::vector<double>{frequency_hz})[1];
}

double relative(const ReceptanceMatrix& a, const ReceptanceMatrix& b)
{
    return ((a - b).cwiseAbs().array() / b.cwiseAbs().array()).maxCoeff();
}

TEST(BeamReceptance, SpotValues)
{
    const auto real = [](const Shaft& shaft, double respond_z_mm, double excite_z_mm) {
        return receptance(shaft, {}, with(ShearModel::Cowper), respond_z_mm, excite_z_mm, 1000)(0, 0).real() /
               mm_N_per_m_N;
    };
    EXPECT_NEAR(real(rod40(), 0, 0), -3.377508e-8, 1e-14);
    EXPECT_NEAR(real(shaftOfPaperB(), 0, 0), -8.721604e-8, 1e-14);
    EXPECT_NEAR(real(shaftOfPaperB(), 183, 183), -7.422992e-8, 1e-14);
    EXPECT_NEAR(real(shaftOfPaperB(), 0, 183), 4.770384e-8, 1e-14);
}

TEST(BeamReceptance, ClampedStaticDeflection)
{
    auto parameters = with(ShearModel::Cowper);
    parameters.supports = {{250, rigid, rigid, 0}};
    const ReceptanceMatrix g = receptance(rod40(), lossless(), parameters, 0, 0, 0);
    const double E = 210000, G = E / 2.6;
    const double I = std::numbers::pi * std::pow(40, 4) / 64, A = std::numbers::pi * 400;
    const double shear = shearCoefficient(ShearModel::Cowper, 0, 0.3) * G * A;
    EXPECT_NEAR(g(0, 0).real() / (std::pow(250, 3) / (3 * E * I) + 250 / shear), 1, 1e-12);
    EXPECT_NEAR(g(0, 1).real() / (250 * 250 / (2 * E * I)), 1, 1e-12);  // + : x points to the free end
    EXPECT_NEAR(g(1, 0).real() / (250 * 250 / (2 * E * I)), 1, 1e-12);
    EXPECT_NEAR(g(1, 1).real() / (250 / (E * I)), 1, 1e-12);
    // With stiff springs in place of the clamp.
    parameters.supports = {{250, 1e13, 1e16, 0}};
    EXPECT_LT(relative(receptance(rod40(), lossless(), parameters, 0, 0, 0), g), 1e-6);
    EXPECT_TRUE(std::isnan(receptance(rod40(), {}, with(ShearModel::Cowper), 0, 0, 0)(0, 0).real()));
}

TEST(BeamReceptance, ShaftBetweenTailstockAndChuck)
{
    auto parameters = with(ShearModel::Hutchinson);
    parameters.supports = {{0, rigid, 0, 0}, {250, rigid, 0, 0}};
    const Complex middle = receptance(rod40(), lossless(), parameters, 125, 125, 0)(0, 0);
    const double E = 210000, I = std::numbers::pi * std::pow(40, 4) / 64;
    const double shear = shearCoefficient(ShearModel::Hutchinson, 0, 0.3) * E / 2.6 * std::numbers::pi * 400;
    EXPECT_NEAR(middle.real() / (std::pow(250, 3) / (48 * E * I) + 250 / (4 * shear)), 1, 1e-11);
    EXPECT_EQ(receptance(rod40(), {}, parameters, 0, 125, 500)(0, 0), Complex(0));  // held
}

TEST(BeamReceptance, TwoHalvesAreTheWhole)
{
    const auto parameters = with(ShearModel::Hutchinson);
    for (const double f : {1.0, 50.0, 1000.0, 9000.0}) {
        const auto whole = receptance(rod40(), {}, parameters, 0, 250, f);
        const auto halves = receptance(stepped({{125, 40}, {125, 40}}), {}, parameters, 0, 250, f);
        EXPECT_LT(relative(halves, whole), 1e-8) << f;
    }
}

TEST(BeamReceptance, Reciprocity)
{
    const std::vector<double> places{20, 0, 140, 183};
    const std::vector<double> frequency_hz{100, 1500, 7000};
    const auto g = beamReceptances(shaftOfPaperB(), {}, with(ShearModel::Hutchinson), places, frequency_hz);
    for (std::size_t line = 0; line < frequency_hz.size(); ++line)
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t c = 0; c < 4; ++c)
                EXPECT_LT(relative(g[line * 16 + a * 4 + c], g[line * 16 + c * 4 + a].transpose()), 1e-9);
}

TEST(BeamReceptance, ADampedShaftTakesPower)
{
    std::vector<double> frequency_hz;
    for (int i = 1; i <= 1000; ++i) frequency_hz.push_back(10.0 * i);
    const std::vector<double> places{0, 90};
    auto parameters = with(ShearModel::Hutchinson);
    parameters.supports = {{183, 1e5, 1e7, 0.05}};
    for (const BeamMethod method : {BeamMethod::Exact, BeamMethod::FiniteElements}) {
        parameters.method = method;
        const auto all = beamReceptances(shaftOfPaperB(), {}, parameters, places, frequency_hz);
        for (std::size_t i = 0; i < all.size(); i += 4) {
            EXPECT_LT(all[i](0, 0).imag(), 0);
            EXPECT_LT(all[i](1, 1).imag(), 0);
            EXPECT_LT(all[i + 3](0, 0).imag(), 0);
        }
    }
}

TEST(BeamReceptance, SlenderShaftInManySegments)
{
    const Shaft whole = cylinder(1000, 10);
    std::vector<std::pair<double, double>> parts(200, {5, 10});
    const Shaft cut = stepped(parts);
    const auto parameters = with(ShearModel::Hutchinson);
    for (double f = 20; f <= 10000; f += 249.5)
        for (const double excite : {0.0, 1000.0}) {
            const auto a = receptance(whole, {}, parameters, 0, excite, f);
            const auto b = receptance(cut, {}, parameters, 0, excite, f);
            ASSERT_TRUE(b.allFinite());
            EXPECT_LT(relative(b, a), 1e-6) << f << ' ' << excite;
        }
}

TEST(BeamReceptance, VeryLongPiecesStayFinite)
{
    const auto g = receptance(cylinder(1e5, 1), {}, with(ShearModel::Hutchinson), 0, 1e5, 10000);
    EXPECT_TRUE(g.allFinite());
}

TEST(BeamReceptance, TaperByFiftyPiecesIsFineEnough)
{
    Shaft taper;
    taper.segments = {{120, 20, 40, 0, {}, {}}, {130, 40, 40, 0, {}, {}}};
    auto parameters = with(ShearModel::Hutchinson);
    auto many = parameters;
    many.taper_pieces = 400;
    for (const double f : {50.0, 500.0, 1000.0, 2000.0, 5000.0})
        EXPECT_LT(relative(receptance(taper, {}, parameters, 0, 0, f), receptance(taper, {}, many, 0, 0, f)), 2e-3)
            << f;
}

TEST(BeamReceptance, FiniteElementsAgree)
{
    const auto exact = receptance(shaftOfPaperB(), {}, with(ShearModel::Hutchinson), 0, 183, 1000);
    auto parameters = with(ShearModel::Hutchinson, BeamMethod::FiniteElements);
    parameters.element_length_mm = 1;
    EXPECT_LT(relative(receptance(shaftOfPaperB(), {}, parameters, 0, 183, 1000), exact), 2e-4);
}

TEST(BeamReceptance, ScalesByItsDimensions)
{
    // Lengths × a, forces × b, times × c.
    constexpr double a = 2.5, b = 3, c = 0.7;
    auto parameters = with(ShearModel::Hutchinson);
    parameters.supports = {{183, 1e5, 1e7, 0.05}};
    const auto g = receptance(shaftOfPaperB(), {}, parameters, 30, 150, 800);
    Material material;
    material.elastic_modulus_MPa *= b / (a * a);
    material.density_kg_m3 *= b * c * c / std::pow(a, 4);
    parameters.supports = {{183 * a, 1e5 * b / a, 1e7 * b * a, 0.05}};
    const auto scaled = receptance(stepped({{98 * a, 30 * a}, {10 * a, 37 * a}, {75 * a, 33.8 * a}}), material,
                                   parameters, 30 * a, 150 * a, 800 / c);
    ReceptanceMatrix expected;
    expected << g(0, 0) * a / b, g(0, 1) / b, g(1, 0) / b, g(1, 1) / (a * b);
    EXPECT_LT(relative(scaled, expected), 1e-10);
}

TEST(BeamReceptance, AChuckOfSpringsIsASupport)
{
    auto parameters = with(ShearModel::Hutchinson);
    const std::vector<double> places{0, 140};
    BeamReceptance open(beamModel(shaftOfPaperB(), {}, parameters, places));
    parameters.supports = {{183, 1e4, 1e8, 0.1}};
    BeamReceptance held(beamModel(shaftOfPaperB(), {}, parameters, places));
    ReceptanceMatrix chuck = ReceptanceMatrix::Zero();
    chuck(0, 0) = Complex(1e4, 1e3);
    chuck(1, 1) = Complex(1e8, 1e7);
    std::array<ReceptanceMatrix, 4> a, b;
    for (const double f : {0.0, 0.1, 50.0, 4000.0}) {
        open.at(f, chuck, a);
        held.at(f, b);
        for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(relative(a[i], b[i]), 1e-12);
    }
}

}  // namespace
}  // namespace lathelier::beam
