#include "engine/receptance/modal/modal_report.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/receptance/modal/modal_plots.h"
#include "engine/receptance/modal/modal_quantities.h"
#include "engine/receptance/receptance_units.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t mostFindings = 3;

report::Finding findingOf(const ShownMode& mode, const Language& language)
{
    return {LT_TEXT("Engine", "{rank}. {frequency} Hz: {flexibility} nm/N · ζ {damping} %"),
            {{"rank", std::int64_t{mode.rank}},
             {"frequency", fixed(mode.mode.frequency_hz, 1, language)},
             {"flexibility", fixed(mode.flexibility_nm_N, 1, language)},
             {"damping", fixed(100 * mode.mode.damping_ratio, 2, language)}},
            {},
            {}};
}

report::QuantityTable residualsTable(const ResponseStudy& study)
{
    const Text low = LT_TEXT("Engine", "mm/(N·s²)"), high = LT_TEXT("Engine", "nm/N");
    const Text uncertainty = LT_TEXT("Engine", "Its standard uncertainty");
    return {LT_TEXT("Engine", "Residuals"),
            {{LT_TEXT("Engine", "Of modes below, 1/M"), study.model.residuals.lower_mm_Ns2, low, 4},
             {uncertainty, study.fit->lower_uncertainty_mm_Ns2, low, 4},
             {LT_TEXT("Engine", "Of modes above, 1/K"), nm_per_mm * study.model.residuals.upper_mm_N, high, 3},
             {uncertainty, nm_per_mm * study.fit->upper_uncertainty_mm_N, high, 3}}};
}

/// Without modes: the frequency of the least real part.
report::Answer plainAnswer(const Frf& frf, const Language& language)
{
    report::Answer answer;
    answer.verdict_words = LT_TEXT("Engine", "computed");
    answer.quantity = LT_TEXT("Engine", "Frequency of the least real part");
    const auto least = std::min_element(
        frf.value.begin(), frf.value.end(),
        [](const std::complex<double>& a, const std::complex<double>& b) { return a.real() < b.real(); });
    if (least == frf.value.end()) return answer;
    answer.value = frf.frequency_hz[static_cast<std::size_t>(least - frf.value.begin())];
    answer.unit = unit::hz;
    answer.decimals = 2;
    answer.sentence = LT_TEXT("Engine", "Least real part {real} nm/N · lines: {lines}");
    answer.values = {{"real", fixed(nm_per_mm * least->real(), 2, language)},
                     {"lines", static_cast<std::int64_t>(frf.value.size())}};
    return answer;
}

}  // namespace

report::Answer answer(const ResponseStudy& study, const Language& language)
{
    if (!study.fit || study.model.modes.empty()) return plainAnswer(study.basis() ? *study.basis() : Frf{}, language);
    std::vector<ShownMode> modes = shownModes(study);
    std::stable_sort(modes.begin(), modes.end(),
                     [](const ShownMode& a, const ShownMode& b) { return a.rank < b.rank; });
    const ShownMode& first = modes.front();
    report::Answer answer;
    answer.verdict_words = study.is_changed ? LT_TEXT("Engine", "changed by hand") : LT_TEXT("Engine", "fitted");
    answer.quantity = LT_TEXT("Engine", "Dominant mode");
    answer.value = first.mode.frequency_hz;
    if (first.frequency_uncertainty_hz) answer.expanded_uncertainty = 2 * *first.frequency_uncertainty_hz;
    answer.unit = unit::hz;
    answer.decimals = 2;
    answer.sentence =
        LT_TEXT("Engine", "ζ {damping} % · k {stiffness} N/mm · error of the model {error} % (rms) · modes: {modes}");
    answer.values = {{"damping", fixed(100 * first.mode.damping_ratio, 2, language)},
                     {"stiffness", fixed(first.mode.stiffness_N_mm, 0, language)},
                     {"error", fixed(study.error_rms_percent, 2, language)},
                     {"modes", static_cast<std::int64_t>(modes.size())}};
    for (std::size_t k = 0; k < std::min(mostFindings, modes.size()); ++k)
        answer.findings.push_back(findingOf(modes[k], language));
    return answer;
}

report::Table modesTable(const ResponseStudy& study)
{
    std::vector<const char*> keys{"rank",
                                  "frequency_hz",
                                  "frequency_uncertainty_hz",
                                  "damping_percent",
                                  "damping_uncertainty_percent",
                                  "stiffness_N_mm",
                                  "stiffness_uncertainty_N_mm"};
    const bool has_phase = std::any_of(study.model.modes.begin(), study.model.modes.end(),
                                       [](const ModalMode& mode) { return mode.phase_deg != 0; });
    if (has_phase) keys.push_back("phase_deg");
    keys.push_back("flexibility_nm_N");
    return report::listTable<ShownMode>(LT_TEXT("Engine", "Modes"), shownModes(study), keys);
}

report::Table shapesTable(const ResponseStudy& study, const Language& language)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Stiffness of every response by mode, N/mm");
    table.columns = {LT_TEXT("Engine", "Response"), LT_TEXT("Engine", "Error, %")};
    table.decimals = {0, 2};
    for (const FittedMode& mode : study.common.front().fit->modes) {
        table.columns.emplace_back(fill(text(LT_TEXT("Engine", "{frequency} Hz"), language),
                                        {{"frequency", fixed(mode.mode.frequency_hz, 1, language)}}, language));
        table.decimals.push_back(0);
    }
    for (const CommonFit& one : study.common) {
        std::vector<Value> row{one.name, one.fit->error_rms_percent};
        for (const FittedMode& mode : one.fit->modes) row.emplace_back(mode.mode.stiffness_N_mm);
        table.rows.push_back(std::move(row));
    }
    return table;
}

report::Document responseReport(const ResponseStudy& study, const Notes& notes, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Frequency response and its modes");
    report::Section result{LT_TEXT("Engine", "Result"), {answer(study, language)}};
    if (study.fit && !study.model.modes.empty()) {
        result.blocks.push_back(modesTable(study));
        result.blocks.push_back(residualsTable(study));
        if (!study.common.empty()) result.blocks.push_back(shapesTable(study, language));
    }
    if (!notes.empty()) result.blocks.push_back(notes);
    document.sections.push_back(std::move(result));
    document.sections.push_back({LT_TEXT("Engine", "Frequency response"),
                                 {magnitudePlot(study, false, language), phasePlot(study), realPlot(study, language),
                                  imaginaryPlot(study), nyquistPlot(study)}});
    std::vector<report::Block>& charts = document.sections.back().blocks;
    if (report::Plot coherence = coherencePlot(study); !coherence.curves.empty())
        charts.emplace_back(std::move(coherence));
    if (!study.fit) return document;
    charts.emplace_back(errorPlot(study));
    charts.emplace_back(stabilisationPlot(study, language));
    const Text words = LT_TEXT(
        "Engine",
        "Modes with viscous damping, G = Σ (1/k)/(1 - r² + 2iζr) - 1/(ω²M) + 1/K, r = f/f_n: linear fits of ascending "
        "order and matched filters give the starts, Gauss and Newton refine all parameters with weights from the noise "
        "of the lines, or from the errors of the fit where it is not known. A mode without which the fit is no worse "
        "than noise explains is left out. Uncertainties are standard uncertainties from the covariance.");
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::Paragraph{words, {}}, report::parametersTable(study.fit->parameters, language)}});
    return document;
}

}  // namespace lathelier::receptance
