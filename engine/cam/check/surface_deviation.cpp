#include "engine/cam/check/surface_deviation.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/stock/machine_limits.h"

namespace lathelier::cam {
namespace {

constexpr std::size_t leastSplitPoints = 8;   ///< stretches with at most this many points are not bisected
constexpr std::size_t leastSplitStrokes = 3;  ///< nor stretches with at most this many candidate strokes
constexpr double refineTo_mm = 1e-5;          ///< along the drawing
constexpr std::size_t mostRefined = 64;       ///< candidate intervals for the deepest gouge
constexpr double rounding_mm = 1e-9;          ///< smaller gouges are rounding errors
constexpr double goldenShare = 0.61803398874989485;

class Surface {
public:
    Surface(const DrawnContour& drawing, const AllStrokes& all, const BarLimits& bar, const Progress& progress)
        : drawing_(drawing), points_(drawing.points()), all_(all), bar_(bar), progress_(progress)
    {
        clearances_.resize(points_.size());
        listOf_.resize(points_.size());
    }

    void measure()
    {
        std::vector<std::int32_t> every(all_.strokes.size());
        for (std::size_t i = 0; i < every.size(); ++i) every[i] = static_cast<std::int32_t>(i);
        if (!points_.empty()) halve(0, points_.size(), std::move(every));
    }

    /// Clearance at a point close to contour point `near`, from that point's candidate strokes.
    Clearance at(const Corner& place, std::size_t near) const { return clearanceOf(place, lists_[listOf_[near]]); }

    const std::vector<Clearance>& clearances() const { return clearances_; }

private:
    using List = std::vector<std::int32_t>;

    Clearance clearanceOf(const Corner& place, const List& strokes, std::vector<double>* each = nullptr) const
    {
        Clearance found;
        found.left_mm = std::min(bar_.radius_mm - place.x_mm, place.z_mm - bar_.end_z_mm);
        found.own_mm = stock::endless_mm;
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            const std::int32_t number = strokes[i];
            const double clearance = all_.strokes[static_cast<std::size_t>(number)].clearance_mm(place);
            if (each) (*each)[i] = clearance;
            if (clearance < found.left_mm) {
                found.left_mm = clearance;
                found.nearest = number;
            }
            if (clearance < found.own_mm && static_cast<std::size_t>(number) < all_.own) {
                found.own_mm = clearance;
                found.own = number;
            }
        }
        return found;
    }

    void halve(std::size_t first, std::size_t end, List strokes)
    {
        progress_.check();
        const std::size_t middle = first + (end - first) / 2;
        const double reach_mm = std::max(points_[end - 1].along_mm - points_[middle].along_mm,
                                         points_[middle].along_mm - points_[first].along_mm) +
                                2 * drawing_.spacing_mm();
        each_.resize(strokes.size());
        const Clearance here = clearanceOf(points_[middle].at, strokes, &each_);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            const bool is_own = static_cast<std::size_t>(strokes[i]) < all_.own;
            if (each_[i] <= here.left_mm + 2 * reach_mm || (is_own && each_[i] <= here.own_mm + 2 * reach_mm))
                strokes[kept++] = strokes[i];
        }
        strokes.resize(kept);
        if (end - first > leastSplitPoints && kept > leastSplitStrokes) {
            halve(first, middle, strokes);
            halve(middle, end, std::move(strokes));
            return;
        }
        for (std::size_t i = first; i < end; ++i) {
            clearances_[i] = clearanceOf(points_[i].at, strokes);
            listOf_[i] = static_cast<std::uint32_t>(lists_.size());
        }
        lists_.push_back(std::move(strokes));
    }

    const DrawnContour& drawing_;
    const std::vector<DrawnPoint>& points_;
    const AllStrokes& all_;
    const BarLimits& bar_;
    const Progress& progress_;
    std::vector<Clearance> clearances_;
    std::vector<std::uint32_t> listOf_;
    std::vector<List> lists_;
    std::vector<double> each_;
};

