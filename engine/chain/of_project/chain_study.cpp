#include "engine/chain/of_project/chain_study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/chain/chain_codes.h"
#include "engine/chain/dossier_report.h"
#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/deflection/influences.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"

namespace lathelier::chain {
namespace {

constexpr std::size_t mostFaults = 5;

std::optional<Proof> readProof(const std::string& folder, const Dossier& dossier)
{
    const ChainStep* const step = dossier.step("proof");
    if (!step || step->state != StepState::Done) return std::nullopt;
    try {
        const io::FileBytes bytes((std::filesystem::path(folder) / step->result).string());
        return proofFrom(Json::parse(bytes.view(), nullptr, false));
    } catch (const Error&) {
        return std::nullopt;  // reported by the check of the dossier
    }
}

void addFit(ChainOutcome& outcome, const Progress& progress)
{
    try {
        outcome.fit =
            fitMachine(outcome.settings.folder, *outcome.dossier, *outcome.proof, outcome.settings.fit, progress);
        if (outcome.fit)
            outcome.notes.insert(outcome.notes.end(), outcome.fit->found.notes.begin(), outcome.fit->found.notes.end());
    } catch (const Error& error) {
        outcome.notes.push_back({notes::fitRefused, {{"reason", text(error)}}});
    }
}

/// Prediction against the copy; a copy out of its limit is not a proof, even if it was predicted well.
report::Answer proofAnswer(const Proof& proof, const std::optional<report::Finding>& copy)
{
    constexpr std::size_t most_rows = 3;
    report::Answer answer;
    answer.quantity = LT_TEXT("Engine", "Prediction and copy differ by");
    std::vector<ComparedError> places = proof.places;
    const auto size = [](const ComparedError& place) { return std::abs(place.normalized_error); };
    std::stable_sort(places.begin(), places.end(),
                     [&](const ComparedError& a, const ComparedError& b) { return size(a) > size(b); });
    if (copy) answer.findings.push_back(*copy);
    std::int64_t disagreeing = 0;
    for (const ComparedError& place : places) {
        if (!(size(place) > 1)) continue;
        if (++disagreeing > static_cast<std::int64_t>(most_rows)) continue;
        answer.findings.push_back(
            {LT_TEXT("Engine", "Row {row}: measured {measured:1} µm, predicted {predicted:1} µm, E_n {error:2}"),
             {{"row", place.row},
              {"measured", place.measured_um},
              {"predicted", place.predicted_um},
              {"error", place.normalized_error}},
             Verdict::Fail,
             {Interval{place.z_start_mm, place.z_end_mm}, {}, {}, {}}});
    }
    // |E_n| <= 1, said in micrometres: the difference against both uncertainties together.
    const ComparedError& worst = places.front();
    answer.value = std::abs(worst.measured_um - worst.predicted_um);
    answer.upper_limit = std::hypot(worst.measured_uncertainty_um, worst.predicted_uncertainty_um);
    answer.unit = micrometre;
    answer.decimals = 1;
    const bool is_out = copy && copy->verdict == Verdict::Fail;
    answer.verdict = disagreeing == 0 && !is_out ? Verdict::Pass : Verdict::Fail;
    if (disagreeing == 0 && !is_out && copy && copy->verdict == Verdict::Undecided) answer.verdict = Verdict::Undecided;
    answer.verdict_words = disagreeing > 0 ? LT_TEXT("Engine", "✗ prediction disagrees with the copy")
                           : is_out        ? LT_TEXT("Engine", "✗ predicted well, but the copy is out of its limit")
                           : answer.verdict == Verdict::Undecided
                               ? LT_TEXT("Engine", "? predicted well; the copy's limit is not decided")
                               : LT_TEXT("Engine", "✓ prediction agrees with the copy");
    answer.sentence = LT_TEXT("Engine", "|E_n| {error:2} · {agreeing} of {rows} rows agree within both uncertainties.");
    const auto rows = static_cast<std::int64_t>(places.size());
    answer.values = {{"error", size(worst)}, {"agreeing", rows - disagreeing}, {"rows", rows}};
    return answer;
}

}  // namespace

ChainOutcome chainOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    ChainOutcome outcome;
    outcome.settings = fromValues<ChainSettings>(state.parameters);
    const std::string& folder = outcome.settings.folder;
    outcome.dossier = stores.of<ChainMemory>()->find(folder, progress.part(0, 0.1));
    if (!outcome.dossier)
        throw Error(errors::chainInputMissing, {{"what", LT_TEXT("Engine", "a chain that was run in this folder")}});
    const std::string path = (std::filesystem::path(folder) / dossierFile).string();
    std::error_code ignored;
    outcome.file = {path, static_cast<std::int64_t>(std::filesystem::file_size(path, ignored)),
                    dossierDigest(folder, progress)};
    outcome.check = checkDossier(path, progress.part(0.1, 0.5));
    outcome.notes = outcome.dossier->notes;
    outcome.synthetic = contains(outcome.notes, notes::syntheticData);
    for (const DossierFault& fault : outcome.check.faults) {
        if (outcome.notes.size() - outcome.dossier->notes.size() == mostFaults) break;
        const std::string name = std::filesystem::path(fault.path).filename().string();
        Note note{notes::chainFileChanged, {{"step", titleOf(fault.step)}, {"path", name}}};
        if (fault.what == "number") {
            note.code = notes::chainNumberChanged;
            set(note.values, "place", fault.place);
        }
        outcome.notes.push_back(std::move(note));
    }
    outcome.proof = readProof(folder, *outcome.dossier);
    if (outcome.proof) addFit(outcome, progress.part(0.5, 1, LT_TEXT("Engine", "Fitting")));
    return outcome;
}

