#include "engine/surface/grid.h"

#include <cmath>
#include <numbers>

namespace lathelier::surface {

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
