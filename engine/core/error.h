// Error (thrown: no result), Note (a remark in a result) and Cancelled (thrown: stopped by the user).
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/value.h"

namespace lathelier {

/// Class of an error; the command line turns it into its exit code.
enum class ErrorKind {
    WrongUsage,     ///< exit 2: invalid options or parameters
    InputRejected,  ///< exit 3: a file is not valid in its format
    NoAnswer,       ///< exit 4: the inputs are valid, but there is no result
    OutputFailed    ///< exit 5: the result cannot be written
};

/// Effect of a note on the reliability of the result.
enum class Severity { Info, Warning };

/// What a note says of the understanding of the inputs (understanding.h).
enum class NoteRole {
    Remark,      ///< nothing
    Assumed,     ///< a value was taken in place of what is not stated
    NotModelled  ///< something that could change the result was not understood
};

/// Kind of an error: an object in the `<room>_codes.h` of the room that throws it. Keys are unique.
struct ErrorCode {
    const char* key;  ///< stable name for scripts, "file_not_found"
    ErrorKind kind;   ///< determines the exit code of the command line
    Text pattern;     ///< English; {name} is replaced by the named value

    friend bool operator==(const ErrorCode& a, const ErrorCode& b) { return std::string_view(a.key) == b.key; }
};

/// Kind of a note: an object in the `<room>_codes.h` of the room that adds it. Keys are unique.
struct NoteCode {
    const char* key;    ///< stable name for scripts, "unit_guessed"
    Severity severity;  ///< effect on the reliability of the result
    Text pattern;       ///< English; {name} is replaced by the named value
    NoteRole role = NoteRole::Remark;

    friend bool operator==(const NoteCode& a, const NoteCode& b) { return std::string_view(a.key) == b.key; }
};

/// Thrown when there is no answer. Carries a code and named values; text(Error) in texts.h makes the sentence.
/// Readers put in `path` and `line` + `column` (both from 1) or `byte` (from 0), `found` and `expected`.
class Error : public std::exception {
public:
    Error(const ErrorCode& code, Values values);

    const ErrorCode& code() const { return code_; }
    const Values& values() const { return values_; }

    /// Adds a value in a caller (a parser knows the line, its caller the path). An existing name is kept.
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

/// A remark in a result that affects its interpretation.
struct Note {
    NoteCode code;  ///< which one, with its pattern
    Values values;  ///< fill in the pattern of `code`, by name
};

using Notes = std::vector<Note>;

/// True when `notes` holds one with this code.
bool contains(const Notes& notes, const NoteCode& code);

}  // namespace lathelier
