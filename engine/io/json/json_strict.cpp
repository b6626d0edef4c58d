#include "engine/io/json/json_strict.h"

#include <algorithm>

namespace lathelier::io {

void requireMembers(const JsonCursor& object, const std::vector<std::string>& known, const ErrorCode& unknown)
{
    object.members(mostJsonMembers, [&](const std::string& key, const JsonCursor& member) {
        if (std::find(known.begin(), known.end(), key) != known.end()) return;
        std::string names;
        for (const std::string& name : known) names.append(names.empty() ? "" : " | ").append(name);
        const JsonPlace here = member.place();
        throw Error(unknown, {{"line", here.line}, {"column", here.column}, {"key", key}, {"expected", names}});
    });
}

Values strictValuesOf(const JsonCursor& object, const std::vector<FieldInfo>& fields, const Value& expected,
                      const ErrorCode& unknown)
{
    Notes notes;
    Values values = valuesOf(object, fields, notes);
    if (notes.empty()) return values;
    Error error(unknown, {{"expected", expected}});
    for (const char* name : {"line", "column", "key"})
        if (const Value* const value = find(notes.front().values, name)) error.with(name, *value);
    throw Error(error);
}

}  // namespace lathelier::io
