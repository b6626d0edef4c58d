#include "engine/stock/drawn_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "engine/core/units.h"
#include "engine/stock/stock_work.h"
#include "engine/stock/tool_travel.h"

namespace lathelier::stock {
namespace {

constexpr double nearness_px = 0.5;
constexpr std::size_t mostUnsearchedPieces = 20000;  ///< up to this number, coincident pieces are not searched

double distanceToPiece(const Corner& a, const Corner& b)  // from (0, 0)
{
    const Corner way = b - a;
    const double squared = way.z_mm * way.z_mm + way.x_mm * way.x_mm;
    const double share = squared > 0 ? std::clamp(-(a.z_mm * way.z_mm + a.x_mm * way.x_mm) / squared, 0.0, 1.0) : 0.0;
    return length_mm(a + share * way);
}

bool overlaps(double a, double b, const Interval& shown)
{
    return std::max(a, b) >= shown.from && std::min(a, b) <= shown.to;
}

/// Pieces already drawn, on the grid of pixels.
class DrawnPieces {
public:
    explicit DrawnPieces(const PathWindow& window) : window_(window) {}

    bool isNew(const Corner& from, const Corner& to)
    {
        const auto at = [](double value, double first, double pixel) {
            return static_cast<std::uint64_t>(std::llround(std::clamp((value - first) / pixel, -1e4, 1e4)) + 16384) &
                   0x7fff;
        };
        const auto place = [&](const Corner& c) {
            return at(c.z_mm, window_.z_mm.from, window_.pixel_z_mm) << 15 |
                   at(c.x_mm, window_.x_mm.from, window_.pixel_x_mm);
        };
        return seen_.insert(place(from) << 30 | place(to)).second;
    }

private:
    const PathWindow& window_;
    std::unordered_set<std::uint64_t> seen_;
};

void appendPiece(report::Curve& curve, const Corner& from, const Corner& to)
{
    const bool continues = !curve.x.empty() && curve.x.back() == from.z_mm && curve.y.back() == from.x_mm;
    if (!continues) {
        if (!curve.x.empty()) {
            curve.x.push_back(notANumber);
            curve.y.push_back(notANumber);
        }
        curve.x.push_back(from.z_mm);
        curve.y.push_back(from.x_mm);
    }
    curve.x.push_back(to.z_mm);
    curve.y.push_back(to.x_mm);
}

}  // namespace

DrawnPath::DrawnPath(std::span<const gcode::Move> moves, double z_zero_mm, std::size_t blocks, const Progress& progress)
{
    TipFollower follower(z_zero_mm);
    ToolTravel travel;
    for (std::size_t m = 0; m < moves.size(); ++m) {
        if (m % 4096 == 0) progress.report(static_cast<double>(m) / static_cast<double>(moves.size()));
        follower.take(moves[m], arcChord_mm, travel);
        for (std::size_t i = 0; i < travel.corners.size(); ++i) {
            if (i == 0 && travel.has_start) continue;  // equal to the end of the previous move
            corners_.push_back(travel.corners[i]);
            line_.push_back(static_cast<std::uint32_t>(travel.line));
            tool_.push_back(travel.tool);
            isRapid_.push_back(travel.is_rapid);
            isFirst_.push_back(i == 0);
        }
    }
    begin_.assign(blocks + 2, 0);
    for (const std::uint32_t line : line_) ++begin_[std::min<std::size_t>(line, blocks) + 1];
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    byLine_.resize(line_.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < line_.size(); ++i)
        byLine_[next[std::min<std::size_t>(line_[i], blocks)]++] = static_cast<std::uint32_t>(i);
    extent_ = boxOf(corners_);
}

std::span<const std::uint32_t> DrawnPath::piecesOf(std::int64_t line) const
{
    if (line < 0 || static_cast<std::size_t>(line) + 1 >= begin_.size()) return {};
    const auto at = static_cast<std::size_t>(line);
    return std::span(byLine_).subspan(begin_[at], begin_[at + 1] - begin_[at]);
}

PathPiece DrawnPath::nearest(const Corner& place, double pixel_z_mm, double pixel_x_mm) const
{
    const auto scaled = [&](const Corner& c) {
        return Corner{(c.z_mm - place.z_mm) / pixel_z_mm, (c.x_mm - place.x_mm) / pixel_x_mm};
    };
    PathPiece best = none;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < corners_.size(); ++i) {
        if (isFirst_[i]) continue;
        double away = distanceToPiece(scaled(corners_[i - 1]), scaled(corners_[i]));
        if (isRapid_[i]) away += nearness_px;  // of coincident pieces the feed move takes precedence
        if (away >= least) continue;
        least = away;
        best = i;
    }
    return best;
}

PathWindow DrawnPath::whole(int pixels) const
{
    const Corner size = extent_.high - extent_.low;
    return {{extent_.low.z_mm, extent_.high.z_mm},
            {extent_.low.x_mm, extent_.high.x_mm},
            size.z_mm / pixels,
            size.x_mm / pixels};
}

std::vector<report::Curve> DrawnPath::curves(const PathWindow& window) const
{
    report::Curve feed{LT_TEXT("Engine", "feed moves"), {}, {}}, rapid{LT_TEXT("Engine", "rapid moves"), {}, {}};
    feed.colour = report::ColourRole::Copy;
    rapid.colour = report::ColourRole::Neutral;
    rapid.style = report::Curve::Style::Dashed;
    feed.has_readout = rapid.has_readout = false;
    const bool is_thinned = window.pixel_z_mm > 0 && window.pixel_x_mm > 0 && corners_.size() > mostUnsearchedPieces;
    const auto is_near = [&](const Corner& a, const Corner& b) {
        return std::abs(a.z_mm - b.z_mm) < nearness_px * window.pixel_z_mm &&
               std::abs(a.x_mm - b.x_mm) < nearness_px * window.pixel_x_mm;
    };
    DrawnPieces drawn(window);
    Corner last;  // end of the last piece drawn or omitted as too short
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        if (isFirst_[i]) {
            last = corners_[i];
            continue;
        }
        const bool is_end = i + 1 == corners_.size() || isFirst_[i + 1] || isRapid_[i + 1] != isRapid_[i];
        if (is_thinned && !is_end && is_near(last, corners_[i])) continue;
        if (overlaps(last.z_mm, corners_[i].z_mm, window.z_mm) && overlaps(last.x_mm, corners_[i].x_mm, window.x_mm) &&
            (!is_thinned || drawn.isNew(last, corners_[i])))
            appendPiece(isRapid_[i] ? rapid : feed, last, corners_[i]);
        last = corners_[i];
    }
    std::vector<report::Curve> both;
    for (report::Curve* curve : {&feed, &rapid})
        if (!curve->x.empty()) both.push_back(std::move(*curve));
    return both;
}

}  // namespace lathelier::stock
