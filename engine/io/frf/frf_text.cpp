#include "engine/io/frf/frf_text.h"

#include <algorithm>

#include "engine/io/frf/frf_columns.h"
#include "engine/io/text/number.h"
#include "engine/io/text/quantity.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

constexpr std::size_t sampledRows = 500;  ///< within which the first complex number stands
constexpr std::size_t searchedHeadings = 50;
constexpr std::size_t longestHeading = 8192;
constexpr std::int64_t linesPerProgress = 1 << 14;

/// A complex number in a line.
struct ComplexCell {
    std::size_t begin = 0, end = 0;
    std::string_view real, imaginary;  ///< as written; an empty real part is 0
    bool is_subtracted = false;        ///< "a - b j"
};

bool isImaginaryUnit(char c)
{
    return c == 'i' || c == 'j' || c == 'I' || c == 'J';
}

bool isWordLetter(char c)
{
    return detail::isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           static_cast<unsigned char>(c) >= 0x80;
}

/// Reads one complex number from a place in a line.
class ComplexParser {
public:
    ComplexParser(std::string_view line, std::size_t at, char decimal) : line_(line), at_(at), decimal_(decimal) {}

    std::optional<ComplexCell> read()
    {
        ComplexCell cell;
        cell.begin = at_;
        const bool is_bracketed = take('(');
        if (is_bracketed) skipBlanks();
        cell.real = number();
        if (cell.real.empty()) return std::nullopt;
        if (takeUnit()) {
            cell.imaginary = cell.real;
            cell.real = {};
        } else if (!(is_bracketed && readPair(cell)) && !readSum(cell)) {
            return std::nullopt;
        }
        if (is_bracketed) {
            skipBlanks();
            if (!take(')')) return std::nullopt;
        }
        cell.end = at_;
        return at_ < line_.size() && isWordLetter(line_[at_]) ? std::nullopt : std::optional(cell);
    }

private:
    bool take(char c)
    {
        if (at_ >= line_.size() || line_[at_] != c) return false;
        ++at_;
        return true;
    }

    bool skipBlanks()
    {
        const std::size_t before = at_;
        while (at_ < line_.size() && line_[at_] == ' ') ++at_;
        return at_ > before;
    }

    std::string_view number()
    {
        double value = 0;
        const char* const begin = line_.data() + at_;
        const char* const end = parseNumber(begin, line_.data() + line_.size(), decimal_, value);
        if (!end) return {};
        at_ += static_cast<std::size_t>(end - begin);
        return {begin, static_cast<std::size_t>(end - begin)};
    }

    /// "j", "*j"; not the begin of a word.
    bool takeUnit()
    {
        std::size_t at = at_;
        if (at < line_.size() && line_[at] == '*') ++at;
        if (at >= line_.size() || !isImaginaryUnit(line_[at])) return false;
        if (at + 1 < line_.size() && isWordLetter(line_[at + 1])) return false;
        at_ = at + 1;
        return true;
    }

    /// "(a, b)" from behind a.
    bool readPair(ComplexCell& cell)
    {
        const std::size_t before = at_;
        skipBlanks();
        if (take(decimal_ == ',' ? ';' : ',') || take(';')) {
            skipBlanks();
            cell.imaginary = number();
            if (!cell.imaginary.empty()) return true;
        }
        at_ = before;
        return false;
    }

    /// "a + b j" or "a + j b" from behind a. Blanks stand on both sides of the sign or on none: "10 -2j" are two cells.
    bool readSum(ComplexCell& cell)
    {
        const bool is_spaced = skipBlanks();
        if (at_ >= line_.size() || (line_[at_] != '+' && line_[at_] != '-')) return false;
        cell.is_subtracted = line_[at_++] == '-';
        if (skipBlanks() != is_spaced) return false;
        if (at_ < line_.size() && isImaginaryUnit(line_[at_])) {
            ++at_;
            take('*');
            cell.imaginary = number();
            return !cell.imaginary.empty();
        }
        cell.imaginary = number();
        return !cell.imaginary.empty() && takeUnit();
    }

    std::string_view line_;
    std::size_t at_;
    char decimal_;
};

bool beginsCell(std::string_view line, std::size_t at)
{
    return at == 0 || std::string_view(" \t,;|\"'").find(line[at - 1]) != std::string_view::npos;
}

std::vector<ComplexCell> complexCells(std::string_view line, char decimal)
{
    std::vector<ComplexCell> cells;
    for (std::size_t at = 0; at < line.size();) {
        const char c = line[at];
        const bool may_begin = detail::isDigit(c) || c == '-' || c == '+' || c == '.' || c == '(';
        auto cell = may_begin && beginsCell(line, at) ? ComplexParser(line, at, decimal).read() : std::nullopt;
        if (cell && at > 0 && (line[at - 1] == '"' || line[at - 1] == '\'') && cell->end < line.size() &&
            line[cell->end] == line[at - 1]) {
            --cell->begin;  // the quotes go with it
            ++cell->end;
        }
        if (cell) cells.push_back(*cell);
        at = cell ? cell->end : at + 1;
    }
    return cells;
}

