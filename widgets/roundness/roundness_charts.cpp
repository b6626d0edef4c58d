#include "widgets/roundness/roundness_charts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/core/language.h"

namespace lathelier::roundness_panel {

report::Table circleTable(const form::RoundnessResult& result)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Reference circles");
    table.columns = {LT_TEXT("Engine", "Circle"), std::string("RONt (µm)"),    LT_TEXT("Engine", "Radius (mm)"),
                     LT_TEXT("Engine", "x (mm)"), LT_TEXT("Engine", "y (mm)"), LT_TEXT("Engine", "Proved to (µm)")};
    table.decimals = {0, 3, 5, 5, 5, 6};
    for (const form::ReferenceCircle which : {form::ReferenceCircle::LSCI, form::ReferenceCircle::MZCI,
                                              form::ReferenceCircle::MICI, form::ReferenceCircle::MCCI}) {
        const form::FittedCircle& circle = result.circles.of(which);
        std::string label(name(which));
        if (which == result.parameters.circle) label += " ◀";
        table.rows.push_back({label, circle.RONt_um, circle.radius_mm, circle.centre_mm.x(), circle.centre_mm.y(),
                              circle.certified_gap_um ? Value(*circle.certified_gap_um) : Value()});
    }
    return table;
}

report::Table hintTable(const form::RoundnessResult& result)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "What the undulations say");
    table.columns = {std::string("UPR"), LT_TEXT("Engine", "Amplitude (µm)"), LT_TEXT("Engine", "Share (%)"),
                     LT_TEXT("Engine", "Usual cause")};
    table.decimals = {0, 3, 0, 0};
    for (const form::RoundnessHint& hint : result.hints)
        table.rows.push_back({std::int64_t{hint.upr}, hint.amplitude_um, hint.share_percent, Value(hint.meaning)});
    return table;
}

plot::PolarPicturePtr withHarmonic(const plot::PolarPicturePtr& picture, const signal::Harmonic& harmonic)
{
    report::PolarPlot plot = picture->plot;
    report::PolarPlot::Trace wave;
    wave.name = std::to_string(harmonic.upr) + " UPR  " + screenNumber(harmonic.amplitude, 2).toStdString() + " µm";
    wave.colour = 5;  // none of the circles has it
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
    return plot::polarPicture(std::move(plot), 1);  // a part of the profile, not a second one
}

}  // namespace lathelier::roundness_panel
