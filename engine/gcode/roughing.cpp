// G71, G72: passes at levels, bounded by the crossings of level and contour.
#include <algorithm>
#include <cmath>

#include "engine/gcode/cycles.h"

namespace lathelier::gcode {
namespace {

constexpr double sameLevel_mm = 1e-7;

/// A point by depth axis (p falls with the depth) and feed axis (q falls along the cut).
struct Place {
    double p = 0;
    double q = 0;
};

/// A part of the contour along which p is monotonic.
struct Stretch {
    Place from;
    Place to;
    Place centre;  ///< of an arc
    double radius = 0;
    bool is_upper = false;  ///< of an arc: q = centre + root, else centre - root
    std::int64_t line = 0;
};

class Rougher {
public:
    Rougher(const Point& start, const std::vector<ContourPiece>& contour, const Roughing& rough)
        : start_(start), contour_(contour), rough_(rough)
    {
        const Point first = shifted(contour.front().piece.to), last = shifted(contour.back().piece.to);
        double sum = 0;
        for (const ContourPiece& part : contour) sum += depthAxis(shifted(part.piece.to)) - depthAxis(start);
        signP_ = sum <= 0 ? 1 : -1;
        const double along = feedAxis(last) - feedAxis(start);
        signQ_ = along <= 0 ? 1 : -1;
        begin_ = place(first);
        home_ = place(start);
        makeStretches();
    }

    CycleMoves run()
    {
        double lowest = begin_.p;
        for (const Stretch& part : stretches_) lowest = std::min({lowest, part.from.p, part.to.p});
        double previous = home_.p;
        const double depth = rough_.depth_mm;
        while (previous > lowest + sameLevel_mm && moves_.size() < mostCycleMoves) {
            const double level = std::max(previous - depth, lowest);
            passesAt(level, previous);
            previous = level;
        }
        followContour();
        return std::move(moves_);
    }

private:
    double depthAxis(const Point& point) const { return rough_.is_face ? point.z_mm : point.x_mm; }
    double feedAxis(const Point& point) const { return rough_.is_face ? point.x_mm : point.z_mm; }
    Point shifted(const Point& point) const
    {
        return {point.x_mm + rough_.allowance_x_mm, point.z_mm + rough_.allowance_z_mm};
    }
    Place place(const Point& point) const { return {signP_ * depthAxis(point), signQ_ * feedAxis(point)}; }
    Point point(const Place& at) const
    {
        return rough_.is_face ? Point{signQ_ * at.q, signP_ * at.p} : Point{signP_ * at.p, signQ_ * at.q};
    }

    void makeStretches()
    {
        stretches_.reserve(contour_.size() * 2);
        for (std::size_t i = 1; i < contour_.size(); ++i) {
            const Piece& piece = contour_[i].piece;
            Stretch part{place(shifted(piece.from)), place(shifted(piece.to)), {}, 0, false, contour_[i].line};
            if (!piece.isArc()) {
                stretches_.push_back(part);
                continue;
            }
            part.centre = place(shifted(piece.centre));
            part.radius = piece.radius_mm();
            // In (q, p) the sense of rotation changes with each mirrored or exchanged axis.
            const bool isMirrored = (signP_ * signQ_ < 0) != rough_.is_face;
            addArc(part, piece.clockwise != isMirrored);
        }
    }

    /// Splits an arc where p is largest or smallest: above or below its centre, seen with q to the right.
    void addArc(const Stretch& arc, bool clockwise)
    {
        const double pi = std::acos(-1.0);
        double from = std::atan2(arc.from.p - arc.centre.p, arc.from.q - arc.centre.q);
        double to = std::atan2(arc.to.p - arc.centre.p, arc.to.q - arc.centre.q);
        if (clockwise && to >= from) to -= 2 * pi;
        if (!clockwise && to <= from) to += 2 * pi;
        std::vector<double> cuts{from};
        for (int k = -3; k <= 3; ++k) {
            const double extreme = pi / 2 + k * pi;
            if ((extreme - from) * (extreme - to) < -1e-12) cuts.push_back(extreme);
        }
        cuts.push_back(to);
        std::sort(cuts.begin() + 1, cuts.end() - 1,
                  [clockwise](double a, double b) { return clockwise ? a > b : a < b; });
        for (std::size_t i = 1; i < cuts.size(); ++i) {
            Stretch part = arc;
            const auto at = [&arc](double angle) {
                return Place{arc.centre.p + arc.radius * std::sin(angle), arc.centre.q + arc.radius * std::cos(angle)};
            };
            if (i > 1) part.from = at(cuts[i - 1]);
            if (i + 1 < cuts.size()) part.to = at(cuts[i]);
            part.is_upper = std::cos((cuts[i - 1] + cuts[i]) / 2) > 0;
            stretches_.push_back(part);
        }
    }

