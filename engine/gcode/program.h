// An NC program as text with its words. The text is neither changed nor normalised: blocks and words are ranges of
// bytes, so the program written back is the program read, byte for byte (mixed line ends, byte order mark, Latin-1,
// missing last line end, digit style).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"
#include "engine/gcode/control.h"
#include "engine/gcode/controls/controls.h"
#include "engine/gcode/declared_names.h"
#include "engine/gcode/diagnostic.h"

namespace lathelier::gcode {

/// A program larger than this is refused (nc_program_too_long).
inline constexpr std::size_t largestProgram_bytes = std::size_t{1} << 30;

/// Number: letter and number (X28.). Expression: letter and expression (X[#1+2.], X=R1, CR=5). Assignment: #1=…, R1=….
/// Flow: the rest of a block with a statement (IF, WHILE, GOTO, o100 sub). Name: a word of its own (DIAMON,
/// a label). Call: a name with arguments (MSG("…"), CYCLE95(…)). Bad: none of these.
enum class WordKind : std::uint8_t { Number, Expression, Assignment, Flow, Name, Call, Comment, Bad };

/// A range of the text. Comments are in the list, but not counted as words.
struct Word {
    std::uint32_t begin = 0;  ///< first byte, in Program::text
    std::uint32_t length = 0;
    std::uint32_t value_begin = 0;  ///< first byte of the number or expression
    WordKind kind = WordKind::Bad;  ///< syntactic form
    char letter = 0;                ///< capital address; small for ",C" and ",R"; 0: a name of several letters
    bool has_point = false;         ///< the number has a decimal point
    bool is_understood = true;      ///< false: unknown or not modelled
    double value = 0;               ///< of a Number, as written
};

/// One line of the text.
struct Block {
    std::uint32_t begin = 0;
    std::uint32_t length = 0;      ///< bytes without the line end
    std::uint32_t first_word = 0;  ///< in Program::words
    std::uint32_t word_count = 0;  ///< comments included
    bool has_skip = false;         ///< begins with “/”
    bool is_malformed = false;     ///< contains text that is not a word: not executed
};

/// A program of another file that stands behind the one that calls it, as if it were of the same file.
struct ProgramPart {
    std::string name;  ///< by which it is called: "O1234", "L54"; where its text declares none
    std::string path;
    std::string text;
};

/// Where the blocks of a part begin.
struct PartPlace {
    std::string name, path;
    std::uint32_t begin = 0;               ///< first byte, in Program::text
    std::size_t first_block = notReached;  ///< in Program::blocks

    static constexpr std::size_t notReached = INT64_MAX;  ///< while the blocks before it are read
};

/// A line of one of the files.
struct LinePlace {
    std::string path;       ///< of a part; empty: the program itself
    std::int64_t line = 0;  ///< from 1
};

struct Program {
    std::string text;                     ///< every byte as it was read; behind it those of the parts
    std::size_t own_bytes = 0;            ///< of the program itself
    std::vector<PartPlace> parts;         ///< programs of other files
    ControlPtr control = usualControl();  ///< what it was read with; never nullptr
    bool is_utf8 = true;                  ///< columns count characters of UTF-8; else bytes
    std::vector<Block> blocks;            ///< lines, from the first to the last
    std::vector<Word> words;              ///< of all blocks, in order
    Diagnostics diagnostics;              ///< of parsing alone
    DeclaredNames names;                  ///< that it declares

    std::string_view textOf(const Block& block) const
    {
        return std::string_view(text).substr(block.begin, block.length);
    }
    std::string_view textOf(const Word& word) const { return std::string_view(text).substr(word.begin, word.length); }
    /// The number or expression of a word.
    std::string_view valueOf(const Word& word) const
    {
        return std::string_view(text).substr(word.value_begin, word.begin + word.length - word.value_begin);
    }
    /// Lines count on through the parts.
    std::int64_t lineOf(const Block& block) const { return &block - blocks.data() + 1; }
    LinePlace placeOf(std::int64_t line) const;
    std::string_view ownText() const { return std::string_view(text).substr(0, own_bytes); }
    /// Characters from the beginning of the block, from 1.
    std::int64_t columnOf(const Block& block, std::uint32_t offset) const;
    /// The last word with this letter in a block, as controls use it; nullptr: none.
    const Word* wordOf(const Block& block, char letter) const;
};

/// At most 40 characters of a part of the text as UTF-8, for messages.
std::string shown(const Program& program, std::string_view part);

/// Number of words without comments.
std::int64_t countWords(const Program& program);
std::int64_t countUnderstood(const Program& program);

/// Splits a program into blocks and words and classifies each word by the tables of its control, which may be any
/// Control that is read; nullptr: that of detectControl(), to which `name` is the name of the file.
/// Throws Error ncDialectNotRead (line, found), dialectUnclear (line, first, second, choices), ncTooLong, formatUnknown
/// (UTF-16, binary), fileEmpty; those of a part with its path. All other problems are diagnostics. Cost: one pass,
/// about 0.3 µs a word; 24 bytes for each word and 20 for each block.
Program readProgram(std::string text, const ControlPtr& control = nullptr, const Progress& progress = {},
                    std::string_view name = {}, const std::vector<ProgramPart>& parts = {});

/// The words of one line alone, classified as in readProgram(): for an editor that shows few lines. Offsets are those
/// in `line`.
std::vector<Word> wordsOfLine(std::string line, const ControlPtr& control);

/// Adds a diagnostic at a byte of a block: line, column and the text of the block are filled in.
void report(const Program& program, Diagnostics& list, const Block& block, std::uint32_t offset, const ErrorCode& code,
            Values values = {});
void report(const Program& program, Diagnostics& list, const Block& block, std::uint32_t offset, const NoteCode& code,
            Values values = {}, std::optional<GapEffect> gap = {});

}  // namespace lathelier::gcode
