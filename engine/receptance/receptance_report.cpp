#include "engine/receptance/receptance_report.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/receptance/frf_plots.h"
#include "engine/receptance/receptance_units.h"
#include "engine/receptance/receptance_verification.h"
#include "engine/receptance/shaft/shaft_report.h"
#include "engine/receptance/spindle/spindle_plots.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"

namespace lathelier::receptance {

report::Answer answer(const ShaftReceptanceResult& result, const Language& language)
{
    report::Answer answer;
    answer.used = result.used;
    answer.verdict_words = LT_TEXT("Engine", "computed");
    const Frf& frf = result.frf;
    std::size_t peak = 0;
    for (std::size_t i = 0; i < frf.value.size(); ++i)
        if (!(std::abs(frf.value[peak]) >= std::abs(frf.value[i]))) peak = i;
    if (result.natural_frequencies_hz && !result.natural_frequencies_hz->empty()) {
        answer.quantity = LT_TEXT("Engine", "First natural frequency");
        answer.value = result.natural_frequencies_hz->front();
        answer.unit = unit::hz;
        answer.decimals = 2;
    } else {
        answer.quantity = LT_TEXT("Engine", "Receptance");
    }
    if (frf.value.empty() || !std::isfinite(std::abs(frf.value[peak]))) return answer;
    answer.sentence = LT_TEXT("Engine", "Largest receptance {magnitude} nm/N at {frequency} Hz · lines: {lines}");
    answer.values = {{"magnitude", fixed(nm_per_mm * std::abs(frf.value[peak]), 2, language)},
                     {"frequency", fixed(frf.frequency_hz[peak], 1, language)},
                     {"lines", static_cast<std::int64_t>(frf.value.size())}};
    return answer;
}

report::Answer answer(const SpindleIdentification& result, const Language& language)
{
    report::Answer answer;
    answer.used = result.used;
    answer.verdict_words = LT_TEXT("Engine", "computed");
    answer.quantity = LT_TEXT("Engine", "Residual of the identification");
    answer.value = result.residual_rms_percent;
    answer.unit = unit::percent;
    answer.decimals = 2;
    answer.values = {{"responses", static_cast<std::int64_t>(result.frfs)},
                     {"lines", static_cast<std::int64_t>(result.frequency_hz.size())}};
    if (result.hold_out_rms_percent)
        answer.values.emplace_back("held_out", fixed(*result.hold_out_rms_percent, 2, language));
    answer.sentence =
        result.hold_out_rms_percent
            ? LT_TEXT("Engine", "Of the rod held out {held_out} % · responses: {responses} · lines: {lines}")
            : LT_TEXT("Engine", "Responses: {responses} · lines: {lines}");
    return answer;
}

report::Section frfSummary(const ShaftReceptanceResult& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(result, language)}};
    if (result.natural_frequencies_hz && !result.natural_frequencies_hz->empty())
        section.blocks.push_back(frequenciesTable(*result.natural_frequencies_hz));
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Section spindleSummary(const SpindleIdentification& result, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(result, language)}};
    if (!result.notes.empty()) section.blocks.push_back(result.notes);
    return section;
}

report::Document frfReport(const ShaftReceptanceResult& result, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Frequency response of a shaft");
    document.verification = {&receptanceVerification()};
    document.sections.push_back(frfSummary(result, language));
    document.sections.push_back({LT_TEXT("Engine", "Frequency response"),
                                 {magnitudePlot(result.frf), realImaginaryPlot(result.frf, {}, language)}});
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::Paragraph{
              LT_TEXT("Engine",
                      "Timoshenko's beam with shear and rotary inertia in closed form, piece by piece; on a "
                      "spindle joined at the chuck face by receptance coupling."),
              {}},
          report::parametersTable(result.parameters, language, result.used)}});
    return document;
}

report::Document spindleReport(const SpindleIdentification& result, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Receptance of a spindle");
    document.verification = {&receptanceVerification()};
    document.sections.push_back(spindleSummary(result, language));
    document.sections.push_back(
        {LT_TEXT("Engine", "Receptance of the chuck face"),
         {spindleMagnitudePlot(result.spindle), spindlePhasePlot(result.spindle), conditionPlot(result)}});
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::Paragraph{LT_TEXT("Engine",
                                    "Inverse receptance coupling line by line: a linear start from the motion of the "
                                    "joint, then weighted least squares on the measured responses."),
                            {}},
          report::parametersTable(result.parameters, language, result.used)}});
    return document;
}

}  // namespace lathelier::receptance
