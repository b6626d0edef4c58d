#include "engine/core/understanding.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/texts.h"

namespace lathelier {
namespace {

std::string textOf(const Values& values, std::string_view name)
{
    const Value* const value = find(values, name);
    return value ? text(*value) : std::string();
}

std::int64_t numberIn(const Values& values, std::string_view name)
{
    const Value* const value = find(values, name);
    const auto* const number = value ? std::get_if<std::int64_t>(value) : nullptr;
    return number ? *number : 0;
}

bool counts(const NotModelled& gap)
{
    return gap.effect != GapEffect::None;
}

/// Of the note and of the error.
Values placeOf(const Understanding& understanding)
{
    const NotModelled& first = *understanding.first();
    std::string place = first.path;
    if (first.line > 0) place.append(place.empty() ? "" : ":").append(std::to_string(first.line));
    Values values{{"count", understanding.count()}, {"found", first.word}, {"place", place}};
    if (!first.path.empty()) values.emplace_back("path", first.path);
    if (first.line > 0) values.emplace_back("line", first.line);
    if (first.column > 0) values.emplace_back("column", first.column);
    return values;
}

Json orNull(const std::string& text)
{
    return text.empty() ? Json(nullptr) : Json(text);
}

Json orNull(std::int64_t place)
{
    return place > 0 ? Json(place) : Json(nullptr);
}

}  // namespace

const NotModelled* Understanding::first() const
{
    const auto found = std::find_if(not_modelled.begin(), not_modelled.end(), counts);
    return found == not_modelled.end() ? nullptr : &*found;
}

std::int64_t Understanding::count() const
{
    const std::int64_t listed = std::count_if(not_modelled.begin(), not_modelled.end(), counts);
    return listed > 0 ? listed + more_not_modelled : 0;
}

void Understanding::add(const Understanding& other, const std::string& path)
{
    for (NotModelled gap : other.not_modelled) {
        if (gap.path.empty()) gap.path = path;
        not_modelled.push_back(std::move(gap));
    }
    for (Assumed one : other.assumed) {
        if (one.path.empty()) one.path = path;
        assumed.push_back(std::move(one));
    }
    more_not_modelled += other.more_not_modelled;
}

Understanding understandingOf(const Notes& notes)
{
    Understanding found;
    for (const Note& note : notes) {
        const Values& values = note.values;
        if (note.code.role == NoteRole::Assumed)
            found.assumed.push_back({note.code.key, text(note), textOf(values, "path"), numberIn(values, "line")});
        if (note.code.role != NoteRole::NotModelled) continue;
        std::string word = textOf(values, "key");
        // A key that is none of the format changes nothing that is modelled; one that is nearly one was meant to.
        const bool isForeign = find(values, "key") && !find(values, "meant");
        if (word.empty()) word = textOf(values, "found");
        if (word.empty()) word = note.code.key;
        found.not_modelled.push_back({textOf(values, "path"), numberIn(values, "line"), numberIn(values, "column"),
                                      word, note.code.key, isForeign ? GapEffect::None : GapEffect::Measures});
    }
    return found;
}

void settle(const Understanding& understanding, std::optional<Verdict>& verdict, Notes& notes)
{
    if (understanding.isWhole()) return;
    verdict = Verdict::Undecided;
    notes.push_back({notes::notModelled, placeOf(understanding)});
}

void requireUnderstood(const Understanding& understanding)
{
    if (!understanding.isWhole()) throw Error(errors::notModelled, placeOf(understanding));
}

const char* key(GapEffect effect)
{
    switch (effect) {
        case GapEffect::None: return "none";
        case GapEffect::Measures: return "measures";
        case GapEffect::Shifts: return "shifts";
        case GapEffect::Moves: return "moves";
    }
    return "none";
}

Json toJson(const Understanding& understanding)
{
    Json gaps = Json::array(), assumed = Json::array();
    for (const NotModelled& gap : understanding.not_modelled)
        gaps.push_back({{"path", orNull(gap.path)},
                        {"line", orNull(gap.line)},
                        {"column", orNull(gap.column)},
                        {"word", gap.word},
                        {"code", gap.code},
                        {"effect", key(gap.effect)}});
    for (const Assumed& one : understanding.assumed)
        assumed.push_back(
            {{"what", one.what}, {"value", one.value}, {"path", orNull(one.path)}, {"line", orNull(one.line)}});
    Json json = {{"not_modelled", std::move(gaps)}, {"assumed", std::move(assumed)}};
    if (understanding.more_not_modelled > 0) json["more_not_modelled"] = understanding.more_not_modelled;
    return json;
}

}  // namespace lathelier