/// A position between two samples of one contour piece.
struct SurfacePlace {
    std::uint32_t piece = 0;
    double t = 0;
    Clearance clearance;
};

class Finder {
public:
    Finder(const DrawnContour& drawing, const Surface& surface)
        : drawing_(drawing), points_(drawing.points()), surface_(surface)
    {
    }

    /// Position near a contour point that maximises `value` of the clearance.
    template <class Of>
    SurfacePlace largest(std::size_t point, Of value) const
    {
        SurfacePlace best{points_[point].piece, points_[point].t, surface_.clearances()[point]};
        for (const int side : {-1, 1}) {
            if ((side < 0 && point == 0) || (side > 0 && point + 1 == points_.size())) continue;
            const std::size_t other = side < 0 ? point - 1 : point + 1;
            if (points_[other].piece != points_[point].piece) continue;
            double low = std::min(points_[point].t, points_[other].t),
                   high = std::max(points_[point].t, points_[other].t);
            const double length = drawing_.pieces()[best.piece].length_mm();
            double a = high - goldenShare * (high - low), b = low + goldenShare * (high - low);
            Clearance at_a = seen(best.piece, a, point), at_b = seen(best.piece, b, point);
            while ((high - low) * length > refineTo_mm) {
                if (value(at_a) > value(at_b)) {
                    high = b;
                    b = a;
                    at_b = at_a;
                    a = high - goldenShare * (high - low);
                    at_a = seen(best.piece, a, point);
                } else {
                    low = a;
                    a = b;
                    at_a = at_b;
                    b = low + goldenShare * (high - low);
                    at_b = seen(best.piece, b, point);
                }
            }
            const bool is_a = value(at_a) > value(at_b);
            if (value(is_a ? at_a : at_b) > value(best.clearance)) {
                best.t = is_a ? a : b;
                best.clearance = is_a ? at_a : at_b;
            }
        }
        return best;
    }

    /// z where the clearance crosses a limit between two neighbouring points; of the second one where a piece ends.
    double crossing(std::size_t outside, std::size_t inside, double limit_mm) const
    {
        const DrawnPoint &out = points_[outside], &in = points_[inside];
        if (out.piece != in.piece) return in.at.z_mm;
        double low = out.t, high = in.t;
        for (int i = 0; i < 20; ++i) {
            const double middle = (low + high) / 2;
            (seen(in.piece, middle, inside).left_mm > limit_mm ? high : low) = middle;
        }
        return drawing_.at(in.piece, high).z_mm;
    }

private:
    Clearance seen(std::uint32_t piece, double t, std::size_t near) const
    {
        return surface_.at(drawing_.at(piece, t), near);
    }

    const DrawnContour& drawing_;
    const std::vector<DrawnPoint>& points_;
    const Surface& surface_;
};

void findGouges(const DrawnContour& drawing, const AllStrokes& all, const Finder& finder, double limit_mm,
                SurfaceDeviation& found)
{
    const std::vector<DrawnPoint>& points = drawing.points();
    const std::vector<Clearance>& clearances = found.clearances;
    const auto depth = [](const Clearance& clearance) { return -clearance.own_mm; };
    std::map<std::int64_t, BlockGouge> blocks;
    std::vector<std::pair<double, std::size_t>> peaks;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double here = depth(clearances[i]);
        if (clearances[i].own < 0 || here < -drawing.spacing_mm()) continue;
        const bool is_peak = (i == 0 || here >= depth(clearances[i - 1])) &&
                             (i + 1 == points.size() || here >= depth(clearances[i + 1]));
        if (is_peak) peaks.emplace_back(here, i);
        if (!(here > limit_mm)) continue;
        const std::int64_t line = all.strokes[static_cast<std::size_t>(clearances[i].own)].line;
        BlockGouge& block = blocks[line];
        if (here > block.depth_mm) block = {line, here, points[i].at};
    }
    const std::size_t refined = std::min(peaks.size(), mostRefined);
    std::partial_sort(
        peaks.begin(), peaks.begin() + static_cast<std::ptrdiff_t>(refined), peaks.end(),
        [](const auto& a, const auto& b) { return a.first > b.first || (a.first == b.first && a.second < b.second); });
    for (std::size_t k = 0; k < refined; ++k) {
        const SurfacePlace place = finder.largest(peaks[k].second, depth);
        if (!(depth(place.clearance) > std::max(found.gouge_mm, rounding_mm))) continue;
        found.gouge_mm = depth(place.clearance);
        found.gouge_at = drawing.at(place.piece, place.t);
        found.gouge_line = all.strokes[static_cast<std::size_t>(place.clearance.own)].line;
    }
    if (found.gouge_mm > limit_mm) {
        BlockGouge& block = blocks[found.gouge_line];
        if (found.gouge_mm > block.depth_mm) block = {found.gouge_line, found.gouge_mm, found.gouge_at};
    }
    for (const auto& [line, block] : blocks) found.blocks.push_back(block);
}

