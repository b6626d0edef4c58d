// From programmed moves to those of the imaginary tip: chamfers and roundings between two moves (,C ,R CHF= CHR= RND=),
// then nose radius compensation (G41, G42).
//
// Compensation follows LinuxCNC's interpreter, for every dialect: at the end of the block that starts it up the nose
// centre is perpendicular to that block; outside corners are rounded about the corner (not where they turn by less than
// 0.05 rad, nor between rapid moves); at inside corners the shifted pieces are cut off where they meet; the last block
// ends perpendicular to itself. The machined surface equals that of controls that extend the pieces instead. From a
// position that is not known it starts perpendicular to the next block.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/error.h"
#include "engine/gcode/arc.h"
#include "engine/gcode/move.h"
#include "engine/gcode/toolpath.h"

namespace lathelier::gcode {

enum class CornerKind : std::uint8_t { None, Legs, Chord, Round };

/// Corner element between a move and the next one.
struct Corner {
    CornerKind kind = CornerKind::None;  ///< Legs: distance from the corner along both; Chord: length of the chamfer
    double size_mm = 0;                  ///< of legs, chord or radius
};

enum class NoseSide : std::uint8_t { Off, Left, Right };

/// A corner or offset that is impossible, reported at its block.
struct PathProblem {
    std::int64_t line = 0;
    const ErrorCode* code = nullptr;
    double size_mm = 0;
};

class PathBuilder {
public:
    explicit PathBuilder(std::vector<Move>& out) : out_(&out) {}

    /// A move from the programmed point `from` (coordinates may be unknown).
    void add(const Move& move, const Point& from, const Corner& corner = {});
    /// Takes effect with the next move. A radius of 0 leaves the path as programmed. `tip`: Fanuc's number.
    void setNose(NoseSide side, double radius_mm, int tip);
    /// Emits the pending moves.
    void finish();

    std::vector<PathProblem> problems;  ///< problems since the list was last cleared

private:
    struct Waiting {
        Move move;
        Piece programmed;
        Corner corner;
    };
    struct Compensated {
        Move move;
        Piece programmed;
        Piece tip;                  ///< of the nose centre
        bool ends_by_next = false;  ///< its end depends on the next move
        bool is_start_up = false;
        std::vector<Move> after;  ///< dwells behind it
    };

    void join(Waiting& next);
    void hand(const Move& move, const Piece& piece);
    void startUp(const Move& move, const Piece& piece);
    void connect(Compensated& last, Compensated& next);
    void flushNose();
    void put(const Compensated& done);

    std::vector<Move>* out_;
    std::optional<Waiting> waiting_;
    NoseSide side_ = NoseSide::Off;
    double radius_mm_ = 0;
    int tip_ = 3;
    bool isStarted_ = false;
    std::optional<Compensated> last_;
};

}  // namespace lathelier::gcode
