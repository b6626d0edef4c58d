#include "engine/deflection/corrected_run.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "engine/core/units.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/written_contour.h"

namespace lathelier::deflection {
namespace {

/// Corrects one run. Sides of a node: 0 toward the piece before it, 1 toward the piece after.
class RunWriter {
public:
    RunWriter(const WorkPlan& plan, const TurningWork& before, const CutPlan& cut, std::span<const Station> ideal,
              const ArcLimits& limits)
        : plan_(plan), cut_(cut), limits_(limits), count_(cut.pieces.size()), arcs_(cut.pieces.size() + 1)
    {
        for (std::vector<const Station*>& side : wanted_) side.assign(count_ + 1, nullptr);
        for (std::vector<bool>& side : free_) side.assign(count_ + 1, false);
        for (std::vector<double>& side : corner_mm_) side.assign(count_ + 1, notANumber);
        for (const Station& s : ideal) wanted_[s.at_start ? 1 : 0][s.piece + (s.at_start ? 0 : 1)] = &s;
        for (std::size_t i = 0; i < count_; ++i) {
            const CutPiece& piece = cut.pieces[i];
            const std::size_t k = cut.first + i;
            const bool starts_in = before.outerStart_mm()[k] - piece.start_mm > noDepth_mm;
            if (starts_in && !wanted_[1][i]) wanted_[1][i] = wanted_[0][i];  // one station represents both sides
            const bool ends_in = before.outerEnd_mm()[k] - piece.end_mm > noDepth_mm;
            if (piece.arc) continue;
            // The cut begins or ends within the piece: its end in air is not corrected.
            if (starts_in && !ends_in) wanted_[0][i + 1] = inAir(z(i + 1), piece.end_mm);
            if (!starts_in && ends_in) wanted_[1][i] = inAir(z(i), piece.start_mm);
        }
        takeArcsWhole();
    }

    WrittenRun write()
    {
        for (std::size_t i = 0; i < count_;) {
            if (!isMaterial(i)) {
                ++i;
                continue;
            }
            std::size_t end = i + 1;
            while (end < count_ && isMaterial(end) && !isShoulder(end)) ++end;
            chooseCorners(i, end);
            i = end;
        }
        fillContour();
        emit();
        return std::move(written_);
    }

private:
    bool isMaterial(std::size_t piece) const { return wanted_[1][piece] && wanted_[0][piece + 1]; }
    /// True at a shoulder or a change of feed, where the deflection jumps.
    bool isShoulder(std::size_t node) const
    {
        if (node == 0 || node == count_) return false;
        if (cut_.pieces[node].start_mm != cut_.pieces[node - 1].end_mm) return true;
        const Station *before = wanted_[0][node], *behind = wanted_[1][node];
        return before && behind && std::abs(before->x_mm - behind->x_mm) > limits_.tolerance_mm;
    }
    std::size_t endOfArc(std::size_t piece) const
    {
        std::size_t end = piece + 1;
        while (end < count_ && cut_.pieces[end].arc && !cut_.block_ends[end]) ++end;
        return end;
    }

    /// What of an arc is in air, or does no more than rub, moves with the nearest part that is corrected; without one,
    /// with the corner that it begins at.
    void takeArcsWhole()
    {
        for (std::size_t i = 0; i < count_;) {
            if (!cut_.pieces[i].arc) {
                ++i;
                continue;
            }
            const std::size_t end = endOfArc(i);
            moveArc(i, end);
            i = end;
        }
    }

    void moveArc(std::size_t from, std::size_t end)
    {
        struct Slot {
            int side;
            std::size_t node;
            double programmed_mm;
        };
        std::vector<Slot> slots;
        slots.reserve(2 * (end - from));
        for (std::size_t k = from; k < end; ++k) {
            slots.push_back({1, k, cut_.pieces[k].start_mm});
            slots.push_back({0, k + 1, cut_.pieces[k].end_mm});
        }
        const auto stationOf = [this](const Slot& slot) { return wanted_[slot.side][slot.node]; };
        const auto corrects = [&](const Slot& slot) { return stationOf(slot) && !stationOf(slot)->rubs; };
        const auto first = std::find_if(slots.begin(), slots.end(), corrects);
        double correction_mm = 0;
        if (first != slots.end())
            correction_mm = stationOf(*first)->x_mm - first->programmed_mm;
        else if (from > 0 && wanted_[0][from])
            correction_mm = wanted_[0][from]->x_mm - cut_.pieces[from - 1].end_mm;
        if (first == slots.end() && std::abs(correction_mm) < limits_.grid_mm / 2) return;
        for (const Slot& slot : slots) {
            if (corrects(slot)) {
                correction_mm = stationOf(slot)->x_mm - slot.programmed_mm;
                continue;
            }
            wanted_[slot.side][slot.node] = inAir(z(slot.node), slot.programmed_mm + correction_mm);
            free_[slot.side][slot.node] = true;
        }
    }

