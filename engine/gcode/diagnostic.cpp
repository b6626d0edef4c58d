#include "engine/gcode/diagnostic.h"

#include <algorithm>
#include <tuple>

#include "engine/core/texts.h"
#include "engine/gcode/gcode_codes.h"

namespace lathelier::gcode {

const char* severityKey(const Diagnostic& diagnostic)
{
    return diagnostic.is_error ? "error" : "warning";
}

std::string sentence(const Diagnostic& diagnostic)
{
    return fill(text(diagnostic.pattern), diagnostic.values);
}

bool Diagnostics::isNew(const char* code, std::uint64_t place)
{
    const auto found = placesByCode_.find(std::string_view(code));
    CodePlaces& seen = found != placesByCode_.end() ? found->second : placesByCode_[code];
    if (seen.places.contains(place)) return false;
    if (seen.places.size() >= mostOfOneCode) {
        ++seen.left_out;
        return false;
    }
    seen.places.insert(place);
    return true;
}

std::vector<Diagnostic> Diagnostics::sorted() const
{
    std::vector<Diagnostic> all = list_;
    std::stable_sort(all.begin(), all.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.order, a.column) < std::tie(b.order, b.column);
    });
    for (const auto& place : placesByCode_) {
        const std::string& code = place.first;
        const CodePlaces& seen = place.second;
        if (seen.left_out == 0) continue;
        Diagnostic more;
        const auto last = std::find_if(all.rbegin(), all.rend(), [&](const Diagnostic& d) { return d.code == code; });
        if (last != all.rend()) {
            more.path = last->path;
            more.line = last->line;
            more.order = last->order;
            more.column = last->column;
        }
        more.code = notes::ncMoreDiagnostics.key;
        more.pattern = notes::ncMoreDiagnostics.pattern;
        more.values = {{"found", code}, {"count", seen.left_out}};
        all.push_back(std::move(more));
    }
    return all;
}

Understanding Diagnostics::understanding(const std::vector<Diagnostic>& of) const
{
    Understanding found;
    for (const Diagnostic& one : of) {
        if (!one.gap) continue;
        const Value* const word = find(one.values, "found");
        found.not_modelled.push_back(
            {one.path, one.line, one.column, word ? text(*word) : one.block, one.code, *one.gap});
    }
    for (const auto& [code, seen] : placesByCode_)
        if (std::any_of(list_.begin(), list_.end(),
                        [&code = code](const Diagnostic& one) { return one.gap && one.code == code; }))
            found.more_not_modelled += seen.left_out;
    return found;
}

bool Diagnostics::hasErrors() const
{
    return std::any_of(list_.begin(), list_.end(), [](const Diagnostic& d) { return d.is_error; });
}

}  // namespace lathelier::gcode
