#include "engine/io/text/number_cell.h"

#include <cmath>
#include <limits>
#include <vector>

#include "engine/io/table/table_style.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {

NumberCells::NumberCells(const ScanSource& source) : text_(source.text), option_(source.options.decimal) {}

double NumberCells::read(std::int64_t lineNumber, std::string_view line, std::string_view word)
{
    double value = 0;
    const char* const end = word.data() + word.size();
    if (parseNumber(word.data(), end, decimal_, value) == end && !word.empty()) return value;
    if (isNotFiniteWord(word)) return std::numeric_limits<double>::quiet_NaN();
    const bool comma = decimal_ == '.' && option_ != Decimal::Point && word.find(',') != std::string_view::npos &&
                       parseNumber(word.data(), end, ',', value) == end;
    if (!comma) throw malformed(lineNumber, line, word, LT_TEXT("Engine", "a number"));
    // The search starts at this line, since remarks above may contain commas.
    if (option_ == Decimal::Auto) {
        const auto offset = static_cast<std::size_t>(line.data() - text_.data());
        const CommaMeaning meaning = meaningOfCommas(text_.substr(offset));
        if (meaning == CommaMeaning::Unknown) throw ambiguousNumber(lineNumber, line, word);
        if (meaning == CommaMeaning::Grouping) throw malformed(lineNumber, line, word, LT_TEXT("Engine", "a number"));
    }
    decimal_ = ',';
    return value;
}

Values placeOfLarge(std::string_view text, std::string_view keyword, char decimal, double largest)
{
    Lines lines(text);
    std::vector<std::string_view> words;
    while (lines.next()) {
        splitWords(lines.line(), words);
        if (words.size() < 4 || lowerCase(words[0]) != keyword) continue;
        for (std::size_t k = 1; k < 4; ++k) {
            const auto value = wholeNumber(words[k], decimal);
            if (value && std::abs(*value) > largest && std::isfinite(*value)) {
                const auto offset = static_cast<std::size_t>(words[k].data() - lines.line().data());
                return {{"line", lines.number()}, {"column", columnAt(lines.line(), offset)}};
            }
        }
    }
    return {{"line", std::int64_t{1}}, {"column", std::int64_t{1}}};
}

}  // namespace lathelier::io
