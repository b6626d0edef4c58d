#include "engine/gcode/level_contour.h"

#include <algorithm>
#include <cmath>

namespace lathelier::gcode {
namespace {

/// Splits an arc where p is largest or smallest: above or below its centre, seen with q to the right.
void addMonotonic(const Stretch& arc, bool clockwise, std::vector<Stretch>& stretches)
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
    std::sort(cuts.begin() + 1, cuts.end() - 1, [clockwise](double a, double b) { return clockwise ? a > b : a < b; });
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        Stretch part = arc;
        const auto at = [&arc](double angle) {
            return Place{arc.centre.p + arc.radius * std::sin(angle), arc.centre.q + arc.radius * std::cos(angle)};
        };
        if (i > 1) part.from = at(cuts[i - 1]);
        if (i + 1 < cuts.size()) part.to = at(cuts[i]);
        part.is_upper = std::cos((cuts[i - 1] + cuts[i]) / 2) > 0;
        stretches.push_back(part);
    }
}

}  // namespace

std::vector<Stretch> stretchesOf(const std::vector<ContourPiece>& contour, const LevelAxes& axes, const Point& shift)
{
    const auto placeOf = [&](const Point& at) { return axes.place({at.x_mm + shift.x_mm, at.z_mm + shift.z_mm}); };
    std::vector<Stretch> stretches;
    stretches.reserve(contour.size() * 2);
    for (std::size_t i = 1; i < contour.size(); ++i) {
        const Piece& piece = contour[i].piece;
        Stretch part;
        part.from = placeOf(piece.from);
        part.to = placeOf(piece.to);
        part.line = contour[i].line;
        if (!piece.isArc()) {
            stretches.push_back(part);
            continue;
        }
        part.centre = placeOf(piece.centre);
        part.radius = piece.radius_mm();
        part.clockwise = piece.clockwise;
        addMonotonic(part, piece.clockwise != axes.isMirrored(), stretches);
    }
    return stretches;
}

double crossing(const Stretch& part, double level)
{
    if (part.radius > 0) {
        const double height = level - part.centre.p;
        const double root = std::sqrt(std::max(part.radius * part.radius - height * height, 0.0));
        return part.is_upper ? part.centre.q + root : part.centre.q - root;
    }
    const double rise = part.to.p - part.from.p;
    return rise == 0 ? part.to.q : part.from.q + (part.to.q - part.from.q) * (level - part.from.p) / rise;
}

}  // namespace lathelier::gcode
