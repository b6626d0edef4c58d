#include "engine/report/plain_text.h"

#include <algorithm>

#include "engine/core/utf8.h"
#include "engine/report/cells.h"

namespace lathelier::report {
namespace {

std::string spaces(std::size_t wanted, std::size_t used)
{
    return std::string(wanted > used ? wanted - used : 0, ' ');
}

std::string padded(const std::string& text, std::size_t width, bool right)
{
    const std::string room = spaces(width, countCharacters(text));
    return right ? room + text : text + room;
}

std::string tableText(const QuantityTable& table, const Language& language)
{
    std::size_t name = 0;
    std::size_t value = 0;
    for (const Quantity& row : table.rows) {
        name = std::max(name, countCharacters(captionText(row.name, language)));
        value = std::max(value, countCharacters(cellText(row.value, row.unit, row.decimals, language)));
    }
    std::string result = captionText(table.title, language) + "\n";
    for (const Quantity& row : table.rows) {
        std::string line = "  " + padded(captionText(row.name, language), name, false) + "  " +
                           padded(cellText(row.value, row.unit, row.decimals, language), value, isNumeric(row.value)) +
                           " " + text(shownUnit(row.unit, language).unit, language);
        line.erase(line.find_last_not_of(' ') + 1);
        result += line + "\n";
    }
    return result;
}

std::string tableText(const Table& table, const Language& language)
{
    std::vector<std::vector<std::string>> lines(1);
    for (const Caption& column : table.columns) lines[0].push_back(captionText(column, language));
    for (const std::vector<Value>& row : table.rows) {
        std::vector<std::string>& line = lines.emplace_back();
        for (std::size_t i = 0; i < row.size(); ++i)
            line.push_back(cellText(row[i], table.unitOf(i), table.decimalsOf(i), language));
    }
    std::vector<std::size_t> widths(table.columns.size());
    for (const auto& line : lines)
        for (std::size_t i = 0; i < std::min(line.size(), widths.size()); ++i)
            widths[i] = std::max(widths[i], countCharacters(line[i]));
    std::string result = captionText(table.title, language) + "\n";
    for (const auto& line : lines) {
        for (std::size_t i = 0; i < std::min(line.size(), widths.size()); ++i)
            result += "  " + padded(line[i], widths[i], true);
        result += "\n";
    }
    return result;
}

}  // namespace

std::string toPlainText(const Section& section, const Language& language)
{
    std::string result;
    bool is_below_heading = true;
    for (const Block& block : section.blocks) {
        std::string piece;
        if (const auto* answer = std::get_if<Answer>(&block))
            piece = plainText(*answer, language);
        else if (const auto* paragraph = std::get_if<Paragraph>(&block))
            piece = fill(text(paragraph->pattern, language), paragraph->values, language) + "\n";
        else if (const auto* quantities = std::get_if<QuantityTable>(&block))
            piece = tableText(*quantities, language);
        else if (const auto* table = std::get_if<Table>(&block))
            piece = tableText(*table, language);
        if (piece.empty()) continue;
        result += (is_below_heading ? "" : "\n") + piece;
        const auto* const heading = std::get_if<QuantityTable>(&block);  // a title without rows heads what follows
        is_below_heading = heading && heading->rows.empty();
    }
    return result;
}

}  // namespace lathelier::report
