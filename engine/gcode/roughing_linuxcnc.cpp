// Passes along the axis of the cycle down to the contour, then along the contour. In places (p, q): p is larger on the
// side of the start, q falls along the contour.
#include "engine/gcode/roughing_linuxcnc.h"

#include <algorithm>
#include <cmath>

#include "engine/gcode/contour_distance.h"
#include "engine/gcode/level_contour.h"

namespace lathelier::gcode {
namespace {

constexpr double roundingOfSubroutineCycle = 1e-9;  ///< closer than this, the last digit decides

enum class Monotony : std::uint8_t { Holds, Fails, Unsure };

/// Does a change, which is to be no less than zero, hold?
Monotony holdsFor(double change)
{
    constexpr double clear = 1e-2;
    if (change >= -roundingOfSubroutineCycle) return Monotony::Holds;
    return change < -clear ? Monotony::Fails : Monotony::Unsure;
}

/// Does the contour never return along an axis, `along` being its component of a point?
template <class Along>
Monotony monotony(const std::vector<Piece>& contour, const Along& along)
{
    const double way = along(contour.back().to) - along(contour.front().from);
    if (std::abs(way) < sameLevel_mm) return Monotony::Unsure;
    Monotony result = Monotony::Holds;
    for (const Piece& piece : contour) {
        const Direction in = directionAtStart(piece), out = directionAtEnd(piece);
        const double change = along(piece.to) - along(piece.from);
        for (const double one : {change, along({in.x, in.z}), along({out.x, out.z})}) {
            const Monotony found = holdsFor(way < 0 ? -one : one);
            if (found == Monotony::Fails) return found;
            if (found == Monotony::Unsure) result = found;
        }
        if (sweepOf(piece) > 3.1 && result == Monotony::Holds) result = Monotony::Unsure;
    }
    return result;
}

class SubroutineCycler {
public:
    SubroutineCycler(const SubroutineCycle& cycle, const std::vector<Piece>& contour)
        : cycle_(cycle), contour_(contour.begin() + 1, contour.end())
    {
    }

    SubroutineCycleMoves run()
    {
        if (!chooseAxes() || !(cycle_.kind == SubroutineCycle::Kind::Finish ? finish() : rough())) {
            found_.moves.clear();
            found_.is_modelled = false;
        }
        return std::move(found_);
    }

private:
    using Kind = SubroutineCycle::Kind;

    /// The axis along which the contour never returns; of finishing, Z if it can be.
    bool chooseAxes()
    {
        const auto x = [](const Point& at) { return at.x_mm; };
        const auto z = [](const Point& at) { return at.z_mm; };
        axes_.is_face = cycle_.kind == Kind::Face;
        Monotony state = axes_.is_face ? monotony(contour_, x) : monotony(contour_, z);
        if (cycle_.kind == Kind::Finish && state == Monotony::Fails) {
            axes_.is_face = true;
            state = monotony(contour_, x);
        }
        if (state == Monotony::Fails)
            found_.refused = LT_TEXT("Engine", "the contour returns along the axis of the cycle");
        const Point& first = contour_.front().from;
        axes_.sign_q = axes_.feedAxis(contour_.back().to) <= axes_.feedAxis(first) ? 1 : -1;
        axes_.sign_p = axes_.depthAxis(cycle_.start) >= axes_.depthAxis(first) ? 1 : -1;
        begin_ = axes_.place(first);
        home_ = axes_.place(cycle_.start);
        home_.q = std::max(home_.q, begin_.q);
        // Along +Z, finishing takes X where the contour ends across it; when exactly is not known.
        if (cycle_.kind == Kind::Finish && !axes_.is_face && axes_.sign_q < 0 &&
            std::abs(directionAtEnd(contour_.back()).z) < 1e-3)
            return false;
        return state == Monotony::Holds;
    }

    void go(MoveKind kind, const Place& at)
    {
        CycleMove move;
        move.kind = kind;
        move.to = axes_.point(at);
        found_.moves.push_back(move);
    }

    void along(const Piece& piece)
    {
        go(piece.isArc() ? MoveKind::Arc : MoveKind::Feed, axes_.place(piece.to));
        found_.moves.back().to = piece.to;
        if (piece.isArc()) found_.moves.back().centre = piece.centre;
        found_.moves.back().clockwise = piece.clockwise;
    }

    /// To the start, and from there along the feed axis until it lies in front of the contour.
    void approach()
    {
        go(MoveKind::Rapid, axes_.place(cycle_.start));
        go(MoveKind::Rapid, home_);
    }

    /// 1: the start lies to the left of the first piece; -1: to its right; 0: that is not sure.
    double sideOfStart() const
    {
        const Piece& piece = contour_.front();
        const Direction way = directionAtStart(piece);
        const Point start = axes_.point(home_);
        const double x = start.x_mm - piece.from.x_mm, z = start.z_mm - piece.from.z_mm;
        const double left = way.z * x - way.x * z;
        if (std::abs(left) > 1e-6) return left > 0 ? 1 : -1;
        return 0;
    }

    /// Of a contour that falls along q and rises along p: 1: the stock lies to its left.
    double sideOfStock() const
    {
        const Direction way = directionAtStart(contour_.front());
        const Point out = axes_.point({1, 1});
        return way.z * out.x_mm - way.x * out.z_mm > 0 ? 1 : -1;
    }

