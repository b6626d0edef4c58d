// Parsing of fixed-column (Fortran) lines of a universal file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/text/text_lines.h"

namespace lathelier::io {

/// One field of a line: how many characters, and what they are.
struct UffColumn {
    enum class Kind { Blank, Integer, Real, Word };
    int width = 0;            ///< width in characters
    Kind kind = Kind::Blank;  ///< Blank: between two texts
};

/// A line of a header, UTF-8 or Latin-1. Writers count the columns in characters or, with letters beyond ASCII, in
/// bytes: the first interpretation consistent with numbers and blanks is taken.
class UffFields {
public:
    /// Error malformed (`line`, `column`) where a number is not in its columns.
    UffFields(std::int64_t lineNumber, std::string_view line, std::span<const UffColumn> columns);
    UffFields(const UffFields&) = delete;
    UffFields& operator=(const UffFields&) = delete;

    /// The number in column k, 0 when the column is blank.
    std::int64_t integer(std::size_t k) const { return static_cast<std::int64_t>(numbers_[k]); }
    double number(std::size_t k) const { return numbers_[k]; }
    std::string text(std::size_t k) const { return std::string(trimmed(parts_[k])); }  ///< trimmed

    /// Character of the line at which the text of column k begins, from 1.
    std::int64_t begin(std::size_t k) const;

    /// Error malformed at field k.
    Error wrong(std::size_t k, Text expected) const;

private:
    std::int64_t lineNumber_;
    std::string line_;                     ///< line in UTF-8
    std::vector<std::string_view> parts_;  ///< fields of line_
    std::vector<double> numbers_;          ///< by field; 0 where it is not a number
};

/// The text of a line as UTF-8, whichever of both it was.
std::string uffText(std::string_view line);

/// Appends the numbers of a line of data to `values`. `widths` are those of its columns. Words for "no number" give
/// NaN. Error malformed (`line`, `column`).
void readUffNumbers(std::int64_t lineNumber, std::string_view line, std::span<const int> widths,
                    std::vector<double>& values);

/// True for a line that separates sets.
bool isUffSeparator(std::string_view line);

}  // namespace lathelier::io
