#include "engine/receptance/spindle/spindle_receptance.h"

#include <algorithm>

#include "engine/core/units.h"
#include "engine/receptance/receptance_codes.h"

namespace lathelier::receptance {
namespace {

ReceptanceMatrix symmetric(const Complex& H, const Complex& L, const Complex& P)
{
    ReceptanceMatrix result;
    result << H, L, L, P;
    return result;
}

ReceptanceMatrix receptanceAt(const SpindleSprings& springs, double /*frequency_hz*/)
{
    const Complex loss(1, springs.loss_factor);
    return symmetric(1.0 / (springs.radial_N_mm * loss), 0, 1.0 / (springs.tilt_N_mm_rad * loss));
}

ReceptanceMatrix receptanceAt(const SpindleTable& table, double frequency_hz)
{
    const std::vector<double>& f = table.frequency_hz;
    if (f.empty() || !(frequency_hz >= f.front() && frequency_hz <= f.back()))
        throw Error(errors::frequencyOutsideSpindle, {{"frequency_hz", frequency_hz},
                                                      {"from_hz", f.empty() ? Value() : Value(f.front())},
                                                      {"to_hz", f.empty() ? Value() : Value(f.back())}});
    const auto above = std::upper_bound(f.begin(), f.end(), frequency_hz);
    const auto last = static_cast<std::size_t>(above - f.begin()) - 1;
    if (above == f.end()) return symmetric(table.H_mm_N[last], table.L_mm_Nmm[last], table.P_rad_Nmm[last]);
    const double share = (frequency_hz - f[last]) / (*above - f[last]);
    const auto between = [&](const std::vector<Complex>& values) {
        return values[last] + share * (values[last + 1] - values[last]);
    };
    return symmetric(between(table.H_mm_N), between(table.L_mm_Nmm), between(table.P_rad_Nmm));
}

}  // namespace

const std::vector<Field<SpindleSprings>>& fieldsOf(const SpindleSprings*)
{
    using S = SpindleSprings;
    const auto label = [](Text name, Text help, Text unit) {
        Label result{name, help, unit};
        result.required = true;
        return result;
    };
    static const auto all = described<S>(
        field("radial_N_mm", &S::radial_N_mm, {1e-6, 1e12},
              label(LT_TEXT("Engine", "Radial stiffness"), LT_TEXT("Engine", "Of the chuck face against deflection."),
                    unit::N_mm)),
        field("tilt_N_mm_rad", &S::tilt_N_mm_rad, {1e-6, 1e15},
              label(LT_TEXT("Engine", "Tilt stiffness"), LT_TEXT("Engine", "Of the chuck face against rotation."),
                    LT_TEXT("Engine", "N·mm/rad"))),
        field(
            "loss_factor", &S::loss_factor, {0, 2},
            label(LT_TEXT("Engine", "Loss factor"), LT_TEXT("Engine", "Both springs are multiplied by 1 + iη."), {})));
    return all;
}

ReceptanceMatrix SpindleReceptance::at(double frequency_hz) const
{
    return std::visit([frequency_hz](const auto& known) { return receptanceAt(known, frequency_hz); }, source);
}

}  // namespace lathelier::receptance