    /// The contour at a distance on the side of the start; false: not modelled.
    bool contourAt(double distance, std::vector<Piece>& pieces)
    {
        const double side = distance == 0 ? 1 : sideOfStart();
        if (side == 0 || distance < 0) return false;
        ContourAtDistance made = contourAtDistance(contour_, side * distance, axes_.is_face);
        if (made.state == ContourAtDistance::State::Parallel)
            found_.refused = LT_TEXT("Engine", "two lines of the contour have the same direction");
        pieces = std::move(made.pieces);
        return made.state == ContourAtDistance::State::Made;
    }

    bool finish()
    {
        approach();
        const int passes = cycle_.passes;
        if (passes < 1 || passes > static_cast<int>(mostCycleMoves)) return false;
        for (int pass = 1; pass <= passes; ++pass) {
            std::vector<Piece> pieces;
            const double distance = cycle_.distance + (cycle_.last - cycle_.distance) * pass / passes;
            if (!contourAt(distance, pieces) || found_.moves.size() > mostCycleMoves) return false;
            if (pass > 1) go(MoveKind::Rapid, home_);
            go(MoveKind::Rapid, axes_.place(pieces.front().from));
            for (const Piece& piece : pieces) along(piece);
        }
        return true;
    }

    /// Does the contour rise towards the start, without pockets?
    bool isWithoutPockets() const
    {
        const auto depth = [this](const Point& at) { return axes_.sign_p * axes_.depthAxis(at); };
        return depth(contour_.back().to) > depth(contour_.front().from) && monotony(contour_, depth) == Monotony::Holds;
    }

    bool rough()
    {
        std::vector<Piece> pieces;
        if (!(cycle_.depth > 0) || !(cycle_.retreat > 0) || !isWithoutPockets() || !contourAt(cycle_.distance, pieces))
            return false;
        approach();
        const Place first = axes_.place(pieces.front().from), last = axes_.place(pieces.back().to);
        if (home_.p < first.p + sameLevel_mm) return false;
        if (last.p < home_.p) {
            if (last.p > home_.p - roundingOfSubroutineCycle) return false;
            pieces.push_back({pieces.back().to, axes_.point({home_.p, last.q}), {}, false});
        } else if (last.p != home_.p && last.p < home_.p + roundingOfSubroutineCycle) {
            return false;
        }
        if (cycle_.pockets != SubroutineCycle::Pockets::OnlyThey && !cutLevels(pieces, first)) return false;
        if (cycle_.pockets == SubroutineCycle::Pockets::LeftOut && !risesEverywhere(pieces)) return false;
        go(MoveKind::Rapid, first);
        for (const Piece& piece : pieces) {
            if (cycle_.pockets == SubroutineCycle::Pockets::LeftOut) go(MoveKind::Feed, axes_.place(piece.from));
            along(piece);
        }
        return true;
    }

    /// Where it leaves pockets out, it goes to the beginning of every piece; what begins along the feed is an
    /// exception.
    bool risesEverywhere(const std::vector<Piece>& pieces) const
    {
        return std::all_of(pieces.begin(), pieces.end(), [this](const Piece& piece) {
            const Direction way = directionAtStart(piece);
            return axes_.sign_p * axes_.depthAxis({way.x, way.z}) > 1e-2;
        });
    }

    bool cutLevels(const std::vector<Piece>& pieces, const Place& first)
    {
        std::vector<ContourPiece> parts(pieces.size() + 1);
        for (std::size_t i = 0; i < pieces.size(); ++i) parts[i + 1].piece = pieces[i];
        const std::vector<Stretch> stretches = stretchesOf(parts, axes_);
        double level = home_.p;
        for (; level > first.p; level -= cycle_.depth) {
            const double entry = home_.q + (first.q - home_.q) * (home_.p - level) / (home_.p - first.p);
            const auto wall = std::find_if(stretches.begin(), stretches.end(),
                                           [level](const Stretch& part) { return part.to.p >= level; });
            if (wall == stretches.end() || !isClear(stretches, level) || found_.moves.size() > mostCycleMoves)
                return false;
            const double end = crossing(*wall, level), out = std::min(cycle_.retreat, (entry - end) / 2);
            if (!(out > sameLevel_mm)) return false;
            go(MoveKind::Rapid, {level, entry});
            go(MoveKind::Feed, {level, end});
            go(MoveKind::Rapid, {level + out, end + out});
            go(MoveKind::Rapid, {level + out, entry - out});
            go(MoveKind::Rapid, {level, entry});
            if (level - first.p < roundingOfSubroutineCycle) return false;
        }
        return level == first.p || level < first.p - roundingOfSubroutineCycle;
    }

    /// Does no piece along the level lie so close that the last digit decides on which side?
    bool isClear(const std::vector<Stretch>& stretches, double level) const
    {
        return std::none_of(stretches.begin(), stretches.end(), [&](const Stretch& part) {
            const bool isAlong = part.radius == 0 && std::abs(part.to.p - part.from.p) < 1e-6;
            const double away = std::abs(part.from.p - level);
            return isAlong && away < 2e-6 && !(away == 0 && part.to.p == level && cycle_.distance == 0);
        });
    }

    SubroutineCycle cycle_;
    std::vector<Piece> contour_;
    LevelAxes axes_;
    Place begin_;
    Place home_;  ///< the start, in front of the contour
    SubroutineCycleMoves found_;
};

}  // namespace

SubroutineCycleMoves subroutineCycle(const SubroutineCycle& cycle, const std::vector<Piece>& contour)
{
    if (contour.size() < 2 || contour.front().isArc()) {
        SubroutineCycleMoves found;
        found.is_modelled = false;
        return found;
    }
    return SubroutineCycler(cycle, contour).run();
}

}  // namespace lathelier::gcode
