#include "engine/deflection/deflection_verification.h"

#include <array>
#include <utility>

#include "engine/core/units.h"
#include "engine/deflection/case_a.h"
#include "engine/deflection/deflection.h"

namespace lathelier::deflection {
namespace {

Shaft rod(double length_mm, double diameter_mm)
{
    Shaft shaft;
    shaft.segments = {{length_mm, diameter_mm, diameter_mm, 0, {}, {}}};
    return shaft;
}

/// Compliance of the uncut workpiece at a node.
double complianceAt(const TurningSetup& setup, const Shaft& stock, double z_mm)
{
    const std::vector<ToolRun> runs{{ToolRun::Kind::TowardChuck, {{z_mm, 1e4, 0.2, 1}, {z_mm + 1, 1e4, 0.2, 1}}}};
    const WorkPlan plan = workPlan(stock, runs, setup);
    TurningWork work(plan, setup);
    std::vector<Station> stations;
    work.take(plan.cuts.front(), CutTask::Predict, stations);
    return work.complianceAt(plan.cuts.front().first).ww;
}

template <VerifyKind (*check)()>
VerifyKind quick(const Progress&)
{
    return check();
}

}  // namespace

VerifyKind verifyCuttingForces()
{
    VerifyTally tally("cutting_force", LT_TEXT("Engine", "Cutting forces"), unit::newton, 0.05);
    const TurningSetup setup = caseASetup();
    struct Known {
        double depth_mm, F_t_N, F_f_N, F_ap_N;
    };
    for (const Known& known : {Known{3, 1402.0, 731.0, 173.5}, Known{1, 503.5, 212.3, 189.2}}) {
        tally.nextSet();
        const cutting::CuttingForces found =
            cutting::cuttingForces(setup.material.cutting, setup.tool, 0.2, known.depth_mm);
        tally.compare(found.F_t_N, known.F_t_N);
        tally.compare(found.F_f_N, known.F_f_N);
        tally.compare(found.F_ap_N, known.F_ap_N);
    }
    return tally.done();
}

VerifyKind verifyCaseA()
{
    VerifyTally tally("deflection_case", LT_TEXT("Engine", "Diameter error of a slender shaft"), unit::um, 0.01);
    TurningSetup setup = caseASetup();
    setup.step_mm = 0.25;  // with nodes at the printed places
    const std::vector<ToolRun> runs{{ToolRun::Kind::TowardChuck, {{-2, 14, 0.2, 7}, {280, 14, 0.2, 8}}}};
    const DeflectionResult result = predictDeflection(caseAStock(), runs, setup);
    const PassResult& pass = result.passes.front();
    for (const auto& [z_mm, error_um] : {std::pair{0.0, 61.304},
                                         {25.0, 50.826},
                                         {50.0, 44.038},
                                         {100.0, 36.550},
                                         {143.75, 31.168},
                                         {200.0, 21.352},
                                         {250.0, 12.647},
                                         {280.0, 10.457}}) {
        tally.nextSet();
        std::size_t i = 0;
        while (i + 1 < pass.z_mm.size() && pass.z_mm[i] < z_mm - 1e-3) ++i;
        tally.compare(pass.diameter_error_um[i], error_um);
    }
    return tally.done();
}

VerifyKind verifyBeams()
{
    VerifyTally tally("beam_deflection", LT_TEXT("Engine", "Beams in closed form, relative"), {}, 1e-9);
    TurningSetup setup = caseASetup();
    const double modulus_MPa = setup.material.elastic.elastic_modulus_MPa, nu = setup.material.elastic.poisson_ratio;
    const beam::BeamSection section = beam::roundSection(30, 0);
    const double bending = modulus_MPa * section.second_moment_mm4;
    const double shear = beam::shearCoefficient(setup.shear, 0, nu) * modulus_MPa / (2 * (1 + nu)) * section.area_mm2;
    const double length_mm = 300;
    setup.chuck = {1e16, 0, 1e18, 0};
    setup.tailstock.reset();
    tally.nextSet();
    tally.compare(complianceAt(setup, rod(length_mm, 30), 0) /
                      (length_mm * length_mm * length_mm / (3 * bending) + length_mm / shear),
                  1);
    setup.chuck = {1e16, 0, 0, 0};
    setup.tailstock = HoldingSprings{1e16, 0, 0, 0};
    for (const double a_mm : {75.0, 150.0}) {
        const double b_mm = length_mm - a_mm;
        tally.nextSet();
        tally.compare(complianceAt(setup, rod(length_mm, 30), a_mm) /
                          (a_mm * a_mm * b_mm * b_mm / (3 * bending * length_mm) + a_mm * b_mm / (length_mm * shear)),
                      1);
    }
    return tally.done();
}

const VerifyPart& deflectionVerification()
{
    static const VerifyPart part{"deflection", {quick<verifyCuttingForces>, quick<verifyCaseA>, quick<verifyBeams>}};
    return part;
}

}  // namespace lathelier::deflection
