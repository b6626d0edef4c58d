#include "engine/cam/check/rest_cause.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

constexpr double touch_mm = 0.001;
constexpr std::size_t mostStretchPoints = 24;   ///< sampled points of one stretch
constexpr std::size_t mostTestedPoints = 4000;  ///< contour points tested against the tool at one position

struct NamedCause {
    const char* key;
    Text name;
};

const std::array<NamedCause, 8>& causeNames()
{
    static const std::array<NamedCause, 8> all{{{"nose_radius", LT_TEXT("Engine", "nose radius")},
                                                {"back_angle", LT_TEXT("Engine", "back angle")},
                                                {"leading_angle", LT_TEXT("Engine", "entering angle")},
                                                {"blade", LT_TEXT("Engine", "blade")},
                                                {"holder", LT_TEXT("Engine", "holder")},
                                                {"chuck", LT_TEXT("Engine", "chuck")},
                                                {"not_cut", LT_TEXT("Engine", "not cut")},
                                                {"tailstock", LT_TEXT("Engine", "tailstock")}}};
    return all;
}

double dot(const Corner& a, const Corner& b)
{
    return a.z_mm * b.z_mm + a.x_mm * b.x_mm;
}

/// The feature that prevents an insert from touching the drawing at a point: its edges, or its nose.
RestCause hindranceAt(const Corner& place, const Corner& normal, const DrawnContour& drawing, const JobTool& tool,
                      double feed)
{
    const double r = tool.radius_mm();
    const Corner centre = place + r * normal;
    const double kappa = tool.entering_angle_deg.value_or(assumed::enteringAngle_deg) * rad_per_deg;
    const double back = std::max(0.0, tool.backAngle_deg() - tool.back_margin_deg) * rad_per_deg;
    const bool leads = kappa < 90 * rad_per_deg;
    const Corner of_main{feed * std::sin(kappa), -std::cos(kappa)}, of_back{-feed * std::sin(back), -std::cos(back)};
    const std::vector<DrawnPoint>& points = drawing.points();
    const std::size_t every = points.size() / mostTestedPoints + 1;
    RestCause found = RestCause::Uncut;
    for (std::size_t i = 0; i < points.size(); i += every) {
        const Corner off = points[i].at - centre;
        // If the nose itself gouges, its edges gouge as well: the nose is reported.
        if (dot(off, off) < (r - touch_mm) * (r - touch_mm)) return RestCause::NoseRadius;
        if (dot(off, of_main) > r - touch_mm || dot(off, of_back) > r - touch_mm) continue;
        const double along = feed * off.z_mm;
        const bool is_behind = along < 0 && dot(off, {-feed * std::cos(back), std::sin(back)}) > 0;
        // Walls are at most vertical: an edge with an entering angle above 90° gouges none before the nose does.
        const bool is_ahead = leads && along > 0 && dot(off, {feed * std::cos(kappa), std::sin(kappa)}) > 0;
        if (is_behind) found = RestCause::BackAngle;
        if (is_ahead && found == RestCause::Uncut) found = RestCause::LeadingAngle;
    }
    return found;
}

}  // namespace

const char* key(RestCause cause)
{
    return causeNames().at(static_cast<std::size_t>(cause)).key;
}

Text nameOf(RestCause cause)
{
    return causeNames().at(static_cast<std::size_t>(cause)).name;
}

RestCause causeOf(const LeftStretch& stretch, const DrawnContour& drawing, const AllStrokes& all, const Job& job)
{
    if (stretch.nearest < 0) return RestCause::Uncut;
    const JobTool* tool = job.tool(all.strokes[static_cast<std::size_t>(stretch.nearest)].tool);
    if (!tool) return RestCause::Uncut;
    if (tool->isBlade()) return RestCause::Blade;
    const bool was_before = static_cast<std::size_t>(stretch.nearest) >= all.own;
    const double feed = (tool->hand == Hand::FromChuck ? -1 : 1) * (was_before ? -1 : 1);
    RestCause cause = RestCause::Uncut;
    const std::size_t count = stretch.last - stretch.first + 1;
    const std::size_t tries = std::min(count, mostStretchPoints);
    for (std::size_t k = 0; k < tries; ++k) {
        const DrawnPoint& point = drawing.points()[stretch.first + (tries > 1 ? k * (count - 1) / (tries - 1) : 0)];
        const RestCause here = hindranceAt(point.at, drawing.normalAt(point.piece, point.t), drawing, *tool, feed);
        if (here == RestCause::BackAngle || here == RestCause::LeadingAngle) return here;
        if (here == RestCause::NoseRadius) cause = here;
    }
    return cause;
}

}  // namespace lathelier::cam