report::Answer answerOf(const ChainOutcome& outcome)
{
    report::Answer answer;
    if (outcome.proof && !outcome.proof->places.empty())
        answer = proofAnswer(*outcome.proof, copyFinding(*outcome.dossier));
    else
        answer = chain::answer(*outcome.dossier);
    if (outcome.check.faults.empty()) return answer;
    // A number whose source has changed is not a proof.
    answer.verdict = Verdict::Undecided;
    answer.verdict_words = LT_TEXT("Engine", "? the files are not those of the dossier");
    answer.findings.insert(answer.findings.begin(),
                           {LT_TEXT("Engine", "Files or numbers that differ from the dossier: {count}"),
                            {{"count", static_cast<std::int64_t>(outcome.check.faults.size())}},
                            Verdict::Undecided,
                            {}});
    return answer;
}

report::Table fitTable(const MachineFit& fit)
{
    report::Table table{LT_TEXT("Engine", "Fitted to the copy"),
                        {LT_TEXT("Engine", "Quantity"), LT_TEXT("Engine", "Before"), LT_TEXT("Engine", "After"),
                         LT_TEXT("Engine", "Factor"), LT_TEXT("Engine", "Standard uncertainty [%]")},
                        {},
                        {0, 2, 2, 3, 1}};
    for (const deflection::IdentifiedFactor& factor : fit.found.factors) {
        const bool has_value = factor.influence != deflection::Influence::Forces;
        table.rows.push_back({deflection::nameOf(factor.influence).name,
                              has_value ? Value(factor.value / factor.factor) : Value(),
                              has_value ? Value(factor.value) : Value(), factor.factor, factor.uncertainty_percent});
    }
    table.rows.push_back(
        {LT_TEXT("Engine", "RMS of the diameters [µm]"), fit.found.rms_before_um, fit.found.rms_after_um, {}, {}});
    return table;
}

report::Plot plotOf(const ChainOutcome& outcome)
{
    report::Plot plot = proofPlot(*outcome.proof);
    if (!outcome.fit) return plot;
    report::Curve fitted;
    fitted.name = LT_TEXT("Engine", "fitted to the copy");
    fitted.colour = report::ColourRole::Limit;
    std::vector<std::pair<double, double>> places;
    for (const deflection::ComparedDiameter& place : outcome.fit->found.diameters)
        places.emplace_back(place.z_mm - outcome.fit->zero_mm, place.after_um);
    std::sort(places.begin(), places.end());
    for (const auto& [z_mm, error_um] : places) {
        fitted.x.push_back(z_mm);
        fitted.y.push_back(error_um);
    }
    plot.curves.push_back(std::move(fitted));
    return plot;
}

report::Document reportOf(const ChainOutcome& outcome)
{
    report::Document document = dossierReport(*outcome.dossier);
    if (outcome.fit)
        document.sections.push_back(
            {LT_TEXT("Engine", "Stiffness and forces from the copy"), {plotOf(outcome), fitTable(*outcome.fit)}});
    document.inputs = {outcome.file};
    for (const ChainStep& step : outcome.dossier->steps)
        for (const InputFile& file : step.inputs)
            if (std::filesystem::path(file.path).is_absolute() &&
                std::none_of(document.inputs.begin(), document.inputs.end(),
                             [&](const InputFile& known) { return known.path == file.path; }))
                document.inputs.push_back(file);
    document.synthetic = outcome.synthetic;
    return document;
}

}  // namespace lathelier::chain
