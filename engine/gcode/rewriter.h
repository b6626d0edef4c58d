// Local changes of an NC program: a new X, a block split into several. If a later block has an incremental X (U, G91),
// its word is adapted so that its end point is unchanged.
//
// Refused (block_not_rewritable, with line, block and reason): a block under G41 or G42, of the contour of G70…G73, run
// more than once (a subprogram called twice, a loop), of a cycle, whose X is computed, that ends in a chamfer or
// rounding, or that has no X to write.
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

struct RewrittenProgram {
    std::string text;  ///< the whole program, bytes of unchanged blocks as they were
    std::vector<BlockChange> changes;
    std::int64_t blocks_changed = 0;  ///< original blocks with changed text
    std::int64_t blocks_added = 0;
};

/// Plans changes by block (its index in Program::blocks, line - 1) and writes them all at once. Program and toolpath
/// have to outlive it. Coordinates are radii and program coordinates in mm; they are written in the units of the
/// program (diameters, inches), with `decimals` digits for a diameter or a Z in mm; a radius has one more, an inch two.
class Rewriter {
public:
    Rewriter(const Program& program, const Toolpath& path, int decimals = 3);

    /// Reason why this block cannot be changed; none: it can.
    std::optional<Error> refusal(std::size_t block) const;

    /// Sets a new end X of the block. A block without an X word (a cylinder along Z) gets one in front of its Z word.
    void setX(std::size_t block, double x_mm);

    /// Splits a feed move into straight ones through these points, the last of which is its end. The first keeps N, F,
    /// M and the comment of the block; the others hold X and Z only. An arc becomes G1 moves.
    void split(std::size_t block, std::vector<Point> points);

    /// X rounded to the output grid, as a radius.
    double rounded_mm(std::size_t block, double x_mm) const;

    /// Throws Error ncBlockNotRewritable for a planned change that is refused, or where a block that counts from a
    /// changed position may not be changed itself, or an arc begins at a changed X.
    RewrittenProgram write() const;

private:
    struct Plan {
        std::vector<Point> points;  ///< ends of the moves; the last one is the end of the block
    };
    int digitsOf(const BlockState& state, bool isX) const;
    [[noreturn]] void refuse(std::size_t block, Text reason) const;
    std::string number(std::size_t block, double value_mm, bool isX, const Word* like) const;
    std::string firstText(std::size_t block, const Point& from, const Point& to, bool isSplit) const;

    const Program& program_;
    const Toolpath& path_;
    int decimals_;
    std::map<std::size_t, Plan> plans_;
};

}  // namespace lathelier::gcode