/// The separator before a complex number, or behind it where it is the first cell; blanks only count as one.
char separatorAt(std::string_view line, const ComplexCell& cell)
{
    const auto search = [&line](std::size_t at, auto step) -> char {
        char blank = 0;
        while (at < line.size()) {
            const char c = line[at];
            if (c == ',' || c == ';' || c == '|' || c == '\t') return c;
            if (c != ' ' && c != '"' && c != '\'') return blank;
            if (c == ' ') blank = ' ';
            at = step(at);
        }
        return 0;
    };
    const char before = search(cell.begin - 1, [](std::size_t at) { return at - 1; });  // wraps at the begin: the end
    return before != 0 ? before : search(cell.end, [](std::size_t at) { return at + 1; });
}

/// Notation of complex numbers in a table.
struct ComplexStyle {
    char decimal = '.';
    char separator = ',';
};

char separatorOf(Delimiter delimiter)
{
    switch (delimiter) {
        case Delimiter::Space: return ' ';
        case Delimiter::Comma: return ',';
        case Delimiter::Semicolon: return ';';
        case Delimiter::Tab: return '\t';
        case Delimiter::Pipe: return '|';
        case Delimiter::Auto: break;
    }
    return 0;
}

/// The style of a row; none: it has no complex number beside another cell.
std::optional<ComplexStyle> styleOf(std::string_view line, const ImportOptions& options)
{
    // A decimal comma needs another separator around it.
    for (const char decimal : {',', '.'}) {
        if (options.decimal != Decimal::Auto && (options.decimal == Decimal::Comma) != (decimal == ',')) continue;
        const std::vector<ComplexCell> cells = complexCells(line, decimal);
        if (cells.empty()) continue;
        const std::string_view words = line.substr(cells[0].begin, cells[0].end - cells[0].begin);
        const char given = separatorOf(options.delimiter), found = separatorAt(line, cells[0]);
        const char separator = given != 0 ? given : found;
        if (separator == 0) continue;
        const bool has_comma =
            cells[0].real.find(',') != std::string_view::npos || cells[0].imaginary.find(',') != std::string_view::npos;
        if (decimal == ',' && options.decimal == Decimal::Auto &&
            (!has_comma || separator == ',' || words.find('.') != std::string_view::npos))
            continue;
        return ComplexStyle{decimal, separator};
    }
    return std::nullopt;
}

/// Style of the first row with a complex number, if most lines below it have one.
struct ComplexTable {
    ComplexStyle style;
    std::int64_t first_line = 0;
    std::vector<std::size_t> columns;  ///< cells that are complex, from 0
    std::size_t cells = 0;             ///< in a row
};

std::optional<ComplexTable> findComplex(std::string_view text, const ImportOptions& options)
{
    std::optional<ComplexTable> table;
    std::size_t rows = 0, all = 0;
    std::vector<Cell> parts;
    Lines lines(text);
    for (std::size_t k = 0; k < sampledRows && lines.next(); ++k) {
        const std::string_view line = lines.line();
        if (trimmed(line).empty()) continue;
        if (!table) {
            if (isRemark(line, ';')) continue;
            const auto style = styleOf(line, options);
            if (!style) continue;
            table = ComplexTable{*style, lines.number(), {}, 0};
            std::string masked(line);  // one character for each complex number
            std::size_t gone = 0;
            for (const ComplexCell& cell : complexCells(line, style->decimal)) {
                splitFields(std::string_view(masked).substr(0, cell.begin - gone), style->separator, parts);
                table->columns.push_back(parts.size() - (style->separator == ' ' || parts.empty() ? 0U : 1U));
                masked.replace(cell.begin - gone, cell.end - cell.begin, "0");
                gone += cell.end - cell.begin - 1;
            }
            splitFields(masked, style->separator, parts);
            dropEmptyEnd(parts, table->columns.back() + 1);
            table->cells = parts.size();
        }
        ++all;
        if (!complexCells(line, table->style.decimal).empty()) ++rows;
    }
    return table && 2 * rows >= all && table->cells > 1 ? table : std::nullopt;
}

/// A line of names or units with two cells for each complex one; as it is, when it has other cells.
std::string widened(std::string_view line, const ComplexTable& table)
{
    std::vector<Cell> cells;
    if (line.size() <= longestHeading) splitFields(line, table.style.separator, cells);
    dropEmptyEnd(cells, table.cells);
    std::string wide(line);
    if (cells.size() != table.cells || table.columns.back() >= cells.size()) return wide;
    for (std::size_t k = table.columns.size(); k-- > 0;) {
        const Cell cell = cells[table.columns[k]];
        const bool is_unit = frfUnit(cell).has_value();
        std::string unit = is_unit ? std::string(cell) : parseFrfHeading(cell).unit;
        if (table.style.separator == ' ') std::erase(unit, ' ');
        if (!is_unit && !unit.empty()) unit.insert(0, 1, '_');
        std::string two = is_unit ? unit : "real" + unit;
        two += table.style.separator;
        two += is_unit ? unit : "imag" + unit;
        wide.replace(static_cast<std::size_t>(cell.data() - line.data()), cell.size(), two);
    }
    return wide;
}

