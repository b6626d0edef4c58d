#include "engine/io/table/table_style.h"

#include <algorithm>

#include "engine/io/text/number.h"

namespace lathelier::io {
namespace {

std::vector<char> delimitersToTry(Delimiter delimiter)
{
    switch (delimiter) {
        case Delimiter::Space: return {' '};
        case Delimiter::Comma: return {','};
        case Delimiter::Semicolon: return {';'};
        case Delimiter::Tab: return {'\t'};
        case Delimiter::Pipe: return {'|'};
        case Delimiter::Auto: break;
    }
    return {'\t', ';', '|', ',', ' '};
}

/// Fit of a separator to the sample.
struct Fit {
    std::size_t columns = 0;
    double quality = 0;
};

Fit fitOf(char delimiter, const std::vector<SampleLine>& sample, std::size_t minimumColumns)
{
    std::vector<std::pair<std::size_t, double>> byColumns;  // number of columns, sum of the shares of numbers
    std::vector<Cell> cells;
    TableStyle style;
    style.delimiter = delimiter;
    for (const SampleLine& line : sample) {
        splitCells(line.text, style, cells);
        if (cells.size() > 1 && cells.back().empty()) cells.pop_back();  // a separator ends the row
        const auto numbers = static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), looksLikeNumber));
        if (numbers < minimumColumns || numbers * 2 < cells.size()) continue;
        const double share = static_cast<double>(numbers) / static_cast<double>(cells.size());
        const auto known = std::find_if(byColumns.begin(), byColumns.end(),
                                        [&](const auto& entry) { return entry.first == cells.size(); });
        if (known == byColumns.end())
            byColumns.emplace_back(cells.size(), share);
        else
            known->second += share;
    }
    Fit best;
    for (const auto& [columns, quality] : byColumns)
        if (quality > best.quality) best = {columns, quality};
    return best;
}

/// Sets decimal mark and grouping from the evidence of the cells.
void decideDecimal(const std::vector<SampleLine>& rows, std::string_view whole, const ImportOptions& options,
                   TableStyle& style)
{
    std::vector<Cell> cells;
    std::size_t counts[6] = {};
    bool groupedByPoint = false;
    bool groupedByComma = false;
    const SampleLine* loneLine = nullptr;
    Cell loneCell;
    for (const SampleLine& line : rows) {
        splitCells(line.text, style, cells);
        for (const Cell cell : cells) {
            const auto [evidence, grouping] = evidenceOf(cell);
            ++counts[static_cast<std::size_t>(evidence)];
            groupedByComma = groupedByComma || (evidence == Evidence::Point && grouping == ',');
            groupedByPoint = groupedByPoint || (evidence == Evidence::Comma && grouping == '.');
            if (evidence == Evidence::LoneComma && !loneLine) {
                loneLine = &line;
                loneCell = cell;
            }
        }
    }
    const auto count = [&counts](Evidence evidence) { return counts[static_cast<std::size_t>(evidence)]; };
    if (options.decimal != Decimal::Auto) {
        style.decimal = options.decimal == Decimal::Comma ? ',' : '.';
        style.grouped = true;
        return;
    }
    Evidence verdict = count(Evidence::Comma) > count(Evidence::Point) ? Evidence::Comma : Evidence::Point;
    if (count(Evidence::Comma) == 0 && count(Evidence::Point) == 0 && loneLine) {
        const CommaMeaning meaning = count(Evidence::LonePoint) > 0 ? CommaMeaning::Unknown : meaningOfCommas(whole);
        if (meaning == CommaMeaning::Unknown) throw ambiguousNumber(loneLine->number, loneLine->text, loneCell);
        verdict = meaning == CommaMeaning::Decimal ? Evidence::Comma : Evidence::Point;
        groupedByComma = meaning == CommaMeaning::Grouping;
    }
    style.decimal = verdict == Evidence::Comma ? ',' : '.';
    style.grouped = verdict == Evidence::Comma ? groupedByPoint : groupedByComma;
}

}  // namespace

CommaMeaning meaningOfCommas(std::string_view text)
{
    for (std::size_t at = text.find(','); at != std::string_view::npos; at = text.find(',', at + 1)) {
        std::size_t begin = at;
        while (begin > 0 && detail::isDigit(text[begin - 1])) --begin;
        std::size_t end = at + 1;
        while (end < text.size() && detail::isDigit(text[end])) ++end;
        const std::size_t before = at - begin;
        const std::size_t after = end - at - 1;
        if (before == 0 || after == 0) continue;
        if (before > 3 || text[begin] == '0' || after != 3) return CommaMeaning::Decimal;
        if (end + 1 < text.size() && (text[end] == ',' || text[end] == '.') && detail::isDigit(text[end + 1]))
            return CommaMeaning::Grouping;
    }
    return CommaMeaning::Unknown;
}

StyleFound findStyle(const std::vector<SampleLine>& sample, std::string_view whole, std::size_t minimumColumns,
                     const ImportOptions& options)
{
    StyleFound result;
    Fit best;
    for (const char delimiter : delimitersToTry(options.delimiter)) {
        const Fit fit = fitOf(delimiter, sample, minimumColumns);
        // If one column is sufficient, "1,250" and "1 250" may still be two: a comma or blank as separator has
        // precedence.
        const bool splitsMore = best.columns == 1 && fit.columns > 1 && fit.quality >= best.quality;
        if (fit.quality > best.quality || splitsMore) {
            best = fit;
            result.style.delimiter = delimiter;
        }
    }
    result.columns = best.columns;
    if (best.columns == 0) return result;
    std::vector<SampleLine> rows;
    std::vector<Cell> cells;
    for (const SampleLine& line : sample) {
        splitCells(line.text, result.style, cells);
        dropEmptyEnd(cells, best.columns);
        if (cells.size() == best.columns) rows.push_back(line);
    }
    decideDecimal(rows, whole, options, result.style);
    return result;
}

}  // namespace lathelier::io
