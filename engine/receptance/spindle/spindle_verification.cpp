#include "engine/receptance/spindle/spindle_verification.h"

#include <limits>
#include <numbers>
#include <utility>

#include "engine/core/random.h"
#include "engine/core/units.h"
#include "engine/receptance/eirc/identify_spindle.h"
#include "engine/receptance/shaft/shaft_receptance.h"

namespace lathelier::receptance {
namespace {

/// A machine with one mode and a cross receptance.
SpindleTable machine(double step_hz)
{
    SpindleTable table;
    for (double f = 100; f <= 1500; f += step_hz) {
        const double ratio = f / 640;
        const Complex mode = 1.0 / Complex(1 - ratio * ratio, 2 * 0.04 * ratio) / 40000.0;
        const double lever = -1.0 / 150;
        const Complex soft = 1.0 / Complex(1, 0.06);
        table.frequency_hz.push_back(f);
        table.H_mm_N.push_back(soft / 15000.0 + mode);
        table.L_mm_Nmm.push_back(mode * lever);
        table.P_rad_Nmm.push_back(soft / 1.974e8 + mode * lever * lever);
    }
    return table;
}

/// All pairs of points of three rods D40, on the machine.
SpindleMeasurements tapTests(const SpindleTable& machine, beam::BeamMethod method, const Progress& progress)
{
    SpindleMeasurements measurements;
    for (const auto& [length_mm, distances_mm] : {std::pair{150.0, std::vector{50.0, 100.0, 150.0}},
                                                  {200.0, std::vector{60.0, 130.0, 200.0}},
                                                  {260.0, std::vector{80.0, 170.0, 260.0}}}) {
        Shaft rod;
        rod.segments.push_back({length_mm, 40, 40, 0, {}, {}});
        rod.material = Material{};
        measurements.rods.push_back({rod, distances_mm});
        for (std::size_t a = 0; a < distances_mm.size(); ++a)
            for (std::size_t b = a; b < distances_mm.size(); ++b) {
                ReceptanceParameters parameters;
                parameters.respond_z_mm = length_mm - distances_mm[a];
                parameters.excite_z_mm = length_mm - distances_mm[b];
                parameters.from_hz = machine.frequency_hz.front();
                parameters.to_hz = machine.frequency_hz.back();
                parameters.step_hz = machine.frequency_hz[1] - machine.frequency_hz[0];
                parameters.method = method;
                measurements.frfs.push_back(
                    {measurements.rods.size() - 1, a, b,
                     receptanceOf(rod, *rod.material, parameters, {SpindleReceptance{machine}, {}}, progress)});
            }
    }
    return measurements;
}

/// Each value times 1 + 1 % of a complex normal deviate.
void addNoise(SpindleMeasurements& measurements)
{
    constexpr double noise = 0.01 / std::numbers::sqrt2;
    for (std::size_t i = 0; i < measurements.frfs.size(); ++i) {
        std::vector<Complex>& value = measurements.frfs[i].frf.value;
        for (std::size_t k = 0; k < value.size(); ++k)
            value[k] *= 1.0 + noise * Complex(randomNormal(1, i, 2 * k), randomNormal(1, i, 2 * k + 1));
    }
}

}  // namespace

VerifyKind verifyInverseCoupling(const Progress& progress)
{
    VerifyTally tally("inverse_coupling", LT_TEXT("Engine", "Spindle found from made responses"), {}, 1e-5);
    const SpindleTable truth = machine(20);
    const SpindleIdentification found =
        identifySpindle(tapTests(truth, beam::BeamMethod::Exact, progress.quiet()), {}, progress.quiet());
    const auto* const table = std::get_if<SpindleTable>(&found.spindle.source);
    if (!table || table->frequency_hz.size() != truth.frequency_hz.size()) return tally.done();
    for (std::size_t i = 0; i < truth.frequency_hz.size(); ++i) {
        tally.nextSet();
        tally.take(std::abs(table->H_mm_N[i] / truth.H_mm_N[i] - 1.0));
        tally.take(std::abs(table->L_mm_Nmm[i] / truth.L_mm_Nmm[i] - 1.0));
        tally.take(std::abs(table->P_rad_Nmm[i] / truth.P_rad_Nmm[i] - 1.0));
    }
    return tally.done();
}

VerifyKind verifySpindleMistakes(const Progress& progress)
{
    VerifyTally tally("spindle_mistakes", LT_TEXT("Engine", "Mistakes of tap tests named"), LT_TEXT("Engine", "%"),
                      0.1);
    // Lines so near each other that their scatter is that of the noise.
    SpindleMeasurements sound = tapTests(machine(5), beam::BeamMethod::FiniteElements, progress.quiet());
    addNoise(sound);
    const SpindleIdentification fit = identifySpindle(sound, {}, progress.quiet());
    tally.nextSet();
    tally.take(fit.remedy ? std::numeric_limits<double>::quiet_NaN() : 0);
    const auto check = [&](const SpindleMeasurements& wrong, RemedyKind kind) {
        const SpindleIdentification found = identifySpindle(wrong, {}, progress.quiet());
        const bool is_named = found.remedy && found.remedy->remedy.kind == kind;
        tally.nextSet();
        tally.compare(is_named ? found.remedy->rms_percent : std::numeric_limits<double>::quiet_NaN(),
                      fit.residual_rms_percent);
    };
    for (const std::size_t frf : {0U, 4U, 11U}) {
        SpindleMeasurements wrong = sound;
        for (Complex& value : wrong.frfs[frf].frf.value) value = -value;
        check(wrong, RemedyKind::Sign);
    }
    for (std::size_t rod = 0; rod < sound.rods.size(); ++rod) {
        SpindleMeasurements wrong = sound;
        std::vector<double>& swapped_mm = wrong.rods[rod].distance_from_chuck_mm;
        std::swap(swapped_mm[0], swapped_mm[2]);
        check(wrong, RemedyKind::Swap);
        wrong = sound;
        wrong.rods[rod].distance_from_chuck_mm[0] += 5;
        check(wrong, RemedyKind::Distance);
    }
    return tally.done();
}

}  // namespace lathelier::receptance
