#include "engine/receptance/modal/modal_model.h"

#include <cmath>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::receptance {

const std::vector<Field<ModalMode>>& fieldsOf(const ModalMode*)
{
    static const std::vector<Field<ModalMode>> all{
        field("frequency_hz", &ModalMode::frequency_hz, {1e-3, 1e6},
              Label{LT_TEXT("Engine", "f"), LT_TEXT("Engine", "Natural frequency, undamped."), unit::hz, false, true}),
        field("damping_ratio", &ModalMode::damping_ratio, {1e-6, 1},
              Label{LT_TEXT("Engine", "ζ"), LT_TEXT("Engine", "Damping ratio, of critical damping."), {}, false, true}),
        field("stiffness_N_mm", &ModalMode::stiffness_N_mm, {-1e12, 1e12},
              Label{LT_TEXT("Engine", "k"),
                    LT_TEXT("Engine",
                            "Modal stiffness, force over displacement at rest; negative between places out of phase."),
                    unit::N_mm, false, true}),
        field("phase_deg", &ModalMode::phase_deg, {-90, 90},
              Label{LT_TEXT("Engine", "Phase"), LT_TEXT("Engine", "Of the residue: 0 for a real normal mode."),
                    unit::deg})};
    return all;
}

std::complex<double> receptanceOf(const ModalMode& mode, double frequency_hz)
{
    const double r = frequency_hz / mode.frequency_hz;
    const double phase = mode.phase_deg * std::numbers::pi / 180;
    return std::complex<double>(std::cos(phase), r * std::sin(phase)) /
           (mode.stiffness_N_mm * std::complex<double>(1 - r * r, 2 * mode.damping_ratio * r));
}

std::complex<double> receptanceOf(const ModalModel& model, double frequency_hz)
{
    std::complex<double> sum = model.residuals.upper_mm_N;
    const double w = 2 * std::numbers::pi * frequency_hz;
    if (w > 0) sum -= model.residuals.lower_mm_Ns2 / (w * w);
    for (const ModalMode& mode : model.modes) sum += receptanceOf(mode, frequency_hz);
    for (const ModalMode& mode : model.beyond) sum += receptanceOf(mode, frequency_hz);
    return sum;
}

Frf synthesised(const ModalModel& model, const std::vector<double>& frequency_hz)
{
    Frf frf;
    frf.frequency_hz = frequency_hz;
    frf.value.reserve(frequency_hz.size());
    for (const double f : frequency_hz) frf.value.push_back(receptanceOf(model, f));
    return frf;
}

}  // namespace lathelier::receptance
