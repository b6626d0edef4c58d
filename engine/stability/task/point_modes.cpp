#include "engine/stability/task/point_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/receptance/modal/modal_fit.h"
#include "engine/stability/simulation/response_modes.h"
#include "engine/stability/simulation/response_poles.h"
#include "engine/stability/stability_codes.h"
#include "engine/stability/task/response_fit.h"
#include "engine/task/memo.h"

namespace lathelier::stability {
namespace {

constexpr double broadDamping = 0.25;  ///< of terms for modes outside the lines; their peak must not chatter
constexpr double aboveLines = 1.3;     ///< of a term for the modes above, over the last line
constexpr double belowLines = 0.2;     ///< of a term for those below, over the first line
constexpr double leastDamping = 5e-4;  ///< start value of a shaft without any
constexpr std::size_t linesOfModel = 400;

struct ComputedPoles : Memo<std::vector<Pole>> {};

Mode modeOf(const receptance::ModalMode& mode)
{
    const double phase = mode.phase_deg * std::numbers::pi / 180;
    const double real = std::max(std::cos(phase), 1e-9);
    return {mode.frequency_hz, mode.damping_ratio, mode.stiffness_N_mm / real, std::sin(phase) / real};
}

/// The fitted model on lines dense enough for its modes.
Frf onDenseLines(const receptance::UncertainModel& fit, const Interval& range_hz, const std::vector<Pole>& poles)
{
    std::vector<double> lines;
    for (std::size_t i = 0; i < linesOfModel; ++i)
        lines.push_back(range_hz.from +
                        (range_hz.to - range_hz.from) * static_cast<double>(i) / static_cast<double>(linesOfModel - 1));
    constexpr int around = 60;
    constexpr double widths = 15;
    for (const Pole& pole : poles)
        for (int i = -around; i <= around; ++i) {
            const double share = static_cast<double>(i) / around;
            const double f = pole.frequency_hz * (1 + widths * pole.damping_ratio * share * std::abs(share));
            if (f > range_hz.from && f < range_hz.to) lines.push_back(f);
        }
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return receptance::synthesised(fit.model, lines);
}

/// All of a fit. Residual terms and modes beyond the lines become what is right within them.
std::vector<Mode> modesOfFit(const receptance::UncertainModel& fit, const Interval& range_hz, double stiffness_N_mm)
{
    const receptance::ModalModel& model = fit.model;
    if (model.beyond.empty() && model.residuals.lower_mm_Ns2 == 0) {
        std::vector<Mode> modes;
        for (const receptance::ModalMode& mode : model.modes) modes.push_back(modeOf(mode));
        if (model.residuals.upper_mm_N != 0) modes.push_back(complianceMode(model.residuals.upper_mm_N));
        return modes;
    }
    std::vector<Pole> poles, broad;
    for (const receptance::ModalMode& mode : model.modes) poles.push_back({mode.frequency_hz, mode.damping_ratio});
    for (const receptance::ModalMode& mode : model.beyond)
        broad.push_back({mode.frequency_hz, std::max(mode.damping_ratio, broadDamping)});
    if (model.residuals.lower_mm_Ns2 != 0) broad.push_back({belowLines * range_hz.from, broadDamping});
    return modesThrough(onDenseLines(fit, range_hz, poles), poles, broad, stiffness_N_mm);
}

std::vector<Pole> startOf(const PointResponse& response)
{
    double loss = response.shaft->material.value_or(Material{}).loss_factor;
    if (const auto* const springs = response.holding.spindle ? response.holding.spindle->springs() : nullptr)
        loss = std::max(loss, springs->loss_factor);
    std::vector<Pole> start;
    for (const double f : response.natural_frequencies_hz) start.push_back({f, std::max(leastDamping, loss / 2)});
    return start;
}

std::vector<Mode> modesOfComputed(const PointResponse& response, double stiffness_N_mm, Stores& stores,
                                  std::int64_t& count, const Progress& progress)
{
    const Frf& frf = *response.frf;
    const auto poles = stores.of<ComputedPoles>()->find(
        response.basis, progress, [&](const Progress& finding) { return polesOf(frf, startOf(response), finding); });
    count = static_cast<std::int64_t>(poles->size());
    std::vector<Pole> broad{{aboveLines * frf.frequency_hz.back(), broadDamping}};
    if (frf.value.front().real() < 0)
        broad.push_back({belowLines * std::max(1.0, frf.frequency_hz.front()), broadDamping});
    return modesThrough(frf, *poles, broad, stiffness_N_mm);
}

}  // namespace

std::vector<Mode> modesOfPoint(const PointResponse& response, double stiffness_N_mm, Stores& stores, Notes& found,
                               const Progress& progress)
{
    if (!response.modes.empty()) return response.modes;
    std::vector<Mode> modes;
    std::int64_t count = 0;
    if (response.shaft) {
        modes = modesOfComputed(response, stiffness_N_mm, stores, count, progress);
    } else {
        receptance::UncertainModel model = response.model;
        if (!model.isKnown()) {
            const auto fit = fitOf(*response.frf, response.basis, stores, progress);
            found.insert(found.end(), fit->notes.begin(), fit->notes.end());
            model = receptance::uncertainModelOf(*fit);
        }
        const std::vector<double>& lines = response.frf->frequency_hz;
        const Interval range_hz = model.range_hz.value_or(Interval{lines.front(), lines.back()});
        count = static_cast<std::int64_t>(model.model.modes.size());
        if (count > 0 || !model.model.beyond.empty()) modes = modesOfFit(model, range_hz, stiffness_N_mm);
    }
    if (modes.empty() || !(highestFrequency(modes) > 0)) throw Error(errors::modesNeeded, {});
    found.push_back({response.shaft ? notes::modesComputed : notes::modesFitted,
                     {{"count", count}, {"error_percent", overallError_percent(modes, *response.frf)}}});
    return modes;
}

}  // namespace lathelier::stability
