// Cells of a text table: splitting of rows, interpretation of cells.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/core/error.h"

namespace lathelier::io {

/// Notation of a table's rows.
struct TableStyle {
    char delimiter = ' ';  ///< separator; ' ': runs of blanks and tabs
    char decimal = '.';    ///< decimal mark: '.' or ','
    bool grouped = false;  ///< the other mark is known to group thousands, so that a single "1,234" is 1234
    bool paired = false;   ///< commas separate cells and mark decimals: "1,5,2,5" is 1.5 and 2.5
};

/// One cell, trimmed and without quotes; a view into its line.
using Cell = std::string_view;

/// Splits a line at the separator; quotes protect it. Blank-separated reals that touch ("6.9-16.1", fixed-width output)
/// are two cells.
void splitFields(std::string_view line, char delimiter, std::vector<Cell>& cells);

/// Splits a row into cells. Quotes protect separators, brackets around the row and a trailing remark (after #, //, %, !
/// or a blank and ;) are removed.
void splitCells(std::string_view line, const TableStyle& style, std::vector<Cell>& cells);

/// Removes empty cells after the last column, since a separator may end the row.
void dropEmptyEnd(std::vector<Cell>& cells, std::size_t columns);

enum class CellKind {
    Number,
    NotFinite,  ///< nan, inf, n/a…
    Empty,
    Ambiguous,  ///< "1,234" where grouping and decimal mark cannot be distinguished
    Text
};

struct CellValue {
    CellKind kind = CellKind::Text;  ///< kind of the cell
    double value = 0;                ///< of a Number or Ambiguous cell, else 0
    std::string_view suffix;         ///< what follows the number, when it is a unit of length: "mm"
};

/// Interpretation of a cell under a style.
CellValue readCell(Cell cell, const TableStyle& style);

/// Evidence of a single cell about the decimal mark of its table.
enum class Evidence { NoNumber, NoMark, Point, Comma, LonePoint, LoneComma };

struct CellEvidence {
    Evidence evidence = Evidence::NoNumber;  ///< decimal marks consistent with the cell
    char grouping = 0;                       ///< grouping mark, for Point and Comma
};
CellEvidence evidenceOf(Cell cell);

/// True when the cell is a number in some style, or an invalid number.
bool looksLikeNumber(Cell cell);

/// Throws numberAmbiguous for a cell such as "1,234" within its line.
Error ambiguousNumber(std::int64_t number, std::string_view line, Cell cell);

/// True when the line is a remark: it starts with #, //, %, !, * or, unless that separates cells, a semicolon.
bool isRemark(std::string_view line, char delimiter);

}  // namespace lathelier::io
