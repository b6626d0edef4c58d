#include "engine/gcode/tool_table.h"

#include <cctype>
#include <cmath>

#include "engine/gcode/gcode_codes.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::gcode {

ToolTable readToolTable(std::string_view text)
{
    ToolTable tools;
    const io::DecodedText decoded = io::decodeText(text, io::Encoding::Auto);
    std::vector<std::string_view> words;
    bool isEmpty = true;
    for (io::Lines lines(decoded.view()); lines.next();) {
        const std::string_view line = lines.line().substr(0, lines.line().find(';'));
        io::splitWords(line, words);
        if (words.empty()) continue;
        isEmpty = false;
        int number = -1, tip = 9;
        double diameter_mm = 0;
        for (const std::string_view word : words) {
            const auto value = io::wholeNumber(word.substr(1), '.');
            const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
            const bool isWrong = !value || !std::isfinite(*value) ||
                                 std::string_view("TPDXYZABCUVWIJQ").find(letter) == std::string_view::npos ||
                                 (letter == 'Q' && (*value < 0 || *value > 9)) || (letter == 'D' && *value < 0) ||
                                 (letter == 'T' && (*value < 0 || *value > 1e6));
            if (isWrong)
                throw Error(errors::toolTableMalformed,
                            {{"line", lines.number()},
                             {"column",
                              io::columnAt(lines.line(), static_cast<std::size_t>(word.data() - lines.line().data()))},
                             {"found", io::excerpt(word)},
                             {"expected", LT_TEXT("Engine", "T, P, D, Q (0 to 9) or an offset with a number")}});
            if (letter == 'T') number = static_cast<int>(*value);
            if (letter == 'D') diameter_mm = *value;
            if (letter == 'Q') tip = tipOfOrientation[static_cast<std::size_t>(*value)];
        }
        if (number < 0)
            throw Error(errors::toolTableMalformed, {{"line", lines.number()},
                                                     {"column", std::int64_t{1}},
                                                     {"found", io::excerpt(line)},
                                                     {"expected", LT_TEXT("Engine", "a tool number T")}});
        if (diameter_mm > 0) tools[number] = {.number = number, .tip = tip, .corner_radius_mm = diameter_mm / 2};
    }
    if (isEmpty) throw Error(errors::fileEmpty, {});
    return tools;
}

}  // namespace lathelier::gcode
