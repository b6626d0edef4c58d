// "No answer" (Error, thrown), "answered, but" (Note, inside a result) and "stopped by the user" (Cancelled).
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/value.h"

namespace lathelier {

/// What an error means to the caller; the command line turns it into its exit code.
enum class ErrorKind {
    WrongUsage,     ///< exit 2: the request itself makes no sense
    InputRejected,  ///< exit 3: a file cannot be read as what it claims to be
    NoAnswer,       ///< exit 4: the files are sound, but the question has no answer
    OutputFailed    ///< exit 5: an answer is there, but a file to write it to is not
};

/// How much a note matters for trusting the number beside it.
enum class Severity { Info, Warning };

/// One reason for "no answer": an object beside the room that throws it, in its `<room>_codes.h`. Keys are unique.
struct ErrorCode {
    const char* key;  ///< stable name for scripts, "file_not_found"
    ErrorKind kind;   ///< what the error means to the caller: exit code of the command line
    Text pattern;     ///< English; {name} is replaced by the named value

    friend bool operator==(const ErrorCode& a, const ErrorCode& b) { return std::string_view(a.key) == b.key; }
};

/// One "answered, but": an object beside the room that says it, in its `<room>_codes.h`. Keys are unique.
struct NoteCode {
    const char* key;    ///< stable name for scripts, "unit_guessed"
    Severity severity;  ///< how much it matters for trusting the result
    Text pattern;       ///< English; {name} is replaced by the named value

    friend bool operator==(const NoteCode& a, const NoteCode& b) { return std::string_view(a.key) == b.key; }
};

/// Thrown when there is no answer. Carries a code and named values; text(Error) in texts.h makes the sentence.
/// Readers put in `path` and `line` + `column` (both from 1) or `byte` (from 0), `found` and `expected`.
class Error : public std::exception {
public:
    Error(const ErrorCode& code, Values values);

    const ErrorCode& code() const { return code_; }
    const Values& values() const { return values_; }

    /// Adds a value on the way up (a parser knows the line, its caller the path). An existing name is kept.
    Error& with(std::string_view name, Value value);

    /// The English sentence, for test output and debuggers only.
    const char* what() const noexcept override { return what_.c_str(); }

private:
    ErrorCode code_;
    Values values_;
    std::string what_;
};

/// Thrown out of a computation that the user stopped.
class Cancelled : public std::exception {
public:
    const char* what() const noexcept override { return "cancelled"; }
};

/// Part of a result: something the reader of the number has to know.
struct Note {
    NoteCode code;  ///< which one, with its pattern
    Values values;  ///< fill in the pattern of `code`, by name
};

using Notes = std::vector<Note>;

/// True when `notes` holds one with this code.
bool contains(const Notes& notes, const NoteCode& code);

}  // namespace lathelier
