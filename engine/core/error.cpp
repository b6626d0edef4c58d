#include "engine/core/error.h"

#include <algorithm>

#include "engine/core/codes.h"
#include "engine/core/texts.h"

namespace lathelier {
namespace {

struct ErrorRow {
    std::string_view key;
    ErrorKind kind;
    Text pattern;
};

struct NoteRow {
    std::string_view key;
    Severity severity;
    Text pattern;
};

constexpr ErrorRow errorRows[] = {
#define LATHELIER_ERROR(code, key, kind, pattern) {key, ErrorKind::kind, pattern},
#include "engine/core/error_codes.def.h"
#undef LATHELIER_ERROR
};

constexpr NoteRow noteRows[] = {
#define LATHELIER_NOTE(code, key, severity, pattern) {key, Severity::severity, pattern},
#include "engine/core/note_codes.def.h"
#undef LATHELIER_NOTE
};

const ErrorRow& row(ErrorCode code) { return errorRows[static_cast<std::size_t>(code)]; }
const NoteRow& row(NoteCode code) { return noteRows[static_cast<std::size_t>(code)]; }

}  // namespace

Error::Error(ErrorCode code, Values values) : code_(code), values_(std::move(values)), what_(text(*this)) {}

Error& Error::with(std::string_view name, Value value)
{
    if (!find(values_, name)) {
        set(values_, name, std::move(value));
        what_ = text(*this);
    }
    return *this;
}

std::string_view key(ErrorCode code) { return row(code).key; }
std::string_view key(NoteCode code) { return row(code).key; }
ErrorKind kind(ErrorCode code) { return row(code).kind; }
Severity severity(NoteCode code) { return row(code).severity; }
Text pattern(ErrorCode code) { return row(code).pattern; }
Text pattern(NoteCode code) { return row(code).pattern; }

bool contains(const Notes& notes, NoteCode code)
{
    return std::any_of(notes.begin(), notes.end(), [code](const Note& note) { return note.code == code; });
}

}  // namespace lathelier
