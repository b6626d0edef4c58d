#include "engine/receptance/shaft/shaft_receptance.h"

#include <array>
#include <cmath>

#include "engine/beam/beam_receptance.h"
#include "engine/beam/natural_frequencies.h"
#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/core/unusual.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/refined_lines.h"
#include "engine/receptance/shaft/held_beam.h"

namespace lathelier::receptance {
namespace {

constexpr double mostShaftLines = 1e6;
constexpr std::size_t linesPerShaftTask = 64;
constexpr std::size_t places = 3;  // response, excitation, chuck face

constexpr double widestStep_hz = 2;      ///< first step of refined lines
constexpr double besideFirstLine = 1.5;  ///< a mode as near to the first line has its least real part there or below

/// Limits need every mode: lines that nobody asked for begin below the lowest natural frequency, and steps are not so
/// wide that a mode between two lines bends neither.
ReceptanceParameters forLimits(const Shaft& shaft, const Material& material, ReceptanceParameters asked,
                               const ShaftHolding& holding)
{
    if (asked.step_hz > widestStep_hz) asked.step_hz /= std::ceil(asked.step_hz / widestStep_hz);
    if (asked.from_hz || (holding.spindle && !holding.spindle->springs())) return asked;
    const beam::BeamModel model =
        beam::beamModel(shaft, material, beamParametersOf(asked, holding, shaft.length_mm(), true), {});
    const std::vector<double> low = beam::naturalFrequencies(model, besideFirstLine * usualLines_hz.from);
    if (!low.empty()) asked.from_hz = low.front() / 2;
    return asked;
}

/// Rejects frequencies outside the spindle's table before computation.
void checkReach(const SpindleReceptance& spindle, const std::vector<double>& frequency_hz)
{
    spindle.at(frequency_hz.front());
    spindle.at(frequency_hz.back());
}

/// What of shaft and supports is hardly meant.
void noteUnusualHolding(const Shaft& shaft, const ShaftHolding& holding, Notes& notes)
{
    const UsualRange length{"length_mm", {2, 20000}}, stiffness{"radial_N_mm", {100, 5e6}};
    noteUnusual(length, shaft.length_mm(), notes);
    if (shaft.material)
        noteUnusual(*shaft.material,
                    {{"elastic_modulus_MPa", {1000, 1e6}}, {"density_kg_m3", {500, 25000}}, {"loss_factor", {0, 0.2}}},
                    notes);
    if (const SpindleSprings* const springs = holding.spindle ? holding.spindle->springs() : nullptr)
        noteUnusual(*springs, {stiffness, {"tilt_N_mm_rad", {1e6, 1e12}}}, notes);
    for (const beam::Support& support : holding.supports)
        if (std::isfinite(support.radial_N_mm)) noteUnusual(stiffness, support.radial_N_mm, notes);
}

}  // namespace

beam::BeamParameters beamParametersOf(const ReceptanceParameters& parameters, const ShaftHolding& holding,
                                      double length_mm, bool springs)
{
    beam::BeamParameters result;
    result.shear = parameters.shear;
    result.method = parameters.method;
    result.step_correction = parameters.step_correction;
    result.supports = holding.supports;
    const SpindleSprings* const spindle = springs && holding.spindle ? holding.spindle->springs() : nullptr;
    if (spindle)
        result.supports.push_back({length_mm, spindle->radial_N_mm, spindle->tilt_N_mm_rad, spindle->loss_factor});
    return result;
}

ReceptanceParameters withinLines(ReceptanceParameters asked, const std::optional<SpindleReceptance>& spindle,
                                 const Interval& usual)
{
    const auto* const table = spindle ? std::get_if<SpindleTable>(&spindle->source) : nullptr;
    const bool has_lines = table && !table->frequency_hz.empty();
    if (!asked.from_hz) asked.from_hz = has_lines ? table->frequency_hz.front() : usual.from;
    if (!asked.to_hz) asked.to_hz = has_lines ? table->frequency_hz.back() : usual.to;
    return asked;
}

std::vector<double> linesOf(const ReceptanceParameters& parameters)
{
    const auto reject = [](const char* parameter, double found, Text expected) {
        throw Error(errors::valueNotUnderstood, {{"parameter", parameter}, {"found", found}, {"expected", expected}});
    };
    if (!(parameters.step_hz > 0)) reject("step_hz", parameters.step_hz, LT_TEXT("Engine", "more than 0"));
    const double from_hz = parameters.from_hz.value_or(usualLines_hz.from);
    const double to_hz = parameters.to_hz.value_or(usualLines_hz.to);
    if (!(from_hz >= 0)) reject("from_hz", from_hz, LT_TEXT("Engine", "0 or more"));
    if (!(to_hz >= from_hz) || !std::isfinite(to_hz))
        reject("to_hz", to_hz, LT_TEXT("Engine", "not less than the first frequency"));
    constexpr double rounding = 1e-9;
    const double steps = std::floor((to_hz - from_hz) / parameters.step_hz * (1 + rounding));
    if (!(steps < mostShaftLines)) reject("step_hz", parameters.step_hz, LT_TEXT("Engine", "at most a million lines"));
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>(steps) + 1);
    for (double i = 0; i <= steps; ++i) result.push_back(from_hz + i * parameters.step_hz);
    return result;
}

