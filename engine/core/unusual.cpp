#include "engine/core/unusual.h"

#include <algorithm>

namespace lathelier {

void noteUnusual(const UsualRange& usual, double value, Notes& notes)
{
    if (value >= usual.range.from && value <= usual.range.to) return;
    const auto names_it = [&](const Note& note) {
        const Value* const named = find(note.values, "parameter");
        return note.code == notes::valueUnusual && named && *named == Value(usual.key);
    };
    if (std::any_of(notes.begin(), notes.end(), names_it)) return;
    notes.push_back(
        {notes::valueUnusual,
         {{"parameter", usual.key}, {"found", value}, {"minimum", usual.range.from}, {"maximum", usual.range.to}}});
}

}  // namespace lathelier
