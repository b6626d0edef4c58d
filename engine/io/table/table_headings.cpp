#include "engine/io/table/table_headings.h"

#include <algorithm>

#include "engine/io/table/column_names.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

// Lines searched for names: names are near the table, and a malicious preface must not take long.
constexpr std::size_t searchedLines = 50;
constexpr std::size_t longestNames = 8192;

/// Splits a line of names into cells.
std::vector<Cell> splitNames(std::string_view line, char delimiter)
{
    std::vector<Cell> cells;
    splitFields(line, delimiter, cells);
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    return cells;
}

std::vector<Heading> splitHeadings(std::string_view line, char delimiter)
{
    std::vector<Heading> headings;
    for (const Cell cell : splitNames(line, delimiter)) {
        // "X (in) Y (in)": the bracket belongs to the preceding name.
        const bool bracketed = !cell.empty() && (cell.front() == '(' || cell.front() == '[');
        if (delimiter == ' ' && bracketed && !headings.empty()) {
            headings.back().unit = lengthUnit(cell);
            headings.back().written += ' ' + std::string(cell);
        } else
            headings.push_back(parseHeading(cell));
    }
    return headings;
}

std::size_t countKnown(const std::vector<Heading>& headings, const TableExpectation& expectation)
{
    if (!expectation.knows_name) return 0;
    return static_cast<std::size_t>(
        std::count_if(headings.begin(), headings.end(),
                      [&expectation](const Heading& heading) { return expectation.knows_name(heading.name); }));
}

/// True for a known name of a quantity that the caller does not use: "force_N", "temp (C)".
bool isOther(const Heading& heading)
{
    return isOtherQuantity(heading.written.substr(0, heading.written.find_first_of("_([")));
}

/// Number of such names; a single word among others does not count.
std::size_t countOthers(const std::vector<Heading>& headings)
{
    const auto count = static_cast<std::size_t>(std::count_if(headings.begin(), headings.end(), isOther));
    return count > 1 ? count : 0;
}

/// The split of a line with the most known names: names and rows may use different separators.
std::vector<Heading> readLine(std::string_view line, char delimiter, const TableExpectation& expectation)
{
    std::vector<Heading> best = splitHeadings(line, delimiter);
    for (const char other : {',', ';', '\t', '|', ' '}) {
        std::vector<Heading> headings = splitHeadings(line, other);
        if (countKnown(headings, expectation) > countKnown(best, expectation)) best = std::move(headings);
    }
    return best;
}

/// True for words such as "s V um um": at least half of them units.
bool isUnitLine(const std::vector<Cell>& cells, const TableExpectation& expectation)
{
    const auto units = std::count_if(cells.begin(), cells.end(), [&expectation](Cell cell) {
        return expectation.knows_unit ? expectation.knows_unit(cell) : lengthUnit(cell).has_value();
    });
    return units > 0 && static_cast<std::size_t>(units) * 2 >= cells.size();
}

struct NamesFound {
    std::vector<Heading> headings;
    std::size_t preface_index = 0;
    std::size_t known = 0;
    bool are_units = false;  ///< a row of units, used in absence of names
};

/// Whether there is a name for each column; leading row numbers may have none, and with decimal commas there are half
/// as many.
bool fitsColumns(std::size_t names, std::size_t columns)
{
    return names == columns || names + 1 == columns || 2 * names == columns;
}

/// The line with the most known names, preferably with a name for every column; without known names the lowest line
/// that is not a remark, preferably not a row of units. A remark of other words ("# shaft of rho 7850, r 15") is not a
/// line of names and does not hide one.
NamesFound findNames(const std::vector<PrefaceLine>& preface, char delimiter, const TableExpectation& expectation,
                     std::size_t columns)
{
    NamesFound best;
    bool bestFits = false;
    for (std::size_t i = preface.size(); i-- > 0 && preface.size() - i <= searchedLines;) {
        if (preface[i].text.size() > longestNames) continue;
        std::vector<Heading> headings = readLine(preface[i].text, delimiter, expectation);
        std::size_t known = countKnown(headings, expectation);
        // Names of other quantities in a remark are names as well, as some programs write "# time force temp".
        if (preface[i].is_remark && known == 0) known = countOthers(headings);
        const bool fits = fitsColumns(headings.size(), columns);
        if (preface[i].is_remark && !fits) continue;
        const bool areUnits = isUnitLine(splitNames(preface[i].text, delimiter), expectation);
        const bool isWanted = best.headings.empty() || (best.are_units && best.known == 0 && !areUnits);
        const bool isLoneName = columns == 1 && headings.size() == 1 && isOther(headings.front());
        const bool isBetter = fits == bestFits || best.known == 0 ? known > best.known : known > 0 && fits;
        if (isBetter || (isWanted && !preface[i].is_remark && (headings.size() > 1 || isLoneName))) {
            best = {std::move(headings), i, known, areUnits};
            bestFits = fits;
        }
    }
    return best;
}

/// A line of units, one for each column; units of angles and others are handled by the caller.
void applyUnitLine(const std::vector<PrefaceLine>& preface, const TableExpectation& expectation, TableLayout& layout)
{
    const std::size_t first = preface.size() - std::min(preface.size(), searchedLines);
    for (std::size_t i = first; i < preface.size(); ++i)
        for (const char delimiter : {layout.style.delimiter, ' '}) {
            const PrefaceLine& line = preface[i];
            const std::vector<Cell> cells = splitNames(line.text, delimiter);
            if (cells.size() != layout.columns.size() || !isUnitLine(cells, expectation)) continue;
            for (std::size_t k = 0; k < cells.size(); ++k) {
                layout.columns[k].unit_text = cells[k];
                if (auto unit = lengthUnit(cells[k])) layout.columns[k].unit = std::move(unit);
            }
            return;
        }
}

}  // namespace

std::size_t countHeadings(const std::vector<PrefaceLine>& preface, char delimiter, const TableExpectation& expectation,
                          std::size_t columns)
{
    return findNames(preface, delimiter, expectation, columns).headings.size();
}

void applyHeadings(const std::vector<PrefaceLine>& preface, const TableExpectation& expectation, TableLayout& layout)
{
    applyUnitLine(preface, expectation, layout);
    const std::size_t columns = layout.columns.size();
    const NamesFound names = findNames(preface, layout.style.delimiter, expectation, columns);
    if (names.headings.empty()) return;
    // One name fewer than columns: leading row numbers or labels have none.
    const bool unnamedFirst =
        names.headings.size() + 1 == columns && (layout.columns[0].is_count || !layout.columns[0].is_number);
    const std::size_t shift = unnamedFirst ? 1 : 0;
    // A remark with a known name ("# scanner X") is a heading only if it names every column.
    const bool fits = names.headings.size() + shift == columns;
    if (!fits && (names.known == 0 || preface[names.preface_index].is_remark)) return;
    layout.has_names = true;
    for (std::size_t k = 0; k + shift < columns && k < names.headings.size(); ++k) {
        layout.columns[k + shift].name = names.headings[k].name;
        layout.columns[k + shift].heading = names.headings[k].written;
        if (names.headings[k].unit) layout.columns[k + shift].unit = names.headings[k].unit;
    }
    layout.skipped[preface[names.preface_index].skipped_index].reason = LT_TEXT("Engine", "column names");
}

}  // namespace lathelier::io
