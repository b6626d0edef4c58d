#include "engine/receptance/receptance_verification.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/beam/beam_receptance.h"
#include "engine/beam/natural_frequencies.h"
#include "engine/receptance/coupling.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/receptance/spindle/spindle_verification.h"

namespace lathelier::receptance {
namespace {

using beam::BeamParameters;
using beam::ShearModel;

constexpr double rigid = std::numeric_limits<double>::infinity();
constexpr double mm_N = 1e-3;  ///< 1 mm/N in m/N

Shaft steppedShaft(const std::vector<std::pair<double, double>>& length_and_diameter_mm)
{
    Shaft shaft;
    shaft.segments.reserve(length_and_diameter_mm.size());
    for (const auto& [length_mm, diameter_mm] : length_and_diameter_mm)
        shaft.segments.push_back({length_mm, diameter_mm, diameter_mm, 0, {}, {}});
    shaft.material = Material{};
    return shaft;
}

BeamParameters cowper(std::vector<beam::Support> supports = {})
{
    BeamParameters parameters;
    parameters.shear = ShearModel::Cowper;
    parameters.supports = std::move(supports);
    return parameters;
}

std::vector<ReceptanceMatrix> at(const Shaft& shaft, const BeamParameters& parameters,
                                 const std::vector<double>& places_z_mm, double frequency_hz)
{
    return beam::beamReceptances(shaft, *shaft.material, parameters, places_z_mm, std::vector<double>{frequency_hz});
}

double relative(const ReceptanceMatrix& a, const ReceptanceMatrix& b)
{
    return ((a - b).cwiseAbs().array() / b.cwiseAbs().array()).maxCoeff();
}

template <VerifyKind (*check)()>
VerifyKind quick(const Progress&)
{
    return check();
}

}  // namespace

VerifyKind verifyNaturalFrequencies()
{
    VerifyTally tally("beam_natural_frequency", LT_TEXT("Engine", "Natural frequencies of beams"), {}, 3e-6);
    const auto compare = [&](const Shaft& shaft, const BeamParameters& parameters, const std::vector<double>& known) {
        const std::vector<double> found =
            beam::naturalFrequencies(beam::beamModel(shaft, *shaft.material, parameters, {}), 1.05 * known.back());
        tally.nextSet();
        if (found.size() < known.size()) return tally.take(std::nan(""));
        for (std::size_t i = 0; i < known.size(); ++i) tally.compare(found[i] / known[i], 1);
    };
    compare(steppedShaft({{250, 40}}), cowper(), {2768.36, 6937.89, 12207.47});
    compare(steppedShaft({{98, 30}, {10, 37}, {75, 33.8}}), cowper(), {3998.26, 10105.76, 17399.64});
    // Slender enough for Euler's beam: β² √(EI/ρA) / (2π L²).
    const double length_mm = 4000, diameter_mm = 2;
    const double speed = std::sqrt(210000 / 7.85e-9) * diameter_mm / 4;
    const auto euler = [&](const std::vector<double>& beta) {
        std::vector<double> f;
        f.reserve(beta.size());
        for (const double b : beta) f.push_back(b * b * speed / (2 * std::numbers::pi * length_mm * length_mm));
        return f;
    };
    compare(steppedShaft({{length_mm, diameter_mm}}), cowper(), euler({4.730040744862704, 7.853204624095838}));
    compare(steppedShaft({{length_mm, diameter_mm}}), cowper({{length_mm, rigid, rigid, 0}}),
            euler({1.875104068711961, 4.694091132974175}));
    return tally.done();
}

VerifyKind verifyBeamReceptances()
{
    VerifyTally tally("beam_receptance", LT_TEXT("Engine", "Receptances of beams"), {}, 1e-6);
    const auto compare = [&](const Shaft& shaft, double respond_z_mm, double excite_z_mm, double known_m_N) {
        tally.nextSet();
        tally.compare(at(shaft, cowper(), {respond_z_mm, excite_z_mm}, 1000)[1](0, 0).real() * mm_N / known_m_N, 1);
    };
    compare(steppedShaft({{250, 40}}), 0, 0, -3.377508e-8);
    const Shaft stepped = steppedShaft({{98, 30}, {10, 37}, {75, 33.8}});
    compare(stepped, 0, 0, -8.721604e-8);
    compare(stepped, 183, 183, -7.422992e-8);
    compare(stepped, 0, 183, 4.770384e-8);
    // Static and clamped: P L³/3EI + P L/κGA.
    Shaft rod = steppedShaft({{250, 40}});
    rod.material->loss_factor = 0;
    const ReceptanceMatrix g = at(rod, cowper({{250, rigid, rigid, 0}}), {0}, 0).front();
    const double bending = 210000 * std::numbers::pi * std::pow(40, 4) / 64;  // bending stiffness EI
    const double shear = beam::shearCoefficient(ShearModel::Cowper, 0, 0.3) * 210000 / 2.6 * std::numbers::pi * 400;
    tally.nextSet();
    tally.compare(g(0, 0).real() / (std::pow(250, 3) / (3 * bending) + 250 / shear), 1);
    tally.compare(g(0, 1).real() / (250 * 250 / (2 * bending)), 1);
    tally.compare(g(1, 1).real() / (250 / bending), 1);
    return tally.done();
}

VerifyKind verifyCoupling()
{
    VerifyTally tally("receptance_coupling", LT_TEXT("Engine", "Two halves of a shaft coupled"), {}, 1e-8);
    const Shaft whole = steppedShaft({{98, 30}, {10, 37}, {75, 33.8}, {60, 40}});
    const Shaft outer = steppedShaft({{98, 30}, {10, 37}, {75, 33.8}}), inner = steppedShaft({{60, 40}});
    const std::vector<double> places{0, 60, 183};
    for (const double f : {150.0, 700.0, 3000.0, 9000.0}) {
        const auto free = at(outer, cowper(), places, f);
        const ReceptanceMatrix other = at(inner, cowper(), {0}, f).front();
        tally.nextSet();
        tally.take(relative(coupled({free[1], free[2], free[8], free[7]}, other), at(whole, cowper(), places, f)[1]));
    }
    return tally.done();
}

VerifyKind verifyCoupledRod()
{
    VerifyTally tally("coupled_rod", LT_TEXT("Engine", "Rod of the source papers on its springs"), {}, 1e-4);
    ReceptanceParameters parameters;
    parameters.shear = ShearModel::Cowper;
    parameters.from_hz = 200;
    parameters.to_hz = 250;
    parameters.step_hz = 0.25;
    const Shaft rod = steppedShaft({{250, 40}});
    const Frf frf =
        receptanceOf(rod, *rod.material, parameters, {SpindleReceptance{SpindleSprings{15000, 1.974e8, 0.06}}, {}});
    std::size_t peak = 0, least = 0;
    for (std::size_t i = 1; i < frf.value.size(); ++i) {
        if (std::abs(frf.value[i]) > std::abs(frf.value[peak])) peak = i;
        if (frf.value[i].real() < frf.value[least].real()) least = i;
    }
    tally.nextSet();
    tally.compare(frf.frequency_hz[peak] / 223.0, 1);
    tally.compare(std::abs(frf.value[peak]) * mm_N / 1.1663e-5, 1);
    tally.nextSet();
    tally.compare(frf.frequency_hz[least] / 228.25, 1);
    tally.compare(frf.value[least].real() * mm_N / -5.7532e-6, 1);
    return tally.done();
}

VerifyKind verifyFiniteElements()
{
    VerifyTally tally("finite_elements", LT_TEXT("Engine", "Shafts on springs against finite elements"), {}, 2e-3);
    const SpindleReceptance machine{SpindleSprings{}};
    for (const auto& segments : std::vector<std::vector<std::pair<double, double>>>{
             {{98, 30}, {10, 37}, {75, 33.8}}, {{250, 40}}, {{120, 18}, {80, 26}}, {{60, 50}, {90, 36}, {40, 60}}}) {
        tally.nextSet();
        ReceptanceParameters asked;
        asked.from_hz = 60;
        asked.to_hz = 1500;
        asked.step_hz = 37;
        const Frf exact = shaftReceptance(steppedShaft(segments), asked, machine).frf;
        asked.method = beam::BeamMethod::FiniteElements;
        const Frf elements = shaftReceptance(steppedShaft(segments), asked, machine).frf;
        double error = 0, size = 0;
        for (std::size_t i = 0; i < exact.value.size(); ++i) {
            error += std::norm(exact.value[i] - elements.value[i]);
            size += std::norm(exact.value[i]);
        }
        tally.take(std::sqrt(error / size));
    }
    return tally.done();
}

const VerifyPart& receptanceVerification()
{
    static const VerifyPart part{
        "receptance",
        {quick<verifyNaturalFrequencies>, quick<verifyBeamReceptances>, quick<verifyCoupling>, quick<verifyCoupledRod>,
         verifyInverseCoupling, verifySpindleMistakes, quick<verifyFiniteElements>},
        {},
        "dynamics"};
    return part;
}

}  // namespace lathelier::receptance
