#include "engine/cam/drawn/rest_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

constexpr double sampleStep_mm = 0.02;  ///< columns of stock are no finer
constexpr std::size_t mostSamples = 400;

/// Radius of the drawing in the stock of a clamping; NaN outside.
double drawnRadius_mm(const ClampingOutcome& clamping, double z_mm)
{
    const std::vector<double>&z = clamping.drawing_z_mm, &x = clamping.drawing_x_mm;
    for (std::size_t i = 1; i < z.size(); ++i) {
        if (z_mm < z[i - 1] || z_mm > z[i] || z[i] <= z[i - 1]) continue;
        return std::lerp(x[i - 1], x[i], (z_mm - z[i - 1]) / (z[i] - z[i - 1]));
    }
    return notANumber;
}

double distance(const stock::Corner& place, const stock::Corner& a, const stock::Corner& b)
{
    const double dz = b.z_mm - a.z_mm, dx = b.x_mm - a.x_mm, length2 = dz * dz + dx * dx;
    const double share =
        length2 > 0 ? std::clamp(((place.z_mm - a.z_mm) * dz + (place.x_mm - a.x_mm) * dx) / length2, 0.0, 1.0) : 0;
    return std::hypot(place.z_mm - a.z_mm - share * dz, place.x_mm - a.x_mm - share * dx);
}

/// The last of the feed moves that come nearest.
std::int64_t nearestFeed(const ClampingOutcome& clamping, const stock::Corner& place)
{
    const stock::DrawnPath& drawn = clamping.drawn;
    double least = std::numeric_limits<double>::infinity();
    std::int64_t line = 0;
    for (std::size_t i = 1; i < drawn.corners(); ++i) {
        if (!drawn.isPiece(i) || drawn.isRapid(i)) continue;
        const double away = distance(place, drawn.corner(i - 1), drawn.corner(i));
        if (away > least) continue;
        least = away;
        line = drawn.lineOf(i);
    }
    return line;
}

}  // namespace

RestPlace placeOf(const TurningOutcome& outcome, std::size_t rest)
{
    const cam::RestInterval& stretch = outcome.plan->rest.at(rest);
    RestPlace place;
    place.clamping = outcome.clampings.size() - 1;
    const double middle_mm = (stretch.z_start_mm + stretch.z_end_mm) / 2;
    if (place.clamping > 0 && middle_mm <= outcome.plan->setups.front().clamping.finished_to_mm) place.clamping = 0;
    if (stretch.line > 0 && place.clamping + 1 == outcome.clampings.size()) {
        place.line = stretch.line;
        return place;
    }
    const Interval at = inStock(outcome, place.clamping, {middle_mm, middle_mm});
    const ClampingOutcome& clamping = outcome.clampings[place.clamping];
    const double radius_mm = drawnRadius_mm(clamping, at.from);
    if (!std::isnan(radius_mm)) place.line = nearestFeed(clamping, {at.from, radius_mm});
    return place;
}

report::Region areaOf(const TurningOutcome& outcome, std::size_t rest, std::size_t clamping)
{
    report::Region area;
    area.colour = report::ColourRole::Excess;
    const std::size_t last = outcome.clampings.size() - 1;
    const auto& check = outcome.plan->setups[last].check;
    if (!check.stock) return area;
    const cam::RestInterval& stretch = outcome.plan->rest.at(rest);
    const double from = stretch.z_start_mm - sampleStep_mm, to = stretch.z_end_mm + sampleStep_mm;
    const auto count =
        std::clamp(static_cast<std::size_t>(std::ceil((to - from) / sampleStep_mm)), std::size_t{2}, mostSamples);
    std::vector<double> top;
    for (std::size_t i = 0; i <= count; ++i) {
        const double z_mm = std::lerp(from, to, static_cast<double>(i) / static_cast<double>(count));
        const double at_mm = inStock(outcome, clamping, {z_mm, z_mm}).from;
        const double drawn_mm = drawnRadius_mm(outcome.clampings[clamping], at_mm);
        const auto left_mm = check.stock->left.outerRadius_mm(inStock(outcome, last, {z_mm, z_mm}).from);
        if (std::isnan(drawn_mm) || !left_mm) continue;
        area.x.push_back(at_mm);
        area.y.push_back(drawn_mm);
        top.push_back(std::max(drawn_mm, *left_mm));
    }
    for (std::size_t i = top.size(); i-- > 0;) {
        area.x.push_back(area.x[i]);
        area.y.push_back(top[i]);
    }
    return area;
}

}  // namespace lathelier::cam
