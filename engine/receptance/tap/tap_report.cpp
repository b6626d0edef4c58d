#include "engine/receptance/tap/tap_report.h"

#include <nlohmann/json.hpp>
#include <numeric>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/receptance/frf_plots.h"
#include "engine/receptance/tap/tap_plots.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t mostHitFindings = 3;

Value wordsOf(const ShownHit& shown)
{
    return shown.hit.fault == HitFault::None ? Value() : Value(words(shown.hit.fault));
}

Value keyOf(const ShownHit& shown)
{
    return shown.hit.fault == HitFault::None ? Value() : Value(std::string(key(shown.hit.fault)));
}

const char* quantityKey(FrfQuantity measured)
{
    if (measured == FrfQuantity::Receptance) return "displacement";
    return measured == FrfQuantity::Mobility ? "velocity" : "acceleration";
}

double blockOf_s(const TapResult& result)
{
    return static_cast<double>(result.samples) / result.rate_hz;
}

Json receptanceJson(const Frf& frf)
{
    std::vector<double> real, imaginary;
    for (const auto& value : frf.value) {
        real.push_back(value.real());
        imaginary.push_back(value.imag());
    }
    return {{"frequency_hz", numbers(frf.frequency_hz)},
            {"real_mm_N", numbers(real)},
            {"imag_mm_N", numbers(imaginary)},
            {"coherence", frf.coherence.empty() ? Json() : numbers(frf.coherence)}};
}

report::QuantityTable settingsTable(const TapResult& result)
{
    report::QuantityTable table{
        LT_TEXT("Engine", "Lines and windows"),
        {{LT_TEXT("Engine", "Block"), blockOf_s(result), unit::s, 4},
         {LT_TEXT("Engine", "Sampling rate"), result.rate_hz, unit::hz, 1},
         {LT_TEXT("Engine", "Distance of the lines"), result.resolution_hz, unit::hz, 4},
         {LT_TEXT("Engine", "Lines"), static_cast<std::int64_t>(result.response.value.size()), {}, 0},
         {LT_TEXT("Engine", "Usable from"), result.usable_from_hz, unit::hz, 2},
         {LT_TEXT("Engine", "Usable up to"), result.usable_to_hz, unit::hz, 2},
         {LT_TEXT("Engine", "Decay added by the window"), result.window_decay_1_s, LT_TEXT("Engine", "1/s"), 4}}};
    return table;
}

}  // namespace

std::vector<ShownHit> shownHits(const TapStudy& study)
{
    std::vector<ShownHit> shown;
    for (const TapHit& hit : study.result.hits)
        shown.push_back({static_cast<std::int64_t>(shown.size()) + 1, study.names[hit.record], hit});
    return shown;
}

const std::vector<QuantityOf<ShownHit>>& quantitiesOf(const ShownHit*)
{
    using H = ShownHit;
    static const auto all = describedBy<H>(
        quantity<H>("number", &H::number, {LT_TEXT("Engine", "Hit"), {}, 0}),
        quantity<H>("record", &H::record, {LT_TEXT("Engine", "Record")}),
        quantity<H>("time_s", [](const H& h) { return h.hit.time_s; }, {LT_TEXT("Engine", "Time"), unit::s, 4}),
        quantity<H>("peak_N", [](const H& h) { return h.hit.peak_N; },
                    {LT_TEXT("Engine", "Peak force"), unit::newton, 1}),
        quantity<H>("second_percent", [](const H& h) { return h.hit.second_percent; },
                    {LT_TEXT("Engine", "Second pulse"), unit::percent, 1}),
        quantity<H>("second_s", [](const H& h) { return h.hit.second_s; }, {LT_TEXT("Engine", "Its time"), unit::s, 4}),
        quantity<H>("used", [](const H& h) { return h.hit.used; }, {LT_TEXT("Engine", "Used")}),
        quantity<H>("reason", keyOf),
        quantity<H>("reason_words", wordsOf, {LT_TEXT("Engine", "Reason"), {}, 0, false}));
    return all;
}

