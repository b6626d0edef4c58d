#include "engine/chain/dossier_cover.h"

#include <algorithm>

#include "engine/chain/dossier_report.h"
#include "engine/core/texts.h"
#include "engine/io/io_codes.h"
#include "engine/report/plot_svg.h"

namespace lathelier::chain {
namespace {

constexpr std::size_t mostPictures = 6;
constexpr std::size_t mostOpenPoints = 5;
constexpr const char* wholeAnnex = "annex_numbers.html";

std::string annexOf(const ChainStep& step)
{
    return "annex_" + step.id + ".html";
}

/// Null: it has none, or was not run by this process.
template <class Block>
const Block* firstOf(const ChainStep& step)
{
    for (const report::Section& section : step.sections)
        for (const report::Block& block : section.blocks)
            if (const auto* const found = std::get_if<Block>(&block)) return found;
    return nullptr;
}

/// Its answer with U and limit; empty: it was not run by this process.
std::string wordsOf(const ChainStep& step, const Language& language)
{
    const auto* const answer = firstOf<report::Answer>(step);
    if (!answer) return {};
    std::string words = report::valueLine(*answer, language);
    if (answer->lower_limit || answer->upper_limit) words += ", " + report::limitText(*answer, language);
    return words;
}

Text shortOf(const ChainStep& step)
{
    const StepStanding standing = standingOf(step);
    return standing.verdict ? shortName(*standing.verdict) : nameOf(standing);
}

report::Table answersTable(const Dossier& dossier, const Language& language)
{
    report::Table table{LT_TEXT("Engine", "Steps"),
                        {LT_TEXT("Engine", "Step"), LT_TEXT("Engine", "State"), LT_TEXT("Engine", "What it says"),
                         LT_TEXT("Engine", "Annex")},
                        {},
                        {}};
    for (const ChainStep& step : dossier.steps)
        table.rows.push_back({titleOf(step.id), shortOf(step), wordsOf(step, language),
                              step.state == StepState::Done ? annexOf(step) : std::string()});
    return table;
}

/// The story of the part: where there are more than six pictures the drawing is left out, whose rows the scan shows.
std::vector<report::Block> picturesOf(const Dossier& dossier, const Language& language)
{
    std::vector<const ChainStep*> told;
    for (const char* id : {"recognise", "draw", "speeds", "program", "deflection", "copy", "proof"})
        if (const ChainStep* const step = dossier.step(id); step && firstOf<report::Plot>(*step)) told.push_back(step);
    if (told.size() > mostPictures) std::erase_if(told, [](const ChainStep* step) { return step->id == "draw"; });
    std::vector<report::Block> pictures;
    pictures.reserve(told.size());
    for (const ChainStep* step : told)
        pictures.emplace_back(report::Picture{
            fill(text(LT_TEXT("Engine", "{step} · {state}"), language),
                 {{"step", titleOf(step->id)}, {"state", shortOf(*step)}}, language),
            report::toSvg(*firstOf<report::Plot>(*step), language, report::Sheet::Half), report::Picture::Width::Half});
    return pictures;
}

/// Warnings of the steps, each once.
Notes openPoints(const Dossier& dossier)
{
    Notes open;
    for (const Note& note : dossier.notes)
        if (note.code.severity == Severity::Warning && !(note.code == notes::syntheticData) &&
            !contains(open, note.code) && open.size() < mostOpenPoints)
            open.push_back(note);
    return open;
}

/// Remarks of a step of an earlier run.
report::Table remarksTable(const ChainStep& step)
{
    report::Table table{titleOf(step.id), {LT_TEXT("Engine", "Taken over from an earlier run")}, {}, {}};
    for (const std::string& remark : step.remarks) table.rows.push_back({remark});
    return table;
}

}  // namespace

report::Document dossierReport(const Dossier& dossier, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Dossier of a copied part");
    document.sections.push_back({LT_TEXT("Engine", "Answer"), {answer(dossier), answersTable(dossier, language)}});
    if (auto pictures = picturesOf(dossier, language); !pictures.empty())
        document.sections.push_back({LT_TEXT("Engine", "From the worn part to its copy"), std::move(pictures)});
    if (Notes open = openPoints(dossier); !open.empty())
        document.sections.push_back({LT_TEXT("Engine", "Open points"), {std::move(open)}});
    report::Section& last = document.sections.back();
    for (const Confirmation& word : dossier.confirmed)
        last.blocks.emplace_back(
            word.by.empty() ? report::Paragraph{LT_TEXT("Engine", "Confirmed by a person who is not named: {file}."),
                                                {{"file", word.file}}}
                            : report::Paragraph{LT_TEXT("Engine", "Confirmed by {by}: {file}."),
                                                {{"by", word.by}, {"file", word.file}}});
    last.blocks.emplace_back(
        report::Paragraph{LT_TEXT("Engine",
                                  "The annexes are in the folder of the chain; all notes, numbers and files with their "
                                  "digests are in {file}."),
                          {{"file", std::string(wholeAnnex)}}});
    return document;
}

std::vector<Annex> annexesOf(const Dossier& dossier, const std::vector<InputFile>& inputs)
{
    std::vector<Annex> annexes;
    Annex whole;
    whole.file = wholeAnnex;
    whole.document.title = LT_TEXT("Engine", "Notes, numbers and files");
    report::Section notes{LT_TEXT("Engine", "Notes"), {stepsTable(dossier)}};
    if (!dossier.notes.empty()) notes.blocks.emplace_back(dossier.notes);
    for (const ChainStep& step : dossier.steps) {
        if (step.past_notes && !step.remarks.empty()) notes.blocks.emplace_back(remarksTable(step));
        if (step.sections.empty()) continue;
        Annex annex{annexOf(step), {}};
        annex.document.title = titleOf(step.id);
        annex.document.sections = step.sections;
        annexes.push_back(std::move(annex));
    }
    whole.document.sections = {std::move(notes),
                               {LT_TEXT("Engine", "Where every number stands"), {numbersTable(dossier)}},
                               {LT_TEXT("Engine", "Files"), {filesTable(dossier)}}};
    whole.document.inputs = inputs;
    annexes.push_back(std::move(whole));
    return annexes;
}

}  // namespace lathelier::chain
