#include "engine/surface/grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lathelier::surface {

GridView GridView::middle(int side) const
{
    const int width = std::min(side, columns), height = std::min(side, rows);
    return {row((rows - height) / 2) + (columns - width) / 2, width, height, stride};
}

Grid GridView::copy() const
{
    Grid grid(columns, rows);
    for (int y = 0; y < rows; ++y) std::copy_n(row(y), columns, grid.row(y));
    return grid;
}

double length(Vector v)
{
    return std::hypot(v.x, v.y);
}

double angle_deg(Vector v)
{
    return std::atan2(v.y, v.x) * 180 / std::numbers::pi;
}

Vector turned(Vector v, double by_deg)
{
    const double angle = by_deg * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

double angleModulo180(double degrees)
{
    const double rest = std::fmod(degrees, 180.0);
    return rest > 90 ? rest - 180 : rest <= -90 ? rest + 180 : rest;
}

}  // namespace lathelier::surface
