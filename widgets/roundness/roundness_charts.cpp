#include "widgets/roundness/roundness_charts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/form/roundness/roundness_quantities.h"
#include "engine/report/quantity_table.h"
#include "widgets/core/language.h"

namespace lathelier::roundness_panel {

report::Table hintTable(const form::RoundnessResult& result)
{
    return report::listTable<form::RoundnessHint>(LT_TEXT("Engine", "What the undulations say"), result.hints,
                                                  {"upr", "amplitude_um", "share_percent", "meaning"});
}

plot::PolarPicturePtr withHarmonic(const plot::PolarPicturePtr& outcome, const signal::Harmonic& harmonic)
{
    report::PolarPlot plot = outcome->plot;
    report::PolarPlot::Trace wave;
    const QString amplitude = screenQuantity(harmonic.amplitude, micrometre, 2);
    wave.name = QString("%1 UPR  %2").arg(harmonic.upr).arg(amplitude).toStdString();
    wave.colour = 5;  // a colour not used by the circles
    // A wave runs about the least-squares circle, the first of them, whatever circle deviations count from.
    const auto ground_um = [&](double angle_deg) {
        return plot.circles.empty() ? 0 : plot::deviationAt(plot.circles.front(), plot.base_radius_mm, angle_deg);
    };
    const int samples = std::max(360, 16 * harmonic.upr);
    for (int i = 0; i < samples; ++i) {
        const double angle = 2 * std::numbers::pi * i / samples;
        wave.angle_deg.push_back(360.0 * i / samples);
        wave.deviation_um.push_back(ground_um(360.0 * i / samples) +
                                    harmonic.amplitude * std::cos(harmonic.upr * angle - harmonic.phase_rad));
    }
    plot.traces.push_back(std::move(wave));
    return plot::polarPicture(std::move(plot), 1);  // the last trace has no readout
}

}  // namespace lathelier::roundness_panel
