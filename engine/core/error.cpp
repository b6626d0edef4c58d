#include "engine/core/error.h"

#include <algorithm>

#include "engine/core/texts.h"

namespace lathelier {

Error::Error(const ErrorCode& code, Values values) : code_(code), values_(std::move(values)), what_(text(*this)) {}

Error& Error::with(std::string_view name, Value value)
{
    if (!find(values_, name)) {
        set(values_, name, std::move(value));
        what_ = text(*this);
    }
    return *this;
}

bool contains(const Notes& notes, const NoteCode& code)
{
    return std::any_of(notes.begin(), notes.end(), [&](const Note& note) { return note.code == code; });
}

}  // namespace lathelier