    const Station* inAir(double z_mm, double x_mm)
    {
        Station& made = made_.emplace_back();
        made.z_mm = z_mm;
        made.x_mm = made.stock_mm = made.radius_mm = x_mm;
        return &made;
    }
    double z(std::size_t node) const { return plan_.z_mm[cut_.first + node]; }

    /// Chooses the corners of a stretch of straight pieces in material, between nodes `from` and `to`.
    void chooseCorners(std::size_t from, std::size_t to)
    {
        std::vector<WantedPlace> places;
        places.reserve(to - from + 1);
        for (std::size_t node = from; node <= to; ++node) {
            const int side = node == from ? 1 : 0;
            places.push_back({z(node), wanted_[side][node]->x_mm, static_cast<bool>(cut_.block_ends[node]),
                              static_cast<bool>(free_[side][node])});
        }
        std::vector<WantedArc> arcs;
        for (std::size_t k = from; k < to;) {
            if (!cut_.pieces[k].arc) {
                ++k;
                continue;
            }
            const std::size_t end = std::min(to, endOfArc(k));
            arcs.push_back({k - from, end - from, *cut_.pieces[k].arc, isUpper(k)});
            k = end;
        }
        const auto corners = writtenContour(places, arcs, limits_);
        if (!corners)
            throw Error(errors::cannotBeWritten, {{"grid_um", 2 * um_per_mm * limits_.grid_mm},
                                                  {"residual_um", um_per_mm * limits_.grid_mm},
                                                  {"tolerance_um", 2 * um_per_mm * limits_.tolerance_mm}});
        for (const WrittenCorner& corner : *corners) {
            const std::size_t node = from + corner.place;
            if (node > from) corner_mm_[0][node] = corner.x_mm;
            if (node < to) corner_mm_[1][node] = corner.x_mm;
            if (node > from) arcs_[node] = corner.arc;
        }
    }

    /// Does the arc of this piece lie at larger radii than its centre?
    bool isUpper(std::size_t piece) const
    {
        const CutPiece& at = cut_.pieces[piece];
        return at.start_mm + at.end_mm > 2 * at.arc->x_mm;
    }

    /// Interpolates the contour between the corners; unchanged in air.
    void fillContour()
    {
        written_.cut = cut_;
        written_.is_coarse.assign(count_, false);
        filled_.assign(count_, false);
        for (std::size_t i = 0; i < count_;) {
            if (std::isnan(corner_mm_[1][i])) {
                ++i;
                continue;
            }
            std::size_t end = i + 1;
            while (end < count_ && std::isnan(corner_mm_[0][end])) ++end;
            const double from_mm = corner_mm_[1][i], to_mm = corner_mm_[0][end];
            const auto along = [&](std::size_t node) {
                if (arcs_[end] && node != i && node != end)
                    return radiusOnArc_mm(*arcs_[end], isUpper(i), z(i), from_mm, z(node));
                return from_mm + (to_mm - from_mm) * (z(node) - z(i)) / (z(end) - z(i));
            };
            for (std::size_t k = i; k < end; ++k) {
                CutPiece& piece = written_.cut.pieces[k];
                piece.start_mm = along(k);
                piece.end_mm = along(k + 1);
                filled_[k] = true;
                written_.is_coarse[k] = arcs_[end].has_value();
            }
            i = end;
        }
    }

    void emitAsItWas(const PathPoint& point)
    {
        written_.run.points.push_back(point);
        if (!point.is_block_end) return;
        CorrectedNode node;
        node.z_mm = point.z_mm;
        node.x_mm = node.programmed_mm = point.x_mm;
        node.line = point.line;
        node.feed_mm_rev = point.feed_mm_rev;
        written_.nodes.push_back(node);
    }