Json toJson(const TapStudy& study)
{
    const TapResult& result = study.result;
    Json json;
    json["quantity"] = quantityKey(result.measured);
    json["averages"] = result.averages;
    json["hits"] = Json::array();
    for (const ShownHit& hit : shownHits(study)) json["hits"].push_back(nestedJson(describedValues(hit)));
    json["rate_hz"] = number(result.rate_hz);
    json["block_s"] = number(blockOf_s(result));
    json["block_samples"] = result.samples;
    json["resolution_hz"] = number(result.resolution_hz);
    json["lines"] = result.response.value.size();
    json["usable_from_hz"] = number(result.usable_from_hz);
    json["usable_to_hz"] = number(result.usable_to_hz);
    json["window_decay_1_s"] = number(result.window_decay_1_s);
    json["force_window_s"] = result.force_window_s > 0 ? number(result.force_window_s) : Json();
    json["receptance"] = receptanceJson(result.response);
    return json;
}

report::Answer answer(const TapStudy& study, const Language& language)
{
    const TapResult& result = study.result;
    report::Answer answer;
    answer.verdict_words = LT_TEXT("Engine", "measured");
    answer.quantity = LT_TEXT("Engine", "Response usable up to");
    answer.value = result.usable_to_hz;
    answer.unit = unit::hz;
    answer.decimals = 1;
    answer.values = {{"from", fixed(result.usable_from_hz, 1, language)},
                     {"used", static_cast<std::int64_t>(result.averages)},
                     {"hits", static_cast<std::int64_t>(result.hits.size())},
                     {"resolution", fixed(result.resolution_hz, 2, language)}};
    const std::vector<double>& coherence = result.response.coherence;
    if (!coherence.empty())
        answer.values.emplace_back("coherence", fixed(std::accumulate(coherence.begin(), coherence.end(), 0.0) /
                                                          static_cast<double>(coherence.size()),
                                                      4, language));
    answer.sentence =
        coherence.empty()
            ? LT_TEXT("Engine", "From {from} Hz · hits used: {used} of {hits} · a line every {resolution} Hz")
            : LT_TEXT("Engine",
                      "From {from} Hz · hits used: {used} of {hits} · a line every {resolution} Hz · mean coherence "
                      "{coherence}");
    for (const TapHit& hit : result.hits) {
        if (hit.used || answer.findings.size() == mostHitFindings) continue;
        answer.findings.push_back({LT_TEXT("Engine", "Hit at {time} s left out: {reason}"),
                                   {{"time", fixed(hit.time_s, 3, language)}, {"reason", words(hit.fault)}},
                                   {},
                                   {}});
    }
    return answer;
}

report::Table hitsTable(const TapStudy& study)
{
    std::vector<const char*> keys{"number", "time_s", "peak_N", "used", "reason_words", "second_percent", "second_s"};
    if (study.names.size() > 1) keys.insert(keys.begin() + 1, "record");
    return report::listTable<ShownHit>(LT_TEXT("Engine", "Hits"), shownHits(study), keys);
}

report::Document tapReport(const TapStudy& study, const Notes& notes, const Language& language)
{
    const TapResult& result = study.result;
    report::Document document;
    document.title = LT_TEXT("Engine", "Impact test");
    report::Section section{LT_TEXT("Engine", "Result"),
                            {answer(study, language), hitsTable(study), settingsTable(result)}};
    if (!notes.empty()) section.blocks.emplace_back(notes);
    document.sections.push_back(std::move(section));
    document.sections.push_back(
        {LT_TEXT("Engine", "Signals"),
         {tapForcePlot(study, language), tapMotionPlot(study, language), tapSpectrumPlot(result, language)}});
    std::vector<report::Block> charts{magnitudePlot(result.response), tapPhasePlot(result)};
    if (!result.coherence.empty()) charts.emplace_back(tapCoherencePlot(result, language));
    document.sections.push_back({LT_TEXT("Engine", "Frequency response"), std::move(charts)});
    const Text method = LT_TEXT(
        "Engine",
        "Spectra of force F and motion X, averaged over the hits: H1 = Σ X F* / Σ F F*, H2 = Σ X X* / Σ F X*, "
        "coherence |Σ X F*|² / (Σ F F* · Σ X X*). An exponential window moves the response from iω to iω + σ; velocity "
        "and acceleration become a displacement by division by that and its square.");
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::Paragraph{method, {}}, report::parametersTable(result.parameters, language)}});
    return document;
}

}  // namespace lathelier::receptance
