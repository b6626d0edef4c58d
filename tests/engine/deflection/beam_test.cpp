// Compliance at the tool: against the force method, closed forms, and the receptance at 0 Hz.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "case_a.h"
#include "engine/receptance/shaft/shaft_receptance.h"

namespace lathelier::deflection {
namespace {

/// By unit loads: the work clamped behind the chuck's springs, the forces of the other springs as unknowns. Moments and
/// shear forces are integrated over every piece of the plan with its current radii.
class ForceMethod {
public:
    ForceMethod(const WorkPlan& plan, const TurningWork& work, const TurningSetup& setup)
        : plan_(plan), work_(work), setup_(setup)
    {
    }

    long double compliance(double z_mm) const
    {
        std::vector<std::pair<double, double>> springs;  // z, stiffness
        if (setup_.tailstock) springs.emplace_back(0, setup_.tailstock->radial_N_mm);
        for (const SteadyRest& rest : setup_.steady_rests) springs.emplace_back(rest.z_mm, rest.radial_N_mm);
        const auto n = static_cast<Eigen::Index>(springs.size());
        using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
        using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
        Matrix f(n, n);
        Vector by_load(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto& [z_i, k_i] = springs[static_cast<std::size_t>(i)];
            by_load(i) = cantilever(z_i, z_mm);
            for (Eigen::Index j = 0; j < n; ++j)
                f(i, j) = cantilever(z_i, springs[static_cast<std::size_t>(j)].first) +
                          (i == j ? 1 / static_cast<long double>(k_i) : 0.0L);
        }
        long double result = cantilever(z_mm, z_mm);
        if (n > 0) result -= by_load.dot(f.fullPivLu().solve(by_load));
        return result;
    }

private:
    /// Deflection at a by a unit force at b.
    long double cantilever(double a, double b) const
    {
        const long double L = plan_.length_mm();
        long double sum = 1 / static_cast<long double>(setup_.chuck.radial_N_mm) +
                          (L - a) * (L - b) / static_cast<long double>(setup_.chuck.tilt_N_mm_rad);
        const Elasticity e(setup_.material.elastic, setup_.shear);
        const double from = std::max(a, b);
        for (std::size_t i = 0; i < plan_.pieces(); ++i) {
            const double z1 = plan_.z_mm[i + 1];
            if (z1 <= from + 1e-12) continue;
            const long double z0 = std::max(plan_.z_mm[i], from), h = z1 - z0;
            const double outer = (work_.outerStart_mm()[i] + work_.outerEnd_mm()[i]) / 2;
            const beam::BeamSection s = beam::roundSection(2 * outer, 2 * plan_.bore_mm[i]);
            const double kappa =
                beam::shearCoefficient(setup_.shear, plan_.bore_mm[i] / outer, setup_.material.elastic.poisson_ratio);
            const long double m = z0 + h / 2;
            const long double product = ((z0 - a) * (z0 - b) + 4 * (m - a) * (m - b) + (z1 - a) * (z1 - b)) * h / 6;
            sum += product / (static_cast<long double>(e.elastic_modulus_MPa) * s.second_moment_mm4) +
                   h / (static_cast<long double>(kappa) * e.shear_modulus_MPa * s.area_mm2);
        }
        return sum;
    }

