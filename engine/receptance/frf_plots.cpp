#include "engine/receptance/frf_plots.h"

#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"

namespace lathelier::receptance {

report::Axis frequencyAxis()
{
    return {LT_TEXT("Engine", "Frequency"), unit::hz};
}

report::Plot magnitudePlot(const Frf& frf)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Magnitude of the receptance");
    plot.x = {LT_TEXT("Engine", "Frequency"), unit::hz, report::Axis::Scale::Logarithmic};
    plot.y = {LT_TEXT("Engine", "Magnitude"), LT_TEXT("Engine", "mm/N"), report::Axis::Scale::Logarithmic};
    report::Curve curve{{}, frf.frequency_hz, {}};
    for (const auto& value : frf.value) curve.y.push_back(std::abs(value));
    plot.curves = {std::move(curve)};
    return plot;
}

report::Plot realImaginaryPlot(const Frf& frf, std::optional<double> least_hz, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Real and imaginary part of the receptance");
    plot.x = frequencyAxis();
    plot.y = {LT_TEXT("Engine", "Receptance"), LT_TEXT("Engine", "µm/N")};
    report::Curve real{LT_TEXT("Engine", "real part"), frf.frequency_hz, {}};
    report::Curve imaginary{LT_TEXT("Engine", "imaginary part"), frf.frequency_hz, {}};
    for (const auto& value : frf.value) {
        real.y.push_back(1000 * value.real());
        imaginary.y.push_back(1000 * value.imag());
    }
    plot.curves = {std::move(real), std::move(imaginary)};
    if (least_hz)
        plot.limits.push_back({report::Limit::Direction::Vertical, *least_hz,
                               fill(text(LT_TEXT("Engine", "least real part, {frequency} Hz"), language),
                                    {{"frequency", fixed(*least_hz, 1, language)}}, language)});
    return plot;
}

}  // namespace lathelier::receptance
