#include "engine/gcode/stock_removal.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/gcode/contour_sections.h"
#include "engine/gcode/nose_path.h"

namespace lathelier::gcode {
namespace {

std::vector<ContourPiece> backwards(const std::vector<ContourPiece>& contour)
{
    std::vector<ContourPiece> result;
    result.reserve(contour.size());
    const Point end = contour.back().piece.to;
    result.push_back({{end, end, {}, false}, true, contour.back().line});
    for (std::size_t i = contour.size(); i-- > 1;) {
        ContourPiece part = contour[i];
        std::swap(part.piece.from, part.piece.to);
        part.piece.clockwise = !part.piece.clockwise;
        result.push_back(part);
    }
    return result;
}

/// The path of the imaginary tip, with the stock on the side of the larger p; none: the nose does not fit.
std::optional<std::vector<ContourPiece>> tipPathOf(const std::vector<ContourPiece>& contour, const LevelAxes& axes,
                                                   const StockRemoval& cut)
{
    double along = 0;  // of q
    for (std::size_t i = 1; i < contour.size(); ++i)
        along += axes.place(contour[i].piece.to).q - axes.place(contour[i].piece.from).q;
    // Left of a travel with falling q and the stock above lies below, seen with q to the right.
    const bool isLeft = (along > 0) != axes.isMirrored();
    return nosePath(contour, isLeft ? NoseSide::Left : NoseSide::Right, cut.nose_radius_mm, cut.nose_tip);
}

/// Does the contour turn back along the feed axis?
bool overhangs(const std::vector<Stretch>& contour)
{
    return std::any_of(contour.begin(), contour.end(), [](const Stretch& part) {
        if (part.to.q > part.from.q + sameLevel_mm) return true;
        if (!(part.radius > 0)) return false;
        const double low = std::min(part.from.p, part.to.p), high = std::max(part.from.p, part.to.p);
        return part.centre.p > low + sameLevel_mm && part.centre.p < high - sameLevel_mm;
    });
}

class StockRemover {
public:
    StockRemover(const std::vector<ContourPiece>& contour, const StockRemoval& cut, std::int64_t mostPasses)
        : contour_(contour), cut_(cut), mostPasses_(mostPasses)
    {
        axes_.is_face = cut.is_face;
        axes_.sign_p = cut.is_outward ? -1 : 1;
        const Place first = axes_.place(contour.front().piece.to), last = axes_.place(contour.back().piece.to);
        const bool isBackwards = first.p > last.p + sameLevel_mm;  // the cut begins at the deep end
        if (isBackwards) contour_ = backwards(contour);
        axes_.sign_q = axes_.feedAxis(contour_.back().piece.to) <= axes_.feedAxis(contour_.front().piece.to) ? 1 : -1;
        asProgrammed_ = isBackwards && !cut.roughs ? contour : contour_;
        const Place begin = axes_.place(contour_.front().piece.to);
        double top = begin.p;
        for (const Stretch& part : stretchesOf(contour_, axes_)) top = std::max({top, part.from.p, part.to.p});
        top_ = top + cut.allowance_depth_mm;
        home_ = {top_ + cut.retreat_mm, begin.q + cut.allowance_feed_mm + cut.retreat_mm};
    }

    StockRemovalMoves run()
    {
        if (overhangs(stretchesOf(contour_, axes_))) return {{}, StockRemovalProblem::Overhang, 0};
        line_ = contour_.front().line;
        go(MoveKind::Rapid, home_, notANumber);
        if (cut_.roughs) rough();
        if (cut_.finishes && problem_ == StockRemovalProblem::None) finish();
        if (problem_ != StockRemovalProblem::None) moves_.clear();
        return {std::move(moves_), problem_, passes_};
    }

private:
    void rough()
    {
        const std::vector<Stretch> left =
            withAllowance(stretchesOf(contour_, axes_), cut_.allowance_depth_mm, cut_.allowance_feed_mm, axes_);
        if (left.empty()) return fail(StockRemovalProblem::Allowance);
        const auto tip = tipPathOf(contourOf(left, axes_), axes_, cut_);
        if (!tip) return fail(StockRemovalProblem::NoseFit);
        const std::vector<Stretch> path = stretchesOf(*tip, axes_);
        if (overhangs(path)) return fail(StockRemovalProblem::NoseFit);
        std::vector<Section> sections = sectionsOf(path);
        if (sections.empty()) return fail(StockRemovalProblem::Nesting);
        sections.front().top = std::max(sections.front().top, top_);
        for (const Section& section : sections) {
            const double count = std::ceil((section.top - section.bottom) / cut_.depth_mm - 1e-9);
            passes_ += std::max(count, 0.0);
            if (passes_ > static_cast<double>(mostPasses_)) return fail(StockRemovalProblem::Passes);
            clear(section, static_cast<int>(count));
        }
        leave();
    }

