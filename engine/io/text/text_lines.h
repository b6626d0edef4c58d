// Iteration over the lines of a text, and errors with line and column.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "engine/core/error.h"

namespace lathelier::io {

/// The lines of a text, one after the other. LF, CRLF and a lone CR end a line. Error malformed for a line of more than
/// 1 MiB: splitting it would need many times its size.
class Lines {
public:
    explicit Lines(std::string_view text, std::size_t offset = 0, std::int64_t firstNumber = 1)
        : text_(text), next_(offset), number_(firstNumber - 1)
    {
    }

    /// Goes to the next line; false at the end of the text.
    bool next();

    std::string_view line() const { return text_.substr(begin_, length_); }  ///< line without its line end
    std::int64_t number() const { return number_; }                          ///< line number, from 1
    std::size_t offset() const { return begin_; }
    std::size_t nextOffset() const { return next_; }

private:
    std::string_view text_;
    std::size_t begin_ = 0;
    std::size_t length_ = 0;
    std::size_t next_;
    std::int64_t number_;
};

/// Trims blanks at both ends.
std::string_view trimmed(std::string_view text);

/// Splits at blanks; `words` is emptied first.
void splitWords(std::string_view line, std::vector<std::string_view>& words);

/// Throws malformed at `part`, which must lie within `line`. `found` is an excerpt of `part`; an empty part at the end
/// of the line is "the end of the line".
Error malformed(std::int64_t number, std::string_view line, std::string_view part, Text expected);

/// Throws malformed because the text ends before `expected`; located at its last line.
Error malformedEnd(const Lines& lines, Text expected);

bool isBlank(char c);

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words);

}  // namespace lathelier::io
