#include "engine/report/understanding_report.h"

#include <algorithm>

namespace lathelier::report {
namespace {

constexpr std::size_t mostFindings = 3;
constexpr std::size_t mostPlaces = 8;
constexpr std::size_t mostRows = 200;

Text nameOf(GapEffect effect)
{
    switch (effect) {
        case GapEffect::None: return LT_TEXT("Engine", "nothing");
        case GapEffect::Measures: return LT_TEXT("Engine", "values");
        case GapEffect::Shifts: return LT_TEXT("Engine", "the place of what follows");
        case GapEffect::Moves: return LT_TEXT("Engine", "moves");
    }
    return {};
}

/// "12 CYCLE95, 20 G70, …"
std::string placesOf(const Understanding& understanding)
{
    std::string places;
    std::size_t count = 0;
    std::int64_t line = -1;
    for (const NotModelled& gap : understanding.not_modelled) {
        if (gap.effect == GapEffect::None || (gap.line > 0 && gap.line == line)) continue;
        line = gap.line;
        if (count++ == mostPlaces) return places + ", …";
        if (!places.empty()) places += ", ";
        if (gap.line > 0) places.append(std::to_string(gap.line)).append(" ");
        places.append("“").append(gap.word).append("”");
    }
    return places;
}

Value orNothing(std::int64_t place)
{
    return place > 0 ? Value(place) : Value();
}

}  // namespace

void settle(Answer& answer, const Understanding& understanding)
{
    if (understanding.isWhole()) return;
    answer.verdict = Verdict::Undecided;
    answer.verdict_words = LT_TEXT("Engine", "? not all of it was understood");
    answer.sentence = LT_TEXT("Engine", "Not modelled, by line: {places}. It could change what is shown here.");
    answer.values = {{"places", placesOf(understanding)}};
    std::vector<Finding> findings;
    std::int64_t line = -1;
    for (const NotModelled& gap : understanding.not_modelled) {
        if (gap.effect == GapEffect::None || findings.size() == mostFindings) continue;
        if (gap.line > 0 && gap.line == line) continue;  // a word and the block that it owns
        line = gap.line;
        Finding& finding = findings.emplace_back();
        finding.pattern = gap.line > 0
                              ? LT_TEXT("Engine", "Line {line}: “{word}” is not modelled; it can change {what}")
                              : LT_TEXT("Engine", "“{word}” is not modelled; it can change {what}");
        finding.values = {{"line", gap.line}, {"word", gap.word}, {"what", nameOf(gap.effect)}};
        finding.verdict = Verdict::Undecided;
        if (gap.line > 0) finding.place.line = gap.line;
    }
    for (Finding& finding : answer.findings)
        if (findings.size() < mostFindings) findings.push_back(std::move(finding));
    answer.findings = std::move(findings);
}

std::optional<Section> understandingSection(const Understanding& understanding)
{
    if (understanding.not_modelled.empty() && understanding.assumed.empty()) return std::nullopt;
    Section section{LT_TEXT("Engine", "What was not understood, and what was assumed"), {}};
    if (!understanding.not_modelled.empty()) {
        Table table;
        table.title = LT_TEXT("Engine", "Not modelled");
        table.columns = {LT_TEXT("Engine", "File"), LT_TEXT("Engine", "Line"), LT_TEXT("Engine", "Word"),
                         LT_TEXT("Engine", "It can change")};
        table.decimals = {0, 0, 0, 0};
        for (const NotModelled& gap : understanding.not_modelled) {
            if (table.rows.size() == mostRows) break;
            table.rows.push_back({gap.path, orNothing(gap.line), gap.word, nameOf(gap.effect)});
        }
        section.blocks.emplace_back(std::move(table));
    }
    if (!understanding.assumed.empty()) {
        Table table;
        table.title = LT_TEXT("Engine", "Assumed");
        table.columns = {LT_TEXT("Engine", "What"), LT_TEXT("Engine", "Value"), LT_TEXT("Engine", "File"),
                         LT_TEXT("Engine", "Line")};
        table.decimals = {0, 0, 0, 0};
        for (const Assumed& one : understanding.assumed)
            table.rows.push_back({one.what, one.value, one.path, orNothing(one.line)});
        section.blocks.emplace_back(std::move(table));
    }
    return section;
}

}  // namespace lathelier::report
