// Local changes of an NC program: a new X, a block split into several. If a later block has an incremental X (U, G91),
// its word is adapted so that its end point is unchanged. Added blocks hold coordinates, for an arc the words of its
// centre or radius as in their block, and what the block has in front of its words and as its end: “/”, “;”.
//
// Refused (block_not_rewritable, with line, block and reason): a block under G41 or G42, of the contour of G70…G73, run
// more than once (a subprogram called twice, a loop), of a cycle, whose X is computed, that ends in a chamfer or
// rounding, that holds a word which is not known to leave the path alone, or that has no X to write. A program is also
// interpreted without its blocks behind “/”: what is left of it has to end where it ended, too.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/gcode/toolpath.h"

namespace lathelier::gcode {

/// A changed or added block.
struct BlockChange {
    std::int64_t line = 0;              ///< of the original block; of an added one: the block that it follows
    std::optional<std::string> before;  ///< text of the block; none: added
    std::string after;                  ///< text of the block
    std::size_t part = 0;               ///< index of the point planned for the block that it leads to
};

/// A move that a block is split into.
struct PathPart {
    Point end;
    std::optional<Point> centre{};  ///< of an arc, in the direction of the block; none: straight
};

struct RewrittenProgram {
    std::string text;  ///< the whole program, bytes of unchanged blocks as they were
    std::vector<BlockChange> changes;
    std::int64_t blocks_changed = 0;  ///< original blocks with changed text
    std::int64_t blocks_added = 0;
};

/// Plans changes by block (its index in Program::blocks, line - 1) and writes them all at once. Program and toolpath
/// have to outlive it. Coordinates are radii and program coordinates in mm; they are written in the units of the
/// program (diameters, inches), with `decimals` digits for a diameter or a length in mm; a radius of a turned X has one
/// more, and so has an inch.
class Rewriter {
public:
    Rewriter(const Program& program, const Toolpath& path, int decimals = 3);

    /// Reason why this block cannot be changed; none: it can.
    std::optional<Error> refusal(std::size_t block) const;

    /// The same for its words alone, with `word`: those that shape its end, and those of which it is not known that
    /// they leave its path alone.
    std::optional<Error> refusalOfWords(std::size_t block) const;

    /// Sets a new end X of the block. A block without an X word (a cylinder along Z) gets one in front of its Z word.
    void setX(std::size_t block, double x_mm);

    /// Splits a feed move into parts, the last of which ends where it ends. The first keeps N, F, M and the comment of
    /// the block. A straight part of an arc gets a G1, and an arc after it the G word of the block.
    void split(std::size_t block, std::vector<PathPart> parts);

    /// X rounded to the output grid, as a radius.
    double rounded_mm(std::size_t block, double x_mm) const;

    /// Throws Error ncBlockNotRewritable for a planned change that is refused, or where a block that counts from a
    /// changed position may not be changed itself, or an arc begins at a changed X.
    RewrittenProgram write() const;

private:
    /// How the words of a program are written.
    struct Style {
        bool has_blanks = true;    ///< between words
        bool ends_blocks = false;  ///< ";" ends most blocks
    };
    struct Written {
        RewrittenProgram program;
        std::vector<double> change_mm;       ///< of X at the end of each block
        std::vector<std::size_t> last_line;  ///< index of the last written line of each block
    };
    int digitsOf(const BlockState& state, bool isX) const;
    [[noreturn]] void refuse(std::size_t block, Text reason, const Word* word = nullptr) const;
    void checkWords(std::size_t block) const;
    std::string formatted(double value, int digits, bool keepsPoint) const;
    std::string number(std::size_t block, double value_mm, bool isX, const Word* like) const;
    std::string centreNumber(std::size_t block, double centre_mm, double from_mm, bool isX, const Word* like) const;
    Style styleOf(const Block& block) const;
    std::string firstText(std::size_t block, const Point& from, const PathPart& to, bool isSplit) const;
    std::string addedText(std::size_t block, const Point& from, const PathPart& to, bool wasArc) const;
    Point rounded(std::size_t block, const Point& point) const;
    Written written() const;
    void checkSkipped(const Written& written) const;

    const Program& program_;
    const Toolpath& path_;
    int decimals_;
    Style style_;                                         ///< of most blocks
    std::map<std::size_t, std::vector<PathPart>> plans_;  ///< the last part ends the block
};

}  // namespace lathelier::gcode
