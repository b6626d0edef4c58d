#include "engine/receptance/modal/modal_plots.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "engine/core/units.h"
#include "engine/receptance/frf_plots.h"

namespace lathelier::receptance {
namespace {

constexpr const char* handlePrefix = "mode.";
constexpr int measuredColour = 0, computedColour = 2, modelColour = 1;
using Part = std::function<double(const std::complex<double>&)>;

report::Curve curveOf(const Frf& frf, Text name, const Part& part, int colour)
{
    report::Curve curve{name, frf.frequency_hz, {}};
    curve.y.reserve(frf.value.size());
    for (const auto& value : frf.value) curve.y.push_back(part(value));
    curve.colour = colour;
    return curve;
}

/// The computed response below the measured one, the model on top.
report::Plot plotOf(const ResponseStudy& study, Text title, report::Axis y, const Part& part)
{
    report::Plot plot;
    plot.title = title;
    plot.x = frequencyAxis();
    plot.y = std::move(y);
    if (study.computed)
        plot.curves.push_back(curveOf(*study.computed, LT_TEXT("Engine", "computed"), part, computedColour));
    if (study.measured)
        plot.curves.push_back(curveOf(*study.measured, LT_TEXT("Engine", "measured"), part, measuredColour));
    if (!study.synthesised.value.empty()) {
        plot.curves.push_back(curveOf(
            study.synthesised,
            study.is_changed ? LT_TEXT("Engine", "modal model, changed by hand") : LT_TEXT("Engine", "modal model"),
            part, modelColour));
        plot.curves.back().style = report::Curve::Style::Dashed;
    }
    return plot;
}

double magnitudeAt(const ResponseStudy& study, double frequency_hz)
{
    return std::abs(receptanceOf(study.model, frequency_hz));
}

std::string hertz(double frequency_hz, const Language& language)
{
    return fill(text(LT_TEXT("Engine", "{frequency} Hz"), language), {{"frequency", fixed(frequency_hz, 1, language)}},
                language);
}

}  // namespace

std::string modeHandleKey(std::size_t index)
{
    return handlePrefix + std::to_string(index);
}

std::optional<std::size_t> modeOfHandle(const std::string& key)
{
    for (std::size_t index = 0; index < mostModes; ++index)
        if (key == modeHandleKey(index)) return index;
    return std::nullopt;
}

report::Plot magnitudePlot(const ResponseStudy& study, bool with_handles, const Language& language)
{
    report::Plot plot =
        plotOf(study, LT_TEXT("Engine", "Magnitude of the receptance"),
               {LT_TEXT("Engine", "Magnitude"), LT_TEXT("Engine", "mm/N"), report::Axis::Scale::Logarithmic},
               [](const std::complex<double>& value) { return std::abs(value); });
    if (study.synthesised.value.empty()) return plot;
    for (std::size_t k = 0; k < study.model.modes.size(); ++k) {
        const double f = study.model.modes[k].frequency_hz, size = magnitudeAt(study, f);
        if (!with_handles) {
            plot.marks.push_back({f, size, hertz(f, language)});
            continue;
        }
        report::Handle handle{modeHandleKey(k), report::Handle::Kind::Point, f, size, hertz(f, language)};
        handle.x_range = study.fit->range_hz;
        handle.y_range = Interval{size / 1000, size * 1000};
        plot.handles.push_back(std::move(handle));
    }
    return plot;
}

report::Plot phasePlot(const ResponseStudy& study)
{
    report::Axis axis{LT_TEXT("Engine", "Phase"), unit::deg};
    axis.range = Interval{-190, 190};
    return plotOf(study, LT_TEXT("Engine", "Phase of the receptance"), axis,
                  [](const std::complex<double>& value) { return std::arg(value) * 180 / std::numbers::pi; });
}

report::Plot realPlot(const ResponseStudy& study, const Language& language)
{
    report::Plot plot = plotOf(study, LT_TEXT("Engine", "Real part of the receptance"),
                               {LT_TEXT("Engine", "Real part"), LT_TEXT("Engine", "µm/N")},
                               [](const std::complex<double>& value) { return um_per_mm * value.real(); });
    const Frf* const basis = study.basis();
    if (!basis || basis->value.empty()) return plot;
    const auto least = std::min_element(
        basis->value.begin(), basis->value.end(),
        [](const std::complex<double>& a, const std::complex<double>& b) { return a.real() < b.real(); });
    const double f = basis->frequency_hz[static_cast<std::size_t>(least - basis->value.begin())];
    plot.limits.push_back({report::Limit::Direction::Vertical, f,
                           fill(text(LT_TEXT("Engine", "least real part, {frequency} Hz"), language),
                                {{"frequency", fixed(f, 1, language)}}, language)});
    return plot;
}

report::Plot imaginaryPlot(const ResponseStudy& study)
{
    return plotOf(study, LT_TEXT("Engine", "Imaginary part of the receptance"),
                  {LT_TEXT("Engine", "Imaginary part"), LT_TEXT("Engine", "µm/N")},
                  [](const std::complex<double>& value) { return um_per_mm * value.imag(); });
}

report::Plot nyquistPlot(const ResponseStudy& study)
{
    report::Plot plot = plotOf(study, LT_TEXT("Engine", "Nyquist plot of the receptance"),
                               {LT_TEXT("Engine", "Imaginary part"), LT_TEXT("Engine", "µm/N")},
                               [](const std::complex<double>& value) { return um_per_mm * value.imag(); });
    plot.x = {LT_TEXT("Engine", "Real part"), LT_TEXT("Engine", "µm/N")};
    plot.along = frequencyAxis();
    plot.equal_scales = true;
    const Frf* const order[] = {study.computed.get(), study.measured.get(),
                                study.synthesised.value.empty() ? nullptr : &study.synthesised};
    std::size_t at = 0;
    for (const Frf* frf : order) {
        if (!frf) continue;
        report::Curve& curve = plot.curves[at++];
        curve.along = std::move(curve.x);
        curve.x.clear();
        curve.x.reserve(frf->value.size());
        for (const auto& value : frf->value) curve.x.push_back(um_per_mm * value.real());
    }
    return plot;
}

report::Plot coherencePlot(const ResponseStudy& study)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Coherence");
    plot.x = frequencyAxis();
    plot.y = {LT_TEXT("Engine", "Coherence γ²"), {}};
    plot.y.range = Interval{0, 1.05};
    if (!study.measured || study.measured->coherence.empty()) return plot;
    report::Curve curve{LT_TEXT("Engine", "measured"), study.measured->frequency_hz, study.measured->coherence};
    curve.colour = measuredColour;
    plot.curves.push_back(std::move(curve));
    return plot;
}