    void clear(const Section& section, int count)
    {
        const double total = section.top - section.bottom;
        if (total <= sameLevel_mm) return;
        double previous = section.top;
        for (int k = 1; k <= count && moves_.size() < mostCycleMoves; ++k) {
            const double level = k == count ? section.bottom : section.top - total * k / count;
            pass(section, level, previous);
            previous = level;
        }
        go(MoveKind::Rapid, {home_.p, now_.q}, notANumber);
    }

    void pass(const Section& section, double level, double previous)
    {
        double entry = home_.q;
        if (section.falling.empty()) {
            line_ = section.rising.empty() ? line_ : section.rising.front().line;
            go(MoveKind::Rapid, {level, home_.q}, notANumber);
        } else {
            entry = enter(section.falling, level, previous);
        }
        double end = now_.q;
        for (const Stretch& part : section.rising) {
            line_ = part.line;
            if (part.to.p > level + sameLevel_mm) {
                end = part.from.p < level ? crossing(part, level) : part.from.q;
                break;
            }
            end = part.to.q;
        }
        cutAlong(level, end);
        for (const Stretch& part : section.rising) {
            if (part.from.p >= previous - sameLevel_mm) break;
            if (part.to.p <= level + sameLevel_mm) continue;
            follow(part, std::max(part.from.p, level), std::min(part.to.p, previous), cut_.feed_rough);
        }
        const double back = std::min(cut_.retreat_mm, std::max(entry - now_.q, 0.0));
        go(MoveKind::Rapid, {now_.p + cut_.retreat_mm, now_.q + back}, notANumber);
        if (section.falling.empty()) go(MoveKind::Rapid, {now_.p, home_.q}, notANumber);
    }

    /// Into a pocket along its falling side; where that was at the level before.
    double enter(const std::vector<Stretch>& falling, double level, double previous)
    {
        bool isFirst = true;
        double entry = now_.q;
        for (const Stretch& part : falling) {
            if (part.to.p >= previous - sameLevel_mm) continue;
            if (part.from.p <= level + sameLevel_mm) break;
            const double from = std::min(part.from.p, previous);
            if (isFirst) {
                isFirst = false;
                line_ = part.line;
                entry = placeAt(part, from).q;
                go(MoveKind::Rapid, {home_.p, now_.q}, notANumber);
                go(MoveKind::Rapid, {home_.p, entry}, notANumber);
                go(MoveKind::Rapid, {std::min(previous + cut_.retreat_mm, home_.p), entry}, notANumber);
                go(MoveKind::Feed, {previous, entry}, cut_.feed_enter);
            }
            follow(part, from, std::max(part.to.p, level), cut_.feed_enter);
        }
        return entry;
    }

    /// The point of a stretch at this depth; its ends are exact.
    static Place placeAt(const Stretch& part, double p)
    {
        if (p == part.from.p) return part.from;
        if (p == part.to.p) return part.to;
        return {p, crossing(part, p)};
    }

    /// Along the stretch between two depths.
    void follow(const Stretch& part, double from, double to, double feed)
    {
        line_ = part.line;
        const bool isFlat = part.from.p == part.to.p;
        const Place begin = isFlat ? part.from : placeAt(part, from), end = isFlat ? part.to : placeAt(part, to);
        if (std::hypot(begin.p - now_.p, begin.q - now_.q) > 1e-6) go(MoveKind::Feed, begin, feed);
        if (std::hypot(begin.p - end.p, begin.q - end.q) < 1e-9) return;
        go(part.radius > 0 ? MoveKind::Arc : MoveKind::Feed, end, feed);
        if (!(part.radius > 0)) return;
        moves_.back().centre = axes_.point(part.centre);
        moves_.back().clockwise = part.clockwise;
    }

