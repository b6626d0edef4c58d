#include "engine/report/abbreviations.h"

#include <cctype>

namespace lathelier::report {
namespace {

const std::vector<Abbreviation>& known()
{
    static const std::vector<Abbreviation> all{{"RMS", LT_TEXT("Engine", "root mean square")},
                                               {"RMSE", LT_TEXT("Engine", "root mean square error")},
                                               {"RONt", LT_TEXT("Engine", "peak-to-valley roundness deviation")},
                                               {"RONp", LT_TEXT("Engine", "peak-to-reference roundness deviation")},
                                               {"RONv", LT_TEXT("Engine", "reference-to-valley roundness deviation")},
                                               {"RONq", LT_TEXT("Engine", "root mean square roundness deviation")},
                                               {"CYLt", LT_TEXT("Engine", "peak-to-valley cylindricity deviation")},
                                               {"LSCI", LT_TEXT("Engine", "least squares reference circle")},
                                               {"MZCI", LT_TEXT("Engine", "minimum zone reference circles")},
                                               {"MICI", LT_TEXT("Engine", "maximum inscribed reference circle")},
                                               {"MCCI", LT_TEXT("Engine", "minimum circumscribed reference circle")},
                                               {"LSCY", LT_TEXT("Engine", "least squares reference cylinder")},
                                               {"MZCY", LT_TEXT("Engine", "minimum zone reference cylinders")},
                                               {"UPR", LT_TEXT("Engine", "undulations per revolution")},
                                               {"G", LT_TEXT("Engine", "Gaussian filter")},
                                               {"sd", LT_TEXT("Engine", "standard deviation")},
                                               {"MAD", LT_TEXT("Engine", "median absolute deviation")}};
    return all;
}

/// Non-ASCII bytes are not letters: no-break spaces separate numbers from units.
bool isLetter(char c)
{
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x80 && std::isalnum(byte) != 0;
}

bool standsIn(const std::string& text, const std::string& word)
{
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !isLetter(text[at - 1])) && (end == text.size() || !isLetter(text[end]))) return true;
    }
    return false;
}

}  // namespace

std::vector<Abbreviation> abbreviationsIn(const std::string& text)
{
    std::vector<Abbreviation> found;
    for (const Abbreviation& one : known())
        if (standsIn(text, one.letters)) found.push_back(one);
    return found;
}

std::string expansion(const std::string& line, const Language& language)
{
    std::string result;
    for (const Abbreviation& one : abbreviationsIn(line))
        result += (result.empty() ? "" : "\n") + one.letters + ": " + text(one.meaning, language);
    return result;
}

}  // namespace lathelier::report