report::Plot stabilisationPlot(const ResponseStudy& study, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Stability of the poles");
    plot.x = frequencyAxis();
    plot.y = {LT_TEXT("Engine", "Order of the fit, pairs of poles"), {}, report::Axis::Scale::Whole};
    if (!study.fit || study.fit->orders.empty()) return plot;
    plot.y.range = Interval{0, mostOrder + 1};
    plot.x.range = study.fit->range_hz;
    report::Curve wandering{LT_TEXT("Engine", "new"), {}, {}},
        frequency{LT_TEXT("Engine", "stable in frequency"), {}, {}},
        both{LT_TEXT("Engine", "stable in frequency and damping"), {}, {}};
    for (const OrderPole& pole : study.fit->orders) {
        report::Curve& curve = pole.is_damping_stable ? both : pole.is_stable ? frequency : wandering;
        curve.x.push_back(pole.frequency_hz);
        curve.y.push_back(pole.order);
    }
    int colour = 0;
    for (report::Curve* curve : {&both, &frequency, &wandering}) {
        curve->style = report::Curve::Style::Points;
        curve->colour = colour++;
        if (!curve->x.empty()) plot.curves.push_back(std::move(*curve));
    }
    for (const ModalMode& mode : study.model.modes)
        plot.limits.push_back(
            {report::Limit::Direction::Vertical, mode.frequency_hz, hertz(mode.frequency_hz, language)});
    return plot;
}

report::Plot errorPlot(const ResponseStudy& study)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Error of the modal model");
    plot.x = frequencyAxis();
    plot.y = {LT_TEXT("Engine", "Error"), unit::percent, report::Axis::Scale::Logarithmic};
    report::Curve curve{LT_TEXT("Engine", "modal model"), study.synthesised.frequency_hz, study.error_percent};
    curve.colour = modelColour;
    plot.curves.push_back(std::move(curve));
    return plot;
}

}  // namespace lathelier::receptance
