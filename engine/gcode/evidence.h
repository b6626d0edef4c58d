// What tells from the text of a program which control it is for.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace lathelier::gcode {

/// Points for a line of the text, which is compared in capitals and without comments. Negative ones speak against.
struct TextSign {
    int points = 0;
    std::vector<std::string> lines;  ///< patterns of the whole line, one of which matches; * stands for any text, ? for
                                     ///< one digit
};

/// Points for a block by its letters and numbers. All conditions hold; an empty one does not count. The letters of
/// comma words (",C2.") are small.
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

/// Points for a program that has a block for each of these signs, whose own points do not count.
struct ProgramSign {
    int points = 0;
    std::vector<BlockSign> blocks;
};

/// A control is told by its points. Each sign counts once, however often a program shows it: a long program tells no
/// more than a short one.
/// - those with `certain` points are told whatever the others have, the first of the list;
/// - else the one with most points among those that are variants of none. To them those count of its variant that has
///   most (speaks_for_base), if it has some itself. Of equal points, that of the higher rank; ControlFound::rival names
///   the other one. Without any points, the first of the list;
/// - that one gives way to the variant of it that has most points among those with `certain` ones; of equal points,
///   that of the higher rank.
struct Evidence {
    std::vector<TextSign> texts;
    std::vector<TextSign> remarks;  ///< the same for what stands between the brackets of a comment
    std::vector<TextSign> names;    ///< the same for the name of the file
    std::vector<BlockSign> blocks;
    std::vector<ProgramSign> programs;
    int certain = 0;               ///< points that are enough; 0: never
    std::string variant_of;        ///< key of the control whose words these are too; empty: of none
    bool speaks_for_base = false;  ///< its points count for the control that it is a variant of
    int rank = 0;                  ///< of equal points
};

}  // namespace lathelier::gcode