Material materialOf(const Shaft& shaft, UsedValues& used, Notes& notes)
{
    Material material = shaft.material.value_or(Material{});
    for (const Field<Material>& field : fields<Material>())
        addUsed(used, field.info, field.get(material), shaft.material ? ValueOrigin::File : ValueOrigin::Assumed);
    if (!shaft.material && !contains(notes, notes::materialAssumed))
        notes.push_back({notes::materialAssumed,
                         {{"elastic_modulus_MPa", material.elastic_modulus_MPa},
                          {"poisson_ratio", material.poisson_ratio},
                          {"density_kg_m3", material.density_kg_m3},
                          {"loss_factor", material.loss_factor}}});
    return material;
}

Frf receptanceOf(const Shaft& shaft, const Material& material, const ReceptanceParameters& parameters,
                 const ShaftHolding& holding, const Progress& progress, LinesOf lines)
{
    const std::optional<SpindleReceptance>& spindle = holding.spindle;
    Frf frf;
    frf.name = shaft.name;
    frf.frequency_hz = linesOf(
        withinLines(lines == LinesOf::Refined ? forLimits(shaft, material, parameters, holding) : parameters, spindle));
    if (spindle) checkReach(*spindle, frf.frequency_hz);
    const std::vector<double> places_z_mm{parameters.respond_z_mm, parameters.excite_z_mm, shaft.length_mm()};
    const beam::BeamReceptance prepared(
        beam::beamModel(shaft, material, beamParametersOf(parameters, holding, shaft.length_mm(), false), places_z_mm));
    const auto values_at = [&](const std::vector<double>& frequency_hz, const Progress& part) {
        std::vector<Complex> value(frequency_hz.size());
        parallelFor(frequency_hz.size(), linesPerShaftTask, part, [&](std::size_t begin, std::size_t end) {
            beam::BeamReceptance mine = prepared;
            std::array<ReceptanceMatrix, places * places> g;
            for (std::size_t line = begin; line < end; ++line) {
                const double f = frequency_hz[line];
                if (spindle)
                    receptancesOnSpindle(mine, spindle->at(f), places - 1, f, g);
                else
                    mine.at(f, g);
                value[line] = g[1](0, 0);
            }
        });
        return value;
    };
    if (lines == LinesOf::Parameters) {
        frf.value = values_at(frf.frequency_hz, progress);
    } else {
        frf.value = values_at(frf.frequency_hz, progress.part(0, 0.8));
        refineLines(frf, [&](const std::vector<double>& more) { return values_at(more, progress.quiet()); });
    }
    return frf;
}

ShaftReceptanceResult shaftReceptance(const Shaft& shaft, const ReceptanceParameters& parameters,
                                      const std::optional<SpindleReceptance>& spindle, const Progress& progress,
                                      LinesOf lines)
{
    return heldShaftReceptance(shaft, parameters, {spindle, {}}, progress, lines);
}

ShaftReceptanceResult heldShaftReceptance(const Shaft& shaft, const ReceptanceParameters& parameters,
                                          const ShaftHolding& holding, const Progress& progress, LinesOf lines)
{
    const std::optional<SpindleReceptance>& spindle = holding.spindle;
    ShaftReceptanceResult result;
    result.length_mm = shaft.length_mm();
    noteUnusualHolding(shaft, holding, result.notes);
    const Material material = materialOf(shaft, result.used, result.notes);
    result.parameters =
        withinLines(lines == LinesOf::Refined ? forLimits(shaft, material, parameters, holding) : parameters, spindle);
    result.frf = receptanceOf(shaft, material, parameters, holding, progress, lines);
    progress.report(0.7);
    if (!spindle || spindle->springs())
        result.natural_frequencies_hz = beam::naturalFrequencies(
            beam::beamModel(shaft, material, beamParametersOf(parameters, holding, result.length_mm, true), {}),
            *result.parameters.to_hz, progress.part(0.7, 1));
    else
        result.notes.push_back({notes::spindleHasNoModes, {}});
    progress.report(1);
    return result;
}

}  // namespace lathelier::receptance
