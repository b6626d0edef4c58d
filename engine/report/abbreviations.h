// Expansions of the abbreviations in headlines and tables, for tooltips on screen and in the HTML report.
#pragma once

#include <string>
#include <vector>

#include "engine/core/texts.h"

namespace lathelier::report {

struct Abbreviation {
    std::string letters;  ///< abbreviation, "RONt"
    Text meaning;         ///< expansion, "peak-to-valley roundness deviation"
};

/// The abbreviations that occur in `text` as whole words, each once, in the order of the list. Names after ISO 12181-1,
/// 12180-1.
std::vector<Abbreviation> abbreviationsIn(const std::string& text);

/// One line for each abbreviation in `text`: "RMS: root mean square"; empty when there is none.
std::string expansion(const std::string& text, const Language& language = {});

}  // namespace lathelier::report