std::string expanded(std::string_view text, const ComplexTable& table, const Progress& progress)
{
    std::string all;
    all.reserve(text.size() + text.size() / 8);
    Lines lines(text);
    while (lines.next()) {
        if (lines.number() % linesPerProgress == 0) progress.check();
        const std::string_view line = lines.line();
        std::size_t done = 0;
        if (lines.number() < table.first_line) {
            const bool is_near = table.first_line - lines.number() <= static_cast<std::int64_t>(searchedHeadings);
            all += is_near ? widened(line, table) : std::string(line);
            done = line.size();
        } else {
            for (const ComplexCell& cell : complexCells(line, table.style.decimal)) {
                all += line.substr(done, cell.begin - done);
                all += cell.real.empty() ? "0" : cell.real;
                all += table.style.separator;
                const bool is_signed = cell.imaginary.front() == '-' || cell.imaginary.front() == '+';
                if (cell.is_subtracted && cell.imaginary.front() != '-') all += '-';
                all += cell.imaginary.substr(is_signed && cell.is_subtracted ? 1 : 0);
                done = cell.end;
            }
        }
        all += line.substr(done);
        all += '\n';
    }
    return all;
}

/// Words behind the numbers of the first row.
struct TrailingNames {
    std::vector<std::string> names;     ///< of the columns
    std::size_t begin = 0, length = 0;  ///< where the words stand in the text
};

/// "Freq Hz Real m/N Imag Real": a name, then its unit; a name for the second time ends the list.
std::vector<std::string> namesOfWords(const std::vector<std::string_view>& words)
{
    std::vector<std::string> names;
    std::vector<FrfRole> roles;
    for (const std::string_view word : words) {
        const FrfRole role = parseFrfHeading(word).role;
        const bool is_unit = !names.empty() && (frfUnit(word) || decibelUnit(word) || quantityUnit(word) ||
                                                (roles.size() == 1 && hzPerUnit(word)));
        if (is_unit) {
            if (names.back().find('(') == std::string::npos) names.back() += " (" + std::string(word) + ")";
        } else if (role == FrfRole::Other || std::find(roles.begin(), roles.end(), role) != roles.end()) {
            break;
        } else {
            roles.push_back(role);
            names.emplace_back(word);
        }
    }
    const auto has = [&roles](FrfRole role) { return std::find(roles.begin(), roles.end(), role) != roles.end(); };
    const bool is_response = has(FrfRole::Frequency) && ((has(FrfRole::Real) && has(FrfRole::Imaginary)) ||
                                                         (has(FrfRole::Magnitude) && has(FrfRole::Phase)));
    return is_response ? names : std::vector<std::string>{};
}

TrailingNames findTrailingNames(std::string_view text)
{
    Lines lines(text);
    while (lines.next() && trimmed(lines.line()).empty()) {
    }
    const std::string_view line = lines.line();
    if (line.size() > longestHeading) return {};
    const auto is_separator = [](char c) { return c == ' ' || c == '\t' || c == ',' || c == ';'; };
    std::vector<std::string_view> words;
    std::size_t numbers = 0, first_word = 0;
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() && !is_separator(line[end])) ++end;
        const std::string_view word = line.substr(at, end - at);
        if (!word.empty() && words.empty() && looksLikeNumber(word)) {
            ++numbers;
        } else if (!word.empty()) {
            if (words.empty()) first_word = at;
            words.push_back(word);
        }
        at = end + 1;
    }
    if (numbers < 3 || words.size() < 3) return {};
    return {namesOfWords(words), lines.offset() + first_word, line.size() - first_word};
}

}  // namespace

FrfText::FrfText(std::string_view text, const ImportOptions& options, const Progress& progress) : written_(text)
{
    if (const auto complex = findComplex(text, options)) {
        isComplex_ = true;
        changed_ = expanded(text, *complex, progress);
        return;
    }
    const TrailingNames trailing = findTrailingNames(text);
    if (trailing.names.empty()) return;
    names_ = trailing.names;
    changed_ = text;
    changed_.replace(trailing.begin, trailing.length, trailing.length, ' ');
}

void FrfText::name(TableLayout& layout) const
{
    if (names_.empty()) return;
    layout.has_names = true;
    for (std::size_t k = 0; k < names_.size() && k < layout.columns.size(); ++k) {
        layout.columns[k].heading = names_[k];
        layout.columns[k].name = lowerCase(names_[k].substr(0, names_[k].find(' ')));
    }
}

}  // namespace lathelier::io
