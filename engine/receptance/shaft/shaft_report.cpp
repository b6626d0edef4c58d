#include "engine/receptance/shaft/shaft_report.h"

#include <cmath>

#include "engine/core/texts.h"
#include "engine/receptance/receptance_report.h"
#include "engine/receptance/receptance_units.h"
#include "engine/receptance/shaft/shaft_plots.h"

namespace lathelier::receptance {
namespace {

report::Table segmentsTable(const Shaft& shaft)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Segments, from the free end");
    for (const FieldInfo& column : infos<ShaftSegment>())
        table.columns.emplace_back(report::Labelled{column.label, column.unit});
    table.rows.reserve(shaft.segments.size());
    for (const ShaftSegment& segment : shaft.segments) {
        std::vector<Value> row;
        for (auto& [key, value] : toValues(segment)) row.push_back(std::move(value));
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

report::Table frequenciesTable(const std::vector<double>& frequencies_hz)
{
    report::Table table;
    table.title = LT_TEXT("Engine", "Natural frequencies, undamped");
    table.columns = {LT_TEXT("Engine", "mode"), LT_TEXT("Engine", "frequency (Hz)")};
    table.decimals = {0, 2};
    table.rows.reserve(frequencies_hz.size());
    for (std::size_t i = 0; i < frequencies_hz.size(); ++i)
        table.rows.push_back({static_cast<std::int64_t>(i + 1), frequencies_hz[i]});
    return table;
}

report::Answer answer(const ShaftStudy& study, const Language& language)
{
    report::Answer result = answer(study.response, language);
    if (result.value) result.decimals = 1;
    report::Finding mass{LT_TEXT("Engine", "Mass {mass} kg, length {length_mm:1} mm"),
                         {{"mass", fixed(study.mass_kg, 3, language)}, {"length_mm", study.response.length_mm}},
                         {},
                         {}};
    report::Finding compliance{LT_TEXT("Engine", "Not held: no static compliance"), {}, {}, {}};
    if (study.static_mm_N) {
        compliance.pattern = LT_TEXT("Engine", "Static compliance {compliance} nm/N");
        compliance.values = {{"compliance", fixed(nm_per_mm * *study.static_mm_N, 1, language)}};
    } else if (!study.response.natural_frequencies_hz) {
        compliance.pattern = LT_TEXT("Engine", "Static compliance not known: the spindle is a table of receptances");
    }
    result.findings = {std::move(compliance), std::move(mass)};
    return result;
}

report::Document shaftReport(const ShaftStudy& study, const Shaft& shaft, const ShaftHolding& holding,
                             const Language& language)
{
    report::Document document = frfReport(study.response, language);
    document.title = LT_TEXT("Engine", "Shaft in bending");
    document.sections.front().blocks.front() = answer(study, language);
    report::Section drawing{LT_TEXT("Engine", "Shaft"),
                            {shaftDrawing(shaft, holding, false, language), segmentsTable(shaft)}};
    if (!study.modes.empty()) drawing.blocks.push_back(modeShapesPlot(study, 1, language));
    document.sections.insert(document.sections.begin() + 1, std::move(drawing));
    return document;
}

}  // namespace lathelier::receptance
