// What is wrong or not understood in an NC program, each with its place.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/core/error.h"

namespace lathelier::gcode {

/// One remark about one place of a program.
struct Diagnostic {
    std::int64_t line = 0;    ///< from 1
    std::int64_t column = 0;  ///< in characters, from 1
    bool is_error = false;    ///< severity error: the moves of the program are not to be trusted; else warning
    std::string code;         ///< stable key, "nose_radius_unknown"
    Text pattern;             ///< English; {name} is replaced by the named value
    Values values;            ///< fill in the pattern
    std::string block;        ///< text of the block, without control characters, at most 40 characters
    /// The error as it is thrown where the first one has to stand alone: `code` with line, column and block.
    std::optional<Error> error;
};

/// "error", "warning".
const char* severityKey(const Diagnostic& diagnostic);

/// The sentence in English.
std::string sentence(const Diagnostic& diagnostic);

/// Collects them: each code once for each place, at most mostOfOneCode of a code; the rest is counted.
class Diagnostics {
public:
    static constexpr std::size_t mostOfOneCode = 1000;

    /// True when it is new. `place` tells places apart (the offset in the text).
    bool isNew(const char* code, std::uint64_t place);
    void add(Diagnostic diagnostic) { list_.push_back(std::move(diagnostic)); }

    /// By line and column, with one more for each code of which places were left out.
    std::vector<Diagnostic> sorted() const;
    bool hasErrors() const;
    std::size_t size() const { return list_.size(); }

private:
    struct Seen {
        std::set<std::uint64_t> places;
        std::int64_t left_out = 0;
    };
    std::vector<Diagnostic> list_;
    std::map<std::string, Seen, std::less<>> seen_;
};

}  // namespace lathelier::gcode
