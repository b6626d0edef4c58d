#include "engine/stability/simulation/simulation_report.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"
#include "engine/stability/simulation/cut_views.h"
#include "engine/stability/simulation/simulation_files.h"
#include "engine/stability/stability_verification.h"

namespace lathelier::stability {
namespace {

constexpr std::size_t shownStretches = 2000;  ///< of a waveform

Text wordOf(CutVerdict cut)
{
    switch (cut) {
        case CutVerdict::Stable: return LT_TEXT("Engine", "stable");
        case CutVerdict::Chatter: return LT_TEXT("Engine", "chatter");
        case CutVerdict::Undecided: break;
    }
    return LT_TEXT("Engine", "undecided");
}

}  // namespace

const char* key(CutVerdict cut)
{
    return cut == CutVerdict::Stable ? "stable" : cut == CutVerdict::Chatter ? "chatter" : "undecided";
}

const std::vector<QuantityOf<SimulationResult>>& quantitiesOf(const SimulationResult*)
{
    using R = SimulationResult;
    static const auto all = describedBy<R>(
        quantity<R>("growth_per_revolution", &R::growth_per_revolution,
                    {LT_TEXT("Engine", "Growth per revolution"), {}, 4}),
        quantity<R>("growth_step_difference", &R::growth_step_difference,
                    {LT_TEXT("Engine", "Its change by half the time step"), {}, 5}),
        quantity<R>("verdict", [](const R& r) { return key(r.cut); }),
        quantity<R>("verdict_words", [](const R& r) { return wordOf(r.cut); },
                    {LT_TEXT("Engine", "Verdict"), {}, 0, false}),
        quantity<R>("frequency_hz", &R::frequency_hz, {LT_TEXT("Engine", "Frequency of the vibration"), unit::hz, 2}),
        quantity<R>("amplitude_mm", &R::amplitude_mm, {LT_TEXT("Engine", "Amplitude at the end"), unit::mm, 5}),
        quantity<R>("lost_contact_percent", &R::lost_contact_percent,
                    {LT_TEXT("Engine", "Time out of the cut at the end"), unit::percent, 1}),
        quantity<R>("static_deflection_mm", &R::static_deflection_mm,
                    {LT_TEXT("Engine", "Deflection of the steady cut"), unit::mm, 5}),
        quantity<R>("wave_turns", [](const R& r) { return r.waves.turns; },
                    {LT_TEXT("Engine", "Waves in a revolution"), {}, 3}),
        quantity<R>("duration_s", &R::seconds, {LT_TEXT("Engine", "Simulated time"), unit::s, 3}),
        quantity<R>("step_s", &R::step_s, {LT_TEXT("Engine", "Time step"), unit::s, 7}),
        quantity<R>("steps_per_revolution", &R::steps_per_revolution,
                    {LT_TEXT("Engine", "Time steps in a revolution"), {}, 0}),
        quantity<R>("model_error_percent", &R::model_error_percent,
                    {LT_TEXT("Engine", "Error of the modes at this frequency"), unit::percent, 2}),
        quantity<R>("model_error_overall_percent", &R::model_error_overall_percent,
                    {LT_TEXT("Engine", "Error of the modes over all lines"), unit::percent, 2}),
        quantity<R>("sound_full_scale_mm", &soundFullScale_mm,
                    {LT_TEXT("Engine", "Full scale of the sound"), unit::mm, 5}));
    return all;
}

report::Plot waveformPlot(const SimulationResult& result)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Deflection of the tool");
    plot.x = {LT_TEXT("Engine", "Time"), unit::s};
    plot.y = {LT_TEXT("Engine", "Deflection"), unit::mm};
    report::Curve curve;
    const std::vector<double>& x = result.deflection_mm;
    const std::size_t stretch = std::max<std::size_t>(1, x.size() / shownStretches);
    for (std::size_t begin = 0; begin < x.size(); begin += stretch) {
        const std::size_t end = std::min(x.size(), begin + stretch);
        const auto [least, largest] = std::minmax_element(x.begin() + static_cast<std::ptrdiff_t>(begin),
                                                          x.begin() + static_cast<std::ptrdiff_t>(end));
        const auto add = [&](auto at) {
            curve.x.push_back(static_cast<double>(at - x.begin() + 1) * result.step_s);
            curve.y.push_back(*at);
        };
        add(std::min(least, largest));
        if (least != largest) add(std::max(least, largest));
    }
    plot.curves = {std::move(curve)};
    plot.limits.push_back(
        {report::Limit::Direction::Horizontal, result.static_deflection_mm, LT_TEXT("Engine", "steady cut")});
    return plot;
}

report::Answer answer(const SimulationResult& result, const Language& language)
{
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Growth of the vibration per revolution");
    answer.verdict_words = wordOf(result.cut);
    answer.value = result.growth_per_revolution;
    answer.decimals = 3;
    answer.sentence = LT_TEXT("Engine", "{frequency} Hz · amplitude {amplitude} mm · out of the cut {lost} %");
    answer.values = {{"frequency", fixed(result.frequency_hz, 1, language)},
                     {"amplitude", fixed(result.amplitude_mm, 4, language)},
                     {"lost", fixed(result.lost_contact_percent, 1, language)}};
    return answer;
}

report::Section simulationSummary(const SimulationResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(result, language)}};
    section.blocks.push_back(report::quantityTable(
        LT_TEXT("Engine", "Simulated cut"), result,
        {"verdict_words", "growth_per_revolution", "growth_step_difference", "frequency_hz", "wave_turns",
         "amplitude_mm", "lost_contact_percent", "static_deflection_mm", "duration_s", "steps_per_revolution",
         "model_error_percent", "model_error_overall_percent"}));
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Document simulationReport(const SimulationResult& result, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Simulation of a cut");
    document.verification = {&stabilityVerification()};
    document.sections.push_back(simulationSummary(result, language));
    document.sections.push_back(
        {LT_TEXT("Engine", "Waveform"), {waveformPlot(result), wavesPlot(result, result.waves, language)}});
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::Paragraph{
              LT_TEXT("Engine",
                      "The modes go on exactly from step to step under a force that runs straight between them; the "
                      "chip is as thick as the feed and the waves of earlier revolutions leave it, and has no force "
                      "where the tool is out of the cut. The growth is that of the cut without loss of contact."),
              {}},
          report::parametersTable(result.parameters, language)}});
    return document;
}

}  // namespace lathelier::stability
