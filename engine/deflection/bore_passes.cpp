#include "engine/deflection/bore_passes.h"

#include <algorithm>
#include <cmath>

#include "engine/beam/segment_contour.h"

namespace lathelier::deflection {
namespace {

constexpr double clear_mm = 1e-6;  ///< beyond rounding

/// Radii of the stock at a place; outside it both are 0.
struct StockRadii {
    double outer_mm = 0;
    double bore_mm = 0;
};

class BoreFinder {
public:
    BoreFinder(std::span<const ToolMove> moves, const Shaft& stock)
        : moves_(moves), stock_(stock), length_mm_(stock.length_mm()), inBore_(moves.size(), false)
    {
    }

    std::vector<bool> find()
    {
        for (std::size_t i = 1; i < moves_.size();) {
            if (!isAlongWork(i)) {
                ++i;
                continue;
            }
            std::size_t end = i + 1;
            while (end < moves_.size() && isInWork(end - 1) && isAlongWork(end)) ++end;
            if (isInBore(i, end))
                std::fill(inBore_.begin() + static_cast<std::ptrdiff_t>(i),
                          inBore_.begin() + static_cast<std::ptrdiff_t>(end), true);
            for (std::size_t k = i; k < end; ++k) drill(k);
            i = end;
        }
        return std::move(inBore_);
    }

private:
    bool isInWork(std::size_t i) const { return moves_[i].z_mm > clear_mm && moves_[i].z_mm < length_mm_ - clear_mm; }
    /// Does the move that leads to this point begin or end along the work?
    bool isAlongWork(std::size_t i) const { return isInWork(i) || isInWork(i - 1); }

    StockRadii radiiAt(double z_mm) const
    {
        double start_mm = 0;
        for (const ShaftSegment& segment : stock_.segments) {
            const double end_mm = start_mm + segment.length_mm;
            if (z_mm <= end_mm)
                return {beam::SegmentContour(segment).radiusAt_mm(std::clamp(z_mm - start_mm, 0.0, segment.length_mm)),
                        segment.bore_diameter_mm / 2};
            start_mm = end_mm;
        }
        return {};
    }

    void drill(std::size_t i)
    {
        const auto isOnAxis = [this](std::size_t k) { return std::abs(moves_[k].x_mm) < clear_mm; };
        if (moves_[i].is_feed && isOnAxis(i) && isOnAxis(i - 1)) drilled_mm_ = std::max(drilled_mm_, moves_[i].z_mm);
    }

    /// Of the moves from `first` to before `end`, between two ways outside the length of the work.
    bool isInBore(std::size_t first, std::size_t end) const
    {
        bool isHollow = false, isWithinBore = false, returnsWithin = false;
        double reached_mm = HUGE_VAL;  // radius at the end of the last cut toward the chuck
        for (std::size_t i = first; i < end; ++i) {
            const ToolMove& move = moves_[i];
            const double along_mm = move.z_mm - moves_[i - 1].z_mm;
            if (!move.is_feed && along_mm < -clear_mm && reached_mm != HUGE_VAL) {
                if (moves_[i - 1].x_mm > reached_mm + clear_mm) return false;
                returnsWithin = returnsWithin || moves_[i - 1].x_mm < reached_mm - clear_mm;
            }
            if (move.is_feed && along_mm > clear_mm) reached_mm = move.x_mm;
            if (!isInWork(i)) continue;
            const StockRadii radii = radiiAt(move.z_mm);
            isHollow = isHollow || radii.bore_mm > 0 || move.z_mm < drilled_mm_ + clear_mm;
            if (move.x_mm >= radii.outer_mm) return false;
            if (radii.bore_mm > 0 && move.x_mm <= radii.bore_mm + clear_mm) isWithinBore = true;
            if (!move.is_feed && std::abs(along_mm) <= clear_mm && move.x_mm > reached_mm + clear_mm) return false;
        }
        if (!isHollow || reached_mm == HUGE_VAL) return isHollow && isWithinBore;
        return isWithinBore || returnsWithin || comesFromWithin(first);
    }

    /// Was the tool at a smaller radius before it came to where the way begins?
    bool comesFromWithin(std::size_t first) const
    {
        const bool retracts = std::abs(moves_[first].x_mm - moves_[first - 1].x_mm) > clear_mm;
        if (retracts) return false;
        for (std::size_t i = first - 1; i > 0; --i) {
            const double across_mm = moves_[i].x_mm - moves_[i - 1].x_mm;
            if (std::abs(across_mm) > clear_mm) return across_mm > 0 && !isInWork(i - 1);
        }
        return false;
    }

    std::span<const ToolMove> moves_;
    const Shaft& stock_;
    double length_mm_;
    double drilled_mm_ = 0;  ///< depth of a hole that the program has made
    std::vector<bool> inBore_;
};

}  // namespace

std::vector<bool> movesInBores(std::span<const ToolMove> moves, const Shaft& stock)
{
    const bool has_bore = std::any_of(stock.segments.begin(), stock.segments.end(),
                                      [](const ShaftSegment& segment) { return segment.bore_diameter_mm > 0; });
    const bool is_drilled = std::any_of(moves.begin(), moves.end(), [](const ToolMove& move) {
        return move.is_feed && std::abs(move.x_mm) < clear_mm && move.z_mm > clear_mm;
    });
    if (!has_bore && !is_drilled) return std::vector<bool>(moves.size(), false);
    return BoreFinder(moves, stock).find();
}

}  // namespace lathelier::deflection