    /// Along the feed axis, with the dwells that break the chip.
    void cutAlong(double level, double end)
    {
        while (cut_.chip_mm > 0 && now_.q - end > cut_.chip_mm + 1e-9 && moves_.size() < mostCycleMoves) {
            go(MoveKind::Feed, {level, now_.q - cut_.chip_mm}, cut_.feed_rough);
            CycleMove rest;
            rest.kind = MoveKind::Dwell;
            rest.to = moves_.back().to;
            rest.dwell_s = cut_.dwell_s;
            rest.line = line_;
            moves_.push_back(rest);
        }
        if (now_.q - end > 1e-9) go(MoveKind::Feed, {level, end}, cut_.feed_rough);
    }

    void finish()
    {
        const auto tip = tipPathOf(asProgrammed_, axes_, cut_);
        if (!tip) return fail(StockRemovalProblem::NoseFit);
        line_ = asProgrammed_.front().line;
        const Place start = axes_.place(tip->front().piece.to);
        const bool isFront = start.q > home_.q - cut_.allowance_feed_mm - cut_.retreat_mm - sameLevel_mm;
        go(MoveKind::Rapid, isFront ? Place{start.p, home_.q} : Place{home_.p, start.q}, notANumber);
        go(MoveKind::Rapid, start, notANumber);
        for (std::size_t i = 1; i < tip->size(); ++i) {
            const ContourPiece& part = (*tip)[i];
            line_ = part.line;
            go(part.piece.isArc() ? MoveKind::Arc : MoveKind::Feed, axes_.place(part.piece.to), cut_.feed_finish);
            moves_.back().clockwise = part.piece.clockwise;
            if (part.piece.isArc()) moves_.back().centre = part.piece.centre;
        }
        leave();
    }

    /// To the start of the cycle: off the work first.
    void leave()
    {
        if (now_.p < home_.p) go(MoveKind::Rapid, {home_.p, now_.q}, notANumber);
        if (now_.q != home_.q) go(MoveKind::Rapid, home_, notANumber);
    }

    void go(MoveKind kind, const Place& at, double feed)
    {
        if (kind == MoveKind::Rapid && !moves_.empty() && at.p == now_.p && at.q == now_.q) return;
        CycleMove move;
        move.kind = kind;
        move.to = axes_.point(at);
        move.feed = feed;
        move.line = line_;
        moves_.push_back(move);
        now_ = at;
    }

    void fail(StockRemovalProblem problem) { problem_ = problem; }

    std::vector<ContourPiece> contour_;       ///< from the deep end
    std::vector<ContourPiece> asProgrammed_;  ///< that finishing follows
    StockRemoval cut_;
    std::int64_t mostPasses_;
    LevelAxes axes_;
    double top_ = 0;
    Place home_;
    Place now_;
    std::int64_t line_ = 0;
    double passes_ = 0;
    StockRemovalProblem problem_ = StockRemovalProblem::None;
    CycleMoves moves_;
};

}  // namespace

StockRemovalMoves stockRemoval(const std::vector<ContourPiece>& contour, const StockRemoval& cut,
                               std::int64_t most_passes)
{
    if (contour.size() < 2) return {};
    return StockRemover(contour, cut, most_passes).run();
}

bool hasSlopes(const std::vector<ContourPiece>& contour)
{
    return std::any_of(contour.begin() + 1, contour.end(), [](const ContourPiece& part) {
        const double dx = std::abs(part.piece.to.x_mm - part.piece.from.x_mm);
        const double dz = std::abs(part.piece.to.z_mm - part.piece.from.z_mm);
        return part.piece.isArc() || (dx > sameLevel_mm && dz > sameLevel_mm);
    });
}

}  // namespace lathelier::gcode
