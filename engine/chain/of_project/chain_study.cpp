#include "engine/chain/of_project/chain_study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/chain/chain_codes.h"
#include "engine/chain/dossier_cover.h"
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

report::Document reportOf(const ChainOutcome& outcome, const Language& language)
{
    report::Document document = dossierReport(*outcome.dossier, language);
    document.sections.back().blocks.emplace_back(
        report::Paragraph{LT_TEXT("Engine", "dossier.json, which names all files: SHA-256 {sha256}."),
                          {{"sha256", outcome.file.sha256}}});
    if (outcome.fit)
        document.sections.insert(document.sections.begin() + 1,
                                 {LT_TEXT("Engine", "Stiffness and forces from the copy"), {fitTable(*outcome.fit)}});
    document.synthetic = outcome.synthetic;
    return document;
}

}  // namespace lathelier::chain
