// Coupling against the assembled model, the papers' numbers and the papers' own form.
#include "engine/receptance/coupling.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "engine/beam/beam_receptance.h"
#include "made_spindle.h"

namespace lathelier::receptance {
namespace {

using beam::BeamParameters;
using beam::ShearModel;

constexpr std::size_t n = 4;  // free end, middle, tailstock side, chuck face

std::vector<ReceptanceMatrix> freeShaft(double frequency_hz, const std::vector<double>& places_z_mm,
                                        const BeamParameters& parameters = {})
{
    return beam::beamReceptances(newPart(), {}, parameters, places_z_mm, std::vector<double>{frequency_hz});
}

double relative(const ReceptanceMatrix& a, const ReceptanceMatrix& b)
{
    return ((a - b).cwiseAbs().array() / b.cwiseAbs().array()).maxCoeff();
}

/// The sign of L is tested by two springs, one of them beside the chuck face, which have a cross term.
TEST(Coupling, IsTheAssembledModel)
{
    const std::vector<double> places{0, 60, 150, 200};
    for (const double f : {50.0, 223.0, 900.0, 4000.0}) {
        const auto g = freeShaft(f, places);
        BeamParameters assembled;
        assembled.supports = {{200, 15000, 1.974e8, 0.06}};
        const auto truth = freeShaft(f, places, assembled);
        const auto found = coupled({g[1], g[3], g[n * n - 1], g[3 * n + 1]}, springs().at(f));
        EXPECT_LT(relative(found, truth[1]), 1e-8) << f;
    }
}

TEST(Coupling, SignOfTheCrossReceptance)
{
    // The spindle is itself a shaft on springs: 120 mm of it, cut at the chuck face. Its L is not 0.
    Shaft whole = newPart();
    whole.segments.push_back({120, 60, 60, 0, {}, {}});
    BeamParameters held;
    held.supports = {{320, 15000, 1.974e8, 0.06}};
    BeamParameters spindle_held;
    spindle_held.supports = {{120, 15000, 1.974e8, 0.06}};
    Shaft spindle;
    spindle.segments = {{120, 60, 60, 0, {}, {}}};
    for (const double f : {100.0, 400.0, 2000.0}) {
        const std::vector<double> line{f};
        const auto truth = beam::beamReceptances(whole, {}, held, std::vector<double>{0, 60}, line);
        const auto g = freeShaft(f, {0, 60, 150, 200});
        const ReceptanceMatrix face =
            beam::beamReceptances(spindle, {}, spindle_held, std::vector<double>{0}, line).front();
        EXPECT_LT(relative(coupled({g[1], g[3], g[n * n - 1], g[3 * n + 1]}, face), truth[1]), 1e-8) << f;
        ReceptanceMatrix wrong = face;
        wrong(0, 1) = -wrong(0, 1);
        wrong(1, 0) = -wrong(1, 0);
        EXPECT_GT(relative(coupled({g[1], g[3], g[n * n - 1], g[3 * n + 1]}, wrong), truth[1]), 1e-2) << f;
    }
}

TEST(Coupling, ClampedIsNoReceptance)
{
    const std::vector<double> places{0, 60, 150, 200};
    BeamParameters clamped;
    clamped.supports = {{200, HUGE_VAL, HUGE_VAL, 0}};
    const auto g = freeShaft(1000, places);
    const auto truth = freeShaft(1000, places, clamped);
    EXPECT_LT(relative(coupled({g[1], g[3], g[n * n - 1], g[3 * n + 1]}, ReceptanceMatrix::Zero()), truth[1]), 1e-8);
}

/// Eq. 7 of Jasiewicz and Miądlicki, An integrated CNC system for chatter suppression in turning, for Hs12 = Hs21:
/// T⁻¹ times the coupled (w1, θ1, w2) is the free one; 1 is the joint, 2 the tip.
TEST(Coupling, IsThePapersTransformation)
{
    const double f = 350;
    const auto g = freeShaft(f, {0, 200});
    const ReceptanceMatrix tip = g[0], cross = g[1], joint = g[3];
    const SpindleTable table = livelySpindle(300, 400, 10);
    const ReceptanceMatrix s = SpindleReceptance{table}.at(f);
    const Complex D = s(0, 0) * s(1, 1) - s(0, 1) * s(1, 0);
    const auto column = [&](const ReceptanceMatrix& beam, int row, int which) {
        return which == 0 ? (beam(row, 0) * s(1, 1) - beam(row, 1) * s(1, 0)) / D
                          : (beam(row, 1) * s(0, 0) - beam(row, 0) * s(0, 1)) / D;
    };
    Eigen::Matrix3cd inverse_T;
    inverse_T << 1.0 + column(joint, 0, 0), column(joint, 0, 1), 0, column(joint, 1, 0), 1.0 + column(joint, 1, 1), 0,
        column(cross, 0, 0), column(cross, 0, 1), 1;
    const Eigen::Vector3cd free_motion(g[2](0, 0), g[2](1, 0), tip(0, 0));
    const Complex papers = inverse_T.fullPivLu().solve(free_motion)[2];
    const Complex ours = coupled({tip, cross, joint, g[2]}, s)(0, 0);
    EXPECT_LT(std::abs(ours / papers - 1.0), 1e-11);
}

TEST(Coupling, ChuckAndTailstockAreTwoJoints)
{
    const std::vector<double> places{0, 60, 150, 200};
    constexpr double f = 700;
    const auto g = freeShaft(f, places);
    const auto at = [&](std::size_t a, std::size_t c) { return g[a * n + c]; };
    BeamParameters assembled;
    assembled.supports = {{200, 15000, 1.974e8, 0.06}, {0, 8000, 1e5, 0.02}};
    const auto truth = freeShaft(f, places, assembled);
    const ReceptanceMatrix tailstock = SpindleReceptance{SpindleSprings{8000, 1e5, 0.02}}.at(f);
    const std::array<Joint, 2> joints{Joint{at(1, 3), at(3, 2), springs().at(f)}, Joint{at(1, 0), at(0, 2), tailstock}};
    const std::array<ReceptanceMatrix, 4> between{at(3, 3), at(3, 0), at(0, 3), at(0, 0)};
    EXPECT_LT(relative(coupled(at(1, 2), joints, between), truth[1 * n + 2]), 1e-8);
}

TEST(Coupling, AnElasticJointAddsItsCompliance)
{
    const SpindleSprings joint{30000, 3e8, 0};
    const ReceptanceMatrix both = behindJoint(springs().at(0), joint);
    EXPECT_NEAR(both(0, 0).real(), (1.0 / (15000.0 * Complex(1, 0.06))).real() + 1.0 / 30000, 1e-15);
    EXPECT_EQ(both(0, 1), Complex(0));
}

TEST(Coupling, AMassIsAddedAndTakenAway)
{
    // 5 g at the tip is a thin disc of the beam there.
    const Complex bare(-3e-5, -2e-6);
    const Complex loaded = withMass(bare, 0.005, 400);
    EXPECT_LT(std::abs(withMass(loaded, -0.005, 400) - bare), 1e-18);
    Shaft heavy = newPart();
    constexpr double thin_mm = 1e-3;
    const double diameter_mm = std::sqrt(0.005e9 / 7850 / thin_mm * 4 / std::numbers::pi);
    heavy.segments.insert(heavy.segments.begin(), {thin_mm, diameter_mm, diameter_mm, 0, {}, {}});
    Material rigid;
    const std::vector<double> line{400}, tip{thin_mm};
    // Rotary inertia of so wide a disc counts too: compare with a beam that has the same disc only roughly.
    const Complex assembled = beam::beamReceptances(heavy, rigid, {}, tip, line)[0](0, 0);
    const Complex bare_tip = freeShaft(400, {0})[0](0, 0);
    EXPECT_LT(std::abs(assembled), std::abs(bare_tip));
    EXPECT_LT(std::abs(withMass(bare_tip, 0.005, 400)), std::abs(bare_tip));
}

}  // namespace
}  // namespace lathelier::receptance
