// Errors and unsupported words of an NC program with their positions.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/understanding.h"

namespace lathelier::gcode {

/// One error or warning at one position of a program.
struct Diagnostic {
    std::string path;              ///< of a called program in a file of its own; empty: the program itself
    std::int64_t line = 0;         ///< from 1
    std::int64_t column = 0;       ///< in characters, from 1
    bool is_error = false;         ///< severity error: the moves of the program are invalid; false: warning
    std::string code;              ///< stable key, "nose_radius_unknown"
    Text pattern;                  ///< English; {name} is replaced by the named value
    Values values;                 ///< fill in the pattern
    std::optional<GapEffect> gap;  ///< what is not modelled here can change this; none: it is modelled
    std::int64_t order = 0;        ///< line counted on through all files
    std::string block;             ///< text of the block, without control characters, at most 40 characters
    /// The error as thrown if a caller reports the first one alone: `code` with line, column and block.
    std::optional<Error> error;
};

/// "error", "warning".
const char* severityKey(const Diagnostic& diagnostic);

/// The sentence in English.
std::string sentence(const Diagnostic& diagnostic);

/// Collection of diagnostics: each code once per position, at most mostOfOneCode of a code; further ones are only
/// counted.
class Diagnostics {
public:
    static constexpr std::size_t mostOfOneCode = 1000;

    /// True if the code was not yet reported at this position. `place`: offset in the text.
    bool isNew(const char* code, std::uint64_t place);
    void add(Diagnostic diagnostic) { list_.push_back(std::move(diagnostic)); }

    /// What is not modelled among these, which sorted() gave; without a path.
    Understanding understanding(const std::vector<Diagnostic>& of) const;

    /// By line and column, with a summary for each code with omitted positions.
    std::vector<Diagnostic> sorted() const;
    bool hasErrors() const;
    std::size_t size() const { return list_.size(); }

private:
    struct CodePlaces {
        std::set<std::uint64_t> places;
        std::int64_t left_out = 0;
    };
    std::vector<Diagnostic> list_;
    std::map<std::string, CodePlaces, std::less<>> placesByCode_;
};

}  // namespace lathelier::gcode