    /// `point`: end of the original block there; null: none.
    void emitCorner(std::size_t at, int side, const PathPoint* point)
    {
        const CutPiece& piece = cut_.pieces[side == 0 ? at - 1 : at];
        const Station& s = *wanted_[side][at];
        CorrectedNode node;
        node.z_mm = z(at);
        node.x_mm = corner_mm_[side][at];
        node.programmed_mm = side == 0 ? piece.end_mm : piece.start_mm;
        node.line = point ? point->line : piece.line;
        node.added = !point;
        if (side == 0) node.arc = arcs_[at];
        node.feed_mm_rev = point ? point->feed_mm_rev : piece.feed_mm_rev;
        node.in_material = true;
        node.dx_um = um_per_mm * s.dx_mm;
        node.dy_um = um_per_mm * s.dy_mm;
        node.F_t_N = s.forces.F_t_N;
        node.F_f_N = s.forces.F_f_N;
        node.F_ap_N = s.forces.F_ap_N;
        node.stiffness_N_mm = s.stiffness_N_mm;
        written_.nodes.push_back(node);
        const PathPoint end{node.z_mm, node.x_mm, node.feed_mm_rev, node.line, true, node.arc};
        if (node.arc && !written_.run.points.empty())
            appendArc(PathPoint(written_.run.points.back()), end, chordOfArc_mm, written_.run.points);
        else
            written_.run.points.push_back(end);
    }

    /// The step before an arc that begins at another radius than the block before it ends at is added to that block.
    void emitStep(std::size_t at, const PathPoint& end)
    {
        emitCorner(at, 1, nullptr);
        written_.nodes.back().line = written_.run.points.back().line = end.line;
        written_.nodes.back().steps_behind = true;
    }

    /// True if the original contour at z is replaced by straight blocks between corners.
    bool isReplaced(double z_mm) const
    {
        const auto after = std::upper_bound(plan_.z_mm.begin(), plan_.z_mm.end(), z_mm);
        const auto node = static_cast<std::size_t>(after - plan_.z_mm.begin());
        return node > cut_.first && node - 1 - cut_.first < count_ && filled_[node - 1 - cut_.first];
    }

    void emit()
    {
        written_.run.kind = cut_.run.kind;
        const std::vector<PathPoint>& points = cut_.run.points;
        std::size_t next = 0;
        const auto emitBefore = [&](double z_mm) {
            for (; next < points.size() && points[next].z_mm < z_mm - samePlanPlace_mm; ++next) {
                if (points[next].is_block_end || !isReplaced(points[next].z_mm)) emitAsItWas(points[next]);
            }
        };
        for (std::size_t i = 0; i <= count_; ++i) {
            emitBefore(z(i));
            std::vector<PathPoint> here;
            for (; next < points.size() && points[next].z_mm <= z(i) + samePlanPlace_mm; ++next)
                if (points[next].is_block_end) here.push_back(points[next]);
            emitNode(i, here);
        }
        emitBefore(HUGE_VAL);
    }

    /// Emits the corners of both sides of a node and the original points there.
    void emitNode(std::size_t i, const std::vector<PathPoint>& here)
    {
        const bool before = !std::isnan(corner_mm_[0][i]), behind = !std::isnan(corner_mm_[1][i]);
        if (!before && !behind) {
            for (const PathPoint& point : here) emitAsItWas(point);
            return;
        }
        const PathPoint* first = here.empty() ? nullptr : &here.front();
        const PathPoint* last = here.empty() ? nullptr : &here.back();
        if (before) emitCorner(i, 0, first);
        if (before && behind && !isShoulder(i)) return;
        if (!before && i > 0 && isShoulder(i) && first) emitAsItWas(*first);
        for (std::size_t k = 1; k + 1 < here.size(); ++k) emitAsItWas(here[k]);
        if (behind && before && here.size() == 1 && cut_.pieces[i].arc)
            emitStep(i, here.front());
        else if (behind)
            emitCorner(i, 1, before && here.size() == 1 ? nullptr : last);
        if (!behind && here.size() > 1) emitAsItWas(*last);
    }

    const WorkPlan& plan_;
    const CutPlan& cut_;
    const ArcLimits& limits_;
    std::size_t count_;
    std::vector<std::optional<ArcCentre>> arcs_;  ///< that lead to the corner at a node
    std::vector<const Station*> wanted_[2];       ///< target stations of the nodes by side; null: none
    std::vector<bool> free_[2];                   ///< stations within arcs that nothing asks for
    std::deque<Station> made_;                    ///< stations generated here
    std::vector<double> corner_mm_[2];            ///< corner radius by side; NaN: none
    std::vector<bool> filled_;                    ///< true for replaced pieces
    WrittenRun written_;
};

}  // namespace

WrittenRun writtenRun(const WorkPlan& plan, const TurningWork& before, const CutPlan& cut,
                      std::span<const Station> ideal, const ArcLimits& limits)
{
    return RunWriter(plan, before, cut, ideal, limits).write();
}

}  // namespace lathelier::deflection
