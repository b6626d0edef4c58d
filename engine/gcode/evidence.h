// What tells from the text of a program which control it is for.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace lathelier::gcode {

/// Points for a line of the text, which is compared in capitals and without comments in brackets.
struct TextSign {
    int points = 0;                  ///< once for a line
    std::vector<std::string> lines;  ///< patterns of the whole line, one of which matches; * stands for any text, ? for
                                     ///< one digit
};

/// Points for a block by its letters and numbers. All conditions hold; an empty one does not count.
struct BlockSign {
    int points = 0;
    std::vector<int> g = {};         ///< one of these G words, by the whole part of their number, at most 199
    std::vector<int> also_g = {};    ///< and one of these
    std::vector<int> no_g = {};      ///< none of these
    std::vector<double> exact = {};  ///< one of these G words by their number: 91.1
    std::vector<int> m = {};         ///< the last M word is one of these
    std::string letters = {};        ///< all of these letters
    std::string one_of = {};         ///< one of these
    std::string none_of = {};        ///< none of these
    std::size_t least_digits = 0, most_digits = 0;  ///< of the last T word, before its point; 0: any number
};

/// A control is told by its points over all lines:
/// - those with `certain` points are told whatever the others have, the first of the list;
/// - else the one with most points among those that are variants of none; of equal points, that of the higher rank;
///   without any points, the first of the list;
/// - that one gives way to a variant of it with `certain` points, to that of the highest rank among several.
struct Evidence {
    std::vector<TextSign> texts;
    std::vector<BlockSign> blocks;
    int casual_line = 0;     ///< points of a line that begins with a small letter or has a comment behind ";" only
    int certain = 0;         ///< points that are enough; 0: never
    std::string variant_of;  ///< key of the control whose words these are too; empty: of none
    int rank = 0;            ///< of equal points
};

}  // namespace lathelier::gcode