    static double crossing(const Stretch& part, double level)
    {
        if (part.radius > 0) {
            const double height = level - part.centre.p;
            const double root = std::sqrt(std::max(part.radius * part.radius - height * height, 0.0));
            return part.is_upper ? part.centre.q + root : part.centre.q - root;
        }
        const double rise = part.to.p - part.from.p;
        return rise == 0 ? part.to.q : part.from.q + (part.to.q - part.from.q) * (level - part.from.p) / rise;
    }

    void go(MoveKind kind, const Place& at)
    {
        CycleMove move;
        move.kind = kind;
        move.to = point(at);
        move.line = line_;
        moves_.push_back(move);
        now_ = at;
    }

    /// All cuts of one level: in front of the contour, then in each pocket.
    void passesAt(double level, double previous)
    {
        bool isBelow = begin_.p <= level + sameLevel_mm;
        double entry = home_.q;
        bool isPocket = false;
        bool hasPocket = false;
        for (const Stretch& part : stretches_) {
            const bool wasBelow = isBelow;
            isBelow = part.to.p <= level + sameLevel_mm;
            if (wasBelow == isBelow) continue;
            const double q = crossing(part, level);
            line_ = part.line;
            if (isBelow) {
                entry = q;
                isPocket = true;
                continue;
            }
            cut(level, previous, entry, q, isPocket);
            hasPocket = hasPocket || isPocket;
        }
        if (isBelow) {
            line_ = contour_.back().line;
            cut(level, previous, entry, stretches_.empty() ? begin_.q : stretches_.back().to.q, isPocket);
            hasPocket = hasPocket || isPocket;
        }
        if (!hasPocket) return;
        go(MoveKind::Rapid, {home_.p, now_.q});
        go(MoveKind::Rapid, home_);
    }

    void cut(double level, double previous, double entry, double end, bool isPocket)
    {
        if (isPocket) {
            if (entry - end < 1e-6) return;
            go(MoveKind::Rapid, {home_.p, moves_.empty() ? home_.q : now_.q});
            go(MoveKind::Rapid, {home_.p, entry});
            go(MoveKind::Rapid, {previous, entry});
            go(MoveKind::Feed, {level, entry});
        } else {
            go(contour_.front().is_rapid ? MoveKind::Rapid : MoveKind::Feed, {level, home_.q});
        }
        go(MoveKind::Feed, {level, end});
        const double out = std::min(rough_.retreat_mm, std::max(entry - end, 0.0));
        if (out > 0) go(MoveKind::Rapid, {level + out, end + out});
        if (!isPocket) go(MoveKind::Rapid, {level + out, home_.q});
    }

    void followContour()
    {
        const MoveKind first = contour_.front().is_rapid ? MoveKind::Rapid : MoveKind::Feed;
        line_ = contour_.front().line;
        go(first, {begin_.p, home_.q});
        if (std::abs(begin_.q - home_.q) > 1e-9) go(begin_.q < home_.q ? MoveKind::Feed : first, begin_);
        for (std::size_t i = 1; i < contour_.size(); ++i) {
            const Piece& piece = contour_[i].piece;
            line_ = contour_[i].line;
            go(piece.isArc() ? MoveKind::Arc : MoveKind::Feed, place(shifted(piece.to)));
            moves_.back().clockwise = piece.clockwise;
            if (piece.isArc()) moves_.back().centre = shifted(piece.centre);
        }
        const double clear = std::max(now_.p, home_.p);
        if (now_.p < clear) go(MoveKind::Rapid, {clear, now_.q});
        go(MoveKind::Rapid, {clear, home_.q});
        if (clear > home_.p) go(MoveKind::Rapid, home_);
    }

    Point start_;
    const std::vector<ContourPiece>& contour_;
    Roughing rough_;
    double signP_ = 1;
    double signQ_ = 1;
    Place begin_;
    Place home_;
    Place now_;
    std::int64_t line_ = 0;
    std::vector<Stretch> stretches_;
    CycleMoves moves_;
};

}  // namespace

CycleMoves roughing(const Point& start, const std::vector<ContourPiece>& contour, const Roughing& rough)
{
    if (contour.size() < 2 || !(rough.depth_mm > 0)) return {};
    return Rougher(start, contour, rough).run();
}

}  // namespace lathelier::gcode