    const WorkPlan& plan_;
    const TurningWork& work_;
    const TurningSetup& setup_;
};

/// Simulates the run up to several nodes and compares there.
void compareWithForceMethod(const Shaft& stock, std::vector<ToolRun> runs, const TurningSetup& setup)
{
    const WorkPlan plan = workPlan(stock, runs, setup);
    std::vector<Station> stations;
    for (const std::size_t share : {0U, 1U, 3U, 5U, 8U, 10U}) {
        CutPlan cut = plan.cuts.front();
        cut.pieces.resize(cut.pieces.size() * share / 10);
        const std::size_t node = cut.last();
        TurningWork work(plan, setup);
        work.take(cut, CutTask::Predict, stations);
        const double found = work.complianceAt(node).ww;
        const auto expected = static_cast<double>(ForceMethod(plan, work, setup).compliance(plan.z_mm[node]));
        // The last piece behind the tool is taken with the error of the node before it.
        EXPECT_NEAR(found / expected, 1, 2e-7) << share;
        // Without cutting both have the same workpiece.
        TurningWork uncut(plan, setup);
        CutPlan air = plan.cuts.front();
        for (CutPiece& piece : air.pieces) piece.start_mm = piece.end_mm = 1e3;
        uncut.take(air, CutTask::Predict, stations);
        const auto there = static_cast<double>(ForceMethod(plan, uncut, setup).compliance(plan.z_mm[node]));
        EXPECT_NEAR(uncut.complianceAt(node).ww / there, 1, 1e-9) << share;
    }
}

TEST(CondensedBeam, ForceMethod)
{
    TurningSetup setup = caseASetup();
    compareWithForceMethod(caseAStock(), caseARuns(), setup);
    setup.step_mm = 0.1;  // 2875 pieces: short ones cancel nothing
    compareWithForceMethod(caseAStock(), caseARuns(), setup);
    setup.step_mm = 0.5;
    setup.tailstock.reset();
    compareWithForceMethod(caseAStock(), caseARuns(), setup);
    setup.steady_rests = {{120.3, 9000}, {200, 4000}};
    setup.shear = beam::ShearModel::Hutchinson;
    Shaft hollow;
    hollow.segments = {{100, 34, 40, 12, {}, {}}, {80, 44, 44, 20, {}, {}}, {107.5, 50, 46, 0, {}, {}}};
    compareWithForceMethod(hollow, straightCut(15, 90), setup);
}

TEST(CondensedBeam, AgreesWithTheReceptanceAtZeroHz)
{
    for (const beam::ShearModel shear : {beam::ShearModel::Cowper, beam::ShearModel::Hutchinson}) {
        TurningSetup setup = caseASetup();
        setup.shear = shear;
        setup.step_mm = 2;
        const Shaft stock = rod(287.5, 34, 10);
        const WorkPlan plan = workPlan(stock, straightCut(1e3, 280), setup);
        TurningWork work(plan, setup);
        std::vector<Station> stations;
        work.take(plan.cuts.front(), CutTask::Predict, stations);
        for (const std::size_t node : {std::size_t{0}, std::size_t{40}, std::size_t{100}}) {
            receptance::ReceptanceParameters asked;
            asked.respond_z_mm = asked.excite_z_mm = plan.z_mm[node];
            asked.from_hz = asked.to_hz = 0;
            asked.shear = shear;
            receptance::ShaftHolding holding;
            holding.spindle = receptance::SpindleReceptance{
                receptance::SpindleSprings{setup.chuck.radial_N_mm, setup.chuck.tilt_N_mm_rad, 0}};
            holding.supports = {{0, setup.tailstock->radial_N_mm, 0, 0}};
            Material material = setup.material.elastic;
            material.loss_factor = 0;
            const Frf frf = receptance::receptanceOf(stock, material, asked, holding);
            EXPECT_NEAR(work.complianceAt(node).ww / frf.value.front().real(), 1, 1e-9);
        }
    }
}

TEST(CondensedBeam, FollowerRestAndShape)
{
    TurningSetup setup = caseASetup();
    const double without = predictDeflection(caseAStock(), caseARuns(), setup).summary.max_um;
    setup.follower_rest = FollowerRest{0, 20000};
    const double beside = predictDeflection(caseAStock(), caseARuns(), setup).summary.max_um;
    for (const double offset_mm : {-1e-6, 1e-6}) {
        setup.follower_rest->offset_mm = offset_mm;
        const DeflectionResult near = predictDeflection(caseAStock(), caseARuns(), setup);
        EXPECT_NEAR(near.passes.front().diameter_error_um[200],
                    predictDeflection(caseAStock(), caseARuns(),
                                      [&] {
                                          TurningSetup at = setup;
                                          at.follower_rest->offset_mm = 0;
                                          return at;
                                      }())
                        .passes.front()
                        .diameter_error_um[200],
                    1e-3);
    }
    EXPECT_LT(beside, 0.5 * without);
}

}  // namespace
}  // namespace lathelier::deflection
