#include "engine/receptance/modal/response_study.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace lathelier::receptance {
namespace {

constexpr double leastDraggedDamping = 1e-5, mostDraggedDamping = 0.5;

/// The values of `frf` at `lines`, a subset of its frequencies.
std::vector<std::complex<double>> valuesOn(const Frf& frf, const std::vector<double>& lines)
{
    std::vector<std::complex<double>> values;
    values.reserve(lines.size());
    std::size_t at = 0;
    for (const double f : lines) {
        while (at + 1 < frf.frequency_hz.size() && frf.frequency_hz[at] < f) ++at;
        values.push_back(frf.value[at]);
    }
    return values;
}

}  // namespace

ResponseStudy studyResponse(FrfPtr measured, FrfPtr computed, std::shared_ptr<const ModalFit> fit,
                            const std::vector<ModalMode>& changed)
{
    ResponseStudy study;
    study.measured = std::move(measured);
    study.computed = std::move(computed);
    study.fit = std::move(fit);
    completeStudy(study, changed);
    return study;
}

void completeStudy(ResponseStudy& study, const std::vector<ModalMode>& changed)
{
    if (!study.fit || !study.basis()) return;
    study.model = study.fit->model;
    study.is_changed = !changed.empty();
    if (study.is_changed) study.model.modes = changed;
    const std::vector<double>& lines = study.fit->synthesised.frequency_hz;
    study.synthesised = synthesised(study.model, lines);
    const auto values = valuesOn(*study.basis(), lines);
    double error = 0, size = 0;
    study.error_percent.reserve(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double away = std::abs(study.synthesised.value[i] - values[i]), here = std::abs(values[i]);
        study.error_percent.push_back(here > 0 ? 100 * away / here : 0);
        if (!study.fit->stands_out[i]) continue;
        error += away * away;
        size += here * here;
    }
    study.error_rms_percent = size > 0 ? 100 * std::sqrt(error / size) : 0;
}

ModalMode draggedMode(const ModalModel& model, std::size_t index, double frequency_hz, double magnitude_mm_N)
{
    ModalModel others = model;
    ModalMode mode = others.modes.at(index);
    others.modes.erase(others.modes.begin() + static_cast<std::ptrdiff_t>(index));
    mode.frequency_hz = frequency_hz;
    // At r = 1 the mode is e q with q = 1/(2ζ): |background + e q| = magnitude is quadratic in q.
    const std::complex<double> background = receptanceOf(others, frequency_hz);
    const double phase = mode.phase_deg * std::numbers::pi / 180;
    const std::complex<double> e = std::polar(1.0, phase) / (mode.stiffness_N_mm * std::complex<double>(0, 1));
    const double half = (background * std::conj(e)).real() / std::norm(e);
    const double rest = (std::norm(background) - magnitude_mm_N * magnitude_mm_N) / std::norm(e);
    const double q = -half + std::sqrt(std::max(0.0, half * half - rest));
    mode.damping_ratio = std::clamp(q > 0 ? 1 / (2 * q) : mostDraggedDamping, leastDraggedDamping, mostDraggedDamping);
    return mode;
}

std::vector<std::size_t> byFlexibility(const std::vector<ModalMode>& modes)
{
    std::vector<std::size_t> order(modes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return flexibilityOf(modes[a]) > flexibilityOf(modes[b]); });
    return order;
}

}  // namespace lathelier::receptance