void findLeft(const DrawnContour& drawing, const Finder& finder, const std::optional<Interval>& looked_at,
              double limit_mm, SurfaceDeviation& found)
{
    const std::vector<DrawnPoint>& points = drawing.points();
    const std::vector<Clearance>& clearances = found.clearances;
    const auto left = [](const Clearance& clearance) { return clearance.left_mm; };
    const auto counts = [&](std::size_t i) {
        return !looked_at || (points[i].at.z_mm >= looked_at->from && points[i].at.z_mm <= looked_at->to);
    };
    std::size_t largest = points.size();
    for (std::size_t i = 0; i < points.size();) {
        if (counts(i) && (largest == points.size() || left(clearances[i]) > left(clearances[largest]))) largest = i;
        if (!counts(i) || !(left(clearances[i]) > limit_mm)) {
            ++i;
            continue;
        }
        LeftStretch stretch;
        stretch.first = i;
        std::size_t top = i;
        for (; i < points.size() && counts(i) && left(clearances[i]) > limit_mm; ++i)
            if (left(clearances[i]) > left(clearances[top])) top = i;
        stretch.last = i - 1;
        if (left(clearances[top]) > left(clearances[largest])) largest = top;
        const bool opens = stretch.first > 0 && counts(stretch.first - 1);
        const bool closes = i < points.size() && counts(i);
        const double begin =
            opens ? finder.crossing(stretch.first - 1, stretch.first, limit_mm) : points[stretch.first].at.z_mm;
        const double end = closes ? finder.crossing(i, stretch.last, limit_mm) : points[stretch.last].at.z_mm;
        stretch.z_start_mm = std::min(begin, end);
        stretch.z_end_mm = std::max(begin, end);
        const SurfacePlace place = finder.largest(top, left);
        stretch.left_mm = left(place.clearance);
        stretch.piece = place.piece;
        stretch.t = place.t;
        stretch.nearest = place.clearance.nearest;
        found.left.push_back(stretch);
    }
    if (largest == points.size()) return;
    const SurfacePlace place = finder.largest(largest, left);
    found.left_max_mm = std::max(0.0, left(place.clearance));
    found.left_max_z_mm = drawing.at(place.piece, place.t).z_mm;
}

}  // namespace

SurfaceDeviation surfaceDeviation(const DrawnContour& drawing, const AllStrokes& all, const BarLimits& bar,
                                  const std::optional<Interval>& looked_at, double gouge_limit_mm, double left_limit_mm,
                                  const Progress& progress)
{
    SurfaceDeviation found;
    Surface surface(drawing, all, bar, progress);
    surface.measure();
    found.clearances = surface.clearances();
    const Finder finder(drawing, surface);
    findGouges(drawing, all, finder, gouge_limit_mm, found);
    findLeft(drawing, finder, looked_at, left_limit_mm, found);
    return found;
}

}  // namespace lathelier::cam
